// SPDX-License-Identifier: Apache-2.0
// simulate.hpp: frames through golden model, truth and RTL, compared, with everything that the report needs.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>

#include "cpp_model/driver/pipegs_frame.h"
#include "cpp_model/float/projection.hpp"
#include "cpp_model/golden.hpp"
#include "scenes/camera.hpp"
#include "scenes/check/finding.hpp"
#include "scenes/scene.hpp"
#include "sim/memory/dram/dram.hpp"
#include "sim/rtl/rtl_model.hpp"
#include "sim/compare/stream_check.hpp"

namespace pipegs {

// The external memory where none is named.
inline constexpr const char* kDefaultDram = "lpddr5-6400x4";

struct SimulateOptions {
  Config config;
  ExternalMemoryOptions memory;
  RtlOptions rtl;
  RtlVariant variant;                        // may be simulated less than this: see built_variant in rtl_model.hpp
  std::optional<std::array<int, 2>> window;  // column and row of the only window to simulate
  std::optional<PixelRect> crop;             // instead of `window`: only the windows of these pixels, and of them these
  double near_plane = 0.2;                   // scene units
  uint64_t walk_most = PIPEGS_WALK_MOST;     // Frame::walk_most, of machines that have it
  double rest = 0;                           // transmittance, Frame::raster.rest; of machines that stop early
  double lod_pixels = 0;                     // Frame::lod by its size of proxies; of machines that have them
  uint64_t aovs = 0;                         // Frame::raster.aovs.wanted, of machines that have them
  std::array<double, 2> half_eye = {};       // of machines with two eyes: half the way between them, scene units, x, y
  uint64_t eyes = 3;                         // likewise whose pictures are made, Frame::raster.eyes
  bool raster = false;                       // pixels in raster order, RGBA8; else by windows
  std::optional<std::array<int, 2>> watch;   // pixel whose blending the RTL shall show
  RtlTaps* taps = nullptr;                   // sees what the RTL shows, beside the comparison
  std::function<void(const Findings&)> found =
      {};  // hears what is odd in what is packed and in frames; from any thread
};

struct MemoryTraffic {
  std::string stream;  // who: "dopu nodes", "pu gaussians", ...
  uint64_t bytes_read = 0, bytes_written = 0;
  uint64_t bursts = 0;  // reads, each of one to eight lines in a row
};

// What the DRAM says of itself after a frame.
struct MemoryFigures {
  Dram::Statistics statistics;
  double gbps = 0, peak_gbps = 0;        // bytes over the pins / time of the frame, and what the pins can carry
  std::vector<uint64_t> latencies = {};  // reads by their latency in cycles of the machine
};

struct Simulation {
  PackedScene packed;
  GoldenInput input;  // points at packed, or at that of another simulation
  GoldenFrame golden;
  Written written, second_written;  // as golden and golden.second; empty where the RTL did not run
  // Exact in the hardware's order, exact and INRIA in global order; only the window that was asked for.
  Image truth_order, truth_exact, truth_inria;
  RtlResult rtl;
  std::vector<MemoryTraffic> traffic;
  std::vector<StreamCheck::Seen> seen;
  uint64_t beats = 0, mismatches = 0;
  std::optional<Mismatch> first_mismatch;
  std::optional<MemoryFigures> dram;  // when external memory is one
  double psnr_numeric = 0, psnr_order = 0, psnr_total = 0, max_abs_error = 0;
  double wall_truth = 0, wall_golden = 0, wall_rtl = 0;
  double cpu_pack = 0, cpu_golden = 0, cpu_truth = 0;  // seconds of all threads

