// SPDX-License-Identifier: Apache-2.0
// dopu_load_test: rtl/dopu/dopu_load.sv against its bit-accurate model: how windows are judged, and in which cycle.
#include "Vdopu_load.h"
#include "cpp_model/dopu/dopu_load.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

struct Group {
  int near, far;  // leading bits of buckets
  uint64_t chunks;
};

class Trial {
 public:
  explicit Trial(uint64_t most, bool pair = false) : most_(most), pair_(pair) {
    dut().most_i = static_cast<IData>(most);
    dut().pair_i = pair;
    dut().group_valid_i = dut().counted_i = 0;
    bench_.reset();
  }
  Bench<Vdopu_load>& bench() { return bench_; }

  // Groups in so many of a hundred cycles, then all of them have come; the verdict must be the model's, in its cycle.
  void judge(const std::vector<Group>& groups, uint64_t percent) {
    const Config& config = test_config();
    const int shift = config.bucket_w() - config.load_w(), words = (1 << config.load_w()) / 4;
    DopuLoad load(config, most_, pair_);
    for (const Group& group : groups) {
      while (bench_.rng() % 100 >= percent) step(false);
      dut().group_near_i = static_cast<CData>(group.near);
      dut().group_far_i = static_cast<CData>(group.far);
      dut().group_chunks_i = static_cast<SData>(group.chunks);
      load.add(group.near << shift, group.far << shift, group.chunks);
      dut().group_valid_i = 1;
      step(false);
      dut().group_valid_i = 0;
      if (load.many_groups()) {
        dut().group_valid_i = bench_.rng() % 2;  // one more comes with the verdict, and is forgotten
        step(true, Load::kByPart);
        dut().group_valid_i = 0;
        ++early;
        return;
      }
    }
    step(false);
    dut().counted_i = 1;
    const std::optional<int> overfull = load.overfull();
    const int wait = load.fits() ? 0 : overfull ? 5 + *overfull / 4 : words + 4;
    for (int cycle = 0; cycle <= wait; ++cycle) {
      step(cycle == wait, load.verdict());
      if (testing::Test::HasFatalFailure()) return;
      dut().counted_i = 0;
    }
    ++(load.fits() ? fit : overfull ? parts : load.verdict() == Load::kByEye ? eyes : whole);
  }
  int early = 0, fit = 0, parts = 0, eyes = 0, whole = 0;

 private:
  Vdopu_load& dut() { return bench_.dut; }
  void step(bool judged, Load verdict = Load::kWhole) {
    dut().eval();
    ASSERT_EQ(dut().judged_o, judged) << "cycle " << bench_.cycle << ", seed " << bench_.seed;
    const Load found = !dut().split_o ? Load::kWhole : dut().parts_o ? Load::kByPart : Load::kByEye;
    if (judged) ASSERT_EQ(found, verdict) << "cycle " << bench_.cycle << ", seed " << bench_.seed;
    bench_.step();
  }
  const uint64_t most_;
  const bool pair_;
  Bench<Vdopu_load> bench_;
};

// Windows of all sizes one after the other, each as soon as the one before is judged: groups of any depth, in few
// buckets, in the same word as the group before, up to the last bucket, with the farthest corner nearer than the
// nearest.
void judge_windows(bool pair) {
  const Config& config = test_config();
  const int last = (1 << config.load_w()) - 1;
  Trial trial(static_cast<uint64_t>(60 * config.chunk), pair);
  auto& rng = trial.bench().rng;
  const auto draw = [&](uint64_t most) { return static_cast<int>(rng() % (most + 1)); };
  for (int window = 0; window < 600; ++window) {
    SCOPED_TRACE(window);
    const int sizes[] = {0, 1, 8, 30, 90, config.nearest_nodes / 2, config.nearest_nodes};
    const int count = draw(static_cast<uint64_t>(sizes[draw(6)])), around = draw(static_cast<uint64_t>(last));
    const int kind = draw(3), longest = 1 << draw(5);
    std::vector<Group> groups;
    for (int i = 0; i < count; ++i) {
      const int near = kind == 0 ? draw(static_cast<uint64_t>(last)) : std::clamp(around + draw(9) - 4, 0, last);
      const int far = kind == 1 ? last : std::clamp(near + draw(static_cast<uint64_t>(longest)) - 1, 0, last);
      groups.push_back({near, far, static_cast<uint64_t>(draw(static_cast<uint64_t>(kind == 3 ? 2 : config.group)))});
    }
    trial.judge(groups, window % 2 == 0 ? 100 : 40);
    ASSERT_FALSE(testing::Test::HasFatalFailure());
  }
  std::printf("dopu_load: %d windows fit, %d are whole, %d by eyes, %d by parts, %d for their many groups\n", trial.fit,
              trial.whole, trial.eyes, trial.parts, trial.early);
  for (const int seen : {trial.fit, trial.whole, trial.parts, trial.early}) EXPECT_GT(seen, 20);
  EXPECT_EQ(trial.eyes > 20, pair);
}

TEST(DopuLoad, JudgesAsItsModelInItsCycle) { judge_windows(false); }

TEST(DopuLoad, JudgesAPairAsItsModelInItsCycle) {
  if (test_config().eyes == 1) GTEST_SKIP() << "a machine of one eye";
  judge_windows(true);
}

// Exactly as much as is allowed in one bucket, and one chunk more, in the first bucket, in the last one, between.
TEST(DopuLoad, AllowsWhatIsAllowed) {
  const Config& config = test_config();
  const int last = (1 << config.load_w()) - 1;
  for (const uint64_t extra : {0, config.chunk - 1}) {
    Trial trial(static_cast<uint64_t>(7 * config.group * config.chunk) + extra);
    for (const int at : {0, 1, 3, 4, 100, last - 1, last}) {
      SCOPED_TRACE(at);
      std::vector<Group> groups;
      for (int i = 0; i < 7; ++i) groups.push_back({std::max(0, at - i), at, static_cast<uint64_t>(config.group)});
      const int beside = at == last ? 0 : last;
      groups.push_back({beside, beside, 1});
      trial.judge(groups, 100);
      groups.push_back({at, at, 1});
      trial.judge(groups, 100);
      ASSERT_FALSE(HasFatalFailure());
    }
    EXPECT_EQ(trial.whole, 7);
    EXPECT_EQ(trial.parts, 7);
  }
}

// No window is judged where none is on trial.
TEST(DopuLoad, HasTrialsWhereThereIsALimit) {
  Bench<Vdopu_load> bench;
  for (const bool some : {false, true}) {
    bench.dut.most_i = some;
    bench.dut.eval();
    EXPECT_EQ(bench.dut.judges_o, some);
  }
}

}  // namespace
}  // namespace pipegs
