// timing_check.cpp: see timing_check.hpp.
#include "sim/timing_check.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace pipegs {
namespace {

// Notes when the end of each window leaves the merge.
class WindowTaps final : public RtlTaps {
 public:
  explicit WindowTaps(const Config& config) : kind_w_(config.kind_w()) {}
  void on_splat(int, const uint32_t*) override {}
  void on_alphas(int, uint64_t, uint64_t, uint32_t, int, const uint32_t*) override {}
  void on_pixels(int, int, int, const uint32_t*) override {}
  void on_sorted(const uint32_t* sorted) override {
    if ((sorted[0] & ((1u << kind_w_) - 1)) == kWindowEnd) ends.push_back(static_cast<uint64_t>(cycle));
  }
  std::vector<uint64_t> ends;

 private:
  int kind_w_;
};

}  // namespace

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

RtlTiming rtl_timing(const GoldenInput& input, const Config& config, const ExternalMemoryOptions& options, uint64_t seed) {
  const std::unique_ptr<RtlModel> model = load_rtl(config, built_variant(config));
  ExternalMemory memory(options);
  const MemoryImage image = memory_image(*input.packed);
  for (size_t i = 0; i < image.lines.size(); ++i) memory.line(i) = image.lines[i];
  std::vector<uint32_t> words(record_words<Frame>(config) + 1);
  pack(config, input.frame, words.data());
  WindowTaps taps(config);
  RtlOptions rtl_options;
  rtl_options.seed = seed;
  const double before = thread_seconds();
  const RtlResult rtl = model->run(words.data(), memory, rtl_options, &taps, {});
  RtlTiming result{.cycles = rtl.cycles, .overflow_lines = rtl.overflow_lines, .window_ends = {}, .seconds = thread_seconds() - before};
  result.window_ends = taps.ends;
  return result;
}

TimingErrors timing_errors(const TimingResult& model, const RtlTiming& rtl) {
  TimingErrors errors;
  errors.frame = static_cast<double>(model.cycles) / static_cast<double>(rtl.cycles) - 1;
  uint64_t model_before = 0, rtl_before = 0;
  for (size_t i = 0; i < std::min(model.window_ends.size(), rtl.window_ends.size()); ++i) {
    const uint64_t window = rtl.window_ends[i] - rtl_before;
    if (window >= kWindowCycles) {
      ++errors.windows;
      const double error = static_cast<double>(model.window_ends[i] - model_before) / static_cast<double>(window) - 1;
      if (std::abs(error) > std::abs(errors.worst_window)) errors.worst_window = error;
    }
    model_before = model.window_ends[i];
    rtl_before = rtl.window_ends[i];
  }
  return errors;
}

}  // namespace pipegs
