// SPDX-License-Identifier: Apache-2.0
// descend.cpp: see descend.hpp.
#include "sim/timing/dopu/descend.hpp"

namespace pipegs::timing {
namespace {

bool bit(const std::vector<uint64_t>& bits, uint32_t at) { return (bits[at / 64] >> (at % 64) & 1) != 0; }

}  // namespace

const DopuItem* Descend::shown(Cycle now, const DopuSets& sets) {
  FallQueue<DopuItem, kResults>& kept = results_[2];
  return kept.valid(now) && (shown_ || !drops(kept.front(), sets)) ? &kept.front() : nullptr;
}

void Descend::step(DopuCycle& cycle, DopuSets& sets) {
  FallQueue<DopuItem, kResults>& kept = results_[2];
  const bool shows = shown(cycle.now, sets) != nullptr;
  const bool leaves = kept.valid(cycle.now) && (cycle.node_taken || !shows);
  shown_ = shows && !cycle.node_taken;
  if (leaves) {
    kept.pop(cycle.now);
    --reserved_[2];
    cycle.changed = true;
  }
  test(cycle, sets);
  read(cycle, sets);
  if (!in_test_.empty()) cycle.at(in_test_.front().due);
}

bool Descend::passes(int level, DopuItem& item, DopuSets& sets) const {
  if (!item.data()) return true;
  DopuSet& set = sets[item.set];
  const TimingWalk& walk = trace_.walks[set.walk];
  if (level == 0) return bit(walk.cells, item.node);
  if (level == 1) return bit(walk.groups, item.node);
  if (set.chunk == walk.first_chunk + walk.chunks) return false;
  const TimingChunk& chunk = trace_.chunks_sent[set.chunk];
  if (chunk.chunk != item.node) return false;
  item.chunk = &chunk;
  ++set.chunk;
  return true;
}

void Descend::test(DopuCycle& cycle, DopuSets& sets) {
  const Cycle now = cycle.now;
  // Results, seen in the queues from the next cycle on; places that become free count from then, too.
  InTest result;
  bool has_result = false;
  if (!in_test_.empty() && in_test_.front().due <= now) {
    result = in_test_.front();
    in_test_.pop(now);
    has_result = true;
  }
  // Who wants to enter: upper levels first. reserved_[2] was lowered in this cycle: that counts from the next on.
  const int freed_now = results_[2].last_pop() == now ? 1 : 0;
  bool entered = false;
  for (int level = 0; level < kLevels; ++level) {
    DopuItem item;
    if (level == 0) {
      if (cycle.cell == nullptr) continue;
      item = *cycle.cell;
    } else {
      const Reader& reader = readers_[static_cast<size_t>(level - 1)];
      if (!reader.item_shown(now)) continue;
      const Reader::Job& job = reader.job();
      item.end = job.tag.end;
      item.set = job.tag.set;
      item.last = job.tag.last;
      item.node = job.first + reader.item();
    }
    const bool drop = drops(item, sets);
    bool enter = false;
    if (drop) {
      cycle.moved = cycle.changed = true;
    } else if (!entered && reserved_[static_cast<size_t>(level)] + (level == 2 ? freed_now : 0) != kResults) {
      cycle.moved = true;
      entered = true;  // lower levels wait
      enter = cycle.phase == 2;
      if (enter) cycle.changed = true;
      cycle.at(now + (enter ? 3 : 2 - cycle.phase));
    }
    if (enter) {
      InTest in{now + kTestCycles, item, static_cast<uint8_t>(level), false};
      in.pass = passes(level, in.item, sets);
      in_test_.push(now, in);
      ++reserved_[static_cast<size_t>(level)];
    }
    if (!enter && !drop) continue;
    if (level == 0) {
      cycle.cell_taken = true;
    } else {
      readers_[static_cast<size_t>(level - 1)].pop_item(now);
    }
  }
  if (!has_result) return;
  cycle.changed = true;
  if (result.pass) {
    results_[result.level].push(now, result.item);
  } else {
    --reserved_[result.level];
  }
}

void Descend::read(DopuCycle& cycle, const DopuSets& sets) {
  for (int l = 0; l < 2; ++l) {
    Reader& reader = readers_[static_cast<size_t>(l)];
    FallQueue<DopuItem, kResults>& kept = results_[static_cast<size_t>(l)];
    Reader::Job job;
    bool take = false;
    if (kept.valid(cycle.now)) {
      const DopuItem& parent = kept.front();
      const bool drop = drops(parent, sets);
      if (!drop && reader.room_before_job(cycle.now)) {
        const TimingNode& node = parent.data() ? (l == 0 ? trace_.cells : trace_.groups)[parent.node] : TimingNode{};
        job = {parent.data(), node.first, node.count, {parent.end, parent.set, parent.last}};
        take = true;
      }
      if (drop || take) {
        kept.pop(cycle.now);
        --reserved_[static_cast<size_t>(l)];
        cycle.changed = true;
      }
    }
    if (reader.step(cycle.now, cycle.granted == l, cycle.answered == l, take ? &job : nullptr)) cycle.changed = true;
    cycle.at(reader.next(cycle.now));
  }
}

}  // namespace pipegs::timing
