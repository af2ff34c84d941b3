// SPDX-License-Identifier: Apache-2.0
// pipelines.cpp: see pipelines.hpp.
#include "sim/command/frame/pipelines.hpp"

#include <fmt/format.h>

#include "sim/progress.hpp"
#include "sim/study/rivals/pipelines.hpp"

namespace pipegs {
namespace {

constexpr std::string_view kPaperMachine = "dop";
constexpr int kGroup = 64;       // of GSAcc's neighbours nothing depends on it; voxels are counted fastest so
constexpr uint64_t kBars = 300;  // of a unit of ours
constexpr double kMachineGhz = 1;

// One of our machines through the RTL; `exit_code` becomes kExitDiffers when a bit differs.
MachinePipeline own_pipeline(const LoadedView& loaded, const SimulateOptions& wanted, const std::string& name,
                             int& exit_code) {
  SimulateOptions options = wanted;
  Simulation simulation;
  simulate_golden(loaded.scene, loaded.camera, options, simulation);
  BusyPieces pieces(options.config);
  options.taps = &pieces;
  simulate_rtl(options, simulation);
  if (simulation.mismatches != 0) {
    fmt::print(stderr, "{}: first mismatch: {}\n", name, simulation.first_mismatch->what);
    exit_code = kExitDiffers;
  }
  const double us = static_cast<double>(simulation.rtl.cycles) / kMachineGhz / 1e3;
  return {name, "RTL, every bit compared with the golden model", us, pieces.rows(kBars, kMachineGhz)};
}

void print(const std::vector<MachinePipeline>& machines) {
  fmt::print("{:<10}{:>10}  share of the frame in which units work\n", "machine", "us");
  for (const MachinePipeline& machine : machines) {
    fmt::print("{:<10}{:>10.0f}", machine.machine, machine.end);
    for (const PipelineRow& row : machine.rows) {
      double busy = 0;
      for (const PipelineBar& bar : row.bars) busy += bar.share * (bar.end - bar.begin);
      fmt::print("  {} {:.0f} %", row.unit, 100 * busy / machine.end);
    }
    fmt::print("\n");
  }
}

}  // namespace

int draw_pipelines(const ViewArguments& view, const MemoryArguments& memory, const std::string& svg) {
  ViewArguments paper = view;
  paper.design_point = kPaperMachine, paper.config.clear(), paper.settings.clear();
  std::vector<SimulateOptions> machines = {paper.options(), view.options()};
  if (machines[0].config == machines[1].config) machines.pop_back();
  if (machines.front().window) throw ConfigError("--window: frames are drawn whole, expected none with --pipelines");
  try_file("--pipelines", svg);
  const LoadedView loaded = load_view(view);
  for (SimulateOptions& one : machines) {
    memory.apply(one);
    need_taps(one);
    follow_scene(loaded.scene, one);
    check_picture_memory(loaded.camera, one, kGoldenPixels + kRtlPixels);
  }
  std::vector<MachinePipeline> pipelines;
  {
    Progress progress("counting");
    const FrameCounts counts = count_frame(
        loaded.scene, loaded.camera,
        {.near_plane = view.near_plane, .group = kGroup, .progress = [&](double share) { progress.update(share); }});
    PlayedMemory played(memory.external.dram);
    pipelines = rival_pipelines(counts, played);
  }
  int exit_code = kExitOk;
  for (const SimulateOptions& one : machines) {
    const std::string point = design_point_name(one.config);
    const bool whole = !point.empty() && find_design_point(point).config == one.config;
    pipelines.push_back(own_pipeline(loaded, one, whole ? point : config_difference(one.config), exit_code));
  }
  write_text(svg, pipelines_svg(fmt::format("{}, view {} ({}x{})", loaded.scene.name, loaded.camera.name,
                                            loaded.camera.width, loaded.camera.height),
                                pipelines));
  print(pipelines);
  return exit_code;
}

}  // namespace pipegs
