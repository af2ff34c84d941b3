// SPDX-License-Identifier: Apache-2.0
// golden: the whole machine as pure functions: a packed scene and a camera in, every stream and every pixel out.
//
// Paper   Fig. 7.       RTL  rtl/pipegs_top.sv
// Idea    Window by window, layer by layer: the models of the units in the order of the streams. What depends on timing
//         in the hardware (which unit takes a chunk, which regions are skipped because they are done already) is left
//         out: the golden model computes everything, and skipping can only leave out work that changes no pixel.
// Order   0: layer by layer. 1: the frame is preprocessed into lists of the windows. 1 and 2: a window is one layer,
//         sorted by {depth, index}, or with order 2 part by part (dopu_walks), which changes no pixel.
// Threads Windows are independent; the result does not depend on their number.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "cpp_model/float/image.hpp"
#include "cpp_model/pu/project/pu_project.hpp"
#include "cpp_model/records.hpp"
#include "cpp_model/ru/ru_aovs.hpp"
#include "cpp_model/ru/ru_raster.hpp"
#include "cpp_model/dopu/walk.hpp"
#include "cpp_model/pack/pack.hpp"

namespace pipegs {

// Counts of the work that a frame asks for, independent of timing.
struct Work {
  uint64_t fetched = 0;  // (Gaussian, walk) pairs streamed into the PUs
  uint64_t visible = 0;  // of these, left by the cull
  uint64_t records = 0;  // of these, with at least one region: (Gaussian, part of a window) pairs that are sorted
  uint64_t regions = 0;  // (Gaussian, region) pairs whose alphas are computed
  uint64_t open_regions =
      0;                 // of these, with a pixel that nearer Gaussians have not stopped: pairs that must be blended
  uint64_t quads = 0;    // with quads: (Gaussian, quad) pairs that are blended
  uint64_t alphas = 0;   // 64 per region
  uint64_t blended = 0;  // (Gaussian, pixel) pairs that changed a pixel
  uint64_t keys = 0;     // keys sorted
  uint64_t chunks = 0;   // (chunk, walk) pairs fetched
  uint64_t layers = 0;   // (layer, window) pairs with at least one chunk
  uint64_t windows = 0;
  Work& operator+=(const Work& other);
};

// How often a narrowing clipped its value.
struct Saturations {
  uint64_t mean = 0;         // projected means beyond the range of s18: such a Gaussian is far outside the window
  uint64_t color = 0;        // colours above the range of u2
  uint64_t accumulated = 0;  // accumulated colours at the top
  uint64_t dead = 0;         // coefficients outside their range: proven not to reach the window
  Saturations& operator+=(const Saturations& other);
};

// How often something happened that a part of the machine is there for: none, and the machine does without
// (config.def).
struct Called {
  uint64_t near = 0;     // (Gaussian, window) pairs before the near plane
  uint64_t guard = 0;    // visible pairs whose x/z or y/z was clamped
  uint64_t stopped = 0;  // pixels that stopped early
  uint64_t ties = 0;     // neighbours in the order of a layer of a window with equal depth keys
  uint64_t layers = 0;   // most layers of one window with at least one record
  uint64_t bucket = 0;   // most keys of one bucket of depth in a layer of a window
  Called& operator+=(const Called& other);
};

// A Gaussian in a part of a window, as it leaves the PU. Its lines of alphas follow from the job.
struct GoldenSplat {
  Splat splat;  // address and ext are zero: they depend on timing
  RowJob job;
};

struct GoldenLayer {
  int ordinal = 0;                  // of the frame's layers, near to far
  std::vector<GoldenSplat> splats;  // sorted
};

struct GoldenWindow {
  uint64_t x = 0, y = 0;
  std::vector<uint64_t> walks;       // order 2, one after the other: of the whole, or of parts
  std::vector<GoldenLayer> layers;   // those with at least one chunk (order 1: one, if a list has an entry); maybe none
  std::vector<RegionState> regions;  // T, RGB, done of the finished window
  std::vector<RegionAovs> aovs;      // of each region; none where the machine has none
  std::vector<double> depth;         // sum of weight * view depth in scene units, by region and pixel
  std::vector<uint32_t> blended;     // Gaussians blended, by region and pixel
  Work work;
  Saturations saturations;
  Called called;
  bool in_parts() const { return !walks.empty() && walks.front() != kWholeWalk; }
};

// Order 1: what the preprocessing of the whole frame leaves, each Gaussian once, and who stands in the list of a
// window.
struct GoldenLists {
  struct Entry {
    Conic conic;  // mean relative to the frame's first window
    Colored colored;
  };
  std::vector<Entry> gaussians;
  std::vector<std::vector<uint32_t>> windows;  // by number (pu_expand_number): those whose box touches the window
  Work work;                                   // fetched, visible, chunks of the frame
  Saturations saturations;                     // mean, color
  Called called;                               // near, guard
};

struct GoldenInput {
  const PackedScene* packed = nullptr;
  Frame frame;
  Picture picture = {};  // how the pixels lie in memory; changes none of them
  // Made by the first golden_lists(); a copy of the input shares them, another frame needs a new input.
  mutable std::shared_ptr<const GoldenLists> lists = {};
};

// The lists of the frame, computed once on all threads (or `threads`). Only for order 1.
const GoldenLists& golden_lists(const GoldenInput& input, unsigned threads = 0);

// One Gaussian as a window sees it: what each bit-accurate model said, for `explain` and for finding a wrong bit.
GoldenWindow golden_window(const GoldenInput& input, uint64_t window_x, uint64_t window_y);

// What pu_fetch makes of a Gaussian of a chunk.
Fetched golden_fetched(const Chunk& chunk, const GaussianRecord& gaussian, uint64_t slot);

// From view space to the conic, and the payload that goes beside all that follows.
struct GoldenConic {
  Conic conic;
  Payload payload;
};
GoldenConic golden_conic(const Config& config, const Frame& frame, const Visible& visible,
                         ProjectCounts* counts = nullptr);

// The alpha codes of the region at a set bit of a job's mask.
void golden_codes(const Config& config, const RowJob& job, int bit, uint16_t codes[kRegionPixels]);

struct GoldenPicture {
  Image image;
  std::vector<uint64_t> pixels;  // as in external memory by windows (ru_resolve), row by row of the image
  AovPixels aovs;                // those that the frame wants
  std::vector<uint8_t> stopped;  // 1: a Gaussian that would have brought T below the stop ended the pixel
};

// The picture is that of the eye that is wanted, of both the first one.
struct GoldenFrame : GoldenPicture {
  std::optional<GoldenPicture> second;  // of the second eye, where both are wanted
  Work work;
  Saturations saturations;
  Called called;
  std::vector<uint32_t> rank;  // by scene index: position in the hardware's order (layer, depth key, index)
};

// What lies in memory of a picture, as in its GoldenPicture.
struct Written {
  std::vector<uint64_t> pixels;  // by windows as ru_resolve, in raster order as ru_rgba8 gives them
  AovPixels aovs;
};

struct GoldenOptions {
  unsigned threads = 0;
  std::function<void(double)> progress;  // share done; may throw to stop
};

GoldenFrame golden_frame(const GoldenInput& input, const GoldenOptions& options);

}  // namespace pipegs
