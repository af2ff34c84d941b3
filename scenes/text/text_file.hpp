// SPDX-License-Identifier: Apache-2.0
// text_file: a whole file of text in memory, line by line when wanted.
//
// Rule    Only a regular file is opened: a folder has no text, and a pipe or a device may never end. Its size is held
//         against the caller's limit before any memory is taken.
// Errors  InputError with what was found in the file's place.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pipegs {

// InputError unless `path` is a regular file; `expected` is what the caller wants there, such as "a .ply file".
void require_regular_file(const std::filesystem::path& path, std::string_view expected);

std::string read_text_file(const std::filesystem::path& path, std::string_view expected, std::uint64_t most_bytes);

// The lines without their LF, CRLF or CR, the first without the mark of UTF-8; what follows the last is a line when
// there is something.
std::vector<std::string_view> lines_of(std::string_view text);

}  // namespace pipegs
