// SPDX-License-Identifier: Apache-2.0
// soc_test: a frame in the example system (soc.sv): the driver starts it at the registers, a DMA has brought the scene
// and reads the picture while it is rendered, and every pixel is the golden model's.
//
// Rule    AXI4 is checked at the core's bus (axi_check, bound) and at the memory's port (AxiRules); everything pauses
//         by chance. Pixels lie where docs/integration.md says, and what is read early is either what lay there before
//         or the pixel as it stays.
#include <gtest/gtest.h>

#include "Vsoc.h"
#include "cpp_model/frame_setup.hpp"
#include "cpp_model/ru/ru_raster.hpp"
#include "sim/compare/simulate.hpp"
#include "sim/memory/axi/axi_rules.hpp"
#include "sim/rtl/pins/control_pins.hpp"
#include "verif/frame/scenes.hpp"
#include "verif/soc/soc_pins.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

constexpr uint64_t kImage = 0x10000, kOverflowSize = 0x80000, kMemory = 0x800000;  // bytes
constexpr uint32_t kBefore = 0x5afe'5afe;                                          // what lies where pixels will

// The formula of the page for the machine `fast`: bytes behind tables.pixels.
uint64_t pixel_offset(uint64_t width, uint64_t x, uint64_t y) {
  const uint64_t window = y / 128 * ((width + 127) / 128) + x / 128;
  const uint64_t region = 64 * (y / 64 % 2 * 2 + x / 64 % 2) + 8 * (y / 8 % 8) + x / 8 % 8;
  return 65536 * window + 256 * region + 32 * (y % 8) + 4 * (x % 8);
}

class System {
 public:
  System() {
    Verilated::threadContextp(&context_);
    context_.randReset(2);
    context_.assertOn(false);  // before the reset everything is noise
    dut_.aresetn = 1;
    clock();
    dut_.aresetn = 0;
    for (int i = 0; i < 4; ++i) clock();
    dut_.aresetn = 1;
    context_.assertOn(true);
  }
  pipegs_bus bus() {
    return {[](void* system, uint32_t offset) { return static_cast<System*>(system)->access(false, offset, 0); },
            [](void* system, uint32_t offset, uint32_t value) {
              static_cast<System*>(system)->access(true, offset, value);
            },
            [](void* system) { static_cast<System*>(system)->wait(); }, this};
  }
  void finish_dma() {
    while (dma.busy()) cycle();
  }

  SocDma<Vsoc> dma;
  std::function<void()> at_cycle = [] {};

 private:
  uint32_t access(bool write, uint32_t offset, uint32_t value) {
    control_.begin(write, offset, value);
    while (control_.open()) cycle();
    return control_.value();
  }
  void wait() {
    do cycle();
    while (!dut_.irq);
  }
  void clock() {
    dut_.aclk = 0;
    control_.drive(dut_);
    dma.drive(dut_);
    dut_.eval();
    look_();
    dut_.aclk = 1;
    dut_.eval();
  }
  void cycle() {
    look_ = [this] {
      rules_.check(soc_memory_manager(dut_), soc_memory_subordinate(dut_));
      control_.observe(dut_);
      dma.observe(dut_);
      at_cycle();
    };
    clock();
    if (++cycles_ > 3'000'000) throw std::runtime_error("the system hangs");
  }

  VerilatedContext context_;
  Vsoc dut_{&context_};
  ControlPins<Vsoc> control_;
  AxiRules rules_{128, 512, 128};
  std::function<void()> look_ = [] {};  // in a cycle of the system, while its signals stand
  uint64_t cycles_ = 0;
};

class Soc : public testing::Test {
 protected:
  Soc() {
    options_.config = test_config();
    simulate_golden(random_scene(5, 1200, 1), camera_, options_, simulation_);
    scene_ = driver_scene(simulation_.packed);
    lens_ = driver_camera(camera_, options_.near_plane);
    EXPECT_EQ(pipegs_identify(&device_, &bus_), PIPEGS_OK);
    memory_ = pipegs_place(&device_.config, &scene_, &lens_, kImage);
    memory_.overflow_size = kOverflowSize;
    EXPECT_LE(memory_.overflow + memory_.overflow_size, kMemory);
    EXPECT_EQ(pipegs_setup_job(&device_.config, &scene_, &lens_, nullptr, &memory_, &job_), PIPEGS_SETUP_OK);
    pipegs_enable(&device_, PIPEGS_IRQ_ENABLE_FRAME_DONE | PIPEGS_IRQ_ENABLE_QUEUE_FREE | PIPEGS_IRQ_ENABLE_ERROR);
    want_.assign(pipegs_pixels_size(&device_.config, &lens_) / 4, {});
    for (int y = 0; y < camera_.height; ++y) {
      for (int x = 0; x < camera_.width; ++x) {
        const uint64_t pixel = simulation_.golden.pixels[static_cast<size_t>(y * camera_.width + x)];
        want_[pixel_offset(static_cast<uint64_t>(camera_.width), static_cast<uint64_t>(x), static_cast<uint64_t>(y)) /
              4] = static_cast<uint32_t>(pixel);
      }
    }
  }

