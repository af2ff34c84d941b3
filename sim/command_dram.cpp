// command_dram.cpp: `pipegs dram`: the memory's timing against other DRAM simulators, run by run.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "scenes/input_error.hpp"
#include "sim/command.hpp"
#include "sim/dram/dram_check.hpp"

namespace pipegs {
namespace {

struct Arguments {
  std::string references = PIPEGS_SOURCE_DIR "/verif/dram/references.csv", source;
};

int check(const Arguments& arguments) {
  std::ifstream in(arguments.references);
  if (!in) throw InputError(arguments.references, "", "cannot be read");
  std::vector<DramReference> references = read_dram_references(in);
  if (!arguments.source.empty()) std::erase_if(references, [&](const DramReference& r) { return r.source != arguments.source; });
  if (references.empty()) throw InputError(arguments.references, "", "no reference run" + (arguments.source.empty() ? "" : " of " + arguments.source));
  const std::vector<DramCheck> checks = check_dram(references);
  double streaming = 0, random = 0;
  for (const DramCheck& one : checks) {
    double& worst = one.streaming() ? streaming : random;
    worst = std::max(worst, std::abs(one.difference()));
  }
  fmt::print("{}\n{} runs; largest difference of the bandwidth: streaming {:.2f} %, random {:.2f} %\n", dram_check_table(checks), checks.size(),
             100 * streaming, 100 * random);
  return kExitOk;
}

}  // namespace

void add_dram(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("dram", "the timing of the external memory against other DRAM simulators");
  command->footer("Example: pipegs dram --source ramulator2");
  static Arguments arguments;
  command->add_option("--references", arguments.references, "reference runs, CSV")->capture_default_str();
  command->add_option("--source", arguments.source, "only the runs of this simulator: ramulator2 or dramsim3");
  command->callback([&run] { run = [] { return check(arguments); }; });
}

}  // namespace pipegs
