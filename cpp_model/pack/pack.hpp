// SPDX-License-Identifier: Apache-2.0
// pack: a scene in the machine's own format: fixed point, grouped by grid cell, cut into chunks with bounding boxes.
//
// Paper   Sec. 3.2 (orthogonal grid), Sec. 4.1.
// RTL     read by rtl/dopu (nodes), rtl/pu/front/pu_fetch (geometry), pu_color (SH)
// Idea    World unit = 2^scene_exponent scene units, so that every coordinate fits WorldW - 2 bits. A uniform grid lies
//         over the 2..98 percentile box of the means; its outer cells extend to infinity. A cell's Gaussians are
//         ordered by pack_order and cut into chunks, up to Group of them in a group; a chunk's means are offsets from
//         its centre in units of 2^offset_exp. A box encloses the ROUNDED means and rounds up; scale_max is the largest
//         *effective* scale, rounded up:
//           effective scale = largest scale * sqrt(ln(AlphaCut opacity) / ln AlphaCut)
//         which is how far a Gaussian of that opacity reaches in the measure of an opaque one.
// Rule    A Gaussian that cannot be drawn never stops the packing: it is left out and counted by reason.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cpp_model/config.hpp"
#include "cpp_model/memory_line.hpp"
#include "cpp_model/pack/narrow_table.hpp"
#include "cpp_model/records.hpp"
#include "scenes/scene.hpp"

namespace pipegs {

inline constexpr uint32_t kPadding = ~uint32_t{0};  // slot_to_index of a slot that holds no Gaussian

// First line of each table in external memory. The overflow areas follow the frame, see frame_setup.
struct MemoryLayout {
  uint64_t cells = 0, groups = 0, chunks = 0, gaussians = 0, colors = 0, pixels = 0;
};

// cell coordinate of a world coordinate v = clamp(floor((v - low) * scale / 2^WorldW), 0, grid - 1)
struct GridBox {
  std::array<int64_t, 3> low{};
  std::array<uint64_t, 3> scale{};
};

struct PackCounts {
  uint64_t packed = 0, proxies = 0;
  uint64_t non_finite = 0, zero_quaternion = 0, transparent = 0, out_of_range = 0;        // left out
  uint64_t saturated_scale = 0, saturated_base = 0, saturated_sh = 0, flushed_scale = 0;  // packed, a field clipped
};

struct PackedScene {
  Config config;
  int scene_exponent = 0;                   // scene units of one world unit = 2^scene_exponent
  bool antialiased = false;                 // as the scene says
  int sh_degree = 0;                        // of the packed colours: the scene's, at most the configuration's
  std::vector<Node> cells, groups, chunks;  // cell -> groups -> chunks -> Gaussians
  NarrowTable<GaussianRecord> gaussians;    // by slot
  NarrowTable<GaussianCode> codes;          // as they lie in memory, if coded: gaussians holds what they stand for
  std::vector<uint32_t> slot_to_index;  // index in the scene (of a proxy: of what weighs most), kPadding: empty slot
  size_t scene_gaussians = 0;           // of the scene, those left out included
  std::vector<MemoryLine> colors;       // SH coefficients, color_slots_per_line of them in a line
  GridBox grid;
  MemoryLayout layout;
  PackCounts counts;

  // Those that hold Gaussians of the scene, without proxies.
  std::vector<Node> own_chunks() const;
  // In the scene, of the index by which the machine orders Gaussians of one depth.
  uint32_t scene_index(uint64_t index) const {
    const bool slot = config.coded() && index < slot_to_index.size();
    return slot ? slot_to_index[index] : static_cast<uint32_t>(index);
  }
};

struct MemoryImage {
  MemoryLayout layout;
  std::vector<MemoryLine> lines;  // from line 0 up to layout.pixels
};

// `coordinate_bound` is the largest magnitude of a camera's coordinate in scene units; the means' own are added here.
// Throws std::invalid_argument with one line when the scene does not fit the machine (too many Gaussians, ...).
PackedScene pack_scene(const Config& config, const Scene& scene, double coordinate_bound);

// The tables as they lie in external memory.
MemoryImage memory_image(const PackedScene& packed);

// Cell coordinate of a world coordinate along one axis.
int cell_coordinate(const Config& config, const GridBox& grid, int axis, int64_t world);

// A decoded scale field, in world units.
double scale_value(const Config& config, uint64_t scale);

}  // namespace pipegs
