// SPDX-License-Identifier: Apache-2.0
// faulty_rtl.cpp: the command line on a machine with a fault: what a command says, and its exit code, when the RTL
// differs, hangs, or the computer gives up.
//
// Idea    The linker puts this in the place of load_rtl (--wrap), so all else is `pipegs` as it is. The machine is the
//         true one; PIPEGS_FAULT in the environment names what is done to its run:
//           color   the lowest bit of red of the first pixel of region 5 is turned over wherever an RU shows it
//           pixel   bit 9 of pixel 66,3 is turned over in memory, or of the first pixel where there is no such
//           cycles  it reports one cycle more, and shows the first chunk that its DOPU sends a cycle late
//           hang    it counts as hung before it can have asked for anything
//           memory  the run has no memory left; bug: a function breaks its promise
//         Or it is the library PIPEGS_LIBRTL, of other sources.
//         Every variant of the default machine is that machine, which changes neither a cycle nor a bit, and need not
//         be built.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <new>
#include <optional>
#include <string_view>
#include <vector>

#include "cpp_model/control/job.hpp"
#include "cpp_model/frame_setup.hpp"
#include "cpp_model/ru/ru_resolve.hpp"
#include "sim/rtl/rtl_model.hpp"

namespace pipegs {
namespace {

// All that a machine shows, with a fault in it: its first chunk is late, a colour is wrong, or something is done to
// the memory before the frame counts as complete.
class FaultyTaps final : public RtlTaps {
 public:
  FaultyTaps(const Config& config, RtlTaps& taps, std::string_view fault, std::function<void()> before_done)
      : taps_(taps),
        chunk_words_(static_cast<int>(record_words<Chunk>(config))),
        late_(fault == "cycles"),
        wrong_color_(fault == "color"),
        before_done_(std::move(before_done)) {}
  void on_splat(int unit, const uint32_t* splat) override { now().on_splat(unit, splat); }
  void on_sorted(const uint32_t* sorted) override { now().on_sorted(sorted); }
  void on_alphas(int lane, uint64_t x, uint64_t y, uint32_t index, int region, int quarter,
                 const uint32_t* line) override {
    now().on_alphas(lane, x, y, index, region, quarter, line);
  }
  void on_pixels(int lane, int region, int quarter, const uint32_t* word) override {
    if (!wrong_color_ || region != 5) return now().on_pixels(lane, region, quarter, word);
    std::array<uint32_t, 64> wrong;  // a word is no wider
    std::copy_n(word, wrong.size(), wrong.begin());
    wrong[0] ^= 1;
    now().on_pixels(lane, region, quarter, wrong.data());
  }
  bool wants_cycles() const override { return taps_.wants_cycles(); }
  void on_cycle(uint64_t number, const uint8_t* states) override {
    now().on_cycle(number, states);
    if (held_) now().on_chunk(held_->unit, held_->kind, held_->words.data());
    held_.reset();
  }
  void on_border(const uint8_t* border) override { now().on_border(border); }
  void on_chunk(int unit, int kind, const uint32_t* chunk) override {
    if (!late_) return now().on_chunk(unit, kind, chunk);
    late_ = false;
    held_ = {unit, kind, {chunk, chunk + chunk_words_}};
  }
  void on_line_free(int unit) override { now().on_line_free(unit); }
  void on_layer_done(int unit, bool window_done) override { now().on_layer_done(unit, window_done); }
  void on_request(int tag, bool write, uint64_t line, int lines) override { now().on_request(tag, write, line, lines); }
  void on_frame_left() override { now().on_frame_left(); }
  void on_give_up() override { now().on_give_up(); }
  void on_frame_done() override {
    before_done_();
    now().on_frame_done();
  }

 private:
  RtlTaps& now() {
    taps_.cycle = cycle, taps_.wave_time = wave_time;
    return taps_;
  }

  struct Beat {
    int unit, kind;
    std::vector<uint32_t> words;
  };

  RtlTaps& taps_;
  const int chunk_words_;
  bool late_, wrong_color_;
  std::optional<Beat> held_;
  std::function<void()> before_done_;
};

class FaultyMachine final : public RtlModel {
 public:
  FaultyMachine(const Config& config, std::unique_ptr<RtlModel> machine, std::string_view fault)
      : config_(config), machine_(std::move(machine)), fault_(fault) {}

  RtlResult drive(const std::function<void(const pipegs_bus&)>& program, ExternalMemory& memory,
                  const RtlOptions& options, RtlTaps* taps, const Progress& progress) override {
    return machine_->drive(program, memory, options, taps, progress);
  }
  RtlResult run(const std::vector<pipegs_job>& frames, ExternalMemory& memory, const RtlOptions& options, RtlTaps* taps,
                const Progress& progress) override {
    if (fault_ == "memory") throw std::bad_alloc();
    if (fault_ == "bug") throw std::logic_error("a promise is broken");
    RtlOptions mine = options;
    if (fault_ == "hang") mine.quiet_limit = 2;
    const auto before_done = [&] {
      if (fault_ == "pixel") turn_over(job_frame(config_, frames.front()), memory);
    };
    std::optional<FaultyTaps> faulty;
    if (taps != nullptr) taps = &faulty.emplace(config_, *taps, fault_, before_done);
    RtlResult result = machine_->run(frames, memory, mine, taps, progress);
    if (fault_ == "cycles") ++result.cycles;
    return result;
  }

 private:
  void turn_over(const Frame& frame, ExternalMemory& memory) const {
    const auto side = static_cast<uint64_t>(config_.window);
    const Raster& raster = frame.raster;
    uint64_t x = 66, y = 3;
    const bool there = x < raster.width && y < raster.height && x / side >= raster.windows.first_x &&
                       x / side <= raster.windows.last_x && y / side >= raster.windows.first_y &&
                       y / side <= raster.windows.last_y;
    if (!there) x = raster.windows.first_x * side, y = raster.windows.first_y * side;
    const int region = region_at(config_, static_cast<int>(x % side / 8), static_cast<int>(y % side / 8));
    const int row = static_cast<int>(y % 8), bit = ru_pixel_bit(config_, row, static_cast<int>(x % 8));
    memory.line(ru_pixel_line(config_, frame, x / side, y / side, region, row))[static_cast<size_t>(bit / 32)] ^= 1u
                                                                                                                  << 9;
  }

  const Config config_;
  std::unique_ptr<RtlModel> machine_;
  const std::string_view fault_;
};

}  // namespace

std::unique_ptr<RtlModel> true_rtl(const Config& config, const RtlVariant& variant) asm(
    "__real__ZN6pipegs8load_rtlERKNS_6ConfigERKNS_10RtlVariantE");
std::unique_ptr<RtlModel> faulty_rtl(const Config& config, const RtlVariant& variant) asm(
    "__wrap__ZN6pipegs8load_rtlERKNS_6ConfigERKNS_10RtlVariantE");

std::unique_ptr<RtlModel> faulty_rtl(const Config& config, const RtlVariant& variant) {
  const char *fault = std::getenv("PIPEGS_FAULT"), *library = std::getenv("PIPEGS_LIBRTL");
  if (library != nullptr) return open_rtl(library, config);
  RtlVariant built = variant;  // as few machines as possible
  built.gates.clear();
  built.asserts = variant.asserts || config == Config{};
  return std::make_unique<FaultyMachine>(config, true_rtl(config, built), fault == nullptr ? "" : fault);
}

}  // namespace pipegs
