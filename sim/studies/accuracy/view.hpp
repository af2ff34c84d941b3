// SPDX-License-Identifier: Apache-2.0
// view.hpp: one view of a scene, measured in any configuration: how far from the truth, and what it costs.
//
// Idea    The truth is float64 with the reference's rules: alpha cut 1/255, stop at 1e-4, all SH bands of the scene.
//           numeric  golden model against the truth in the golden model's order: what numbers (and other rules) cost
//           order    the truth in that order against the truth in depth order: what layers and depth keys cost
//           total    golden model against the truth in depth order
//         Cycles and bytes come from the timing model, buffers from static_cost.
// Reuse   The truth in an order is kept for a while: many configurations have the same order.
// Threads measure() computes on the calling thread and may be called from several; the constructor uses all.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "sim/studies/accuracy/flips.hpp"
#include "sim/compare/simulate.hpp"

namespace pipegs {

struct ErrorFigures {
  double psnr = 0, ssim = 0, max = 0, p999 = 0;  // p999: the 99.9th percentile of the absolute error
};

struct Accuracy {
  std::string failure;  // one line when the scene does not fit the configuration; then nothing below holds
  ErrorFigures numeric, order, total;
  Flips flips;
  uint64_t cycles = 0, bytes = 0, buffer_bits = 0;
  double seconds_golden = 0, seconds_truth = 0, seconds_trace = 0,
         seconds_model = 0;  // of one core; truth 0 when reused

  double gbps() const { return static_cast<double>(bytes) / static_cast<double>(cycles); }  // at 1 GHz
  double buffer_kb() const { return static_cast<double>(buffer_bits) / 8192; }
};

// Mean squared error of a PSNR, 0 for equal images.
double mean_square(double psnr);

class AccuracyView {
 public:
  // `options` give memory, near plane and window; its configuration only the side of that window. Scene and camera must
  // outlive the view.
  AccuracyView(const Scene& scene, const Camera& camera, const SimulateOptions& options);

  Accuracy measure(const Config& config) const;

  const Image& exact() const { return exact_; }  // the truth in depth order, of the part that was asked for
  Image golden(const Config& config) const;      // of the same part
  double flips_sampled() const { return flips_->sampled(); }
  SimulateOptions options(const Config& config) const;
  bool can_show(const Config& config) const;  // a part that was asked for is one of the base's windows

 private:
  struct Ordered {
    std::vector<uint32_t> rank;
    Image truth;
    ErrorFigures error;  // against depth order
  };
  std::shared_ptr<const Ordered> ordered(const std::vector<uint32_t>& rank, unsigned threads) const;
  Image truth(const std::vector<uint32_t>* rank, unsigned threads) const;

  const Scene& scene_;
  const Camera& camera_;
  const SimulateOptions options_;
  Image exact_;
  std::unique_ptr<FlipCounter> flips_;
  mutable std::mutex mutex_;
  mutable std::deque<std::shared_ptr<const Ordered>> kept_;
};

}  // namespace pipegs
