// SPDX-License-Identifier: Apache-2.0
// nearest.cpp: see nearest.hpp.
#include "sim/timing/dopu/nearest.hpp"

#include <algorithm>

#include "cpp_model/dopu/nearest/dopu_depth.hpp"

namespace pipegs::timing {

// What the parts say in a cycle, from the registers as it began.
struct Nearest::Said {
  std::array<bool, kLevels> held{}, live{}, direct{}, retired{}, through{}, level_done{};
  bool full = false, any_live = false, insert = false;
  int insert_level = 0;
  int pop = -1;
  // dopu_send
  bool done = false, end_due = false, mark_due = false, pop_send = false, load_direct = false, load_popped = false;
  int lowest = 0;
};

Nearest::Nearest(const TimingTrace& trace, const Config& config)
    : trace_(trace),
      mark_chunks_(static_cast<uint32_t>(config.mark_chunks)),
      since_most_((uint32_t{1} << (clog2(config.mark_chunks + 1) + 7)) - 1),
      near_step_(dopu_depth_near(trace.config, trace.frame)),
      mark_shift_(config.depth_w - config.step_w()),
      load_(trace.config, trace.frame.walk_most, wanted_eyes(trace.config, trace.frame).size() > 1),
      load_cycles_((1 << trace.config.load_w()) / kLoadWord + 4),
      test_cycles_(trace.config.lod ? 14 : 13),
      queue_(std::make_unique<NearestQueue>(config.nearest_nodes)),
      none_((1 << trace.config.bucket_w()) - 1),
      open_{Open(trace.frame.tables.groups, none_), Open(trace.frame.tables.chunks, none_)} {}

void Nearest::step(DopuCycle& cycle, DopuSets& sets) {
  const Cycle now = cycle.now;
  const Said is = look(cycle, sets);
  if (!queue_->idle() || is.pop >= 0 || is.end_due || is.retired[0] || is.retired[1] || is.retired[2] ||
      is.through[0] || is.through[1] || is.through[2])
    cycle.moved = cycle.changed = true;

  // dopu_load
  const bool counted = is.through[1] && sets[static_cast<size_t>(set_[1])].judges, read = judge_at_ == now;
  cycle.judged = many_groups_ || read || (counted && load_.fits());
  cycle.split = many_groups_ || (read && load_.verdict() != Load::kWhole);
  if (counted) judge_at_ = now + (load_.overfull() ? 5 + *load_.overfull() / kLoadWord : load_cycles_);
  enter(cycle, sets, is);
  if (cycle.judged) load_.clear(), many_groups_ = false, judge_at_ = kNever, cycle.changed = true;
  cycle.at(judge_at_);
  if (send(cycle, sets, is)) cycle.changed = true;

  // The queue, and the nodes that are opened.
  const NearestNode inserted = is.insert ? held_[static_cast<size_t>(is.insert_level)].front().node : NearestNode{};
  const int insert_list = list(is.insert_level, set_[static_cast<size_t>(is.insert_level)]);
  if (is.insert && is.insert_level == 2) ++waiting_[static_cast<size_t>(set_[2])];
  if (queue_->out() && queue_->list() >= 4) --waiting_[static_cast<size_t>(queue_->list() & 1)];
  open(cycle, sets, is);
  for (size_t l = 0; l < kLevels; ++l) {
    if (is.retired[l]) held_[l].pop(now), --reserved_[l], cycle.changed = true;
  }
  if (queue_->step(now, insert_list, is.insert ? &inserted : nullptr, is.pop)) cycle.changed = true;

  // Levels that are through with a set.
  const int sent = send_set_;
  if (is.end_due) send_set_ ^= 1, cycle.changed = true;
  for (size_t l = 0; l < kLevels; ++l) {
    if (is.end_due) complete_[l][static_cast<size_t>(sent)] = false;
    if (!is.through[l]) continue;
    if (l == 0) cells_in_ = false;
    cycle.changed = true;
    complete_[l][static_cast<size_t>(set_[l])] = true;
    set_[l] ^= 1;
  }
  if (!in_test_.empty()) cycle.at(in_test_.front().due);
  cycle.at(queue_->next(now));
}

Nearest::Said Nearest::look(const DopuCycle& cycle, const DopuSets& sets) {
  const Cycle now = cycle.now;
  Said is;
  const int set1 = set_[1], set2 = set_[2];
  for (size_t l = 0; l < kLevels; ++l) {
    is.level_done[l] = sets[static_cast<size_t>(set_[l])].done;
    is.held[l] = held_[l].valid(now);
    is.live[l] = is.held[l] && held_[l].front().pass && !is.level_done[l];
    is.any_live = is.any_live || is.live[l];
  }
  const bool idle = queue_->idle(), crowded = queue_->crowded();
  is.full = queue_->full(now);
  std::array<bool, kLevels> some{};
  std::array<int, kLevels> first{};
  for (int l = 0; l < kLevels; ++l) {
    const int at = list(l, l == 0 ? set1 : set2);
    some[static_cast<size_t>(l)] = queue_->some(at);
    first[static_cast<size_t>(l)] = queue_->some(at) ? queue_->first(at) : none_;
  }
  is.through[0] = cells_in_ && reserved_[0] == 0;
  is.through[1] = !complete_[1][static_cast<size_t>(set1)] && complete_[0][static_cast<size_t>(set1)] && !some[0] &&
                  open_[0].buckets.empty();
  is.through[2] = !complete_[2][static_cast<size_t>(set2)] && complete_[1][static_cast<size_t>(set2)] && !some[1] &&
                  open_[1].buckets.empty();

  // dopu_send
  const auto sent = static_cast<size_t>(send_set_);
  const bool opened = complete_[2][sent];
  int unopened = none_;
  if (!complete_[0][sent]) {
    unopened = 0;
  } else {
    if (!complete_[1][sent]) {
      unopened = open_[0].nearest;
      if (some[0]) unopened = std::min(unopened, first[0]);
    }
    unopened = std::min(unopened, open_[1].nearest);
    if (some[1]) unopened = std::min(unopened, first[1]);
  }
  const int send_list = list(2, send_set_);
  const bool has_first = queue_->some(send_list), idle_send = !valid_ && !popping_;
  const int first_send = has_first ? queue_->first(send_list) : none_;
  is.done = sets[sent].done;
  is.lowest = opened ? none_ : unopened;
  if (has_first) is.lowest = std::min(is.lowest, first_send);
  is.end_due = idle_send && opened && !has_first;
  is.mark_due = idle_send && !is.done && !is.end_due &&
                since_ >= mark_chunks_ << 8 * marks_ / (Config::window_marks() + 1) &&
                marks_ != Config::window_marks() && is.lowest > mark_;
  const bool direct_chunk = is.full && idle && is.live[2] && set2 == send_set_;
  const bool chunk_due = first_send == is.lowest || (direct_chunk && first_send <= held_[2].front().node.bucket);
  is.pop_send = has_first && (is.done ? !popping_ : idle_send && !is.mark_due && chunk_due);
  is.load_direct = direct_chunk && idle_send && !is.done && !is.mark_due && !is.pop_send;
  is.load_popped = queue_->out() && queue_->list() >= 4 && !is.done;

  // Opening: the nearest cell, the nearest group.
  const bool few = waiting_[static_cast<size_t>(set2)] < Config::nearest_ahead() && !crowded;
  const bool group_first = !some[2] || first[1] <= first[2];
  const bool held_back = sets[static_cast<size_t>(set2)].judges;
  const bool cell_first =
      set1 == set2 && (!some[2] || first[0] <= first[2]) && (!some[1] || held_back || first[0] <= first[1]);
  const bool pop_cell = some[0] && (is.level_done[1] || (open_[0].room() && (!crowded || cell_first)));
  const bool pop_group = some[1] && (is.level_done[2] || (!held_back && open_[1].room() && (few || group_first)));
  is.pop = is.pop_send ? send_list : pop_group ? list(1, set2) : pop_cell ? list(0, set1) : -1;
  is.insert = is.any_live && idle && is.pop < 0 && !is.full;
  is.insert_level = is.live[2] ? 2 : is.live[1] ? 1 : 0;
  is.direct[2] = is.load_direct;
  for (size_t l = 0; l < 2; ++l)
    is.direct[l] = is.full && idle && is.pop < 0 && is.live[l] && open_[l].room() && set_[l] == set_[l + 1];
  is.direct[1] = is.direct[1] && !held_back;
  for (size_t l = 0; l < kLevels; ++l) {
    is.retired[l] =
        is.held[l] && (!is.live[l] || is.direct[l] || (is.insert && is.insert_level == static_cast<int>(l)));
  }
  return is;
}

// --- nodes to test: upper levels first -------------------------------------------------------------------------------

Nearest::Result Nearest::child(int level, uint32_t node, bool last, const DopuSets& sets) {
  const TimingWalk& walk = trace_.walks[sets[static_cast<size_t>(set_[static_cast<size_t>(level)])].walk];
  Result result{last, false, {}};
  if (level == 0) {
    const auto at = std::lower_bound(walk.cells_ranked.begin(), walk.cells_ranked.end(), node,
                                     [](const TimingParent& a, uint32_t b) { return a.node < b; });
    if (at == walk.cells_ranked.end() || at->node != node) return result;
    return {last, true, {at->bucket, static_cast<uint32_t>(at - walk.cells_ranked.begin())}, at->sides};
  }
  uint32_t& cursor = open_[static_cast<size_t>(level - 1)].cursor;
  if (level == 1) {
    while (cursor < walk.groups_ranked.size() && walk.groups_ranked[cursor].node < node) ++cursor;
    if (cursor == walk.groups_ranked.size() || walk.groups_ranked[cursor].node != node) return result;
    return {last, true, {walk.groups_ranked[cursor].bucket, cursor}, walk.groups_ranked[cursor].sides};
  }
  while (cursor < walk.first_chunk + walk.chunks && trace_.chunks_sent[cursor].chunk < node) ++cursor;
  if (cursor == walk.first_chunk + walk.chunks || trace_.chunks_sent[cursor].chunk != node) return result;
  return {last, true, {trace_.chunks_sent[cursor].bucket, cursor}, trace_.chunks_sent[cursor].sides};
}

void Nearest::enter(DopuCycle& cycle, const DopuSets& sets, const Said& is) {
  const Cycle now = cycle.now;
  const bool here =
      cycle.cell != nullptr && cycle.cell->set == set_[0] && !cells_in_ && !complete_[0][static_cast<size_t>(set_[0])];
  bool entered = false;
  const auto offer = [&](int level, uint32_t node, bool last) {  // tells whether the node leaves its giver
    const auto l = static_cast<size_t>(level);
    if (is.level_done[l] && !last) {
      cycle.moved = cycle.changed = true;
      return true;
    }
    if (entered || reserved_[l] == kResults) return false;
    cycle.moved = true;
    entered = true;  // lower levels wait
    cycle.at(now + 1);
    cycle.changed = true;
    in_test_.push(now, {now + test_cycles_, static_cast<uint8_t>(level), static_cast<uint8_t>(set_[l]),
                        child(level, node, last, sets)});
    return true;
  };
  std::array<bool, kLevels> left{};
  if (here && cycle.cell->data()) {
    left[0] = offer(0, cycle.cell->node, false);
    if (left[0] && !is.level_done[0]) ++reserved_[0];
  }
  for (int level = 1; level < kLevels; ++level) {
    Open& open = open_[static_cast<size_t>(level - 1)];
    if (!open.reader.item_shown(now)) continue;
    const Reader::Job& job = open.reader.job();
    const uint32_t item = open.reader.item();
    if (item == 0) open.cursor = job.tag.first_pass;
    const bool last = item + 1 == job.count;
    const size_t before = static_cast<size_t>(in_test_.count());
    if (!offer(level, job.first + item, last)) continue;
    if (static_cast<size_t>(in_test_.count()) != before) ++reserved_[static_cast<size_t>(level)];
    open.reader.pop_item(now);
    cycle.changed = true;
  }
  if (left[0]) cycle.cell_taken = true;
  if (here && !cycle.cell->data()) {
    cycle.cell_taken = cycle.moved = cycle.changed = true;
    if (cycle.cell->end == kWindowEndBeat) cells_in_ = true, cycle.changed = true;
  }
  // Results.
  if (!in_test_.empty() && in_test_.front().due <= now) {
    InTest& in = in_test_.front();
    const DopuSet& set = sets[in.set];
    in.result.pass = in.result.pass && passes(in.result.sides, set, in.due - test_cycles_);
    if (in.level == 1 && in.result.pass && set.judges) {
      const TimingParent& group = trace_.walks[set.walk].groups_ranked[in.result.node.number];
      load_.add(group.bucket, group.far, group.opened.count);
      many_groups_ = load_.many_groups();
    }
    if (in.result.pass || in.result.last) {
      held_[in.level].push(now, in.result);
    } else {
      --reserved_[in.level];
    }
    in_test_.pop(now);
    cycle.changed = true;
  }
}

// --- opening ---------------------------------------------------------------------------------------------------------

void Nearest::open(DopuCycle& cycle, const DopuSets& sets, const Said& is) {
  const Cycle now = cycle.now;
  for (int l = 0; l < 2; ++l) {
    Open& open = open_[static_cast<size_t>(l)];
    const size_t child_level = static_cast<size_t>(l) + 1;
    const bool settled = is.retired[child_level] && held_[child_level].front().last;
    const bool popped =
        queue_->out() && queue_->list() >> 1 == l && !sets[static_cast<size_t>(queue_->list() & 1)].done;
    const bool take = popped || is.direct[static_cast<size_t>(l)];
    // The job that waits goes to the reader.
    const bool job_goes = open.job_valid && open.reader.room_before_job(now);
    if (open.reader.step(now, cycle.granted == l, cycle.answered == l, job_goes ? &open.job : nullptr))
      cycle.changed = true;
    cycle.at(open.reader.next(now));
    if (job_goes) open.job_valid = false;
    if (settled) open.buckets.pop(now);
    if (take) {
      const int set = popped ? queue_->list() & 1 : set_[child_level];
      const NearestNode node = popped ? queue_->node() : held_[static_cast<size_t>(l)].front().node;
      const TimingWalk& walk = trace_.walks[sets[static_cast<size_t>(set)].walk];
      const TimingParent& parent = l == 0 ? walk.cells_ranked[node.number] : walk.groups_ranked[node.number];
      open.job = {true, parent.opened.first, parent.opened.count, {parent.first}};
      open.job_valid = true;
      open.buckets.push(now, node.bucket);
    }
    if (!settled && !take) continue;
    cycle.changed = true;
    open.nearest = none_;
    for (int i = 0; i < open.buckets.count(); ++i) open.nearest = std::min<int>(open.nearest, open.buckets.at(i));
  }
}

// --- dopu_send -------------------------------------------------------------------------------------------------------

bool Nearest::send(const DopuCycle& cycle, const DopuSets& sets, const Said& is) {
  const bool gone = valid_ && (cycle.node_taken || dropped(sets)), popped = queue_->out() && queue_->list() >= 4;
  if (popped) {
    popping_ = false;
  } else if (is.pop_send && queue_->idle()) {
    popping_ = true;
  }
  shown_ = valid_ && !gone;
  if (gone) valid_ = false;
  if (!is.load_popped && !is.load_direct && !is.mark_due && !is.end_due) return gone;
  valid_ = true;
  out_ = {};
  out_.set = static_cast<uint8_t>(send_set_);
  if (is.end_due) {
    out_.end = kWindowEndBeat;
    out_.last = sets[out_.set].walk + 1 == trace_.walks.size();
    since_ = 0, mark_ = 0, marks_ = 0;
  } else if (is.mark_due) {
    out_.end = kLayerEndBeat;
    out_.mark = static_cast<uint32_t>(near_step_ + is.lowest) << mark_shift_;
    since_ = 0, mark_ = is.lowest, ++marks_;
  } else {
    const uint32_t number = is.load_popped ? queue_->node().number : held_[2].front().node.number;
    out_.chunk = &trace_.chunks_sent[number];
    out_.node = out_.chunk->chunk;
    since_ = std::min(since_ + 1, since_most_);
  }
  return true;
}

}  // namespace pipegs::timing
