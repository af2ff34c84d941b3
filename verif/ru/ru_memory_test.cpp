// SPDX-License-Identifier: Apache-2.0
// ru_memory_test: rtl/ru/ru_memory.sv against the two queues of requests that enter it.
#include "cpp_model/config.hpp"
#include "verif/support/bench.hpp"
#include "Vru_memory.h"

namespace pipegs {
namespace {

// Watches the port: keeps requests in order of acceptance and checks that a waiting one does not change.
class Port : public Endpoint {
 public:
  Port(Bench<Vru_memory>& bench, Pace pace) : bench_(bench), pace_(pace) { bench.add(*this); }
  void drive() override { bench_.dut.mem_ready_i = goes(pace_, bench_.rng); }
  void observe() override {
    auto& dut = bench_.dut;
    Words now(2 + 16);
    now[0] = dut.mem_write_o | dut.mem_halves_o << 1;
    now[1] = static_cast<uint32_t>(dut.mem_address_o);
    if (dut.mem_write_o) read_port(dut.mem_data_o, now.data() + 2);
    if (waiting_) {
      EXPECT_TRUE(dut.mem_valid_o);
      EXPECT_EQ(now, last_) << "cycle " << bench_.cycle;
    }
    waiting_ = dut.mem_valid_o && !dut.mem_ready_i;
    last_ = now;
    if (!dut.mem_valid_o || !dut.mem_ready_i) return;
    (dut.mem_write_o ? writes : reads).push_back(now);
    cycles.push_back(bench_.cycle);
  }
  std::vector<Words> reads, writes;
  std::vector<uint64_t> cycles;

 private:
  Bench<Vru_memory>& bench_;
  Pace pace_;
  Words last_;
  bool waiting_ = false;
};

// The write side: address and line travel together.
class Writer : public Endpoint {
 public:
  Writer(Bench<Vru_memory>& bench, int count) : bench_(bench), left_(count) { bench.add(*this); }
  void drive() override {
    auto& dut = bench_.dut;
    if (!up_ && left_ > 0) {
      up_ = true;
      words_ = Words(18);
      words_[0] = 1 | static_cast<uint32_t>(bench_.rng() % 4) << 1;  // a write, and its halves
      for (size_t i = 1; i < words_.size(); ++i) words_[i] = static_cast<uint32_t>(bench_.rng());
    }
    dut.write_valid_i = up_;
    dut.write_halves_i = words_[0] >> 1;
    dut.write_address_i = words_[1];
    write_port(dut.write_data_i, words_.data() + 2);
  }
  void observe() override {
    if (!up_ || !bench_.dut.write_ready_o) return;
    EXPECT_FALSE(bench_.dut.read_valid_i) << "a write went before a read";
    sent.push_back(words_);
    up_ = false;
    --left_;
  }
  std::vector<Words> sent;

 private:
  Bench<Vru_memory>& bench_;
  int left_;
  bool up_ = false;
  Words words_ = Words(18);
};

TEST(RuMemory, KeepsBothOrdersAndLetsReadsGoFirst) {
  for (const Pace read_pace : kPaces) {
    for (const Pace port_pace : kPaces) {
      Bench<Vru_memory> bench;
      auto& dut = bench.dut;
      dut.read_valid_i = dut.write_valid_i = 0;
      WordSource reads(bench, dut.read_valid_i, dut.read_ready_o, dut.read_address_i, read_pace);
      Writer writer(bench, 200);
      Port port(bench, port_pace);
      bench.reset();
      std::vector<uint32_t> addresses;
      for (int i = 0; i < 200; ++i) {
        addresses.push_back(static_cast<uint32_t>(bench.rng()));
        reads.push({addresses.back(), 0});
      }
      bench.run_until([&] { return port.reads.size() + port.writes.size() == 400; });
      ASSERT_EQ(port.reads.size(), 200u);
      for (int i = 0; i < 200; ++i) {
        ASSERT_EQ(port.reads[i][0], 3u << 1) << "a read is of the whole line";
        ASSERT_EQ(port.reads[i][1], addresses[i]);
      }
      ASSERT_EQ(port.writes, writer.sent);
      if (port_pace == Pace::kAlways && read_pace == Pace::kAlways) {
        EXPECT_EQ(port.cycles.back() - port.cycles.front(), 399u);
      }
    }
  }
}

}  // namespace
}  // namespace pipegs
