// SPDX-License-Identifier: Apache-2.0
// accuracy_test: the table of knobs, what a view measures, fronts and targets.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "cpp_model/float/metrics.hpp"
#include "cpp_model/pu/rows/pu_region.hpp"
#include "cpp_model/pu/rows/pu_row_unit.hpp"
#include "sim/design/design_point.hpp"
#include "sim/studies/explore/report.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

// What the value names, on the default.
Config named(const KnobValue& value) {
  Config config;
  for (const std::string& setting : value.settings) config_set(config, setting);
  return config;
}

TEST(AccuracyKnobs, EveryValueIsLegalOnEveryDesignPointThatTakesItsOrder) {
  for (const DesignPoint& design_point : design_points()) {
    const Config& base = design_point.config;
    for (const Knob& knob : accuracy_knobs()) {
      for (const KnobValue& value : knob.values) {
        if (base.quadratic && knob.name == "layers") continue;
        if (base.order != 2 && value.less.lod > 0) continue;
        if (base.tight_boxes && named(value).scale_m_w > 12) continue;  // a node has no room for it
        if (base.units == 8 && named(value).window == 16) continue;     // more units than regions
        EXPECT_NO_THROW(with_value(base, value)) << design_point.name << ": " << knob.name << " " << value.label;
      }
    }
  }
}

TEST(AccuracyKnobs, TheDefaultIsAmongTheValues) {
  const Config standard;
  for (const Knob& knob : accuracy_knobs()) {
    bool found = false;
    for (const KnobValue& value : knob.values) found = found || named(value) == standard;
    EXPECT_TRUE(found) << knob.name;
  }
}

// Three values have one configuration, and are three points all the same.
TEST(AccuracyKnobs, ProxiesOfOneMachineAreMeasuredEachAndLeftOutWhereThereAreNone) {
  const MeasurePoints none = [](const char*, std::vector<Point>& points) {
    for (Point& point : points) point.figures.cycles = 1, point.figures.numeric.psnr = 60 - point.value.less.lod;
  };
  const SweepOptions options{.knobs = find_knobs({"codes", "proxies"}), .points = 8};
  const AccuracySweep exact = accuracy_sweep(none, find_design_point("exact").config, options);
  EXPECT_EQ(exact.skipped, std::vector<std::string>());
  std::vector<double> pixels;
  for (const Point& point : exact.all()) pixels.push_back(point.value.less.lod);
  EXPECT_EQ(pixels, (std::vector<double>{0, 0, 4, 2, 1})) << "the base, codes, and each value of proxies";

  const AccuracySweep dop = accuracy_sweep(none, find_design_point("dop").config, options);
  ASSERT_EQ(dop.skipped.size(), 3u);
  for (const std::string& reason : dop.skipped) {
    EXPECT_NE(reason.find(" px: configuration: lod = 1 needs order = 2"), std::string::npos) << reason;
    EXPECT_EQ(reason.find('\n'), std::string::npos) << reason;
  }
  EXPECT_EQ(dop.all().size(), 2u);
  EXPECT_EQ(dop.knobs.at(1).points.size(), 1u);
}

TEST(AccuracyKnobs, AnUnknownOneIsRefused) {
  EXPECT_EQ(find_knobs({}).size(), accuracy_knobs().size());
  EXPECT_EQ(find_knobs({"alpha_w"}).at(0)->name, "alpha_w");
  EXPECT_THROW(find_knobs({"alpha"}), ConfigError);
}

// A record of up to 256 bits shares its line with another.
TEST(AccuracyKnobs, RecordsAreAsWideAsTheirNames) {
  for (const KnobValue& value : find_knobs({"record"})[0]->values) {
    const Config c = with_value({}, value);
    const int bits = 3 * c.pos_w + 4 * c.quat_w + 3 * c.scale_w() + c.opacity_w() + 3 * c.base_w + c.index_w;
    EXPECT_EQ(value.label, std::to_string(bits) + " bit");
    EXPECT_EQ(c.gaussians_per_line(), bits <= 256 ? 2 : 1);
  }
}

class SmallView : public testing::Test {
 protected:
  SmallView() {
    options_.memory.dram = "lpddr5-6400x4";
    options_.config = find_design_point("exact").config;
  }
  Config with(const std::vector<std::string>& settings) const {
    Config config = options_.config;
    for (const std::string& setting : settings) config_set(config, setting);
    return config;
  }

  const Scene scene_ = random_scene(3, 400, 3);
  const Camera camera_ = test_camera(100, 80);
  const std::vector<Camera> cameras_ = {camera_};
  SimulateOptions options_;
};

