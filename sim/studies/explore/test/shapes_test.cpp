// SPDX-License-Identifier: Apache-2.0
// shapes_test: neighbours are legal machines with the same pixels; a sweep of frames by formula, its front, its best.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "sim/design/design_point.hpp"
#include "sim/studies/explore/report.hpp"
#include "sim/studies/explore/shapes.hpp"

namespace pipegs {
namespace {

Config exact() { return find_design_point("exact").config; }

TEST(Neighbours, AreLegalAndOfTheSamePixels) {
  for (const DesignPoint& point : design_points()) {
    std::set<std::string> names;
    for (const Neighbour& one : neighbours(point.config)) {
      EXPECT_NO_THROW(config_check(one.config)) << config_difference(one.config);
      EXPECT_TRUE(names.insert(config_difference(one.config)).second) << config_difference(one.config);
      EXPECT_EQ(one.config.*one.entry->member, one.value);
      Config same = one.config;
      for (const ShapeEntry& entry : shape_entries()) same.*entry.member = point.config.*entry.member;
      EXPECT_EQ(same, point.config) << "another entry moved: " << config_difference(one.config);
    }
    EXPECT_FALSE(names.empty());
    EXPECT_FALSE(names.contains(config_difference(point.config)));
  }
}

TEST(Neighbours, HaveNoMoreFrontsThanUnits) {
  for (const Neighbour& one : neighbours(exact())) EXPECT_LE(one.config.fronts, one.config.units);
  Config two = exact();
  two.units = 2;
  for (const Neighbour& one : neighbours(two)) EXPECT_FALSE(one.entry->name == "fronts" && one.value > 1);
}

TEST(Neighbours, LeaveAloneWhatAMachineDoesNotHave) {
  const auto moves = [](const Config& config, const std::string& name) {
    const std::vector<Neighbour> found = neighbours(config);
    return std::any_of(found.begin(), found.end(), [&](const Neighbour& one) { return one.entry->name == name; });
  };
  EXPECT_TRUE(moves(exact(), "mark_chunks"));
  EXPECT_FALSE(moves(find_design_point("dop").config, "mark_chunks")) << "there are no watermarks";
  EXPECT_FALSE(moves(find_design_point("dop").config, "occlusion")) << "its chunks come in no order";
  EXPECT_TRUE(moves(find_design_point("fast").config, "occlusion"));
  EXPECT_TRUE(moves(find_design_point("fast").config, "pace"));
  EXPECT_FALSE(moves(find_design_point("gscore").config, "pace")) << "the oriented box is made in eight cycles";
  EXPECT_TRUE(moves(find_design_point("fast").config, "window"));
  EXPECT_FALSE(moves(exact(), "window")) << "128 pixels need quads";
  Config narrow = exact();
  narrow.window = 32;
  EXPECT_FALSE(moves(narrow, "window")) << "its footprints have another anchor";
  EXPECT_TRUE(moves(exact(), "bus_w"));
  Config bare = exact();
  bare.bus_w = 0;
  EXPECT_FALSE(moves(bare, "bus_w")) << "there is no bus";
}

// Cycles by formula: units and tests help, records above 1024 do not, one bucket bit is best.
class Frames {
 public:
  void operator()(const char*, std::vector<Point>& points) {
    for (Point& point : points) {
      const Config& config = point.config;
      ++measured[config_difference(config)];
      const double cycles = 4e6 / config.units * (config.tests == 2 ? 0.9 : 1) * (config.records < 1024 ? 1.3 : 1) *
                            (1 + 0.02 * std::abs(config.bucket_bits - 4)) * (1 + 0.1 / config.pu_fronts());
      point.figures.cycles = static_cast<uint64_t>(cycles), point.figures.bytes = 40000000;
      point.silicon = silicon().cost(config, point.figures.cycles, point.figures.bytes);
    }
  }
  static const FrameModel& silicon() {
    static const FrameModel kSilicon = read_frame_model();
    return kSilicon;
  }
  std::map<std::string, int> measured;
};

struct Swept {
  Frames frames;
  std::vector<Point> shapes;
};
Swept swept(int runs) {
  Swept result;
  result.shapes = sweep_shapes(std::ref(result.frames), Frames::silicon(), exact(), {.mm2 = 3.283, .runs = runs});
  return result;
}

const std::vector<Point>& forty() {
  static const std::vector<Point> kShapes = swept(40).shapes;
  return kShapes;
}

TEST(Shapes, MeasuresEachOnceAndNoMoreThanAsked) {
  for (const int runs : {1, 5, 22}) {
    const Swept found = swept(runs);
    EXPECT_LE(found.shapes.size(), static_cast<size_t>(runs));
    EXPECT_EQ(found.shapes.size(), found.frames.measured.size());
    for (const auto& [name, times] : found.frames.measured) EXPECT_EQ(times, 1) << name;
    EXPECT_EQ(found.shapes.front().config, exact());
  }
  EXPECT_GT(forty().size(), neighbours(exact()).size() + 1) << "some together";
}

TEST(Shapes, LeavesOutMachinesWhoseAreaIsNotKnown) {
  const std::vector<Neighbour> all = neighbours(exact());
  EXPECT_TRUE(std::any_of(all.begin(), all.end(), [](const Neighbour& one) { return one.config.pace == 4; }));
  for (const Point& shape : forty()) EXPECT_TRUE(Frames::silicon().area().knows(shape.config)) << shape.config.pace;
}

// Who is on a front is tradeoff_test's to say.
TEST(Shapes, TheFrontGoesFromSmallToFast) {
  const std::vector<const Point*> front = shape_front(forty());
  ASSERT_GT(front.size(), 1u);
  for (size_t i = 1; i < front.size(); ++i) {
    EXPECT_EQ(front[i]->front, front[i - 1]->front + 1);
    EXPECT_GT(front[i]->mm2(), front[i - 1]->mm2());
    EXPECT_LT(front[i]->silicon->us, front[i - 1]->silicon->us);
  }
}

TEST(Shapes, TheBestTakesWhatHelpsTogether) {
  const std::vector<Point>& shapes = forty();
  const Point* best = best_within(shapes, 3.283);
  ASSERT_NE(best, nullptr);
  EXPECT_EQ(best->config.units, 4);
  EXPECT_EQ(best->config.tests, 2);
  EXPECT_EQ(best->config.bucket_bits, 4);
  EXPECT_LE(best->mm2(), 3.283);
  for (const Point& shape : shapes) {
    if (shape.mm2() <= 3.283) EXPECT_GE(shape.silicon->us, best->silicon->us);
  }
  EXPECT_EQ(best_within(shapes, 0.1), nullptr);
}

TEST(Shapes, ReportsNameTheBestAndTheFront) {
  const std::vector<Point>& shapes = forty();
  const Answer answer = shapes_answer(shapes, 3.283), none = shapes_answer(shapes, 0.1);
  const std::string text = tables_text(answer.tables);
  const nlohmann::ordered_json& json = answer.json;
  EXPECT_NE(text.find("\n  best within 3.283 mm2: " + json["best"].get<std::string>() + ": "), std::string::npos);
  EXPECT_EQ(json["shapes"].size(), shapes.size());
  EXPECT_EQ(json["front"].size(), shape_front(shapes).size());
  EXPECT_EQ(json["shapes"][0]["shape"], "base");
  EXPECT_EQ(json["shapes"][0]["ghz"].is_null(), !json["clock_known"].get<bool>());
  EXPECT_NE(tables_text(none.tables).find("no shape that was measured fits 0.1 mm2"), std::string::npos);
  EXPECT_TRUE(none.json["best"].is_null());
  EXPECT_EQ(answer.charts[0].series.size(), 4u);
}

}  // namespace
}  // namespace pipegs
