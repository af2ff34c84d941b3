// SPDX-License-Identifier: Apache-2.0
// axi_rules.cpp: see axi_rules.hpp.
#include "sim/memory/axi/axi_rules.hpp"

#include <stdexcept>

namespace pipegs {

void AxiRules::fail(const std::string& channel, const std::string& rule) const {
  throw std::runtime_error("AXI4 rule broken on " + channel + " in cycle " + std::to_string(cycle_) + ": " + rule);
}

void AxiRules::check_address(const std::string& channel, const AxiAddress& now, const AxiAddress& before) const {
  if (before.valid && !now.valid) fail(channel, "valid fell before the address was taken");
  if (before.valid && now != before) fail(channel, "the address changed before it was taken");
  if (!now.valid) return;
  if (now.burst != 1) fail(channel, "a burst that is not INCR");
  if (1 << now.size != bytes_ && (channel != "AR" || now.length != 0 || 1 << now.size > bytes_))
    fail(channel, "beats narrower or wider than the bus");
  if (now.length < 0 || now.length > 255) fail(channel, "a burst of more than 256 beats");
  if (now.address % (uint64_t{1} << now.size) != 0) fail(channel, "an address that is not aligned");
  const uint64_t last = now.address + static_cast<uint64_t>(now.length) * static_cast<uint64_t>(bytes_);
  if (now.address / 4096 != last / 4096) fail(channel, "a burst crosses 4 KB");
}

void AxiRules::check_data(const AxiWriteBeat& now) {
  if (w_.valid && !now.valid) fail("W", "valid fell before the beat was taken");
  if (w_.valid && now != w_) fail("W", "the beat changed before it was taken");
  if (!now.valid) return;
  if (!lengths_.empty() && now.last != (beat_ == lengths_.front())) fail("W", "WLAST is not at the last beat");
}

void AxiRules::check(const AxiManagerSide& manager, const AxiSubordinateSide& own) {
  ++cycle_;
  check_address("AR", manager.ar, ar_);
  check_address("AW", manager.aw, aw_);
  check_data(manager.w);
  ar_ = own.ar_ready ? AxiAddress{} : manager.ar;
  aw_ = own.aw_ready ? AxiAddress{} : manager.aw;
  w_ = own.w_ready ? AxiWriteBeat{} : manager.w;
  if (manager.aw.valid && own.aw_ready) {
    if (ends_.empty()) {
      lengths_.push_back(manager.aw.length);
    } else {
      if (ends_.front() != manager.aw.length) fail("AW", "the data that came before it has another length");
      ends_.pop_front();
    }
    if (++writes_ > most_writes_) fail("AW", "more than " + std::to_string(most_writes_) + " bursts are unanswered");
  }
  if (manager.w.valid && own.w_ready) {
    if (manager.w.last && lengths_.empty()) ends_.push_back(beat_);
    if (manager.w.last && !lengths_.empty()) {
      if (beat_ != lengths_.front()) fail("W", "WLAST is not at the last beat");
      lengths_.pop_front();
    }
    beat_ = manager.w.last ? 0 : beat_ + 1;
  }
  if (manager.ar.valid && own.ar_ready && ++reads_ > most_reads_) {
    fail("AR", "more than " + std::to_string(most_reads_) + " bursts are unanswered");
  }
  if (own.r.valid && own.r.last && manager.r_ready) --reads_;
  if (own.b.valid && manager.b_ready) --writes_;
}

}  // namespace pipegs
