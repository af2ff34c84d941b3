// SPDX-License-Identifier: Apache-2.0
// timeline.cpp: see timeline.hpp.
#include "sim/report/timeline.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/compare/simulate.hpp"

namespace pipegs {
namespace {

constexpr int kCounterProcess = 5;
constexpr std::array<const char*, 4> kProcessNames = {"DOPU", "PU: preprocessing", "SU: sorting", "RU: rasterization"};
constexpr std::array<const char*, 4> kUnitNames = {"DOPU", "PU", "SU", "RU"};
constexpr std::array<const char*, 4> kColors = {"good", "grey", "bad", "terrible"};  // chrome://tracing only

// Cycles as microseconds with three digits.
std::string time(uint64_t cycles) { return fmt::format("{}.{:03}", cycles / 1000, cycles % 1000); }

}  // namespace

Timeline::Timeline(const Config& config, const TimelineOptions& options, std::ostream& out)
    : FrameWatch(config),
      options_(options),
      out_(out),
      states_(1 + 3 * config.units),
      sums_(1 + 3 * config.units),
      streams_(memory_streams(config)),
      bytes_(streams_.size(), 0) {
  out_ << "{\"displayTimeUnit\": \"ns\", \"traceEvents\": [\n";
  name_tracks();
}

void Timeline::event(const std::string& text) {
  out_ << (any_ ? ",\n" : "") << text;
  any_ = true;
}

Timeline::Track Timeline::track(int unit) const {
  if (unit == 0) return {1, 1};
  const int units = config().units, kind = 1 + (unit - 1) / units, k = (unit - 1) % units;
  return {kind + 1, 2 * k + 1};
}

std::string Timeline::unit_name(int unit) const {
  if (unit == 0) return kUnitNames[0];
  const int units = config().units;
  return fmt::format("{} {}", kUnitNames[1 + (unit - 1) / units], (unit - 1) % units);
}

void Timeline::name_tracks() {
  for (int process = 1; process <= kCounterProcess; ++process) {
    event(fmt::format(R"({{"ph": "M", "pid": {0}, "name": "process_name", "args": {{"name": "{1}"}}}})", process,
                      process == kCounterProcess ? "memory and buffers" : kProcessNames[process - 1]));
    event(fmt::format(R"({{"ph": "M", "pid": {0}, "name": "process_sort_index", "args": {{"sort_index": {0}}}}})",
                      process));
  }
  for (int unit = 0; unit < static_cast<int>(states_.size()); ++unit) {
    const auto [process, thread] = track(unit);
    const std::string name = unit_name(unit);
    event(fmt::format(R"({{"ph": "M", "pid": {}, "tid": {}, "name": "thread_name", "args": {{"name": "{}"}}}})",
                      process, thread, name));
    event(fmt::format(R"({{"ph": "M", "pid": {}, "tid": {}, "name": "thread_name", "args": {{"name": "{} state"}}}})",
                      process, thread + 1, name));
  }
}

void Timeline::layer(UnitKind kind, int k, const FramePlace& place, uint64_t begin, uint64_t end) {
  const int unit = kind == UnitKind::kDopu ? 0 : 1 + (static_cast<int>(kind) - 1) * config().units + k;
  const auto [process, thread] = track(unit);
  const uint64_t x = options_.first_x + place.window % options_.columns,
                 y = options_.first_y + place.window / options_.columns;
  event(fmt::format(R"({{"ph": "X", "pid": {}, "tid": {}, "ts": {}, "dur": {}, "name": "window {},{} layer {}", )"
                    R"("args": {{"window": {}, "layer": {}}}}})",
                    process, thread, time(begin), time(end + 1 - begin), x, y, place.layer, place.window, place.layer));
}

void Timeline::on_request(int tag, bool, uint64_t, int lines) {
  bytes_[memory_stream(config(), tag)] += 64 * static_cast<uint64_t>(lines);
}

void Timeline::end_slice(int unit, uint64_t end) {
  States& states = states_[unit];
  if (states.name < 0) return;
  const auto [process, thread] = track(unit);
  event(fmt::format(R"({{"ph": "X", "pid": {}, "tid": {}, "ts": {}, "dur": {}, "name": "{}", "cname": "{}", )"
                    R"("args": {{"busy": {}, "starved": {}, "blocked": {}, "memory": {}}}}})",
                    process, thread + 1, time(states.begin), time(end - states.begin), kUnitStateNames[states.name],
                    kColors[states.name], states.slice[kBusy], states.slice[kStarved], states.slice[kBlocked],
                    states.slice[kMemory]));
}

// The piece joins the slice or begins a new one.
void Timeline::end_piece(int unit, uint64_t end) {
  States& states = states_[unit];
  uint64_t length = 0;
  for (const uint64_t count : states.piece) length += count;
  if (length == 0) return;
  const int name = static_cast<int>(std::max_element(states.piece.begin(), states.piece.end()) - states.piece.begin());
  if (name != states.name) {
    end_slice(unit, end - length);
    states.begin = end - length;
    states.slice = {};
    states.name = name;
  }
  for (size_t i = 0; i < 4; ++i) states.slice[i] += states.piece[i];
  states.piece = {};
}

void Timeline::counters(uint64_t at) {
  std::string bytes, lines;
  for (size_t i = 0; i < streams_.size(); ++i)
    bytes += fmt::format("{}\"{}\": {}", i == 0 ? "" : ", ", streams_[i], bytes_[i]);
  std::fill(bytes_.begin(), bytes_.end(), 0);
  event(fmt::format(R"({{"ph": "C", "pid": {}, "ts": {}, "name": "bytes per {} cycles", "args": {{{}}}}})",
                    kCounterProcess, time(at), options_.sample, bytes));
  event(fmt::format(R"({{"ph": "C", "pid": {}, "ts": {}, "name": "records in the SUs", "args": {{"records": {}}}}})",
                    kCounterProcess, time(at), records()));
  if (!has_alpha_stores()) return;
  for (int k = 0; k < config().units; ++k)
    lines += fmt::format("{}\"store {}\": {}", k == 0 ? "" : ", ", k, alpha_lines(k));
  event(fmt::format(R"({{"ph": "C", "pid": {}, "ts": {}, "name": "lines in the alpha stores", "args": {{{}}}}})",
                    kCounterProcess, time(at), lines));
}

void Timeline::cycle(uint64_t cycle, const uint8_t* states) {
  if (cycle > 0 && cycle % static_cast<uint64_t>(options_.grain) == 0) {
    for (int unit = 0; unit < static_cast<int>(states_.size()); ++unit) end_piece(unit, cycle);
  }
  // A value stands at the begin of its interval.
  const auto sample = static_cast<uint64_t>(options_.sample);
  if (cycle > 0 && cycle % sample == 0) counters(cycle - sample);
  for (size_t unit = 0; unit < states_.size(); ++unit) {
    ++states_[unit].piece[states[unit]];
    ++sums_[unit][states[unit]];
  }
  cycles_ = cycle + 1;
}

void Timeline::finish(const RtlResult& rtl) {
  for (int unit = 0; unit < static_cast<int>(states_.size()); ++unit) {
    end_piece(unit, cycles_);
    end_slice(unit, cycles_);
  }
  if (cycles_ > 0)
    counters((cycles_ - 1) / static_cast<uint64_t>(options_.sample) * static_cast<uint64_t>(options_.sample));
  std::vector<UnitCycles> units = rtl.dopu;
  units.insert(units.end(), rtl.pu.begin(), rtl.pu.end());
  units.insert(units.end(), rtl.su.begin(), rtl.su.end());
  units.insert(units.end(), rtl.ru.begin(), rtl.ru.end());
  std::string list;
  for (size_t i = 0; i < units.size(); ++i) {
    const UnitCycles& unit = units[i];
    if (sums_[i] != Counts{unit.busy, unit.starved, unit.blocked, unit.memory}) {
      throw std::logic_error(fmt::format("timeline: the states of {} do not sum to its performance counters",
                                         unit_name(static_cast<int>(i))));
    }
    const auto [process, thread] = track(static_cast<int>(i));
    list += fmt::format(
        R"({}{{"unit": "{}", "pid": {}, "tid": {}, "busy": {}, "starved": {}, "blocked": {}, "memory": {}}})",
        i == 0 ? "" : ",\n  ", unit_name(static_cast<int>(i)), process, thread, unit.busy, unit.starved, unit.blocked,
        unit.memory);
  }
  out_ << fmt::format("\n], \"otherData\": {{\"cycles\": {}, \"grain\": {}, \"units\": [\n  {}]}}}}\n", rtl.cycles,
                      options_.grain, list);
}

}  // namespace pipegs
