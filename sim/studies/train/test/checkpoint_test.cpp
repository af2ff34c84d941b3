// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/train/run/checkpoint: a run that goes on from any of its checkpoints ends in the same bits.
//
// Idea    A file that is cut, changed, of another run or holds what is no number is refused; one that cannot be written
//         leaves the one before.
#include "sim/studies/train/run/checkpoint.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "scenes/input_error.hpp"
#include "scenes/own_failure.hpp"
#include "verif/scenes/scratch_folder.hpp"
#include "sim/studies/train/test/small_world.hpp"

namespace pipegs {
namespace {

class Checkpoint : public testing::Test {
 protected:
  Checkpoint() {
    options_.schedule.steps = 240;  // grows at 100
    options_.layers = 2;
    start_ = start_of_points(small_points(scene_), 1, 1000, 0);
  }

  Trainer begun() const { return Trainer(options_, views_, Trainer::begin(start_)); }
  std::uint64_t mark() const { return run_mark(options_, views_, start_); }
  static void advance(Trainer& trainer, int steps) {
    for (int i = 0; i < steps && !trainer.done(); ++i) trainer.step();
  }
  std::string bytes() const {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void expect_refused(const std::string& word, std::uint64_t of) const {
    try {
      read_checkpoint(path_, of);
      ADD_FAILURE() << "was accepted";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(path_.string()), std::string::npos) << error.what();
    }
  }

  const ScratchFolder scratch_;
  const std::filesystem::path path_ = scratch_ / "checkpoint.bin";
  const Scene scene_ = small_scene(60);
  const TrainingViews views_ = views_of_scene(scene_, small_cameras(9, 32, 24), 1, 0, [](double) {});
  TrainOptions options_;
  Parameters start_;
};

TEST_F(Checkpoint, ARunThatGoesOnEndsInTheSameBits) {
  Trainer whole = begun();
  advance(whole, options_.schedule.steps);
  write_checkpoint(path_, mark(), whole.state());
  const std::string wanted = bytes();
  EXPECT_GT(whole.state().parameters.size(), start_.size());
  for (const int stop : {0, 1, 57, 99, 100, 101, 239}) {
    SCOPED_TRACE(stop);
    Trainer first = begun();
    advance(first, stop);
    write_checkpoint(path_, mark(), first.state());
    advance(first, 3);  // lost when it was killed
    Trainer second(options_, views_, read_checkpoint(path_, mark()));
    advance(second, options_.schedule.steps);
    write_checkpoint(path_, mark(), second.state());
    EXPECT_TRUE(bytes() == wanted);
  }
  EXPECT_EQ(scratch_.files(), 1u);
}

TEST_F(Checkpoint, WhatIsCutOrChangedIsRefused) {
  Trainer trainer = begun();
  advance(trainer, 5);
  write_checkpoint(path_, mark(), trainer.state());
  const std::string good = bytes();
  for (const std::size_t length : {std::size_t{0}, std::size_t{7}, std::size_t{20}, good.size() / 2, good.size() - 1}) {
    scratch_.write("checkpoint.bin", good.substr(0, length));
    expect_refused(length < 12 ? "expected a checkpoint" : "cut or changed", mark());
  }
  for (const std::size_t place : {std::size_t{9}, std::size_t{30}, good.size() / 3, good.size() - 2}) {
    std::string changed = good;
    changed[place] = static_cast<char>(changed[place] ^ 4);
    scratch_.write("checkpoint.bin", changed);
    expect_refused("cut or changed", mark());
  }
  scratch_.write("checkpoint.bin", std::string(1000, 'x'));
  expect_refused("expected a checkpoint", mark());
}

TEST_F(Checkpoint, WhatIsNoNumberIsRefused) {
  for (const float value : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    TrainState state = Trainer::begin(start_);
    state.moments.second.rotation[3].y = value;
    write_checkpoint(path_, mark(), state);
    expect_refused("second moments", mark());
  }
  TrainState state = Trainer::begin(start_);
  state.parameters.mean.pop_back();
  write_checkpoint(path_, mark(), state);
  expect_refused("parameters", mark());
  state = Trainer::begin(start_);
  state.demand.seen.push_back(1);
  write_checkpoint(path_, mark(), state);
  expect_refused("contradict", mark());
}

TEST_F(Checkpoint, OfAnotherRunIsRefused) {
  write_checkpoint(path_, mark(), Trainer::begin(start_));
  TrainOptions other = options_;
  other.threads = 7;
  EXPECT_EQ(run_mark(other, views_, start_), mark()) << "threads change nothing";
  other.seed = 2;
  expect_refused("another run", run_mark(other, views_, start_));
  other = options_;
  other.cldr.weight = 2;
  expect_refused("another run", run_mark(other, views_, start_));
  TrainingViews views = views_;
  views.trained[3].computed[7].x += 0.1f;
  expect_refused("another run", run_mark(options_, views, start_));
}

TEST_F(Checkpoint, OneThatCannotBeWrittenLeavesTheOneBefore) {
  Trainer trainer = begun();
  write_checkpoint(path_, mark(), trainer.state());
  const std::string before = bytes();
  advance(trainer, 1);
  // A name that is too long; a full disk is tried by train_cli.
  const std::filesystem::path longest = scratch_ / std::string(256, 'a');
  EXPECT_THROW(write_checkpoint(longest, mark(), trainer.state()), OwnFailure);
  EXPECT_TRUE(bytes() == before);
  EXPECT_EQ(read_checkpoint(path_, mark()).step, 0);
  EXPECT_EQ(scratch_.files(), 1u);
}

}  // namespace
}  // namespace pipegs
