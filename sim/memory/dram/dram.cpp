// SPDX-License-Identifier: Apache-2.0
// dram.cpp: see dram.hpp.
#include "sim/memory/dram/dram.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

namespace pipegs {
namespace {

constexpr int kLineBytes = 64;

}  // namespace

int64_t LatencyHistogram::percentile(double percent) const {
  const double wanted = percent / 100 * static_cast<double>(count_);
  uint64_t seen = 0;
  for (std::size_t bin = 0; bin + 1 < bins_.size(); ++bin) {
    seen += bins_[bin];
    if (seen > 0 && static_cast<double>(seen) >= wanted) return static_cast<int64_t>(bin);
  }
  return max_;
}

std::vector<uint64_t> LatencyHistogram::reads() const {
  const auto longest = std::min<std::size_t>(static_cast<std::size_t>(max_), bins_.size() - 1);
  return {bins_.begin(), bins_.begin() + static_cast<std::ptrdiff_t>(longest) + 1};
}

Dram::Dram(const DramTiming& timing, double machine_clock_ghz)
    : timing_(timing),
      machine_clock_ghz_(machine_clock_ghz),
      ratio_(1000.0 / (machine_clock_ghz * timing.t_ck_ps)),
      places_(timing),
      bursts_per_line_(std::max(1, kLineBytes / timing.burst_bytes())),
      line_shift_(std::countr_zero(static_cast<unsigned>(kLineBytes)) -
                  std::countr_zero(static_cast<unsigned>(timing.burst_bytes()))) {
  check_dram(timing);
  if (!(machine_clock_ghz > 0)) throw std::invalid_argument("dram: the machine's clock must be positive");
  channels_.assign(timing.channels, DramChannel(timing));
  front_.resize(std::bit_ceil(static_cast<unsigned>(timing.front_queue)));
  // Room for all reads that the channels can hold, and for some that have arrived and are not yet popped.
  const int bursts = timing.channels * (timing.read_queue + timing.banks_per_channel() + timing.rl + timing.t_burst);
  lines_.resize(timing.front_queue + bursts + 256);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    lines_[i].left = i + 1 < lines_.size() ? static_cast<int32_t>(i + 1) : -1;
  }
  arrivals_.resize(std::bit_ceil(lines_.size()));
  for (int c = 0; c < timing.channels; ++c) next_[c] = channels_[c].next();
  next_all_ = *std::min_element(next_.begin(), next_.begin() + timing.channels);
}

void Dram::request(bool write, uint64_t line, uint32_t id, int halves) {
  if (!ready()) throw std::logic_error("dram: a line is given while not ready");
  uint64_t burst = line_shift_ >= 0 ? line << line_shift_ : line >> -line_shift_;
  int bursts = bursts_per_line_;
  if (halves != 3 && bursts > 1) {
    bursts /= 2;
    if (halves == 2) burst += static_cast<uint64_t>(bursts);
  }
  Waiting waiting{burst, places_(burst), bursts, 0, write};
  if (write) {
    ++writes_;
  } else {
    ++reads_;
    waiting.slot = static_cast<uint32_t>(free_);
    Line& slot = lines_[waiting.slot];
    free_ = slot.left;
    slot = {id, bursts, step_};
  }
  if (waiting_ == 0 && offer(waiting, dram_cycle(step_))) return;
  front_[(first_waiting_ + waiting_++) & (static_cast<int>(front_.size()) - 1)] = waiting;
}

// Gives the bursts of a line to their channels as far as these accept them; true if none is left.
bool Dram::offer(Waiting& waiting, DramCycle now) {
  for (;;) {
    const uint32_t c = waiting.place.channel;
    DramChannel& channel = channels_[c];
    if (!channel.accepts(waiting.write)) return false;
    channel.accept(now, waiting.write, waiting.place, waiting.slot);
    next_[c] = channel.next();
    next_all_ = std::min(next_all_, next_[c]);
    if (--waiting.left == 0) return true;
    waiting.place = places_.next(waiting.place, ++waiting.burst);
  }
}

void Dram::advance(DramCycle until) {
  while (next_all_ <= until) {
    const DramCycle now = next_all_;
    next_all_ = INT64_MAX;
    for (int c = 0; c < timing_.channels; ++c) {
      if (next_[c] <= now) {
        DramChannel& channel = channels_[c];
        uint32_t slot;
        while (channel.finished(now, slot)) arrive(slot);
        channel.tick(now);
        next_[c] = channel.next();
      }
      next_all_ = std::min(next_all_, next_[c]);
    }
    while (waiting_ > 0 && offer(front_[first_waiting_], now)) {
      first_waiting_ = (first_waiting_ + 1) & (static_cast<int>(front_.size()) - 1);
      --waiting_;
    }
  }
}

void Dram::arrive(uint32_t slot) {
  Line& line = lines_[slot];
  if (--line.left > 0) return;
  latency_.add(step_ - line.since);
  arrivals_[(first_arrival_ + arrived_++) & (arrivals_.size() - 1)] = slot;
}

bool Dram::pop(uint32_t& id) {
  const uint32_t slot = arrivals_[first_arrival_ & (arrivals_.size() - 1)];
  ++first_arrival_;
  --arrived_;
  id = lines_[slot].id;
  lines_[slot].left = free_;
  free_ = static_cast<int32_t>(slot);
  return true;
}

bool Dram::idle() const {
  if (waiting_ > 0) return false;
  for (const DramChannel& channel : channels_) {
    if (!channel.idle()) return false;
  }
  return true;
}

Dram::Statistics Dram::statistics() const {
  DramChannel::Counters sum;
  for (const DramChannel& channel : channels_) sum += channel.counters();
  Statistics s;
  s.reads = reads_, s.writes = writes_;
  s.bursts_read = sum.bursts_read, s.bursts_written = sum.bursts_written;
  s.reads_forwarded = sum.reads_forwarded, s.writes_merged = sum.writes_merged;
  s.row_hits = sum.row_hits, s.row_misses = sum.row_misses, s.row_conflicts = sum.row_conflicts;
  s.activates = sum.activates, s.precharges = sum.precharges, s.refreshes = sum.refreshes;
  s.data_bus_busy = (s.bursts_read + s.bursts_written) * static_cast<uint64_t>(timing_.t_burst);
  const double all = static_cast<double>(step_) * ratio_ * timing_.channels;
  s.data_bus_share = all > 0 ? static_cast<double>(s.data_bus_busy) / all : 0;
  s.latency_mean = latency_.mean();
  s.latency_p50 = latency_.percentile(50), s.latency_p90 = latency_.percentile(90);
  s.latency_p99 = latency_.percentile(99), s.latency_max = latency_.max();
  return s;
}

double Dram::achieved_gbps() const {
  const Statistics s = statistics();
  const double bytes = static_cast<double>(s.bursts_read + s.bursts_written) * timing_.burst_bytes();
  return step_ == 0 ? 0 : bytes * 1e-9 / seconds();
}

}  // namespace pipegs