  Simulation() = default;
  Simulation(const Simulation&) = delete;  // input points into packed
};

// Packs the scene so that frames of all these cameras can be rendered. Says what is left out.
PackedScene pack_views(const Scene& scene, const std::vector<Camera>& cameras, const SimulateOptions& options);
// Sets up the frame of a scene that is packed already, the result's own or one that outlives the result.
void simulate_frame(const PackedScene& packed, const Camera& camera, const SimulateOptions& options,
                    Simulation& result);
// Runs the golden model on the frame that is set up, and says whether it is empty; without `how` with a line on the
// terminal.
void simulate_golden(const SimulateOptions& options, Simulation& result);
void simulate_golden(const SimulateOptions& options, Simulation& result, const GoldenOptions& how);
// Packs the scene and sets up the frame.
void simulate_pack(const Scene& scene, const Camera& camera, const SimulateOptions& options, Simulation& result);
// The same, and runs the golden model.
void simulate_golden(const Scene& scene, const Camera& camera, const SimulateOptions& options, Simulation& result);
// The float64 render of the part that was asked for, of two eyes side by side, in this order of Gaussians or by depth;
// `stage` names it on the terminal. Throws std::runtime_error when interrupted.
Image simulate_float(const char* stage, const Scene& scene, const Camera& camera, const SimulateOptions& options,
                     Semantics semantics, const std::vector<uint32_t>* rank = nullptr);
// What a screen shows of a picture: channels from 0 to 1, as psnr takes them. A 10-bit channel ends at 1, float64 does
// not: without this the largest error of a bright pixel is how bright it is.
Image shown(Image image);
// Renders the three truths and the figures that compare golden with them; needs simulate_golden. Truths that `known`, a
// simulation of the same view, holds already are copied: the same ranks give the same picture.
void simulate_truth(const Scene& scene, const Camera& camera, const SimulateOptions& options, Simulation& result,
                    const Simulation* known = nullptr);
// Runs the RTL and compares every stream and every pixel; needs simulate_golden.
void simulate_rtl(const SimulateOptions& options, Simulation& result);

// Over the pins of external memory.
struct MemoryBytes {
  uint64_t read = 0, written = 0;
};

// What one machine says of frames that it ran one after the other.
struct SequenceRun {
  RtlResult rtl;  // counters since the machine was last empty
  std::vector<MemoryTraffic> traffic;
  std::vector<MemoryBytes> frame_bytes;  // of each: from the end of the frame before, or the start, to its own
  std::optional<MemoryFigures> dram;
  double wall = 0;  // seconds
};

// Runs these frames in one machine without a reset between them, as options.rtl says, and compares each; their scenes
// lie behind one another in memory, frames of one PackedScene share it and the place of their pixels. Needs
// simulate_golden of each.
SequenceRun simulate_sequence(const SimulateOptions& options, const std::vector<Simulation*>& frames);

// The streams of external memory, in the order of the ports of rtl/buf/pipegs_memory_arbiter.sv, and that of one port
// (a request's tag).
std::vector<std::string> memory_streams(const Config& config);
size_t memory_stream(const Config& config, int port);
// The bytes that each stream moved.
std::vector<MemoryTraffic> memory_traffic(const Config& config, const ExternalMemory& memory);

// The pixels that were asked for, of a picture of this size: all, a window, or a crop. Throws ConfigError when they
// are not all inside.
PixelRect asked_pixels(int width, int height, const SimulateOptions& options);

// These pixels of a picture; all of them are inside.
Rgb8 cropped(const Rgb8& picture, const PixelRect& part);
Image cropped(const Image& image, const PixelRect& part);

// The part of an image that was asked for.
Image crop_window(const Image& image, const SimulateOptions& options);

// The camera of an eye of such a machine; that of the frame stands between them.
Camera eye_camera(const Camera& camera, const SimulateOptions& options, int eye);

// That part of the picture, of two eyes side by side: the golden model's, and colours, T and AOVs as the RTL has
// written them where it ran and memory holds them.
Image golden_picture(const Simulation& simulation, const SimulateOptions& options);
Image picture_of(const Simulation& simulation, const SimulateOptions& options);

}  // namespace pipegs
