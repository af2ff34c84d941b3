// SPDX-License-Identifier: Apache-2.0
// command.cpp: `pipegs dram`: the memory's timing against other DRAM simulators, run by run; what mappings are worth.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <ranges>

#include "scenes/input_error.hpp"
#include "sim/command/command.hpp"
#include "sim/memory/dram/check/dram_check.hpp"
#include "sim/memory/dram/check/dram_worth.hpp"
#include "sim/memory/dram_memory.hpp"

namespace pipegs {
namespace {

struct DramArguments {
  std::string references = PIPEGS_SOURCE_DIR "/verif/dram/references.csv", source, preset;
  bool mappings = false;
};

int check(const DramArguments& arguments) {
  if (!arguments.preset.empty()) throw InputError("--preset", "", "goes with --mappings");
  std::vector<DramReference> references = read_dram_references(arguments.references);
  if (!arguments.source.empty())
    std::erase_if(references, [&](const DramReference& r) { return r.source != arguments.source; });
  if (references.empty())
    throw InputError(arguments.references, "",
                     "no reference run" + (arguments.source.empty() ? "" : " of " + arguments.source));
  const std::vector<DramCheck> checks = check_dram(references);
  double streaming = 0, random = 0;
  for (const DramCheck& one : checks) {
    double& worst = one.streaming() ? streaming : random;
    worst = std::max(worst, std::abs(one.difference()));
  }
  const auto differing = std::ranges::count_if(checks, [](const DramCheck& one) { return !one.agrees(); });
  const auto known = std::ranges::count_if(checks, &DramCheck::known_to_differ);
  fmt::print("{}\n{} runs; largest difference of the bandwidth: streaming {:.2f} %, random {:.2f} %\n",
             dram_check_table(checks), checks.size(), 100 * streaming, 100 * random);
  fmt::print("{} runs differ by more than 5 % (streaming) or 10 % (random), or by a cycle from ramulator2{}\n",
             differing,
             known == 0 ? "" : fmt::format("; {} more known to differ (docs/cycles/memory_timing.md)", known));
  return differing == 0 ? kExitOk : kExitDiffers;
}

int mappings(const DramArguments& arguments) {
  const std::vector<std::string> names = arguments.preset.empty() ? dram_presets() : std::vector{arguments.preset};
  std::vector<DramRow> rows, steps;
  for (const std::string& name : names) {
    const DramTiming* preset = dram_preset(name);
    if (preset == nullptr)
      throw InputError("--preset", "", fmt::format("'{}': expected one of {}", name, fmt::join(dram_presets(), ", ")));
    std::ranges::move(dram_mapping_rows(*preset), std::back_inserter(rows));
    std::ranges::move(dram_step_rows(*preset, dram_memory_timing(name)), std::back_inserter(steps));
  }
  fmt::print("GB/s at the pins, by trace\n\n{}\nFrom the preset to the machine's memory, step by step\n\n{}",
             dram_mapping_table(rows), dram_step_table(steps));
  return kExitOk;
}

}  // namespace

void add_dram(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("dram", "the timing of the external memory against other DRAM simulators");
  command->footer(footer("pipegs dram --source ramulator2\n         pipegs dram --mappings --preset lpddr5-6400x4",
                         "every run agrees (--mappings: listed)", "a run differs"));
  static DramArguments arguments;
  command->add_option("--references", arguments.references, "reference runs, CSV")->capture_default_str();
  command->add_option("--source", arguments.source, "only the runs of this simulator: ramulator2 or dramsim3");
  command->add_flag("--mappings", arguments.mappings,
                    "instead: bandwidth by mapping, and what each rule of the machine's controller adds");
  command->add_option("--preset", arguments.preset, "with --mappings: only this preset; without it all");
  command->callback([&run] { run = [] { return arguments.mappings ? mappings(arguments) : check(arguments); }; });
}

}  // namespace pipegs
