// SPDX-License-Identifier: Apache-2.0
// pu_project_test: rtl/pu/project/pu_project.sv against its bit-accurate model, and the model against double
// precision.
#include "cpp_model/pu/project/pu_project.hpp"

#include "Vpu_project.h"
#include "verif/pu/pu_stage.hpp"

namespace pipegs {

std::string to_text(const Config& config, const ProjectedParts& parts) {
  return to_text(config, parts.projected) + " " + to_text(config, parts.center) + " " + to_text(config, parts.payload);
}
std::string first_difference(const Config& config, const ProjectedParts& expected, const ProjectedParts& found) {
  return first_difference(config, expected.projected, found.projected) +
         first_difference(config, expected.center, found.center) +
         first_difference(config, expected.payload, found.payload);
}

namespace {

// Beside the records, which may wait, centres and payloads leave that are never refused.
struct Stage {
  using Dut = Vpu_project;
  using Input = Visible;
  using Output = ProjectedParts;
  template <class R, class Port>
  struct Beside {
    Beside(Bench<Dut>& b, const Config& c, const CData& valid, const Port& port) : sink(b, c, valid, ready, port) {}
    CData ready = 0;
    RecordSink<R, Port> sink;
  };
  class Sink {
   public:
    Sink(Bench<Dut>& b, const Config& c, Pace pace)
        : centers_(b, c, b.dut.center_valid_o, b.dut.center_o),
          payloads_(b, c, b.dut.payload_valid_o, b.dut.payload_o),
          projected_(b, c, b.dut.projected_valid_o, b.dut.projected_ready_i, b.dut.projected_o, pace),
          cycles(projected_.cycles) {}
    size_t size() const { return projected_.size(); }
    ProjectedParts at(size_t i) const {
      ProjectedParts parts;
      parts.projected = projected_.at(i);
      if (parts.projected.kind != kData) return parts;
      size_t number = 0;  // of the Gaussian
      for (size_t k = 0; k < i; ++k) number += projected_.at(k).kind == kData;
      parts.center = centers_.sink.at(number), parts.payload = payloads_.sink.at(number);
      EXPECT_LE(centers_.sink.cycles[number], projected_.cycles[i]) << "a centre comes behind its record";
      EXPECT_LT(payloads_.sink.cycles[number], projected_.cycles[i]) << "a payload comes behind its record";
      return parts;
    }

   private:
    Beside<Center, std::remove_reference_t<decltype(Dut::center_o)>> centers_;
    Beside<Payload, std::remove_reference_t<decltype(Dut::payload_o)>> payloads_;
    RecordSink<Projected, std::remove_reference_t<decltype(Dut::projected_o)>> projected_;

