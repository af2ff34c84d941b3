// SPDX-License-Identifier: Apache-2.0
// pu_color_fetch_test: rtl/pu/color/pu_color_fetch.sv against its bit-accurate model: three streams out of one, and the
// line of each job.
#include "cpp_model/pu/color/pu_color_fetch.hpp"

#include "Vpu_color_fetch.h"
#include "verif/pu/color/pu_color_support.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "verif/support/frame_ports.hpp"

namespace pipegs {
namespace {

const Config kConfig = test_config();
constexpr size_t kDepth = 32;  // the module's default

ColorJob random_job(std::mt19937_64& rng) {
  ColorJob job = random_record<ColorJob>(kConfig, rng);
  job.kind = rng() % 8 == 0 ? (rng() % 2 == 0 ? kLayerEnd : kWindowEnd) : kData;
  job.slot = rng() % 5000;
  return job;
}

struct Fetch {
  Fetch(int degree, Pace source_pace, Pace task_pace, Pace other_pace, const ExternalMemoryOptions& options)
      : memory(options),
        port(bench, memory, bench.dut.mem_valid_o, bench.dut.mem_ready_i, nullptr, bench.dut.mem_address_o,
             &bench.dut.line_o, bench.dut.rsp_valid_i, bench.dut.rsp_data_i, other_pace),
        in(bench, kConfig, bench.dut.job_valid_i, bench.dut.job_ready_o, bench.dut.job_i, source_pace),
        tasks(bench, kConfig, bench.dut.task_valid_o, bench.dut.task_ready_i, bench.dut.task_o, task_pace),
        directions(bench, kConfig, bench.dut.direction_valid_o, bench.dut.direction_ready_i, bench.dut.direction_o,
                   other_pace) {
    frame.tables.sh_degree = degree;
    frame.tables.colors = 12345;
    write_frame(kConfig, bench.dut, frame);
    bench.dut.line_ready_i = 0;
    bench.reset();
  }
  void fill() {
    for (const ColorJob& job : sent) {
      MemoryLine& line = memory.line(color_line(frame, job.slot));
      for (uint32_t& word : line)
        word = static_cast<uint32_t>(color_line(frame, job.slot) * 77 + (&word - line.data()));
    }
  }
  Bench<Vpu_color_fetch> bench;
  Frame frame;
  ExternalMemory memory;
  MemoryEndpoint<std::remove_reference_t<decltype(bench.dut.mem_address_o)>,
                 std::remove_reference_t<decltype(bench.dut.line_o)>>
      port;
  RecordSource<ColorJob, decltype(bench.dut.job_i)> in;
  RecordSink<ColorTask, decltype(bench.dut.task_o)> tasks;
  RecordSink<ViewDirection, decltype(bench.dut.direction_o)> directions;
  std::vector<ColorJob> sent;
};

// The consumer takes a line together with its task, as pu_color_sum does: `tasks` is held back until the line is here.
class LinesWithTasks : public Endpoint {
 public:
  explicit LinesWithTasks(Fetch& fetch) : fetch_(fetch) { fetch.bench.add(*this); }
  void drive() override {
    auto& dut = fetch_.bench.dut;
    dut.eval();
    const bool data = dut.task_valid_o && fetch_.frame.tables.sh_degree != 0 &&
                      read_record<ColorTask>(kConfig, dut.task_o).kind == kData;
    if (data && !dut.line_valid_o) dut.task_ready_i = 0;
    dut.line_ready_i = data && dut.task_ready_i;
  }
  void observe() override {
    auto& dut = fetch_.bench.dut;
    if (!dut.line_ready_i) return;
    Words words(17);
    read_port(dut.line_o, words.data());
    lines.push_back(words);
  }
  std::vector<Words> lines;