TEST_F(SmallView, APointHoldsTheFiguresOfASimulation) {
  const View view(scene_, camera_, cameras_, options_, Measured::kErrors);
  const Config config = with({"alpha_w=10"});
  const Figures a = view.measure(config);
  SimulateOptions options = options_;
  options.config = config;
  Simulation simulation;
  simulate_golden(scene_, camera_, options, simulation);
  simulate_truth(scene_, camera_, options, simulation);
  EXPECT_DOUBLE_EQ(a.numeric.psnr, simulation.psnr_numeric);
  EXPECT_DOUBLE_EQ(a.order.psnr, simulation.psnr_order);
  EXPECT_DOUBLE_EQ(a.numeric.max, simulation.max_abs_error);
  EXPECT_DOUBLE_EQ(a.total.psnr, psnr(simulation.golden.image, simulation.truth_exact));
  EXPECT_GT(a.total.ssim, 0.99);
  EXPECT_LE(a.numeric.p999, a.numeric.max);
  EXPECT_GT(a.cycles, 1000u);
  EXPECT_GT(a.bytes, 10000u);
  EXPECT_GT(a.buffer_kb(), 100);
}

// What proxies stand for has no place in an order.
TEST_F(SmallView, OfProxiesAllErrorIsNumeric) {
  Scene scene = random_scene(67, 6000, 0);
  for (Gaussian& gaussian : scene.gaussians) {  // larger than their distance: a proxy stands for several
    gaussian.mean = glm::vec3(0, 0, 5) + 0.2f * gaussian.mean;
    gaussian.log_scale = glm::vec3(-1.9f);
    gaussian.opacity_logit = 0;
  }
  const View view(scene, camera_, cameras_, options_, Measured::kErrors);
  Config config = find_design_point("fast").config;
  config_set(config, "lod=1");
  const Figures a = view.measure(config, {.lod = 1000});
  EXPECT_LT(a.numeric.psnr, view.measure(config).numeric.psnr - 3) << "no proxies in the picture";
  EXPECT_DOUBLE_EQ(a.numeric.psnr, a.total.psnr);
  EXPECT_TRUE(std::isinf(a.order.psnr));
  EXPECT_TRUE(reaches(a, a.numeric.psnr));
  SimulateOptions options = options_;
  options.config = config;
  options.lod_pixels = 1000;
  Simulation simulation;
  simulate_golden(scene, camera_, options, simulation);
  simulate_truth(scene, camera_, options, simulation);
  EXPECT_DOUBLE_EQ(a.numeric.psnr, simulation.psnr_numeric);
  EXPECT_TRUE(std::isinf(simulation.psnr_order));
}

TEST_F(SmallView, TheTruthKeepsItsRulesWhateverTheMachineDoes) {
  const View view(scene_, camera_, cameras_, options_, Measured::kErrors);
  const double base = view.measure(options_.config).numeric.psnr;
  for (const char* setting : {"sh_degree=0", "alpha_cut=64", "alpha_cut=1023"})
    EXPECT_LT(view.measure(with({setting})).numeric.psnr, base - 1) << setting;
}

// With as many fraction bits as the accumulators, moving the coefficients from region to region is exact: whether
// differences start at the footprint's anchor or at the region makes no difference, so only the coefficients' own
// rounding is left.
TEST_F(SmallView, WithoutARoundingTheAnchorIsThatOfTheFootprint) {
  Config config = with({"coeff_f=20", "power_f=20"});
  std::mt19937_64 rng(1);
  const auto bits = [&](int width) { return static_cast<int64_t>(rng() << (64 - width)) >> (64 - width); };
  for (int i = 0; i < 1000; ++i) {
    RowJob job;
    job.a = bits(config.a_w()), job.b = bits(config.bc_w()), job.c = bits(config.bc_w());
    job.d = bits(config.def_w()), job.e = bits(config.def_w()), job.f = bits(config.def_w());
    job.mask = ~uint64_t{0};
    for (const int region : {0, 7, 9, 36, 63}) {
      const Region start = pu_region(config, job, region);
      for (int dy = 0; dy < 8; ++dy) {
        Row row = pu_row_init(start, dy);
        for (int dx = 0; dx < 8; ++dx) {
          const int64_t x = 8 * (region % 8) + dx, y = 8 * (region / 8) + dy;
          ASSERT_EQ(row.power, job.a + job.b * x + job.c * y + job.d * x * x + job.e * y * y + job.f * x * y);
          row = pu_row_unit(row, start.curve_x);
        }
      }
    }
  }
}

