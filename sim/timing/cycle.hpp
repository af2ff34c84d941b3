// SPDX-License-Identifier: Apache-2.0
// cycle.hpp: time, and the two kinds of places in which a beat waits: an output register and a queue.
//
// Idea    The model keeps the machine's registers, not its wires. In a cycle every unit sees the registers as they were
//         when the cycle began; units are stepped from the image back to the scene (enum Unit of machine.hpp), so that
//         a taker has emptied an output register before its owner looks whether it is free: the chain of ready signals
//         of one cycle. A beat carries the cycle from which it can be seen.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>

namespace pipegs::timing {

using std::size_t;

using Cycle = int64_t;  // of the machine's clock; 0 is the restart of the frame

inline constexpr Cycle kLongAgo = -1000;
inline constexpr Cycle kNever = int64_t{1} << 60;

// A Gaussian of the trace, or an end, with its kind in the low bits. Below the ends: number of a survivor of the cull,
// see TimingTrace.
using Beat = uint32_t;
inline constexpr Beat kBubble = 0xfffffffc, kLayerEndBeat = 0xfffffffd, kWindowEndBeat = 0xfffffffe;
inline constexpr Beat kPartEndBeat = 0xffffffff;
inline bool is_end(Beat beat) { return beat > kBubble; }
inline uint64_t end_kind(Beat beat) { return beat - kBubble; }

// An output register: valid until the taker clears it; seen from `from` on.
template <class T>
struct Output {
  bool valid = false;
  Cycle from = 0;
  T value{};

  bool shown(Cycle now) const { return valid && from <= now; }
  void set(Cycle when, const T& what) { valid = true, from = when, value = what; }
};

// A queue of at most `depth` beats: `Latency` cycles from a push to the output, then one beat per cycle. Whether there
// is room is a register: a place that is freed in a cycle can be used in the next one.
template <class T, int Capacity, int Latency>
class Queue {
 public:
  explicit Queue(int depth = Capacity) : depth_(depth) {
    if (depth > Capacity) throw std::logic_error("timing model: a queue deeper than its array");
  }

  bool room(Cycle now, int beats = 1) const { return count_ + (last_pop_ == now ? 1 : 0) + beats <= depth_; }
  bool valid(Cycle now) const { return count_ > 0 && head_from_ <= now; }
  bool empty() const { return count_ == 0; }
  int count() const { return count_; }
  Cycle head_from() const { return count_ > 0 ? head_from_ : kNever; }  // when the head can be seen
  T& front() { return items_[head_]; }
  const T& front() const { return items_[head_]; }
  const T& at(int i) const { return items_[(head_ + static_cast<unsigned>(i)) & kMask]; }
  Cycle last_pop() const { return last_pop_; }

  void push(Cycle now, T item) {
    const unsigned at = (head_ + static_cast<unsigned>(count_)) & kMask;
    items_[at] = std::move(item);
    pushed_[at] = now;
    if (count_++ == 0) head_from_ = now + Latency > last_pop_ + 1 ? now + Latency : last_pop_ + 1;
  }
  void pop(Cycle now) {
    head_ = (head_ + 1) & kMask;
    --count_;
    last_pop_ = now;
    if (count_ > 0) head_from_ = pushed_[head_] + Latency > now + 1 ? pushed_[head_] + Latency : now + 1;
  }

 private:
  static constexpr unsigned kMask = std::bit_ceil(static_cast<unsigned>(Capacity)) - 1;
  std::array<T, kMask + 1> items_{};
  std::array<Cycle, kMask + 1> pushed_{};
  unsigned head_ = 0;
  int count_ = 0, depth_;
  Cycle head_from_ = kNever, last_pop_ = kLongAgo;
};

template <class T, int Capacity>
using SramQueue = Queue<T, Capacity, 2>;  // rtl/buf/pipegs_sram_fifo.sv
template <class T, int Capacity>
using FallQueue = Queue<T, Capacity, 1>;  // rtl/lib/pipegs_fifo.sv

// Who acts when: one bit per unit in each of the next cycles. Waking a unit for nothing does no harm.
class Wheel {
 public:
  static constexpr int kSlots = 256, kWords = 3;

  void wake(int unit, Cycle when) {  // in the next cycle at the earliest
    if (when >= kNever) return;
    if (when <= now_) when = now_ + 1;
    if (when > now_ + kSlots - 1) when = now_ + kSlots - 1;  // the unit will ask again
    slots_[static_cast<size_t>(when) & (kSlots - 1)][static_cast<size_t>(unit >> 6)] |= uint64_t{1} << (unit & 63);
  }
  // Only for a unit that comes later in this cycle.
  void wake_now(int unit) {
    slots_[static_cast<size_t>(now_) & (kSlots - 1)][static_cast<size_t>(unit >> 6)] |= uint64_t{1} << (unit & 63);
  }

  Cycle now() const { return now_; }
  void next_cycle() { ++now_; }
  uint64_t& word(int i) { return slots_[static_cast<size_t>(now_) & (kSlots - 1)][static_cast<size_t>(i)]; }

 private:
  Cycle now_ = 0;
  std::array<std::array<uint64_t, kWords>, kSlots> slots_{};
};

// Round robin: the lowest bit of `requests` above `last`, else the lowest. `requests` is not zero.
inline int round_robin(uint64_t requests, int last) {
  const uint64_t above = requests & ~((uint64_t{2} << last) - 1);
  return std::countr_zero(above != 0 ? above : requests);
}

// What it has shown and nobody has used stays, as in rtl/lib/pipegs_arbiter.sv.
class Arbiter {
 public:
  int port(uint64_t requests) const {
    if (requests == 0) return 0;
    return locked_ && (requests >> shown_ & 1) != 0 ? shown_ : round_robin(requests, last_);
  }
  void clock(uint64_t requests, bool advance) {
    shown_ = port(requests);
    if (requests != 0 && advance) last_ = shown_;
    locked_ = requests != 0 && !advance;
  }

 private:
  int last_ = 0, shown_ = 0;
  bool locked_ = false;
};

}  // namespace pipegs::timing
