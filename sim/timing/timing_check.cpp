// SPDX-License-Identifier: Apache-2.0
// timing_check.cpp: see timing_check.hpp.
#include "sim/timing/timing_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "cpp_model/areas/frame_areas.hpp"
#include "cpp_model/control/job.hpp"

namespace pipegs {
namespace {

// Notes when the end of each window leaves the merge.
class WindowTaps final : public RtlTaps {
 public:
  explicit WindowTaps(const Config& config) : kind_w_(config.kind_w()) {}
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

RtlTiming rtl_timing(const GoldenInput& input, const Config& config, const ExternalMemoryOptions& options,
                     uint64_t seed, Lockstep* lockstep) {
  const std::unique_ptr<RtlModel> model = load_rtl(config, built_variant());
  ExternalMemory memory(options, config.bus_w);
  memory.load(memory_image(*input.packed).lines);
  WindowTaps windows(config);
  RtlTaps& taps = lockstep != nullptr ? static_cast<RtlTaps&>(*lockstep) : windows;
  RtlOptions rtl_options;
  rtl_options.seed = seed;
  const double before = thread_seconds();
  const Areas areas = frame_areas(config, *input.packed, input.frame, input.picture);
  memory.set_lines(input.frame.tables.overflow + areas.overflow);
  const RtlResult rtl =
      model->run({frame_job(config, input.frame, areas, input.picture)}, memory, rtl_options, &taps, {});
  if (lockstep != nullptr) lockstep->finish();
  return {.cycles = rtl.cycles,
          .overflow_lines = rtl.overflow_lines,
          .traffic = memory_traffic(config, memory),
          .window_ends = lockstep != nullptr ? lockstep->window_ends() : windows.ends,
          .seconds = thread_seconds() - before};
}

std::vector<std::string> timing_differences(const TimingResult& model, const RtlTiming& rtl) {
  std::vector<std::string> lines;
  const auto compare = [&lines](const std::string& what, uint64_t by_rtl, uint64_t by_model) {
    if (by_rtl != by_model) lines.push_back(fmt::format("{}: RTL {}, model {}", what, by_rtl, by_model));
  };
  compare("cycles", rtl.cycles, model.cycles);
  compare("lines that overflow", rtl.overflow_lines, model.overflow_lines);
  for (size_t i = 0; i < rtl.traffic.size(); ++i) {
    compare("bytes read, " + rtl.traffic[i].stream, rtl.traffic[i].bytes_read, model.streams.at(i).bytes_read);
    compare("bursts read, " + rtl.traffic[i].stream, rtl.traffic[i].bursts, model.streams.at(i).bursts);
    compare("bytes written, " + rtl.traffic[i].stream, rtl.traffic[i].bytes_written, model.streams.at(i).bytes_written);
  }
  if (rtl.window_ends.empty()) return lines;
  compare("windows", rtl.window_ends.size(), model.window_ends.size());
  uint64_t rtl_before = 0, model_before = 0;
  for (size_t i = 0; i < std::min(rtl.window_ends.size(), model.window_ends.size()); ++i) {
    compare(fmt::format("cycles of window {}", i), rtl.window_ends[i] - rtl_before,
            model.window_ends[i] - model_before);
    rtl_before = rtl.window_ends[i], model_before = model.window_ends[i];
  }
  return lines;
}

}  // namespace pipegs
