// SPDX-License-Identifier: Apache-2.0
// example_frame_test: cpp_model/driver/example.c on the RTL: the program that a user starts with renders our own
// scene, and every stream and pixel is compared.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "cpp_model/areas/frame_areas.hpp"
#include "scenes/generate/generate.hpp"
#include "sim/compare/sequence_check.hpp"
#include "sim/compare/simulate.hpp"
#include "sim/design/design_point.hpp"
#include "cpp_model/driver/pipegs_platform.h"

extern "C" int pipegs_example();  // main of example.c

namespace pipegs {
namespace {

constexpr uint64_t kImage = 0x100000;  // bytes: where the program finds it
const pipegs_bus* bus = nullptr;
std::string said;

TEST(ExampleFrame, TheExampleRendersAFrame) {
  SimulateOptions options;
  options.config = find_design_point(kDefaultDesignPoint).config;
  Simulation simulation;
  simulate_golden(generate_scene(1), generated_cameras()[0], options, simulation);
  GoldenInput input = simulation.input;
  move_frame(input.frame, kImage / 64);

  ExternalMemory memory(options.memory, options.config.bus_w);
  std::ifstream file(PIPEGS_PACKED "/image.bin", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  ASSERT_EQ(bytes.size() % 64, 0u);
  for (size_t i = 0; i < bytes.size(); i += 4) {
    uint32_t word = 0;
    for (size_t k = 4; k-- > 0;) word = word << 8 | static_cast<uint8_t>(bytes[i + k]);
    memory.line((kImage + i) / 64)[i / 4 % 16] = word;
  }

  const Areas areas = frame_areas(options.config, *input.packed, input.frame);
  SequenceCheck check({{&input, &simulation.golden, areas}}, memory, nullptr);
  int result = -1;
  const auto program = [&](const pipegs_bus& machine) {
    bus = &machine;
    result = pipegs_example();
  };
  load_rtl(options.config)->drive(program, memory, {}, &check, {});
  EXPECT_EQ(result, 0) << said;
  EXPECT_EQ(check.complete(), 1u);
  ASSERT_EQ(check.frame(0).mismatches(), 0u) << check.frame(0).first()->what;
  EXPECT_GT(check.frame(0).beats(), 0u);
}

}  // namespace
}  // namespace pipegs

extern "C" {
uint32_t pipegs_platform_read(void*, uint32_t offset) { return pipegs::bus->read(pipegs::bus->context, offset); }
void pipegs_platform_write(void*, uint32_t offset, uint32_t value) {
  pipegs::bus->write(pipegs::bus->context, offset, value);
}
void pipegs_platform_wait(void*) { pipegs::bus->idle(pipegs::bus->context); }
uint64_t pipegs_platform_image() { return pipegs::kImage; }
void pipegs_platform_print(const char* text) { pipegs::said = text; }
}
