// SPDX-License-Identifier: Apache-2.0
// stream_check.cpp: see stream_check.hpp.
#include "sim/compare/stream_check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <tuple>

#include "cpp_model/dopu/dopu_origin.hpp"
#include "cpp_model/pu/conic/pu_coeff.hpp"
#include "cpp_model/pu/conic/pu_intersect.hpp"
#include "cpp_model/eyes.hpp"
#include "cpp_model/pu/front/pu_cull.hpp"
#include "cpp_model/pu/front/pu_reach.hpp"
#include "cpp_model/pu/pu_parts.hpp"
#include "cpp_model/ru/ru_walk.hpp"

namespace pipegs {
namespace {

// Compares two records; says which field differs.
template <class R>
bool differ(const Config& config, const R& expected, const R& found, Mismatch& where) {
  const std::string text = first_difference(config, expected, found);  // "depth: expected 5, found 4"
  if (text.empty()) return false;
  constexpr std::string_view kExpected = ": expected ", kFound = ", found ";
  const size_t first = text.find(kExpected), second = text.find(kFound), begin = first + kExpected.size();
  where.field = text.substr(0, first);
  where.expected = text.substr(begin, second - begin);
  where.found = text.substr(second + kFound.size());
  return true;
}

// The same of two splats, leaving out where the alphas lie, which depends on timing.
bool differ(const Config& config, Splat expected, Splat found, Mismatch& where) {
  expected.address = found.address = 0;
  expected.ext = found.ext = 0;
  expected.mask = found.mask = 0;
  return differ<Splat>(config, expected, found, where);
}

// The same of two states of a pixel.
bool differ(const PixelState& expected, const PixelState& found, Mismatch& where) {
  const std::tuple<const char*, uint32_t, uint32_t> parts[] = {{"T", expected.t, found.t},
                                                               {"red", expected.rgb[0], found.rgb[0]},
                                                               {"green", expected.rgb[1], found.rgb[1]},
                                                               {"blue", expected.rgb[2], found.rgb[2]},
                                                               {"done", expected.done, found.done}};
  for (const auto& [name, wanted, shown] : parts) {
    if (wanted == shown) continue;
    where.field = name, where.expected = fmt::to_string(wanted), where.found = fmt::to_string(shown);
    return true;
  }
  return false;
}

std::string text_of(const Mismatch& one) {
  std::vector<std::string> parts;
  if (one.gaussian) parts.push_back(fmt::format("Gaussian {}", *one.gaussian));
  if (one.layer) parts.push_back(fmt::format("layer {}", *one.layer));
  if (one.region) parts.push_back(fmt::format("region {}", *one.region));
  if (one.pixel) parts.push_back(fmt::format("pixel {},{}", (*one.pixel)[0], (*one.pixel)[1]));
  if (!one.field.empty()) parts.push_back("field " + one.field);
  return fmt::format("{}: {}{}expected {}{}", one.stream(), fmt::join(parts, ", "), parts.empty() ? "" : ": ",
                     one.expected, one.found.empty() ? "" : ", found " + one.found);
}

// A Gaussian in a part of a window.
uint64_t name_of(uint64_t index, uint64_t part) { return index * kParts + part; }

}  // namespace

std::string Mismatch::stream() const {
  const std::string number = unit ? fmt::format(" {}", *unit) : "";
  switch (tap) {
    case Tap::kChunk: return "DOPU -> PU" + number;
    case Tap::kSplat: return fmt::format("PU{} -> SU", number);
    case Tap::kSorted: return "merge -> RU";
    case Tap::kAlphas: return "alphas -> RU" + number;
    case Tap::kPixels: return "RU" + number;
    case Tap::kMemory: return "frame";
    case Tap::kState: return "state of " + who;
    case Tap::kRequest: return "memory port " + who;
    case Tap::kTime: return "time";
  }
  return "";
}

std::string Mismatch::signal() const {
  switch (tap) {
    case Tap::kChunk: return "tap_chunk_o";
    case Tap::kSplat: return "tap_splat_o";
    case Tap::kSorted: return "tap_sorted_o";
    case Tap::kAlphas: return "tap_alphas_o";
    case Tap::kPixels: return "tap_pixels_o";
    case Tap::kState: return "tap_state_o";
    case Tap::kRequest: return "mem_request_o";
    case Tap::kMemory:
    case Tap::kTime: return "";
  }
  return "";
}

std::string Mismatch::line() const {
  return fmt::format("cycle {}, window {},{}: {}", cycle, window_x, window_y, what);
}

StreamCheck::StreamCheck(const GoldenInput& input)
    : input_(input),
      config_(input.packed->config),
      constants_(config_, input.frame.raster.rest),
      rows_(config_),
      windows_x_(input.frame.raster.windows.last_x - input.frame.raster.windows.first_x + 1),
      chunk_window_(config_.units, 0),
      splat_place_(config_.units),
      ru_window_(config_.units * config_.tap_lanes(), 0),
      pending_(config_.units * config_.tap_lanes()),
      marks_(config_.units, 0) {}

StreamCheck::Window& StreamCheck::window(uint64_t ordinal) {
  const auto found = open_.find(ordinal);
  if (found != open_.end()) return found->second;
  Window& window = open_[ordinal];
  const uint64_t x = input_.frame.raster.windows.first_x + ordinal % windows_x_,
                 y = input_.frame.raster.windows.first_y + ordinal / windows_x_;
  window.golden = golden_window(input_, x, y);
  if (!config_.has_lists()) window.chunks.emplace(input_, x, y, window.golden.walks);
  for (const GoldenLayer& layer : window.golden.layers) {
    auto& by_name = window.by_name.emplace_back();
    for (const GoldenSplat& splat : layer.splats) by_name.emplace(name_of(splat.splat.index, splat.splat.part), &splat);
  }
  for (int r = 0; r < config_.regions(); ++r) {
    window.done.add(config_, r, window.golden.regions[r].all_done());
    window.live.push_back(ru_fresh_region(config_, input_.frame, x, y, r));
    if (config_.has_aovs()) window.live_aovs.push_back(ru_fresh_region_aovs(config_));
  }
  window.lines.resize(window.live.size());
  window.next.resize(window.live.size());
  window.shown.resize(window.live.size());
  for (const GoldenLayer& layer : window.golden.layers) {
    for (const GoldenSplat& golden : layer.splats) {
      for (uint64_t rest = golden.splat.mask; rest != 0; rest &= rest - 1) {
        const int region = static_cast<int>(golden.splat.part) * config_.mask_w() + std::countr_zero(rest);
        const uint32_t quads = config_.quads ? ru_live_quads(codes_of(golden, region).data(), 0) : 1;
        window.lines[region].push_back({&golden, quads});
      }
    }
  }
  return window;
}

std::array<uint16_t, kRegionPixels> StreamCheck::codes_of(const GoldenSplat& splat, int region) const {
  std::array<uint16_t, kRegionPixels> codes;
  pu_region_line(rows_, splat.job, region_bit(config_, region), codes.data());
  return codes;
}

// Whether a line would change a pixel of the quad, or with whole regions may not be left out.
bool StreamCheck::changes(const Window& window, int region, int quad, const Line& line) const {
  const RegionState& state = window.live[region];
  const bool stopped = config_.quads ? (ru_stopped_quads(state) >> quad & 1) != 0 : state.all_done();
  return (line.quads >> quad & 1) != 0 && !stopped;
}

// Lines up to `end` that no RU has shown in a region, or in a quad of it: each that would change a pixel is missing.
void StreamCheck::skip_to(uint64_t ordinal, size_t region, size_t quad, size_t end, const std::string& seen) {
  Window& now = window(ordinal);
  for (size_t& next = now.next[region][quad]; next < end; ++next) {
    const Line& line = now.lines[region][next];
    if (changes(now, static_cast<int>(region), static_cast<int>(quad), line))
      fail(ordinal, {.tap = Tap::kAlphas, .gaussian = line.splat->splat.index, .region = static_cast<int>(region)},
           "its line " + seen, "it missing");
  }
}

// An RU shows the line of a splat in a region, or in a quad of it: all that it has left out since the line before it
// changes nothing there, and it has not been shown before.
void StreamCheck::expect_line(uint64_t ordinal, int lane, size_t region, size_t quad, const GoldenSplat& shown) {
  Window& now = window(ordinal);
  const std::vector<Line>& lines = now.lines[region];
  size_t& next = now.next[region][quad];
  const auto found = std::find_if(lines.begin() + static_cast<std::ptrdiff_t>(next), lines.end(),
                                  [&](const Line& line) { return line.splat == &shown; });
  if (found == lines.end()) {
    return fail(
        ordinal,
        {.tap = Tap::kAlphas, .unit = unit_of(lane), .gaussian = shown.splat.index, .region = static_cast<int>(region)},
        "once, in the sorted order");
  }
  skip_to(ordinal, region, quad, static_cast<size_t>(found - lines.begin()),
          fmt::format("before Gaussian {}", shown.splat.index));
  ++next;
  size_t& last = now.shown[region];
  last = std::max(last, next);
}

// A chunk that has not come, though the PUs had use for it.
void StreamCheck::expect_chunks(uint64_t ordinal, const ChunkSet& chunks,
                                const std::function<bool(const Chunk& chunk)>& needed) {
  if (const std::optional<uint64_t> slot = chunks.missing(needed))
    fail(ordinal, {.tap = Tap::kChunk, .gaussian = input_.packed->gaussians[*slot].index}, "its chunk", "it missing");
}

// With Occlusion: whether each region of a Gaussian was done when its line there was due, so that it may be missing
// from the walk: done in the golden window too, and nothing behind that line has been blended.
bool StreamCheck::closed_before(const Window& window, uint64_t index, uint64_t walk) const {
  for (const auto& by_name : window.by_name) {
    for (uint64_t part = 0; part < static_cast<uint64_t>(config_.parts()); ++part) {
      const auto found = by_name.find(name_of(index, part));
      if (found == by_name.end() || !walk_has(config_, walk, part)) continue;
      if ((found->second->splat.mask & ~window.done.mask[part]) != 0) return false;
      for (uint64_t rest = found->second->splat.mask; rest != 0; rest &= rest - 1) {
        const auto region = static_cast<size_t>(region_number(config_, part, std::countr_zero(rest)));
        const std::vector<Line>& lines = window.lines[region];
        // With Occlusion all are of one layer, whose splats lie in their order.
        const auto line = std::lower_bound(lines.begin(), lines.end(), found->second,
                                           [](const Line& one, const GoldenSplat* splat) { return one.splat < splat; });
        if (static_cast<size_t>(line - lines.begin()) < window.shown[region]) return false;
      }
    }
  }
  return true;
}

// Whether the Gaussian in this slot of a chunk has a region in the chunk's walk.
bool StreamCheck::has_region(const Chunk& chunk, uint64_t slot) const {
  const Frame& frame = input_.frame;
  const Fetched fetched = golden_fetched(chunk, input_.packed->gaussians[slot], slot);
  for (const int eye : walk_eyes(config_, frame, chunk.walk)) {
    Gap gap;
    const std::optional<Visible> visible = pu_cull(config_, frame, fetched, nullptr, &gap, {}, nullptr, eye);
    if (!visible) continue;
    if (config_.tight_cull && !pu_reach(config_, frame, *visible, gap)) continue;
    for (const PuPart& one :
         pu_parts(config_, golden_conic(config_, frame, *visible).conic, chunk.walk, visible->eye)) {
      if (pu_intersect(config_, frame, pu_coeff(config_, frame, one.conic)).mask != 0) return true;
    }
  }
  return false;
}

// With Occlusion: a chunk of the scene that the planes of a whole walk of the window do not let pass. None of its
// Gaussians has a region there; the cull, which knows spheres and one axis of ellipses, may keep some.
const Chunk* StreamCheck::beside(uint64_t ordinal, ChunkSet& chunks, const Chunk& found) {
  if (!config_.occlusion) return nullptr;
  const std::vector<uint64_t>& walks = window(ordinal).golden.walks;
  if (std::find(walks.begin(), walks.end(), found.walk) == walks.end()) return nullptr;
  const std::vector<Node>& nodes = input_.packed->chunks;
  const auto node = std::find_if(nodes.begin(), nodes.end(), [&](const Node& one) { return one.first == found.slot; });
  if (node == nodes.end()) return nullptr;
  const auto& windows = input_.frame.raster.windows;
  Chunk chunk = dopu_origin(config_, input_.frame, *node, static_cast<int>(windows.first_x + ordinal % windows_x_),
                            static_cast<int>(windows.first_y + ordinal / windows_x_));
  chunk.walk = found.walk;
  for (uint64_t slot = chunk.slot; slot < chunk.slot + chunk.count; ++slot) {
    if (has_region(chunk, slot)) return nullptr;
  }
  chunks.add(chunk);
  return chunks.find(found);
}

// A window that every stream has left: no line is missing, and what was blended is the golden window. Where something
// that a walk covers was open to the end all of its chunks have come.
void StreamCheck::expect_all(uint64_t ordinal) {
  const Window& now = window(ordinal);
  const auto open = [&](const Chunk& chunk) {
    bool some = false;
    for (int r = 0; r < config_.regions(); ++r) {
      some = some || (walk_has(config_, chunk.walk, static_cast<uint64_t>(region_part(config_, r))) &&
                      !now.done.has(config_, r));
    }
    if (!some || !config_.occlusion) return some;
    for (uint64_t k = 0; k < chunk.count; ++k) {
      if (!closed_before(now, input_.packed->gaussians[chunk.slot + k].index, chunk.walk)) return true;
    }
    return false;
  };
  if (now.chunks) expect_chunks(ordinal, *now.chunks, open);
  for (size_t region = 0; region < now.live.size(); ++region) {
    for (size_t quad = 0; quad < (config_.quads ? kQuads : 1); ++quad)
      skip_to(ordinal, region, quad, now.lines[region].size(), "at the window's end");
    const RegionState &blended = now.live[region], &golden = now.golden.regions[region];
    for (int i = 0; i < kRegionPixels; ++i) {
      const int number = static_cast<int>(region);
      Mismatch where{.tap = Tap::kPixels, .region = number, .pixel = pixel_at(ordinal, number, i)};
      if (!differ(golden.pixel(i), blended.pixel(i), where)) continue;
      where.found += " at the window's end";
      fail(ordinal, where);
      break;
    }
  }
}

// Drops windows that every stream has left.
void StreamCheck::release() {
  uint64_t oldest = sorted_place_.window;
  for (const Place& place : splat_place_) oldest = std::min(oldest, place.window);
  for (const uint64_t window : ru_window_) oldest = std::min(oldest, window);
  for (auto window = open_.begin(); window != open_.end();) {
    if (window->first + 2 >= oldest) {
      ++window;
      continue;
    }
    expect_all(window->first);
    window = open_.erase(window);
  }
}

void StreamCheck::fail(uint64_t window, Mismatch mismatch, std::string expected, std::string found) {
  mismatch.expected = std::move(expected), mismatch.found = std::move(found);
  fail(window, std::move(mismatch));
}

void StreamCheck::fail(uint64_t window, Mismatch mismatch) {
  ++mismatches_;
  if (first_) return;
  mismatch.window_x = input_.frame.raster.windows.first_x + window % windows_x_;
  mismatch.window_y = input_.frame.raster.windows.first_y + window / windows_x_;
  mismatch.cycle = cycle;
  if (mismatch.gaussian) mismatch.gaussian = input_.packed->scene_index(*mismatch.gaussian);
  mismatch.what = text_of(mismatch);
  first_ = std::move(mismatch);
}

void StreamCheck::fail_pixel(int x, int y, const std::string& expected, const std::string& found) {
  const auto column = static_cast<uint64_t>(x / config_.window), row = static_cast<uint64_t>(y / config_.window);
  const auto& windows = input_.frame.raster.windows;
  fail((row - windows.first_y) * windows_x_ + column - windows.first_x,
       {.tap = Tap::kMemory,
        .region = region_at(config_, x % config_.window / 8, y % config_.window / 8),
        .pixel = {{x, y}}},
       expected, found);
}

std::array<int, 2> StreamCheck::pixel_at(uint64_t window, int region, int pixel) const {
  const auto& windows = input_.frame.raster.windows;
  return {static_cast<int>(windows.first_x + window % windows_x_) * config_.window + 8 * region_x(config_, region) +
              pixel % 8,
          static_cast<int>(windows.first_y + window / windows_x_) * config_.window + 8 * region_y(config_, region) +
              pixel / 8};
}

void StreamCheck::end(Place& place, uint64_t kind) {
  if (kind == kPartEnd) return static_cast<void>(++place.walk);
  place.next = place.walk = 0;
  ++place.layer;
  if (kind != kWindowEnd) return;
  place.layer = 0;
  ++place.window;
  release();
}

// A layer's end follows a layer with chunks. The window may end early when all that is left lies in regions that are
// done, and late, with a layer that turned out to be empty: the DOPU learns that only after the end of the layer before
// it.
void StreamCheck::expect_end(const Place& place, uint64_t kind, Mismatch where) {
  where.layer = place.layer;
  const Window& now = window(place.window);
  if (kind == kLayerEnd) {
    if (place.layer >= now.golden.layers.size()) {
      fail(place.window, where, fmt::format("the end of the window, which has {} layers", now.golden.layers.size()),
           "the end of a layer");
    }
    return;
  }
  for (size_t layer = place.layer + 1; layer < now.golden.layers.size(); ++layer) {
    for (const GoldenSplat& splat : now.golden.layers[layer].splats) {
      if ((splat.splat.mask & ~may_miss(now, splat.splat)) == 0) continue;
      where.gaussian = splat.splat.index;
      return fail(place.window, where, fmt::format("it in layer {}", layer), "it missing, the end of the window");
    }
  }
}

// Every walk of a window ends, the last one with the window.
void StreamCheck::expect_walk(const Place& place, uint64_t kind, const Mismatch& where) {
  const size_t walks = walks_of(window(place.window));
  if (kind == kLayerEnd || (kind == kWindowEnd) == (place.walk + 1 == walks)) return;
  fail(place.window, where, fmt::format("the end of walk {} of {}", place.walk + 1, walks),
       kind == kPartEnd ? "the end of a part" : "the end of the window");
}

// The ends of layers depend on timing, or are those of the splats.
void StreamCheck::on_chunk(int unit, int kind, const uint32_t* words) {
  uint64_t& ordinal = chunk_window_[static_cast<size_t>(unit)];
  if (kind != kData) {
    ordinal += kind == kWindowEnd;
    return;
  }
  ++beats_;
  const auto chunk = unpack<Chunk>(config_, words);
  if (config_.has_lists() && !listed_)
    listed_.emplace(input_, input_.frame.raster.windows.first_x, input_.frame.raster.windows.first_y);
  ChunkSet& chunks = config_.has_lists() ? *listed_ : *window(ordinal).chunks;
  Mismatch where{.tap = Tap::kChunk, .unit = unit};
  const Chunk* expected = chunks.find(chunk);
  if (expected == nullptr) expected = beside(ordinal, chunks, chunk);
  if (expected == nullptr) return fail(ordinal, where, "none", to_text(config_, chunk));
  where.gaussian = input_.packed->gaussians[chunk.slot].index;
  if (!chunks.take(chunk)) return fail(ordinal, where, "its chunk once", "it again");
  if (differ(config_, *expected, chunk, where)) fail(ordinal, where);
}

void StreamCheck::on_splat(int unit, const uint32_t* words) {
  ++beats_;
  const auto splat = unpack<Splat>(config_, words);
  Place& place = splat_place_[unit];
  Window& now = window(place.window);
  Mismatch where{.tap = Tap::kSplat, .unit = unit};
  if (splat.kind == kLayerEnd && config_.has_watermarks()) return on_mark(unit, place, splat);
  if (splat.kind != kData) {
    if (config_.has_watermarks()) marks_[static_cast<size_t>(unit)] = 0;
    expect_walk(place, splat.kind, where);
    if (splat.kind != kPartEnd) expect_end(place, splat.kind, where);
    return end(place, splat.kind);
  }
  where.gaussian = splat.index, where.layer = place.layer;
  if (place.layer >= now.by_name.size()) return fail(place.window, where, "the end of the window", "a splat");
  const auto found = now.by_name[place.layer].find(name_of(splat.index, splat.part));
  if (found == now.by_name[place.layer].end()) return fail(place.window, where, "none", to_text(config_, splat));
  const Splat& expected = found->second->splat;
  if (place.walk >= walks_of(now)) return fail(place.window, where, "the end of the window", "a splat");
  if (const uint64_t walk = now.golden.in_parts() ? now.golden.walks[place.walk] : kWholeWalk;
      !walk_has(config_, walk, splat.part)) {
    where.field = "part";
    return fail(place.window, where, fmt::format("one of walk {}", walk), fmt::to_string(splat.part));
  }
  const uint64_t mark = marks_[static_cast<size_t>(unit)];
  if (config_.has_watermarks() && splat.depth < mark) {
    where.field = "depth";
    return fail(place.window, where, fmt::format("{} at least, the watermark", mark), fmt::to_string(splat.depth));
  }
  if (differ(config_, expected, splat, where)) return fail(place.window, where);
  expect_mask(place, where, expected, splat.mask);
}

// The regions of a splat; those that are done may be left out.
void StreamCheck::expect_mask(const Place& place, const Mismatch& where, const Splat& expected, uint64_t found) {
  const uint64_t done = may_miss(window(place.window), expected);
  if ((found & ~expected.mask) == 0 && (expected.mask & ~found & ~done) == 0) return;
  Mismatch mask = where;
  mask.field = "mask";
  fail(place.window, mask, fmt::format("{:016x}, {:016x} of it done", expected.mask, expected.mask & done),
       fmt::format("{:016x}", found));
}

// A watermark: it may only rise, and no later splat of the walk lies below it.
void StreamCheck::on_mark(int unit, const Place& place, const Splat& mark) {
  uint64_t& last = marks_[static_cast<size_t>(unit)];
  if (mark.depth < last) {
    fail(place.window, {.tap = Tap::kSplat, .unit = unit, .field = "watermark"}, fmt::format("{} at least", last),
         fmt::to_string(mark.depth));
  }
  last = mark.depth;
}

void StreamCheck::on_sorted(const uint32_t* words) {
  ++beats_;
  const auto sorted = unpack<Sorted>(config_, words);
  Mismatch where{.tap = Tap::kSorted, .unit = {}};
  Place& place = sorted_place_;
  Window& now = window(place.window);
  static const std::vector<GoldenSplat> kNone;
  const std::vector<GoldenSplat>& splats =
      place.layer < now.golden.layers.size() ? now.golden.layers[place.layer].splats : kNone;
  // Golden splats that the RTL left out lie only in regions that are done.
  const auto skip_done = [&](auto stop) {
    while (place.next < splats.size() && !stop(splats[place.next])) {
      const GoldenSplat& left_out = splats[place.next++];
      if ((left_out.splat.mask & ~may_miss(now, left_out.splat)) != 0) {
        Mismatch missing{.tap = Tap::kSorted, .gaussian = left_out.splat.index, .layer = place.layer};
        const std::string other = sorted.kind == kData ? fmt::format("Gaussian {}", sorted.index) : "the layer's end";
        return fail(place.window, missing, "it", "it missing before " + other);
      }
    }
  };
  if (sorted.kind == kPartEnd) return fail(place.window, where, "the end of the window alone", "the end of a part");
  if (sorted.kind != kData) {
    skip_done([](const GoldenSplat&) { return false; });
    expect_end(place, sorted.kind, where);
    return end(place, sorted.kind);
  }
  const auto same = [&](const GoldenSplat& golden) {
    return golden.splat.index == sorted.index && golden.splat.part == sorted.part;
  };
  skip_done(same);
  where.gaussian = sorted.index, where.layer = place.layer;
  if (place.next >= splats.size() || !same(splats[place.next]))
    return fail(place.window, where, "it in the order of depths", "it out of order");
  const auto found = unpack<Splat>(config_, words);  // a sorted splat begins with the splat
  if (differ(config_, splats[place.next].splat, found, where)) fail(place.window, where);
  expect_mask(place, where, splats[place.next].splat, found.mask);
  ++place.next;
}

void StreamCheck::on_alphas(int lane, uint64_t window_x, uint64_t window_y, uint32_t index, int region, int quarter,
                            const uint32_t* line) {
  ++beats_;
  const uint64_t ordinal =
      (window_y - input_.frame.raster.windows.first_y) * windows_x_ + (window_x - input_.frame.raster.windows.first_x);
  ru_window_[lane] = ordinal;
  Window& now = window(ordinal);
  const GoldenSplat* splat = nullptr;
  for (const auto& by_name : now.by_name) {
    const auto found = by_name.find(name_of(index, static_cast<uint64_t>(region_part(config_, region))));
    if (found != by_name.end()) splat = found->second;
  }
  Mismatch where{.tap = Tap::kAlphas, .unit = unit_of(lane), .gaussian = index, .region = region};
  if (splat == nullptr) return fail(ordinal, where, "a Gaussian of the window", "this one");
  Pending pending{.index = index,
                  .region = region,
                  .quarter = quarter,
                  .codes = {},
                  .after = {},
                  .aovs = {},
                  .window = ordinal,
                  .words = config_.quads ? 1 : 4};
  const int quad = config_.quads ? ru_quad(lane % config_.tap_lanes(), quarter) : 0;
  expect_line(ordinal, lane, static_cast<size_t>(region), static_cast<size_t>(quad), *splat);
  const std::array<uint16_t, kRegionPixels> codes = codes_of(*splat, region);
  bool same = true;
  for (int i = 0; i < (config_.quads ? kQuadPixels : kRegionPixels); ++i) {
    const int pixel = config_.quads ? ru_word_pixel(config_, lane % config_.tap_lanes(), quarter, i) : i;
    pending.codes[pixel] = codes[pixel];
    const uint64_t found = get_bits(line, i * config_.alpha_w, config_.alpha_w);
    if (found == codes[pixel] || !same) continue;
    same = false;
    where.pixel = pixel_at(ordinal, region, pixel), where.field = "alpha";
    fail(ordinal, where, fmt::to_string(codes[pixel]), fmt::to_string(found));
  }
  const uint32_t color[3] = {static_cast<uint32_t>(splat->splat.red), static_cast<uint32_t>(splat->splat.green),
                             static_cast<uint32_t>(splat->splat.blue)};
  const RegionState before = now.live[region];
  ru_blend_region(constants_, now.live[region], pending.codes.data(), color);
  pending.after = now.live[region];
  if (config_.has_aovs()) {
    ru_add_region_aovs(config_, constants_, now.live_aovs[region], before, pending.after, pending.codes.data(),
                       ru_linear(config_, splat->splat.depth, input_.frame.raster.aovs.range), index);
    pending.aovs = now.live_aovs[region];
  }
  pending_[lane].push_back(pending);
}

void StreamCheck::on_pixels(int lane, int region, int quarter, const uint32_t* word) {
  ++beats_;
  Mismatch where{.tap = Tap::kPixels, .unit = unit_of(lane), .region = region};
  if (pending_[lane].empty()) return fail(ru_window_[lane], where, "a line before its pixels", "no line");
  Pending& pending = pending_[lane].front();
  where.gaussian = pending.index;
  if (pending.region != region || (config_.quads && pending.quarter != quarter)) {
    where.field = "region";
    fail(pending.window, where, fmt::to_string(pending.region), fmt::to_string(region));
  } else {
    // The word: colours of its pixels, then their transmittances, then their done flags, then what they have for AOVs
    // (rtl/ru/ru_lanes.sv, rtl/ru/live/ru_live.sv).
    const int colors = 3 * config_.rgb_w, pixels = ru_word_pixels(config_);
    for (int i = 0; i < pixels; ++i) {
      const int pixel = ru_word_pixel(config_, lane % config_.tap_lanes(), quarter, i);
      const PixelState expected = pending.after.pixel(pixel);
      const auto field = [&](int at, int width) { return static_cast<uint32_t>(get_bits(word, at, width)); };
      const PixelState found{field(pixels * colors + i * config_.t_w, config_.t_w),
                             {field(i * colors, config_.rgb_w), field(i * colors + config_.rgb_w, config_.rgb_w),
                              field(i * colors + 2 * config_.rgb_w, config_.rgb_w)},
                             field(pixels * (colors + config_.t_w) + i, 1) != 0};
      where.pixel = pixel_at(pending.window, region, pixel);
      if (where.pixel == watched_) seen_.push_back({pending.index, pending.codes[pixel], found});
      bool wrong = found != expected && differ(expected, found, where);
      if (!wrong && config_.has_aovs()) {
        std::vector<uint32_t> words(static_cast<size_t>(record_words<PixelAovs>(config_) + 2));
        const int first = pixels * (colors + config_.t_w + 1) + i * config_.aov_bits();
        for (int bit = 0; bit < config_.aov_bits(); bit += 32) {
          const int width = std::min(32, config_.aov_bits() - bit);
          put_bits(words.data(), bit, width, get_bits(word, first + bit, width));
        }
        wrong =
            differ(config_, pending.aovs[static_cast<size_t>(pixel)], unpack<PixelAovs>(config_, words.data()), where);
      }
      if (!wrong) continue;
      fail(pending.window, where);
      break;
    }
  }
  if (--pending.words == 0) pending_[lane].pop_front();
}

void StreamCheck::finish() {
  const auto come = [&](uint64_t windows) { return fmt::format("{} windows", windows); };
  for (size_t unit = 0; unit < splat_place_.size(); ++unit) {
    const uint64_t shown = splat_place_[unit].window;
    if (!splats_over(static_cast<int>(unit)))
      fail(shown, {.tap = Tap::kSplat, .unit = static_cast<int>(unit)}, come(frame_windows(input_.frame)), come(shown));
  }
  for (size_t lane = 0; lane < pending_.size(); ++lane) {
    if (pending_[lane].empty()) continue;
    const Pending& line = pending_[lane].front();
    fail(line.window,
         {.tap = Tap::kPixels, .unit = unit_of(static_cast<int>(lane)), .gaussian = line.index, .region = line.region},
         "its line written back", "nothing");
  }
  if (!sorted_over())
    fail(sorted_place_.window, {.tap = Tap::kSorted}, come(frame_windows(input_.frame)), come(sorted_place_.window));
  for (const auto& [ordinal, window] : open_) expect_all(ordinal);
  if (listed_) expect_chunks(0, *listed_, [](const Chunk&) { return true; });
  open_.clear();
}

}  // namespace pipegs