 private:
  Fetch& fetch_;
};

void run(int degree, Pace source_pace, Pace task_pace, Pace other_pace, const ExternalMemoryOptions& options) {
  Fetch fetch(degree, source_pace, task_pace, other_pace, options);
  LinesWithTasks lines(fetch);
  for (int i = 0; i < 400; ++i) fetch.in.push(fetch.sent.emplace_back(random_job(fetch.bench.rng)));
  fetch.fill();
  size_t data = 0;
  for (const ColorJob& job : fetch.sent) data += job.kind == kData && degree != 0;
  fetch.bench.run_until([&] { return fetch.tasks.size() == fetch.sent.size() && fetch.directions.size() == data; });
  ASSERT_EQ(fetch.port.requests, data);
  ASSERT_EQ(lines.lines.size(), data);
  size_t n = 0;
  for (size_t i = 0; i < fetch.sent.size(); ++i) {
    const ColorJob& job = fetch.sent[i];
    ASSERT_EQ(first_difference(kConfig, color_task(job), fetch.tasks.at(i)), "")
        << "job " << i << " seed " << fetch.bench.seed;
    if (job.kind != kData || degree == 0) continue;
    ASSERT_EQ(first_difference(kConfig, color_direction(job), fetch.directions.at(n)), "") << "job " << i;
    for (uint32_t w = 0; w < 16; ++w)
      ASSERT_EQ(lines.lines[n][w], color_line(fetch.frame, job.slot) * 77 + w) << "job " << i;
    ++n;
  }
  for (int i = 0; i < 3; ++i) fetch.bench.step();
  EXPECT_EQ(fetch.bench.dut.busy_o, 0);
}

// The last line of the table comes; the job behind it asks for nothing, nor does any later one.
TEST(PuColorFetch, StopsAtALineThatTheTableDoesNotHold) {
  for (int degree = 1; degree <= 3; ++degree) {
    Fetch fetch(degree, Pace::kAlways, Pace::kAlways, Pace::kAlways, {});
    LinesWithTasks lines(fetch);
    Areas areas = wide_areas();
    areas.colors = 50;
    write_frame(kConfig, fetch.bench.dut, fetch.frame, areas);
    const uint64_t slots = degree == 1 ? 200 : 50;
    for (const uint64_t slot : {uint64_t{0}, slots - 1, slots, uint64_t{3}}) {
      ColorJob job = random_job(fetch.bench.rng);
      job.kind = kData;
      job.slot = slot;
      fetch.in.push(fetch.sent.emplace_back(job));
    }
    for (int i = 0; i < 400; ++i) fetch.bench.step();
    EXPECT_EQ(fetch.port.requests, 2u);
    EXPECT_EQ(fetch.tasks.size(), 2u);
    EXPECT_EQ(fetch.bench.dut.bad_o, 1);
    EXPECT_EQ(fetch.bench.dut.bad_line_o, fetch.frame.tables.colors + 50);
  }
}

TEST(PuColorFetch, EqualsItsModelAtEveryPaceAndDegree) {
  for (int degree = 0; degree <= 3; ++degree) {
    for (const Pace source_pace : kPaces) {
      for (const Pace sink_pace : kPaces) {
        run(degree, source_pace, sink_pace, Pace::kCoin,
            {.latency = 30, .bytes_per_cycle = 32, .jitter = 20, .queue = 5});
      }
    }
  }
}

TEST(PuColorFetch, RoomForEveryAnswerWhenNobodyTakesAnything) {
  Fetch fetch(3, Pace::kAlways, Pace::kAlways, Pace::kAlways, {.latency = 2, .bytes_per_cycle = 64});
  fetch.bench.dut.task_ready_i = 0;
  for (size_t i = 0; i < 2 * kDepth; ++i) {
    ColorJob job = random_job(fetch.bench.rng);
    job.kind = kData;
    fetch.in.push(fetch.sent.emplace_back(job));
  }
  fetch.tasks.pace = Pace::kAlways;
  struct Closed : Endpoint {
    explicit Closed(Fetch& fetch) : fetch(fetch) { fetch.bench.add(*this); }
    void drive() override { fetch.bench.dut.task_ready_i = fetch.bench.dut.direction_ready_i = 0; }
    void observe() override {}
    Fetch& fetch;
  } closed(fetch);
  for (int i = 0; i < 300; ++i) fetch.bench.step();
  EXPECT_EQ(fetch.in.taken, kDepth);
  EXPECT_EQ(fetch.port.requests, kDepth);
}

TEST(PuColorFetch, TakesOneJobPerCycleWithoutAndEverySecondCycleWithSh) {
  for (const int degree : {0, 3}) {
    Fetch fetch(degree, Pace::kAlways, Pace::kAlways, Pace::kAlways, {.latency = 5, .bytes_per_cycle = 64});
    LinesWithTasks lines(fetch);
    for (int i = 0; i < 200; ++i) {
      ColorJob job = random_job(fetch.bench.rng);
      job.kind = kData;
      fetch.in.push(fetch.sent.emplace_back(job));
    }
    fetch.bench.run_until([&] { return fetch.tasks.size() == fetch.sent.size(); });
    EXPECT_EQ(fetch.tasks.cycles.back() - fetch.tasks.cycles.front(), degree == 0 ? 199u : 398u);
  }
}

}  // namespace
}  // namespace pipegs
