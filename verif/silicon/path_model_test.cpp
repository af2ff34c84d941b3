// SPDX-License-Identifier: Apache-2.0
// path_model_test: longest paths by hand and their bounds; the clock of a frame; leave-one-out errors of the table.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sim/silicon/frame_model.hpp"

namespace pipegs {
namespace {

constexpr const char* kSynth = PIPEGS_SOURCE_DIR "/synth/data/";
const UnitKnobs kKnobs = {{"pu", {"coeff_f"}}, {"top", {"coeff_f", "t_w"}}};

// The PU's path grows with coeff_f; the machine's is the RU's until that is longer.
PathPoint by_hand(int coeff_f, int late = 0) {
  PathPoint point;
  point.config.coeff_f = coeff_f, point.config.late = late;
  const double pu = 50 + (coeff_f - 20) + 3 * late;
  point.fo4 = {{"dopu", 40}, {"pu", pu}, {"su", 45}, {"ru", 55}, {"top", std::max(55.0, pu)}};
  return point;
}

TEST(PathModel, TellsTheLongestUnitsPath) {
  const PathModel model({by_hand(28), by_hand(20), by_hand(24, 1), by_hand(28, 1)}, kKnobs);
  EXPECT_NEAR(model.by_unit(by_hand(24).config).at("pu"), 54, 0.1);
  EXPECT_NEAR(model.by_unit(by_hand(26, 1).config).at("pu"), 59, 0.1) << "a kind is an offset";
  EXPECT_NEAR(model.by_unit(by_hand(24).config).at("dopu"), 40, 0.1);
  EXPECT_NEAR(*model.fo4(by_hand(28, 1).config), 61, 0.1);
  EXPECT_NEAR(*model.fo4(by_hand(20).config), 55, 0.1);
  EXPECT_EQ(by_hand(28).longest(), 58);
}

TEST(PathModel, StaysWithinWhatWasMeasuredOfTheKind) {
  const PathModel model({by_hand(28), by_hand(20), by_hand(24, 1)}, kKnobs);
  EXPECT_EQ(model.by_unit(by_hand(30).config).at("pu"), 58);
  EXPECT_EQ(model.by_unit(by_hand(20, 1).config).at("pu"), 57) << "one point has one path";
  EXPECT_TRUE(model.inside(by_hand(24).config));
  EXPECT_FALSE(model.inside(by_hand(30).config));
}

TEST(PathModel, KnowsNothingOfOtherKinds) {
  const PathModel model({by_hand(28), by_hand(20)}, kKnobs);
  EXPECT_FALSE(model.fo4(by_hand(28, 1).config));
  EXPECT_TRUE(model.by_unit(by_hand(28, 1).config).empty());
  EXPECT_FALSE(model.inside(by_hand(28, 1).config));
  EXPECT_FALSE(PathModel().fo4(Config{}));
}

AreaModel one_block() {
  AreaPoint point;
  point.nand2["pu"]["pu"] = 1e6;
  return {{point}, {{"pu", {"coeff_f"}}}};
}

// A frame takes cycles / clock, and leaks as long.
TEST(FrameModel, TimesByTheClockWhereItIsKnown) {
  const SramLaw law(std::string(kSynth) + "sram.csv");
  const FrameModel known(one_block(), PathModel({by_hand(28), by_hand(20)}, one_block().unit_knobs()), law, {});
  const FrameModel unknown(one_block(), PathModel(), law, {});
  const FrameCost with = known.cost(Config{}, 100000, 0).value(), without = unknown.cost(Config{}, 100000, 0).value();
  ASSERT_TRUE(with.ghz());
  EXPECT_NEAR(*with.ghz(), 1000 / (58 * 16.0), 1e-3) << "above 1 GHz too";
  EXPECT_NEAR(with.us, 100 / *with.ghz(), 1e-6);
  EXPECT_FALSE(with.extrapolated_path);
  EXPECT_FALSE(without.ghz());
  EXPECT_EQ(without.us, 100) << "at 1 GHz";
  EXPECT_NEAR(with.chip.mid / without.chip.mid, with.us / without.us, 1e-9);
  Config narrow;
  narrow.coeff_f = 20;
  EXPECT_LT(known.cost(narrow, 100000, 0)->us, with.us) << "narrow numbers are faster";
}

// Every point of the table told from all others of its kind.
TEST(PathModel, LeaveOneOutErrorsOfThePaths) {
  const PathModel model = read_frame_model().paths();
  if (model.points().empty()) GTEST_SKIP() << "synth/data/paths.csv has no points yet: synth/points.py writes them";
  for (size_t i = 0; i < model.points().size(); ++i) {
    const PathPoint& kept_out = model.points()[i];
    const std::optional<double> told = model.without(i).fo4(kept_out.config);
    const std::string name = config_difference(kept_out.config);
    if (!told) {
      printf("%6.1f FO4, alone of its kind: %s\n", kept_out.longest(), name.c_str());
      continue;
    }
    const double fitted = *model.fo4(kept_out.config) / kept_out.longest() - 1, error = *told / kept_out.longest() - 1;
    printf("%6.1f FO4, fitted %+6.2f %%, leave-one-out %+6.2f %%%s: %s\n", kept_out.longest(), 100 * fitted,
           100 * error, model.without(i).inside(kept_out.config) ? "" : " (extrapolated)", name.c_str());
    EXPECT_LT(std::abs(fitted), 0.03);
    EXPECT_LT(std::abs(error), 0.25);
  }
}

}  // namespace
}  // namespace pipegs
