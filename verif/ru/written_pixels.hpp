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
  // Whether both halves of a line of the picture hold pixels.
  static bool wide(const Frame& frame, const Picture& picture, uint64_t line) {
    return (line - picture.base) % picture.stride * 16 + 8 < frame.raster.width;
  }

 private:
  std::map<std::pair<uint64_t, int>, MemoryLine> lines_;
};

}  // namespace pipegs
