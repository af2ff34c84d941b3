// SPDX-License-Identifier: Apache-2.0
// refused.hpp: what every reader owes to bad input: one short line that says these words.
#pragma once

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "scenes/input_error.hpp"
#include "verif/scenes/scratch_folder.hpp"

namespace pipegs {

// The line, of InputError; `input` is shown when `read` does not throw it.
inline std::string refusal(const std::function<void()>& read, const std::string& input = "") {
  try {
    read();
    ADD_FAILURE() << "was accepted: " << input.substr(0, 300);
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find('\n'), std::string::npos);
    EXPECT_LT(message.size(), 300u) << message;
    return message;
  }
  return "";
}

inline void expect_one_line(const std::function<void()>& read, const std::vector<std::string>& words,
                            const std::string& input = "") {
  const std::string message = refusal(read, input);
  for (const std::string& word : words)
    EXPECT_NE(message.find(word), std::string::npos) << "no '" << word << "' in: " << message;
}

// Neither a device nor a pipe is opened, which would never end.
inline void expect_only_regular_files(const std::function<void(const std::filesystem::path&)>& read) {
  const ScratchFolder scratch;
  ASSERT_EQ(mkfifo((scratch / "pipe").c_str(), 0600), 0);
  expect_one_line([&] { read(scratch / "nothing"); }, {"found no file"});
  expect_one_line([&] { read("/dev/zero"); }, {"found a device"});
  expect_one_line([&] { read(scratch / "pipe"); }, {"found a pipe"});
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

}  // namespace pipegs
