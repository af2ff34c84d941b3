// SPDX-License-Identifier: Apache-2.0
// truth: the renderer of truth.hpp.
//
// Idea    project all -> bin into 16x16 tiles -> sort each tile's by the wanted order and blend them. All
//         three steps run on all threads; tiles share nothing and an order has no ties, so the picture
//         does not depend on the number of threads.
// Memory  A projected Gaussian that touches the window is kept once (Splats), all else is its number.
// Speed   A row's powers are computed without branches; a Gaussian that cannot reach 1/255 at a
//         pixel is dropped by comparing powers, before the exponential.
#include "cpp_model/float/truth.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>

#include "cpp_model/float/parallel.hpp"

namespace pipegs {
namespace {

constexpr int kBin = 16;
constexpr std::size_t kBlock = 8192;  // Gaussians that a thread projects at a time

// What blending needs of a Gaussian; kept small since scenes have millions.
struct Splat {
  glm::dvec2 mean;
  glm::dvec3 conic;
  double opacity, depth;
  double least_power;  // below it alpha < 1/255 for certain
  glm::dvec3 rgb;
  PixelRect rect;
  double order;  // the rank or the depth, as the options say
  std::uint32_t index;
};

// The Gaussians that may touch the window, in blocks of the scene. The place of one rises with its index.
struct Splats {
  std::vector<std::vector<Splat>> blocks;
  const Splat& operator[](std::uint32_t place) const { return blocks[place / kBlock][place % kBlock]; }
};

// Of a Gaussian in the blending order, which has no ties.
struct Turn {
  double order;
  std::uint32_t place;
  bool operator<(const Turn& o) const { return order != o.order ? order < o.order : place < o.place; }
};

struct Rules {
  Semantics semantics;
  double center;  // of pixel 0

  explicit Rules(Semantics s) : semantics(s), center(s == Semantics::kGsplat ? 0.5 : 0.0) {}

