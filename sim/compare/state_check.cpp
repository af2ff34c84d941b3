// SPDX-License-Identifier: Apache-2.0
// state_check.cpp: see state_check.hpp.
#include "sim/compare/state_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/compare/frame_watch.hpp"

namespace pipegs {
namespace {

// Sets of states.
enum : unsigned { kB = 1u << kBusy, kS = 1u << kStarved, kK = 1u << kBlocked, kM = 1u << kMemory, kAny = 15 };
constexpr const char* kNames[] = {"busy", "starved", "blocked", "memory"};
constexpr const char* kKindNames[] = {"DOPU", "PU", "SU", "RU"};

// Cycles that a Gaussian spends in the projection at least, whatever its stages are.
constexpr int kProjection = 20;
// Cycles from the arrival of a line to the first in which a unit has it at its output and does not wait any more.
constexpr int64_t kArrival = 3;

std::string names(unsigned allowed) {
  std::string text;
  for (unsigned i = 0; i < 4; ++i) {
    if ((allowed >> i & 1) != 0) text += (text.empty() ? "" : " or ") + std::string(kNames[i]);
  }
  return text;
}

}  // namespace

StateCheck::StateCheck(const Config& config, bool raster, Hear hear)
    : config_(config), joined_(raster && config.units > 1), hear_(std::move(hear)) {}

size_t StateCheck::place(size_t kind, int k) const {
  return kind == 0 ? 0 : 1 + (kind - 1) * static_cast<size_t>(config_.units) + static_cast<size_t>(k);
}

// All of a cycle is known when the next one begins. What a unit has asked for counts from the first one on.
void StateCheck::on_cycle(uint64_t, const uint8_t* states) {
  if (cycles_ > 0) judge();
  if (cycle != now().number + 1) counts_ = {};  // the machine was empty, and its counters begin anew
  ++cycles_;
  now() = {.number = cycle, .states = {}, .border = {}, .ends = 0, .pixels = 0, .layers = 0};
  for (size_t unit = 0; unit < place(kKinds, 0); ++unit) {
    now().states[unit] = states[unit];
    ++counts_[unit][states[unit]];
  }
}

void StateCheck::on_border(const uint8_t* border) { std::copy_n(border, kRtlBorders, now().border.begin()); }

void StateCheck::on_chunk(int pu, int kind, const uint32_t*) {
  if (kind != kData) now().ends |= static_cast<uint8_t>(1 << pu);
}

void StateCheck::on_pixels(int lane, int, int, const uint32_t*) {
  now().pixels |= static_cast<uint8_t>(1 << lane / config_.tap_lanes());
}

// Reads of geometry, colours and nodes have the last tags.
void StateCheck::on_request(int tag, bool write, uint64_t, int lines) {
  const int reader = tag - (config_.memory_ports() - 2 * config_.units - 1);
  if (write || reader < 0) return;
  if (reader < config_.units) pu_[static_cast<size_t>(reader)].geometry.lines += lines;
  if (reader == 2 * config_.units) nodes_.lines += lines, --nodes_.requests;
}

void StateCheck::finish(const RtlResult& counters) {
  const std::vector<UnitCycles>* units[] = {&counters.dopu, &counters.pu, &counters.su, &counters.ru};
  for (size_t kind = 0; kind < kKinds; ++kind) {
    for (int k = 0; k < static_cast<int>(units[kind]->size()); ++k) {
      const UnitCycles& counted = (*units[kind])[static_cast<size_t>(k)];
      const std::array<uint64_t, kStates> found = {counted.busy, counted.starved, counted.blocked, counted.memory},
                                          &expected = counts_[place(kind, k)];
      if (found == expected) continue;
      const auto text = [](const auto& sums) { return fmt::format("{} {} {} {}", sums[0], sums[1], sums[2], sums[3]); };
      hear_({.unit = fmt::format("{} {}", kKindNames[kind], k), .expected = text(expected), .found = text(found)});
    }
  }
}

void StateCheck::expect(const Cycle& cycle, size_t kind, int k, unsigned allowed) {
  if (cycle.number == kNone) return;
  const uint8_t state = cycle.states[place(kind, k)];
  if ((allowed >> state & 1) != 0) return;
  hear_({.unit = kind == 0 ? kKindNames[kind] : fmt::format("{} {}", kKindNames[kind], k),
         .cycle = cycle.number,
         .expected = names(allowed),
         .found = kNames[state]});
}

void StateCheck::judge() {
  judge_dopu();
  for (int k = 0; k < config_.units; ++k) judge_pu(k), judge_su(k), judge_ru(k);
}

// A chunk shows in the cycle after the one that lets it pass, so it is the cycle before that is judged.
void StateCheck::judge_dopu() {
  const Cycle &judged = ago(1), &next = ago(0);
  unsigned allowed = kAny;
  if (judged.border[kChunkShows] != 0) {
    allowed &= ~kS;
  } else {
    if (judged.border[kChunkRoom] != 0) allowed &= ~kK;
    // Nearest first, what holds up nodes on their way is a chunk that is made, or finds no room.
    if (config_.has_watermarks() && without_nodes_ == 0 && !loading_) allowed &= ~kS;
  }
  if (without_nodes_ > kArrival) allowed &= ~kM;
  if (!judged.at(kDopuBusy, 0)) allowed = kS;
  if ((next.border[kChunkShows] & ~judged.border[kChunkShows]) != 0) allowed = kB;
  expect(judged, 0, 0, allowed);

  nodes_.requests += next.at(kNodeAsked, 0);
  nodes_.lines -= next.at(kNodeLine, 0);
  loading_ = !next.at(kDopuBusy, 0) || (loading_ && !next.at(kNodeAsks, 0));
  const bool coming = loading_ || next.at(kNodeAsks, 0) || nodes_.requests > 0 || nodes_.lines > 0;
  without_nodes_ = coming ? 0 : without_nodes_ + 1;
}

void StateCheck::judge_pu(int k) {
  const Cycle& judged = ago(0);
  Pu& pu = pu_[static_cast<size_t>(k)];
  const bool inside = judged.at(kPuBusy, k);
  unsigned allowed = kAny;
  if (!config_.has_stores()) allowed &= ~kK;
  if (pu.geometry.lines > 0 && pu.since > kArrival) allowed &= ~kS;
  if (!inside) pu.first = true, pu.passing = 0;
  if (pu.first) allowed = !inside ? kS : pu.geometry.lines > 0 ? kM : kM | kS;
  // The end of the layer before may be left, which waits for older ones to leave the stores, and then goes its way; and
  // its last line of alphas, on its way to the memory.
  if (pu.first && config_.has_stores()) allowed = inside ? kAny : config_.spills_alphas() ? kS | kK | kM : kS | kK;
  if (pu.passing > 0 || judged.at(kCulledShows, k)) allowed = kB | kK;
  if (judged.at(kSplatShows, k) && !judged.at(kSplatReady, k)) allowed = config_.caches_alphas() ? kB | kK : kK;
  expect(judged, 1, k, allowed);

  pu.geometry.lines -= judged.at(kGeometryLine, k);
  pu.since = judged.at(kGeometryLine, k) ? 0 : pu.since + 1;
  pu.passing = judged.at(kVisibleTakes, k) ? kProjection : std::max(0, pu.passing - 1);
  if (judged.at(kVisibleTakes, k) || judged.at(kGeometryLine, k) || (judged.ends >> k & 1) != 0) pu.first = false;
}

void StateCheck::judge_su(int k) {
  const Cycle& judged = ago(0);
  bool& spills = spills_[static_cast<size_t>(k)];
  spills = spills || judged.at(kSpilling, k) || judged.at(kSortAsks, k);
  const unsigned rest = judged.at(kOrderedShows, k) && !judged.at(kOrderedReady, k) ? kK : kS;
  unsigned allowed = judged.at(kSuActive, k) ? kB : rest;
  if (judged.at(kSuTakes, k)) allowed |= rest;
  if (spills) allowed |= judged.at(kSuActive, k) ? rest | kM : kM;
  if (judged.at(kSortAsks, k)) allowed = kB | kM;
  expect(judged, 2, k, allowed);
}

// Pixels that begin are seen when they are written back: the cycle that is judged is as long ago. A line of pixels
// leaves for the register before the memory; in raster order the first of two RUs writes the second one's, too.
void StateCheck::judge_ru(int k) {
  const uint64_t pass = config_.quads ? 5 : 3;
  const Cycle &judged = ago(pass), &next = ago(pass - 1);
  int64_t& queued = queued_[static_cast<size_t>(k)];
  unsigned allowed = kB;
  if ((ago(0).pixels >> k & 1) == 0 && (judged.layers >> k & 1) == 0 && !judged.leaves(k, next)) {
    const bool shared = joined_ && k % 2 == 1 && judged.leaves(k - 1, next);
    allowed = judged.at(kRuAsks, k) ? kM : kS;
    if (joined_) allowed |= kM;
    if (config_.caches_alphas()) allowed |= kK | kM;  // it waits for a line of alphas
    if (queued > 0 || shared) allowed |= kB;
    if (judged.number != kNone && judged.states[place(3, k)] == kBusy && !shared) --queued;
  }
  expect(judged, 3, k, allowed);
  queued += ago(pass + 1).at(kRuTakes, k);
}

}  // namespace pipegs
