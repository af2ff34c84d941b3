// SPDX-License-Identifier: Apache-2.0
// model.cpp: see model.hpp.
#include "sim/studies/terms/model.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/studies/rivals/frame/pipeline.hpp"
#include "sim/studies/rivals/frame/traffic.hpp"

namespace pipegs {
namespace {

constexpr int kUnits = 4;                              // PUs, SUs and RUs, Table 2
constexpr double kRenderingUnits = 16, kRowUnits = 8;  // of an RU, of a PU, Sec. 4.2
constexpr double kFloats = 59 * 4;                     // a Gaussian: mean, scale, rotation, opacity, SH of degree 3
constexpr double kFeature = 32, kKey = 8, kPixel = 4;  // FP32 records: of a Gaussian in the image, a pair, a pixel
constexpr double kPackedGaussian = 96, kPackedRecord = 64, kPackedPixel = 8;  // of our RTL with 64-bit pixels
constexpr double kAlphaRun = 512;  // bytes of alphas that an RU reads at a place
constexpr double kLine = 64;

double total(const Slice& slice, int side, Cover cover) { return slice.sum(side).keys[cover]; }

double total(const Slice& slice, int side, PixelSet work, bool stop) { return slice.sum(side).pixels(work, stop); }

PixelSet work_of(const Terms& terms, Rung rung) {
  return rung == Rung::kBaseline || rung == Rung::kDpc ? terms.raster : terms.active;
}

// Cycles of a lane for a pixel.
double pixel_cycles(const Terms& terms, Rung rung) {
  if (terms.lane == LanePace::kPixel) return 1;
  const double ops = raster_ops(rung, terms.exp);
  return terms.lane == LanePace::kSerial ? ops : ops / raster_ops(Rung::kDop, terms.exp);
}

double gaussian_bytes(const Terms& terms) { return terms.packed ? kPackedGaussian : kFloats; }

double pixel_bytes(const Terms& terms) { return terms.packed ? kPackedPixel : kPixel; }
double gaussians(const Terms& terms, const Slice& slice) { return terms.all ? slice.valid : slice.frustum; }
// Of lists: written by the PUs, read by SUs and RUs.
double listed_bytes(const Terms& terms, double pairs, const Slice& slice) {
  return terms.packed ? kPackedRecord * pairs : kKey * pairs + kFeature * slice.frustum;
}
double read_bytes(const Terms& terms, double pairs) { return (terms.packed ? kPackedRecord : kKey + kFeature) * pairs; }

double over_chip(const Terms& terms, double bytes) {
  if (terms.store == AlphaStore::kFree) return 0;
  return terms.store == AlphaStore::kMemory ? bytes : std::max(0.0, bytes - kChipBytes);
}

// Layers: what else moves passes beside the work. So do alphas that all go through memory; those that a full store
// sends there hold up a PU's Row Units and an RU, which have one line after the other: the RTL's counters say so.
double with_memory(const Terms& terms, double work, double rest, double alphas) {
  if (!terms.dram) return work;
  return terms.store == AlphaStore::kChip ? std::max(work, rest) + alphas : std::max(work, rest + alphas);
}

}  // namespace

MemoryRates memory_rates(const TermsView& view, const std::string& dram, double clock_ghz) {
  const double keys = std::max(1.0, total(view.frame, 16, Cover::kOriented)) * (kKey + kFeature),
               alphas = std::max(kLine, total(view.frame, 16, PixelSet::kOrientedParts, false)),
               scene = view.file * kFloats;
  const auto rate = [&](const Flow& flow) {
    if (!(flow.bytes > 0)) return 0.0;
    const Traffic traffic = play_traffic({flow}, dram, clock_ghz);
    return traffic.cycles / traffic.bytes;
  };
  return {.scene = rate({.kind = "scene", .bytes = scene}),
          .list_write = rate({.kind = "lists", .write = true, .bytes = keys, .run = kLine}),
          .list_read = rate({.kind = "lists", .bytes = keys}),
          .alpha_write = rate({.kind = "alphas", .write = true, .bytes = alphas}),
          .alpha_read = rate({.kind = "alphas", .bytes = alphas, .run = kAlphaRun}),
          .pixels = rate({.kind = "pixels", .write = true, .bytes = view.pixels * kPixel})};
}

Passes TermsModel::passes_of(const Terms& terms, Rung rung, const Slice& slice) const {
  const bool window = terms.list != kTileSide;  // all units on one list
  const PixelSet work = work_of(terms, rung);
  const double pace = pixel_cycles(terms, rung) / kRenderingUnits / (window ? kUnits : 1);
  Passes passes;
  std::vector<std::vector<double>> items;
  double ratios = 0, sorted = 0;
  for (const ListWork& list : slice.lists(terms.list)) {
    const double keys = list.keys[list_cover(work)];
    if (keys == 0) continue;
    const double sort = window ? sort_cycles(terms.sort, std::ceil(keys / kUnits)) : sort_cycles(terms.sort, keys),
                 raster = list.pixels(work, terms.stop) * pace;
    items.push_back({sort, raster});
    ratios += raster / sort, ++sorted;
  }
  const int units = window ? 1 : kUnits;
  const PipelineRun run = run_pipeline(
      {{.name = "sort", .units = units, .ahead = static_cast<size_t>(2 * units)}, {.name = "raster", .units = units}},
      items);
  passes.cycles = run.cycles;
  passes.sort = run.busy[0] / units, passes.raster = run.busy[1] / units;
  if (sorted > 0) passes.ratio = ratios / sorted;
  return passes;
}

// grid 0: the frame.
const std::vector<Passes>& TermsModel::all_passes(const Terms& terms, Rung rung, int grid) {
  const Key key{terms.list, pixel_cycles(terms, rung), work_of(terms, rung), terms.stop, terms.sort, grid};
  const auto found = known_.find(key);
  if (found != known_.end()) return found->second;
  std::vector<Passes> all;
  if (grid == 0) all.push_back(passes_of(terms, rung, view_.frame));
  if (grid != 0) {
    for (const Slice& layer : view_.grids.at(grid)) all.push_back(passes_of(terms, rung, layer));
  }
  return known_.emplace(key, std::move(all)).first->second;
}

const Passes& TermsModel::passes(const Terms& terms, Rung rung) { return all_passes(terms, rung, 0).front(); }

double TermsModel::front_cycles(const Terms& terms, const Slice& slice) const {
  if (terms.turns) return slice.all_windows.turns / kUnits;
  return terms.pre * gaussians(terms, slice) / kUnits;
}

double TermsModel::alpha_cycles(const Terms& terms, double pixels) const {
  const double pace = terms.rows == RowPace::kSerial ? row_ops(terms.exp) : terms.rows == RowPace::kOne ? 1 : 0.5;
  return pixels * pace / (kUnits * kRowUnits);
}

double TermsModel::pu_cycles(const Terms& terms, double front, double alphas) const {
  return terms.in_turn ? front + alphas : std::max(front, alphas);
}

// Baseline, DPC and HGR: a barrier between preprocessing and the rest.
RungTimes TermsModel::serial(const Terms& terms, Rung rung) {
  const Passes& passes = this->passes(terms, rung);
  RungTimes times{.sort = passes.sort, .raster = passes.raster, .ratio = passes.ratio};
  const double front = front_cycles(terms, view_.frame);
  double write = 0, read = 0;  // alphas in memory
  times.pre = front;
  if (rung == Rung::kHgr) {
    const double pixels = total(view_.frame, terms.list, terms.active, false);  // nothing is known to be opaque yet
    times.pre = pu_cycles(terms, front, alpha_cycles(terms, pixels));
    times.alpha_bytes = pixels * terms.alpha_bytes;
    write = over_chip(terms, times.alpha_bytes);
    read = over_chip(terms, total(view_.frame, terms.list, terms.active, terms.stop) * terms.alpha_bytes);
  }
  const double pairs = total(view_.frame, terms.list, list_cover(work_of(terms, rung))),
               scene = gaussian_bytes(terms) * gaussians(terms, view_.frame),
               listed = listed_bytes(terms, pairs, view_.frame), fetched = read_bytes(terms, pairs),
               pixels = pixel_bytes(terms) * view_.pixels;
  times.bytes = scene + listed + fetched + pixels + write + read;
  times.front = times.pre;
  double rest = passes.cycles;
  if (terms.dram) {
    times.front = std::max(times.front, scene * rates_.scene + listed * rates_.list_write + write * rates_.alpha_write);
    rest = std::max(rest, fetched * rates_.list_read + read * rates_.alpha_read + pixels * rates_.pixels);
  }
  times.stall = times.front;
  times.cycles = times.front + rest;
  return times;
}

// Layer by layer over the whole frame; returns the cycles.
double TermsModel::run_layers(const Terms& terms, RungTimes& times) {
  const std::vector<Slice>& layers = view_.grids.at(terms.grid);
  const std::vector<Passes>& passes = all_passes(terms, Rung::kDop, terms.grid);
  const double written = pixel_bytes(terms) * view_.pixels / static_cast<double>(layers.size());
  std::vector<std::vector<double>> items;
  for (size_t i = 0; i < layers.size(); ++i) {
    if (layers[i].valid == 0) continue;
    const double pixels = total(layers[i], terms.list, terms.active, !terms.opaque),
                 over = over_chip(terms, pixels * terms.alpha_bytes),
                 pu = pu_cycles(terms, front_cycles(terms, layers[i]), alpha_cycles(terms, pixels)),
                 scene = gaussian_bytes(terms) * gaussians(terms, layers[i]),
                 pairs = total(layers[i], terms.list, list_cover(terms.active)),
                 listed = listed_bytes(terms, pairs, layers[i]), read = read_bytes(terms, pairs);
    times.pre += pu, times.sort += passes[i].sort, times.raster += passes[i].raster;
    times.alpha_bytes += pixels * terms.alpha_bytes, times.bytes += scene + listed + read + 2 * over;
    const double in = scene * rates_.scene + listed * rates_.list_write,
                 out = read * rates_.list_read + written * rates_.pixels;
    items.push_back({with_memory(terms, pu, in, over * rates_.alpha_write),
                     with_memory(terms, passes[i].cycles, out, over * rates_.alpha_read)});
  }
  const PipelineRun run = run_pipeline({{.name = "PU", .ahead = 1}, {.name = "SU and RU"}}, items);
  times.front = items.empty() ? 0 : items[0][0];
  times.stall = run.cycles - run.busy[1];
  return run.cycles;
}

// All layers of a list before the next list, as our RTL does; a Gaussian is fetched and projected for each of its
// lists. A list is sorted before its first Gaussian is blended.
double TermsModel::run_lists(const Terms& terms, RungTimes& times) {
  const std::vector<Slice>& layers = view_.grids.at(terms.grid);
  const double pace = pixel_cycles(terms, Rung::kDop) / (kUnits * kRenderingUnits);
  const size_t lists = view_.frame.lists(terms.list).size();
  const double written = pixel_bytes(terms) * view_.pixels / static_cast<double>(lists * layers.size());
  std::vector<std::vector<double>> items;
  for (size_t l = 0; l < lists; ++l) {
    for (const Slice& layer : layers) {
      const ListWork& list = layer.lists(terms.list)[l];
      const double keys = list.keys[list_cover(terms.active)], pixels = list.pixels(terms.active, !terms.opaque),
                   over = over_chip(terms, pixels * terms.alpha_bytes),
                   front = (terms.turns && terms.list != kTileSide ? list.turns : terms.pre * keys) / kUnits,
                   pu = pu_cycles(terms, front, alpha_cycles(terms, pixels)),
                   sort = sort_cycles(terms.sort, std::ceil(keys / kUnits)),
                   raster = list.pixels(terms.active, terms.stop) * pace,
                   fetched = gaussian_bytes(terms) * list.keys[Cover::kAxis];
      times.pre += pu, times.sort += sort, times.raster += raster;
      times.alpha_bytes += pixels * terms.alpha_bytes, times.bytes += fetched + 2 * over;
      items.push_back({with_memory(terms, pu, fetched * rates_.scene, over * rates_.alpha_write),
                       sort + with_memory(terms, raster, written * rates_.pixels, over * rates_.alpha_read)});
    }
  }
  const PipelineRun run = run_pipeline({{.name = "PU", .ahead = 1}, {.name = "SU and RU"}}, items);
  times.front = items.empty() ? 0 : items[0][0];
  times.stall = run.cycles - run.busy[1];
  return run.cycles;
}

RungTimes TermsModel::layered(const Terms& terms) {
  RungTimes times;
  times.cycles = terms.by_window ? run_lists(terms, times) : run_layers(terms, times);
  times.ratio = passes(terms, Rung::kDop).ratio;
  times.bytes += pixel_bytes(terms) * view_.pixels;
  return times;
}

TermsLadder TermsModel::without_layers(const Terms& terms) {
  TermsLadder ladder;
  for (const Rung rung : {Rung::kBaseline, Rung::kDpc, Rung::kHgr})
    ladder.rungs[static_cast<size_t>(rung)] = serial(terms, rung);
  return ladder;
}

TermsLadder TermsModel::ladder(const Terms& terms) {
  TermsLadder ladder = without_layers(terms);
  ladder.rungs[static_cast<size_t>(Rung::kDop)] = layered(terms);
  return ladder;
}

}  // namespace pipegs
