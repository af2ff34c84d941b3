// SPDX-License-Identifier: Apache-2.0
// terms.cpp: see terms.hpp.
#include "sim/studies/terms/terms.hpp"

#include <fmt/format.h>

#include <cmath>

namespace pipegs {
namespace {

constexpr double kChannels = 16;     // of the Bitonic Sorter, Sec. 4.2.2
constexpr double kPivots = 8;        // of GSCore's, which the Baseline reproduces; the paper gives none
constexpr double kRecordCycles = 3;  // to take a record and to send it, docs/units/su.md
constexpr double kStages = 10;       // of a bitonic network of 16

std::string work_name(PixelSet work) {
  switch (work) {
    case PixelSet::kSquareTiles: return "tiles of the square";
    case PixelSet::kOrientedTiles: return "tiles of the oriented box";
    case PixelSet::kOrientedParts: return "parts of the oriented box";
    case PixelSet::kExactParts: return "parts, exact";
    case PixelSet::kReached: break;
  }
  return "pixels, exact";
}

std::string lane_name(LanePace lane) {
  return lane == LanePace::kPixel ? "a pixel a cycle" : lane == LanePace::kArea ? "equal area" : "an operation a cycle";
}

std::string sort_name(SortPace sort) {
  switch (sort) {
    case SortPace::kWide: return "16 keys a cycle";
    case SortPace::kSplitter: return "a key a cycle";
    case SortPace::kCompare: return "a comparison a cycle";
    case SortPace::kNetwork: return "8 exchanges a cycle";
    case SortPace::kExchange: return "an exchange a cycle";
    case SortPace::kRecords: break;
  }
  return "a key a cycle, and records";
}

std::string rows_name(RowPace rows) {
  return rows == RowPace::kSerial ? "an operation a cycle"
         : rows == RowPace::kOne  ? "a pixel a cycle"
                                  : "2 pixels a cycle";
}

std::string store_name(AlphaStore store) {
  return store == AlphaStore::kFree ? "on chip" : store == AlphaStore::kChip ? "256 KB, rest in memory" : "in memory";
}

std::string pre_name(const Terms& t) {
  return fmt::format("{} of {}{}", t.pre, t.all ? "all" : "the frustum", t.turns ? ", each window" : "");
}

double log2_ceil(double n) { return std::ceil(std::log2(n)); }

double exchanges(double n) {  // of the bitonic network of the next power of two
  const double levels = log2_ceil(n);
  return std::exp2(levels) / 2 * levels * (levels + 1) / 2;
}

// A field that is taken as it is.
#define TAKE(field) [](Terms& to, const Terms& from) { to.field = from.field; }

}  // namespace

Terms our_terms() {
  return {.list = 64,
          .raster = PixelSet::kExactParts,
          .active = PixelSet::kExactParts,
          .lane = LanePace::kPixel,
          .sort = SortPace::kRecords,
          .rows = RowPace::kTwo,
          .opaque = false,
          .store = AlphaStore::kChip,
          .dram = true,
          .packed = true,
          .all = false,
          .turns = true,
          .by_window = true};
}

Terms paper_terms() {
  return {.raster = PixelSet::kSquareTiles,
          .active = PixelSet::kSquareTiles,
          .stop = false,
          .lane = LanePace::kArea,
          .rows = RowPace::kTwo,
          .pre = 128,
          .all = false};
}

const std::vector<Assumption>& assumptions() {
  static const std::vector<Assumption> all = {
      {"lists", "side of the tiles that are sorted, px", "Sec. 3.1: \"a specific 16x16 tile\"",
       [](const Terms& t) { return std::to_string(t.list); }, TAKE(list)},
      {"raster", "pixels of Baseline and DPC",
       "Sec. 1: GSCore, the Baseline, has \"subtile skipping\"; Fig. 4 counts whole tiles",
       [](const Terms& t) { return work_name(t.raster); }, TAKE(raster)},
      {"active", "pixels from TSPP on", "Sec. 3.1: \"a fine-grained 4-bit bitmap\", \"only the active pixels\"",
       [](const Terms& t) { return work_name(t.active); }, TAKE(active)},
      {"stop", "RUs leave out what is opaque", "Sec. 4.1: \"early termination\"",
       [](const Terms& t) { return std::string(t.stop ? "yes" : "no"); }, TAKE(stop)},
      {"lanes", "what a Rendering Unit does", "Sec. 4.2.3: \"16 parallel Rendering Units\"; of a cycle silent",
       [](const Terms& t) { return lane_name(t.lane); }, TAKE(lane)},
      {"exp", "operations of exponential and opacity", "silent",
       [](const Terms& t) {
         return t.lane == LanePace::kPixel && t.rows != RowPace::kSerial ? std::string("any") : std::to_string(t.exp);
       },
       TAKE(exp)},
      {"sort", "pace of an SU", "Sec. 4.2.2: MinMax Finder, Splitter, \"16-channel Bitonic Sorter\"; of a cycle silent",
       [](const Terms& t) { return sort_name(t.sort); }, TAKE(sort)},
      {"rows", "what a Row Unit does", "Sec. 4.2.1: \"eight Row Units\"; of a cycle silent",
       [](const Terms& t) { return rows_name(t.rows); }, TAKE(rows)},
      {"opaque", "PUs compute alphas of pixels that the layers before made opaque",
       "Sec. 3.1: \"sorting-independent\", so before any is known",
       [](const Terms& t) { return std::string(t.opaque ? "yes" : "no"); }, TAKE(opaque)},
      {"alphas", "beside the projections or after them", "Sec. 4.2.1: \"immediately computes\"; silent on the overlap",
       [](const Terms& t) { return std::string(t.in_turn ? "after" : "beside"); }, TAKE(in_turn)},
      {"store", "where alphas wait", "Sec. 3.1: \"precompute and cache\"; Table 2: 428 KB of buffers; silent on where",
       [](const Terms& t) { return store_name(t.store); }, TAKE(store)},
      {"alpha", "bytes of an alpha", "silent",
       [](const Terms& t) { return t.store == AlphaStore::kFree ? std::string("any") : std::to_string(t.alpha_bytes); },
       TAKE(alpha_bytes)},
      {"memory", "takes time", "Sec. 5.1: \"DRAM timing modeled by Ramulator\"; of bytes silent",
       [](const Terms& t) { return std::string(t.dram ? "DRAM" : "ideal"); }, TAKE(dram)},
      {"records", "bytes of scene, lists and pixels", "silent",
       [](const Terms& t) { return std::string(!t.dram    ? "any"
                                               : t.packed ? "packed"
                                                          : "FP32"); }, TAKE(packed)},
      {"layers", "of the whole frame or list by list",
       "Sec. 4.1: \"while the PU preprocesses layer i + 1, the SU and "
       "RU concurrently sort and rasterize layer i\"",
       [](const Terms& t) { return std::string(t.by_window ? "list by list" : "of the frame"); }, TAKE(by_window)},
      {"pre", "cycles of a Gaussian in a PU",
       "silent; Sec. 2.2: \"complete traversal of all Gaussians in the view "
       "frustum\"",
       pre_name, [](Terms& to, const Terms& from) { to.pre = from.pre, to.all = from.all, to.turns = from.turns; }},
      {"grid", "cells along an axis", "Sec. 5.1: 4 outdoors, 8 indoors",
       [](const Terms& t) { return std::to_string(t.grid); }, TAKE(grid)},
  };
  return all;
}

std::string describe(const Terms& terms) {
  std::string text;
  for (const Assumption& one : assumptions())
    text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", one.key, one.value(terms));
  return text;
}

const char* rung_name(Rung rung) {
  switch (rung) {
    case Rung::kBaseline: return "baseline";
    case Rung::kDpc: return "dpc";
    case Rung::kHgr: return "hgr";
    case Rung::kDop: break;
  }
  return "dop";
}

double raster_ops(Rung rung, int exp) {
  if (rung == Rung::kBaseline) return kPowerOps + exp + kBlendOps;
  return rung == Rung::kDpc ? kDpcOps + exp + kBlendOps : kBlendOps;
}

double sort_cycles(SortPace sort, double n) {
  if (n <= 1) return n;
  double passes = 0;
  for (double reach = kChannels; reach < n; reach *= kPivots) ++passes;
  const double batches = std::ceil(n / kChannels);
  switch (sort) {
    case SortPace::kWide: return batches * (2 + passes);
    case SortPace::kSplitter: return n * (1 + passes) + kStages * batches;
    case SortPace::kCompare: return n * log2_ceil(n);
    case SortPace::kNetwork: return std::ceil(exchanges(n) / (kChannels / 2));
    case SortPace::kExchange: return exchanges(n);
    case SortPace::kRecords: break;
  }
  return sort_cycles(SortPace::kSplitter, n) + kRecordCycles * n;
}

}  // namespace pipegs
