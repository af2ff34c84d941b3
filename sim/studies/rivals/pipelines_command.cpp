// SPDX-License-Identifier: Apache-2.0
// pipelines_command.cpp: see pipelines_command.hpp.
#include "sim/studies/rivals/pipelines_command.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "sim/progress.hpp"
#include "sim/studies/rivals/pipelines.hpp"

namespace pipegs {
namespace {

constexpr int kGroup = 64;       // of voxels, which none of these machines has: counted fastest so
constexpr uint64_t kBars = 300;  // of a unit of ours
constexpr double kMachineGhz = 1;

// One of our machines through the RTL; `exit_code` becomes kExitDiffers when a bit differs.
MachinePipeline own_pipeline(const LoadedView& loaded, SimulateOptions options, int& exit_code) {
  const std::string name = machine_name(options.config);
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

// Of the frame, in which the row's units work.
double busy_share(const PipelineRow& row, double end) {
  double busy = 0;
  for (const PipelineBar& bar : row.bars) busy += bar.share * (bar.end - bar.begin);
  return busy / end;
}

std::string text_of(const std::vector<MachinePipeline>& machines) {
  std::string text = fmt::format("{:<10}{:>10}  share of the frame in which units work\n", "machine", "us");
  for (const MachinePipeline& machine : machines) {
    text += fmt::format("{:<10}{:>10.0f}", machine.machine, machine.end);
    for (const PipelineRow& row : machine.rows)
      text += fmt::format("  {} {:.0f} %", row.unit, 100 * busy_share(row, machine.end));
    text += "\n";
  }
  return text;
}

std::string json_of(const std::vector<MachinePipeline>& machines) {
  nlohmann::ordered_json json;
  for (const MachinePipeline& machine : machines) {
    json[machine.machine]["us"] = machine.end;
    for (const PipelineRow& row : machine.rows) json[machine.machine]["busy"][row.unit] = busy_share(row, machine.end);
  }
  return json.dump(2) + "\n";
}

}  // namespace

int draw_pipelines(const ViewArguments& view, const MemoryArguments& memory, const std::string& svg, bool json) {
  std::vector<SimulateOptions> machines = view.paper_and_own();
  if (machines.front().window) throw ConfigError("--window: frames are drawn whole, expected none with --pipelines");
  try_file("--svg", svg);
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
  for (const SimulateOptions& one : machines) pipelines.push_back(own_pipeline(loaded, one, exit_code));
  if (!svg.empty()) {
    write_text(svg, pipelines_svg(fmt::format("{}, view {} ({}x{})", loaded.scene.name, loaded.camera.name,
                                              loaded.camera.width, loaded.camera.height),
                                  pipelines));
  }
  fmt::print("{}", json ? json_of(pipelines) : text_of(pipelines));
  return exit_code;
}

}  // namespace pipegs
