// SPDX-License-Identifier: Apache-2.0
// view.hpp: one view of a scene, measured in any configuration and with less of it drawn: how far from the truth, and
// what it costs.
//
// Idea    The truth is float64 with the reference's rules: alpha cut 1/255, stop at 1e-4, all SH bands of the scene.
//           numeric  golden model against the truth in the golden model's order: what numbers (and other rules) cost
//           order    the truth in that order against the truth in depth order: what layers and depth keys cost
//           total    golden model, brought to full size, against the truth of the whole scene in depth order
//         Cycles and bytes come from the timing model, buffers from static_cost.
// Rule    numeric and order are measured of whole scenes at full size only. Gaussians that proxies stand for have no
//         place in an order: where proxies may be drawn, numeric is the total, and order costs nothing.
// Reuse   Truths in an order, the scene without some of its Gaussians and the trace of the timing model are held for a
//         while: configurations that share() them are measured together.
// Threads measure() computes on the calling thread and may be called from several.
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "sim/compare/simulate.hpp"
#include "sim/studies/explore/figures.hpp"
#include "sim/studies/explore/less.hpp"
#include "sim/timing/cycle_engine.hpp"

namespace pipegs {

class View {
 public:
  // `options` give memory, near plane and window; its configuration only the side of that window. Scene and cameras
  // must outlive the view.
  View(const Scene& scene, const Camera& camera, const std::vector<Camera>& cameras, const SimulateOptions& options,
       Measured measured);

  Figures measure(const Config& config, const Less& less = {}) const;
  // What is the same in all that should be measured one after the other.
  std::string shared(const Config& config, const Less& less) const;
  // What a stored measurement depends on beside view and configuration.
  nlohmann::ordered_json key(const Less& less) const;

  // Says what is odd in a measurement; from any thread.
  void tell(const Findings& findings) const;

  Measured measured() const { return measured_; }
  Camera camera(const Less& less) const;
  size_t gaussians(const Less& less) const;

 private:
  struct Ordered {
    std::vector<uint32_t> rank;
    Image truth;
    ErrorFigures error;  // against depth order
  };
  struct Lesser {
    double without = 0;
    Scene scene;
  };
  std::shared_ptr<const Ordered> ordered(const std::vector<uint32_t>& rank) const;
  std::shared_ptr<const Lesser> scene_without(double without) const;
  Image truth(const std::vector<uint32_t>* rank, unsigned threads) const;  // of the part that was asked for
  const Image& exact() const;                                              // in depth order
  void measure_picture(const Config& config, const Less& less, Figures& result) const;

  const Scene& scene_;
  const Camera& camera_;
  const std::vector<Camera>& cameras_;
  const SimulateOptions options_;
  const Measured measured_;
  const CycleEngine engine_;
  mutable std::once_flag exact_once_;
  mutable Image exact_;
  mutable std::mutex mutex_, lesser_mutex_;
  mutable std::deque<std::shared_ptr<const Ordered>> orders_;
  mutable std::vector<float> contributions_;
  mutable std::shared_ptr<const Lesser> lesser_;
};

}  // namespace pipegs