  // The DMA brings words to memory, a line of 64 bytes in a burst.
  void load(uint64_t address, const uint32_t* words, size_t count) {
    std::vector<SocBeat> beats;
    for (size_t i = 0; i < count; i += 4) {
      beats.push_back({words[i], words[i + 1], words[i + 2], words[i + 3]});
      if (beats.size() < 4) continue;
      system_.dma.write(address, std::exchange(beats, {}));
      address += 64;
    }
    system_.finish_dma();
  }
  void load_all() {
    const MemoryImage image = memory_image(simulation_.packed);
    load(kImage, image.lines.front().data(), image.lines.size() * 16);
    const std::vector<uint32_t> before(want_.size(), kBefore);
    load(memory_.pixels, before.data(), before.size());
  }
  // Reads the pixels of the first windows, a line in a burst; false while the DMA has not all of the last time.
  bool look(uint64_t windows) {
    if (system_.dma.busy()) return false;
    for (uint64_t at = 0; at < 65536 * windows; at += 64) system_.dma.read(memory_.pixels + at, 4);
    return true;
  }
  pipegs_result render() {
    uint32_t ticket = 0;
    const pipegs_result result = pipegs_queue(&device_, &job_, PIPEGS_NO_LIMIT, &ticket);
    return result != PIPEGS_OK ? result : pipegs_wait(&device_, ticket, PIPEGS_NO_LIMIT);
  }

  Camera camera_ = test_camera(200, 136);
  SimulateOptions options_;
  Simulation simulation_;
  pipegs_scene scene_;
  pipegs_camera lens_;
  System system_;
  pipegs_bus bus_ = system_.bus();
  pipegs_device device_{};
  pipegs_memory memory_;
  pipegs_job job_{};
  std::vector<std::optional<uint32_t>> want_;  // by word behind tables.pixels, of the pixels of the picture
};

TEST_F(Soc, APictureIsReadWhileItIsRendered) {
  load_all();
  size_t early = 0, final = 0, wrong = 0;
  system_.dma.got = [&](uint64_t address, const SocBeat& beat) {
    for (size_t i = 0; i < 4; ++i) {
      const std::optional<uint32_t> want = want_[(address - memory_.pixels) / 4 + i];
      if (want && beat[i] == *want) ++final;
      else if (want && beat[i] == kBefore) ++early;
      else if (want) ++wrong;
    }
  };
  system_.at_cycle = [this] { look(1); };
  ASSERT_EQ(render(), PIPEGS_OK);
  system_.at_cycle = [] {};
  system_.finish_dma();
  EXPECT_EQ(wrong, 0u);
  EXPECT_GT(early, 10'000u);
  EXPECT_GT(final, 10'000u);

  early = final = 0;
  ASSERT_TRUE(look(4));
  system_.finish_dma();
  EXPECT_EQ(final, 200u * 136);
  EXPECT_EQ(early + wrong, 0u);
  pipegs_counters counters;
  pipegs_get_counters(&device_, &counters);
  EXPECT_GT(counters.overflow_lines, 100u) << "nothing went to the overflow area";
}

// Addresses behind the memory: DECERR comes through crossbar and adapter to the driver. The next frame is right, here
// in raster order, whose halves of lines are written each on its own.
TEST_F(Soc, AnErrorOfTheMemoryComesToTheDriver) {
  load_all();
  const auto fails = [this](uint64_t& table, uint32_t cause) {
    const uint64_t right = std::exchange(table, kMemory);
    ASSERT_EQ(render(), PIPEGS_FAILED);
    const pipegs_error error = pipegs_get_error(&device_);
    EXPECT_EQ(error.causes, cause);
    pipegs_abort(&device_, PIPEGS_NO_LIMIT);
    pipegs_clear_error(&device_, error.causes);
    table = right;
  };
  fails(job_.frame.tables_pixels, PIPEGS_ERROR_WRITE_DECERR);
  fails(job_.frame.tables_colors, PIPEGS_ERROR_READ_DECERR);

  job_.picture = {.format = 1, .base = memory_.pixels, .stride = 832};
  job_.areas.picture = 832 * 136;
  ASSERT_EQ(render(), PIPEGS_OK);
  size_t wrong = 0;
  system_.dma.got = [&](uint64_t address, const SocBeat& beat) {
    for (size_t i = 0; i < 4; ++i) {
      const uint64_t word = (address - memory_.pixels) / 4 + i, x = word % 208, y = word / 208;
      if (x >= 200 || y >= 136) continue;
      wrong += beat[i] != ru_rgba8(options_.config, simulation_.golden.pixels[y * 200 + x]);
    }
  };
  ASSERT_TRUE(look(4));
  system_.finish_dma();
  EXPECT_EQ(wrong, 0u);
}

// What docs/integration.md says in numbers.
TEST_F(Soc, ThePageIsRight) {
  EXPECT_EQ(pixel_offset(800, 300, 200), 625'936u);
  for (const uint32_t units : {1u, 2u, 4u}) {
    device_.config.units = units;
    EXPECT_EQ(pipegs_overflow_size(&device_.config, 10'000, 6), 128u * units * device_.config.parts * 10'000);
    EXPECT_EQ(pipegs_overflow_size(&device_.config, 10'000'000, 6), uint64_t{1} << 30);
  }
}

}  // namespace
}  // namespace pipegs
