// SPDX-License-Identifier: Apache-2.0
// fidelity.cpp: see fidelity.hpp.
#include "sim/studies/accuracy/fidelity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cpp_model/float/metrics.hpp"
#include "cpp_model/float/truth.hpp"
#include "sim/progress.hpp"
#include "sim/timing/timing_model.hpp"

namespace pipegs {
namespace {

void stop_when_interrupted(double) {
  if (interrupted()) throw std::runtime_error("interrupted");
}

uint64_t bytes_of(const std::vector<MemoryTraffic>& traffic) {
  uint64_t bytes = 0;
  for (const MemoryTraffic& stream : traffic) bytes += stream.bytes_read + stream.bytes_written;
  return bytes;
}

// A run of the RTL with every comparison; the golden model's results are in `simulation`.
FidelityRow rtl_row(const std::string& name, const SimulateOptions& options, Simulation& simulation, Fidelity& result) {
  FidelityRow row{.name = name};
  try {
    simulate_rtl(options, simulation);
  } catch (const RtlBuildError& error) {
    row.failure = error.what();
    return row;
  }
  result.mismatches += simulation.mismatches;
  row.seconds = simulation.wall_rtl;
  row.pixels = simulation.mismatches == 0 ? "bit by bit" : fmt::format("{} mismatches", simulation.mismatches);
  row.cycles = fmt::format("{}", simulation.rtl.cycles);
  row.bytes = fmt::format("{}", bytes_of(simulation.traffic));
  row.stalls = "of every unit";
  return row;
}

// Takes the waves away again, whatever happens.
struct WaveFile {
  explicit WaveFile(std::string path) : path_(std::move(path)) {}
  WaveFile(const WaveFile&) = delete;
  ~WaveFile() {
    std::error_code ignored;
    for (const char* end : {"", ".hier"}) std::filesystem::remove(path_ + end, ignored);
  }
  uint64_t bytes() const {
    std::error_code none;
    const auto size = std::filesystem::file_size(path_, none);
    return none ? 0 : size;
  }

 private:
  std::string path_;
};

// Read and written, stream by stream.
bool same_bytes(const std::vector<TimingResult::Stream>& model, const std::vector<MemoryTraffic>& rtl) {
  return std::equal(model.begin(), model.end(), rtl.begin(), rtl.end(),
                    [](const TimingResult::Stream& a, const MemoryTraffic& b) {
                      return a.name == b.stream && a.bytes_read == b.bytes_read && a.bytes_written == b.bytes_written;
                    });
}

}  // namespace

Fidelity fidelity(const Scene& scene, const Camera& camera, const SimulateOptions& options,
                  std::array<int, 2> wave_window, const std::string& wave_file) {
  Fidelity result;
  Simulation simulation;
  simulate_pack(scene, camera, options, simulation);
  Stopwatch watch;
  const auto lap = [&watch] {
    const double passed = watch.seconds();
    watch = Stopwatch();
    return passed;
  };

  TruthOptions truth_options{.near_plane = options.near_plane, .threads = 1, .progress = stop_when_interrupted};
  lap();
  const Image truth = render_truth(scene, camera, truth_options);
  FidelityRow truth_row{
      .name = "truth, float64", .seconds = lap(), .pixels = "", .cycles = "-", .bytes = "-", .stalls = "-"};
  simulation.golden = golden_frame(simulation.input, {.threads = 1, .progress = stop_when_interrupted});
  FidelityRow golden_row{
      .name = "golden model", .seconds = lap(), .pixels = "", .cycles = "-", .bytes = "-", .stalls = "-"};
  truth_row.pixels = fmt::format("{:.1f} dB", psnr(truth, simulation.golden.image));
  lap();
  const TimingTrace trace = timing_trace(simulation.input, 1);
  stop_when_interrupted(0);
  const TimingResult timing = timing_run(trace, options.config, options.memory);
  FidelityRow model_row{
      .name = "timing model", .seconds = lap(), .pixels = "-", .cycles = "", .bytes = "", .stalls = "-"};

  SimulateOptions plain = options, threads = options;
  threads.variant = plain.variant;
  threads.variant.threads = 2;
  const FidelityRow two = rtl_row("RTL, 2 threads", threads, simulation, result);
  const FidelityRow one = rtl_row("RTL, 1 thread", plain, simulation, result);
  golden_row.pixels = one.pixels;
  if (one.failure.empty()) {
    const bool same = same_bytes(timing.streams, simulation.traffic);
    result.mismatches += timing.cycles != simulation.rtl.cycles;
    result.mismatches += !same;
    model_row.cycles =
        fmt::format("{} ({:+.3f} %)", timing.cycles,
                    100 * (static_cast<double>(timing.cycles) / static_cast<double>(simulation.rtl.cycles) - 1));
    model_row.bytes = same ? "the same, by stream" : "differ";
  }

  SimulateOptions window = options;
  window.window = wave_window;
  Simulation small;
  simulate_golden(scene, camera, window, small);
  const FidelityRow still = rtl_row("RTL, one window", window, small, result);
  window.rtl.waves = wave_file;
  const WaveFile removed(wave_file);
  FidelityRow waves = rtl_row("  with waves", window, small, result);
  result.wave_bytes = removed.bytes();

  result.rows = {truth_row, golden_row, model_row, one, two, still, waves};
  for (FidelityRow& row : result.rows) row.ratio = row.seconds / golden_row.seconds;
  result.rows.back().ratio = waves.seconds / still.seconds;
  return result;
}

bool Fidelity::complete() const {
  return std::all_of(rows.begin(), rows.end(), [](const FidelityRow& row) { return row.failure.empty(); });
}

std::string fidelity_text(const Fidelity& fidelity) {
  std::string text = fmt::format("  {:<18}{:>9}{:>9}  {:<14}{:<22}{:<22}{}\n", "", "wall s", "ratio", "pixels",
                                 "cycles", "bytes", "stalls");
  for (const FidelityRow& row : fidelity.rows) {
    if (!row.failure.empty()) text += fmt::format("  {:<18}not run: {}\n", row.name, row.failure);
    else
      text += fmt::format("  {:<18}{:>9.2f}{:>9.2f}  {:<14}{:<22}{:<22}{}\n", row.name, row.seconds, row.ratio,
                          row.pixels, row.cycles, row.bytes, row.stalls);
  }
  return text + fmt::format(
                    "  ratio: to the golden model; with waves: to the same window without ({:.1f} MB of waves). One "
                    "core, but for 2 threads.\n",
                    static_cast<double>(fidelity.wave_bytes) / 1e6);
}

nlohmann::ordered_json fidelity_json(const Fidelity& fidelity) {
  nlohmann::ordered_json json = {{"mismatches", fidelity.mismatches},
                                 {"wave_bytes", fidelity.wave_bytes},
                                 {"rows", nlohmann::ordered_json::array()}};
  for (const FidelityRow& row : fidelity.rows) {
    if (!row.failure.empty()) json["rows"].push_back({{"name", row.name}, {"failure", row.failure}});
    else
      json["rows"].push_back({{"name", row.name},
                              {"seconds", row.seconds},
                              {"ratio", row.ratio},
                              {"pixels", row.pixels},
                              {"cycles", row.cycles},
                              {"bytes", row.bytes},
                              {"stalls", row.stalls}});
  }
  return json;
}

}  // namespace pipegs
