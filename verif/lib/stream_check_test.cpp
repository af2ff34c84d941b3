// SPDX-License-Identifier: Apache-2.0
// stream_check_test: rtl/lib/pipegs_stream_check.sv: three streams side by side; it speaks when one breaks the
// contract, and only then.
#include "Vpipegs_stream_check.h"
#include "verif/support/bench.hpp"

namespace pipegs {
namespace {

#ifdef PIPEGS_SHARED_BEAT
constexpr int kBeats = 1;
#else
constexpr int kBeats = 3;
#endif
constexpr int kPorts = 3;

struct Streams {
  explicit Streams(uint64_t seed = test_seed()) : bench(seed) {
    bench.dut.valid_i = bench.dut.ready_i = 0;
    bench.dut.beat_i = 0;
    bench.reset();
  }
  // A cycle in which all obey: what was shown and not taken stays.
  void obey() {
    uint32_t valid = static_cast<uint32_t>(bench.rng() % 8), beats = static_cast<uint32_t>(bench.rng());
    valid |= waits;
    for (int i = 0; i < kBeats; ++i) {
      const uint32_t here = kBeats == 1 ? 7 : 1u << i;
      if ((waits & here) != 0) beats = (beats & ~(0xfu << (4 * i))) | (shown & 0xfu << (4 * i));
    }
    drive(valid, static_cast<uint32_t>(bench.rng() % 8), beats);
  }
  void drive(uint32_t valid, uint32_t ready, uint32_t beats) {
    bench.dut.valid_i = static_cast<CData>(valid);
    bench.dut.ready_i = static_cast<CData>(ready);
    shown = beats & ((1u << (4 * kBeats)) - 1);
    bench.dut.beat_i = static_cast<std::remove_reference_t<decltype(bench.dut.beat_i)>>(shown);
    waits = valid & ~ready;
    bench.step();
  }
  Bench<Vpipegs_stream_check> bench;
  uint32_t waits = 0, shown = 0;
};

TEST(StreamCheck, IsSilentWhileAllObey) {
  Streams s;
  for (int i = 0; i < 20000; ++i) s.obey();
  s.bench.reset();  // what waited is forgotten
  s.drive(0, 0, 0);
}

TEST(StreamCheck, FindsEveryValidThatFalls) {
  for (uint64_t seed = 1; seed < 20; ++seed) {
    for (uint32_t port = 0; port < kPorts; ++port) {
      Streams s(seed);
      for (int i = 0; i < 50 || (s.waits >> port & 1) == 0; ++i) s.obey();
      EXPECT_THROW(s.drive(s.waits & ~(1u << port), 7, s.shown), std::runtime_error) << "port " << port;
    }
  }
}

TEST(StreamCheck, FindsEveryBitOfABeatThatChanges) {
  for (uint64_t seed = 1; seed < 20; ++seed) {
    for (uint32_t bit = 0; bit < 4 * kBeats; ++bit) {
      const uint32_t here = kBeats == 1 ? 7 : 1u << bit / 4;
      Streams s(seed);
      for (int i = 0; i < 50 || (s.waits & here) == 0; ++i) s.obey();
      EXPECT_THROW(s.drive(7, 7, s.shown ^ 1u << bit), std::runtime_error) << "bit " << bit;
    }
  }
}

}  // namespace
}  // namespace pipegs
