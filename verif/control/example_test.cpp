// SPDX-License-Identifier: Apache-2.0
// example_test: cpp_model/driver/example.c, compiled with the scene.h that `pipegs pack` wrote, on the model of the
// registers: the machine is given the very frame that the model renders, and image.bin is its memory.
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>

#include "cpp_model/frame_setup.hpp"
#include "scenes/generate/generate.hpp"
#include "sim/compare/simulate.hpp"
#include "sim/design/design_point.hpp"
#include "cpp_model/driver/pipegs_platform.h"
#include "verif/control/driver_bus.hpp"

extern "C" int pipegs_example();  // main of example.c

namespace pipegs {
namespace {

constexpr uint64_t kImage = 0x40000;
DriverBus* machine = nullptr;
std::string said;

struct Example : testing::Test {
  Config config = find_design_point(kDefaultDesignPoint).config;
  DriverBus bus{config, 1};
  void SetUp() override {
    machine = &bus;
    said.clear();
  }
};

TEST_F(Example, QueuesTheFrameThatTheModelRenders) {
  ASSERT_EQ(pipegs_example(), 0) << said;
  EXPECT_EQ(said, "the frame is in memory");
  EXPECT_GT(bus.idles, 0);
  ASSERT_EQ(bus.frames.size(), 1u);
  SimulateOptions options;
  options.config = config;
  const Camera camera = generated_cameras()[0];
  const PackedScene packed = pack_views(generate_scene(1), {camera}, options);
  pipegs_job job = frame_job(config, packed, camera);
  for (uint64_t* address :
       {&job.frame.tables_cells, &job.frame.tables_groups, &job.frame.tables_chunks, &job.frame.tables_gaussians,
        &job.frame.tables_colors, &job.frame.tables_pixels, &job.frame.tables_overflow}) {
    *address += kImage;
  }
  EXPECT_GT(job.areas.overflow, 0u);
  const auto* const words = reinterpret_cast<const uint64_t*>(&job);
  const std::vector<Slot> slots = bus.model.map.shadow();
  for (size_t i = 0; i < slots.size(); ++i) {
    const uint64_t bits = slots[i].width == 0 ? 0 : ~uint64_t{0} >> (64 - slots[i].width);
    EXPECT_EQ(bus.frames[0][i], (words[i] >> slots[i].shift) & bits) << slots[i].name;
  }
  std::ifstream file(PIPEGS_PACKED "/image.bin", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  const MemoryImage image = memory_image(packed);
  ASSERT_EQ(bytes.size(), image.lines.size() * 64);
  EXPECT_EQ(std::memcmp(bytes.data(), image.lines.data(), bytes.size()), 0);
}

TEST_F(Example, SaysWhatWentWrong) {
  int cycle = 0;
  bus.at_step = [&] {
    if (!bus.frames.empty() && ++cycle == 1) {
      bus.in.errors = bus.in.located = PIPEGS_ERROR_WRITE_DECERR;
      bus.in.error_lines[3] = 0x1234;
    }
  };
  EXPECT_EQ(pipegs_example(), 1);
  EXPECT_EQ(said, "memory answered a write with DECERR; first: memory answered a write with DECERR, at 0x48d00");
  EXPECT_EQ(bus.aborts, 1);
}

// A memory that answers nothing, for as long as the machine itself allows: the program ends.
TEST_F(Example, EndsWhereMemoryIsSilent) {
  bus.answers = false;
  bus.write(PIPEGS_BUS_TIMEOUT, 5000);  // what a reset leaves is too long for a test
  EXPECT_EQ(pipegs_example(), 1);
  EXPECT_EQ(said, "memory did not answer a read for BUS_TIMEOUT cycles");
}

// Machines with other records than the scene was packed for: of other widths, and with codes in their place.
TEST(OtherMachine, IsRefused) {
  Config coded = find_design_point(kDefaultDesignPoint).config;
  coded.record = 48;
  for (const Config& config : {Config{}, coded}) {
    DriverBus bus(config, 1);
    machine = &bus;
    said.clear();
    EXPECT_EQ(pipegs_example(), 1);
    EXPECT_EQ(said, "this machine cannot render this scene from this camera");
    EXPECT_TRUE(bus.writes.empty());
  }
}

}  // namespace
}  // namespace pipegs

uint32_t pipegs_platform_read(void*, uint32_t offset) { return pipegs::machine->read(offset); }
void pipegs_platform_write(void*, uint32_t offset, uint32_t value) { pipegs::machine->write(offset, value); }
void pipegs_platform_wait(void*) { pipegs::machine->idle(); }
uint64_t pipegs_platform_image() { return pipegs::kImage; }
void pipegs_platform_print(const char* text) { pipegs::said = text; }
