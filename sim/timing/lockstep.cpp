// SPDX-License-Identifier: Apache-2.0
// lockstep.cpp: see lockstep.hpp.
#include "sim/memory/axi/bus_timing.hpp"
#include "sim/timing/lockstep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "cpp_model/records.hpp"
#include "cpp_model/su/su.hpp"
#include "sim/timing/machine.hpp"

namespace pipegs {
namespace {

using timing::Border;
using timing::TimingEvent;

constexpr int64_t kForever = std::numeric_limits<int64_t>::max();

std::string port_name(const Config& config, int port) {
  const int units = config.units, reads = config.write_ports();
  if (port < 3 * units) {
    constexpr const char* kNames[] = {"PU {} (alphas)", "SU {}", "RU {}"};
    return fmt::format(fmt::runtime(kNames[port / units]), port % units);
  }
  if (port < reads) return "lists";
  if (port < reads + units) return fmt::format("PU {} (geometry)", port - reads);
  if (port < reads + 2 * units) return fmt::format("PU {} (colour)", port - reads - units);
  return "DOPU";
}

// The unit that acts.
std::string unit_name(const Config& config, const TimingEvent& event) {
  switch (event.border) {
    case Border::kRequest: return port_name(config, event.lane);
    case Border::kChunk: return fmt::format("PU {}", event.lane);
    case Border::kSplat: return fmt::format("SU {}", event.lane);
    case Border::kSorted: return "merge";
    case Border::kLine: return fmt::format("RU {}", event.lane / config.tap_lanes());
    case Border::kLayer: return fmt::format("RU {}", event.lane);
  }
  return "";
}

std::string beat_name(uint64_t what, const char* data) {
  return what == 2 ? "the end of a window" : what == 1 ? "the end of a layer" : fmt::format("{} {:x}", data, what >> 2);
}

std::string action(const TimingEvent* event) {
  if (event == nullptr) return "nothing";
  switch (event->border) {
    case Border::kRequest:
      return fmt::format("{} {} from line {:x} on", event->what & 1 ? "writes" : "reads", 1 + (event->what >> 1 & 7),
                         event->what >> 4);
    case Border::kChunk: return "takes " + (event->what == 0 ? "a chunk" : beat_name(event->what, ""));
    case Border::kSplat: return "takes " + beat_name(event->what, "the splat of key");
    case Border::kSorted: return "gives " + beat_name(event->what, "the splat of key");
    case Border::kLine: return fmt::format("has blended alphas of region {}, row {}", event->what / 4, event->what % 4);
    case Border::kLayer: return "has blended a layer";
  }
  return "";
}

}  // namespace

std::string TimingDifference::text() const {
  return fmt::format("cycle {}, {}: RTL {}, model {}", cycle, unit, rtl, model);
}

Lockstep::Lockstep(const TimingTrace& trace, const Config& config, const ExternalMemoryOptions& memory)
    : config_(config),
      memory_(machine_memory_timing(memory, config)),
      machine_(std::make_unique<timing::Machine>(trace, config, *memory_)) {
  machine_->events = &model_;
}

Lockstep::~Lockstep() = default;

void Lockstep::on_request(int tag, bool write, uint64_t line, int lines) {
  show(Border::kRequest, tag, timing::shown_request(line, write, lines));
}
void Lockstep::on_chunk(int unit, int kind, const uint32_t*) {
  show(Border::kChunk, unit, static_cast<uint64_t>(kind));
}
void Lockstep::on_splat(int unit, const uint32_t* splat) { show(Border::kSplat, unit, beat<Splat>(splat)); }
void Lockstep::on_sorted(const uint32_t* sorted) {
  const uint64_t what = beat<Sorted>(sorted);
  if (what == kWindowEnd) window_ends_.push_back(static_cast<uint64_t>(cycle));
  show(Border::kSorted, 0, what);
}
void Lockstep::on_layer_done(int unit, bool) { show(Border::kLayer, unit, 0); }
void Lockstep::on_alphas(int lane, uint64_t, uint64_t, uint32_t, int region, int quarter, const uint32_t*) {
  show(Border::kLine, lane, timing::shown_line(region, quarter));
}

template <class Record>
uint64_t Lockstep::beat(const uint32_t* words) const {
  const Record record = unpack<Record>(config_, words);
  if (record.kind != kData) return record.kind;
  return timing::shown_splat(splat_key(config_, record.depth, record.index, record.part));
}

void Lockstep::show(Border border, int lane, uint64_t what) {
  if (first_) return;
  if (cycle != played_) {
    compare();
    if (!first_) advance(cycle);
  }
  rtl_.push_back({cycle, border, static_cast<uint8_t>(lane), what});
}

void Lockstep::advance(int64_t cycle) {
  while (!first_ && played_ < cycle && machine_->cycle()) {
    ++played_;
    if (played_ < cycle) compare();
  }
  played_ = cycle;
}

void Lockstep::compare() {
  std::sort(rtl_.begin(), rtl_.end());
  std::sort(model_.begin(), model_.end());
  const auto [rtl, model] = std::mismatch(rtl_.begin(), rtl_.end(), model_.begin(), model_.end());
  events_ += static_cast<uint64_t>(rtl - rtl_.begin());
  if (rtl != rtl_.end() || model != model_.end())
    part(rtl == rtl_.end() ? nullptr : &*rtl, model == model_.end() ? nullptr : &*model);
  rtl_.clear();
  model_.clear();
}

void Lockstep::part(const TimingEvent* rtl, const TimingEvent* model) {
  // The events are sorted: of two units that differ the first has an event that the other side lacks.
  if (rtl != nullptr && model != nullptr && (rtl->border != model->border || rtl->lane != model->lane))
    (*rtl < *model ? model : rtl) = nullptr;
  const TimingEvent& event = rtl != nullptr ? *rtl : *model;
  first_ = {event.cycle, unit_name(config_, event), action(rtl), action(model)};
}

void Lockstep::finish() {
  if (!first_) compare();
  advance(kForever);
}

}  // namespace pipegs
