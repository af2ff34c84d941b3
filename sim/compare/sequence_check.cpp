// SPDX-License-Identifier: Apache-2.0
// sequence_check.cpp: see sequence_check.hpp.
#include "sim/compare/sequence_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cpp_model/eyes.hpp"
#include "cpp_model/ru/ru_resolve.hpp"

namespace pipegs {
namespace {

constexpr size_t kInside = 3;  // frames at most: in front, behind it, and on its way to memory

}  // namespace

SequenceCheck::SequenceCheck(const std::vector<Expected>& frames, const ExternalMemory& memory, RtlTaps* second)
    : memory_(memory), second_(second), cycles_(second != nullptr && second->wants_cycles()) {
  for (const Expected& one : frames)
    frames_.push_back({one, std::make_unique<StreamCheck>(*one.input), {*one.input, one.areas}});
  chunk_frame_.resize(static_cast<size_t>(frames.front().input->packed->config.units));
  splat_frame_.resize(chunk_frame_.size());
  watch_states();
}

void SequenceCheck::watch_states() {
  const bool raster = std::any_of(frames_.begin(), frames_.end(),
                                  [](const One& one) { return one.expected.input->picture.format != 0; });
  const auto hear = [this](const StateCheck::Wrong& wrong) {
    const bool sums = wrong.cycle < 0;
    StreamCheck& streams = at(left_);
    if (!sums) streams.cycle = wrong.cycle;
    streams.fail_beside({.tap = Tap::kState,
                         .who = wrong.unit,
                         .field = sums ? "counters of busy, starved, blocked, memory" : "",
                         .expected = wrong.expected,
                         .found = wrong.found});
  };
  states_ = std::make_unique<StateCheck>(frames_.front().expected.input->packed->config, raster, hear);
}

StreamCheck& SequenceCheck::at(size_t number) {
  StreamCheck& streams = *frames_[std::min(number, frames_.size() - 1)].streams;
  streams.cycle = cycle;
  return streams;
}

std::optional<int64_t> SequenceCheck::first_cycle() const {
  std::optional<int64_t> first;
  for (const One& one : frames_) {
    const std::optional<Mismatch>& own = one.streams->first();
    if (own && (!first || own->cycle < *first)) first = own->cycle;
  }
  return first;
}

RtlTaps& SequenceCheck::states() {
  states_->cycle = cycle;
  return *states_;
}

RtlTaps& SequenceCheck::second() {
  second_->cycle = cycle;
  return *second_;
}

void SequenceCheck::on_splat(int unit, const uint32_t* splat) {
  size_t& number = splat_frame_[static_cast<size_t>(unit)];
  at(number).on_splat(unit, splat);
  if (at(number).splats_over(unit)) ++number;
  if (second_ != nullptr) second().on_splat(unit, splat);
}

void SequenceCheck::on_sorted(const uint32_t* sorted) {
  at(sorted_frame_).on_sorted(sorted);
  if (at(sorted_frame_).sorted_over()) ++sorted_frame_;
  if (second_ != nullptr) second().on_sorted(sorted);
}

void SequenceCheck::on_alphas(int lane, uint64_t window_x, uint64_t window_y, uint32_t index, int region, int quarter,
                              const uint32_t* line) {
  at(left_).on_alphas(lane, window_x, window_y, index, region, quarter, line);
  if (second_ != nullptr) second().on_alphas(lane, window_x, window_y, index, region, quarter, line);
}

void SequenceCheck::on_pixels(int lane, int region, int quarter, const uint32_t* word) {
  at(left_).on_pixels(lane, region, quarter, word);
  states().on_pixels(lane, region, quarter, word);
  if (second_ != nullptr) second().on_pixels(lane, region, quarter, word);
}

void SequenceCheck::on_frame_left() {
  ++left_;
  if (second_ != nullptr) second().on_frame_left();
}

void SequenceCheck::on_frame_done() {
  if (back_ < frames_.size()) {
    One& one = frames_[back_];
    one.streams->cycle = cycle;
    if (one.expected.input->packed->config.taps) one.streams->finish();
    compare_pixels(one);
    for (const MemoryTraffic& traffic : memory_traffic(one.expected.input->packed->config, memory_))
      one.moved = {one.moved.read + traffic.bytes_read, one.moved.written + traffic.bytes_written};
  }
  ++back_;
  if (second_ != nullptr) second().on_frame_done();
}

void SequenceCheck::on_give_up() {
  for (size_t i = back_; i < frames_.size(); ++i)
    frames_[i].streams = std::make_unique<StreamCheck>(*frames_[i].expected.input);
  std::fill(chunk_frame_.begin(), chunk_frame_.end(), back_);
  std::fill(splat_frame_.begin(), splat_frame_.end(), back_);
  sorted_frame_ = left_ = back_;
  watch_states();
  if (second_ != nullptr) second().on_give_up();
}

void SequenceCheck::on_cycle(uint64_t number, const uint8_t* states) {
  this->states().on_cycle(number, states);
  if (cycles_) second().on_cycle(number, states);
}

void SequenceCheck::on_border(const uint8_t* border) {
  states().on_border(border);
  if (cycles_) second().on_border(border);
}

void SequenceCheck::on_chunk(int unit, int kind, const uint32_t* chunk) {
  size_t& number = chunk_frame_[static_cast<size_t>(unit)];
  at(number).on_chunk(unit, kind, chunk);
  if (at(number).chunks_over(unit)) ++number;
  states().on_chunk(unit, kind, chunk);
  if (cycles_) second().on_chunk(unit, kind, chunk);
}

void SequenceCheck::on_line_free(int unit) {
  if (cycles_) second().on_line_free(unit);
}

void SequenceCheck::on_layer_done(int unit, bool window_done) {
  states().on_layer_done(unit, window_done);
  if (cycles_) second().on_layer_done(unit, window_done);
}

void SequenceCheck::on_request(int tag, bool write, uint64_t line, int lines) {
  states().on_request(tag, write, line, lines);
  compare_request(tag, write, line, lines);
  if (cycles_) second().on_request(tag, write, line, lines);
}

void SequenceCheck::finish(const RtlResult& counters) {
  if (frames_.front().expected.input->packed->config.taps) states_->finish(counters);
}

// Of the frames inside: the one that is being written, and those that the front has begun meanwhile.
void SequenceCheck::compare_request(int tag, bool write, uint64_t line, int lines) {
  const size_t first = std::min(back_, frames_.size() - 1), end = std::min(back_ + kInside, frames_.size());
  for (size_t i = first; i < end; ++i) {
    if (frames_[i].requests.allows(tag, write, line, lines)) return;
  }
  const Config& config = frames_[first].expected.input->packed->config;
  at(first).fail_beside({.tap = Tap::kRequest,
                         .who = fmt::format("{} ({})", tag, memory_streams(config)[memory_stream(config, tag)]),
                         .field = fmt::format("line that it {}", write ? "writes" : "reads"),
                         .expected = frames_[first].requests.allowed(tag, write),
                         .found = fmt::to_string(line) + (lines > 1 ? fmt::format(" and {} more", lines - 1) : "")});
}

uint64_t SequenceCheck::found(const One& one, uint64_t x, uint64_t y, uint64_t ahead) const {
  const GoldenInput& input = *one.expected.input;
  const Config& config = input.packed->config;
  if (input.picture.format != 0)
    return get_bits(memory_.line(ru_raster_line(input.picture, x, y) + ahead).data(), ru_raster_bit(x), 32);
  const uint64_t side = static_cast<uint64_t>(config.window);
  const int region = region_at(config, static_cast<int>(x % side / 8), static_cast<int>(y % side / 8)),
            row = static_cast<int>(y % 8);
  return get_bits(memory_.line(ru_pixel_line(config, input.frame, x / side, y / side, region, row) + ahead).data(),
                  ru_pixel_bit(config, row, static_cast<int>(x % 8)), config.pixel_w);
}

// What memory holds of a frame against the golden pictures of its eyes.
void SequenceCheck::compare_pixels(One& one) {
  const GoldenFrame& golden = *one.expected.golden;
  const Frame& frame = one.expected.input->frame;
  const Config& config = one.expected.input->packed->config;
  for (int eye = 0; eye < config.eyes; ++eye) {
    if (!wants_eye(config, frame, eye)) continue;
    const bool second = eye == 1 && golden.second;
    compare_picture(one, second ? *golden.second : golden, static_cast<uint64_t>(eye) * frame.raster.eye_lines,
                    second ? one.second : one.first);
  }
}

// One picture and its AOVs, so many lines behind where those of the first eye are.
void SequenceCheck::compare_picture(One& one, const GoldenPicture& golden, uint64_t behind, Written& written) {
  const GoldenInput& input = *one.expected.input;
  const Config& config = input.packed->config;
  const Frame& frame = input.frame;
  const Raster& raster = frame.raster;
  const bool in_raster = input.picture.format != 0;
  const uint64_t side = static_cast<uint64_t>(config.window),
                 base = in_raster ? input.picture.base : frame.tables.pixels;
  const uint64_t x0 = raster.windows.first_x * side, x1 = std::min(raster.width, (raster.windows.last_x + 1) * side),
                 y0 = raster.windows.first_y * side, y1 = std::min(raster.height, (raster.windows.last_y + 1) * side);
  const auto each = [&](const std::string& what, uint64_t ahead, auto&& expected, auto&& keep) {
    for (uint64_t y = y0; y < y1; ++y) {
      for (uint64_t x = x0; x < x1; ++x) {
        const uint64_t at = y * raster.width + x, shown = found(one, x, y, ahead), wanted = expected(at);
        keep(at, shown);
        if (shown == wanted) continue;
        one.streams->fail_pixel(static_cast<int>(x), static_cast<int>(y), what + fmt::format("{:016x}", wanted),
                                what + fmt::format("{:016x}", shown));
      }
    }
  };
  written.pixels.assign(golden.pixels.size(), 0);
  each(
      "", behind, [&](uint64_t at) { return in_raster ? ru_rgba8(config, golden.pixels[at]) : golden.pixels[at]; },
      [&](uint64_t at, uint64_t shown) { written.pixels[at] = shown; });
  for (size_t i = 0; i < kAovs.size(); ++i) {
    if (!wants_aov(config, frame, kAovs[i])) continue;
    written.aovs[i].assign(golden.pixels.size(), 0);
    each(
        std::string(kAovNames[i]) + " ", aov_line(config, frame, kAovs[i]) - base + behind,
        [&](uint64_t at) { return uint64_t{golden.aovs[i][at]}; },
        [&](uint64_t at, uint64_t shown) { written.aovs[i][at] = static_cast<uint32_t>(shown); });
  }
}

}  // namespace pipegs
