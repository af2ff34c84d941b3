// SPDX-License-Identifier: Apache-2.0
// sim.cpp: `pipegs sim`: golden model, truth and RTL of one view, compared bit for bit.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "sim/command/command.hpp"
#include "sim/command/page/frame_page_argument.hpp"
#include "sim/command/frame/picture_arguments.hpp"
#include "sim/command/page/viewer_argument.hpp"
#include "sim/command/replay.hpp"
#include "sim/command/sequence/sequence.hpp"
#include "sim/report/report.hpp"
#include "sim/effects/effects.hpp"
#include "sim/rtl/rtl_fault.hpp"

namespace pipegs {
namespace {

struct SimArguments {
  ViewArguments view;
  MemoryArguments memory;
  PictureArguments picture_of;
  SequenceArguments sequence;
  FramePageArgument page;
  ViewerArgument viewer;
  std::string out = "out";
  std::vector<std::string> effects = {"all"};
  std::string picture = "windows";
  bool waves = false, netlist = false, json = false, no_truth = false, no_rtl = false;
};

const std::vector<std::string> kAll = {"all"}, kAuto = {"auto"};

bool are_named(const std::vector<std::string>& effects) { return effects != kAll && effects != kAuto; }

// The command that runs the same again with waves: of one window, or of what was asked for.
std::string replay(const SimArguments& arguments, const CLI::App& command, const std::string& window) {
  std::set<std::string> other = {"--out", "--json", "--no-truth", "--waves", "--page", "--against", "--viewer"};
  std::string more = " --no-truth --out replay";
  if (!window.empty()) {
    other.insert({"--window", "--crop"});
    more += " --window " + window;
  }
  if (!arguments.netlist) more += " --waves";  // gates write none
  if (!arguments.netlist && are_named(arguments.effects)) {
    std::vector<std::string> effects = arguments.effects;
    for (const char* needed : {"waves", "taps"}) {
      if (std::find(effects.begin(), effects.end(), needed) == effects.end()) effects.emplace_back(needed);
    }
    other.insert("--effects");
    more += fmt::format(" --effects {}", shell_word(fmt::format("{}", fmt::join(effects, ","))));
  }
  return given_again(command, other) + more;
}

// What --effects asks for without a look at the view.
EffectPlan named_effects(const SimArguments& arguments, const SimulateOptions& options) {
  if (!are_named(arguments.effects)) return {options, {"all"}, {}};
  return plan_effects(options, arguments.effects);
}

// The RTL on the view; when it stops, how to run it again.
std::string run_rtl(const SimArguments& arguments, const CLI::App& command, const LoadedView& loaded,
                    const SimulateOptions& options, const EffectPlan& plan, Simulation& simulation) {
  try {
    return simulate_effects(loaded.scene, loaded.camera, options, plan, simulation);
  } catch (const RtlFault&) {
    fmt::print(stderr, "replay with waves: {}\n", replay(arguments, command, ""));
    throw;
  }
}

void check_outputs(const SimArguments& arguments, const CLI::App& command) {
  arguments.sequence.check(command, arguments.out);
  if (arguments.page.wanted() && arguments.sequence.wanted())
    throw ConfigError("--page: found a sequence, expected one frame");
  arguments.page.check();
  try_folder("--out", arguments.out,
             {"frame.exr", "frame.png", "report.json", "page.html", "viewer.html", "waves.fst"});
}

int simulate(const SimArguments& arguments, const CLI::App& command) {
  SimulateOptions options = arguments.view.options();
  arguments.memory.apply(options);
  if (arguments.waves) options.rtl.waves = arguments.out + "/waves.fst";
  options.raster = arguments.picture == "raster";
  arguments.picture_of.apply(arguments.view, true, options);
  options.variant.netlist = arguments.netlist;
  if (arguments.no_rtl && arguments.waves) throw ConfigError("--waves: there are none with --no-rtl");
  built_variant(options.variant, options.rtl);  // refuses waves of gates
  check_outputs(arguments, command);
  if (arguments.sequence.wanted()) {
    make_folder_of(options.rtl.waves);
    return run_sequence(arguments.view, arguments.sequence, arguments.picture_of, options,
                        {.out = arguments.out,
                         .rtl = !arguments.no_rtl,
                         .json = arguments.json,
                         .replay = replay(arguments, command, ""),
                         .viewer = arguments.viewer,
                         .command = command});
  }
  const bool page = arguments.page.wanted(), record = page && !arguments.no_rtl;
  if (record) need_taps(options);
  const LoadedView loaded = load_view(arguments.view);
  const std::optional<Rgb8> against = arguments.page.read(loaded, options);
  follow_scene(loaded, options);
  check_picture_memory(loaded.camera, options,
                       kGoldenPixels + kWritePixels + (arguments.no_truth ? PixelBytes{} : kTruthPixels) +
                           (arguments.no_rtl ? PixelBytes{} : kRtlPixels) + (page ? kPagePixels : PixelBytes{}));
  std::optional<FrameRecord> seen;
  if (record)
    options.taps = &seen.emplace(options.config, asked_pixels(loaded.camera.width, loaded.camera.height, options));
  EffectPlan plan = named_effects(arguments, options);
  ViewerArgument viewer = arguments.viewer;
  viewer.begin(loaded, {loaded.camera}, options, arguments.picture_of.color(), command);
  make_folder_of(options.rtl.waves);

  Simulation simulation;
  simulate_golden(loaded.scene, loaded.camera, options, simulation);
  if (!arguments.no_truth) simulate_truth(loaded.scene, loaded.camera, options, simulation);
  if (arguments.effects == kAuto)
    plan = plan_effects(options, find_effects(effect_facts(loaded.scene, options, simulation, false)));
  std::string wrong;
  if (!arguments.no_rtl) wrong = run_rtl(arguments, command, loaded, options, plan, simulation);

  auto report =
      report_json(loaded.scene, loaded.camera, wrong.empty() ? plan.options : options, simulation, loaded.told->all());
  report["effects"] = arguments.no_rtl
                          ? nlohmann::ordered_json(nullptr)
                          : nlohmann::ordered_json{{"simulated", plan.simulated}, {"left_out", plan.left_out}};
  const Rgb8 picture = arguments.picture_of.picture(simulation, options);
  write_images(arguments.out, picture_of(simulation, options), picture);
  write_text(arguments.out + "/report.json", report.dump(2) + "\n");
  // A run that was repeated with all effects has left two in the record.
  if (page)
    arguments.page.write(
        command, arguments.out,
        {.picture = picture, .report = report, .against = against, .record = wrong.empty() && seen ? &*seen : nullptr},
        simulation, options);
  viewer.add(picture);
  const std::string viewed = viewer.write(arguments.out);
  if (arguments.json) {
    fmt::print("{}\n", report.dump(2));
  } else {
    fmt::print("{}  picture {}/frame.png, {}/frame.exr; figures {}/report.json\n{}", report_text(report), arguments.out,
               arguments.out, arguments.out, viewed.empty() ? "" : "  " + viewed);
  }
  if (!wrong.empty()) fmt::print(stderr, "pipegs: {}\n", wrong);
  if (simulation.mismatches == 0) return wrong.empty() ? kExitOk : kExitDiffers;
  fmt::print(stderr, "first mismatch, window {},{}: {}\nreplay with waves: {}\n", simulation.first_mismatch->window_x,
             simulation.first_mismatch->window_y, simulation.first_mismatch->what,
             replay(arguments, command,
                    fmt::format("{},{}", simulation.first_mismatch->window_x, simulation.first_mismatch->window_y)));
  return kExitDiffers;
}

}  // namespace

void add_sim(CLI::App& app, Run& run) {
  CLI::App& command = add_command(
      app, "sim", "one view by truth, golden model, RTL: compared",
      footer("pipegs sim garden.ply --cameras cameras.json --view 0 --set units=2 --out garden",
             "every bit of the RTL agrees (or --no-rtl: nothing compared)", "a bit differs or the RTL stops"));
  static SimArguments arguments;
  arguments.view.add(command);
  arguments.memory.add(command);
  arguments.picture_of.add(command);
  arguments.sequence.add(command);
  arguments.page.add(command);
  arguments.viewer.add_option(command);
  add_text(command, "--picture", arguments.picture,
           "pixels in memory: windows, as --set pixel_w says; raster, rows of RGBA8, and frame.png is these")
      .shows_default()
      .one_of({"windows", "raster"}, true);
  add_text(command, "--out", arguments.out, "folder for frame.exr, frame.png, report.json, and what is asked for")
      .shows_default();
  add_flag(command, "--waves", arguments.waves, "waves.fst: waves of every signal (use with --window)");
  add_names(command, "--effects", arguments.effects,
            "what to simulate: all; auto, what the view calls for; or names by commas (pipegs effects lists them)")
      .shows_default();
  add_flag(command, "--netlist", arguments.netlist,
           "DOPU, PUs, SUs and RUs as gates (use with --window; builds for many minutes)");
  add_flag(command, "--no-truth", arguments.no_truth, "leave out the float64 renders and the PSNR");
  add_flag(command, "--no-rtl", arguments.no_rtl, "leave out the RTL: accuracy and work counts only, nothing compared");
  add_flag(command, "--json", arguments.json, "print report.json instead of the table");
  when_chosen(command, run, [&command] { return simulate(arguments, command); });
}

}  // namespace pipegs
