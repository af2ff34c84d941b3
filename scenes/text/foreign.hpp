// SPDX-License-Identifier: Apache-2.0
// foreign: what a file is that is none of those that are read here, by its first bytes.
//
// Idea    People name the pointer that Git LFS left, a web page that a download saved, an archive, a photograph, a
//         point cloud of another program. "Not JSON" or "no scene" sends them the wrong way; a word about the file does
//         not.
#pragma once

#include <string>
#include <string_view>

namespace pipegs {

// "a Git LFS pointer, not the file itself: git lfs pull fetches it"; empty when it is nothing that is known.
std::string foreign_kind(std::string_view begin);

// InputError that says so when the bytes are foreign; what `expected` is, such as "a scene".
void refuse_foreign(const std::string& file, std::string_view begin, std::string_view expected);

}  // namespace pipegs
