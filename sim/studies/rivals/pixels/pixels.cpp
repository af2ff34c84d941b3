// SPDX-License-Identifier: Apache-2.0
// pixels.cpp: see pixels.hpp.
//
// Idea    What does not depend on the order is made once: of a view the projection, colours and exact picture; of an
//         edge the rays' way through the voxels; of a frame of the path its exact picture, for all speeds.
#include "sim/studies/rivals/pixels/pixels.hpp"

#include <algorithm>
#include <stdexcept>

#include "sim/studies/rivals/pixels/frames.hpp"
#include "sim/studies/rivals/pixels/path.hpp"
#include "sim/studies/rivals/pixels/streaming.hpp"

namespace pipegs {
namespace {

double extent_of(const Scene& scene) {
  double longest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (size_t i = 0; i < scene.gaussians.size(); ++i) {
      ActivatedGaussian gaussian;
      if (activate(scene, i, gaussian) == Cull::kNone) values.push_back(gaussian.mean[axis]);
    }
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const size_t last = values.size() - 1;
    longest = std::max(longest, values[last - last / 100] - values[last / 100]);
  }
  return longest;
}

class Study {
 public:
  Study(const Scene& scene, const Camera& camera, const std::vector<Camera>& cameras, const PixelOptions& options)
      : scene_(scene), camera_(camera), cameras_(cameras), options_(options) {
    result_.extent = extent_of(scene);
    for (const double edge : options.voxels) edges_.push_back({edge, 0});
    for (const int part : kExtentParts) {
      if (result_.extent > 0) edges_.push_back({result_.extent / part, part});
    }
    steps_ = edges_.size() * options.groups.size() + static_cast<size_t>(options.frames) * options.speeds.size();
  }

  PixelStudy run() {
    streams();
    paths();
    return std::move(result_);
  }

 private:
  struct Edge {
    double edge;
    int part;
  };
  struct Frame {
    std::vector<Difference> differences = {};
    OrderCounts blends = {};
    double newcomers = 0;
  };

  Image exact_picture(const PixelView& view) const {
    return blend(view, sequences_of(view, depth_order(view), kTableSide), options_.threads).image;
  }

  void step() {
    if (options_.progress) options_.progress(static_cast<double>(++done_) / static_cast<double>(steps_));
  }

  void streams() {
    const PixelView view = pixel_view(scene_, camera_, options_.near_plane, options_.threads);
    const Image exact = exact_picture(view);
    const std::vector<Circle> circles = coarse_circles(scene_, camera_, options_.near_plane, options_.threads);
    std::vector<Sequences> sequences;
    for (const int side : options_.groups) sequences.push_back(exact_sequences(view, side, options_.threads));
    for (const auto& [edge, part] : edges_) {
      const VoxelScene voxels = voxel_scene(scene_, view, edge, options_.near_plane, options_.threads);
      for (const Sequences& of_side : sequences) {
        const StreamPicture picture = stream(view, voxels, circles, of_side, options_.threads);
        const Image sorted = blend(view, by_depth(picture.sequences), options_.threads).image;
        result_.streams.push_back({edge, part, of_side.side, voxels.voxels.size(),
                                   difference(picture.blend.image, exact), difference(picture.blend.image, sorted),
                                   difference(sorted, exact), picture.blend.counts, picture.counts,
                                   picture.counts.bytes(options_.index_bytes)});
        step();
      }
    }
  }

  void paths() {
    const CameraPath path(scene_, camera_, cameras_, options_.near_plane);
    result_.arc = path.arc(), result_.legs = path.legs(), result_.degrees = path.length();
    const double share = options_.step / path.length();  // of the path
    result_.turn = path.rotation() * share, result_.move = path.distance() * share;
    result_.parallax = path.parallax() * share;
    std::vector<std::vector<Frame>> found(options_.speeds.size(), std::vector<Frame>(std::size(kMachines)));
    for (int frame = 0; frame < options_.frames; ++frame) {
      const double at = (frame + 0.5) / options_.frames * path.length();
      const PixelView now = pixel_view(scene_, path.at(at), options_.near_plane, options_.threads);
      const Image exact = exact_picture(now);
      for (size_t s = 0; s < options_.speeds.size(); ++s) {
        speed(path, at, options_.speeds[s] * options_.step, now, exact, found[s]);
        step();
      }
    }
    for (size_t s = 0; s < options_.speeds.size(); ++s) {
      for (size_t m = 0; m < std::size(kMachines); ++m) {
        const Frame& all = found[s][m];
        const auto late = static_cast<double>(all.blends.late), blends = static_cast<double>(all.blends.blends);
        result_.paths.push_back({kMachines[m], options_.speeds[s], together(all.differences), worst_db(all.differences),
                                 blends > 0 ? late / blends : 0, all.newcomers / options_.frames});
      }
    }
  }

  // One frame, in the order that each machine has at this speed.
  void speed(const CameraPath& path, double at, double step, const PixelView& now, const Image& exact,
             std::vector<Frame>& found) const {
    SortedTables mixed(scene_), even(scene_, Ages::kEven);
    PixelView last;
    for (int back = kWarmFrames; back > 0; --back) {
      last = pixel_view(scene_, path.at(at - back * step), options_.near_plane, options_.threads);
      const Sequences exact_last = exact_sequences(last, kTableSide, options_.threads);
      mixed.next(last, exact_last, options_.threads);
      even.next(last, exact_last, options_.threads);
    }
    const Sequences exact_now = exact_sequences(now, kTableSide, options_.threads);
    const Sequences sequences[] = {sequences_of(now, stale_order(scene_, now, last, Newcomers::kAll), kTableSide),
                                   sequences_of(now, stale_order(scene_, now, last, Newcomers::kSeen), kTableSide),
                                   mixed.next(now, exact_now, options_.threads),
                                   even.next(now, exact_now, options_.threads)};
    const double fresh = newcomers(now, last, scene_.gaussians.size());
    for (size_t m = 0; m < std::size(kMachines); ++m) {
      const OrderedPicture result = blend(now, sequences[m], options_.threads);
      found[m].differences.push_back(difference(result.image, exact));
      found[m].blends.blends += result.counts.blends, found[m].blends.late += result.counts.late;
      found[m].newcomers += fresh;
    }
  }

  static constexpr const char* kMachines[] = {"gsacc_all", "gsacc_seen", "neo", "neo_even"};
  const Scene& scene_;
  const Camera& camera_;
  const std::vector<Camera>& cameras_;
  const PixelOptions& options_;
  std::vector<Edge> edges_ = {};
  size_t steps_ = 0, done_ = 0;
  PixelStudy result_ = {};
};

}  // namespace

PixelStudy study_pixels(const Scene& scene, const Camera& view, const std::vector<Camera>& cameras,
                        const PixelOptions& options) {
  check_consistent(scene);
  const auto positive = [](double value) { return value > 0; };
  if (!std::all_of(options.voxels.begin(), options.voxels.end(), positive) ||
      !std::all_of(options.speeds.begin(), options.speeds.end(), positive) || !positive(options.step) ||
      options.frames < 1 || !(options.index_bytes >= 0))
    throw std::invalid_argument("pixels: edges, speeds, the step and the number of frames are above 0");
  if (!std::all_of(options.groups.begin(), options.groups.end(), [](int s) { return s > 0 && s % kTileSide == 0; }))
    throw std::invalid_argument("pixels: a group's side is a multiple of 16");
  return Study(scene, view, cameras, options).run();
}

}  // namespace pipegs
