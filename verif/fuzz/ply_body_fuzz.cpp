// SPDX-License-Identifier: Apache-2.0
// ply_body_fuzz: any bytes as the body of a .ply with one of a few headers; the first byte says which.
//
// Idea    Headers cost a fuzzer its time, so here they are good ones: all three formats, with lists and mixed types, of
//         no and one SH degree. What is read is a scene that holds together and fits the file, and can be
//         looked at as a whole, or an InputError.
#include <fmt/format.h>

#include <cstdlib>

#include "scenes/check/scene_check.hpp"
#include "scenes/check/view_check.hpp"
#include "scenes/input_error.hpp"
#include "scenes/ply/ply.hpp"
#include "verif/fuzz/keep.hpp"

namespace {

std::string header_of(std::uint8_t which) {
  static constexpr const char* kFormats[] = {"ascii", "binary_little_endian", "binary_big_endian"};
  const bool lists = (which & 4) != 0, mixed = (which & 8) != 0, rest = (which & 16) != 0;
  std::string text = fmt::format("ply\nformat {} 1.0\n", kFormats[which % 3]);
  if (lists) text += "element face 1\nproperty list uchar short corners\n";
  text += fmt::format("element vertex {}\n", 1 + which / 64);
  for (const char* name : {"x", "y", "z", "f_dc_0", "f_dc_1", "f_dc_2", "opacity", "scale_0", "scale_1", "rot_0",
                           "rot_1", "rot_2", "rot_3"})
    text += fmt::format("property {} {}\n", mixed && name[0] == 's' ? "uchar" : mixed ? "double" : "float", name);
  if (lists) text += "property list int float more\n";
  for (int i = 0; i < (rest ? 9 : 0); ++i) text += fmt::format("property float f_rest_{}\n", i);
  return text + "end_header\n";
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pipegs;
  if (size == 0) return 0;
  try {
    PlySource source("fuzz.ply", header_of(data[0]) + std::string(reinterpret_cast<const char*>(data) + 1, size - 1));
    const Scene scene = read_ply(source);
    check_consistent(scene);
    if (scene.gaussians.size() > size) std::abort();
    Camera camera;
    camera.width = camera.height = 64;
    camera.fx = camera.fy = 50;
    for (const Findings& found : {check_scene(scene), check_views(scene, {&camera, 1}, 0.2)}) {
      for (const Finding& finding : found) {
        if (finding.count > scene.gaussians.size() || finding_line(finding).find('\n') != std::string::npos)
          std::abort();
      }
    }
    Kept<10> kept;
    for (std::size_t i = 0; i < scene.gaussians.size(); ++i) {
      ActivatedGaussian activated;
      kept.add(activate(scene, i, activated) == Cull::kNone ? "drawn" : "not drawn");
    }
  } catch (const InputError& error) { refused(error); }
  return 0;
}
