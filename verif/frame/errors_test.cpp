// SPDX-License-Identifier: Apache-2.0
// errors_test: frames whose areas are too small and scenes that contradict themselves: the machine says so and stops.
//
// Whatever the size of an area is, a frame ends with the picture of the golden model or with an error; never with a
// hang or another picture, and no request leaves the areas of the frame.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "cpp_model/areas/frame_areas.hpp"
#include "cpp_model/control/job.hpp"
#include "sim/compare/sequence_check.hpp"
#include "verif/frame/machines.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

// A frame that runs once with what a test changes in its memory and its areas.
class ErrorFrame : public RtlTaps {
 public:
  ErrorFrame(size_t number, const Scene& scene, const Camera& camera) : options_(machine(number)) {
    simulate_golden(scene, camera, options_, simulation_);
    frame = simulation_.input.frame;
    areas = frame_areas(config(), packed(), frame);
    image = memory_image(packed());
    options_.rtl.quiet_limit = 30000;
  }
  const Config& config() const { return options_.config; }
  const PackedScene& packed() const { return simulation_.packed; }

  // Pixels in raster order, with so many lines to spare in each row.
  const Picture& in_raster_order(uint64_t spare) {
    Picture& picture = simulation_.input.picture;
    picture = raster_picture(frame.tables.pixels, frame.raster.width);
    picture.stride += spare;
    areas = frame_areas(config(), packed(), frame, picture);
    return picture;
  }

  // Changes every node of a table that has children, in memory alone.
  void change(const std::vector<Node>& nodes, uint64_t table, const std::function<void(Node&)>& edit) {
    std::vector<uint32_t> words(static_cast<size_t>(record_words<Node>(config())));
    for (size_t i = 0; i < nodes.size(); ++i) {
      if (nodes[i].count == 0) continue;
      Node node = nodes[i];
      edit(node);
      pack(config(), node, words.data());
      std::copy(words.begin(), words.end(), image.lines[table + i / 2].begin() + static_cast<int>(i % 2 * 8));
    }
  }
  // The error that the machine tells, or nothing when the frame is complete. All streams until then and every pixel
  // are those of the golden model, unless the scene in memory is another one.
  std::optional<MachineError> run() {
    ExternalMemory memory(options_.memory, config().bus_w);
    memory.load(image.lines);
    memory.set_lines(frame.tables.overflow + areas.overflow);
    SequenceCheck check({{&simulation_.input, &simulation_.golden, areas}}, memory, this);
    RtlTaps& taps = compares ? static_cast<RtlTaps&>(check) : *this;
    std::optional<MachineError> found;
    frames_ = 0;
    try {
      load_rtl(config())->run({frame_job(config(), frame, areas, simulation_.input.picture)}, memory, options_.rtl,
                              &taps, {});
    } catch (const MachineError& error) { found = error; }
    EXPECT_EQ(frames_, found ? 0 : 1);
    if (compares) { EXPECT_EQ(check.frame(0).mismatches(), 0u) << check.frame(0).first()->what; }
    return found;
  }

  void on_frame_done() override { ++frames_; }
  bool wants_cycles() const override { return true; }
  void on_request(int tag, bool write, uint64_t line, int lines) override {
    const Tables& t = frame.tables;
    const uint64_t last = line + static_cast<uint64_t>(lines) - 1;
    const auto in = [&](uint64_t first, uint64_t count) { return line >= first && last - first < count; };
    const bool scene = in(t.cells, areas.cells) || in(t.groups, areas.groups) || in(t.chunks, areas.chunks) ||
                       in(t.gaussians, areas.gaussians) || in(t.colors, areas.colors);
    const Picture& p = simulation_.input.picture;
    const bool pixels = p.format != 0 ? in(p.base, areas.picture) : in(t.pixels, areas.pixels);
    const bool own = in(t.overflow, areas.overflow) || (write && pixels);
    ASSERT_TRUE(own || (scene && !write)) << "tag " << tag << (write ? " writes" : " reads") << " line " << line;
  }

  Frame frame;
  Areas areas;
  MemoryImage image;
  bool compares = true;

 private:
  SimulateOptions options_;
  Simulation simulation_;
  int frames_ = 0;
};

// Machines whose stores overflow, of layers, lists with and without alphas, and nearest first.
const std::vector<size_t> kOverflowMachines = {kTiny, kTspp, kDpc, kGscore, kTinyExact};
// The default, too, and one without a bus.
const std::vector<size_t> kErrorMachines = {kTiny, kTspp, kDpc, kGscore, kTinyExact, kFast, kOdd};

TEST(Errors, EverySizeOfTheOverflowAreaGivesThePictureOrAnError) {
  const Scene scene = random_scene(71, 1200, 1);
  for (const size_t number : todays(kOverflowMachines)) {
    ErrorFrame one(number, scene, test_camera(128, 64));
    int errors = 0, pictures = 0;
    const uint64_t enough = one.areas.overflow;
    for (uint64_t lines = 1; lines <= enough; lines = 3 * lines + 1) {
      SCOPED_TRACE(fmt::format("{}, {} lines", config_difference(one.config()), lines));
      one.areas.overflow = lines;
      const auto error = one.run();
      (error ? errors : pictures) += 1;
      if (error) {
        EXPECT_EQ(error->cause, MachineError::kAreaFull);
        EXPECT_TRUE(error->line >= one.frame.tables.overflow && error->line <= one.frame.tables.overflow + lines)
            << error->what();
      }
      if (HasFatalFailure() || HasNonfatalFailure()) return;
    }
    EXPECT_GT(errors, 2) << config_difference(one.config());
    EXPECT_GT(pictures, 0) << config_difference(one.config());
  }
}

