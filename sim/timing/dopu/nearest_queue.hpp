// SPDX-License-Identifier: Apache-2.0
// nearest_queue.hpp: nodes that wait in the DOPU by bucket of depth, in the timing model.
//
// RTL     rtl/dopu/nearest/dopu_bucket.sv: an insert in two cycles, a pop in three.
#pragma once

#include <array>
#include <bit>
#include <vector>

#include "sim/timing/cycle.hpp"

namespace pipegs::timing {

// A cell, group or chunk that passed: its bucket, and its number in the trace (cells_ranked, groups_ranked,
// chunks_sent).
struct NearestNode {
  uint16_t bucket = 0;
  uint32_t number = 0;
};

class NearestQueue {
 public:
  static constexpr int kLists = 6, kMost = 1 << 12;  // buckets of a list

  explicit NearestQueue(int nodes) : nodes_(nodes), chains_(kLists * kMost) {}

  bool idle() const { return state_ == kIdle; }
  bool full(Cycle now) const { return fresh_ == nodes_ && !back_.valid(now); }
  bool crowded() const { return taken_ >= nodes_ / 4 * 3; }
  bool some(int list) const { return words_[static_cast<size_t>(list)] != 0; }
  int first(int list) const {  // only if there is some
    const auto l = static_cast<size_t>(list);
    const int word = std::countr_zero(words_[l]);
    return 64 * word + std::countr_zero(occupied_[l][static_cast<size_t>(word)]);
  }

  // The node that comes out in this cycle, from list().
  bool out() const { return state_ == kOut; }
  int list() const { return list_; }
  const NearestNode& node() const { return node_; }
  Cycle next(Cycle now) const { return fresh_ == nodes_ && back_.head_from() > now ? back_.head_from() : kNever; }

  // A cycle: a node to insert (or null), or a list to pop from (or -1); only when idle. Tells whether anything changed.
  bool step(Cycle now, int list, const NearestNode* insert, int pop) {
    switch (state_) {
      case kInsert: state_ = kIdle; return true;
      case kFetch: state_ = kOut; return true;
      case kOut: {
        state_ = kIdle;
        std::vector<NearestNode>& chain = this->chain(list_, node_.bucket);
        chain.pop_back();
        if (chain.empty()) clear(list_, node_.bucket);
        back_.push(now, 0);
        --taken_;
        return true;
      }
      case kIdle: break;
    }
    if (pop >= 0) {
      list_ = pop;
      node_ = chain(pop, first(pop)).back();
      state_ = kFetch;
    } else if (insert != nullptr) {
      chain(list, insert->bucket).push_back(*insert);
      occupied_[static_cast<size_t>(list)][insert->bucket / 64] |= uint64_t{1} << (insert->bucket % 64);
      words_[static_cast<size_t>(list)] |= uint64_t{1} << (insert->bucket / 64);
      if (back_.valid(now)) {
        back_.pop(now);
      } else {
        ++fresh_;
      }
      ++taken_;
      state_ = kInsert;
    } else {
      return false;
    }
    return true;
  }

 private:
  enum State { kIdle, kInsert, kFetch, kOut };

  std::vector<NearestNode>& chain(int list, int bucket) { return chains_[static_cast<size_t>(list * kMost + bucket)]; }
  void clear(int list, int bucket) {
    uint64_t& word = occupied_[static_cast<size_t>(list)][static_cast<size_t>(bucket / 64)];
    word &= ~(uint64_t{1} << (bucket % 64));
    if (word == 0) words_[static_cast<size_t>(list)] &= ~(uint64_t{1} << (bucket / 64));
  }

  const int nodes_;
  std::vector<std::vector<NearestNode>> chains_;  // newest last
  std::array<std::array<uint64_t, kMost / 64>, kLists> occupied_{};
  std::array<uint64_t, kLists> words_{};  // of occupied_ that are not zero
  State state_ = kIdle;
  int list_ = 0, fresh_ = 0, taken_ = 0;
  NearestNode node_;
  SramQueue<uint8_t, 4096> back_;  // places given back
};

}  // namespace pipegs::timing
