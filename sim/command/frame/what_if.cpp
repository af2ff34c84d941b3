// SPDX-License-Identifier: Apache-2.0
// what_if.cpp: `pipegs what-if`: one view on a machine and on changes of it, side by side, without the RTL.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <memory>

#include "cpp_model/float/metrics.hpp"
#include "scenes/input_error.hpp"
#include "sim/command/command.hpp"
#include "sim/command/page/study_output.hpp"
#include "sim/ladder/what_if.hpp"
#include "sim/progress.hpp"
#include "sim/timing/timing_model.hpp"

namespace pipegs {
namespace {

using Change = std::vector<std::string>;  // key=value, of one machine

struct WhatIfArguments {
  ViewArguments base;
  MemoryArguments memory;
  std::vector<Change> changes;
  StudyOutput output;
};

// One of the machines, before anything is measured.
struct Machine {
  std::string name;
  SimulateOptions options;
};

// Why there is no such machine; what other commands say of one --set begins with the option.
std::string refused(const std::string& name, std::string_view why) {
  if (why.starts_with("--set")) why.remove_prefix(why.find(' ') + 1);
  return fmt::format("--set {}: {}", one_line(name.substr(0, kLongestQuotation)), why);
}

Machine changed(const WhatIfArguments& arguments, const Change& change, const Machine& base) {
  Machine machine{fmt::format("{}", fmt::join(change, ",")), {}};
  ViewArguments view = arguments.base;
  view.settings = change;
  try {
    machine.options = view.one_of_several();
  } catch (const ConfigError& error) { throw ConfigError(refused(machine.name, error.what())); }
  const int side = machine.options.config.window, base_side = base.options.config.window;
  if (machine.options.window && side != base_side)
    throw ConfigError(refused(
        machine.name, fmt::format("--window: found windows of {} pixels, expected the base's, {}", side, base_side)));
  return machine;
}

// The base, then the changes.
std::vector<Machine> machines_of(const WhatIfArguments& arguments) {
  std::vector<Machine> machines = {{arguments.base.design_point, arguments.base.one_of_several()}};
  if (!arguments.base.config.empty()) machines.front().name = "base";
  for (const Change& change : arguments.changes) {
    machines.push_back(changed(arguments, change, machines.front()));
    const auto same = [&](const Machine& other) { return other.name == machines.back().name; };
    if (std::count_if(machines.begin(), machines.end(), same) > 1)
      throw ConfigError(refused(machines.back().name, "found a second time, expected once"));
  }
  std::vector<SimulateOptions> options;
  for (Machine& machine : machines) {
    arguments.memory.apply(machine.options);
    options.push_back(machine.options);
  }
  arguments.base.check_fields(options);
  return machines;
}

// All machines draw and count the same view.
class WhatIf {
 public:
  WhatIf(const LoadedView& loaded, const std::vector<Machine>& machines) : loaded_(loaded), machines_(machines) {
    SimulateOptions all_bands = machines.front().options;
    all_bands.config.sh_degree = kMaxShDegree;
    truth_ = simulate_float("truth", loaded.scene, loaded.camera, all_bands, Semantics::kExact);
  }

  std::vector<WhatIfRow> rows() {
    std::vector<WhatIfRow> rows;
    Progress progress("what-if");
    for (const Machine& machine : machines_) {
      const auto at = [&](double share) {
        if (interrupted()) throw std::runtime_error("interrupted");
        progress.update((static_cast<double>(rows.size()) + share) / static_cast<double>(machines_.size()),
                        machine.name);
      };
      try {
        rows.push_back(row_of(machine, at));
      } catch (const InputError& error) {  // the scene does not fit it
        if (&machine == &machines_.front()) throw;
        throw InputError(refused(machine.name, error.what()));
      }
    }
    return rows;
  }

 private:
  // A picture, and what control asks for: the same for all machines that timing_config() makes equal.
  struct Drawn {
    Simulation simulation;
    Image picture;
    TimingTrace trace;
  };

