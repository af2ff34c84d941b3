// SPDX-License-Identifier: Apache-2.0
// table_test: one table as text, CSV and what a page reads: the same cells in each.
#include "sim/report/table.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pipegs {
namespace {

Table example() {
  return {.title = "Times",
          .columns = {{.key = "name", .heading = "name", .word = true},
                      {.key = "us", .heading = "frame", .unit = "us", .digits = 1},
                      {.key = "front", .heading = "front"},
                      {.key = "empty", .heading = "empty"},
                      {.key = "remark", .word = true}},
          .rows = {{text_cell("grün, a"), number_cell(1000.25), number_cell(2), {}, {}},
                   {text_cell("x|\"y\""), number_cell(582.5, "~"), {}, {}, text_cell("late")}},
          .notes = {"us at 1 GHz"}};
}

TEST(Table, TextStandsInColumns) {
  EXPECT_EQ(table_text(example()),
            "  Times\n"
            "  name     frame, us  front\n"
            "  grün, a     1000.2      2\n"
            "  x|\"y\"       ~582.5         late\n"
            "  us at 1 GHz\n");
  EXPECT_EQ(tables_text({{.notes = {"a"}}, {.notes = {"b"}}}), "  a\n\n  b\n");
  EXPECT_EQ(table_text({}), "");
}

// A long text that stands last goes on in its own column, unless too little is left of the line.
TEST(Table, LongTextGoesOnBelow) {
  std::string words;
  for (int i = 0; i < 30; ++i) words += "word ";
  Table table = {.columns = {{.heading = "key", .word = true}, {.heading = "what", .word = true, .wrapped = true}},
                 .rows = {{text_cell("a"), text_cell(words + "end")}, {text_cell("b"), text_cell("short")}}};
  const std::string text = table_text(table);
  EXPECT_TRUE(text.starts_with("  key  what\n  a    word word ")) << text;
  EXPECT_NE(text.find("word\n       word word "), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with(" end\n  b    short\n")) << text;
  EXPECT_EQ(text.find('\n', 13) - 12, 116u) << "a word more would stand beyond 120 places";
  table.rows[0][0] = text_cell(std::string(90, 'k'));
  EXPECT_NE(table_text(table).find(words + "end\n"), std::string::npos);
}

TEST(Table, CsvHasAllColumnsAndFullNumbers) {
  EXPECT_EQ(table_csv(example()),
            "name,us,front,empty,remark\n"
            "\"grün, a\",1000.25,2,,\n"
            "\"x|\"\"y\"\"\",582.5,,,late\n");
}

TEST(Table, APageSortsByNumbers) {
  const nlohmann::ordered_json json = table_json(example());
  ASSERT_EQ(json["columns"].size(), 4u) << "an empty column is left out";
  EXPECT_EQ(json["columns"][1]["name"], "frame, us");
  EXPECT_EQ(json["rows"][1][1].dump(), R"({"text":"~582.5","value":582.5})");
  EXPECT_EQ(json["rows"][1][2], "");
  EXPECT_EQ(json["notes"][0], "us at 1 GHz");
}

// Infinity shows, and stands in no JSON.
TEST(Table, WhatIsNotFiniteHasNoValue) {
  const TableColumn column = {.digits = 2};
  EXPECT_EQ(cell_text(number_cell(HUGE_VAL), column), "inf");
  const Table table = {.columns = {column}, .rows = {{number_cell(HUGE_VAL)}}};
  EXPECT_EQ(table_json(table)["rows"][0][0], "inf");
}

}  // namespace
}  // namespace pipegs
