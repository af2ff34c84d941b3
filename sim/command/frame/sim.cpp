// SPDX-License-Identifier: Apache-2.0
// sim.cpp: `pipegs sim`: golden model, truth and RTL of one view, compared bit for bit.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "sim/command/command.hpp"
#include "sim/command/frame/gate_timing.hpp"
#include "sim/command/page/frame_page_argument.hpp"
#include "sim/command/frame/against_argument.hpp"
#include "sim/command/frame/picture_arguments.hpp"
#include "sim/command/page/viewer_argument.hpp"
#include "sim/command/replay.hpp"
#include "sim/command/sequence/quality.hpp"
#include "sim/command/sequence/sequence.hpp"
#include "sim/report/report.hpp"
#include "sim/effects/effects.hpp"
#include "sim/progress.hpp"
#include "sim/rtl/rtl_fault.hpp"

namespace pipegs {
namespace {

struct SimArguments {
  ViewArguments view;
  MemoryArguments memory;
  PictureArguments picture_of;
  SequenceArguments sequence;
  AgainstArgument against;
  FramePageArgument page;
  ViewerArgument viewer;
  std::string out = "out";
  std::vector<std::string> effects = {"all"}, gates = kGates;
  std::string picture = "windows";
  std::optional<WaveRange> wave_range;
  bool waves = false, netlist = false, json = false, no_truth = false, no_rtl = false;
};

const std::vector<std::string> kAll = {"all"}, kAuto = {"auto"};

bool are_named(const std::vector<std::string>& effects) { return effects != kAll && effects != kAuto; }

// "5312" or "5312,50".
WaveRange wave_range(const std::string& text) {
  const size_t comma = text.find(',');
  constexpr int64_t kMost = int64_t{1} << 40;
  WaveRange range{.cycle = parse_integer<int64_t>(text.substr(0, comma), 0, kMost), .around = 200};
  if (comma != std::string::npos) range.around = parse_integer<int64_t>(text.substr(comma + 1), 1, kMost);
  return range;
}

// A run that shows what went wrong: of one window or of all that was asked for, and when it shows it.
struct Shown {
  std::optional<std::array<int, 2>> window;
  std::optional<int64_t> cycle;
};

// The command of that run, with waves around the cycle.
std::string replay(const SimArguments& arguments, const CLI::App& command, const Shown& shown) {
  std::set<std::string> other = {"--out",          "--json", "--no-truth", "--waves",
                                 "--waves-around", "--page", "--against",  "--viewer"};
  std::string more = " --no-truth --out replay";
  if (shown.window) {
    other.insert({"--window", "--crop"});
    more += fmt::format(" --window {}", fmt::join(*shown.window, ","));
  }
  if (!arguments.netlist)  // gates write none
    more += shown.cycle ? fmt::format(" --waves-around {}", *shown.cycle) : " --waves";
  if (are_named(arguments.effects)) {
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

bool has_waves(const RtlOptions& options, int64_t cycle) {
  return !options.waves.empty() && (!options.wave_range || options.wave_range->holds(cycle));
}

// The shortest run that shows a mismatch of this one: of its window alone, unless it does not come there.
Shown shortest(const LoadedView& loaded, const SimulateOptions& options, const Mismatch& first) {
  const std::array<int, 2> window = {static_cast<int>(first.window_x), static_cast<int>(first.window_y)};
  if (!options.variant.gates.empty() || options.window == window) return {window, first.cycle};
  SimulateOptions alone = options;
  alone.window = window;
  alone.crop.reset();
  alone.taps = nullptr;
  alone.found = nullptr;
  alone.rtl.waves.clear();
  Simulation simulation;
  const Progress stage("the window of the mismatch alone");
  simulate_golden(loaded.scene, loaded.camera, alone, simulation);
  try {
    simulate_rtl(alone, simulation);
  } catch (const RtlFault& fault) { return {window, fault.cycle}; }
  if (!simulation.first_mismatch) return {{}, first.cycle};
  return {window, simulation.first_mismatch->cycle};
}

// The RTL on the view; when it stops, how to run it again.
std::string run_rtl(const SimArguments& arguments, const CLI::App& command, const LoadedView& loaded,
                    const SimulateOptions& options, const EffectPlan& plan, Simulation& simulation) {
  try {
    return simulate_effects(loaded.scene, loaded.camera, options, plan, simulation);
  } catch (const RtlFault& fault) {
    fmt::print(stderr, "replay with waves: {}\n", replay(arguments, command, {{}, fault.cycle}));
    throw;
  }
}

// In the order of kGates, so that a machine has one name.
std::vector<std::string> asked_gates(const SimArguments& arguments) {
  std::vector<std::string> gates;
  for (const std::string& unit : kGates)
    if (std::find(arguments.gates.begin(), arguments.gates.end(), unit) != arguments.gates.end()) gates.push_back(unit);
  if (gates.size() != arguments.gates.size())
    throw ConfigError(fmt::format("--gates: found {}, expected some of {}", fmt::join(arguments.gates, ","),
                                  fmt::join(kGates, ", ")));
  return gates;
}

void check_outputs(const SimArguments& arguments, const CLI::App& command) {
  arguments.sequence.check(command, arguments.out);
  arguments.page.check();
  try_folder("--out", arguments.out,
             {"frame.exr", "frame.png", "report.json", "page.html", "viewer.html", "waves.fst", "waves.gtkw"});
}

int simulate(const SimArguments& arguments, const CLI::App& command) {
  SimulateOptions options = arguments.view.options();
  arguments.memory.apply(options);
  if (arguments.waves || arguments.wave_range) options.rtl.waves = arguments.out + "/waves.fst";
  options.rtl.wave_range = arguments.wave_range;
  options.raster = arguments.picture == "raster";
  arguments.picture_of.apply(arguments.view, true, options);
  if (arguments.netlist) options.variant.gates = asked_gates(arguments);
  if (arguments.no_rtl && !options.rtl.waves.empty()) throw ConfigError("--waves: there are none with --no-rtl");
  built_variant(options.variant, options.rtl);  // refuses waves of gates
  check_outputs(arguments, command);
  if (arguments.sequence.wanted()) {
    make_folder_of(options.rtl.waves);
    return run_sequence(arguments.view, arguments.sequence, arguments.picture_of, options,
                        {.out = arguments.out,
                         .rtl = !arguments.no_rtl,
                         .json = arguments.json,
                         .replay =
                             [&](std::optional<int64_t> cycle) {
                               return replay(arguments, command, {{}, cycle});
                             },
                         .viewer = arguments.viewer,
                         .against = arguments.against,
                         .page = arguments.page.wanted(),
                         .command = command});
  }
  const bool page = arguments.page.wanted(), record = page && !arguments.no_rtl;
  if (record || arguments.netlist) need_taps(options);
  const LoadedView loaded = load_view(arguments.view);
  arguments.page.check(loaded.camera, options);
  AgainstArgument against = arguments.against;
  against.begin(loaded, {loaded.camera}, options, false);
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
  std::optional<GateTiming> gates;
  if (arguments.netlist) gates.emplace(simulation, options);
  std::string wrong;
  if (!arguments.no_rtl) wrong = run_rtl(arguments, command, loaded, options, plan, simulation);
  if (gates) gates->compare(simulation);

  auto report =
      report_json(loaded.scene, loaded.camera, wrong.empty() ? plan.options : options, simulation, loaded.told->all());
  report["effects"] = arguments.no_rtl
                          ? nlohmann::ordered_json(nullptr)
                          : nlohmann::ordered_json{{"simulated", plan.simulated}, {"left_out", plan.left_out}};
  std::string again;
  if (const std::optional<Mismatch>& first = simulation.first_mismatch;
      first && !has_waves(options.rtl, first->cycle)) {
    again = replay(arguments, command, shortest(loaded, wrong.empty() ? plan.options : options, *first));
    report["first_mismatch"]["replay"] = again;
  }
  const Rgb8 picture = arguments.picture_of.picture(simulation, options);
  write_images(arguments.out, picture_of(simulation, options), picture);
  const std::optional<AgainstFigures> like = against.figures(0, picture);
  add_view(report, {.against = like});
  write_text(arguments.out + "/report.json", report.dump(2) + "\n");
  // A run that was repeated with all effects has left two in the record.
  if (page)
    arguments.page.write(command, arguments.out,
                         {.picture = picture,
                          .report = report,
                          .against = against.photograph(0),
                          .against_name = like ? std::filesystem::path(like->photograph).filename().string() : "",
                          .record = wrong.empty() && seen ? &*seen : nullptr},
                         simulation, options);
  viewer.add(picture);
  const std::string viewed = viewer.write(arguments.out);
  if (arguments.json) {
    fmt::print("{}\n", report.dump(2));
  } else {
    fmt::print("{}{}  picture {}/frame.png, {}/frame.exr; figures {}/report.json\n{}", report_text(report),
               like ? "  " + against_text(*like) : "", arguments.out, arguments.out, arguments.out,
               viewed.empty() ? "" : "  " + viewed);
  }
  std::fflush(stdout);  // a mismatch stands last
  const auto last = static_cast<int64_t>(simulation.rtl.cycles);
  if (const std::optional<WaveRange>& range = options.rtl.wave_range; range && range->cycle - range->around > last)
    fmt::print(stderr, "pipegs: --waves-around {}: the run ends with cycle {}, its waves are empty\n", range->cycle,
               last);
  if (!wrong.empty()) fmt::print(stderr, "pipegs: {}\n", wrong);
  if (!simulation.first_mismatch) return wrong.empty() ? kExitOk : kExitDiffers;
  fmt::print(stderr, "first mismatch, {}\n", simulation.first_mismatch->line());
  if (!again.empty()) fmt::print(stderr, "replay with waves: {}\n", again);
  else fmt::print(stderr, "its waves: gtkwave {}\n", shell_word(arguments.out + "/waves.gtkw"));
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
  arguments.against.add(command);
  arguments.page.add(command);
  arguments.viewer.add_option(command);
  add_text(command, "--picture", arguments.picture,
           "pixels in memory: windows, as --set pixel_w says; raster, rows of RGBA8, and frame.png is these")
      .shows_default()
      .one_of({"windows", "raster"}, true);
  add_text(command, "--out", arguments.out, "folder for frame.exr, frame.png, report.json, and what is asked for")
      .shows_default();
  add_flag(command, "--waves", arguments.waves,
           "waves.fst: waves of every signal (use with --window); waves.gtkw: its streams in GTKWave");
  add_read(command, "--waves-around",
           "waves.fst of so many cycles on both sides of one (200 without N), and only these", "CYCLE[,N]",
           [](const std::string& text) { arguments.wave_range = wave_range(text); })
      .excludes("--waves");
  add_names(command, "--effects", arguments.effects,
            "what to simulate: all; auto, what the view calls for; or names by commas (pipegs effects lists them)")
      .shows_default();
  add_flag(command, "--netlist", arguments.netlist,
           "units as gates, cycles compared, too (use with --window; builds for many minutes)")
      .excludes("--effects")
      .excludes("--page");
  add_names(command, "--gates", arguments.gates, "units that are gates, some of dopu,pu,su,ru; without it all are")
      .needs("--netlist");
  add_flag(command, "--no-truth", arguments.no_truth, "leave out the float64 renders and the PSNR");
  add_flag(command, "--no-rtl", arguments.no_rtl, "leave out the RTL: accuracy and work counts only, nothing compared")
      .excludes("--netlist");
  add_flag(command, "--json", arguments.json, "print report.json instead of the table");
  when_chosen(command, run, [&command] { return simulate(arguments, command); });
}

}  // namespace pipegs