   public:
    const std::vector<uint64_t>& cycles;
  };
  static auto source(Bench<Dut>& b, const Config& c, Pace pace) {
    return RecordSource<Visible, std::remove_reference_t<decltype(b.dut.visible_i)>>(
        b, c, b.dut.visible_valid_i, b.dut.visible_ready_o, b.dut.visible_i, pace);
  }
  static auto sink(Bench<Dut>& b, const Config& c, Pace pace) { return Sink(b, c, pace); }
};

Visible make(PuRandom& random, const Frame& frame) {
  Visible v = random.visible(frame);
  const int64_t low = -(int64_t{1} << (random.config.view_w - 1));
  if (random.chance(10)) v.view_x = random.chance(2) ? low : -1 - low;
  if (random.chance(10)) v.view_y = random.chance(2) ? low : 0;
  if (random.chance(10))
    v.view_z = random.chance(3)   ? 1
               : random.chance(2) ? -1 - low
                                  : int64_t{1} << random.integer(0, random.config.view_w - 2);
  if (random.chance(20)) v.view_exp = 63;
  return v;
}
ProjectedParts model(const Config& config, const Frame& frame, const Visible& visible) {
  return pu_project(config, frame, visible);
}

TEST(PuProject, EqualsItsModelAtEveryPace) { check_every_pace<Stage>(stage_run<Stage>(make, model)); }

TEST(PuProject, TakesARecordEveryEightCycles) { check_pace<Stage>(stage_run<Stage>(make, model), 13); }

TEST(PuProject, ModelIsPreciseAgainstDouble) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  PuRandom random{config, rng};
  const auto real = [](auto m, int64_t e) { return std::ldexp(static_cast<double>(m), static_cast<int>(e)); };
  const double edge = real(1, config.mean_w() - 1 - config.mean_f);  // of a mean's range
  double inverse = 0, tangent = 0, near = 0, far = 0, turn = 0;
  for (int i = 0; i < 100000; ++i) {
    const Frame f = random.frame();
    const Visible v = random.visible(f);
    ProjectCounts counts;
    const auto [p, center, payload] = pu_project(config, f, v, &counts);
    const double x = static_cast<double>(v.view_x), y = static_cast<double>(v.view_y),
                 z = static_cast<double>(v.view_z);
    inverse =
        std::max(inverse, std::abs(real(p.inv_z_m, p.inv_z_e) * real(v.view_z, static_cast<int64_t>(v.view_exp)) - 1));
    const double limit = config.guard_band ? real(f.lens.limit_x, -config.tan_f) : 16;
    tangent = std::max(tangent, std::abs(std::clamp(x / z, -limit, limit) - real(p.tan_x, -config.tan_f)));
    const double centered = real(f.lens.focal_x, -config.focal_f()) * x / z;
    const double mean =
        centered + real(f.lens.center_x, -config.center_f()) - static_cast<double>(v.window_x) * config.window;
    if (std::abs(mean) < edge - 1 && counts.saturated == 0) {
      const double error = std::abs(mean - real(center.mean_x, -config.mean_f));
      near = std::abs(centered) < 4096 ? std::max(near, error) : near;
      far = std::abs(centered) < 4096 ? far : std::max(far, error / std::abs(centered));
    } else if (std::abs(mean) > edge + 1) {
      EXPECT_EQ(counts.saturated, 1u) << to_text(config, v);
    }
    const double a[3] = {x, y, z}, b[3] = {real(payload.dir_x, 0), real(payload.dir_y, 0), real(payload.dir_z, 0)};
    const double cross = std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
    turn = std::max(turn, cross / (std::hypot(x, y, z) * std::hypot(b[0], b[1], b[2])));
  }
  std::printf(
      "pu_project: 1/z 2^%.2f relative; tan 2^%.2f; mean 2^%.2f px within 4096 px, 2^%.2f relative beyond; direction "
      "2^%.1f rad\n",
      std::log2(inverse), std::log2(tangent), std::log2(near), std::log2(far), std::log2(turn));
  if (config.mantissa_w < 26 || config.view_w < 28) return;  // the bounds are those of the default widths
  EXPECT_LT(inverse, std::ldexp(1.0, -25));
  EXPECT_LT(tangent,
            std::ldexp(config.guard_band ? 1.1 : 2, -config.tan_f));  // up to 16 the relative error of 1/z counts
  EXPECT_LT(near, std::ldexp(1.0, -10));
  EXPECT_LT(far, std::ldexp(1.0, -24) + std::ldexp(1.0, -config.mean_f - 12));
  EXPECT_LT(turn, std::ldexp(1.0, -15));
}

TEST(PuProject, TheDepthKeyOrdersByDepth) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  PuRandom random{config, rng};
  const Frame f = random.frame();
  for (int i = 0; i < 20000; ++i) {
    Visible v = random.visible(f), w = random.visible(f);
    if (random.chance(2)) w.view_z = v.view_z + random.integer(0, 1), w.view_exp = v.view_exp;
    if (w.view_z >= int64_t{1} << (config.view_w - 1)) continue;
    const double dv = std::ldexp(static_cast<double>(v.view_z), static_cast<int>(v.view_exp));
    const double dw = std::ldexp(static_cast<double>(w.view_z), static_cast<int>(w.view_exp));
    const uint64_t kv = pu_project(config, f, v).payload.depth, kw = pu_project(config, f, w).payload.depth;
    if (dv < dw) { ASSERT_LE(kv, kw); }
    if (dv == dw) { ASSERT_EQ(kv, kw) << "the same depth in two units"; }
    if (dv > dw) { ASSERT_GE(kv, kw); }
  }
}

}  // namespace
}  // namespace pipegs
