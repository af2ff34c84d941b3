// SPDX-License-Identifier: Apache-2.0
// coverage_test: which lines of the default machine's RTL frames execute: a report, and a floor.
//
// Idea    The machine is linked here with Verilator's counters (--coverage-line): one for each block of statements and
//         each branch of the RTL, of all instances of a module together. A window of our own scene, hostile views, and
//         windows in which the Sorting Units spill, some whole and some in parts, are drawn, and compared as always.
//         What none of them executes is printed by module, with its lines; unit tests and proofs may reach it.
// Rule    Fewer executed than kFloor fails: a change of the RTL that frames do not reach, or views that reach less.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <verilated_cov.h>

#include <fstream>
#include <map>
#include <memory>
#include <set>
#include <tuple>

#include "scenes/generate/generate.hpp"
#include "sim/bounds/hostile_scene.hpp"
#include "verif/frame/scenes.hpp"
#include "verif/scenes/scratch_folder.hpp"
#include "verif/support/config.hpp"
#include "verif/top/linked_machine.hpp"

namespace pipegs {
namespace {

constexpr double kFloor = 98.0;  // per cent

class Coverage {
 public:
  // Takes the counters of the latest run in this thread.
  void add() {
    const std::string file = (scratch_ / "coverage.dat").string();
    Verilated::threadContextp()->coveragep()->write(file.c_str());
    std::ifstream text(file);
    for (std::string line; std::getline(text, line);) {
      if (line.starts_with("C '")) count(line);
    }
  }

  // Prints what was not executed, by module; the share that was, in per cent.
  double report() const {
    size_t all = 0, never = 0;
    for (const auto& [module, points] : modules_) {
      std::set<int> lines;
      size_t missed = 0;
      for (const auto& [point, executed] : points) {
        if (executed) continue;
        lines.insert(std::get<0>(point));
        ++missed;
      }
      all += points.size();
      never += missed;
      if (missed > 0)
        fmt::print("{:24} {} of {} never, lines {}\n", module, missed, points.size(), fmt::join(lines, " "));
    }
    const double share = all == 0 ? 0 : 100 * static_cast<double>(all - never) / static_cast<double>(all);
    fmt::print("{} modules: {} of {} executed, {:.1f} %\n", modules_.size(), all - never, all, share);
    return share;
  }

 private:
  using Point = std::tuple<int, int, std::string>;  // line, column, which branch

  // A line of the file is C '<1>key<2>value<1>key<2>value...' count.
  void count(const std::string& line) {
    const size_t end = line.rfind('\'');
    const auto field = [&](const std::string& key) {
      const size_t at = line.find('\1' + key + '\2');
      if (at == std::string::npos) return std::string();
      const size_t from = at + key.size() + 2;
      return line.substr(from, std::min(line.find('\1', from), end) - from);
    };
    const std::string file = field("f"), module = std::filesystem::path(file).stem().string();
    if (file.find("/rtl/") == std::string::npos || file.find("/sim/") != std::string::npos) return;
    if (module == "pipegs_stream_check") return;  // of the simulation only
    const Point point{std::stoi(field("l")), std::stoi(field("n")), field("o")};
    modules_[module][point] |= std::stoull(line.substr(end + 1)) > 0;
  }

  const ScratchFolder scratch_;
  std::map<std::string, std::map<Point, bool>> modules_;
};

// More than Sorting Units hold: rows of specks that begin at one depth, so that all are fetched before any leaves, one
// on the other; and specks a little behind the rows' ends, which still find a place when what is before them has left.
Scene rows_of_specks() {
  constexpr int kRows = 1200;
  std::vector<Gaussian> gaussians;
  const auto add = [&](float x, float y, float z) { gaussians.push_back(gaussian_at({x, y, z}, 0.02f, 0.3)); };
  for (int i = 0; i < kRows; ++i) {
    const float x = 0.3f * static_cast<float>(i % 21 - 10), y = 0.3f * static_cast<float>(i / 21 % 21 - 10);
    for (int k = 0; k < 16; ++k) add(x, y, 2 + 0.03f * static_cast<float>(k));
  }
  for (int i = 0; i < 500; ++i)
    add(0.15f + 0.3f * static_cast<float>(i % 20 - 10), 0.15f + 0.3f * static_cast<float>(i / 20 % 20 - 10), 2.49f);
  return scene_of(std::move(gaussians));
}

TEST(Coverage, FramesExecuteTheDefaultMachine) {
  SimulateOptions options;
  options.config = test_config();
  options.memory.dram = kDefaultDram;
  const std::unique_ptr<RtlModel> machine(pipegs_rtl_create(&options.config));
  Coverage coverage;
  const auto draw = [&](const Scene& scene, const Camera& camera) {
    Simulation frame;
    simulate_golden(scene, camera, options, frame);
    run_linked(*machine, options, {&frame});
    coverage.add();
  };
  options.window = {3, 3};
  draw(generate_scene(1), generated_cameras()[0]);
  options.window.reset();
  std::vector<StressView> views;
  for (uint64_t seed = 1; seed <= 8; ++seed) views.push_back(stress_view(seed));
  views.push_back(stress_view(900, {.gaussians = 20000, .width = 128, .height = 128}));
  for (const StressView& view : views) {
    options.near_plane = view.near_plane;
    draw(view.scene, view.camera);
  }
  options.near_plane = SimulateOptions{}.near_plane;
  for (const uint64_t most : {0, 1000}) {
    options.walk_most = most;
    draw(rows_of_specks(), test_camera(64, 64, 10));
  }
  EXPECT_GE(coverage.report(), kFloor) << "per cent of what stands in the RTL was executed";
}

}  // namespace
}  // namespace pipegs
