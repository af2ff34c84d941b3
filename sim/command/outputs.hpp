// SPDX-License-Identifier: Apache-2.0
// outputs.hpp: what a command will write is tried before anything is computed, and written whole or not at all.
//
// Idea    A run takes minutes; that --out cannot be written must be known in its first second. A try looks for the
//         nearest folder above that exists, writes an empty file in it and takes that away again, so a command that
//         is refused leaves nothing behind. Folders that are missing are made when the file is written.
// Errors  InputError (the option and its value) from the tries, OwnFailure from the writers: what could be written
//         before the run and cannot be afterwards is a full disk or the like.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>

#include "cpp_model/float/image.hpp"

namespace pipegs {

// The folder that `option` names, and the files that will be written in it.
void try_folder(const std::string& option, const std::filesystem::path& folder,
                std::initializer_list<const char*> files = {});
// The file that `option` names; nothing without one.
void try_file(const std::string& option, const std::filesystem::path& file);

// Makes the folder in which `file` will lie; std::runtime_error when the program is to end.
void make_folder_of(const std::filesystem::path& file);

// frame.exr and frame.png: the 8-bit picture of the image, or the one that is given.
void write_images(const std::string& folder, const Image& image, const std::optional<Rgb8>& picture = {});
void write_text(const std::filesystem::path& path, const std::string& text);

}  // namespace pipegs
