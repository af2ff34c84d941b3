// SPDX-License-Identifier: Apache-2.0
// simulate.cpp: see simulate.hpp.
#include "sim/compare/simulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cpp_model/float/metrics.hpp"
#include "cpp_model/float/truth.hpp"
#include "cpp_model/frame_setup.hpp"
#include "cpp_model/ru/ru_resolve.hpp"
#include "sim/host_use.hpp"
#include "sim/progress.hpp"

namespace pipegs {
namespace {

struct Rectangle {
  int x0, y0, x1, y1;
};

// The pixels that were asked for. Throws ConfigError when the window lies outside the image.
Rectangle asked(int width, int height, const SimulateOptions& options) {
  if (!options.window) return {0, 0, width, height};
  const int side = options.config.window;
  const auto [column, row] = *options.window;
  const int last_column = (width - 1) / side, last_row = (height - 1) / side;
  if (column < 0 || row < 0 || column > last_column || row > last_row)
    throw ConfigError(fmt::format("--window {},{}: expected 0,0 to {},{}", column, row, last_column, last_row));
  const int x = column * side, y = row * side;
  return {x, y, std::min(x + options.windows * side, width), std::min(y + side, height)};
}

// Ports of the lists of windows, which stand behind the others that write.
int list_ports(const Config& config) { return config.memory_ports() - 5 * config.units - 1; }

void fill(ExternalMemory& memory, const PackedScene& packed) {
  const MemoryImage image = memory_image(packed);
  for (size_t i = 0; i < image.lines.size(); ++i) memory.line(i) = image.lines[i];
}

// Shows the machine to two watchers.
class TapFan final : public RtlTaps {
 public:
  TapFan(RtlTaps& first, RtlTaps* second) : first_(first), second_(second) {}

  void on_splat(int unit, const uint32_t* splat) override {
    first_.on_splat(unit, splat);
    if (second_ != nullptr) second_->on_splat(unit, splat);
  }
  void on_sorted(const uint32_t* sorted) override {
    first_.on_sorted(sorted);
    if (second_ != nullptr) second_->on_sorted(sorted);
  }
  void on_alphas(int lane, uint64_t window_x, uint64_t window_y, uint32_t index, int region, int quarter,
                 const uint32_t* line) override {
    first_.on_alphas(lane, window_x, window_y, index, region, quarter, line);
    if (second_ != nullptr) second_->on_alphas(lane, window_x, window_y, index, region, quarter, line);
  }
  void on_pixels(int lane, int region, int quarter, const uint32_t* word) override {
    first_.on_pixels(lane, region, quarter, word);
    if (second_ != nullptr) second_->on_pixels(lane, region, quarter, word);
  }
  // Only the second one looks at cycles.
  bool wants_cycles() const override { return second_ != nullptr && second_->wants_cycles(); }
  void on_cycle(uint64_t cycle, const uint8_t* states) override { second_->on_cycle(cycle, states); }
  void on_chunk(int unit, int kind) override { second_->on_chunk(unit, kind); }
  void on_layer_done(int unit, bool window_done) override { second_->on_layer_done(unit, window_done); }
  void on_request(int tag, bool write, uint64_t line) override { second_->on_request(tag, write, line); }

