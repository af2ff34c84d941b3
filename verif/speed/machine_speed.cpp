// SPDX-License-Identifier: Apache-2.0
// machine_speed.cpp: machine_speed POINT CONFIG [ROUNDS WINDOWS LIBRARY...]: clocks machines side by side.
//
// The machine is that of the design point POINT with the entries of the file CONFIG ('' for none). Alone these two
// print its settings, as sim/rtl/build_rtl.sh takes them. Every LIBRARY (a librtl.so) is that machine in some variant.
// In each of ROUNDS rounds each of them runs WINDOWS windows in the middle of our own scene, once with nothing looked
// at and once with every beat compared. They take turns, because other work on the computer slows a run by more than
// variants differ; the fastest run counts. Prints JSON: thousands of cycles in a second of a processor. Exit code 1
// when a beat differs or libraries take other numbers of cycles, 2 on bad arguments, 3 when a library does not load.
#include <dlfcn.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <string>
#include <vector>

#include "cpp_model/areas/frame_areas.hpp"
#include "cpp_model/control/job.hpp"
#include "scenes/generate/generate.hpp"
#include "scenes/own_failure.hpp"
#include "sim/compare/simulate.hpp"
#include "sim/design/config_file.hpp"
#include "sim/design/design_point.hpp"
#include "sim/timing/timing_check.hpp"

namespace pipegs {
namespace {

using Create = RtlModel* (*)(const Config*);

struct Machine {
  std::string library;
  Create create = nullptr;
  uint64_t cycles = 0;
  double seconds = 0, compared_seconds = 0;  // of the fastest run
};

Machine load(const std::string& library) {
  void* handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) throw OwnFailure(fmt::format("{}: {}", library, dlerror()));
  const auto create = reinterpret_cast<Create>(dlsym(handle, "pipegs_rtl_create"));
  if (create == nullptr) throw OwnFailure(fmt::format("{}: no pipegs_rtl_create", library));
  return {.library = library, .create = create};
}

// Runs the machine once and keeps the seconds if they are the fewest. Throws when a beat differs.
void run(Machine& machine, const Simulation& simulation, bool compare) {
  const Config& config = simulation.packed.config;
  ExternalMemory memory({.dram = "lpddr5-6400x4"}, config.bus_w);
  memory.load(memory_image(simulation.packed).lines);
  StreamCheck check(simulation.input);
  const std::unique_ptr<RtlModel> model(machine.create(&config));
  const Frame& frame = simulation.input.frame;
  const double before = thread_seconds();
  const RtlResult result = model->run({frame_job(config, frame, frame_areas(config, simulation.packed, frame))}, memory,
                                      {}, compare ? &check : nullptr, {});
  const double seconds = thread_seconds() - before;
  if (compare) check.finish();
  if (check.mismatches() != 0) throw std::runtime_error(machine.library + ": " + check.first()->what);
  if (machine.cycles != 0 && machine.cycles != result.cycles)
    throw std::runtime_error(machine.library + ": not the same cycles in two runs");
  machine.cycles = result.cycles;
  double& least = compare ? machine.compared_seconds : machine.seconds;
  least = least == 0 ? seconds : std::min(least, seconds);
}

int positive(const char* name, const std::string& text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 1)
    throw ConfigError(fmt::format("machine_speed: {}: expected a positive integer, found '{}'", name, text));
  return value;
}

Config configuration(const std::string& point, const std::string& file) {
  Config config = find_design_point(point).config;
  if (!file.empty()) apply_config_file(file, config);
  config_check(config);
  return config;
}

int measure(const std::vector<std::string>& arguments) {
  if (arguments.size() != 2 && arguments.size() < 5)
    throw ConfigError("machine_speed: expected POINT CONFIG [ROUNDS WINDOWS LIBRARY...]");
  SimulateOptions options;
  options.config = configuration(arguments[0], arguments[1]);
  if (arguments.size() == 2) {
    fmt::print("{}\n", config_difference(options.config));
    return 0;
  }
  const int rounds = positive("ROUNDS", arguments[2]);
  const Camera camera = generated_cameras().front();
  options.windows = positive("WINDOWS", arguments[3]);
  options.window = {camera.width / 4 / options.config.window, camera.height / 2 / options.config.window};
  std::vector<Machine> machines;
  for (size_t i = 4; i < arguments.size(); ++i) machines.push_back(load(arguments[i]));
  Simulation simulation;
  simulate_golden(generate_scene(1), camera, options, simulation);
  for (int round = 0; round < rounds; ++round) {
    for (const bool compare : {false, true}) {
      for (Machine& machine : machines) run(machine, simulation, compare);
    }
  }
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Machine& machine : machines) {
    if (machine.cycles != machines.front().cycles)
      throw std::runtime_error(machine.library + ": not the cycles of the first library");
    const double kilo_cycles = 1e-3 * static_cast<double>(machine.cycles);
    list.push_back({{"variant", std::filesystem::path(machine.library).parent_path().filename()},
                    {"cycles", machine.cycles},
                    {"khz", kilo_cycles / machine.seconds},
                    {"compared_khz", kilo_cycles / machine.compared_seconds}});
  }
  fmt::print("{}\n", list.dump(2));
  return 0;
}

}  // namespace
}  // namespace pipegs

int main(int count, char** words) {
  try {
    return pipegs::measure({words + 1, words + count});
  } catch (const pipegs::ConfigError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  } catch (const pipegs::OwnFailure& error) {
    fmt::print(stderr, "machine_speed: {}\n", error.what());
    return 3;
  } catch (const std::exception& error) {
    fmt::print(stderr, "machine_speed: {}\n", error.what());
    return 1;
  }
}
