// SPDX-License-Identifier: Apache-2.0
// ladder.cpp: `pipegs ladder`: one view on every design point, each compared bit for bit: the paper's Fig. 8 and 9.
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "sim/command/command.hpp"
#include "sim/command/page/study_output.hpp"
#include "sim/command/replay.hpp"
#include "sim/ladder/ladder.hpp"
#include "sim/progress.hpp"
#include "sim/report/report.hpp"
#include "sim/rtl/rtl_fault.hpp"

namespace pipegs {
namespace {

struct LadderArguments {
  ViewArguments view;
  MemoryArguments memory;
  StudyOutput output;
  bool no_truth = false;
};

// What the design points above have shown, for comparing pictures and for truths that need not be rendered again.
struct Known {
  std::vector<std::pair<const DesignPoint*, std::vector<uint64_t>>> pixels;
  std::unique_ptr<Simulation> first;
  std::vector<std::pair<std::string_view, Mismatch>> wrong;
};

void compare_pixels(LadderRow& row, const std::vector<uint64_t>& pixels, Known& known) {
  for (const auto& [design_point, other] : known.pixels) {
    if (row.same_pixels.empty() && other == pixels) row.same_pixels = design_point->name;
    if (design_point->picture != row.design_point->picture || row.different_pixels > 0) continue;
    for (size_t i = 0; i < pixels.size(); ++i) row.different_pixels += pixels[i] != other[i];
  }
  known.pixels.emplace_back(row.design_point, pixels);
}

void run_design_point(LadderRow& row, const LadderArguments& arguments, const LoadedView& loaded, Known& known) {
  auto simulation = std::make_unique<Simulation>();
  simulate_golden(loaded.scene, loaded.camera, row.options, *simulation);
  row.with_truth = !arguments.no_truth;
  FigureWatch watch(row.options.config);
  row.options.taps = &watch;
  simulate_rtl(row.options, *simulation);
  row.options.taps = nullptr;
  if (row.with_truth) simulate_truth(loaded.scene, loaded.camera, row.options, *simulation, known.first.get());
  ladder_figures(row, *simulation, watch);
  compare_pixels(row, simulation->golden.pixels, known);
  const std::string folder = arguments.output.out() + "/" + std::string(row.design_point->name);
  write_images(folder, picture_of(*simulation, row.options));
  write_text(folder + "/report.json",
             report_json(loaded.scene, loaded.camera, row.options, *simulation, loaded.told->all()).dump(2) + "\n");
  if (const std::optional<Mismatch>& first = simulation->first_mismatch)
    known.wrong.push_back({row.design_point->name, *first});
  if (!known.first) known.first = std::move(simulation);
}

void check_outputs(const LadderArguments& arguments, const std::vector<const DesignPoint*>& chosen) {
  arguments.output.check();
  for (const DesignPoint* design_point : chosen)
    try_folder("--out", arguments.output.out() + "/" + std::string(design_point->name),
               {"frame.exr", "frame.png", "report.json"});
}

// Of the design point that runs, and of the first one, whose truths are kept.
PixelBytes memory_of(const LadderArguments& arguments) {
  const PixelBytes one = arguments.no_truth ? kGoldenPixels : kGoldenPixels + kTruthPixels;
  return one + one + kWritePixels + kRtlPixels;
}

// What differs, with the commands that look closer; it stands last.
void tell_mismatches(const Known& known, const CLI::App& command) {
  std::fflush(stdout);
  for (const auto& [name, first] : known.wrong) {
    std::set<std::string> without = {"--designs", "--out", "--json", "--page", "--window", "--no-truth"};
    if (!find_design_point(name).config.has_walks()) without.insert("--walk-most");
    fmt::print(stderr, "{}: first mismatch, {}\nreplay: {} --design {} --no-truth --out replay --window {},{}\n", name,
               first.line(), given_to("sim", command, without), name, first.window_x, first.window_y);
  }
}

int ladder(const LadderArguments& arguments, const CLI::App& command) {
  const std::vector<const DesignPoint*> chosen = find_design_points(arguments.view.design_points);
  const std::vector<SimulateOptions> options = arguments.view.options(chosen);
  std::vector<LadderRow> rows;
  for (size_t i = 0; i < chosen.size(); ++i) {
    rows.push_back({.design_point = chosen[i], .options = options[i]});
    arguments.memory.apply(rows.back().options);
  }
  check_outputs(arguments, chosen);
  for (const LadderRow& row : rows) need_taps(row.options);
  const LoadedView loaded = load_view(arguments.view);
  for (LadderRow& row : rows) follow_scene(loaded, row.options);
  check_picture_memory(loaded.camera, rows.front().options, memory_of(arguments));

  Known known;
  size_t done = 0;
  bool differs = false;
  for (LadderRow& row : rows) {
    if (!arguments.output.json()) fmt::print(stderr, "{}: {}\n", row.design_point->name, row.design_point->what);
    try {
      run_design_point(row, arguments, loaded, known);
      ++done;
      differs = differs || row.mismatches > 0 || row.different_pixels > 0;
    } catch (const RtlBuildError& error) { row.failure = error.what(); } catch (const RtlFault& error) {
      row.failure = error.what();
      differs = true;
    }
  }

  const Camera& camera = loaded.camera;
  nlohmann::ordered_json json = {
      {"scene", {{"name", loaded.scene.name}, {"gaussians", loaded.scene.gaussians.size()}}},
      {"camera", {{"name", camera.name}, {"width", camera.width}, {"height", camera.height}}},
      {"memory",
       {{"kind", arguments.memory.external.dram},
        {"bytes_per_cycle", memory_peak(arguments.memory.external)},
        {"seed", arguments.memory.seed}}},
      {"designs", ladder_json(rows)}};
  const std::string head = fmt::format("{}: {} Gaussians; view {} ({}x{}); memory {}, {:g} B/cycle", loaded.scene.name,
                                       loaded.scene.gaussians.size(), camera.name, camera.width, camera.height,
                                       arguments.memory.external.dram, memory_peak(arguments.memory.external));
  NamedMachines machines;
  for (const LadderRow& row : rows) machines.emplace_back(row.design_point->name, row.options.config);
  arguments.output.write({.title = "One view on every design point",
                          .head = head,
                          .charts = ladder_charts(rows),
                          .tables = ladder_tables(rows),
                          .machines = machines,
                          .odd = loaded.told->all()},
                         json, done > 0);
  tell_mismatches(known, command);
  if (differs) return kExitDiffers;
  return done == rows.size() ? kExitOk : kExitOwnFailure;
}

}  // namespace

void add_ladder(CLI::App& app, Run& run) {
  CLI::App& command =
      add_command(app, "ladder", "one view on every design point, in RTL",
                  footer("pipegs ladder garden.ply --cameras cameras.json --view 0 --out ladder --page",
                         "every bit of every design point agrees", "a bit differs or the RTL stops",
                         "A design point whose RTL does not build is named, the others run; then the exit code is 3."));
  static LadderArguments arguments;
  arguments.view.add(command, DesignPoints::kSeveral);
  arguments.memory.add(command);
  arguments.output.add(command, "ladder");
  add_flag(command, "--no-truth", arguments.no_truth, "leave out the float64 renders and the PSNR");
  when_chosen(command, run, [&command] { return ladder(arguments, command); });
}

}  // namespace pipegs
