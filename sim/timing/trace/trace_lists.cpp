// SPDX-License-Identifier: Apache-2.0
// trace_lists.cpp: the trace of a frame with lists: one walk of the DOPU, then each Gaussian in the windows of its box.
#include <algorithm>

#include "cpp_model/dopu/dopu.hpp"
#include "cpp_model/float/parallel.hpp"
#include "cpp_model/pu/list/pu_expand.hpp"
#include "sim/timing/trace/trace_splat.hpp"

namespace pipegs {
namespace {

// What some chunks leave.
struct Part {
  std::vector<TimingChunk> chunks;
  std::vector<uint32_t> slot, pairs;  // by survivor; pairs: how many
  std::vector<TracePair> pair;
  std::vector<uint16_t> number;
  std::vector<uint8_t> passed;
  std::vector<uint16_t> quads;
  std::vector<uint32_t> quads_first;  // by pair
};

void walk(const GoldenInput& input, TimingWalk& walk, std::vector<Chunk>& chunks, std::vector<uint32_t>& numbers) {
  const PackedScene& packed = *input.packed;
  const Frame& frame = input.frame;
  const auto x = static_cast<int>(frame.raster.windows.first_x), y = static_cast<int>(frame.raster.windows.first_y);
  const Planes planes = dopu_planes(packed.config, frame, x, y);
  const auto pass = [&](const std::vector<Node>& nodes) {
    std::vector<uint64_t> bits((nodes.size() + 63) / 64);
    for (size_t i = 0; i < nodes.size(); ++i) {
      if (nodes[i].count != 0 && dopu_test(packed.config, frame, planes, nodes[i], 0))
        bits[i / 64] |= uint64_t{1} << (i % 64);
    }
    return bits;
  };
  walk.cells = pass(packed.cells);
  walk.groups = pass(packed.groups);
  dopu_window(packed.config, frame, packed, x, y, [&](int, const Chunk& chunk, uint64_t number) {
    chunks.push_back(chunk);
    numbers.push_back(static_cast<uint32_t>(number));
  });
  walk.chunks = chunks.size();
}

void gaussian(const GoldenInput& input, const PuRows& rows, const GoldenConic& found, Part& part) {
  const Config& config = input.packed->config;
  const auto& [conic, payload] = found;
  part.pairs.push_back(0);
  const std::optional<PuExpandBox> box = pu_expand_box(config, input.frame, conic);
  if (!box) return;
  for (int64_t y = box->first_y; y <= box->last_y; ++y) {
    for (int64_t x = box->first_x; x <= box->last_x; ++x) {
      const bool passed = !pu_expand_keeps(config, conic, *box, x, y);
      part.passed.push_back(passed);
      part.pair.push_back(passed ? TracePair{} : trace_pair(input, pu_expand(config, conic, x, y), payload, 0));
      part.number.push_back(static_cast<uint16_t>(pu_expand_number(input.frame, x, y)));
      trace_quads(rows, part.pair.back().splat, part.quads, part.quads_first);
      ++part.pairs.back();
    }
  }
}

}  // namespace

void trace_lists(const GoldenInput& input, unsigned threads, TimingTrace& trace) {
  const Frame& frame = input.frame;
  std::vector<Chunk> chunks;
  std::vector<uint32_t> numbers;
  trace.walks.resize(1);
  walk(input, trace.walks[0], chunks, numbers);

  const PuRows rows(input.packed->config);
  constexpr size_t kChunksOfPart = 64;
  std::vector<Part> parts((chunks.size() + kChunksOfPart - 1) / kChunksOfPart);
  parallel_for(parts.size(), threads, [&](size_t i) {
    Part& part = parts[i];
    for (size_t k = i * kChunksOfPart; k < std::min(chunks.size(), (i + 1) * kChunksOfPart); ++k) {
      TimingChunk sent{numbers[k], static_cast<uint32_t>(part.slot.size()), 0, 0};
      for (uint64_t n = 0; n < chunks[k].count; ++n) {
        const std::optional<GoldenConic> conic = trace_conic(input, chunks[k], chunks[k].slot + n);
        if (!conic) continue;
        sent.survivors |= uint64_t{1} << n;
        part.slot.push_back(static_cast<uint32_t>(chunks[k].slot + n));
        gaussian(input, rows, *conic, part);
      }
      part.chunks.push_back(sent);
    }
  });

  const uint64_t columns = frame.raster.windows.last_x - frame.raster.windows.first_x + 1,
                 windows = columns * (frame.raster.windows.last_y - frame.raster.windows.first_y + 1);
  std::vector<std::vector<const TraceSplat*>> lists(windows);
  for (const Part& part : parts) {
    const auto base = static_cast<uint32_t>(trace.slot.size());
    for (TimingChunk chunk : part.chunks) {
      chunk.first += base;
      trace.chunks_sent.push_back(chunk);
    }
    auto first = static_cast<uint32_t>(trace.mask.size());
    for (const uint32_t count : part.pairs) trace.pairs.push_back(first), first += count;
    trace.slot.insert(trace.slot.end(), part.slot.begin(), part.slot.end());
    trace.number.insert(trace.number.end(), part.number.begin(), part.number.end());
    trace.passed.insert(trace.passed.end(), part.passed.begin(), part.passed.end());
    for (const uint32_t at : part.quads_first)
      trace.quads_first.push_back(static_cast<uint32_t>(trace.quads.size()) + at);
    trace.quads.insert(trace.quads.end(), part.quads.begin(), part.quads.end());
    for (size_t i = 0; i < part.pair.size(); ++i) {
      const TracePair& pair = part.pair[i];
      trace.mask.push_back(pair.splat.mask);
      trace.key.push_back(pair.splat.key);
      trace.boxes.push_back(pair.boxes);
      if (pair.splat.mask != 0) lists[part.number[i]].push_back(&pair.splat);
    }
  }
  trace.pairs.push_back(static_cast<uint32_t>(trace.mask.size()));

  trace.windows.resize(windows);
  parallel_for(windows, threads, [&](size_t i) {
    std::vector<std::vector<TraceSplat>> layers(1);
    for (const TraceSplat* splat : lists[i]) layers[0].push_back(*splat);
    trace.windows[i] = trace_window(input, rows, frame.raster.windows.first_x + i % columns,
                                    frame.raster.windows.first_y + i / columns, layers);
  });
}

}  // namespace pipegs
