// SPDX-License-Identifier: Apache-2.0
// ru_fetch_test: rtl/ru/ru_fetch.sv against a queue of records and lines. Without Overflow every line lies in a store,
// or an assertion says so.
#include "verif/ru/alpha_lines.hpp"
#include "verif/support/config.hpp"
#include "verif/support/frame_ports.hpp"
#include "Vru_fetch.h"

namespace pipegs {
namespace {

const Config kConfig = test_config();
using LinePort = std::remove_reference_t<decltype(Vru_fetch::rsp_data_i)>;
constexpr uint64_t kOverflow = 0x12345;

// Takes blend_t and the line beside it.
class LineSink : public Endpoint {
 public:
  LineSink(Bench<Vru_fetch>& bench, Pace pace) : bench_(bench), pace_(pace) {
    bench.dut.out_ready_i = 0;
    bench.add(*this);
  }
  void drive() override { bench_.dut.out_ready_i = !closed && goes(pace_, bench_.rng); }
  void observe() override {
    auto& dut = bench_.dut;
    if (shown_) { EXPECT_TRUE(dut.out_valid_o) << "valid fell, cycle " << bench_.cycle; }
    shown_ = dut.out_valid_o && !dut.out_ready_i;
    if (!dut.out_valid_o || !dut.out_ready_i) return;
    records.push_back(read_record<Blend>(kConfig, dut.out_o));
    Words words(port_words<decltype(dut.out_line_o)>() + 1);
    read_port(dut.out_line_o, words.data());
    Codes codes;
    for (int i = 0; i < kRegionPixels; ++i)
      codes[i] = static_cast<uint16_t>(get_bits(words.data(), i * kConfig.alpha_w, kConfig.alpha_w));
    lines.push_back(codes);
    cycles.push_back(bench_.cycle);
  }
  std::vector<Blend> records;
  std::vector<Codes> lines;
  std::vector<uint64_t> cycles;
  bool closed = false;

 private:
  Bench<Vru_fetch>& bench_;
  Pace pace_;
  bool shown_ = false;
};

struct FetchRun {
  FetchRun(Pace in_pace, Pace out_pace, Pace store_pace, Pace memory_pace, ExternalMemoryOptions options)
      : memory(options),
        in(bench, kConfig, bench.dut.in_valid_i, bench.dut.in_ready_o, bench.dut.in_i, in_pace),
        out(bench, out_pace),
        stores(bench, kConfig, store_pace),
        port(bench, memory, bench.dut.mem_valid_o, bench.dut.mem_ready_i, nullptr, bench.dut.mem_address_o,
             static_cast<const LinePort*>(nullptr), bench.dut.rsp_valid_i, bench.dut.rsp_data_i, memory_pace) {
    frame.tables.overflow = kOverflow;
    write_frame(kConfig, bench.dut, frame);
    bench.reset();
    bench.step();
  }
  void send(uint64_t kind, bool ext, bool skip = false) {
    Fetch fetch = random_record<Fetch>(kConfig, bench.rng);
    fetch.kind = kind;
    fetch.ext = ext;
    fetch.skip = skip;
    fetch.unit %= kConfig.units;
    fetch.address = next++;
    if (ext) fetch.address |= bench.rng() % 2 << ru_number_w(kConfig);
    const Codes codes = random_codes(kConfig, bench.rng, 1);
    if (kind == kData && ext && kConfig.overflow) {
      store_line(kConfig, memory, ru_overflow_line(kConfig, wide_overflow(frame), fetch.unit, fetch.address), codes);
    } else if (kind == kData) {
      stores.lines[{static_cast<int>(fetch.unit), fetch.address}] = codes;
    }
    in.push(fetch);
    if (kind == kData && skip) return;
    sent.push_back(fetch);
    lines.push_back(codes);
  }
  void compare() {
    bench.run_until([&] { return in.empty() && out.records.size() == sent.size(); });
    ASSERT_EQ(out.records.size(), sent.size());
    for (size_t i = 0; i < sent.size(); ++i) {
      const Blend& found = out.records[i];
      ASSERT_EQ(found.kind, sent[i].kind) << "beat " << i << " seed " << bench.seed;
      if (found.kind != kData) continue;
      const Blend expected{.kind = 0,
                           .region = sent[i].region,
                           .ext = sent[i].ext,
                           .red = sent[i].red,
                           .green = sent[i].green,
                           .blue = sent[i].blue,
                           .index = sent[i].index};
      ASSERT_EQ(first_difference(kConfig, expected, found), "") << "beat " << i << " seed " << bench.seed;
      ASSERT_EQ(out.lines[i], lines[i]) << "beat " << i << (sent[i].ext ? " external" : " local") << " seed "
                                        << bench.seed;
    }
    EXPECT_TRUE(bench.dut.idle_o);
    EXPECT_TRUE(stores.lines.empty()) << "lines were not freed";
  }