Point point(double numeric, double order, uint64_t cycles, uint64_t buffers, int alpha_w = 8) {
  Point p{.knob = "alpha_w", .value = {}, .config = {}};
  p.config.alpha_w = alpha_w;
  p.figures.numeric.psnr = numeric, p.figures.order.psnr = order;
  p.figures.cycles = cycles, p.figures.bytes = cycles, p.figures.buffer_bits = buffers;
  return p;
}

TEST(AccuracyFront, HoldsWhatNothingBeats) {
  const std::vector<Point> points = {point(60, 90, 100, 1), point(50, 90, 90, 1), point(55, 90, 100, 1),
                                     point(45, 90, 95, 1), point(70, 30, 80, 1)};
  const std::vector<const Point*> front = accuracy_front(points, costs().front());
  ASSERT_EQ(front.size(), 2u);
  EXPECT_EQ(front[0], &points[1]);
  EXPECT_EQ(front[1], &points[0]);
}

// Its words draw the same frame, not only the same machine.
TEST(AccuracyFront, TheTargetNamesTheProxiesOfItsFrame) {
  Point one{
      .knob = "proxies", .value = {.label = "2 px", .less = {.lod = 2}}, .config = find_design_point("exact").config};
  one.config.lod = 1;
  one.figures.numeric.psnr = 50, one.figures.order.psnr = std::numeric_limits<double>::infinity();
  const Table table = target_table({one}, 45);
  ASSERT_EQ(table.notes.size(), 2u);
  EXPECT_TRUE(table.notes[1].ends_with("--set lod=1 --lod-pixels 2")) << table.notes[1];
}

TEST(AccuracyFront, TheTargetIsReachedByTheCheapest) {
  const double inf = std::numeric_limits<double>::infinity();
  std::vector<Point> points = {point(61, inf, 1000, 9), point(62, 59, 1005, 5), point(63, inf, 1200, 1),
                               point(80, 40, 10, 1), point(50, inf, 10, 1)};
  EXPECT_EQ(cheapest(points, 60), &points[1]);  // as many cycles, but for chance
  EXPECT_EQ(cheapest(points, 62.5), &points[2]);
  EXPECT_EQ(cheapest(points, 50), &points[4]);
  EXPECT_EQ(cheapest(points, 81), nullptr);
  points[4].figures.failure = "did not fit";
  EXPECT_EQ(cheapest(points, 50), &points[1]);
}

TEST_F(SmallView, TogetherGoesFromTheFinestToTheCoarsest) {
  const View view(scene_, camera_, cameras_, options_, Measured::kErrors);
  const MeasurementStore store("", scene_, camera_, options_);
  const FrameModel silicon = read_frame_model();
  Explorer explorer(view, store, silicon);
  const AccuracySweep sweep = accuracy_sweep(std::ref(explorer), options_.config,
                                             {.knobs = find_knobs({"alpha_w", "rgb_w", "sh_degree"}), .points = 8});
  ASSERT_GE(sweep.together.size(), 3u);
  ASSERT_LE(sweep.together.size(), 8u);
  EXPECT_EQ(sweep.together.front().config.alpha_w, 12);
  EXPECT_GT(sweep.together.front().figures.numeric.psnr, sweep.base.figures.numeric.psnr);
  double coarsest = sweep.base.figures.numeric.psnr;
  for (const Point& p : sweep.together) coarsest = std::min(coarsest, p.figures.numeric.psnr);
  EXPECT_LT(coarsest, sweep.base.figures.numeric.psnr - 3);
  for (const Point& p : sweep.all()) EXPECT_NO_THROW(config_check(p.config));

  const Answer answer = accuracy_answer(sweep);
  size_t points = 1 + sweep.together.size();
  for (const SweptKnob& knob : sweep.knobs) points += knob.points.size();
  const auto& rows = answer.tables.at(0).rows;
  ASSERT_EQ(rows.size(), points);
  EXPECT_TRUE(rows.back().back().copy.starts_with("--design ")) << rows.back().back().copy;
  EXPECT_EQ(answer.json["knobs"].size(), sweep.knobs.size());
  for (const Chart& chart : answer.charts) EXPECT_FALSE(chart.series.at(0).values.empty()) << chart.title;
  EXPECT_EQ(charts_json(answer.charts).size(), answer.charts.size());  // counts fit each other
}

}  // namespace
}  // namespace pipegs
