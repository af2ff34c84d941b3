// dopu.cpp: see dopu.hpp.
#include "sim/timing/dopu.hpp"

#include <algorithm>
#include <bit>

#include "cpp_model/dopu/dopu_axis.hpp"
#include "cpp_model/dopu/dopu_layer.hpp"
#include "sim/timing/machine.hpp"

namespace pipegs::timing {
namespace {

constexpr int kQuietCycles = 127;
constexpr Cycle kTestCycles = 12, kOriginCycles = 9, kShiftCycles = 4, kPlanesCycles = 53;

bool bit(const std::vector<uint64_t>& bits, uint32_t at) { return (bits[at / 64] >> (at % 64) & 1) != 0; }

}  // namespace

Dopu::Dopu(const Machine& m)
    : units_(m.units), grid_(m.config.grid), axis_(dopu_axis(m.frame)), windows_(m.trace.windows.size()), groups_(2, m.frame.groups),
      chunks_(2, m.frame.chunks), table_line_(m.frame.cells) {
  table_left_ = table_coming_ = (grid_ * grid_ * grid_ + 1) / 2;
  const int camera = dopu_layer_camera(m.config, m.frame, axis_);
  for (int step = 0; step < 2 * grid_; ++step) slabs_[static_cast<size_t>(step)] = dopu_layer_step(m.config, camera, step);
}

const ChunkBeat& Dopu::take_chunk(Machine& m, int lane) {
  emit_taken_ |= uint32_t{1} << lane;
  m.wheel.wake_now(unit(kDopu));
  return emit_chunk_;
}

uint32_t Dopu::ready_pus(const Machine& m, Cycle now) const {
  uint32_t ready = 0;
  for (int k = 0; k < units_; ++k) ready |= uint32_t{m.pu[static_cast<size_t>(k)].chunk_room(now)} << k;
  return ready;
}

void Dopu::step(Machine& m, Cycle now) {
  if (!busy_) return;
  // Cycles since the last step: nothing moved in them, so the clock may have stopped.
  if (stepped_ >= 0) {
    int quiet = acted_ ? 0 : std::min(quiet_ + 1, kQuietCycles);  // of the next cycle
    const Cycle between = now - stepped_ - 1;
    if (level_) {
      quiet = between > 0 ? 0 : quiet;
    } else {
      frozen_ += std::max<Cycle>(0, between - (kQuietCycles - quiet));
      quiet = static_cast<int>(std::min<Cycle>(kQuietCycles, quiet + between));
    }
    quiet_ = quiet;
  }
  stepped_ = now;
  moved_ = woken_ = changed_ = false;
  origin_taken_ = window_sent_ = cell_taken_ = window_walked_ = false;

  const bool phase = (now - frozen_) % 3 == 2;
  emit(m, now);
  origin(now);
  test(m, now, phase);
  read(m, now);
  cells(m, now);
  windows(m, now);
  ask(m);

  acted_ = moved_ || woken_ || level_ || now == 0;
  if (!acted_ && quiet_ == kQuietCycles) ++frozen_;  // this cycle's edge does not come
  if (last_sent_ && emit_valid_ == 0) busy_ = false;

  // What comes by itself.
  Cycle next = changed_ || moved_ ? now + 1 : kNever;
  const auto at = [&](bool when, Cycle cycle) { if (when) next = std::min(next, std::max(cycle, now + 1)); };
  at(!in_test_.empty(), in_test_.empty() ? 0 : in_test_.front().due);
  at(multiplying_, multiplied_at_);
  at(shifting_, shifted_at_);
  at(planes_ == kPlanesBusy, planes_at_);
  at(now < 2 + m.config.focal_w(), 2 + m.config.focal_w());
  m.wheel.wake(unit(kDopu), next);
}

// --- dopu_emit ------------------------------------------------------------------------------------------------------------

void Dopu::emit(Machine& m, Cycle now) {
  const bool held = emit_valid_ != 0, standing = shifting_ && shifted_at_ <= now;
  level_ = false;
  if (emit_taken_ != 0) {
    emit_valid_ &= ~emit_taken_;
    emit_taken_ = 0;
    changed_ = true;
    woken_ = true;
  }
  if (!held && !standing) return;
  const uint32_t ready = ready_pus(m, now);
  if (ready != 0) woken_ = true;  // blocked && chunk_ready
  level_ = ready != 0;
  if (held || !standing || (shifted_.data() && ready == 0)) return;
  // The chunk, or the end, moves to the output.
  moved_ = origin_taken_ = true;
  emit_chunk_ = {};
  if (shifted_.data()) {
    const TimingNode& node = m.trace.chunks[shifted_.node];
    emit_chunk_ = {0, node.first, node.count, shifted_.chunk->first, shifted_.chunk->survivors};
    emit_last_ = round_robin(ready, emit_last_);
    emit_valid_ = uint32_t{1} << emit_last_;
    had_chunk_ = true;
  } else {
    emit_chunk_.end = shifted_.end;
    const bool drop = shifted_.end == kLayerEndBeat && !had_chunk_;
    emit_valid_ = drop ? 0 : (uint32_t{1} << units_) - 1;
    had_chunk_ = false;
    if (shifted_.last) last_sent_ = true;
  }
  emit_from_ = now + 1;
  level_ = false;
  for (int k = 0; k < units_; ++k) m.wheel.wake(unit(kReader, k), now + 1);
}

// --- dopu_origin ------------------------------------------------------------------------------------------------------------

void Dopu::origin(Cycle now) {
  const bool was_multiplying = multiplying_;
  if (multiplying_ && now >= multiplied_at_ && (!shifting_ || origin_taken_)) {
    shifting_ = true;
    shifted_ = multiplied_;
    shifted_at_ = now + (shifted_.data() ? kShiftCycles : 1);
    multiplying_ = false;
    changed_ = true;
  } else if (origin_taken_) {
    shifting_ = false;
    changed_ = true;
  }
  FallQueue<Item, kResults>& kept = results_[2];
  if (!kept.valid(now)) return;
  if (drops(kept.front())) {
    kept.pop(now);
    --reserved_[2];
    changed_ = true;
    return;
  }
  if (was_multiplying) return;
  multiplying_ = true;
  multiplied_ = kept.front();
  multiplied_at_ = now + (multiplied_.data() ? kOriginCycles : 1);
  window_sent_ = multiplied_.end == kWindowEndBeat;
  kept.pop(now);
  --reserved_[2];
  moved_ = true;
}

// --- dopu_descend: the test ---------------------------------------------------------------------------------------------------

bool Dopu::passes(const Machine& m, int level, Item& item) {
  if (!item.data()) return true;
  Set& set = sets_[item.set];
  const TimingWindow& window = m.trace.windows[set.window];
  if (level == 0) return bit(window.cells, item.node);
  if (level == 1) return bit(window.groups, item.node);
  if (set.chunk == window.first_chunk + window.chunks) return false;
  const TimingChunk& chunk = m.trace.chunks_sent[set.chunk];
  if (chunk.chunk != item.node) return false;
  item.chunk = &chunk;
  ++set.chunk;
  return true;
}

void Dopu::test(Machine& m, Cycle now, bool phase) {
  // Results, seen in the queues from the next cycle on; places that become free count from then, too.
  std::array<int, kLevels> freed{};
  freed[2] = 0;
  InTest result;
  bool has_result = false;
  if (!in_test_.empty() && in_test_.front().due <= now) {
    result = in_test_.front();
    in_test_.pop(now);
    has_result = true;
  }
  // Who wants to enter: upper levels first. reserved_[2] was lowered by origin() in this cycle: that counts from the next on.
  const int freed_now = results_[2].last_pop() == now ? 1 : 0;
  bool entered = false;
  for (int level = 0; level < kLevels; ++level) {
    Reader& reader = level == 1 ? groups_ : chunks_;
    if (level == 0 ? !(item_valid_ && item_shown_) : !reader.item_shown(now)) continue;
    Item item;
    if (level == 0) {
      item = item_;
    } else {
      const Reader::Job& job = reader.job();
      item.end = job.tag.end;
      item.set = job.tag.set;
      item.last = job.tag.last;
      item.node = job.first + reader.item();
    }
    const bool drop = drops(item);
    bool enter = false;
    if (drop) {
      moved_ = true;
    } else if (!entered && reserved_[static_cast<size_t>(level)] + (level == 2 ? freed_now : 0) != kResults) {
      moved_ = true;
      entered = true;  // lower levels wait
      enter = phase;
    }
    if (enter) {
      InTest in{now + kTestCycles, item, static_cast<uint8_t>(level), false};
      in.pass = passes(m, level, in.item);
      in_test_.push(now, in);
      ++reserved_[static_cast<size_t>(level)];
    }
    if (!enter && !drop) continue;
    if (level == 0) {
      cell_taken_ = true;
    } else {
      reader.pop_item(now);
    }
  }
  if (has_result) {
    changed_ = true;
    if (result.pass) {
      results_[result.level].push(now, result.item);
    } else {
      --reserved_[result.level];
    }
  }
}

// --- dopu_descend: the readers; the memory port ---------------------------------------------------------------------------------

void Dopu::read(Machine& m, Cycle now) {
  const int port = m.memory.node_port();
  const bool granted = m.memory.granted(port, now), answered = m.memory.answered(port);
  if (granted || answered) woken_ = true;
  int granted_to = -1, answered_to = -1;
  if (granted) {
    granted_to = port_last_ = port_shown_;
    port_locked_ = false;
    if (granted_to == 2) {
      ++table_line_;
      --table_left_;
    } else {
      asked_.push(now, static_cast<uint8_t>(granted_to));
    }
  }
  if (answered) {
    if (table_coming_ > 0) {
      answered_to = 2;
      --table_coming_;
    } else {
      answered_to = asked_.front();
      asked_.pop(now);
    }
    changed_ = true;
  }
  for (int l = 0; l < 2; ++l) {
    Reader& reader = l == 0 ? groups_ : chunks_;
    FallQueue<Item, kResults>& kept = results_[static_cast<size_t>(l)];
    Reader::Job job;
    bool take = false;
    if (kept.valid(now)) {
      const Item& parent = kept.front();
      const bool drop = drops(parent);
      if (!drop && reader.room_before_job(now)) {
        const TimingNode& node = parent.data() ? (l == 0 ? m.trace.cells : m.trace.groups)[parent.node] : TimingNode{};
        job = {parent.data(), node.first, node.count, {parent.end, parent.set, parent.last}};
        take = true;
      }
      if (drop || take) {
        kept.pop(now);
        --reserved_[static_cast<size_t>(l)];
        changed_ = true;
      }
    }
    if (reader.step(now, granted_to == l, answered_to == l, take ? &job : nullptr)) changed_ = true;
    if (reader.next(now) < kNever) changed_ = true;
  }
}

void Dopu::ask(Machine& m) {
  const uint32_t requests = uint32_t{groups_.wants()} | uint32_t{chunks_.wants()} << 1 | uint32_t{table_left_ > 0} << 2;
  if (requests == 0) {
    port_locked_ = false;
    return;
  }
  if (!port_locked_ || (requests >> port_shown_ & 1) == 0) port_shown_ = round_robin(requests, port_last_);
  port_locked_ = true;
  m.memory.ask(m.memory.node_port(), port_shown_ == 2 ? table_line_ : port_shown_ == 1 ? chunks_.line() : groups_.line());
}

// --- dopu_cells -------------------------------------------------------------------------------------------------------------------

void Dopu::cells(const Machine& m, Cycle now) {
  const Set& set = sets_[walk_set_];
  const bool advance = !item_valid_ || !item_shown_ || cell_taken_;
  if (advance && item_valid_) item_valid_ = false, changed_ = true;
  // An answer of this cycle counts from the next one on.
  const bool loading = table_coming_ > 0 || (m.memory.answered(m.memory.node_port()) && table_coming_ == 0 && asked_.last_pop() != now);
  if (!walking_ || loading || now < 2 + m.config.focal_w() || !set.fresh) return;
  const bool done = set_done(walk_set_);
  const bool inside = walk_step_ < 2 * grid_ && slabs_[static_cast<size_t>(walk_step_)] >= 0;
  if (advance || !inside) moved_ = true;
  const bool read = advance && (inside || done);
  const bool is_end = end_next_ || done, window_end = walk_layer_ == grid_ - 1 || done;
  const bool finished = read && is_end && window_end;
  if (read) {
    item_valid_ = true;
    item_ = {};
    item_.set = walk_set_;
    if (is_end) {
      item_.end = window_end ? kWindowEndBeat : kLayerEndBeat;
      item_.last = window_end && set.last;
      item_shown_ = true;
    } else {
      item_.node = static_cast<uint32_t>(dopu_layer_cell(m.config, axis_, slabs_[static_cast<size_t>(walk_step_)], walk_number_));
      item_shown_ = m.trace.cells[item_.node].count != 0;
    }
  }
  if (finished) {
    window_walked_ = true;
    if (set.last) walking_ = false;
    walk_step_ = walk_layer_ = walk_number_ = 0;
    end_next_ = false;
  } else if (!inside) {
    ++walk_step_;
  } else if (read && end_next_) {
    ++walk_step_;
    ++walk_layer_;
    end_next_ = false;
  } else if (read) {
    end_next_ = walk_number_ == grid_ * grid_ - 1;
    walk_number_ = end_next_ ? 0 : walk_number_ + 1;
  }
}

// --- dopu_windows -----------------------------------------------------------------------------------------------------------------

void Dopu::windows(const Machine& m, Cycle now) {
  // done of the next cycle; the sets as they were when this one began.
  for (size_t s = 0; s < 2; ++s) {
    bool done = sets_[s].valid;
    for (const Ru& ru : m.ru) done = done && ru.window() == sets_[s].window && ru.done() == ru.own();
    if (done != done_[s]) woken_ = changed_ = true;
    done_next_[s] = done;
  }
  if (planes_ == kPlanesBusy && now >= planes_at_) planes_ = kPlanesReady;
  if (planes_ == kPlanesReady && !sets_[fill_].valid) {
    Set& set = sets_[fill_];
    set.valid = set.fresh = true;
    set.window = next_window_;
    set.chunk = m.trace.windows[next_window_].first_chunk;
    set.last = ++next_window_ == windows_;
    fill_ ^= 1;
    planes_ = kPlanesIdle;
    planes_at_ = now + 1;
    changed_ = true;
  } else if (planes_ == kPlanesIdle && now >= planes_at_ && next_window_ < windows_) {
    planes_ = kPlanesBusy;
    planes_at_ = now + kPlanesCycles;
  }
  if (window_walked_) {
    sets_[walk_set_].fresh = false;
    walk_set_ ^= 1;
    changed_ = true;
  }
  if (window_sent_) {
    sets_[oldest_].valid = false;
    oldest_ ^= 1;
    changed_ = true;
  }
  done_ = done_next_;
}

}  // namespace pipegs::timing
