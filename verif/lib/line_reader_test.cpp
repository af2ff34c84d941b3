// SPDX-License-Identifier: Apache-2.0
// line_reader_test: rtl/lib/pipegs_line_reader.sv against a queue of jobs. (pu_fetch_test and dopu_test drive it, too.)
#include "Vpipegs_line_reader.h"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

// Feeds jobs and collects items; every item holds its own number, so a wrong one shows.
struct Jobs : Endpoint {
  struct Job {
    bool read;
    uint32_t first, count, tag;
  };
  Bench<Vpipegs_line_reader>& bench;
  Pace source, sink;
  std::deque<Job> jobs;
  std::deque<std::array<uint32_t, 3>> expected;  // tag, item, is an item
  bool up = false;
  size_t items = 0;
  std::vector<uint64_t> cycles;

  Jobs(Bench<Vpipegs_line_reader>& b, Pace source, Pace sink) : bench(b), source(source), sink(sink) { b.add(*this); }
  void push(const Job& job) {
    jobs.push_back(job);
    if (!job.read) expected.push_back({job.tag, 0, 0});
    for (uint32_t i = 0; job.read && i < job.count; ++i) expected.push_back({job.tag, job.first + i, 1});
  }
  void drive() override {
    auto& d = bench.dut;
    if (!up && !jobs.empty() && goes(source, bench.rng)) up = true;
    d.job_valid_i = up;
    if (up) {
      d.job_read_i = jobs.front().read;
      d.job_first_i = jobs.front().first;
      d.job_count_i = jobs.front().count;
      d.job_tag_i = static_cast<CData>(jobs.front().tag);
    }
    d.out_ready_i = goes(sink, bench.rng);
  }
  void observe() override {
    auto& d = bench.dut;
    if (up && d.job_ready_o) {
      jobs.pop_front();
      up = false;
    }
    if (!d.out_valid_o || !d.out_ready_i) return;
    ASSERT_FALSE(expected.empty()) << "a beat too many, cycle " << bench.cycle;
    const auto [tag, item, is_item] = expected.front();
    ASSERT_EQ(d.out_tag_o, tag) << "beat " << items << ", cycle " << bench.cycle;
    ASSERT_EQ(d.out_read_o, is_item) << "beat " << items << ", cycle " << bench.cycle;
    if (is_item) {
      ASSERT_EQ(d.out_index_o, item) << "beat " << items << ", cycle " << bench.cycle;
      ASSERT_EQ(d.out_item_o.m_storage[0], item * 7 + 1) << "beat " << items << ", cycle " << bench.cycle;
    }
    expected.pop_front();
    ++items;
    cycles.push_back(bench.cycle);
  }
};

void run(Pace source, Pace sink, Pace memory_pace, const ExternalMemoryOptions& options, int jobs, uint32_t largest,
         bool full_rate) {
  Bench<Vpipegs_line_reader> bench;
  auto& dut = bench.dut;
  ExternalMemory memory(options);
  constexpr uint64_t kBase = 77;
  for (uint32_t item = 0; item < 1200; ++item) memory.line(kBase + item / 2)[item % 2 * 8] = item * 7 + 1;
  write_record(test_config(), dut.table_i, Span{kBase, 600});
  Jobs ends(bench, source, sink);
  MemoryEndpoint<QData, VlWide<16>> port(bench, memory, dut.mem_valid_o, dut.mem_ready_i, nullptr, dut.mem_address_o,
                                         nullptr, dut.rsp_valid_i, dut.rsp_data_i, memory_pace, &dut.mem_lines_o);
  bench.reset();
  uint64_t groups = 0;  // of eight lines, in which the lines of a job lie
  for (int i = 0; i < jobs; ++i) {
    const uint32_t first = static_cast<uint32_t>(bench.rng() % 1000);
    ends.push({full_rate || bench.rng() % 4 != 0, full_rate ? first & ~1u : first,
               full_rate ? largest : 1 + static_cast<uint32_t>(bench.rng() % largest),
               static_cast<uint32_t>(bench.rng() % 256)});
    const Jobs::Job& job = ends.jobs.back();
    if (job.read) groups += (kBase + (job.first + job.count - 1) / 2) / 8 - (kBase + job.first / 2) / 8 + 1;
  }
  ASSERT_TRUE(bench.run_until([&] { return ends.expected.empty(); }));
  for (int i = 0; i < 100; ++i) bench.step();
  EXPECT_EQ(dut.idle_o, 1);
  EXPECT_EQ(port.requests, groups);
  if (full_rate) { EXPECT_EQ(ends.cycles.back() - ends.cycles.front(), ends.items - 1); }
}

TEST(LineReader, SendsEveryItemInOrderAtEveryPace) {
  for (const Pace source : kPaces) {
    for (const Pace sink : kPaces) {
      for (const Pace memory : kPaces) {
        run(source, sink, memory, {.latency = 30, .jitter = 20}, 60, 40, false);
        run(source, sink, memory, {.latency = 3}, 60, 3, false);  // odd starts, single items, markers side by side
      }
    }
  }
}

// Jobs before a bad one are complete; it, and what comes behind it, asks for nothing.
TEST(LineReader, StopsAtAJobThatTheTableDoesNotHold) {
  constexpr uint64_t kBase = 77, kLines = 20;  // 40 items
  struct Bad {
    uint32_t first, count;
  };
  for (const Bad bad : {Bad{3, 0}, Bad{40, 1}, Bad{39, 2}, Bad{0, 41}, Bad{0xffffff, 5}, Bad{0xfffffe, 0xfffff}}) {
    for (const Pace pace : kPaces) {
      Bench<Vpipegs_line_reader> bench;
      auto& dut = bench.dut;
      ExternalMemory memory({.latency = 10});
      for (uint32_t item = 0; item < 40; ++item) memory.line(kBase + item / 2)[item % 2 * 8] = item * 7 + 1;
      memory.set_lines(kBase + kLines);
      write_record(test_config(), dut.table_i, Span{kBase, kLines});
      Jobs ends(bench, pace, pace);
      MemoryEndpoint<QData, VlWide<16>> port(bench, memory, dut.mem_valid_o, dut.mem_ready_i, nullptr,
                                             dut.mem_address_o, nullptr, dut.rsp_valid_i, dut.rsp_data_i, pace,
                                             &dut.mem_lines_o);
      bench.reset();
      ends.push({true, 0, 40, 1});  // all of the table is good
      ends.push({true, 39, 1, 2});
      ASSERT_TRUE(bench.run_until([&] { return ends.expected.empty(); }));
      EXPECT_EQ(dut.bad_o, 0);
      ends.jobs.push_back({true, bad.first, bad.count, 3});
      ends.jobs.push_back({true, 0, 4, 4});
      for (int i = 0; i < 300; ++i) bench.step();
      ASSERT_EQ(dut.bad_o, 1) << "first " << bad.first << ", count " << bad.count;
      EXPECT_EQ(dut.bad_line_o, kBase + bad.first / 2);
      EXPECT_EQ(ends.jobs.size(), 1u) << "a job was taken behind the bad one";
      EXPECT_EQ(port.requests, 5u);  // four groups of eight lines hold the table, one its last line
    }
  }
}

TEST(LineReader, SendsOneItemPerCycle) {
  run(Pace::kAlways, Pace::kAlways, Pace::kAlways, {.latency = 20, .bytes_per_cycle = 64}, 40, 32, true);
}

}  // namespace
}  // namespace pipegs
