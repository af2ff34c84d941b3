// config_file_test: configurations survive the way through a file; bad lines are named.
#include "sim/config_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "sim/accuracy/report.hpp"
#include "sim/rung.hpp"

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
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "accepted";
  }
  const std::filesystem::path path_ = std::filesystem::temp_directory_path() / ("pipegs_config_" + std::to_string(getpid()) + ".cfg");
};

TEST_F(ConfigFile, ComesBackAsItWasWritten) {
  Config config;
  for (const Rung& rung : rungs()) {
    apply_rung(rung, config);
    config.alpha_w = 10;
    EXPECT_EQ(read(config_file(config, "a comment")), config);
  }
  EXPECT_EQ(read(config_file(Config{}, "nothing")), Config{});
}

// The machine that verif/frame runs in RTL.
TEST_F(ConfigFile, TheFineNumbersOfExact) {
  Config config;
  apply_rung(find_rung("exact"), config);
  apply_config_file(PIPEGS_SOURCE_DIR "/sim/fine.cfg", config);
  EXPECT_EQ(config_difference(config), "late=1,order=2,pos_w=18,base_w=14,mantissa_w=22,coeff_f=24,alpha_w=10,records=2048");
  EXPECT_EQ(config.gaussians_per_line(), 2) << "as many bytes as by default";
}

TEST_F(ConfigFile, BlanksAndCommentsDoNotCount) {
  Config expected;
  expected.alpha_w = 10, expected.units = 2;
  EXPECT_EQ(read("# all of it\n\n  alpha_w = 10   # bits\r\n\tunits=2"), expected);
}

TEST_F(ConfigFile, TheFirstBadLineIsNamed) {
  for (const auto& [text, place, what] :
       {std::tuple{"alpha_w=10\nalpha_w=99\n", ":2: ", "found '99', expected an integer from 6 to 12"}, {"nonsense=1", ":1: ", "unknown key 'nonsense'"},
        {"# fine\n\nalpha_w", ":3: ", "expected key=value"}, {"alpha_w=", ":1: ", "found ''"}}) {
    const std::string error = refused(text);
    EXPECT_NE(error.find(path_.string() + place), std::string::npos) << error;
    EXPECT_NE(error.find(what), std::string::npos) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos);
    EXPECT_EQ(error.find("--set"), std::string::npos) << error;
  }
  Config config;
  EXPECT_THROW(apply_config_file("/nowhere/at/all.cfg", config), ConfigError);
  EXPECT_THROW(apply_config_file("/tmp", config), ConfigError);
}

}  // namespace
}  // namespace pipegs
