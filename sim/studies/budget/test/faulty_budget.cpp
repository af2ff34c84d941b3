// SPDX-License-Identifier: Apache-2.0
// faulty_budget.cpp: the command line on a bit-accurate model that breaks its bound: with PIPEGS_FAULT=bound one of the
// Gaussians that `pipegs study budget` looks at lies beyond it.
//
// Idea    As in faulty_rtl.cpp the linker puts this in the place of budget_samples (--wrap); all else is `pipegs`.
#include <cstdlib>
#include <string_view>

#include "sim/studies/budget/sample.hpp"

namespace pipegs {

using Progress = std::function<void(double)>;

std::vector<BudgetSample> true_samples(const Config& config, uint64_t seed, size_t count, const Progress& progress) asm(
    "__real__ZN6pipegs14budget_samplesERKNS_6ConfigEmmRKSt8functionIFvdEE");
std::vector<BudgetSample> faulty_samples(
    const Config& config, uint64_t seed, size_t count,
    const Progress& progress) asm("__wrap__ZN6pipegs14budget_samplesERKNS_6ConfigEmmRKSt8functionIFvdEE");

std::vector<BudgetSample> faulty_samples(const Config& config, uint64_t seed, size_t count, const Progress& progress) {
  std::vector<BudgetSample> samples = true_samples(config, seed, count, progress);
  const char* fault = std::getenv("PIPEGS_FAULT");
  if (fault == nullptr || std::string_view(fault) != "bound") return samples;
  BudgetSample& last = samples.back();
  last.power = 2 * last.bound;
  last.power_excess = last.bound;
  return samples;
}

}  // namespace pipegs
