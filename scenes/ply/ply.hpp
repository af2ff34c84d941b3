// SPDX-License-Identifier: Apache-2.0
// ply: INRIA's point_cloud.ply, the common tongue of trained Gaussian scenes.
//
// Reads   binary little- and big-endian and ASCII; properties by name (ply_layout.hpp) in any order and of any scalar
//         type; other elements, also lists, are skipped; CRLF headers; comments "antialiased 1" and "SplatRenderMode:
//         mip" set Scene::antialiased.
// Writes  binary little-endian float with INRIA's own property list, zero normals included; no infinity and no NaN: a
//         Gaussian that is culled is left out, a flat axis becomes the least float, an infinite logit one of 20.
// Rule    Nothing is allocated on the header's word: counts are checked against the file's size. Every element is
//         read to its end, an ASCII row is one line, numbers are whole and fit their type. What follows is said.
// Errors  InputError with the header line, or "vertex 17, opacity".
#pragma once

#include <filesystem>
#include <iosfwd>

#include "scenes/ply/ply_file.hpp"
#include "scenes/scene.hpp"

namespace pipegs {

struct SceneFormat;

Scene read_ply(const std::filesystem::path& path);
Scene read_ply(PlySource& source);  // without a name
Scene read_ply(PlySource& source, const PlyHeader& header, SceneFormat& format);
bool says_antialiased(const PlyHeader& header);
// A finding when something follows the last element.
void tell_rest(PlySource& source, const PlyHeader& header, SceneFormat& format);
// How many Gaussians were left out. `origin` is what was subtracted from the positions, a comment.
std::size_t write_ply(const std::filesystem::path& path, const Scene& scene, const glm::dvec3& origin = glm::dvec3(0));
std::size_t write_ply(std::ostream& stream, const Scene& scene, const glm::dvec3& origin = glm::dvec3(0));

}  // namespace pipegs
