// SPDX-License-Identifier: Apache-2.0
// pu_covariance_test: rtl/pu/project/pu_covariance.sv against its bit-accurate model, and the chain of bit-accurate
// models before it against double precision.
#include "cpp_model/pu/project/pu_covariance.hpp"

#include "Vpu_covariance.h"
#include "verif/pu/pu_chain.hpp"
#include "verif/pu/pu_stage.hpp"

namespace pipegs {
namespace {

// A Gaussian's centre comes beside its squares; the module says when it takes it.
struct Stage {
  using Dut = Vpu_covariance;
  struct Input {
    Squares squares;
    Center center;
  };
  using Output = Covariance;
  class Source {
   public:
    Source(Bench<Dut>& b, const Config& c, Pace pace)
        : squares_(b, c, b.dut.squares_valid_i, b.dut.squares_ready_o, b.dut.squares_i, pace),
          centers_(b, c, center_valid_, b.dut.center_take_o, b.dut.center_i) {}
    void push(const Input& input) {
      squares_.push(input.squares);
      if (input.squares.kind == kData) centers_.push(input.center);
    }
    bool empty() const { return squares_.empty(); }

   private:
    CData center_valid_ = 0;  // the module trusts that it is there
    RecordSource<Squares, std::remove_reference_t<decltype(Dut::squares_i)>> squares_;
    RecordSource<Center, std::remove_reference_t<decltype(Dut::center_i)>> centers_;
  };
  static auto source(Bench<Dut>& b, const Config& c, Pace pace) { return Source(b, c, pace); }
  static auto sink(Bench<Dut>& b, const Config& c, Pace pace) {
    return RecordSink<Covariance, std::remove_reference_t<decltype(b.dut.covariance_o)>>(
        b, c, b.dut.covariance_valid_o, b.dut.covariance_ready_i, b.dut.covariance_o, pace);
  }
};

// A run of data and ends, one in ten.
template <class Make>
auto covariance_run(Make&& make) {
  return [=](PuRandom& random, int count) {
    StageRun<Stage> run;
    run.frame = random.frame();
    for (int i = 0; i < count; ++i) {
      run.inputs.push_back({make(random, run.frame), random.center()});
      if (random.chance(10)) {
        run.inputs.push_back({random_record<Squares>(random.config, random.rng), {}});
        run.inputs.back().squares.kind = random.chance(3) ? kWindowEnd : kLayerEnd;
      }
    }
    for (const Stage::Input& in : run.inputs)
      run.expected.push_back(pu_covariance(random.config, run.frame, in.squares, in.center));
    return run;
  };
}

// Now and then a sum of squares is zero beside any exponent.
Squares make(PuRandom& random, const Frame& frame) {
  Squares s = random_squares(random, frame);
  if (random.chance(20)) s.a_m = 0, s.a_e = random.integer(-100, 100);
  if (random.chance(20)) s.c_m = 0, s.c_e = random.integer(-100, 100);
  if (random.chance(20)) s.d_m = 0, s.d_e = random.integer(-100, 100);
  return s;
}

TEST(PuCovariance, EqualsItsModelAtEveryPace) { check_every_pace<Stage>(covariance_run(make)); }

TEST(PuCovariance, TakesARecordEveryEightCycles) { check_pace<Stage>(covariance_run(random_squares), 10); }

// From the fields of `oriented` on: what quantisation of the record costs is not counted.
TEST(PuCovariance, TheChainOfModelsIsPreciseForNeedlesPancakesAndAllSizes) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  PuRandom random{config, rng};
  double a = 0, b = 0, c = 0, det = 0;
  for (int i = 0; i < 50000; ++i) {
    const Frame f = random.frame();
    for (int k = 0; k < 4; ++k) {
      const Oriented o = random_oriented(random, f);
      const ExactCovariance exact = exact_covariance(random, f, o);
      const Covariance found =
          pu_covariance(config, f, pu_squares(config, f, pu_factors(config, f, pu_jacobian(config, f, o))), {});
      if (exact.a > 0x1p100 || exact.c > 0x1p100) continue;  // exponents saturate
      const auto real = [](auto m, auto e) { return std::ldexp(static_cast<double>(m), static_cast<int>(e)); };
      const auto worst = [&](double& error, double found_value, double exact_value, double scale) {
        error = std::max(error, std::abs(found_value - exact_value) / scale);
      };
      worst(a, real(found.a_m, found.a_e), exact.a, exact.a);
      worst(c, real(found.c_m, found.c_e), exact.c, exact.c);
      worst(det, real(found.det_m, found.det_e), exact.det, exact.det);
      worst(b, real(found.b_m, found.b_e), exact.b, std::sqrt(exact.a) * std::sqrt(exact.c));
      for (const uint64_t m : {found.a_m, found.c_m, found.det_m})
        ASSERT_EQ(m >> (config.mantissa_w - 1), 1u) << "normalised";
    }
  }
  std::printf("pu_covariance: relative error of a 2^%.2f, c 2^%.2f, det 2^%.2f, of b to sqrt(ac) 2^%.2f\n",
              std::log2(a), std::log2(c), std::log2(det), std::log2(b));
  const int lost = std::max(0, 26 - config.mantissa_w);  // the bounds are those of the default width
  EXPECT_LT(a, std::ldexp(1.0, lost - 21));
  EXPECT_LT(c, std::ldexp(1.0, lost - 21));
  EXPECT_LT(det, std::ldexp(1.0, lost - 21));
  EXPECT_LT(b, std::ldexp(1.0, lost - 22));
}

TEST(PuCovariance, AScaleOfZeroLeavesTheDilation) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  PuRandom random{config, rng};
  const Frame f = random.frame();
  Oriented o = random_oriented(random, f);
  o.scale_0 = o.scale_1 = o.scale_2 = 0;
  const Covariance found =
      pu_covariance(config, f, pu_squares(config, f, pu_factors(config, f, pu_jacobian(config, f, o))), {});
  const auto real = [](auto m, auto e) { return std::ldexp(static_cast<double>(m), static_cast<int>(e)); };
  EXPECT_NEAR(real(found.a_m, found.a_e), 0.3, 1e-5);
  EXPECT_NEAR(real(found.c_m, found.c_e), 0.3, 1e-5);
  EXPECT_NEAR(real(found.det_m, found.det_e), 0.09, 1e-5);
  EXPECT_EQ(found.b_m, 0);
}

}  // namespace
}  // namespace pipegs
