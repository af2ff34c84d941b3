// SPDX-License-Identifier: Apache-2.0
// written_pixels.hpp: the lines and halves of lines of finished windows that a module under test has yet to write.
#pragma once

#include <map>

#include "cpp_model/ru/ru.hpp"
#include "verif/support/bench.hpp"

namespace pipegs {

// By windows, or in raster order with some stride.
inline Picture random_picture(const Config& config, const Frame& frame, std::mt19937_64& rng, bool raster) {
  Picture picture{.format = raster, .base = frame.tables.pixels, .stride = rng() % 4096};
  if (raster) {
    picture.stride = (frame.raster.width + 15) / 16;
    if (rng() % 2 != 0) picture.stride += rng() % 200;
  }
  EXPECT_LT(picture.stride, uint64_t{1} << config.stride_w());
  return picture;
}

// How far behind the pixels each AOV lies, which pipegs_raster finds out once for all RUs; which ones are wanted.
template <class Dut>
void write_aovs(const Config& config, Dut& dut, const Frame& frame, const Picture& picture) {
  std::vector<uint32_t> ahead(static_cast<size_t>(Config::aov_kinds() * config.address_w() / 32 + 2));
  uint32_t wanted = 0;
  for (const Aov aov : kAovs) {
    const int number = static_cast<int>(aov);
    if (!wants_aov(config, frame, aov)) continue;
    wanted |= 1u << number;
    put_bits(ahead.data(), number * config.address_w(), config.address_w(),
             aov_line(config, frame, aov) - (picture.format != 0 ? picture.base : frame.tables.pixels));
  }
  write_port(dut.ahead_i, ahead.data());
  if constexpr (requires { dut.wanted_aovs_i; }) dut.wanted_aovs_i = wanted;
}

// AOVs behind it, some of them wanted.
inline Aovs random_aovs(const Config& config, const Frame& frame, const Picture& picture, std::mt19937_64& rng) {
  if (!config.has_aovs()) return {};
  const uint64_t row = std::max<uint64_t>(picture.stride, 1),
                 lines = row * (frame.raster.height + 100000 + rng() % 100);
  return {.wanted = rng() % 16,
          .range = config.has_depths() ? rng() % 64 : 0,
          .base = picture.base + lines * (1 + rng() % 3),
          .lines = lines};
}

// Of two eyes one or both, unless the frame says which; the second one's picture lies behind all of the first one.
inline void random_eyes(const Config& config, const Picture& picture, std::mt19937_64& rng, Frame& frame) {
  if (config.eyes == 1) return;
  if (frame.raster.eyes == 0) frame.raster.eyes = 1 + rng() % 3;
  frame.raster.eye_lines = std::max<uint64_t>(picture.stride, 1) * (10 * frame.raster.height + 1000000 + rng() % 100);
}

class WrittenPixels {
 public:
  // What the model writes of a region, in the window of `state`.
  void expect(const Config& config, const Frame& frame, const Picture& picture, const RuState& state, int region) {
    ru_write(config, frame, picture, state, region, *this);
  }
  void operator()(uint64_t line, int halves, const MemoryLine& data) { lines_[{line, halves}] = data; }

  // A request of the module: one of those expected, and each once.
  template <class Port>
  void take(uint64_t line, int halves, const Port& data, uint64_t seed) {
    const auto expected = lines_.find({line, halves});
    ASSERT_NE(expected, lines_.end()) << "line " << line << ", halves " << halves << ", seed " << seed;
    Words found(18);
    read_port(data, found.data());
    for (size_t i = 0; i < 16; ++i) {
      if ((halves >> i / 8 & 1) == 0) continue;
      ASSERT_EQ(found[i], expected->second[i]) << "line " << line << ", word " << i << ", seed " << seed;
    }
    lines_.erase(expected);
  }
  bool empty() const { return lines_.empty(); }
  // Whether both halves of a line of the picture hold pixels; AOVs lie whole rows further.
  static bool wide(const Frame& frame, const Picture& picture, uint64_t line) {
    return (line - picture.base) % picture.stride * 16 + 8 < frame.raster.width;
  }

 private:
  std::map<std::pair<uint64_t, int>, MemoryLine> lines_;
};

}  // namespace pipegs