 private:
  RtlTaps& first_;
  RtlTaps* second_;
};

}  // namespace

std::vector<MemoryTraffic> memory_traffic(const Config& config, const ExternalMemory& memory) {
  std::vector<MemoryTraffic> result;
  for (const std::string& name : memory_streams(config)) result.push_back({.stream = name});
  for (int port = 0; port < config.memory_ports(); ++port) {
    MemoryTraffic& traffic = result[memory_stream(config, port)];
    traffic.bytes_read += 64 * memory.traffic()[port].lines_read;
    traffic.bytes_written += 64 * memory.traffic()[port].lines_written;
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

Image crop_window(const Image& image, const SimulateOptions& options) {
  const Rectangle r = asked(image.width, image.height, options);
  Image part(r.x1 - r.x0, r.y1 - r.y0);
  for (int y = r.y0; y < r.y1; ++y) {
    for (int x = r.x0; x < r.x1; ++x) {
      const size_t to = part.at(x - r.x0, y - r.y0), from = image.at(x, y);
      part.rgb[to] = image.rgb[from];
      part.transmittance[to] = image.transmittance[from];
      part.depth[to] = image.depth[from];
      part.blended[to] = image.blended[from];
    }
  }
  return part;
}

void simulate_frame(const Camera& camera, const SimulateOptions& options, Simulation& result) {
  result.input = {.packed = &result.packed,
                  .frame = frame_setup(options.config, result.packed, camera, {}, options.near_plane)};
  if (!options.window) return;
  asked(camera.width, camera.height, options);  // refuses a window outside the image
  const auto [x, y] = *options.window;
  auto& windows = result.input.frame.raster.windows;
  windows.first_x = static_cast<uint64_t>(x);
  windows.last_x = std::min(windows.last_x, static_cast<uint64_t>(x + options.windows - 1));
  windows.first_y = windows.last_y = static_cast<uint64_t>(y);
}

void simulate_pack(const Scene& scene, const Camera& camera, const SimulateOptions& options, Simulation& result) {
  // World coordinates must hold the camera and, in a tiny or empty scene, the near plane.
  const double bound = std::max(
      {std::abs(camera.position.x), std::abs(camera.position.y), std::abs(camera.position.z), 2 * options.near_plane});
  const double before = process_seconds();
  result.packed = pack_scene(options.config, scene, bound);
  result.cpu_pack = process_seconds() - before;
  simulate_frame(camera, options, result);
}

void simulate_golden(const Scene& scene, const Camera& camera, const SimulateOptions& options, Simulation& result) {
  simulate_pack(scene, camera, options, result);
  Progress progress("golden");
  const Stopwatch watch;
  const double before = process_seconds();
  result.golden = golden_frame(result.input, {.threads = 0, .progress = [&](double share) {
                                                if (interrupted()) throw std::runtime_error("interrupted");
                                                progress.update(share);
                                              }});
  result.wall_golden = watch.seconds();
  result.cpu_golden = process_seconds() - before;
}

void simulate_truth(const Scene& scene, const Camera& camera, const SimulateOptions& options, Simulation& result,
                    const Simulation* known) {
  const Stopwatch watch;
  const double before = process_seconds();
  const Rectangle r = asked(camera.width, camera.height, options);
  const auto render = [&](const char* name, Semantics semantics, const std::vector<uint32_t>* rank) {
    Progress progress(name);
    TruthOptions truth;
    truth.semantics = semantics;
    truth.rank = rank;
    truth.near_plane = options.near_plane;
    truth.sh_degree = std::min(scene.sh_degree, options.config.sh_degree);
    truth.clip_window = options.window.has_value();
    truth.x0 = r.x0, truth.y0 = r.y0, truth.x1 = r.x1, truth.y1 = r.y1;
    truth.progress = [&](double share) {
      if (interrupted()) throw std::runtime_error("interrupted");
      progress.update(share);
    };
    return render_truth(scene, camera, truth);
  };
  const bool same_order = known != nullptr && known->golden.rank == result.golden.rank;
  result.truth_order = same_order ? known->truth_order : render("truth", Semantics::kExact, &result.golden.rank);
  result.truth_exact = known != nullptr ? known->truth_exact : render("truth", Semantics::kExact, nullptr);
  result.truth_inria = known != nullptr ? known->truth_inria : render("truth", Semantics::kInria, nullptr);
  result.wall_truth = watch.seconds();
  result.cpu_truth = process_seconds() - before;

  const Image golden = crop_window(result.golden.image, options);  // the truths are clipped already
  result.psnr_numeric = psnr(golden, result.truth_order);
  result.psnr_order = psnr(result.truth_order, result.truth_exact);
  result.psnr_total = psnr(golden, result.truth_inria);
  result.max_abs_error = max_abs_error(golden, result.truth_order);
}

void simulate_rtl(const SimulateOptions& options, Simulation& result) {
  const Config& config = options.config;
  if (!config.taps && (options.taps != nullptr || options.watch))
    throw ConfigError("configuration: what shows the streams needs taps = 1");
  const std::unique_ptr<RtlModel> model = load_rtl(config, built_variant(options.variant, options.rtl));
  const Frame& frame = result.input.frame;
  ExternalMemory memory(options.memory);
  fill(memory, result.packed);

  StreamCheck check(result.input);
  if (options.watch) check.watch((*options.watch)[0], (*options.watch)[1]);
  TapFan taps(check, options.taps);
  std::vector<uint32_t> words(record_words<Frame>(config) + 1);
  pack(config, frame, words.data());
  const double windows = static_cast<double>((frame.raster.windows.last_x - frame.raster.windows.first_x + 1) *
                                             (frame.raster.windows.last_y - frame.raster.windows.first_y + 1));
  Progress progress("rtl");
  const Stopwatch watch;
  result.rtl = model->run(words.data(), memory, options.rtl, &taps, [&](uint64_t cycle, uint64_t windows_done) {
    progress.update(static_cast<double>(windows_done) / windows,
                    fmt::format("{:.0f} kHz", static_cast<double>(cycle) / watch.seconds() / 1000));
    return !interrupted();
  });
  if (config.taps) check.finish();
  result.wall_rtl = watch.seconds();
  result.traffic = memory_traffic(config, memory);
  result.dram.reset();
  if (const Dram* dram = memory.dram())
    result.dram = {dram->statistics(), dram->achieved_gbps(), dram->timing().peak_gbps()};
  result.seen = check.seen();
  result.beats = check.beats();
  result.mismatches = check.mismatches();
  result.first_mismatch = check.first();

  // The frame in external memory against the golden pixels.
  const uint64_t side = config.window;
  for (uint64_t y = frame.raster.windows.first_y * side;
       y < std::min(frame.raster.height, (frame.raster.windows.last_y + 1) * side); ++y) {
    for (uint64_t x = frame.raster.windows.first_x * side;
         x < std::min(frame.raster.width, (frame.raster.windows.last_x + 1) * side); ++x) {
      const int region = region_at(config, static_cast<int>(x % side / 8), static_cast<int>(y % side / 8));
      const MemoryLine& line =
          memory.line(ru_pixel_line(config, frame, x / side, y / side, region, static_cast<int>(y % 8)));
      const uint64_t found =
          get_bits(line.data(), ru_pixel_bit(config, static_cast<int>(y % 8), static_cast<int>(x % 8)), config.pixel_w);
      const uint64_t expected = result.golden.pixels[y * frame.raster.width + x];
      if (found == expected) continue;
      ++result.mismatches;
      if (!result.first_mismatch) {
        result.first_mismatch =
            Mismatch{fmt::format("frame: pixel {},{}: expected {:016x}, found {:016x}", x, y, expected, found),
                     x / side, y / side};
      }
    }
  }
}

}  // namespace pipegs
