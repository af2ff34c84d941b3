// SPDX-License-Identifier: Apache-2.0
// simulate.cpp: see simulate.hpp.
#include "sim/compare/simulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cpp_model/aov_image.hpp"
#include "cpp_model/dopu/nearest/dopu_lod.hpp"
#include "cpp_model/float/metrics.hpp"
#include "cpp_model/float/truth.hpp"
#include "cpp_model/frame_setup.hpp"
#include "cpp_model/ru/ru_resolve.hpp"
#include "sim/compare/frame_check.hpp"
#include "sim/host_use.hpp"
#include "sim/progress.hpp"

namespace pipegs {
namespace {

// Ports of the lists of windows, which stand behind the others that write.
int list_ports(const Config& config) { return config.memory_ports() - 5 * config.units - 1; }

// Red, green or blue of a pixel as it lies in memory, 0 to 1 (by windows and with T, to 4).
double color_of(const SimulateOptions& options, uint64_t pixel, int channel) {
  if (options.raster) return static_cast<double>(pixel >> 8 * channel & 0xff) / 255;
  if (options.config.pixel_w == 32) return static_cast<double>(pixel >> 10 * channel & kMostCode) / kMostCode;
  return std::ldexp(static_cast<double>(pixel >> 16 * channel & 0xffff), -14);
}

}  // namespace

PixelRect asked_pixels(int width, int height, const SimulateOptions& options) {
  if (options.crop) {
    const PixelRect crop = *options.crop;
    if (!crop.empty() && crop.x0 >= 0 && crop.y0 >= 0 && crop.x1 <= width && crop.y1 <= height) return crop;
    throw ConfigError(fmt::format("--crop {},{},{},{}: expected a rectangle of {}x{} pixels", crop.x0, crop.y0,
                                  crop.x1 - crop.x0, crop.y1 - crop.y0, width, height));
  }
  if (!options.window) return {0, 0, width, height};
  const int side = options.config.window;
  const auto [column, row] = *options.window;
  const int last_column = (width - 1) / side, last_row = (height - 1) / side;
  if (column < 0 || row < 0 || column > last_column || row > last_row)
    throw ConfigError(fmt::format("--window {},{}: expected 0,0 to {},{}", column, row, last_column, last_row));
  const int x = column * side, y = row * side;
  return {x, y, std::min(x + side, width), std::min(y + side, height)};
}

std::vector<MemoryTraffic> memory_traffic(const Config& config, const ExternalMemory& memory) {
  std::vector<MemoryTraffic> result;
  for (const std::string& name : memory_streams(config)) result.push_back({.stream = name});
  for (int port = 0; port < config.memory_ports(); ++port) {
    MemoryTraffic& traffic = result[memory_stream(config, port)];
    traffic.bursts += memory.traffic()[port].bursts;
    traffic.bytes_read += 32 * memory.traffic()[port].halves_read;
    traffic.bytes_written += 32 * memory.traffic()[port].halves_written;
  }
  return result;
}

std::vector<std::string> memory_streams(const Config& config) {
  std::vector<std::string> names = {"alpha_overflow_write", "sort_overflow", "raster", "geometry", "color", "nodes"};
  if (list_ports(config) > 0) names.insert(names.begin() + 3, "lists");
  return names;
}

size_t memory_stream(const Config& config, int port) {
  const int writers = 3 * config.units, lists = list_ports(config);
  if (port < writers) return static_cast<size_t>(port / config.units);
  if (port < writers + lists) return 3;
  return static_cast<size_t>((port - lists) / config.units + (lists > 0));
}

Rgb8 cropped(const Rgb8& picture, const PixelRect& part) {
  Rgb8 out{part.x1 - part.x0, part.y1 - part.y0, {}};
  for (int y = part.y0; y < part.y1; ++y) {
    const auto row = picture.data.begin() + 3 * (static_cast<ptrdiff_t>(y) * picture.width + part.x0);
    out.data.insert(out.data.end(), row, row + 3 * static_cast<ptrdiff_t>(out.width));
  }
  return out;
}

Image cropped(const Image& image, const PixelRect& r) {
  Image part(r.x1 - r.x0, r.y1 - r.y0);
  part.median.resize(image.median.empty() ? 0 : part.depth.size());
  part.index.resize(image.index.empty() ? 0 : part.depth.size());
  for (int y = r.y0; y < r.y1; ++y) {
    for (int x = r.x0; x < r.x1; ++x) {
      const size_t to = part.at(x - r.x0, y - r.y0), from = image.at(x, y);
      part.rgb[to] = image.rgb[from];
      part.transmittance[to] = image.transmittance[from];
      part.depth[to] = image.depth[from];
      part.blended[to] = image.blended[from];
      if (!image.median.empty()) part.median[to] = image.median[from];
      if (!image.index.empty()) part.index[to] = image.index[from];
    }
  }
  return part;
}

Image crop_window(const Image& image, const SimulateOptions& options) {
  return cropped(image, asked_pixels(image.width, image.height, options));
}

namespace {

// Of one eye, as the RTL has left it where it ran.
Image eye_picture(const Simulation& simulation, const SimulateOptions& options, const GoldenPicture& golden,
                  const Written& written) {
  if (written.pixels.empty()) return crop_window(golden.image, options);
  Image whole = golden.image;
  show_aovs(*simulation.input.packed, simulation.input.frame, written.aovs, whole);
  Image image = crop_window(whole, options);
  const PixelRect r = asked_pixels(whole.width, whole.height, options);
  for (int y = r.y0; y < r.y1; ++y) {
    for (int x = r.x0; x < r.x1; ++x) {
      const uint64_t pixel = written.pixels[whole.at(x, y)];
      const size_t at = image.at(x - r.x0, y - r.y0);
      for (int j = 0; j < 3; ++j) image.rgb[at][j] = color_of(options, pixel, j);
      if (!options.raster && options.config.pixel_w == 64)
        image.transmittance[at] = std::ldexp(static_cast<double>(pixel >> 48), -15);
    }
  }
  return image;
}

template <class T>
std::vector<T> rows_beside(const std::vector<T>& left, const std::vector<T>& right, int width) {
  std::vector<T> both;
  for (size_t at = 0; at < left.size(); at += static_cast<size_t>(width)) {
    const auto end = static_cast<ptrdiff_t>(at) + width, begin = static_cast<ptrdiff_t>(at);
    both.insert(both.end(), left.begin() + begin, left.begin() + end);
    both.insert(both.end(), right.begin() + begin, right.begin() + end);
  }
  return both;
}

// Two eyes' pictures as one.
Image beside(Image left, const Image& right) {
  const int width = left.width;
  left.rgb = rows_beside(left.rgb, right.rgb, width);
  left.transmittance = rows_beside(left.transmittance, right.transmittance, width);
  left.depth = rows_beside(left.depth, right.depth, width);
  left.blended = rows_beside(left.blended, right.blended, width);
  left.median = rows_beside(left.median, right.median, width);
  left.index = rows_beside(left.index, right.index, width);
  left.width += right.width;
  return left;
}

}  // namespace

Camera eye_camera(const Camera& camera, const SimulateOptions& options, int eye) {
  Camera moved = camera;
  const glm::dvec3 half(options.half_eye[0], options.half_eye[1], 0);
  moved.position += (eye == 0 ? -1.0 : 1.0) * (glm::transpose(camera.world_to_camera) * half);
  return moved;
}

Image picture_of(const Simulation& simulation, const SimulateOptions& options) {
  Image image = eye_picture(simulation, options, simulation.golden, simulation.written);
  if (!simulation.golden.second) return image;
  return beside(std::move(image),
                eye_picture(simulation, options, *simulation.golden.second, simulation.second_written));
}

Image golden_picture(const Simulation& simulation, const SimulateOptions& options) {
  Image image = crop_window(simulation.golden.image, options);
  if (!simulation.golden.second) return image;
  return beside(std::move(image), crop_window(simulation.golden.second->image, options));
}

PackedScene pack_views(const Scene& scene, const std::vector<Camera>& cameras, const SimulateOptions& options) {
  const Progress stage("packing the scene");
  // World coordinates must hold the cameras and, in a tiny or empty scene, the near plane; half the way between two
  // eyes has a bit less.
  double bound = 2 * options.near_plane;
  for (const Camera& camera : cameras) {
    for (int axis = 0; axis < 3; ++axis) bound = std::max(bound, std::abs(camera.position[axis]));
  }
  for (const double half : options.half_eye) bound = std::max(bound, 2.5 * std::abs(half));
  PackedScene packed = pack_scene(options.config, scene, bound);
  if (options.found) options.found(check_packed(packed));
  return packed;
}

void simulate_frame(const PackedScene& packed, const Camera& camera, const SimulateOptions& options,
                    Simulation& result) {
  result.input = {.packed = &packed, .frame = frame_setup(options.config, packed, camera, {}, options.near_plane)};
  if (options.config.has_walks()) result.input.frame.walk_most = options.walk_most;
  if (options.rest != 0 && options.config.early_stop)
    result.input.frame.raster.rest = rest_of(options.config, options.rest);
  if (options.config.eyes > 1) {
    frame_eyes(options.config, packed, options.half_eye, result.input.frame);
    result.input.frame.raster.eyes = options.eyes;
  }
  if (options.config.has_aovs()) result.input.frame.raster.aovs.wanted = options.aovs;
  if (options.config.lod) result.input.frame.lod = dopu_lod_of(options.config, camera.fx, options.lod_pixels);
  if (options.raster)
    result.input.picture = raster_picture(result.input.frame.tables.pixels, result.input.frame.raster.width);
  const PixelRect r = asked_pixels(camera.width, camera.height, options);
  const auto number = [&](int pixel) { return static_cast<uint64_t>(pixel / options.config.window); };
  result.input.frame.raster.windows = {
      .first_x = number(r.x0), .first_y = number(r.y0), .last_x = number(r.x1 - 1), .last_y = number(r.y1 - 1)};
}

void simulate_pack(const Scene& scene, const Camera& camera, const SimulateOptions& options, Simulation& result) {
  const double before = process_seconds();
  result.packed = pack_views(scene, {camera}, options);
  result.cpu_pack = process_seconds() - before;
  simulate_frame(result.packed, camera, options, result);
}

void simulate_golden(const SimulateOptions& options, Simulation& result, const GoldenOptions& how) {
  const Stopwatch watch;
  const double before = process_seconds();
  result.golden = golden_frame(result.input, how);
  result.wall_golden = watch.seconds();
  result.cpu_golden = process_seconds() - before;
  if (options.found) options.found(check_frame(result, options));
}

void simulate_golden(const SimulateOptions& options, Simulation& result) {
  Progress progress("golden model");
  simulate_golden(options, result, {.threads = 0, .progress = [&](double share) {
                                      if (interrupted()) throw std::runtime_error("interrupted");
                                      progress.update(share);
                                    }});
}

void simulate_golden(const Scene& scene, const Camera& camera, const SimulateOptions& options, Simulation& result) {
  simulate_pack(scene, camera, options, result);
  simulate_golden(options, result);
}

Image simulate_float(const char* stage, const Scene& scene, const Camera& camera, const SimulateOptions& options,
                     Semantics semantics, const std::vector<uint32_t>* rank) {
  const PixelRect r = asked_pixels(camera.width, camera.height, options);
  Progress progress(stage);
  TruthOptions truth;
  truth.semantics = semantics;
  truth.rank = rank;
  truth.near_plane = options.near_plane;
  truth.sh_degree = std::min(scene.sh_degree, options.config.sh_degree);
  truth.aovs = options.aovs != 0;
  truth.clip_window = options.window || options.crop;
  truth.x0 = r.x0, truth.y0 = r.y0, truth.x1 = r.x1, truth.y1 = r.y1;
  truth.progress = [&](double share) {
    if (interrupted()) throw std::runtime_error("interrupted");
    progress.update(share);
  };
  if (options.config.eyes == 1) return render_truth(scene, camera, truth);
  const auto eye = [&](int number) { return render_truth(scene, eye_camera(camera, options, number), truth); };
  return options.eyes == 3 ? beside(eye(0), eye(1)) : eye(options.eyes == 1 ? 0 : 1);
}

Image shown(Image image) {
  for (glm::dvec3& channels : image.rgb) channels = glm::clamp(channels, 0.0, 1.0);
  return image;
}

void simulate_truth(const Scene& scene, const Camera& camera, const SimulateOptions& options, Simulation& result,
                    const Simulation* known) {
  const Stopwatch watch;
  const double before = process_seconds();
  const auto render = [&](const char* stage, Semantics semantics, const std::vector<uint32_t>* rank) {
    return simulate_float(stage, scene, camera, options, semantics, rank);
  };
  const bool same_order = known != nullptr && known->golden.rank == result.golden.rank;
  result.truth_exact = known != nullptr ? known->truth_exact : render("truth", Semantics::kExact, nullptr);
  // Proxies have no place among the scene's Gaussians: what they change is numeric.
  if (result.input.frame.lod != 0) result.truth_order = result.truth_exact;
  else if (same_order) result.truth_order = known->truth_order;
  else result.truth_order = render("truth", Semantics::kExact, &result.golden.rank);
  result.truth_inria = known != nullptr ? known->truth_inria : render("truth", Semantics::kInria, nullptr);
  result.wall_truth = watch.seconds();
  result.cpu_truth = process_seconds() - before;

  const Image golden = golden_picture(result, options);  // the truths are clipped already
  result.psnr_numeric = psnr(golden, result.truth_order);
  result.psnr_order = psnr(result.truth_order, result.truth_exact);
  result.psnr_total = psnr(golden, result.truth_inria);
  result.max_abs_error = max_abs_error(shown(golden), shown(result.truth_order));
}

}  // namespace pipegs
