// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/explore/figures: a stored point comes back as it was measured; one that is broken is as good as
// none, and what is no file in a point's place is refused before anything is measured.
#include <gtest/gtest.h>

#include <fstream>

#include "scenes/input_error.hpp"
#include "scenes/text/json.hpp"
#include "sim/report/measurement_store.hpp"
#include "sim/studies/explore/figures.hpp"
#include "verif/frame/scenes.hpp"
#include "verif/scenes/scratch_folder.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Figures& figures) { return to_json(figures, Measured::kErrors); }
Figures figures_of(const Json& json) { return figures_from_json(json, Measured::kErrors); }

Figures measured() {
  Figures a;
  a.numeric = {60.5, 0.99, 0.1, 0.01};
  a.order = {std::numeric_limits<double>::infinity(), 1, 0, 0};
  a.total = {40, 0.9, 1, 0.5};
  a.cycles = 123456, a.bytes = ~uint64_t{0}, a.buffer_bits = 8192;
  return a;
}

class Points : public testing::Test {
 protected:
  Points() { scene_.name = "caf\xe9"; }  // Latin-1, as a file name may be
  MeasurementStore store() const { return store(options_); }
  MeasurementStore store(const SimulateOptions& options) const {
    return {scratch_ / "points", scene_, camera_, options};
  }
  // The point of the default configuration with another text in place of `from`.
  bool is_read_with(const std::string& from, const std::string& to) {
    store().save(config_, json_of(measured()));
    const std::filesystem::path path = store().path(config_);
    std::ifstream file(path, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
    std::ofstream(path, std::ios::binary) << text;
    return store().load(config_, figures_of).has_value();
  }

  const ScratchFolder scratch_;
  Scene scene_ = random_scene(1, 5, 0);
  const Camera camera_ = test_camera(64, 48);
  const SimulateOptions options_;
  const Config config_;
};

TEST_F(Points, ComeBackAsTheyWereMeasured) {
  EXPECT_FALSE(store().load(config_, figures_of).has_value());
  store().save(config_, json_of(measured()));
  const std::optional<Figures> read = store().load(config_, figures_of);
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(json_of(*read), json_of(measured()));
  EXPECT_EQ(read->bytes, ~uint64_t{0});
  EXPECT_TRUE(is_read_with("123456", "123457"));
}

// Cycles and bytes depend on how many Gaussians at one depth a window may have to go whole.
TEST_F(Points, OfAnotherWalkMostAreNotTaken) {
  store().save(config_, json_of(measured()));
  SimulateOptions other;
  ++other.walk_most;
  EXPECT_FALSE(store(other).load(config_, figures_of).has_value());
  EXPECT_NE(store(other).path(config_), store().path(config_));
  EXPECT_TRUE(store().load(config_, figures_of).has_value());
}

TEST_F(Points, HoldWhatWasMeasuredAndNoMore) {
  for (const Measured part : {Measured::kCycles, Measured::kPicture}) {
    const Json json = to_json(measured(), part);
    EXPECT_EQ(json.contains("total"), part == Measured::kPicture);
    EXPECT_FALSE(json.contains("numeric"));
    EXPECT_EQ(to_json(figures_from_json(json, part), part), json);
    EXPECT_THROW(figures_of(json), Json::exception);
  }
}

TEST_F(Points, BrokenOnesAreAsGoodAsNone) {
  for (const char* number : {"-1", "1.5", "0", "1e99", "\"123456\"", "null", "123456x", "+123456", "12 3456", ""})
    EXPECT_FALSE(is_read_with("123456", number)) << number;
  for (const char* number : {"nan", "1e999", "\"60.5\"", "[60.5]"})
    EXPECT_FALSE(is_read_with("60.5", number)) << number;
  EXPECT_FALSE(is_read_with("\"max\": 0.1", "\"max\": -0.1"));
  EXPECT_FALSE(is_read_with("\"cycles\": 123456", "\"cycles\": 123456, \"cycles\": 123456")) << "a field comes once";
  EXPECT_FALSE(is_read_with("\"cycles\": 123456,", "")) << "a field is missing";
  EXPECT_FALSE(is_read_with("123456", std::string(400000, '[') + std::string(400000, ']'))) << "nested too deep";
  EXPECT_FALSE(is_read_with("}\n}", "}\n}}")) << "something follows";
  EXPECT_FALSE(is_read_with("measured_by", "measured by")) << "another key";
  EXPECT_FALSE(is_read_with("\"memory\"", "\"m\xe9mory\"")) << "no UTF-8";
}

TEST_F(Points, WhatIsNoFileIsRefused) {
  store();
  std::filesystem::create_directories(store().path(config_));
  try {
    store().load(config_, figures_of);
    FAIL() << "a folder was taken for a point";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("found a folder, expected a kept measurement"), std::string::npos);
  }
}

TEST(Json, IntegersAreWholeAndInRange) {
  EXPECT_EQ(json_integer<int>(Json(5)), 5);
  EXPECT_EQ(json_integer<int>(Json(-5)), -5);
  EXPECT_EQ(json_integer<int>(Json(5.0)), 5);
  EXPECT_EQ(json_integer<uint64_t>(Json(~uint64_t{0})), ~uint64_t{0});
  EXPECT_THROW(json_integer<uint64_t>(Json(-1)), NumberError);
  EXPECT_THROW(json_integer<uint64_t>(Json(18446744073709551616.0)), NumberError);
  EXPECT_THROW(json_integer<int>(Json(4294967301u)), NumberError);
  EXPECT_THROW(json_integer<int>(Json(5.5)), NumberError);
  EXPECT_THROW(json_integer<int>(Json(true)), NumberError);
  EXPECT_THROW(json_real(Json("5")), NumberError);
  EXPECT_THROW(json_real(Json(std::nan(""))), NumberError);
}

}  // namespace
}  // namespace pipegs
