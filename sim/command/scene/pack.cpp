// SPDX-License-Identifier: Apache-2.0
// pack.cpp: `pipegs pack`: a scene in the machine's own format for a program that drives it: the tables as they lie in
// memory, and a C header with what the driver (cpp_model/driver/pipegs_frame.h) takes of them and of a camera.
#include <fmt/format.h>

#include <bit>
#include <fstream>

#include "cpp_model/frame_setup.hpp"
#include "scenes/atomic_file.hpp"
#include "scenes/own_failure.hpp"
#include "sim/command/command.hpp"

namespace pipegs {
namespace {

struct PackArguments {
  ViewArguments view;
  std::string out = "packed";
};

void write_image(const std::filesystem::path& path, const MemoryImage& image) {
  static_assert(std::endian::native == std::endian::little, "a line's bytes, the lowest first");
  AtomicFile out(path);
  std::ofstream stream(out.temporary(), std::ios::binary);
  stream.write(reinterpret_cast<const char*>(image.lines.data()),
               static_cast<std::streamsize>(image.lines.size() * sizeof(MemoryLine)));
  stream.close();
  if (!stream) throw OwnFailure(path.string() + ": cannot write");
  out.commit();
}

std::string text_of(const pipegs_number& number) {
  return fmt::format("{{INT64_C({}), {}}}", number.mantissa, number.exponent);
}
template <class Range>
std::string list_of(const Range& range) {
  std::string text;
  for (const auto& item : range) {
    text += text.empty() ? "{" : ", ";
    if constexpr (std::is_same_v<std::decay_t<decltype(item)>, pipegs_number>) text += text_of(item);
    if constexpr (std::is_same_v<std::decay_t<decltype(item)>, int64_t>) text += fmt::format("INT64_C({})", item);
    if constexpr (std::is_same_v<std::decay_t<decltype(item)>, uint64_t>) text += fmt::format("UINT64_C({})", item);
  }
  return text + "}";
}

std::string scene_header(const pipegs_scene& scene, const pipegs_camera& camera) {
  std::string text =
      "/* SPDX-License-Identifier: CC0-1.0\n"
      " * scene.h: printed by `pipegs pack` with image.bin: what the driver takes of the packed scene and the camera. "
      "*/\n"
      "#ifndef PIPEGS_PACKED_SCENE_H\n#define PIPEGS_PACKED_SCENE_H\n\n#include \"pipegs_frame.h\"\n\n"
      "static const struct pipegs_scene pipegs_packed_scene = {\n  .packed_for = {\n";
#define PRINT_FIELD(name, offset, low, width) text += fmt::format("    .{} = {}u,\n", #name, scene.packed_for.name);
  PIPEGS_CONFIGURATION(PRINT_FIELD)
#undef PRINT_FIELD
  text += fmt::format("  }},\n  .exponent = {},\n  .sh_degree = {}u,\n  .antialias = {}u,\n", scene.exponent,
                      scene.sh_degree, scene.antialias);
  text += fmt::format("  .grid_low = {},\n  .grid_scale = {},\n", list_of(scene.grid_low), list_of(scene.grid_scale));
  for (const auto& [name, value] : {std::pair{"cells", scene.cells},
                                    {"groups", scene.groups},
                                    {"chunks", scene.chunks},
                                    {"gaussians", scene.gaussians},
                                    {"colors", scene.colors},
                                    {"size", scene.size},
                                    {"slots", scene.slots}}) {
    text += fmt::format("  .{} = UINT64_C({}),\n", name, value);
  }
  text += fmt::format("}};\n\nstatic const struct pipegs_camera pipegs_packed_camera = {{\n  .position = {},\n",
                      list_of(camera.position));
  text += fmt::format("  .rotation = {{{},\n               {},\n               {}}},\n", list_of(camera.rotation[0]),
                      list_of(camera.rotation[1]), list_of(camera.rotation[2]));
  text += fmt::format("  .focal = {},\n  .center = {},\n  .near_plane = {},\n", list_of(camera.focal),
                      list_of(camera.center), text_of(camera.near_plane));
  return text + fmt::format("  .width = {}u,\n  .height = {}u,\n}};\n\n#endif\n", camera.width, camera.height);
}

int pack(const PackArguments& arguments) {
  SimulateOptions options = arguments.view.options();
  if (options.window) throw ConfigError("--window: found one, expected none: what is packed serves every window");
  if (arguments.view.walk_most)
    throw ConfigError("--walk-most: found one, expected none: the host says it in each job");
  if (arguments.view.rest != 0) throw ConfigError("--rest: found one, expected none: the host says it in each job");
  if (arguments.view.lod_pixels != 0)
    throw ConfigError("--lod-pixels: found one, expected none: the host says it in each job");
  try_folder("--out", arguments.out, {"image.bin", "scene.h"});
  const LoadedView loaded = load_view(arguments.view);
  follow_scene(loaded, options);
  const PackedScene packed = pack_views(loaded.scene, {loaded.camera}, options);
  // Refuses what the driver would refuse.
  const pipegs_job job = frame_job(options.config, packed, loaded.camera, {}, options.near_plane);
  const MemoryImage image = memory_image(packed);
  make_folder_of(arguments.out + "/image.bin");
  write_image(arguments.out + "/image.bin", image);
  write_text(arguments.out + "/scene.h",
             scene_header(driver_scene(packed), driver_camera(loaded.camera, options.near_plane)));
  fmt::print(
      "{0}/image.bin: {1} bytes, {2} Gaussians; {0}/scene.h: its tables and view {3}\n"
      "memory for image, frame and overflow areas: at most {4} bytes\n",
      arguments.out, image.lines.size() * sizeof(MemoryLine), packed.counts.packed, loaded.camera.name,
      job.frame.tables_overflow + job.areas.overflow + PIPEGS_OVERFLOW_ALIGNMENT - 64);
  return kExitOk;
}

}  // namespace

void add_pack(CLI::App& app, Run& run) {
  CLI::App& command =
      add_command(app, "pack", "a scene in the machine's format, for its driver",
                  footer("pipegs pack garden.ply --cameras cameras.json --view 0 --out packed", "done", "",
                         "image.bin is put into the machine's memory as it is; scene.h is compiled with "
                         "cpp_model/driver/example.c\nor a program like it."));
  static PackArguments arguments;
  arguments.view.add(command);
  add_text(command, "--out", arguments.out, "folder for image.bin and scene.h").shows_default();
  when_chosen(command, run, [] { return pack(arguments); });
}

}  // namespace pipegs