  std::unique_ptr<Drawn> draw(const Machine& machine, const std::function<void(double)>& at) const {
    auto drawn = std::make_unique<Drawn>();
    Simulation& simulation = drawn->simulation;
    simulate_pack(loaded_.scene, loaded_.camera, machine.options, simulation);
    simulate_golden(machine.options, simulation, {.progress = [&](double share) { at(kGoldenShare * share); }});
    drawn->picture = crop_window(simulation.golden.image, machine.options);
    at(kGoldenShare);
    drawn->trace = timing_trace(simulation.input);
    return drawn;
  }

  WhatIfRow row_of(const Machine& machine, const std::function<void(double)>& at) {
    WhatIfRow row{.name = machine.name, .config = machine.options.config};
    std::unique_ptr<Drawn> own;
    if (!base_ || !(timing_config(base_->trace.config) == timing_config(row.config))) own = draw(machine, at);
    if (!base_) base_ = std::move(own);
    Drawn& drawn = own ? *own : *base_;
    at(kDrawnShare);
    const TimingResult timing = timing_run(drawn.trace, row.config, machine.options.memory);
    at(1);
    drawn.simulation.traffic = timing.streams;
    row.frame = frame_figures(drawn.simulation, machine.options, timing.cycles);
    row.silicon = silicon_.cost(row.config, row.frame.cycles, row.frame.bytes());
    row.truth_db = psnr(drawn.picture, truth_);
    row.base_db = psnr(drawn.picture, base_->picture);
    return row;
  }

  static constexpr double kGoldenShare = 0.35, kDrawnShare = 0.8;  // of the time of a machine

  const LoadedView& loaded_;
  const std::vector<Machine>& machines_;
  const FrameModel silicon_ = read_frame_model();
  Image truth_;
  std::unique_ptr<Drawn> base_;
};

int what_if(const WhatIfArguments& arguments) {
  std::vector<Machine> machines = machines_of(arguments);
  arguments.output.check();
  const LoadedView loaded = load_view(arguments.base);
  for (Machine& machine : machines) follow_scene(loaded, machine.options);
  const PixelBytes drawn = kGoldenPixels + kImagePixels;  // the base's is held
  check_picture_memory(loaded.camera, machines.front().options, drawn + drawn + kImagePixels);
  const std::vector<WhatIfRow> rows = WhatIf(loaded, machines).rows();
  NamedMachines named;
  for (const WhatIfRow& row : rows) named.emplace_back(row.name, row.config);
  arguments.output.write({.title = "What if",
                          .head = head_of(loaded, arguments.memory),
                          .charts = what_if_charts(rows),
                          .tables = {what_if_table(rows)},
                          .machines = named,
                          .odd = loaded.told->all()},
                         {{"scene", loaded.scene.name},
                          {"camera", loaded.camera.name},
                          {"memory", arguments.memory.external.dram},
                          {"machines", what_if_json(rows)}});
  return kExitOk;
}

}  // namespace

void add_what_if(CLI::App& app, Run& run) {
  CLI::App& command = add_command(
      app, "what-if", "a machine beside changes: time, area, energy, dB",
      footer("pipegs what-if --set units=2 --set window=64,records=2048 --out what-if --page", "measured", "",
             "Each --set is one machine beside the base, which is --design with --config. Nothing is built: cycles and "
             "bytes are the\ntiming model's, decibels the golden model's; area, clock and energy are interpolated "
             "(docs/numerics/accuracy.md)."));
  static WhatIfArguments arguments;
  arguments.base.add(command, DesignPoints::kBase);
  arguments.memory.add(command);
  add_lists(command, "--set", arguments.changes,
            "what is another in a machine beside the base; may be repeated, each time one more machine",
            "KEY=VALUE[,...]")
      .required();
  arguments.output.add(command);
  when_chosen(command, run, [] { return what_if(arguments); });
}

}  // namespace pipegs