  Bench<Vru_fetch> bench;
  ExternalMemory memory;
  RecordSource<Fetch, decltype(Vru_fetch::in_i)> in;
  LineSink out;
  AlphaStores<Vru_fetch> stores;
  MemoryEndpoint<QData, LinePort> port;
  Frame frame;
  uint64_t next = 100;
  std::vector<Fetch> sent;
  std::vector<Codes> lines;
};

TEST(RuFetch, LinesLeaveInOrderAtEveryPace) {
  for (const Pace in_pace : kPaces) {
    for (const Pace out_pace : kPaces) {
      FetchRun run(in_pace, out_pace, Pace::kCoin, Pace::kCoin, {.latency = 30, .jitter = 20});
      for (int i = 0; i < 600; ++i) {
        const uint64_t dice = run.bench.rng() % 16;
        const bool ext = kConfig.overflow && ((i / 40) % 3 == 0 ? run.bench.rng() % 2 : (i / 40) % 3 == 1);
        run.send(dice == 0 ? kWindowEnd : dice < 3 ? kLayerEnd : kData, ext, !ext && run.bench.rng() % 4 == 0);
      }
      run.compare();
      EXPECT_GT(run.stores.skipped, 0u);
      EXPECT_EQ(run.port.requests > 0, kConfig.overflow != 0);
    }
  }
}

// Lines that are skipped need neither room for an answer nor a place in the queue of records.
TEST(RuFetch, ALineIsSkippedWhileTheLanesStandStill) {
  FetchRun run(Pace::kAlways, Pace::kAlways, Pace::kAlways, Pace::kAlways, {});
  run.out.closed = true;
  for (int i = 0; i < Config::ru_local_lines(); ++i) run.send(kData, false);
  for (int i = 0; i < 2 * kConfig.ru_records(); ++i) run.send(kData, false, true);
  run.bench.run_until([&] { return run.in.empty() && run.stores.lines.empty(); });
  EXPECT_TRUE(run.stores.lines.empty());
  EXPECT_EQ(run.out.records.size(), 0u);
}

TEST(RuFetch, LocalLinesComeOnePerCycle) {
  FetchRun run(Pace::kAlways, Pace::kAlways, Pace::kAlways, Pace::kAlways, {});
  for (int i = 0; i < 100; ++i) run.send(kData, false);
  run.compare();
  EXPECT_LE(run.out.cycles.back() - run.out.cycles.front(), 100u);
}

TEST(RuFetch, SaysSoWhenALineLiesInMemory) {
  if (kConfig.overflow) GTEST_SKIP() << "it comes from there";
  FetchRun run(Pace::kAlways, Pace::kAlways, Pace::kAlways, Pace::kAlways, {});
  for (const bool ext : {false, false, true}) run.send(kData, ext);
  EXPECT_THROW(run.compare(), std::runtime_error);
  EXPECT_EQ(run.in.taken, 3u);
}

TEST(RuFetch, ManyExternalLinesAreInFlight) {
  if (!kConfig.overflow) GTEST_SKIP() << "no line lies in memory";
  const int latency = 60;
  FetchRun run(Pace::kAlways, Pace::kAlways, Pace::kAlways, Pace::kAlways, {.latency = latency, .bytes_per_cycle = 64});
  const int lines = 10 * kConfig.fetch_lines;
  for (int i = 0; i < lines; ++i) run.send(kData, true);
  run.compare();
  const double per_line = double(run.out.cycles.back() - run.out.cycles.front()) / (lines - 1);
  std::printf("external lines: %.2f cycles each at a latency of %d\n", per_line, latency);
  EXPECT_LT(per_line, std::max<double>(kConfig.alpha_memory_lines(), (latency + 8.0) / kConfig.fetch_lines) * 1.1);
}

}  // namespace
}  // namespace pipegs
