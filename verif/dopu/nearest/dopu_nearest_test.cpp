// SPDX-License-Identifier: Apache-2.0
// dopu_nearest_test: rtl/dopu/pipegs_dopu.sv whole with order = 2, on random packed scenes: every chunk of every walk
// once, and every watermark right, against cpp_model/dopu/nearest/dopu_nearest.hpp.
#include <array>
#include <cstdlib>
#include <functional>
#include <map>
#include <set>

#include "cpp_model/dopu/dopu_walks.hpp"
#include "cpp_model/dopu/nearest/dopu_nearest.hpp"
#include "cpp_model/pack/pack_nodes.hpp"
#include "scenes/ply/ply.hpp"
#include "verif/dopu/dopu_bench.hpp"
#include "verif/support/random_open.hpp"

namespace pipegs {
namespace {

struct Known {  // a chunk of a window, by the model
  Chunk chunk;
  int bucket;
};
using Window = std::map<uint64_t, Known>;  // by slot, which no two chunks share

struct Tally {
  uint64_t windows = 0, chunks = 0, marks = 0, early = 0, crowded_early = 0;
  double released = 0;  // sum over the chunks: was it below the last watermark of its window
};

// With levels of detail: in one of four frames no group has proxies, in others those from any bucket on that one of the
// groups takes.
template <class Rng>
void some_proxies(World& world, Rng& rng) {
  if (!world.config.lod || world.packed.groups.empty() || rng() % 4 == 0) return;
  const Node& group = world.packed.groups[rng() % world.packed.groups.size()];
  const auto error = static_cast<int64_t>(group.error << (world.config.bucket_bits - Config::error_bits())),
             bucket = static_cast<int64_t>(rng() % (uint64_t{1} << world.config.bucket_w()));
  const int64_t lod = dopu_depth_edge(world.config, world.frame, static_cast<int>(bucket / 2)) - error;
  world.frame.lod = static_cast<uint64_t>(std::clamp<int64_t>(lod, 1, (int64_t{1} << world.config.lod_w()) - 1));
}

// All walks of a frame, of a window or of a part, in their order; `crowded`: more nodes pass than the queue holds.
struct Expected {
  std::vector<Window> windows;              // of each walk
  std::vector<std::array<uint64_t, 3>> at;  // column, row, kind of the end
  std::vector<uint64_t> walks;
  std::vector<bool> crowded;
  uint64_t nodes_passed = 0, parts = 0;
  explicit Expected(const World& world) {
    const Frame& frame = world.frame;
    std::vector<size_t> nodes;
    for (uint64_t y = frame.raster.windows.first_y; y <= frame.raster.windows.last_y; ++y) {
      for (uint64_t x = frame.raster.windows.first_x; x <= frame.raster.windows.last_x; ++x) {
        const int column = static_cast<int>(x), row = static_cast<int>(y);
        const std::vector<uint64_t> here = dopu_walks(world.config, frame, world.packed, column, row);
        for (const uint64_t walk : here) {
          Window window;
          dopu_nearest(world.config, frame, world.packed, column, row, walk,
                       [&](int bucket, const Chunk& chunk, uint64_t) {
                         window[chunk.slot] = {chunk, bucket};
                       });
          const Planes planes = dopu_planes(world.config, frame, column, row, walk);
          size_t passed = window.size();
          const int near = dopu_depth_near(world.config, frame);  // with it as its depth a node passes most easily
          for (const auto* level : {&world.packed.cells, &world.packed.groups}) {
            for (const Node& node : *level)
              passed += node.count != 0 && dopu_test(world.config, frame, planes, node, near);
          }
          nodes_passed += passed;
          // In the queue beside them, those of a walk that is given up.
          if (frame.walk_most != 0) passed += world.packed.cells.size() + world.packed.groups.size();
          nodes.push_back(passed);
          windows.push_back(std::move(window));
          at.push_back({x, y, uint64_t{walk == here.back() ? kWindowEnd : kPartEnd}});
          walks.push_back(walk);
          parts += walk != kWholeWalk;
        }
      }
    }
    for (size_t i = 0; i < nodes.size(); ++i) {  // the next window's nodes wait in the same queue
      const size_t before = i > 0 ? nodes[i - 1] : 0, after = i + 1 < nodes.size() ? nodes[i + 1] : 0;
      crowded.push_back(before + nodes[i] + after > static_cast<size_t>(world.config.nearest_nodes));
    }
  }
};

// Follows the stream of all units and checks it against what is expected; no chunk may lack of a walk that was not
// closed.
struct Checker {
  const Config& config;
  const World* world = nullptr;
  const Expected* expected = nullptr;
  uint64_t parts = 0;  // walks of parts so far
  std::function<bool(uint64_t walk)> closed = [](uint64_t) { return false; };
  std::function<std::set<uint64_t>(size_t walk)> beside;  // with Occlusion: chunks that may lack
  size_t lacking = 0, extra = 0;
  size_t window = 0, since = 0;
  std::map<uint64_t, int> sent;  // slot -> bucket, of this window
  std::vector<uint64_t> marks;   // of this window
  int farthest = 0;              // bucket sent in this window
  std::vector<std::vector<Chunk>> ends;
  Tally tally;

