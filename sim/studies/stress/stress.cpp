// SPDX-License-Identifier: Apache-2.0
// stress.cpp: see stress.hpp.
#include "sim/studies/stress/stress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <new>

#include "scenes/own_failure.hpp"
#include "sim/progress.hpp"

namespace pipegs {
namespace {

// The view with Gaussians [first, last) left out.
StressView without(const StressView& view, size_t first, size_t last) {
  StressView less = view;
  auto& gaussians = less.scene.gaussians;
  gaussians.erase(gaussians.begin() + static_cast<std::ptrdiff_t>(first),
                  gaussians.begin() + static_cast<std::ptrdiff_t>(last));
  const size_t rest = 3 * static_cast<size_t>(sh_rest_count(view.scene.sh_degree));
  auto& sh = less.scene.sh_rest;
  sh.erase(sh.begin() + static_cast<std::ptrdiff_t>(first * rest),
           sh.begin() + static_cast<std::ptrdiff_t>(last * rest));
  return less;
}

}  // namespace

std::optional<std::string> stress_check(const StressView& view, SimulateOptions options, bool rtl,
                                        StressFigures* figures) {
  options.near_plane = view.near_plane;
  Simulation simulation;
  BudgetReport report;
  try {
    simulate_golden(view.scene, view.camera, options, simulation);
    report = budget_frame(view.scene, view.camera, options, simulation);
    if (rtl) simulate_rtl(options, simulation);
  } catch (const std::exception& error) {
    const bool ours = dynamic_cast<const RtlBuildError*>(&error) != nullptr ||
                      dynamic_cast<const OwnFailure*>(&error) != nullptr ||
                      dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
    if (ours || interrupted()) throw;
    return fmt::format("stopped: {}", error.what());
  }
  if (figures != nullptr) {
    ++figures->views;
    figures->gaussians += view.scene.gaussians.size();
    figures->pairs += report.pairs, figures->vacuous += report.vacuous;
    figures->beats += simulation.beats, figures->cycles += simulation.rtl.cycles;
    figures->saturations += simulation.golden.saturations;
    figures->alpha = std::max(figures->alpha, report.alpha.error);
    figures->t = std::max(figures->t, report.t.error);
    figures->color = std::max(figures->color, report.color.error);
  }
  if (simulation.mismatches > 0) return fmt::format("RTL and golden model differ: {}", simulation.first_mismatch->what);
  if (!report.holds()) return fmt::format("beyond the bound: {}", *report.first);
  return std::nullopt;
}

StressShrunk stress_shrink(const StressView& view, const StressPredicate& predicate,
                           const std::function<bool(const StressShrunk&)>& step) {
  StressShrunk best{view, "", 1};
  const std::optional<std::string> whole = predicate(view);
  if (!whole) throw std::invalid_argument("stress_shrink: the view does not fail");
  best.what = *whole;
  bool stopped = false;
  const auto keep = [&](StressView less) {
    ++best.tried;
    const std::optional<std::string> what = predicate(less);
    if (what) best.view = std::move(less), best.what = *what;
    if (step && !step(best)) stopped = true;
    return what.has_value();
  };
  const auto fewer_gaussians = [&] {
    for (size_t part = std::max<size_t>(1, best.view.scene.gaussians.size() / 2); part > 0; part /= 2) {
      for (size_t first = 0; first < best.view.scene.gaussians.size() && !stopped;) {
        const size_t last = std::min(first + part, best.view.scene.gaussians.size());
        if (!keep(without(best.view, first, last))) first = last;
      }
    }
  };
  fewer_gaussians();
  // Narrower and lower, from the right and the bottom: what remains keeps its coordinates.
  for (int Camera::*side : {&Camera::width, &Camera::height}) {
    for (int cut = best.view.camera.*side / 2; cut > 0; cut /= 2) {
      while (best.view.camera.*side > cut && !stopped) {
        StressView less = best.view;
        less.camera.*side -= cut;
        if (!keep(std::move(less))) break;
      }
    }
  }
  fewer_gaussians();
  return best;
}

}  // namespace pipegs
