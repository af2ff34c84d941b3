// SPDX-License-Identifier: Apache-2.0
// soc_pins: the DMA of the example system, and what the port of its memory shows.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <random>
#include <stdexcept>
#include <vector>

#include "sim/memory/axi/axi_signals.hpp"

namespace pipegs {

using SocBeat = std::array<uint32_t, 4>;

// An AXI4 manager of 128 bits with one ID: bursts in the order in which they were asked for, all pauses by chance.
template <class Dut>
class SocDma {
 public:
  std::function<void(uint64_t address, const SocBeat& data)> got;  // a beat was read

  void read(uint64_t address, int beats) { reads_.push_back({address, beats}); }
  void write(uint64_t address, std::vector<SocBeat> beats) { writes_.push_back({address, std::move(beats)}); }
  bool busy() const { return !reads_.empty() || !open_.empty() || !writes_.empty() || unanswered_ > 0; }

  void drive(Dut& dut) {
    ask_ = ask_ || chance();  // what was shown stays until it is taken
    show_ = show_ || chance();
    dut.d_arvalid = ask_ && !reads_.empty() && open_.size() < 4;
    if (dut.d_arvalid) dut.d_araddr = reads_.front().address, dut.d_arlen = reads_.front().beats - 1;
    dut.d_rready = chance();
    dut.d_awvalid = !writes_.empty() && !told_;
    dut.d_wvalid = show_ && !writes_.empty() && beat_ < writes_.front().beats.size();
    if (!writes_.empty()) {
      const Write& write = writes_.front();
      dut.d_awaddr = write.address, dut.d_awlen = write.beats.size() - 1;
    }
    if (dut.d_wvalid) {
      const Write& write = writes_.front();
      for (size_t i = 0; i < 4; ++i) dut.d_wdata[i] = write.beats[beat_][i];
      dut.d_wlast = beat_ + 1 == write.beats.size();
    }
    dut.d_bready = chance();
  }

  void observe(const Dut& dut) {
    if (dut.d_arvalid && dut.d_arready) {
      open_.push_back(reads_.front());
      reads_.pop_front();
      ask_ = false;
    }
    if (dut.d_rvalid && dut.d_rready) take(dut);
    if (dut.d_wvalid && dut.d_wready) ++beat_, show_ = false;
    told_ = told_ || (dut.d_awvalid && dut.d_awready);
    if (!writes_.empty() && told_ && beat_ == writes_.front().beats.size()) {
      writes_.pop_front();
      beat_ = 0, told_ = false, ++unanswered_;
    }
    if (!dut.d_bvalid || !dut.d_bready) return;
    if (dut.d_bresp != 0 || --unanswered_ < 0) throw std::runtime_error("DMA: a write failed, or was never made");
  }

 private:
  struct Read {
    uint64_t address;
    int beats;
  };
  struct Write {
    uint64_t address;
    std::vector<SocBeat> beats;
  };

  void take(const Dut& dut) {
    if (open_.empty() || dut.d_rresp != 0 || (dut.d_rlast != 0) != (open_.front().beats == 1))
      throw std::runtime_error("DMA: an answer to nobody, an error, or RLAST at the wrong beat");
    Read& read = open_.front();
    if (got) got(read.address, {dut.d_rdata[0], dut.d_rdata[1], dut.d_rdata[2], dut.d_rdata[3]});
    read.address += sizeof(SocBeat);
    if (--read.beats == 0) open_.pop_front();
  }

  bool chance() { return (rng_() & 1) != 0; }

  std::mt19937_64 rng_{1};
  std::deque<Read> reads_, open_;  // open: taken by the bus
  std::deque<Write> writes_;
  size_t beat_ = 0;  // of the first of `writes_`
  bool ask_ = false, show_ = false, told_ = false;
  int unanswered_ = 0;
};

// What the crossbar shows at the memory's port, for AxiRules.
template <class Dut>
AxiManagerSide soc_memory_manager(const Dut& dut) {
  const auto burst = [](bool valid, uint64_t ask) {
    return AxiAddress{.valid = valid,
                      .id = static_cast<uint32_t>(ask >> 48),
                      .address = ask >> 8 & 0xff'ffff'ffff,
                      .length = static_cast<int>(ask & 0xff),
                      .size = 4,
                      .burst = 1};
  };
  AxiManagerSide side;
  side.ar = burst(dut.m_arvalid, dut.m_ar);
  side.aw = burst(dut.m_awvalid, dut.m_aw);
  side.w.valid = dut.m_wvalid, side.w.last = dut.m_wlast, side.w.strobes = dut.m_w[4];
  for (size_t i = 0; i < 4; ++i) side.w.data[i] = dut.m_w[i];
  side.r_ready = dut.m_rready, side.b_ready = dut.m_bready;
  return side;
}
template <class Dut>
AxiSubordinateSide soc_memory_subordinate(const Dut& dut) {
  AxiSubordinateSide side;
  side.ar_ready = dut.m_arready, side.aw_ready = dut.m_awready, side.w_ready = dut.m_wready;
  side.r.valid = dut.m_rvalid, side.r.last = dut.m_rlast, side.b.valid = dut.m_bvalid;
  return side;
}

}  // namespace pipegs
