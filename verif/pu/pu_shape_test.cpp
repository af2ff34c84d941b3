// SPDX-License-Identifier: Apache-2.0
// pu_shape_test: rtl/pu/pu_shape.sv, all stages from a visible Gaussian to its conic, against their bit-accurate
// models: records in order at every pair of paces, and the pace itself.
//
// The models are held against double precision in projection_models_test, box_models_test and pu_conic_test.
#include "Vpu_shape.h"
#include "cpp_model/golden.hpp"
#include "cpp_model/pu/stages.hpp"
#include "verif/pu/pu_stage.hpp"

namespace pipegs {

struct Shaped {
  Conic conic;
  Payload payload;
  bool operator==(const Shaped&) const = default;
};
std::string to_text(const Config& config, const Shaped& shaped) {
  return to_text(config, shaped.conic) + " " + to_text(config, shaped.payload);
}
std::string first_difference(const Config& config, const Shaped& expected, const Shaped& found) {
  return first_difference(config, expected.conic, found.conic) +
         first_difference(config, expected.payload, found.payload);
}

namespace {

// Beside the conics, which may wait, payloads leave that are never refused.
struct Stage {
  using Dut = Vpu_shape;
  using Input = Visible;
  using Output = Shaped;
  class Sink {
   public:
    Sink(Bench<Dut>& b, const Config& c, Pace pace)
        : payloads_(b, c, b.dut.payload_valid_o, ready_, b.dut.payload_o),
          conics_(b, c, b.dut.conic_valid_o, b.dut.conic_ready_i, b.dut.conic_o, pace),
          cycles(conics_.cycles) {}
    size_t size() const { return conics_.size(); }
    Shaped at(size_t i) const {
      Shaped shaped{conics_.at(i), {}};
      if (shaped.conic.kind != kData) return shaped;
      size_t number = 0;  // of the Gaussian
      for (size_t k = 0; k < i; ++k) number += conics_.at(k).kind == kData;
      EXPECT_LT(payloads_.cycles.at(number), conics_.cycles[i]) << "a payload comes behind its record";
      shaped.payload = payloads_.at(number);
      return shaped;
    }

   private:
    CData ready_ = 0;
    RecordSink<Payload, std::remove_reference_t<decltype(Dut::payload_o)>> payloads_;
    RecordSink<Conic, std::remove_reference_t<decltype(Dut::conic_o)>> conics_;

   public:
    const std::vector<uint64_t>& cycles;
  };
  static auto source(Bench<Dut>& b, const Config& c, Pace pace) {
    return RecordSource<Visible, std::remove_reference_t<decltype(b.dut.visible_i)>>(
        b, c, b.dut.visible_valid_i, b.dut.visible_ready_o, b.dut.visible_i, pace);
  }
  static auto sink(Bench<Dut>& b, const Config& c, Pace pace) { return Sink(b, c, pace); }
};

// Any visible Gaussian; now and then with what hurts one of the stages.
Visible make(PuRandom& random, const Frame& frame) {
  const Config& config = random.config;
  Visible v = random.visible(frame);
  const int64_t low = -(int64_t{1} << (config.view_w - 1)), one = int64_t{1} << (config.quat_w - 1);
  if (random.chance(10)) v.view_x = random.chance(2) ? low : -1 - low;
  if (random.chance(10)) v.view_y = random.chance(2) ? low : 0;
  if (random.chance(10))
    v.view_z = random.chance(3) ? 1 : random.chance(2) ? -1 - low : int64_t{1} << random.integer(0, config.view_w - 2);
  if (random.chance(20)) v.view_exp = 63;
  if (random.chance(12)) v.qw = v.qx = v.qy = v.qz = -one;  // length 2: saturates
  if (random.chance(10)) {                                  // exact axes: zeros, and sums that cancel to nothing
    v.qw = v.qx = v.qy = v.qz = 0;
    *std::array{&v.qw, &v.qx, &v.qy, &v.qz}[random.rng() % 4] = random.chance(2) ? -one : one - 1;
  }
  if (random.chance(10)) *std::array{&v.scale_0, &v.scale_1, &v.scale_2}[random.rng() % 3] = 0;
  if (random.chance(20)) v.scale_0 = v.scale_1 = v.scale_2 = 0;               // the dilation alone: round
  if (random.chance(20)) v.scale_0 = v.scale_1 = v.scale_2 = random.scale();  // round before perspective
  if (random.chance(8)) {  // turned by 45 degrees, or nearly so, about the axis of view: both variances alike
    v.view_x = v.view_y = v.qx = v.qy = 0;
    v.qw = std::llround(static_cast<double>(one) * std::cos(M_PI / 8)) + random.integer(-3, 3);
    v.qz = std::llround(static_cast<double>(one) * std::sin(M_PI / 8)) + random.integer(-3, 3);
  }
  return v;
}

// Of the frames some are without rotation, and half are of a scene that asks for compensation. One beat in ten is an
// end if there are some.
StageRun<Stage> shape_run(PuRandom& random, int count, bool ends) {
  StageRun<Stage> run;
  run.frame = random.frame();
  if (random.config.antialias) run.frame.tables.antialias = random.rng() % 2;
  if (random.chance(4)) {
    run.frame.camera = {};
    run.frame.lens.focal_y = run.frame.lens.focal_x;
    run.frame.camera.quaternion.w = int64_t{1} << (random.config.cam_quat_w() - 2);
  }
  for (int i = 0; i < count; ++i) {
    run.inputs.push_back(make(random, run.frame));
    if (!ends || !random.chance(10)) continue;
    run.inputs.push_back(random_record<Visible>(random.config, random.rng));
    run.inputs.back().kind = random.chance(3) ? kWindowEnd : kLayerEnd;
  }
  for (const Visible& in : run.inputs) {
    const auto [conic, payload] = golden_conic(random.config, run.frame, in);
    run.expected.push_back({conic, payload});
  }
  return run;
}

TEST(PuShape, EqualsItsModelsAtEveryPace) {
  check_every_pace<Stage>([](PuRandom& random, int count) { return shape_run(random, 3 * count, true); });
}

// With the cycles of each stage that the timing model takes, too. pu_conic of eight cycles, which is not in the table,
// leaves a record at its source for the first phases of its turn: right in front of it pu_box, whose last result comes
// late, takes one every fourteen.
TEST(PuShape, TakesARecordAtItsPaceOrAsPuBoxDoes) {
  const Config config = test_config();
  uint64_t latency = config.pace == 8 ? 14 : 0;
  for (const PuStage& stage : pu_built(config, "project", "conic"))
    latency += static_cast<uint64_t>(stage.begin + stage.result);
  check_pace<Stage>([](PuRandom& random, int count) { return shape_run(random, count, false); }, latency,
                    config.oriented() && !config.antialias ? 14 : static_cast<uint64_t>(config.pace));
}

}  // namespace
}  // namespace pipegs
