// SPDX-License-Identifier: Apache-2.0
// read_scene: a scene from a file of any format that is read here, recognised by its content, not by its name.
//
// Idea    Signatures first: "ply" (INRIA's or compressed, by its properties), gzip and NGSP (.spz), glTF, PK (a bundle
//         of SOG), an object of JSON (SOG, streamed SOG or .gltf, by its keys). .ksplat and .splat have none: they are
//         what they look like. A folder is the lod-meta.json or meta.json in it.
// Errors  InputError; of a file that is none of them with what it begins with.
#pragma once

#include <filesystem>
#include <string>

#include "scenes/formats/format.hpp"

namespace pipegs {

// `format`, when it is asked for, says what the file was.
Scene read_scene(const std::filesystem::path& path, const ReadOptions& options = {}, SceneFormat* format = nullptr);
// Bytes in memory; without a name.
Scene read_scene(const InputFile& file, const ReadOptions& options, SceneFormat& format);

}  // namespace pipegs
