// SPDX-License-Identifier: Apache-2.0
// refused.hpp: what every reader owes to bad input: one short line that says these words.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "scenes/input_error.hpp"

namespace pipegs {

// `input` is told when `read` does not throw InputError.
inline void expect_one_line(const std::function<void()>& read, const std::vector<std::string>& words,
                            const std::string& input = "") {
  try {
    read();
    ADD_FAILURE() << "was accepted: " << input;
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find('\n'), std::string::npos);
    EXPECT_LT(message.size(), 500u) << message;
    for (const std::string& word : words)
      EXPECT_NE(message.find(word), std::string::npos) << "no '" << word << "' in: " << message;
  }
}

}  // namespace pipegs
