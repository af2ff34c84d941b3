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

// Whether a text of ASCII has this byte.
inline bool is_printable(unsigned char c) { return (c >= ' ' && c <= '~') || (c >= '\t' && c <= '\r'); }

// "a Git LFS pointer, not the file itself: git lfs pull fetches it"; empty when it is nothing that is known.
std::string foreign_kind(std::string_view begin);

// The mark of UTF-8 that Windows puts before a text, which means nothing.
inline constexpr std::string_view kUtf8Mark = "\xef\xbb\xbf";
inline std::string_view without_mark(std::string_view text) {
  return text.substr(text.starts_with(kUtf8Mark) ? kUtf8Mark.size() : 0);
}

// InputError that says so when the bytes are foreign; what `expected` is, such as "a scene".
void refuse_foreign(const std::string& file, std::string_view begin, std::string_view expected);

}  // namespace pipegs
