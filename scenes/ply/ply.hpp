// SPDX-License-Identifier: Apache-2.0
// ply: INRIA's point_cloud.ply, the common tongue of trained Gaussian scenes.
//
// Reads   binary little- and big-endian and ASCII; properties by name in any order and of any scalar
//         type; missing normals; missing scale_2 (2DGS: a flat splat); 0, 9, 24 or 45 f_rest; other
//         properties and elements, also lists, are skipped; CRLF headers; comments
//         "antialiased 1" and "SplatRenderMode: mip" set Scene::antialiased.
// Writes  binary little-endian float with INRIA's own property list, zero normals included.
// Rule    Nothing is allocated on the header's word: counts are checked against the file's size. Every element is
//         read to its end, an ASCII row is one line, numbers are whole and fit their type, and nothing follows the last
//         element.
// Errors  InputError with the header line, or "vertex 17, opacity".
#pragma once

#include <filesystem>
#include <iosfwd>

#include "scenes/ply/ply_file.hpp"
#include "scenes/scene.hpp"

namespace pipegs {

Scene read_ply(const std::filesystem::path& path);
Scene read_ply(PlySource& source);  // without a name
Scene read_ply(PlySource& source, const PlyHeader& header);
bool says_antialiased(const PlyHeader& header);
void write_ply(const std::filesystem::path& path, const Scene& scene);
void write_ply(std::ostream& stream, const Scene& scene);

}  // namespace pipegs
