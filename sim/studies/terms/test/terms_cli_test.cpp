// SPDX-License-Identifier: Apache-2.0
// terms_cli_test: `pipegs terms` as a person meets it: text and JSON say the same, bad input.
#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::json;

class TermsCli : public Cli {
 protected:
  const std::string view_ = "terms scene.ply --cameras cameras.json ";
};

TEST_F(TermsCli, TextAndJsonTellTheSame) {
  const Outcome json = run(view_ + "--json"), text = run(view_);
  ASSERT_EQ(json.code, 0) << json.err;
  ASSERT_EQ(text.code, 0) << text.err;
  const Json found = Json::parse(json.out);
  const auto shows = [&](const std::string& what) { EXPECT_NE(text.out.find(what), std::string::npos) << what; };
  const Json& search = found["search"];
  shows(std::to_string(search["sets"].get<size_t>()) + " sets of terms; " +
        std::to_string(search["speeds"]["sets"].get<size_t>()) + " with all three");
  for (const Json& row : found["closed"]) shows(row["equation"].get<std::string>());
  for (const Json& row : found["assumptions"]) shows(row["words"].get<std::string>());
  for (const Json& row : found["waterfall"]) shows(row["value"].get<std::string>());
  for (const auto& [key, figure] : found["paper"]["figures"].items()) shows(figure["what"].get<std::string>());
  for (const char* rung : {"baseline", "dpc", "hgr", "dop"}) {
    EXPECT_GT(found["ours"][rung]["cycles"], 0);
    EXPECT_GT(found["paper"]["rungs"][rung]["cycles"], 0);
  }
  EXPECT_EQ(found["ours"]["baseline"]["cycles"], found["ours"]["dpc"]["cycles"]);
  EXPECT_EQ(found["search"]["nearest"]["terms"].size(), found["assumptions"].size());
}

TEST_F(TermsCli, BadInputIsOneLine) {
  expect_refused(view_ + "--window 0,0", "--window: terms counts the whole view, expected none");
  expect_refused(view_ + "--memory ideal", "--memory: found ideal, terms expects a DRAM");
  expect_refused(view_ + "--view 1", "--view: found 1, expected 0 to 0");
  expect_refused("terms missing.ply --cameras cameras.json", "missing.ply");
}

}  // namespace
}  // namespace pipegs
