// SPDX-License-Identifier: Apache-2.0
// Against scenes/text/csv: a table is read as its header says, field by field, or the line and column are named.
#include "scenes/text/csv.hpp"

#include "verif/scenes/refused.hpp"

namespace pipegs {
namespace {

constexpr const char* kHeader = "name,count,size";

struct Row {
  std::string name;
  uint64_t count;
  double size;
  bool operator==(const Row&) const = default;
};

std::vector<Row> rows_of(const std::string& text) {
  std::vector<Row> rows;
  parse_csv("a.csv", text, kHeader, [&](const CsvRow& row) {
    rows.push_back({row.text("name"), row.integer<uint64_t>("count"), row.real("size", kNotNegative)});
  });
  return rows;
}

void expect_refused(const std::string& text, const std::string& part) {
  const std::string message = refusal([&] { rows_of(text); }, text);
  EXPECT_TRUE(message.starts_with("a.csv: ")) << message;
  EXPECT_NE(message.find(part), std::string::npos) << "no '" << part << "' in: " << message;
}

TEST(Csv, ReadsBareAndQuotedFields) {
  const std::vector<Row> expected = {{"one", 1, 0.5}, {"late=1,order=1", 2, 1e-3}, {"a \"b\"", 3, 0}, {"", 4, 1}};
  const std::string rows = "one,1,0.5\n\"late=1,order=1\",2,1e-3\n\"a \"\"b\"\"\",3,0\n,4,1";
  EXPECT_EQ(rows_of("name,count,size\n" + rows), expected);
  EXPECT_EQ(rows_of("name,count,size\n" + rows + "\n"), expected);
  EXPECT_EQ(rows_of("# by hand\n# twice\nname,count,size\n# measured\n" + rows + "\n# the end"), expected);
  for (const char* text : {"name,count,size\r\none,1,0.5\r\n", "\xef\xbb\xbfname,count,size\rone,1,0.5\r"})
    EXPECT_EQ(rows_of(text), std::vector<Row>({expected[0]}));
}

TEST(Csv, TheHeaderIsExact) {
  for (const char* header : {"name,count", "name,count,size,size", "name,count,count", "name, count,size",
                             "Name,count,size", "", "name,count,size,"})
    expect_refused(std::string(header) + "\none,1,1\n",
                   "line 1: found " + quote(header) + ", expected name,count,size");
  expect_refused("", "found no header, expected name,count,size");
  expect_refused("# only this", "found no header");
}

TEST(Csv, ARowHasTheFieldsOfTheHeader) {
  expect_refused("name,count,size\none,1\n", "line 2: found 2 fields, expected 3");
  expect_refused("name,count,size\none,1,1\none,1,1,1\n", "line 3: found 4 fields, expected 3");
  expect_refused("name,count,size\none,1,1,\n", "line 2: found 4 fields");
  expect_refused("name,count,size\n\none,1,1\n", "line 2: found 1 fields");
  expect_refused("name,count,size\n # late\n", "line 2: found 1 fields");
  expect_refused("name,count,size\n\"one,1,1\n", "line 2: found a quote that does not end");
  expect_refused("name,count,size\n\"one\" ,1,1\n", "line 2: found text behind a quoted field");
  expect_refused("name,count,size\no\"n\"e,1,1\n", "line 2: found a quote inside of a field");
}

TEST(Csv, NumbersAreReadWhole) {
  for (const char* number : {"", "-1", "1.0", " 1", "1 ", "+-1", "1x", "18446744073709551616"})
    expect_refused("name,count,size\none," + std::string(number) + ",1\n", "line 2, count: found " + quote(number));
  for (const char* number : {"", "-1", "nan", "inf", "1e999", " 1", "1 0", "0x1", "1.5.2"})
    expect_refused("name,count,size\none,1," + std::string(number) + "\n", "line 2, size: found " + quote(number));
}

TEST(Csv, WhatTheVisitorFindsGetsTheLine) {
  const auto refused = [](const auto& visit) {
    return refusal([&] { parse_csv("a.csv", "name,count,size\none,1,1\n", kHeader, visit); });
  };
  EXPECT_EQ(refused([](const CsvRow&) { throw std::runtime_error("no such thing"); }), "a.csv: line 2: no such thing");
  EXPECT_EQ(refused([](const CsvRow& row) { row.fail("name", "seen before"); }), "a.csv: line 2, name: seen before");
  EXPECT_THROW(refused([](const CsvRow& row) { row.text("color"); }), std::invalid_argument) << "a caller's mistake";
}

TEST(Csv, OnlyARegularFileIsRead) {
  const ScratchFolder scratch;
  const auto read = [](const std::filesystem::path& path) { read_csv(path, kHeader, [](const CsvRow&) {}); };
  expect_only_regular_files(read);
  expect_one_line([&] { read(scratch / ""); }, {"found a folder"});
  scratch.write("large.csv", "");
  std::filesystem::resize_file(scratch / "large.csv", std::uintmax_t{1} << 40);
  expect_one_line([&] { read(scratch / "large.csv"); }, {"found 1099511627776 bytes"});
  EXPECT_NO_THROW(read(scratch.write("good.csv", "name,count,size\ncaf\xe9,1,1\n")));
}

}  // namespace
}  // namespace pipegs
