// SPDX-License-Identifier: Apache-2.0
// join.cpp: see join.hpp.
#include "sim/command/campaign/join.hpp"

#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "scenes/input_error.hpp"
#include "sim/command/campaign/merge.hpp"
#include "sim/command/outputs.hpp"

namespace pipegs {
namespace {

// Copies the file of a point, as write_exr wrote it, to its place in the picture.
void read_part(const std::filesystem::path& path, int x0, int y0, int width, int height, Image& picture) {
  const auto pixels = static_cast<size_t>(width) * static_cast<size_t>(height);
  std::map<std::string, std::vector<float>> planes;
  std::vector<uint32_t> blended(pixels);
  try {
    Imf::InputFile file(path.c_str());
    const Imath::Box2i window = file.header().dataWindow();
    if (window != Imath::Box2i({0, 0}, {width - 1, height - 1}))
      throw InputError(path.string(), "", fmt::format("found another size, expected {}x{} pixels", width, height));
    Imf::FrameBuffer frame;
    for (const char* name : {"R", "G", "B", "T", "depth"}) {
      std::vector<float>& plane = planes[name];
      plane.resize(pixels);
      frame.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(plane.data()), sizeof(float),
                                    sizeof(float) * static_cast<size_t>(width)));
    }
    frame.insert("blended", Imf::Slice(Imf::UINT, reinterpret_cast<char*>(blended.data()), sizeof(uint32_t),
                                       sizeof(uint32_t) * static_cast<size_t>(width)));
    file.setFrameBuffer(frame);
    file.readPixels(0, height - 1);
  } catch (const InputError&) { throw; } catch (const std::exception& error) {
    throw InputError(path.string(), "", fmt::format("cannot read: {}", error.what()));
  }
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const size_t from = static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x),
                   to = picture.at(x0 + x, y0 + y);
      picture.rgb[to] = {planes["R"][from], planes["G"][from], planes["B"][from]};
      picture.transmittance[to] = planes["T"][from];
      picture.depth[to] = planes["depth"][from];
      picture.blended[to] = blended[from];
    }
  }
}

}  // namespace

void join_windows(const std::filesystem::path& folder, const std::vector<PointResult>& points) {
  std::map<std::string, std::vector<const PointResult*>> views;
  for (const PointResult& one : points) {
    const ViewArguments& view = one.point.arguments.view;
    if (view.window.empty()) continue;
    views[fmt::format("{}-{}-{}-{}", one.point.scene, view.view, one.point.configuration, view.design_point)].push_back(
        &one);
  }
  for (const auto& [name, parts] : views) {
    if (!std::all_of(parts.begin(), parts.end(), [](const PointResult* part) { return part->kept.has_value(); }))
      continue;
    Image picture(parts.front()->width, parts.front()->height);
    for (const PointResult* part : parts) {
      const PointArguments& point = part->point.arguments;
      const int x = point.view.window[0] * part->window, y = point.view.window[1] * part->window;
      read_part(std::filesystem::path(part->file).replace_extension(".exr"), x, y,
                std::min(point.windows * part->window, picture.width - x), std::min(part->window, picture.height - y),
                picture);
    }
    write_images((folder / name).string(), picture);
  }
}

}  // namespace pipegs