  Checker(Units& units, const Config& c) : config(c), ends(static_cast<size_t>(c.units)) {
    units.taken = [this](int unit, const Chunk& chunk) { take(unit, chunk); };
  }
  void begin(const World& w, const Expected& e) {
    world = &w;
    expected = &e;
    parts += e.parts;
    window = since = 0;
    farthest = 0;
    sent.clear();
    marks.clear();
    for (auto& mine : ends) mine.clear();
  }
  void take(int unit, const Chunk& chunk) {
    if (chunk.kind != kData) ends[static_cast<size_t>(unit)].push_back(chunk);
    if (chunk.kind != kData && unit != 0)
      return;  // every unit gets the same ends, which finish() checks; no chunk passes one of them
    ASSERT_LT(window, expected->windows.size());
    const Window& here = expected->windows[window];
    if (chunk.kind == kData) {
      const auto known = here.find(chunk.slot);
      if (known == here.end() && beside) {
        ++extra;
        ++since;
        return;
      }
      ASSERT_NE(known, here.end()) << to_text(config, chunk) << " is not in window " << window;
      ASSERT_EQ(first_difference(config, known->second.chunk, chunk), "") << "window " << window;
      const int bucket = known->second.bucket;
      ASSERT_TRUE(sent.emplace(chunk.slot, bucket).second) << "sent twice: " << to_text(config, chunk);
      if (!marks.empty()) {
        ASSERT_LE(marks.back(), dopu_depth_key(config, world->frame, bucket))
            << "behind its watermark: " << to_text(config, chunk);
      }
      if (bucket < farthest) ++(expected->crowded[window] ? tally.crowded_early : tally.early);
      farthest = std::max(farthest, bucket);
      ++since;
      ++tally.chunks;
      return;
    }
    if (chunk.kind == kLayerEnd) {
      ASSERT_GE(since, static_cast<size_t>(config.mark_chunks));
      ASSERT_GT(chunk.watermark, marks.empty() ? dopu_depth_key(config, world->frame, 0) : marks.back())
          << "a watermark that did not rise";
      marks.push_back(chunk.watermark);
      since = 0;
      ++tally.marks;
    } else {
      const Frame& frame = world->frame;
      const std::array<uint64_t, 3> end = {chunk.window_x, chunk.window_y, chunk.kind};
      ASSERT_EQ(end, expected->at[window]) << "walk " << window;
      ASSERT_EQ(chunk.watermark, 0u);
      if (beside && sent.size() != here.size()) {
        const std::set<uint64_t> may = beside(window);
        for (const auto& [slot, known] : here) {
          if (sent.contains(slot)) continue;
          ASSERT_TRUE(may.contains(slot)) << to_text(config, known.chunk) << " lacks in walk " << window;
          ++lacking;
        }
      } else if (!closed(expected->walks[window])) {
        ASSERT_EQ(sent.size(), here.size()) << "walk " << window;
      }
      for (const auto& [slot, bucket] : sent) {
        tally.released += !marks.empty() && dopu_depth_key(config, frame, bucket) < marks.back();
      }
      ++window;
      ++tally.windows;
      since = 0;
      farthest = 0;
      sent.clear();
      marks.clear();
    }
  }
  void finish() const {
    EXPECT_EQ(window, expected->windows.size());
    for (const auto& mine : ends) EXPECT_TRUE(mine == ends[0]) << mine.size() << " ends against " << ends[0].size();
  }
  void print(const char* what) const {
    std::printf(
        "dopu_nearest: %s: %llu windows, %llu chunks, %llu watermarks, %.0f %% of the chunks below the last one; out "
        "of order: "
        "%llu, in windows that crowd the queue %llu\n",
        what, static_cast<unsigned long long>(tally.windows), static_cast<unsigned long long>(tally.chunks),
        static_cast<unsigned long long>(tally.marks),
        100 * tally.released / std::max<double>(1, static_cast<double>(tally.chunks)),
        static_cast<unsigned long long>(tally.early), static_cast<unsigned long long>(tally.crowded_early));
  }
};

TEST(DopuNearest, SendsEveryChunkOnceWhateverStandsAroundIt) {
  for (const Around& around : kAround) {
    SCOPED_TRACE(around.name);
    Dopu<> dopu(around.memory, around.pace, around.memory_pace);
    Checker checker(dopu.units, dopu.config);
    std::optional<Expected> expected;
    six_frames(
        dopu,
        [&](World& world) {
          some_proxies(world, dopu.bench.rng);
          checker.begin(world, expected.emplace(world));
        },
        [&](const World&) { checker.finish(); });
    checker.print(around.name);
    EXPECT_EQ(checker.tally.early, 0u) << "chunks sent behind farther ones although the queue had room";
    EXPECT_GT(checker.tally.marks, 20u);
    EXPECT_GT(checker.tally.chunks, 1000u);
    EXPECT_EQ(checker.parts > 20, dopu.config.has_walks());
  }
}

// An entry of the table whose count has no bit in the field of that name: 128 groups, where a group's error takes the
// upper bits. Its box is all there is.
TEST(DopuNearest, WalksAnEntryOf128Groups) {
  if (!test_config().lod) GTEST_SKIP() << "without proxies the count has a field of its own";
  Dopu<> dopu({});
  Checker checker(dopu.units, dopu.config);
  World world(dopu.bench.rng, 34000, 300, 200);
  std::vector<Node>& cells = world.packed.cells;
  const std::vector<Node>& groups = world.packed.groups;
  ASSERT_GT(groups.size(), 128u);
  Node whole = make_parent(dopu.config, groups);
  std::fill(cells.begin(), cells.end(), Node{});
  whole.first = 0, whole.count = 128, cells[0] = whole;
  whole.first = 128, whole.count = groups.size() - 128, cells[1] = whole;
  const Expected expected(world);
  checker.begin(world, expected);
  dopu.frame(world);
  checker.finish();
  EXPECT_GT(checker.tally.chunks, 1000u);
}

// PUs that take a chunk every few hundred cycles: the queue fills up, two windows stand in it.
TEST(DopuNearest, SendsEveryChunkOnceToSlowUnits) {
  Dopu<> dopu({.latency = 30, .jitter = 10});
  dopu.units.rare = 300;
  Checker checker(dopu.units, dopu.config);
  const World world(dopu.bench.rng, 3000, 4 * dopu.config.window, 3 * dopu.config.window);
  const Expected expected(world);
  checker.begin(world, expected);
  dopu.frame(world);
  checker.finish();
  checker.print("slow units");
  EXPECT_EQ(checker.tally.early, 0u);
}

// The RUs report windows done at any moment: what is still sent is right, watermarks too, and every end comes.
TEST(DopuNearest, SkipsTheRestOfAWindowThatIsDone) {
  Dopu<> dopu({.latency = 60, .jitter = 30}, Pace::kCoin);
  Checker checker(dopu.units, dopu.config);
  Feedback feedback(dopu.bench, dopu.units, dopu.config);
  checker.closed = [&](uint64_t walk) {
    for (uint64_t part = 0; part < static_cast<uint64_t>(dopu.config.parts()); ++part) {
      if (walk_has(dopu.config, walk, part) && (feedback.parts >> part & 1) == 0) return false;
    }
    return true;
  };
  auto& rng = dopu.bench.rng;
  feedback.next_window = [&] {
    const size_t some[] = {0, 1, rng() % 8, rng() % 60, rng() % 400, 100000};
    feedback.after = some[rng() % 6];
    feedback.parts = rng() % 3 != 0 ? ~uint64_t{0} : rng();
  };
  size_t all = 0;
  for (int frame = 0; frame < 4; ++frame) {
    World world(rng, frame == 3 ? 2000 : 20000, 200, 150);
    if (world.config.has_walks()) world.frame.walk_most = frame % 2 == 0 ? 1 : 60000;
    some_proxies(world, rng);
    const Expected expected(world);
    for (const Window& window : expected.windows) all += window.size();
    checker.begin(world, expected);
    feedback.frame = &world.frame;
    feedback.window = feedback.ends = 0;
    feedback.seen = dopu.units.beats.size();
    feedback.next_window();
    dopu.frame(world);
    ASSERT_FALSE(testing::Test::HasFatalFailure()) << "frame " << frame;
    checker.finish();
    feedback.frame = nullptr;
    dopu.no_feedback();
  }
  checker.print("done windows");
  EXPECT_LT(checker.tally.chunks, all * 9 / 10) << "of " << all;
  EXPECT_GT(checker.tally.chunks, all / 20) << "of " << all;
  EXPECT_EQ(checker.tally.early, 0u);
}

// With Occlusion: what pipegs_open might say of the walk that is sent, less and less open; and of other windows, which
// nobody may hear.
struct Shrinking : Endpoint {
  Bench<Vpipegs_dopu>& bench;
  const Checker& checker;
  uint64_t rare = 400;  // something more is closed in one cycle of so many
  size_t walk = ~size_t{0};
  Open open;
  std::map<size_t, std::set<std::array<uint64_t, 4>>> seen;  // of each walk
  Shrinking(Bench<Vpipegs_dopu>& b, const Checker& c) : bench(b), checker(c) { b.add(*this); }
  void begin() { walk = ~size_t{0}, seen.clear(), open = {}; }
  void drive() override {
    const Expected* expected = checker.expected;
    if (expected == nullptr || checker.window >= expected->walks.size())
      return write_record(checker.config, bench.dut.open_i, Open{});
    const auto& at = expected->at[checker.window];
    if (checker.window != walk) {
      walk = checker.window;
      if (open.window_x != at[0] || open.window_y != at[1] || !open.known) {
        open = {.known = 1, .window_x = at[0], .window_y = at[1]};
        rare = 20 + bench.rng() % 800;
      }
    }
    if (bench.rng() % 50 == 0)  // some other window
      return write_record(checker.config, bench.dut.open_i,
                          random_open(checker.config, at[0] + 1000, at[1], bench.rng));
    for (size_t next = walk;
         next < expected->walks.size() && expected->at[next][0] == at[0] && expected->at[next][1] == at[1]; ++next) {
      Closed closed = walk_closed(checker.config, open, expected->walks[next]);
      const auto side = static_cast<uint64_t>(walk_square(checker.config, expected->walks[next]).side) / 8;
      const auto more = [&](uint64_t& one, uint64_t other) {
        if (bench.rng() % rare == 0 && one + other + 1 < side) one += 1 + bench.rng() % (side - one - other - 1);
      };
      more(closed.left, closed.right), more(closed.right, closed.left);
      more(closed.top, closed.bottom), more(closed.bottom, closed.top);
      close_walk(checker.config, open, expected->walks[next], closed);
      seen[next].insert({closed.left, closed.right, closed.top, closed.bottom});
    }
    write_record(checker.config, bench.dut.open_i, open);
  }
  void observe() override {}
  // Chunks that some planes of the walk, as they were, do not let pass, or a node above them.
  std::set<uint64_t> beside(const World& world, const Expected& expected, size_t number) const {
    const Config& c = world.config;
    const int x = static_cast<int>(expected.at[number][0]), y = static_cast<int>(expected.at[number][1]);
    const Planes whole = dopu_planes(c, world.frame, x, y, expected.walks[number]);
    std::vector<Planes> planes;
    if (const auto found = seen.find(number); found != seen.end()) {
      for (const auto& one : found->second)
        planes.push_back(dopu_planes(c, world.frame, x, y, expected.walks[number], {one[0], one[1], one[2], one[3]}));
    }
    const auto fails = [&](const Node& node, int parent) {
      return std::any_of(planes.begin(), planes.end(), [&](const Planes& one) {
        return !dopu_test(c, world.frame, one, node, dopu_depth_edge(c, world.frame, parent));
      });
    };
    const auto bucket = [&](const Node& node, int parent) { return dopu_depth(c, world.frame, whole, node, parent); };
    std::set<uint64_t> slots;
    for (const Node& cell : world.packed.cells) {
      if (cell.count == 0) continue;
      const bool cell_fails = fails(cell, 0);
      const int cell_bucket = bucket(cell, 0);
      for (uint64_t g = cell.first; g < cell.first + cell.count; ++g) {
        const Node& group = world.packed.groups[g];
        const bool group_fails = cell_fails || fails(group, cell_bucket);
        const int group_bucket = bucket(group, cell_bucket);
        const Node opened = dopu_lod(c, world.frame, group, group_bucket);
        for (uint64_t k = opened.first; k < opened.first + opened.count; ++k) {
          const Node& chunk = world.packed.chunks[k];
          if (group_fails || fails(chunk, group_bucket)) slots.insert(chunk.first);
        }
      }
    }
    return slots;
  }
};

// The rectangle around what is open shrinks at any moment: only what lies beside it lacks, watermarks are right, and
// every end comes.
TEST(DopuNearest, LeavesOutWhatLiesBesideTheOpenRectangle) {
  if (!test_config().occlusion) GTEST_SKIP() << "without Occlusion the planes stay";
  for (const Around& around : {kAround[0], kAround[1], kAround[4]}) {
    SCOPED_TRACE(around.name);
    Dopu<> dopu(around.memory, around.pace, around.memory_pace);
    Checker checker(dopu.units, dopu.config);
    Shrinking shrinking(dopu.bench, checker);
    size_t all = 0;
    for (int frame = 0; frame < 3; ++frame) {
      World world(dopu.bench.rng, frame == 1 ? 2000 : 12000, 300, 200);
      if (world.config.has_walks()) world.frame.walk_most = frame == 0 ? 1 : 60000;
      some_proxies(world, dopu.bench.rng);
      const Expected expected(world);
      for (const Window& window : expected.windows) all += window.size();
      shrinking.begin();
      checker.begin(world, expected);
      checker.beside = [&](size_t walk) { return shrinking.beside(world, expected, walk); };
      dopu.frame(world);
      ASSERT_FALSE(testing::Test::HasFatalFailure()) << "frame " << frame;
      checker.finish();
      checker.expected = nullptr;
    }
    std::printf("dopu_nearest: %s: %zu of %zu chunks left out, %zu that the walk alone would not let pass\n",
                around.name, checker.lacking, all, checker.extra);
    EXPECT_GT(checker.lacking, all / 20);
    EXPECT_LT(checker.extra, 1 + all / 150);
  }
}

// Nothing is left out while nothing is closed, or something of another window.
TEST(DopuNearest, HearsOnlyOfItsOwnWindow) {
  if (!test_config().occlusion) GTEST_SKIP();
  Dopu<> dopu({.latency = 60, .jitter = 30});
  Checker checker(dopu.units, dopu.config);
  const World world(dopu.bench.rng, 8000, 300, 200);
  const Expected expected(world);
  checker.begin(world, expected);
  const Beside other(
      dopu.bench, [] {},
      [&] {
        const auto& at = expected.at[std::min(checker.window, expected.at.size() - 1)];
        Open open = random_open(dopu.config, at[0], at[1], dopu.bench.rng);
        if (dopu.bench.rng() % 2 == 0) open.known = 0;
        else open.window_x += 1000;
        write_record(dopu.config, dopu.bench.dut.open_i, open);
      });
  dopu.frame(world);
  checker.finish();
}

// Without a clock whenever active_o is low, with units that take a chunk every few hundred cycles: the same frame.
TEST(DopuNearest, NeedsNoClockWhenItSaysSo) {
  Dopu<GatedBench<Vpipegs_dopu>> dopu({.latency = 300, .bytes_per_cycle = 0.1, .jitter = 100, .queue = 1});
  dopu.units.rare = 600;
  Checker checker(dopu.units, dopu.config);
  std::optional<Shrinking> shrinking;
  if (dopu.config.occlusion) shrinking.emplace(dopu.bench, checker);
  World world(dopu.bench.rng, 300, 3 * dopu.config.window, 2 * dopu.config.window);
  if (world.config.has_walks()) world.frame.walk_most = 100;
  const Expected expected(world);
  checker.begin(world, expected);
  if (shrinking) checker.beside = [&](size_t walk) { return shrinking->beside(world, expected, walk); };
  dopu.frame(world, true);
  checker.finish();
  EXPECT_GT(dopu.bench.gated, dopu.bench.cycle / 10) << "of " << dopu.bench.cycle << " cycles";
}

// A node test in each cycle, a chunk in ten, a node through the queue in five, whichever is most; the rest hides
// behind it, as far as windows are alike. PIPEGS_LATENCY=cycles: of the memory. PIPEGS_SCENE=file.ply
// PIPEGS_CAMERAS=cameras.json: that scene's first view instead of a random cloud.
TEST(DopuNearest, KeepsItsTestsBusy) {
  const char* latency = std::getenv("PIPEGS_LATENCY");
  Dopu<> dopu({.latency = latency != nullptr ? std::atoi(latency) : 100, .bytes_per_cycle = 51.2});
  Checker checker(dopu.units, dopu.config);
  const char *scene = std::getenv("PIPEGS_SCENE"), *cameras = std::getenv("PIPEGS_CAMERAS");
  const bool given = scene != nullptr && cameras != nullptr;
  World world = given ? World(read_ply(scene), read_cameras(cameras).at(0))
                      : World(dopu.bench.rng, 20000, 10 * dopu.config.window, 7 * dopu.config.window);
  world.frame.walk_most = 0;  // what is summed is of whole windows
  const Expected expected(world);
  const DopuCounts sum = dopu_counts(world);
  checker.begin(world, expected);
  const uint64_t frame_cycles = dopu.frame(world);
  checker.finish();
  checker.print(given ? scene : "random cloud");
  const double tests = static_cast<double>(sum.cell_tests + sum.group_tests + sum.chunk_tests),
               windows = static_cast<double>(checker.tally.windows);
  const double bound =
      std::max({tests, 10.0 * static_cast<double>(sum.chunks), 5.0 * static_cast<double>(expected.nodes_passed)});
  const double cycles = static_cast<double>(frame_cycles);
  RecordProperty("roofline_ratio", std::to_string(cycles / bound));
  std::printf("dopu_nearest: %.0f tests, %llu chunks, %.0f cycles, %.0f a window, roofline ratio %.3f\n", tests,
              static_cast<unsigned long long>(sum.chunks), cycles, cycles / windows, cycles / bound);
  // The shortest queue that windows of 128 pixels may have is full most of the time.
  EXPECT_LT(cycles, (world.config.has_walks() && world.config.nearest_nodes <= 128 ? 2.0 : 1.4) * bound);
}

}  // namespace
}  // namespace pipegs
