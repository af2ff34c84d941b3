// SPDX-License-Identifier: Apache-2.0
// effects.cpp: `pipegs effects`: which parts of the machine and of its simulation a view calls for, and the gain.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <ctime>
#include <limits>
#include <nlohmann/json.hpp>

#include "sim/command/command.hpp"
#include "sim/effects/run.hpp"
#include "sim/progress.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

struct EffectsArguments {
  ViewArguments view;
  MemoryArguments memory;
  bool json = false, measure = false;
  int rounds = 3;
};

// Seconds of all cores that this program has computed: other work on the machine hardly moves them.
double computed_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Time {
  double wall = 0, computed = 0;
  Time operator+(const Time& o) const { return {wall + o.wall, computed + o.computed}; }
};

template <class Work>
Time timed(Work&& work) {
  const Stopwatch watch;
  const double before = computed_seconds();
  work();
  return {watch.seconds(), computed_seconds() - before};
}

// The stages of one simulation, without the truth, which no effect touches. Of several rounds the best of each stage.
struct Measured {
  Time golden, detect, build, rtl;  // golden: packing and golden model
  uint64_t cycles = 0, mismatches = 0;
  std::string caught;

  Time total() const { return golden + detect + rtl; }
  void best(const Measured& o) {
    const auto less = [](Time& mine, const Time& other) {
      if (other.computed < mine.computed) mine = other;
    };
    less(golden, o.golden), less(detect, o.detect), less(rtl, o.rtl);
    mismatches += o.mismatches;
    if (!o.caught.empty()) caught = o.caught;
  }
};

Measured measure(const LoadedView& loaded, const SimulateOptions& full, bool lean) {
  Measured measured;
  Simulation simulation;
  measured.golden = timed([&] { simulate_golden(loaded.scene, loaded.camera, full, simulation); });
  EffectPlan plan{full, {}, {}};
  if (lean)
    measured.detect =
        timed([&] { plan = plan_effects(full, find_effects(effect_facts(loaded.scene, full, simulation, false))); });
  measured.build =
      timed([&] { build_rtl(plan.options.config, built_variant(plan.options.variant, plan.options.rtl)); });
  measured.rtl =
      timed([&] { measured.caught = simulate_effects(loaded.scene, loaded.camera, full, plan, simulation); });
  measured.cycles = simulation.rtl.cycles;
  measured.mismatches = simulation.mismatches;
  return measured;
}

Json to_json(const Measured& m) {
  const auto time = [](const Time& t) { return Json{{"wall", t.wall}, {"computed", t.computed}}; };
  return {{"golden", time(m.golden)}, {"detect", time(m.detect)}, {"build", time(m.build)},     {"rtl", time(m.rtl)},
          {"total", time(m.total())}, {"cycles", m.cycles},       {"mismatches", m.mismatches}, {"caught", m.caught}};
}

Json table(const Scene& scene, const SimulateOptions& options, const Simulation& simulation) {
  Json list = Json::array();
  for (const EffectFinding& finding : find_effects(effect_facts(scene, options, simulation, true))) {
    list.push_back({{"name", finding.effect->name},
                    {"called_for", finding.verdict.called_for},
                    {"evidence", finding.verdict.evidence},
                    {"what", finding.effect->what},
                    {"cost", effect_cost(*finding.effect, options)},
                    {"without", finding.effect->without}});
  }
  return list;
}

void print_measured(const Json& json) {
  fmt::print("\n  seconds of a core (wall)            all            auto   ratio\n");
  const auto line = [&](const char* name, const char* key) {
    const Json &all = json["all"][key], &lean = json["auto"][key];
    const double a = all["computed"], b = lean["computed"];
    fmt::print("    {:<22}{:>8.2f} ({:.2f}){:>9.2f} ({:.2f}){}\n", name, a, all["wall"].get<double>(), b,
               lean["wall"].get<double>(), a > 0 && b > 0 ? fmt::format("{:>8.2f}", a / b) : "");
  };
  line("pack, golden model", "golden"), line("detectors", "detect"), line("RTL, comparison", "rtl"),
      line("in all", "total");
  line("once: RTL build", "build");
  const auto cycles = [&](const char* key) { return json[key]["cycles"].get<uint64_t>(); };
  fmt::print("    cycles {} and {}, mismatches {} and {}\n", cycles("all"), cycles("auto"),
             json["all"]["mismatches"].get<uint64_t>(), json["auto"]["mismatches"].get<uint64_t>());
}

int effects(const EffectsArguments& arguments) {
  SimulateOptions options = arguments.view.options();
  arguments.memory.apply(options);
  const LoadedView loaded = load_view(arguments.view);
  follow_scene(loaded.scene, options);
  check_picture_memory(loaded.camera, options, kGoldenPixels + kRtlPixels);
  Json json = {{"scene", loaded.scene.name},
               {"camera", loaded.camera.name},
               {"configuration", config_difference(options.config)}};
  {
    Simulation simulation;
    simulate_golden(loaded.scene, loaded.camera, options, simulation);
    json["effects"] = table(loaded.scene, options, simulation);
  }
  std::string caught;
  if (arguments.measure) {
    Measured all = measure(loaded, options, false), lean = measure(loaded, options, true);
    for (int round = 1; round < arguments.rounds; ++round) {
      all.best(measure(loaded, options, false));
      lean.best(measure(loaded, options, true));
    }
    caught = lean.caught;
    json["all"] = to_json(all), json["auto"] = to_json(lean);
  }
  if (arguments.json) {
    fmt::print("{}\n", json.dump(2));
  } else {
    fmt::print("{}: view {} ({}x{})\n\n", loaded.scene.name, loaded.camera.name, loaded.camera.width,
               loaded.camera.height);
    for (const Json& row : json["effects"]) {
      const auto text = [&](const char* key) { return row[key].get<std::string>(); };
      fmt::print("  {:<14}{:<12}{}\n", text("name"), row["called_for"].get<bool>() ? "called for" : "not",
                 text("evidence"));
      fmt::print("  {:<26}{}; without: {}{}\n", "", text("what"), text("without"),
                 text("cost").empty() ? "" : ", saves " + text("cost"));
    }
    if (arguments.measure) print_measured(json);
  }
  if (!caught.empty()) fmt::print(stderr, "pipegs: {}\n", caught);
  const bool agrees =
      !arguments.measure || (json["all"]["mismatches"] == 0 && json["auto"]["mismatches"] == 0 && caught.empty());
  return agrees ? kExitOk : kExitDiffers;
}

}  // namespace

void add_effects(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand(
      "effects",
      "which parts of machine and simulation a view calls for, with evidence; what leaving out the rest gains");
  command->footer(
      footer("pipegs effects garden.ply --cameras cameras.json --view 0 --measure",
             "listed (--measure: and every bit agrees)", "--measure: a bit differs or the RTL stops",
             "`pipegs sim --effects auto` leaves out what is not called for; every pixel is compared all the same."));
  static EffectsArguments arguments;
  arguments.view.add(*command);
  arguments.memory.add(*command);
  command->add_flag("--measure", arguments.measure,
                    "run the RTL with all and with auto, in turns, and compare their times");
  add_integer(*command, "--rounds", arguments.rounds, "with --measure: how often; the best of each stage counts", 1,
              100)
      ->capture_default_str();
  command->add_flag("--json", arguments.json, "print JSON instead of the table");
  command->callback([&run] { run = [] { return effects(arguments); }; });
}

}  // namespace pipegs