  // INRIA and gsplat skip a power above 0, the hardware clamps it.
  bool settle(double& power) const {
    if (power > 0) {
      if (semantics != Semantics::kExact) return false;
      power = 0;
    }
    return true;
  }
  bool finishes(double next) const {
    return semantics == Semantics::kGsplat ? next <= kMinTransmittance : next < kMinTransmittance;
  }
};

void check(const Scene& scene, const Camera& camera, const TruthOptions& options) {
  check_consistent(scene);
  if (options.rank != nullptr && options.rank->size() != scene.gaussians.size()) {
    throw std::invalid_argument("truth: rank holds " + std::to_string(options.rank->size()) + " entries, the scene " +
                                std::to_string(scene.gaussians.size()) + " Gaussians");
  }
  if (options.largest_weight != nullptr && options.largest_weight->size() != scene.gaussians.size()) {
    throw std::invalid_argument("truth: largest_weight holds " + std::to_string(options.largest_weight->size()) +
                                " entries, the scene " + std::to_string(scene.gaussians.size()) + " Gaussians");
  }
  if (options.clip_window && !(0 <= options.x0 && options.x0 < options.x1 && options.x1 <= camera.width &&
                               0 <= options.y0 && options.y0 < options.y1 && options.y1 <= camera.height)) {
    throw std::invalid_argument("truth: the clip window is empty or outside the image");
  }
}

PixelRect intersection(const PixelRect& a, const PixelRect& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

// One Gaussian, if it may touch `window`.
std::optional<Splat> splat_of(const Scene& scene, std::size_t i, const Camera& camera, const TruthOptions& options,
                              const PixelRect& window) {
  const ProjectionOptions projection{options.semantics, options.near_plane, scene.antialiased,
                                     std::max(0, options.sh_degree)};
  ActivatedGaussian gaussian;
  if (activate(scene, i, gaussian) != Cull::kNone) return std::nullopt;
  const TruthProjection p =
      project_truth(gaussian, scene.gaussians[i].sh_dc, sh_rest_of(scene, i), scene.sh_degree, camera, projection);
  const PixelRect rect = intersection(footprint(p, camera, options.semantics), window);
  if (rect.empty()) return std::nullopt;
  const double least_power = -std::log(255 * p.opacity) - 1e-9;
  // Both references sort by the bits of a float, so depths that differ less are ties there.
  const double depth =
      options.semantics == Semantics::kExact ? p.depth : static_cast<double>(static_cast<float>(p.depth));
  const double order = options.rank != nullptr ? (*options.rank)[i] : depth;
  return Splat{p.mean, p.conic, p.opacity, p.depth, least_power, p.rgb, rect, order, static_cast<std::uint32_t>(i)};
}

Splats project_all(const Scene& scene, const Camera& camera, const TruthOptions& options, const PixelRect& window) {
  const std::size_t count = scene.gaussians.size();
  Splats splats;
  splats.blocks.resize((count + kBlock - 1) / kBlock);
  parallel_for(splats.blocks.size(), options.threads, [&](std::size_t b) {
    std::vector<Splat> found;
    found.reserve(kBlock);
    for (std::size_t i = b * kBlock; i < std::min(count, (b + 1) * kBlock); ++i) {
      if (const auto splat = splat_of(scene, i, camera, options, window)) found.push_back(*splat);
    }
    splats.blocks[b].assign(found.begin(), found.end());
  });
  return splats;
}

struct Bins {
  int columns, rows;
  std::vector<std::size_t> first;  // per bin, one more at the end
  std::vector<std::uint32_t> splats;
};

// Calls action(bin, place) for each bin that each splat touches, on all threads.
template <class Action>
void for_each_bin(const Splats& splats, const PixelRect& window, int columns, unsigned threads, Action&& action) {
  parallel_for(splats.blocks.size(), threads, [&](std::size_t block) {
    for (std::size_t k = 0; k < splats.blocks[block].size(); ++k) {
      const PixelRect& rect = splats.blocks[block][k].rect;
      for (int y = (rect.y0 - window.y0) / kBin; y <= (rect.y1 - 1 - window.y0) / kBin; ++y) {
        for (int x = (rect.x0 - window.x0) / kBin; x <= (rect.x1 - 1 - window.x0) / kBin; ++x) {
          action(static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x),
                 static_cast<std::uint32_t>(block * kBlock + k));
        }
      }
    }
  });
}

// The places of each bin's splats, in any order: blend_bin() sorts them.
Bins bin(const Splats& splats, const PixelRect& window, unsigned threads) {
  Bins bins{(window.x1 - window.x0 + kBin - 1) / kBin, (window.y1 - window.y0 + kBin - 1) / kBin, {}, {}};
  bins.first.assign(static_cast<std::size_t>(bins.columns) * static_cast<std::size_t>(bins.rows) + 1, 0);
  for_each_bin(splats, window, bins.columns, threads,
               [&](std::size_t b, std::uint32_t) { ++std::atomic_ref(bins.first[b + 1]); });
  for (std::size_t b = 1; b < bins.first.size(); ++b) bins.first[b] += bins.first[b - 1];
  bins.splats.resize(bins.first.back());
  std::vector<std::size_t> cursor(bins.first.begin(), bins.first.end() - 1);
  for_each_bin(splats, window, bins.columns, threads,
               [&](std::size_t b, std::uint32_t place) { bins.splats[std::atomic_ref(cursor[b])++] = place; });
  return bins;
}

void raise(float& largest, float value) {
  const std::atomic_ref shared(largest);
  float known = shared.load(std::memory_order_relaxed);
  while (known < value && !shared.compare_exchange_weak(known, value, std::memory_order_relaxed)) {}
}

void blend_bin(const Splats& splats, std::span<const std::uint32_t> places, const Rules& rules, const PixelRect& area,
               const PixelRect& window, Image& image, std::vector<float>* largest_weight) {
  double best[kBin * kBin] = {};  // largest weight of each pixel
  std::vector<Turn> turns;
  turns.reserve(places.size());
  for (const std::uint32_t place : places) turns.push_back({splats[place].order, place});
  std::sort(turns.begin(), turns.end());
  bool finished[kBin * kBin] = {};
  int live = (area.x1 - area.x0) * (area.y1 - area.y0);
  for (auto turn = turns.begin(); turn != turns.end() && live > 0; ++turn) {
    const Splat& s = splats[turn->place];
    const PixelRect r = intersection(s.rect, area);
    double powers[kBin], largest = 0;
    for (int y = r.y0; y < r.y1; ++y) {
      const double dy = s.mean.y - (y + rules.center);
      for (int x = r.x0; x < r.x1; ++x) powers[x - r.x0] = power_at(s.conic, s.mean.x - (x + rules.center), dy);
      for (int x = r.x0; x < r.x1; ++x) {
        double power = powers[x - r.x0];
        const int in_bin = (y - area.y0) * kBin + (x - area.x0);
        bool& done = finished[in_bin];
        if (!(power >= s.least_power) || done || !rules.settle(power)) continue;
        const double alpha = std::min(kMaxAlpha, s.opacity * std::exp(power));
        if (alpha < kMinAlpha) continue;
        const std::size_t pixel = image.at(x - window.x0, y - window.y0);
        const double before = image.transmittance[pixel];
        const double next = before * (1 - alpha);
        if (rules.finishes(next)) {
          done = true;
          --live;
          continue;
        }
        const double weight = alpha * before;
        image.rgb[pixel] += weight * s.rgb;
        image.depth[pixel] += weight * s.depth;
        image.transmittance[pixel] = next;
        ++image.blended[pixel];
        if (!image.median.empty()) {
          if (before >= 0.5 && next < 0.5) image.median[pixel] = s.depth;
          if (weight > best[in_bin]) best[in_bin] = weight, image.index[pixel] = s.index;
        }
        largest = std::max(largest, weight);
      }
    }
    if (largest_weight != nullptr && largest > 0) raise((*largest_weight)[s.index], static_cast<float>(largest));
  }
}

}  // namespace

Image render_truth(const Scene& scene, const Camera& camera, const TruthOptions& options) {
  check(scene, camera, options);
  const PixelRect window = options.clip_window ? PixelRect{options.x0, options.y0, options.x1, options.y1}
                                               : PixelRect{0, 0, camera.width, camera.height};
  const Splats splats = project_all(scene, camera, options, window);
  const Bins bins = bin(splats, window, options.threads);
  const Rules rules(options.semantics);
  Image image(window.x1 - window.x0, window.y1 - window.y0);
  if (options.aovs) image.median.assign(image.depth.size(), 0), image.index.assign(image.depth.size(), kNoGaussian);
  const std::size_t total = bins.first.size() - 1;
  std::size_t done = 0;
  std::mutex mutex;
  parallel_for(total, options.threads, [&](std::size_t b) {
    const int x = window.x0 + kBin * static_cast<int>(b % static_cast<std::size_t>(bins.columns));
    const int y = window.y0 + kBin * static_cast<int>(b / static_cast<std::size_t>(bins.columns));
    const PixelRect area = intersection({x, y, x + kBin, y + kBin}, window);
    const auto places = std::span(bins.splats).subspan(bins.first[b], bins.first[b + 1] - bins.first[b]);
    blend_bin(splats, places, rules, area, window, image, options.largest_weight);
    if (options.progress) {
      const std::lock_guard lock(mutex);
      options.progress(static_cast<double>(++done) / static_cast<double>(total));
    }
  });
  return image;
}

std::vector<TruthStep> explain_truth(const Scene& scene, const Camera& camera, const TruthOptions& options, int px,
                                     int py) {
  TruthOptions pixel = options;
  pixel.clip_window = true;
  pixel.x0 = px;
  pixel.y0 = py;
  pixel.x1 = px + 1;
  pixel.y1 = py + 1;
  check(scene, camera, pixel);
  const Rules rules(options.semantics);
  std::vector<TruthStep> steps;
  double transmittance = 1;
  const Splats splats = project_all(scene, camera, pixel, {px, py, px + 1, py + 1});
  std::vector<Turn> turns;
  for (std::size_t b = 0; b < splats.blocks.size(); ++b) {
    for (std::size_t k = 0; k < splats.blocks[b].size(); ++k)
      turns.push_back({splats.blocks[b][k].order, static_cast<std::uint32_t>(b * kBlock + k)});
  }
  std::sort(turns.begin(), turns.end());
  for (const Turn& turn : turns) {
    const Splat& s = splats[turn.place];
    double power = power_at(s.conic, s.mean.x - (px + rules.center), s.mean.y - (py + rules.center));
    if (!(power >= s.least_power) || !rules.settle(power)) continue;
    const double alpha = std::min(kMaxAlpha, s.opacity * std::exp(power));
    if (alpha < kMinAlpha) continue;
    const double next = transmittance * (1 - alpha);
    if (rules.finishes(next)) break;
    steps.push_back({s.index, power, alpha, alpha * transmittance, transmittance});
    transmittance = next;
  }
  return steps;
}

}  // namespace pipegs