TEST(Errors, PixelsThatHaveNoRoomAreAnError) {
  for (const size_t number : todays(kErrorMachines)) {
    ErrorFrame one(number, random_scene(72, 100, 0), test_camera(150, 70));
    --one.areas.pixels;
    const auto error = one.run();
    ASSERT_TRUE(error) << config_difference(one.config());
    EXPECT_EQ(error->cause, MachineError::kAreaFull);
    EXPECT_EQ(error->line, one.frame.tables.pixels + one.areas.pixels);
  }
}

// A picture in raster order has an area, too: with the last line of its last row it is written, and with a line less
// nothing is.
TEST(Errors, APictureInRasterOrderThatHasNoRoomIsAnError) {
  for (const size_t number : todays(kErrorMachines)) {
    ErrorFrame one(number, random_scene(72, 100, 0), test_camera(150, 70));
    const Picture& picture = one.in_raster_order(1);
    one.areas.picture = 69 * picture.stride + (150 + 15) / 16;
    EXPECT_FALSE(one.run()) << config_difference(one.config());
    --one.areas.picture;
    const auto error = one.run();
    ASSERT_TRUE(error) << config_difference(one.config());
    EXPECT_EQ(error->cause, MachineError::kAreaFull);
    EXPECT_EQ(error->line, picture.base + one.areas.picture);
  }
}

// What is wrong with a scene, and the line that the error must name.
struct Malformed {
  const char* what;
  std::function<void(ErrorFrame&)> make;
  std::function<uint64_t(const ErrorFrame&)> line;
};

const std::vector<Malformed> kMalformed = {
    {"a group of no chunks",
     [](ErrorFrame& f) { f.change(f.packed().groups, f.frame.tables.groups, [](Node& n) { n.first = n.count = 0; }); },
     [](const ErrorFrame& f) { return f.frame.tables.chunks; }},
    {"a chunk of no Gaussians",
     [](ErrorFrame& f) { f.change(f.packed().chunks, f.frame.tables.chunks, [](Node& n) { n.first = n.count = 0; }); },
     [](const ErrorFrame& f) { return f.frame.tables.gaussians; }},
    {"a cell behind the last group",
     [](ErrorFrame& f) {
       f.change(f.packed().cells, f.frame.tables.cells, [&](Node& n) { n.first = 2 * f.areas.groups; });
     },
     [](const ErrorFrame& f) { return f.frame.tables.chunks; }},
    {"a group behind the last chunk",
     [](ErrorFrame& f) {
       f.change(f.packed().groups, f.frame.tables.groups, [&](Node& n) { n.first = 2 * f.areas.chunks; });
     },
     [](const ErrorFrame& f) { return f.frame.tables.gaussians; }},
    {"a chunk behind the last Gaussian",
     [](ErrorFrame& f) {
       const auto slots = f.areas.gaussians * static_cast<uint64_t>(f.config().gaussians_per_line());
       f.change(f.packed().chunks, f.frame.tables.chunks, [&](Node& n) { n.first = slots; });
     },
     [](const ErrorFrame& f) { return f.frame.tables.colors; }},
    {"a cell whose last group comes before its first",
     [](ErrorFrame& f) {
       const uint64_t last = (uint64_t{1} << f.config().slot_w()) - 1;
       f.change(f.packed().cells, f.frame.tables.cells, [&](Node& n) { n.first = last, n.count = 3; });
     },
     [](const ErrorFrame& f) { return f.frame.tables.groups + ((uint64_t{1} << f.config().slot_w()) - 1) / 2; }},
    {"a cell with more groups than there are",
     [](ErrorFrame& f) {
       f.change(f.packed().cells, f.frame.tables.cells,
                [&](Node& n) { n.first = 0, n.count = (uint64_t{1} << f.config().count_w()) - 1; });
     },
     [](const ErrorFrame& f) { return f.frame.tables.groups; }},
    {"a table of cells that ends too early", [](ErrorFrame& f) { --f.areas.cells; },
     [](const ErrorFrame& f) { return f.frame.tables.cells; }},
    {"colours that end too early", [](ErrorFrame& f) { f.areas.colors = 0; }, {}},
};

TEST(Errors, ASceneThatContradictsItselfIsAnError) {
  const Scene scene = random_scene(73, 600, 2);
  for (const size_t number : todays(kErrorMachines)) {
    for (const Malformed& malformed : kMalformed) {
      ErrorFrame one(number, scene, test_camera(96, 64));
      SCOPED_TRACE(fmt::format("{}: {}", config_difference(one.config()), malformed.what));
      malformed.make(one);
      one.compares = false;
      const auto error = one.run();
      ASSERT_TRUE(error);
      EXPECT_EQ(error->cause, MachineError::kBadScene) << error->what();
      if (malformed.line) EXPECT_EQ(error->line, malformed.line(one)) << error->what();
      if (HasFailure()) return;
    }
  }
}

// Levels are three whatever a node says, so no walk goes in a circle: a node that names itself, or what another one
// names, gives some picture or an error.
TEST(Errors, ANodeThatPointsAtItselfHangsNothing) {
  const Scene scene = random_scene(74, 300, 0);
  for (const size_t number : todays(kErrorMachines)) {
    for (const bool cells : {true, false}) {
      ErrorFrame one(number, scene, test_camera(64, 64));
      const auto& nodes = cells ? one.packed().cells : one.packed().groups;
      one.change(nodes, cells ? one.frame.tables.cells : one.frame.tables.groups, [](Node& n) { n.first = 0; });
      one.compares = false;
      one.run();
      if (HasFailure()) FAIL() << config_difference(one.config());
    }
  }
}

}  // namespace
}  // namespace pipegs
