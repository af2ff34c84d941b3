// SPDX-License-Identifier: Apache-2.0
// pu_color_test: rtl/pu/color/pu_color.sv with an external memory against its bit-accurate model, and the model
// against double precision.
#include "cpp_model/pu/color/pu_color.hpp"

#include "Vpu_color.h"
#include "verif/pu/color/pu_color_support.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "verif/support/frame_ports.hpp"

namespace pipegs {
namespace {

const Config kConfig = test_config();
constexpr uint64_t kColors = 777;

ColorJob random_job(std::mt19937_64& rng) {
  ColorJob job = random_record<ColorJob>(kConfig, rng);
  const ViewDirection d = random_direction(kConfig, rng);
  job.dir_x = d.x, job.dir_y = d.y, job.dir_z = d.z;
  job.slot = rng() % 4096;
  job.kind = kData;
  return job;
}

// Coefficients like those of trained scenes: the largest of a Gaussian between 1/128 and 1/4.
TEST(PuColor, ModelIsCloseToDouble) {
  std::mt19937_64 rng(test_seed());
  double worst = 0, squares = 0;
  int channels = 0;
  for (int i = 0; i < 200000; ++i) {
    Frame frame{.tables = {.sh_degree = rng() % 4}};
    set_rotation(kConfig, frame, rng);
    ColorJob job = random_job(rng);
    const glm::dvec3 view(job.dir_x, job.dir_y, job.dir_z);
    if (glm::length(view) < 65536) continue;
    const auto line = random_line(kConfig, rng, 20, 25);
    const auto basis = sh_basis(glm::normalize(to_world(kConfig, frame, view)));
    const Colored colored = pu_color(kConfig, frame, job, line.data());
    const uint64_t found[3] = {colored.red, colored.green, colored.blue};
    const int64_t base[3] = {job.base_r, job.base_g, job.base_b};
    const int degree = color_degree(kConfig, frame), bands = (degree + 1) * (degree + 1) - 1;
    for (int c = 0; c < 3; ++c) {
      double exact = std::ldexp(base[c], 3 - kConfig.base_w);
      for (int k = 0; k < bands; ++k) exact += coefficient(kConfig, frame, line.data(), job.slot, k, c) * basis[k + 1];
      if (exact <= 0 || exact >= 3.99) continue;
      const double error = std::ldexp(static_cast<double>(found[c]), 2 - kConfig.color_w) - exact;
      worst = std::max(worst, std::abs(error));
      squares += error * error;
      ++channels;
    }
  }
  const double rms = std::sqrt(squares / channels);
  std::printf("pu_color: worst error 2^%.2f, rms 2^%.2f, without channels below 0\n", std::log2(worst), std::log2(rms));
  EXPECT_LT(worst, std::ldexp(1.0, 2 - kConfig.color_w) / 2 * 1.25 + std::exp2(-12));
  if (kConfig.color_w == 12) { EXPECT_LT(rms, std::exp2(-11.5)); }
}

TEST(PuColor, AZeroDirectionGivesAColourWithoutPoison) {
  ColorJob job;
  std::array<uint32_t, 16> line{};
  job.base_r = int64_t{1} << (kConfig.base_w - 3);
  const Colored colored = pu_color(kConfig, Frame{.tables = {.sh_degree = 3}}, job, line.data());
  EXPECT_EQ(colored.red, uint64_t{1} << (kConfig.color_w - 2));
}

struct Fixture {
  Fixture(uint64_t degree, Pace source_pace, Pace sink_pace, Pace memory_pace, const ExternalMemoryOptions& options)
      : memory(options),
        port(bench, memory, bench.dut.mem_valid_o, bench.dut.mem_ready_i, nullptr, bench.dut.mem_address_o, nullptr,
             bench.dut.rsp_valid_i, bench.dut.rsp_data_i, memory_pace),
        in(bench, kConfig, bench.dut.job_valid_i, bench.dut.job_ready_o, bench.dut.job_i, source_pace),
        out(bench, kConfig, bench.dut.colored_valid_o, bench.dut.colored_ready_i, bench.dut.colored_o, sink_pace) {
    set_rotation(kConfig, frame, bench.rng);
    frame.tables.sh_degree = degree;
    frame.tables.colors = kColors;
    write_frame(kConfig, bench.dut, frame);
    port.halves = &bench.dut.mem_halves_o;
    for (uint64_t slot = 0; slot < 4096; ++slot)
      memory.line(kColors + slot) =
          slot % 2 == 0 ? random_line(kConfig, bench.rng) : random_line(kConfig, bench.rng, 14, 27);
    bench.reset();
  }
  void push(const ColorJob& job) {
    in.push(job);
    expected.push_back(pu_color(kConfig, frame, job, memory.line(color_line(kConfig, frame, job.slot)).data()));
  }
  void check() {
    bench.run_until([&] { return out.size() == expected.size(); });
    for (size_t i = 0; i < out.size(); ++i) {
      ASSERT_EQ(first_difference(kConfig, expected[i], out.at(i)), "")
          << "degree " << frame.tables.sh_degree << " splat " << i << " cycle " << out.cycles[i] << " seed "
          << bench.seed;
    }
    for (int i = 0; i < 3; ++i) bench.step();
    EXPECT_EQ(bench.dut.busy_o, 0);
  }
  uint64_t pace() const { return (out.cycles.back() - out.cycles.front() + (out.size() - 1) / 2) / (out.size() - 1); }

