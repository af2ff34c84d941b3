// SPDX-License-Identifier: Apache-2.0
// sequence_check.cpp: see sequence_check.hpp.
#include "sim/compare/sequence_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cpp_model/ru/ru_resolve.hpp"

namespace pipegs {

SequenceCheck::SequenceCheck(const std::vector<Expected>& frames, const ExternalMemory& memory, RtlTaps* second)
    : memory_(memory), second_(second) {
  for (const Expected& one : frames) frames_.push_back({one, std::make_unique<StreamCheck>(*one.input)});
  splat_frame_.resize(static_cast<size_t>(frames.front().input->packed->config.units));
}

StreamCheck& SequenceCheck::at(size_t number) { return *frames_[std::min(number, frames_.size() - 1)].streams; }

void SequenceCheck::on_splat(int unit, const uint32_t* splat) {
  size_t& number = splat_frame_[static_cast<size_t>(unit)];
  at(number).on_splat(unit, splat);
  if (at(number).splats_over(unit)) ++number;
  if (second_ != nullptr) second_->on_splat(unit, splat);
}

void SequenceCheck::on_sorted(const uint32_t* sorted) {
  at(sorted_frame_).on_sorted(sorted);
  if (at(sorted_frame_).sorted_over()) ++sorted_frame_;
  if (second_ != nullptr) second_->on_sorted(sorted);
}

void SequenceCheck::on_alphas(int lane, uint64_t window_x, uint64_t window_y, uint32_t index, int region, int quarter,
                              const uint32_t* line) {
  at(back_).on_alphas(lane, window_x, window_y, index, region, quarter, line);
  if (second_ != nullptr) second_->on_alphas(lane, window_x, window_y, index, region, quarter, line);
}

void SequenceCheck::on_pixels(int lane, int region, int quarter, const uint32_t* word) {
  at(back_).on_pixels(lane, region, quarter, word);
  if (second_ != nullptr) second_->on_pixels(lane, region, quarter, word);
}

void SequenceCheck::on_frame_done() {
  if (back_ < frames_.size()) {
    One& one = frames_[back_];
    if (one.expected.input->packed->config.taps) one.streams->finish();
    compare_pixels(one);
  }
  ++back_;
  if (second_ != nullptr) second_->on_frame_done();
}

void SequenceCheck::on_give_up() {
  for (size_t i = back_; i < frames_.size(); ++i)
    frames_[i].streams = std::make_unique<StreamCheck>(*frames_[i].expected.input);
  std::fill(splat_frame_.begin(), splat_frame_.end(), back_);
  sorted_frame_ = back_;
  if (second_ != nullptr) second_->on_give_up();
}

// The frame in external memory against the golden pixels.
void SequenceCheck::compare_pixels(One& one) {
  const Config& config = one.expected.input->packed->config;
  const Frame& frame = one.expected.input->frame;
  const Windows& windows = frame.raster.windows;
  const uint64_t side = static_cast<uint64_t>(config.window);
  for (uint64_t y = windows.first_y * side; y < std::min(frame.raster.height, (windows.last_y + 1) * side); ++y) {
    for (uint64_t x = windows.first_x * side; x < std::min(frame.raster.width, (windows.last_x + 1) * side); ++x) {
      const int region = region_at(config, static_cast<int>(x % side / 8), static_cast<int>(y % side / 8));
      const MemoryLine& line =
          memory_.line(ru_pixel_line(config, frame, x / side, y / side, region, static_cast<int>(y % 8)));
      const uint64_t found =
          get_bits(line.data(), ru_pixel_bit(config, static_cast<int>(y % 8), static_cast<int>(x % 8)), config.pixel_w);
      const uint64_t expected = (*one.expected.pixels)[y * frame.raster.width + x];
      if (found == expected) continue;
      one.streams->fail_pixel(
          x / side, y / side,
          fmt::format("frame: pixel {},{}: expected {:016x}, found {:016x}", x, y, expected, found));
    }
  }
}

}  // namespace pipegs
