// SPDX-License-Identifier: Apache-2.0
// su_external.cpp: the merge sort of a set that a Sorting Unit brought to memory, up to a mark: see su.hpp.
//
// RTL     rtl/su/sort/: su_runs, su_levels, su_ways, su_tree, su_lines.
// Idea    Lines of memory are only counted: the keys of a run are kept beside its ways and nodes.
#include <algorithm>

#include "sim/timing/machine.hpp"

namespace pipegs::timing {

void Su::external(Cycle now, const Now& is) {
  External& e = external_;
  if (is.spilled || is.spill_start) moved_ = true;
  // What the parts say, from the registers as the cycle began.
  const bool line = answers_.valid(now) && owners_.front() != kRecordLine;
  const bool forms = e.level == kForm, list = lists(), written = e.written(), merged = e.tree == kTreeIdle;
  const bool setup = e.level == kSetup, start = e.level == kStart;
  const bool formed = e.form == kLoad && closed() && e.seen == records_out_.size() && e.pool.empty() && !e.refill;
  keep_keys(is, start);
  if (list) {
    form_runs(now, is, line, written);
  } else {
    const int way = e.rising.way;
    const bool release = rise(is);
    ask_ways(now, line, setup);
    if (release) --e.ways[static_cast<size_t>(way)].held, --e.ways[static_cast<size_t>(way)].ready;
    if (start) {
      e.tree = kLook;
      e.seeding = true;
      e.nodes_filled = 0;
      e.seed = e.rising.way = e.rising.place = 0;
    }
  }
  merge_levels(is, forms ? formed : merged && (e.last || written));
  if (is.spill_start || is.again) {
    e.asked = e.seen = e.formed = e.rest = 0;
    e.from = is.again ? is.mark_bucket : 0;
    e.refill = is.again && !is.stay;
  }
  if (is.spill_start || is.stay) {
    e.level = kForm;
    const auto keys = static_cast<uint32_t>(records_ / kKeysPerLine * kKeysPerLine);
    e.lines = (keys + static_cast<uint32_t>(config_.su_run_keys()) - 1) / static_cast<uint32_t>(config_.su_run_keys());
    e.area = true;
    e.last = false;
    e.lines_number = 0;
    e.merged.clear();
  }
}

// --- su_lines --------------------------------------------------------------------------------------------------------

void Su::keep_keys(const Now& is, bool merges) {
  External& e = external_;
  if (run_taken_) e.lines_full = false, ++e.lines_number;
  if (is.kept) {
    e.merged.back().push_back(kept_);
    ++e.lines_place;
    if (e.lines_place == config_.su_run_keys() || e.lines_left == 1) e.lines_full = true, e.lines_place = 0;
    --e.lines_left;
  }
  if (e.level == kForm ? e.form == kGroupGoes : merges && !e.last) {
    e.lines_left = e.level == kForm ? static_cast<uint32_t>(e.pool.size()) : e.sum;
    e.merged.emplace_back();
  }
}

// --- su_runs ---------------------------------------------------------------------------------------------------------

bool Su::fetches(Cycle now) const {
  const External& e = external_;
  if (!lists()) return e.asking;
  const auto count = static_cast<uint32_t>(records_out_.size());
  const bool begins = marks_cut_ ? closed() && (marks_.valid(now) || e.refill) : open();
  return begins && e.form != kReturn && e.asked < (closed() ? count + kKeysPerLine - 1 : count) / kKeysPerLine;
}

void Su::form_runs(Cycle now, const Now& is, bool line, bool written) {
  External& e = external_;
  const auto count = static_cast<uint32_t>(records_out_.size());
  if (fetch_taken_) ++e.asked;
  switch (e.form) {
    case kLoad: {
      const bool full = e.pool.size() == static_cast<size_t>(records_ / kKeysPerLine * kKeysPerLine);
      const bool through = closed() && e.seen == count, some = !e.pool.empty();
      if (line && !full) {
        const Sorted& record = records_out_[e.seen];
        const uint32_t bucket = marks_cut_ ? bucket_of(record.key) : 0;
        if (!marks_cut_ || (bucket >= e.from && (e.refill || is.mark_all || bucket < is.mark_bucket)))
          e.pool.push_back(record), stored_at_ = now;
        else if (bucket >= e.from) ++e.rest;
        ++e.seen;
        if (e.seen % kKeysPerLine == 0 || (closed() && e.seen == count))
          answers_.pop(now), owners_.pop_front(), line_used_ = true;
      }
      if (e.refill && through) {
        if (is.drained) e.form = kReturn;
      } else if (some && (full || through)) {
        e.form = kGroupGoes;
      }
      break;
    }
    case kGroupGoes: {
      order_.clear();
      for (const Sorted& record : e.pool) order_.push_back({record, kNil, false});
      const auto [nearest, farthest] = std::minmax_element(
          e.pool.begin(), e.pool.end(), [](const Sorted& a, const Sorted& b) { return a.key < b.key; });
      begin_split(now, nearest->key, farthest->key);
      e.formed += static_cast<uint32_t>(e.pool.size());
      e.form = kSortRun;
      break;
    }
    case kSortRun:
      if (written) e.form = kLoad, e.pool.clear();
      break;
    case kReturn:
      if (is.item_goes) e.pool.pop_front();
      if (is.returned) e.form = kLoad;
      break;
  }
}

// --- su_ways ---------------------------------------------------------------------------------------------------------

void Su::ask_ways(Cycle now, bool line, bool setup) {
  External& e = external_;
  const auto run_keys = static_cast<uint32_t>(config_.su_run_keys());
  uint32_t wants = 0;
  for (size_t i = 0; i < e.ways.size(); ++i)
    if (e.ways[i].more && e.ways[i].held != config_.su_way_lines()) wants |= 1u << i;
  if (e.asking) {
    if (fetch_taken_) {
      Way& way = e.ways[static_cast<size_t>(e.asked_way)];
      ++way.line;
      ++way.held;
      way.more = way.unasked > run_keys;
      way.unasked -= std::min(way.unasked, run_keys);
      e.asking = false;
    }
  } else if (!setup && wants != 0) {
    e.asked_way = round_robin(wants, e.asked_way);
    e.asking = true;
  }
  if (!line) return;
  stored_at_ = now;
  if (++e.place < config_.su_run_keys()) return;
  e.place = 0;
  ++e.ways[static_cast<size_t>(owners_.front())].ready;
  answers_.pop(now), owners_.pop_front(), line_used_ = true;
}

// --- su_tree ---------------------------------------------------------------------------------------------------------

// Tells whether a line of the way that was at the top is used up.
bool Su::rise(const Now& is) {
  External& e = external_;
  Node& rising = e.rising;
  bool release = false;
  switch (e.tree) {
    case kTreeIdle: break;
    case kLook: e.tree = kTake; break;
    case kTake: {
      Way& way = e.ways[static_cast<size_t>(rising.way)];
      const bool wraps = !e.seeding && rising.place == config_.su_run_keys() - 1;
      const bool ended = way.left == (e.seeding ? 0u : 1u);
      const bool take = e.item() && is.item_goes;
      const bool fetch = !ended && !e.fetched && way.ready > (wraps && !e.taken ? 1 : 0);
      const bool leaves = (e.seeding || e.taken || take) && (ended || e.fetched || fetch);
      release = take && (wraps || ended);
      if (take) e.taken = true;
      if (fetch) e.fetched = true;
      if (!leaves) break;
      e.taken = e.fetched = false;
      if (!e.seeding) --way.left;
      rising.none = ended;
      rising.place = e.seeding || wraps ? 0 : rising.place + 1;
      if (!ended) rising.item = way.keys[way.keys.size() - way.left];
      e.node = ((1 << e.levels) | rising.way) >> 1;
      e.tree = kCompare;
      break;
    }
    case kCompare: {
      const bool filled = (e.nodes_filled >> e.node & 1) != 0;
      Node& node = e.nodes[static_cast<size_t>(e.node)];
      const bool top = e.node == 1;
      if (!filled) {
        node = rising;
        e.nodes_filled |= 1u << e.node;
        rising.way = ++e.seed;
        rising.place = 0;
        e.tree = kLook;
        break;
      }
      if (rising.none ? !node.none : !node.none && node.item.key < rising.item.key) std::swap(node, rising);
      e.node >>= 1;
      if (!top) break;
      e.seeding = false;
      e.tree = rising.none ? kTreeIdle : kLook;
      break;
    }
  }
  return release;
}

// --- su_levels -------------------------------------------------------------------------------------------------------

// done: all keys are in runs, or the merge is.
void Su::merge_levels(const Now& is, bool done) {
  External& e = external_;
  const uint32_t count = e.formed;
  const auto most = static_cast<uint32_t>(config_.su_ways());
  switch (e.level) {
    case kForm:
      if (!done) break;
      e.runs = std::move(e.merged);
      e.merged.clear();
      e.next_run = 0;
      e.next_line = 0;
      if (count == 0) e.last = true;
      e.level = count == 0 ? kSent : kSize;
      break;
    case kSize: {
      const auto runs = static_cast<uint32_t>(e.runs.size() - e.next_run);
      const uint32_t merges = static_cast<uint32_t>(e.merged.size()), all = runs + merges;
      e.last = all <= most;
      e.way = 0;
      e.sum = 0;
      e.merged_line = 0;
      e.next_merged = 0;
      if (e.merged.empty()) e.lines_number = 0;
      if (!e.last && runs == 0) {
        e.runs = std::move(e.merged);
        e.merged.clear();
        e.next_run = 0;
        e.next_line = 0;
        e.lines = e.merged_lines;
        e.area = !e.area;
        break;
      }
      e.ways_used = e.last ? all : std::min({runs, most, all - (most - 1)});
      e.merges = e.last ? merges : 0;
      e.levels = std::max(1, clog2(static_cast<int>(e.ways_used)));
      e.level = kSetup;
      break;
    }
    case kSetup: {
      Way& way = e.ways[static_cast<size_t>(e.way)];
      const auto number = static_cast<uint32_t>(e.way);
      const bool merged = number < e.merges, used = number < e.ways_used;
      way.keys = merged ? std::move(e.merged[e.next_merged++])
                 : used ? std::move(e.runs[e.next_run++])
                        : std::vector<Sorted>{};
      way.area = e.area != merged;
      way.line = merged ? e.merged_line : e.next_line;
      way.unasked = way.left = static_cast<uint32_t>(way.keys.size());
      way.more = way.left != 0;
      way.held = way.ready = 0;
      e.sum += way.left;
      if (merged) e.merged_line += e.merged_lines;
      if (used && !merged) e.next_line += e.lines;
      if (++e.way == 1 << e.levels) e.level = kStart;
      break;
    }
    case kStart: e.level = kMerge; break;
    case kMerge:
      if (!done) break;
      if (e.merged.size() == 1) e.merged_lines = e.lines_number;
      e.level = e.last ? kSent : kSize;
      break;
    case kSent:
      if (is.spill_end) e.level = kForm;
      break;
  }
}

}  // namespace pipegs::timing
