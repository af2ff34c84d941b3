// SPDX-License-Identifier: Apache-2.0
// lockstep.hpp: the timing model beside the RTL, cycle by cycle: the first cycle and unit in which they part.
//
// Idea    The RTL runs and shows what crosses its units' borders (RtlTaps). The model is played up to the same cycle
//         and shows the same events (event.hpp). The first that only one of them has is kept; nothing else is.
// Rule    Needs a machine with taps.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/memory/memory_timing.hpp"
#include "sim/rtl/rtl_model.hpp"
#include "sim/timing/event.hpp"
#include "sim/timing/trace/trace.hpp"

namespace pipegs {

namespace timing {
struct Machine;
}

struct TimingDifference {
  int64_t cycle = 0;       // 0 is the restart of the frame
  std::string unit;        // "SU 2"
  std::string rtl, model;  // what each of them does: "takes the splat of key 1f03a", or "nothing"
  std::string text() const;
};

class Lockstep final : public RtlTaps {
 public:
  Lockstep(const TimingTrace& trace, const Config& config, const ExternalMemoryOptions& memory);
  ~Lockstep() override;

  bool wants_cycles() const override { return true; }
  void on_splat(int unit, const uint32_t* splat) override;
  void on_sorted(const uint32_t* sorted) override;
  void on_alphas(int lane, uint64_t window_x, uint64_t window_y, uint32_t index, int region, int quarter,
                 const uint32_t* line) override;
  void on_chunk(int unit, int kind, const uint32_t* chunk) override;
  void on_layer_done(int unit, bool window_done) override;
  void on_request(int tag, bool write, uint64_t line, int lines) override;

  // After the RTL's last cycle: plays the model to its end.
  void finish();
  const std::optional<TimingDifference>& first() const { return first_; }
  uint64_t events() const { return events_; }                                // that were alike
  const std::vector<uint64_t>& window_ends() const { return window_ends_; }  // of the RTL, as TimingResult::window_ends

 private:
  void show(timing::Border border, int lane, uint64_t what);
  void advance(int64_t cycle);  // the model plays up to and with this cycle
  void compare();               // the events of one cycle
  template <class Record>
  uint64_t beat(const uint32_t* words) const;
  void part(const timing::TimingEvent* rtl, const timing::TimingEvent* model);

  const Config config_;
  std::unique_ptr<MemoryTiming> memory_;
  std::unique_ptr<timing::Machine> machine_;
  int64_t played_ = -1;  // the model's latest cycle
  std::vector<timing::TimingEvent> rtl_, model_;
  std::optional<TimingDifference> first_;
  uint64_t events_ = 0;
  std::vector<uint64_t> window_ends_;
};

}  // namespace pipegs
