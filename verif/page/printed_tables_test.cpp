// SPDX-License-Identifier: Apache-2.0
// printed_tables_test: what commands print becomes tables without a word lost; charts and cells as the page reads them.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim/design/design_point.hpp"
#include "sim/report/html/printed_tables.hpp"

namespace pipegs {
namespace {

std::vector<std::string> texts(const std::vector<TableCell>& row) {
  std::vector<std::string> all;
  for (const TableCell& cell : row) all.push_back(cell.text);
  return all;
}

using Texts = std::vector<std::string>;

TEST(PrintedTables, ColumnsAreApartWhereAllLinesHaveTwoBlanks) {
  const std::vector<Table> tables = printed_tables(
      "  cycles at B/cycle        12.8       102.4   not memory-bound from      MB\n"
      "  gscore                6375612     1700436            102.4 B/cycle    57.3\n"
      "  late: not run: it does not build\n"
      "  fast                  1214773      498850             51.2 B/cycle    15.3  (the highest)\n"
      "  the port takes a line\n");
  ASSERT_EQ(tables.size(), 1u);
  ASSERT_EQ(tables[0].columns.size(), 6u);
  EXPECT_EQ(tables[0].columns[3].heading, "not memory-bound from");
  EXPECT_TRUE(tables[0].columns[0].word);
  EXPECT_FALSE(tables[0].columns[3].word);
  ASSERT_EQ(tables[0].rows.size(), 2u);
  EXPECT_EQ(texts(tables[0].rows[1]), (Texts{"fast", "1214773", "498850", "51.2 B/cycle", "15.3", "(the highest)"}));
  EXPECT_EQ(tables[0].rows[1][3].value, 51.2);
  EXPECT_EQ(tables[0].notes, (Texts{"late: not run: it does not build", "the port takes a line"}));
}

TEST(PrintedTables, ASentenceAboveTheNamesIsATitle) {
  const std::vector<Table> tables = printed_tables(
      "words alone\n\n  first, of 28 nm\n  name   mm2\n  RU     1.5\n  second\n  name   W\n  RU     0.1\n  SU     "
      "0.2\n");
  ASSERT_EQ(tables.size(), 3u);
  EXPECT_TRUE(tables[0].columns.empty());
  EXPECT_EQ(tables[0].notes, Texts{"words alone"});
  EXPECT_EQ(tables[1].title, "first, of 28 nm");
  EXPECT_EQ(tables[1].rows.size(), 1u);
  EXPECT_EQ(tables[2].title, "second");
  EXPECT_EQ(tables[2].rows.size(), 2u);
}

// One blank is enough where two are not to be had, and a character of several bytes fills one place.
TEST(PrintedTables, ColumnsAreFoundWhereNumbersNearlyTouch) {
  const std::vector<Table> tables =
      printed_tables("  name     GHz      us\n  grün   1.012  ~582.2\n  x     ~1.012 1000.25\n");
  ASSERT_EQ(tables.size(), 1u);
  EXPECT_EQ(texts(tables[0].rows[0]), (Texts{"grün", "1.012", "~582.2"}));
  EXPECT_EQ(texts(tables[0].rows[1]), (Texts{"x", "~1.012", "1000.25"}));
  EXPECT_EQ(tables[0].rows[0][2].value, 582.2);
  EXPECT_TRUE(printed_tables("").empty());
  EXPECT_TRUE(printed_tables("\n \n").empty());
}

TEST(PrintedTables, ARowThatDoesNotFitIsCutByNoColumn) {
  const std::vector<Table> tables = printed_tables(
      "  times         here  paper\n"
      "  a            8.1 %  7 %\n"
      "  b             9.64\n"
      "  ab   9.05 10.00 16.05\n"
      "  c            37277  over 70 %\n"
      "  d            0.58x\n");
  ASSERT_EQ(tables.size(), 1u);
  ASSERT_EQ(tables[0].columns.size(), 3u);
  EXPECT_EQ(texts(tables[0].rows[2]), (Texts{"ab", "9.05 10.00 16.05", ""}));
  EXPECT_EQ(texts(tables[0].rows[3]), (Texts{"c", "37277", "over 70 %"}));
}

TEST(PrintedTables, RowsWithoutNamesAreRows) {
  const std::vector<Table> tables = printed_tables(
      "gaussians\n  scene     600  Gaussians  in the file\n  visible    37  Gaussians  in a pixel\n\n"
      "  alone  7\n\n                50 %   90 %\n  power, ours   0.1    0.2\n");
  ASSERT_EQ(tables.size(), 3u);
  EXPECT_EQ(tables[0].title, "gaussians");
  ASSERT_EQ(tables[0].rows.size(), 2u);
  EXPECT_EQ(texts(tables[0].rows[0]), (Texts{"scene", "600", "Gaussians", "in the file"}));
  EXPECT_EQ(tables[0].columns[1].heading, "");
  EXPECT_EQ(texts(tables[1].rows[0]), (Texts{"alone", "7"}));
  EXPECT_EQ(tables[2].columns[2].heading, "90 %");
}

TEST(PrintedTables, ANumberStandsAtTheBeginning) {
  EXPECT_EQ(leading_number("~1.5"), 1.5);
  EXPECT_EQ(leading_number("+0.52"), 0.52);
  EXPECT_EQ(leading_number("-3 %"), -3);
  EXPECT_EQ(leading_number("0.12 (0.1 to 0.2)"), 0.12);
  for (const char* none : {"", "-", "inf", "nan", "yes", "--1", "~", "x1"}) EXPECT_FALSE(leading_number(none)) << none;
}

TEST(StudyPage, ItsJsonHoldsNoInfinityAndEndsNoElement) {
  StudyPage page("</script>", "pipegs <x>", "v");
  const double inf = std::numeric_limits<double>::infinity();
  page.charts({{.form = Chart::Form::kScatter,
                .title = "t",
                .series = {{.name = "s", .values = {1, inf}, .x = {std::nan(""), 2}, .labels = {"a", "b"}}}}});
  page.table({.title = "",
              .columns = {{.heading = "a", .word = true}, {.heading = "empty"}, {.heading = "b"}},
              .rows = {{{.text = "x"}, {.text = ""}, {.text = "1", .value = 1}}}});
  const std::string html = page.text("<!--data-->");
  EXPECT_EQ(html.find("</script>"), html.rfind("</script>")) << "one element, ended once";
  const size_t from = html.find('{');
  const auto section = nlohmann::json::parse(html.substr(from, html.find("</script>") - from))["sections"][0];
  EXPECT_EQ(section["charts"][0]["series"][0]["values"].dump(), "[1.0,null]");
  EXPECT_EQ(section["charts"][0]["series"][0]["x"].dump(), "[null,2.0]");
  EXPECT_EQ(section["tables"][0]["columns"].size(), 2u) << "an empty column is left out";
  EXPECT_EQ(section["tables"][0]["rows"][0][1]["value"], 1.0);
}

TEST(StudyPage, MachinesAreSettingsForAnyCommand) {
  EXPECT_EQ(machine_words(find_design_point("fast").config), "--design fast");
  EXPECT_EQ(machine_words(Config{}), "--design dop");
  Config config = find_design_point("exact").config;
  config.units = 2, config.alpha_w = 11;
  EXPECT_EQ(machine_words(config), "--design exact --set units=2 --set alpha_w=11");
}

}  // namespace
}  // namespace pipegs
