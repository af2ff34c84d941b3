// SPDX-License-Identifier: Apache-2.0
// self_test: the comparison itself: a machine that is fed something else than the golden model must be caught.
#include <gtest/gtest.h>

#include <set>

#include "cpp_model/areas/frame_areas.hpp"
#include "cpp_model/control/job.hpp"
#include "cpp_model/dopu/nearest/dopu_nearest.hpp"
#include "sim/compare/simulate.hpp"
#include "sim/design/design_point.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

// Runs the RTL on `image` and compares it with the golden model of `simulation`; `frame` is what the job says.
uint64_t mismatches(const Simulation& simulation, const MemoryImage& image, const Frame& frame, std::string* first) {
  const Config& config = simulation.packed.config;
  ExternalMemory memory({}, config.bus_w);
  memory.load(image.lines);
  StreamCheck check(simulation.input);
  load_rtl(config)->run({frame_job(config, frame, frame_areas(config, simulation.packed, frame))}, memory, {}, &check,
                        {});
  check.finish();
  if (check.first()) *first = check.first()->what;
  return check.mismatches();
}

uint64_t mismatches(const Simulation& simulation, const MemoryImage& image, std::string* first) {
  return mismatches(simulation, image, simulation.input.frame, first);
}

class StreamCheckTest : public testing::Test {
 protected:
  void SetUp() override {
    simulate_golden(random_scene(3, 300, 1), test_camera(128, 64), SimulateOptions{}, simulation_);
    image_ = memory_image(simulation_.packed);
  }
  // One changed field of the Gaussian in a slot, in memory only.
  void change(size_t slot, const std::function<void(GaussianRecord&)>& edit) {
    GaussianRecord record = simulation_.packed.gaussians[slot];
    edit(record);
    const Config& config = simulation_.packed.config;
    std::vector<uint32_t> words(record_words<GaussianRecord>(config));
    pack(config, record, words.data());
    const int per_line = config.gaussians_per_line();
    MemoryLine& line = image_.lines[simulation_.packed.layout.gaussians + slot / per_line];
    std::copy(words.begin(), words.end(), line.begin() + 16 / per_line * (slot % per_line));
  }
  // Slot of a Gaussian that is blended.
  size_t visible_slot() const {
    const GoldenWindow window = golden_window(simulation_.input, 0, 0);
    const uint64_t index = window.layers.at(0).splats.at(0).splat.index;
    for (size_t slot = 0; slot < simulation_.packed.slot_to_index.size(); ++slot) {
      if (simulation_.packed.slot_to_index[slot] == index) return slot;
    }
    throw std::logic_error("no visible Gaussian");
  }

  Simulation simulation_;
  MemoryImage image_;
  std::string first_;
};

TEST_F(StreamCheckTest, AgreesWhenNothingIsChanged) {
  EXPECT_EQ(mismatches(simulation_, image_, &first_), 0u) << first_;
}

TEST_F(StreamCheckTest, SeesAColourThatDiffersByOneStep) {
  change(visible_slot(), [](GaussianRecord& record) { record.base_g += 4; });
  EXPECT_GT(mismatches(simulation_, image_, &first_), 0u);
  EXPECT_NE(first_.find("green"), std::string::npos) << first_;
}

TEST_F(StreamCheckTest, SeesAnOpacityThatDiffers) {
  change(visible_slot(), [](GaussianRecord& record) { record.opacity += 64; });
  EXPECT_GT(mismatches(simulation_, image_, &first_), 0u);
}

TEST_F(StreamCheckTest, SeesAGaussianThatIsMissing) {
  change(visible_slot(), [](GaussianRecord& record) { record.opacity = 0xffff; });
  EXPECT_GT(mismatches(simulation_, image_, &first_), 0u);
  EXPECT_NE(first_.find("missing"), std::string::npos) << first_;
}

TEST_F(StreamCheckTest, SeesAChangedIndex) {
  change(visible_slot(), [](GaussianRecord& record) { record.index += 1000; });
  EXPECT_GT(mismatches(simulation_, image_, &first_), 0u);
}

// The machine whose windows have walks, on one window, and streams as it would show them.
class WalkCheckTest : public testing::Test {
 protected:
  // Windows with more Gaussians than this at one depth go by parts.
  void golden(uint64_t walk_most) {
    SimulateOptions options;
    options.config = find_design_point("fast").config;
    options.walk_most = walk_most;
    simulate_golden(random_scene(3, 300, 1), test_camera(128, 128), options, simulation_);
    window_ = golden_window(simulation_.input, 0, 0);
  }
  const Config& config() const { return simulation_.packed.config; }
  template <class R>
  std::vector<uint32_t> words_of(const R& record) const {
    std::vector<uint32_t> words(record_words<R>(config()));
    pack(config(), record, words.data());
    return words;
  }

  Simulation simulation_;
  GoldenWindow window_;
};

// The machine goes as its job says, whole or by parts, and the golden model the other way.
TEST_F(WalkCheckTest, SeesAMachineThatWalksOtherwise) {
  for (const uint64_t walk_most : {0, 1}) {
    golden(walk_most);
    const MemoryImage image = memory_image(simulation_.packed);
    Frame frame = simulation_.input.frame;
    std::string first;
    EXPECT_EQ(mismatches(simulation_, image, frame, &first), 0u) << first;
    frame.walk_most = 1 - walk_most;
    EXPECT_GT(mismatches(simulation_, image, frame, &first), 0u);
    EXPECT_NE(first.find("DOPU -> PU"), std::string::npos) << first;
  }
}

TEST_F(WalkCheckTest, SeesASplatBehindTheLastWalk) {
  golden(1);
  ASSERT_EQ(window_.walks.size(), 4u);
  StreamCheck check(simulation_.input);
  for (size_t i = 0; i < window_.walks.size(); ++i) check.on_splat(0, words_of(Splat{.kind = kPartEnd}).data());
  EXPECT_EQ(check.mismatches(), 1u) << "the last end was to be that of the window";
  std::set<uint64_t> parts;
  for (const GoldenSplat& golden : window_.layers.at(0).splats) {
    if (!parts.insert(golden.splat.part).second) continue;
    const uint64_t before = check.mismatches();
    check.on_splat(0, words_of(golden.splat).data());
    EXPECT_EQ(check.mismatches(), before + 1) << "part " << golden.splat.part;
  }
  EXPECT_EQ(parts.size(), 4u);
}

// One that comes for a part of a window that is walked whole, or the other way round.
TEST_F(WalkCheckTest, SeesAChunkOfAWalkThatTheWindowDoesNotHave) {
  for (const uint64_t walk_most : {0, 1}) {
    golden(walk_most);
    const uint64_t other = walk_most == 0 ? walk_of(config(), 1) : kWholeWalk;
    StreamCheck check(simulation_.input);
    uint64_t sent = 0;
    const auto send = [&](int, const Chunk& chunk, uint64_t) {
      check.on_chunk(0, kData, words_of(chunk).data());
      EXPECT_EQ(check.mismatches(), chunk.walk == other ? ++sent : 0u);
    };
    for (const uint64_t walk : window_.walks)
      dopu_nearest(config(), simulation_.input.frame, *simulation_.input.packed, 0, 0, walk, send);
    dopu_nearest(config(), simulation_.input.frame, *simulation_.input.packed, 0, 0, other, send);
    EXPECT_GT(sent, 0u);
  }
}

}  // namespace
}  // namespace pipegs
