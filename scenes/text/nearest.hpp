// SPDX-License-Identifier: Apache-2.0
// nearest: the word that somebody who wrote another one may have meant.
//
// Rule    A known word that holds the other one is as near as one wrong letter; else the fewest letters to change, add
//         or leave out count, capitals like small ones. Of equals the first.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pipegs {

// "" when nothing is known.
std::string nearest_word(std::string_view word, const std::vector<std::string>& known);

}  // namespace pipegs
