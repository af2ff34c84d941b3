// SPDX-License-Identifier: Apache-2.0
// Against scenes/ply/ply: broken and hostile files give one clear line, never a crash or an allocation.
//
// Idea    Each case names the words its message must hold. Then every prefix of a good file must be read or refused,
//         nothing else; random bytes are the work of verif/fuzz.
#include "scenes/formats/format.hpp"
#include "scenes/ply/ply.hpp"
#include "verif/scenes/ply_file.hpp"
#include "verif/scenes/refused.hpp"

namespace pipegs {
namespace {

void expect_refused(const std::string& content, const std::vector<std::string>& words) {
  const ScratchFolder scratch;
  const auto path = scratch.write("bad.ply", content);
  expect_one_line([&] { read_ply(path); }, words, content);
  EXPECT_TRUE(refusal([&] { read_ply(path); }).starts_with(path.string() + ": "));
}

std::string without(const std::string& name) {
  auto columns = plain_columns(2, 0);
  std::erase_if(columns, [&](const Column& c) { return c.name == name; });
  return PlyText{}.build(columns);
}

TEST(PlyHostile, NamesTheMissingProperty) {
  for (const char* name : {"x", "y", "z", "f_dc_0", "f_dc_2", "opacity", "scale_0", "scale_1", "rot_0", "rot_3"}) {
    expect_refused(without(name), {"line 3", std::string("property ") + name, "missing"});
  }
}

TEST(PlyHostile, RefusesWrongNumbersOfRest) {
  for (int rest : {1, 8, 10, 23, 44, 46, 71})
    expect_refused(PlyText{}.build(plain_columns(1, rest)), {"f_rest", std::to_string(rest), "0, 9, 24 or 45"});
  auto columns = plain_columns(1, 9);
  for (Column& c : columns) {
    if (c.name == "f_rest_3") c.name = "f_rest_30";
  }
  expect_refused(PlyText{}.build(columns), {"f_rest", "up to 30"});
}

TEST(PlyHostile, ChecksTheCountAgainstTheFile) {
  const std::string good = PlyText{}.build(plain_columns(2, 45));
  for (const char* count : {"3", "1000000000000", "18446744073709551615"}) {
    expect_refused(replaced(good, "element vertex 2", std::string("element vertex ") + count),
                   {"line 3", count, "truncated"});
  }
  for (const char* count : {"-1", "2.5", "many", "18446744073709551616", "0x10"}) {
    expect_refused(replaced(good, "element vertex 2", std::string("element vertex ") + count), {"line 3", "count"});
  }
  PlyText ascii;
  ascii.format = "ascii";
  expect_refused(replaced(ascii.build(plain_columns(2, 0)), "element vertex 2", "element vertex 99999999999"),
                 {"truncated"});
  expect_refused(good.substr(0, good.size() - 1), {"truncated"});
}

TEST(PlyHostile, RefusesNonsenseHeaders) {
  const std::string good = PlyText{}.build(plain_columns(1, 0));
  expect_refused("", {"line 1"});
  expect_refused("PNG\n", {"line 1", "expected 'ply'"});
  expect_refused(std::string(3 << 20, 'x'), {"line 1", "does not end"});
  expect_refused("ply\nformat ascii 1.0\n" + std::string(2 << 20, '\n'), {"does not end"});
  for (const char* body : {"1 2 3\r", "\1\2\n\3"})
    expect_refused(std::string("ply\rformat ascii 1.0\rend_header\r") + body, {"carriage returns alone"});
  expect_refused(replaced(good, "binary_little_endian", "binary_middle_endian"), {"line 2", "binary_middle_endian"});
  expect_refused(replaced(good, "endian 1.0", "endian 2.0"), {"line 2", "2.0"});
  expect_refused(replaced(good, "format binary_little_endian 1.0\n", ""), {"format", "missing"});
  expect_refused(replaced(good, "property float y", "property quad y"), {"line 5", "quad"});
  expect_refused(replaced(good, "property float y", "property float"), {"line 5"});
  expect_refused(replaced(good, "property float y", "property float x"), {"line 5", "second 'x'"});
  expect_refused(replaced(good, "property float y", "property list float int y"), {"line 5", "integer type"});
  expect_refused(replaced(good, "property float y", "property list uchar float y"), {"line 5", "y", "list"});
  expect_refused(replaced(good, "element vertex 1\n", "property float w\nelement vertex 1\n"),
                 {"line 3", "before any element"});
  expect_refused(replaced(good, "element vertex 1\n", "element vertex 1\nelement vertex 1\n"), {"line 4", "second"});
  expect_refused(replaced(good, "element vertex 1\n", "element point 1\n"), {"vertex", "missing"});
  expect_refused(replaced(good, "ply\n", "ply\nnonsense here\n"), {"line 2", "nonsense"});
  expect_refused(
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uint packed_position\nend_header\n1234",
      {"property x is missing"});
}

TEST(PlyHostile, PointsIntoTheBody) {
  PlyText ascii;
  ascii.format = "ascii";
  const std::string good = ascii.build(plain_columns(2, 0));
  const std::string start = good.substr(0, good.find("end_header\n") + 11);
  expect_refused(start + "1 2 three 4 5 6 7 8 9 10 11 12 13 14 15 16 17 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1",
                 {"vertex 0, z", "three"});
  expect_refused(
      start + "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17\n1 1 1 1 1 1 1 1 1 1 1 1 1 1                        ",
      {"vertex 1, rot_1", "the file ends"});
  std::string list =
      "ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list uint double v\nelement vertex "
      "0\nend_header\n";
  append_value(list, "uint", 4294967295.0, false);
  expect_refused(list, {"face 0, v", "list"});
}

// A row is a line of as many numbers as the element has properties, each whole and of its property's type.
TEST(PlyHostile, HoldsEachAsciiRowAgainstTheHeader) {
  const auto body = [](const std::string& rows) {
    return "ply\nformat ascii 1.0\nelement camera 2\nproperty uchar a\nproperty float b\nelement vertex 0\n"
           "property float x\nend_header\n" +
           rows;
  };
  expect_refused(body("1\n2 3\n4 5\n"), {"camera 0, b", "the line ends"});
  expect_refused(body("1 2 3\n4 5\n"), {"camera 0, line", "'3'", "behind the last value"});
  for (const char* number : {"256", "-1", "1.5", "1e1", "nan", "++1", "0x1", "1,"})
    expect_refused(body("1 2\n" + std::string(number) + " 5\n"),
                   {"camera 1, a", quote(number), "integer from 0 to 255"});
  for (const char* number : {"+-2", "--2", "2f", "0x2", "two", "1,5"})
    expect_refused(body("1 2\n1 " + std::string(number) + "\n"), {"camera 1, b", quote(number), "a number"});
  expect_refused(body("1 " + std::string(600, '7') + "\n1 2\n"), {"found the word '777", "expected a number"});
  expect_refused(body("1 2\n\n \n1 2\n"), {"x", "missing"});  // blank lines between rows do not count
}

TEST(PlyHostile, NamesWhatFollowsTheLastElement) {
  const auto expect_said = [](const std::string& bytes, const std::string& words) {
    PlySource source("a.ply", bytes);
    SceneFormat format;
    EXPECT_EQ(read_ply(source, read_ply_header(source), format).gaussians.size(), 2u);
    ASSERT_FALSE(format.findings.empty());
    EXPECT_EQ(format.findings.back().kind->key, "behind_end");
    EXPECT_NE(format.findings.back().what.find(words), std::string::npos) << format.findings.back().what;
  };
  PlyText text;
  text.body_after = "12345";
  expect_said(text.build(plain_columns(2, 0)), "5 bytes behind the last Gaussian");
  text.elements_after = "element camera 2\nproperty uchar id\n";
  expect_said(text.build(plain_columns(2, 0)), "3 bytes");
  text.elements_after = "element camera 1000000\nproperty uchar id\n";
  expect_refused(text.build(plain_columns(2, 0)), {"element 'camera'", "1000000", "truncated"});
  PlyText ascii;
  ascii.format = "ascii";
  ascii.body_after = "\n \n7 8\n";
  expect_said(ascii.build(plain_columns(2, 0)), "4 bytes");
}

TEST(PlyHostile, AFieldComesOnce) {
  const std::string good = PlyText{}.build(plain_columns(1, 9));
  expect_refused(replaced(good, "f_rest_8", "f_rest_7"), {"second 'f_rest_7'"});
  expect_refused(replaced(good, "f_rest_8", "f_rest_07"), {"f_rest", "found 8 properties"});
  expect_refused(replaced(good, "f_rest_8", "f_rest_+7"), {"f_rest", "found 8 properties"});
  std::string many = "ply\nformat ascii 1.0\n";
  for (int i = 0; i < 100; ++i) many += fmt::format("element e{} 0\n", i);
  expect_refused(many + "end_header\n", {"more than 64 elements"});
  expect_refused(replaced(good, "end_header\n", "end_header now\n"), {"end_header", "expected nothing behind it"});
}

TEST(PlyHostile, OnlyARegularFileIsOpened) {
  expect_only_regular_files([](const std::filesystem::path& path) { read_ply(path); });
  const ScratchFolder scratch;
  expect_one_line([&] { read_ply(scratch / "nothing.ply"); }, {"found no file, expected a .ply file"});
  expect_one_line([&] { read_ply(scratch / ""); }, {"found a folder"});
}

// Names are bytes; reports are UTF-8.
TEST(PlyHostile, ALatin1NameBecomesUtf8) {
  const ScratchFolder scratch;
  const Scene scene = read_ply(scratch.write("caf\xe9.ply", PlyText{}.build(plain_columns(1, 0))));
  EXPECT_EQ(scene.name, "caf\xef\xbf\xbd");
  expect_refused(replaced(PlyText{}.build(plain_columns(1, 0)), "float y", "caf\xe9 y"), {"line 5", "caf?"});
}

TEST(PlyHostile, SurvivesEveryPrefix) {
  const ScratchFolder scratch;
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    PlyText text;
    text.format = format;
    text.elements_before = "element face 1\nproperty list uchar int v\n";
    text.body_before = std::string(format) == "ascii" ? "1 5\n" : std::string("\0", 1);
    const std::string good = text.build(plain_columns(3, 9));
    for (std::size_t n = 0; n + 8 < good.size(); n += 3)  // of the last number a part is a number, too
      expect_one_line([&] { read_ply(scratch.write("a.ply", good.substr(0, n))); }, {}, good.substr(0, n));
  }
}

}  // namespace
}  // namespace pipegs