  Bench<Vpu_color> bench;
  Frame frame;
  ExternalMemory memory;
  MemoryEndpoint<std::remove_reference_t<decltype(bench.dut.mem_address_o)>,
                 std::remove_reference_t<decltype(bench.dut.rsp_data_i)>>
      port;
  RecordSource<ColorJob, decltype(bench.dut.job_i)> in;
  RecordSink<Colored, decltype(bench.dut.colored_o)> out;
  std::vector<Colored> expected;
};

TEST(PuColor, EqualsItsModelAtEveryPaceAndDegree) {
  for (uint64_t degree = 0; degree <= 3; ++degree) {
    for (const Pace source_pace : kPaces) {
      for (const Pace sink_pace : kPaces) {
        Fixture setup(degree, source_pace, sink_pace, Pace::kCoin,
                      {.latency = 40, .bytes_per_cycle = 20, .jitter = 30, .queue = 8});
        for (int i = 0; i < 250; ++i) {
          ColorJob job = random_job(setup.bench.rng);
          if (setup.bench.rng() % 10 == 0) job.kind = setup.bench.rng() % 2 == 0 ? kLayerEnd : kWindowEnd;
          setup.push(job);
        }
        setup.check();
      }
    }
  }
}

// The last line of the table comes; the job behind it asks for nothing, nor does any later one.
TEST(PuColor, StopsAtALineThatTheTableDoesNotHold) {
  for (uint64_t degree = 1; degree <= 3 && kConfig.sh_degree > 0; ++degree) {
    Fixture setup(degree, Pace::kAlways, Pace::kAlways, Pace::kAlways, {});
    Areas areas = wide_areas();
    areas.colors = 50;
    write_frame(kConfig, setup.bench.dut, setup.frame, areas);
    const auto slots = 50 * static_cast<uint64_t>(color_slots_per_line(kConfig, static_cast<int>(degree)));
    for (const uint64_t slot : {uint64_t{0}, slots - 1, slots, uint64_t{3}}) {
      ColorJob job = random_job(setup.bench.rng);
      job.slot = slot;
      setup.push(job);
    }
    for (int i = 0; i < 400; ++i) setup.bench.step();
    EXPECT_EQ(setup.port.requests, 2u);
    EXPECT_EQ(setup.out.size(), 2u);
    EXPECT_EQ(setup.bench.dut.bad_o, 1);
    EXPECT_EQ(setup.bench.dut.bad_line_o, kColors + 50);
  }
}

TEST(PuColor, AsksForOneLinePerGaussianAndForNoneWithoutSh) {
  for (uint64_t degree = 0; degree <= 3; ++degree) {
    Fixture setup(degree, Pace::kAlways, Pace::kAlways, Pace::kAlways, {});
    for (int i = 0; i < 50; ++i) {
      ColorJob job = random_job(setup.bench.rng);
      if (i % 10 == 9) job.kind = kLayerEnd;
      setup.push(job);
    }
    setup.check();
    EXPECT_EQ(setup.port.requests, degree == 0 || kConfig.sh_degree == 0 ? 0u : 45u);
    EXPECT_EQ(setup.memory.traffic()[0].halves_read, setup.port.requests * (kConfig.coded() ? 1 : 2));
  }
}

// With the latency of the default memory.
TEST(PuColor, ReachesItsPace) {
  const uint64_t paces[] = {2, 7, 7, 8};
  for (uint64_t degree = 0; degree <= 3; ++degree) {
    Fixture setup(degree, Pace::kAlways, Pace::kAlways, Pace::kAlways, {.latency = 150});
    for (int i = 0; i < 300; ++i) setup.push(random_job(setup.bench.rng));
    setup.check();
    EXPECT_EQ(setup.pace(), paces[std::min<uint64_t>(degree, kConfig.sh_degree)]) << "degree " << degree;
    std::printf("pu_color degree %d: %llu cycles per Gaussian, first after %llu\n", static_cast<int>(degree),
                static_cast<unsigned long long>(setup.pace()),
                static_cast<unsigned long long>(setup.out.cycles.front()));
  }
}

TEST(PuColor, SaysThatItWaitsForMemoryAndIsBusyMeanwhile) {
  if (kConfig.sh_degree == 0) GTEST_SKIP() << "no memory without SH";
  Fixture setup(3, Pace::kAlways, Pace::kAlways, Pace::kAlways, {.latency = 200});
  EXPECT_EQ(setup.bench.dut.busy_o, 0);
  setup.push(random_job(setup.bench.rng));
  for (int i = 0; i < 100; ++i) setup.bench.step();
  EXPECT_EQ(setup.bench.dut.waiting_memory_o, 1);
  EXPECT_EQ(setup.bench.dut.busy_o, 1);
  setup.check();
  for (int i = 0; i < 20; ++i) setup.push({.kind = kLayerEnd});
  for (int i = 0; i < 60; ++i) {
    EXPECT_EQ(setup.bench.dut.waiting_memory_o, 0) << "an end needs no line";
    setup.bench.step();
  }
}

}  // namespace
}  // namespace pipegs
