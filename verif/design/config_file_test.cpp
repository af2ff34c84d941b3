// SPDX-License-Identifier: Apache-2.0
// Against sim/design/config_file: each line is one entry, read whole, once; the first bad one is named.
#include "sim/design/config_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "sim/design/design_point.hpp"

namespace pipegs {
namespace {

class ConfigFile : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(path_); }
  Config read(const std::string& text) {
    std::ofstream(path_) << text;
    Config config;
    apply_config_file(path_, config);
    return config;
  }
  std::string refused(const std::string& text) {
    try {
      read(text);
    } catch (const ConfigError& error) { return error.what(); }
    return "accepted";
  }
  const std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / ("pipegs_config_" + std::to_string(getpid()) + ".cfg");
};

// The machine that verif/frame runs in RTL.
TEST_F(ConfigFile, TheFineNumbersOfExact) {
  Config config = find_design_point("exact").config;
  apply_config_file(PIPEGS_SOURCE_DIR "/sim/fine.cfg", config);
  EXPECT_EQ(config_difference(config),
            "late=1,order=2,pos_w=18,base_w=14,mantissa_w=22,coeff_f=24,alpha_w=10,records=2048,bucket_bits=5");
  EXPECT_EQ(config.gaussians_per_line(), 2) << "as many bytes as by default";
}

TEST_F(ConfigFile, BlanksAndCommentsDoNotCount) {
  Config expected;
  expected.alpha_w = 10, expected.units = 2;
  EXPECT_EQ(read("# all of it\n\n  alpha_w = 10   # bits\r\n\tunits=2"), expected);
  EXPECT_EQ(read("\xef\xbb\xbf"
                 "alpha_w=10\r# as old editors write it\runits=2\r"),
            expected);
}

TEST_F(ConfigFile, TheFirstBadLineIsNamed) {
  for (const auto& [text, place, what] :
       {std::tuple{"units=2\nalpha_w=99\n", ":2: ", "found '99', expected an integer from 6 to 12"},
        {"nonsense=1", ":1: ", "unknown key 'nonsense'"},
        {"# fine\n\nalpha_w", ":3: ", "expected key=value"},
        {"alpha_w=", ":1: ", "found ''"},
        {"alpha_w=1 0\n", ":1: ", "found '1 0', expected an integer from 6 to 12"},
        {"al pha_w=10\n", ":1: ", "unknown key 'al pha_w'"},
        {"alpha_w=+-8", ":1: ", "found '+-8'"},
        {"alpha_w=8.0", ":1: ", "found '8.0'"},
        {"alpha_w=8x", ":1: ", "found '8x'"},
        {"alpha_w=-8", ":1: ", "found '-8'"},
        {"alpha_w=--8", ":1: ", "found '--8'"},
        {"alpha_w=nan", ":1: ", "found 'nan'"},
        {"alpha_w=inf", ":1: ", "found 'inf'"},
        {"alpha_w=-4294967288", ":1: ", "found '-4294967288'"},
        {"alpha_w=4294967304", ":1: ", "found '4294967304'"},
        {"alpha_w=8=9", ":1: ", "found '8=9'"},
        {"alpha_w=8 units=2", ":1: ", "found '8 units=2'"},
        {"units=2\nalpha_w=8\n\n alpha_w = 9", ":4: ", "found a second 'alpha_w', the first is in line 2"},
        {"alpha_w=\xe9\x1b[2J", ":1: ", "?[2J', expected an integer"}}) {
    const std::string error = refused(text);
    EXPECT_NE(error.find(path_.string() + place), std::string::npos) << error;
    EXPECT_NE(error.find(what), std::string::npos) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos);
    EXPECT_EQ(error.find("--set"), std::string::npos) << error;
  }
}

TEST_F(ConfigFile, OnlyARegularFileOfSomeSizeIsRead) {
  const auto refused_path = [](const std::filesystem::path& path) -> std::string {
    try {
      Config config;
      apply_config_file(path, config);
    } catch (const ConfigError& error) { return error.what(); }
    return "accepted";
  };
  EXPECT_NE(refused_path("/nowhere/at/all.cfg").find("found no file, expected a configuration file"),
            std::string::npos);
  EXPECT_NE(refused_path("/tmp").find("found a folder"), std::string::npos);
  EXPECT_NE(refused_path("/dev/zero").find("found a device"), std::string::npos);
  ASSERT_EQ(mkfifo(path_.c_str(), 0600), 0);
  EXPECT_NE(refused_path(path_).find("found a pipe"), std::string::npos);
  std::filesystem::remove(path_);
  EXPECT_NE(refused("#" + std::string(1 << 20, '\n')).find("1048577 bytes"), std::string::npos);
}

}  // namespace
}  // namespace pipegs
