// SPDX-License-Identifier: Apache-2.0
// ru.cpp: see ru.hpp.
#include "sim/timing/ru/ru.hpp"

#include <algorithm>
#include <bit>

#include "cpp_model/ru/ru_raster.hpp"
#include "cpp_model/ru/ru_resolve.hpp"
#include "cpp_model/ru/ru_walk.hpp"
#include "sim/timing/machine.hpp"

namespace pipegs::timing {

Ru::Ru(const Machine& m, int lane)
    : queue(m.config.ru_queue()),
      lane_(lane),
      port_(m.memory.raster_port(lane)),
      late_(!m.config.caches_alphas()),
      quads_(m.config.quads != 0),
      stores_(m.config.has_stores()),
      fetch_lines_(m.config.fetch_lines),
      parts_(m.config.alpha_memory_lines()),
      records_(m.config.ru_records()),
      external_(m.config.fetch_lines),
      rows_(m.config.pixels_per_row),
      own_(ru_own_mask(m.config, lane)) {
  for (size_t part = 0; part < static_cast<size_t>(m.config.parts()); ++part) owned_.mask[part] = own_;
  set_window(m, 0);
  if (quads_) drain_.start(0, owned_, true, 0, 0);
}

void Ru::set_window(const Machine& m, size_t window) {
  window_ = window;
  outside_ = window < m.trace.windows.size() ? m.trace.windows[window].outside : RegionSet{};
  blended_ = {};
  done_ = owned_ & outside_;
  if (quads_) live_.start_window(m.config, window < m.trace.windows.size() ? &m.trace.windows[window] : nullptr);
}

void Ru::publish(Machine& m, Cycle now) {
  bool news = false;
  while (!done_coming_.empty() && done_coming_.front().from <= now) {
    blended_.add(m.config, done_coming_.front().region);
    done_coming_.pop(now);
    done_ = blended_;
    done_ |= outside_;
    done_ = done_ & owned_;
    news = true;
  }
  if (window_coming_ && window_done_at_ < now) {
    window_coming_ = false;
    set_window(m, window_ + 1);
    news = true;
    if (quads_) m.wheel.wake(unit(kPublish), now + 1);
  }
  if (quads_) {
    live_.publish(m.config, now);
    // In the first cycle of a window nothing is known to be done.
    const RegionSet done = now == window_done_at_ + 1 ? RegionSet{} : owned_ & live_.stopped();
    news = news || done != done_;
    done_ = done;
  }
  if (!news) return;
  m.wheel.wake_now(unit(late_ ? kSource : kWalk, lane_));
  m.wheel.wake_now(unit(kDopu));
}

// --- ru_lanes --------------------------------------------------------------------------------------------------------

void Ru::lanes(Machine& m, Cycle now) {
  if (start_ < kNever) {
    if (now < start_ + 3) return m.wheel.wake(unit(kLanes, lane_), start_ + 3);
    consume(m, now);
  }
  for (;;) {
    Cycle from;
    Beat beat;
    if (late_) {
      from = row_lines_.head_from();
      if (from >= kNever) return;
      beat = row_lines_.front().end ? row_lines_.front().beat : 0;
    } else {
      from = records_.head_from();
      if (from >= kNever) return;
      const Record& head = records_.front();
      beat = head.beat;
      if (!is_end(beat)) from = std::max(from, head.ext ? external_.head_from() : local_.head_from());
      if (from >= kNever) return;
    }
    if (!is_end(beat)) {
      start_ = std::max(from, now);
      return m.wheel.wake(unit(kLanes, lane_), start_ + 3);
    }
    const Cycle when = std::max(from, last_issue_ + 4);
    if (when > now) return m.wheel.wake(unit(kLanes, lane_), when);
    if (beat == kWindowEndBeat && (lines_left_ > 0 || resolved_from_ > now)) return;  // ru_resolve wakes us
    end(m, now, beat);
  }
}

// Lanes without work get some: a line is played in its last cycle, what may have to wait from its first one on.
void Ru::queued(Machine& m, Cycle from, bool line) {
  if (line) start_ = from;
  m.wheel.wake(unit(kLanes, lane_), line ? from + 3 : from);
}

// The last quarter of the line in the lanes.
void Ru::consume(Machine& m, Cycle now) {
  uint8_t region;
  if (late_) {
    region = row_lines_.front().region;
    row_lines_.pop(now);
  } else {
    const Record record = records_.front();
    region = record.region;
    records_.pop(now);
    if (record.ext) {
      external_.pop(now);
      --external_out_;
      external_pop_ = now;
    } else {
      local_.pop(now);
      --local_out_;
      local_pop_ = now;
    }
  }
  m.show(now, Border::kLine, lane_, shown_line(region, 0));
  m.wheel.wake(unit(kSource, lane_), now + 1);
  last_issue_ = now;
  start_ = kNever;
  if (++lines_[region] == m.trace.windows[window_].done_after[region]) {
    done_coming_.push(now, {now + 4, region});
    m.wheel.wake(unit(kPublish), now + 4);
  }
}

void Ru::end(Machine& m, Cycle now, Beat beat) {
  if (!quads_) late_ ? row_lines_.pop(now) : records_.pop(now);
  m.wheel.wake(unit(kSource, lane_), now + 1);
  m.layer_free.done(m, now, lane_);
  if (beat != kWindowEndBeat) return;
  window_done_at_ = now;
  window_coming_ = true;
  lines_.fill(0);
  if (!quads_) m.wheel.wake_now(unit(late_ ? kSource : kWalk, lane_));
  m.wheel.wake(unit(late_ ? kSource : kWalk, lane_), now + 1);
  if (quads_) return drain_.start(now, owned_ & ~unwritten(m), false, window_, rows_written(m, window_));
  // ru_resolve starts.
  regions_left_ = owned_ & ~unwritten(m);
  window_written_ = window_;
  lines_left_ = 0;
  for (size_t part = 0; part < regions_left_.mask.size(); ++part) {
    for (uint64_t rest = regions_left_.mask[part]; rest != 0; rest &= rest - 1)
      lines_left_ += requests(m, window_, region_number(m.config, part, std::countr_zero(rest)), 0, 8);
  }
  line_ = 0;
  line_from_ = now + 2;
  if (lines_left_ > 0) m.wheel.wake(unit(kRuMemory, joined(m) ? lane_ & ~1 : lane_), line_from_);
}

// --- ru_fetch, or the Row Units --------------------------------------------------------------------------------------

bool Ru::read(Machine& m, Cycle now, uint64_t line) {
  if (memory_valid_ && !m.memory.granted(port_, now)) return false;
  memory_valid_ = true;
  read_at_ = now;
  m.memory.ask(port_, line);
  return true;
}

void Ru::source(Machine& m, Cycle now) {
  if (m.memory.granted(port_, now)) m.wheel.wake_now(unit(kRuMemory, lane_));
  if (quads_) return live_source(m, now);
  if (late_) return rows_source(m, now);
  if (m.memory.answered(port_)) {
    answer_part_ = !answer_part_;
    if (parts_ == 1 || !answer_part_) {
      external_.push(now, 0);
      m.wheel.wake(unit(kLanes, lane_), external_.head_from());
    }
  }
  if (!out_.shown(now)) return;
  const Fetch& fetch = out_.value;
  if (fetch.skip) return m.stores.want(m, fetch.unit, lane_);
  if (!records_.room(now)) return;
  if (is_end(fetch.beat)) return fire(m, now);
  if (!fetch.ext) {
    if (local_out_ + (local_pop_ == now ? 1 : 0) < Config::ru_local_lines()) m.stores.want(m, fetch.unit, lane_);
    return;
  }
  if (external_out_ + (external_pop_ == now ? 1 : 0) >= fetch_lines_) return;
  const uint64_t line = ru_overflow_line(m.config, m.overflow, fetch.unit, fetch.address) + (ask_part_ ? 1 : 0);
  if (!read(m, now, line)) return;
  if (parts_ == 1 || ask_part_) fire(m, now);
  if (parts_ == 2) ask_part_ = !ask_part_;
}

void Ru::fire(Machine& m, Cycle now) {
  const Fetch& fetch = out_.value;
  const bool data = !is_end(fetch.beat), local = data && !fetch.ext;
  if (local) m.pu[fetch.unit].line_free(m, now);
  if (!fetch.skip) {
    records_.push(now, {fetch.beat, fetch.region, data && fetch.ext});
    if (data) ++(fetch.ext ? external_out_ : local_out_);
    if (local) local_.push(now, 0);
    if (records_.count() == 1) queued(m, std::max(records_.head_from(), local ? local_.head_from() : 0), local);
  }
  out_.valid = false;
  m.wheel.wake_now(unit(kWalk, lane_));
}

void Ru::next_splat(Machine& m, Cycle now) {
  splat_valid_ = queue.valid(now);
  if (!splat_valid_) return;
  splat_ = queue.front();
  queue.pop(now);
  rest_ = splat_.mask & own_;
  m.wheel.wake(unit(kOrder), now + 1);
}

bool Ru::joined(const Machine& m) { return m.trace.picture.format != 0 && m.units > 1; }

Ru& Ru::other(Machine& m) const { return m.ru[static_cast<size_t>(lane_ ^ 1)]; }

// Asked for by both RUs of a pair: the first one to ask is stepped first, or neither is.
const Ru::Seen& Ru::seen(Cycle now) {
  if (seen_.at == now) return seen_;
  seen_ = {.at = now, .at_end = false, .wanted = {}};
  if (!splat_valid_) return seen_;
  seen_.at_end = splat_.beat == kWindowEndBeat && live_.idle(now) && drain_.held() == RegionSet{};
  if (!is_end(splat_.beat)) seen_.wanted.mask[splat_.part] = rest_;
  return seen_;
}

// Of two regions side by side the left one is outside when both are.
RegionSet Ru::unwritten(const Machine& m) const {
  constexpr uint64_t kLeft = 0x5555555555555555;
  RegionSet result = outside_;
  for (uint64_t& mask : result.mask) {
    if (joined(m)) mask = (mask & kLeft) | (mask & kLeft) << 1;
  }
  return result;
}

// ru_live.
void Ru::live_source(Machine& m, Cycle now) {
  const bool data = !is_end(splat_.beat), empty = live_.idle(now), known = now != window_done_at_ + 1;
  const uint64_t held = drain_.held().mask[splat_.part];
  bool job = false, at_end = false;
  if (drain_.active() || !data || joined(m)) {
    RegionSet wanted = seen(now).wanted;
    at_end = seen(now).at_end;
    if (joined(m)) {
      constexpr uint64_t kLeft = 0x5555555555555555;
      const Seen& beside = other(m).seen(now);
      at_end = at_end && beside.at_end;
      for (size_t i = 0; i < wanted.mask.size(); ++i)
        wanted.mask[i] |= (beside.wanted.mask[i] & kLeft) << 1 | (beside.wanted.mask[i] >> 1 & kLeft);
    }
    job = drain_.step(m.config, now, wanted);
    if (job) last_job_ = now;
    if (!drain_.words.empty()) m.wheel.wake(unit(kRuMemory, lane_), drain_.words.head_from());
  }
  live_.step(m, now, lane_, job);
  bool leave = false;
  if (splat_valid_ && !data) {
    leave = splat_.beat == kWindowEndBeat ? at_end : empty;
    if (leave) end(m, now, splat_.beat);
  } else if (splat_valid_ && known) {
    const uint64_t open = rest_ & ~done_.mask[splat_.part], free = open & ~held;
    const uint64_t lowest = free & -free;
    if (free != 0 && live_.moved()) {
      const int bit = std::countr_zero(free);
      const uint64_t mask = m.trace.mask[splat_.beat], below = mask & ((uint64_t{1} << bit) - 1);
      live_.pick(region_number(m.config, splat_.part, bit),
                 m.trace.quads[m.trace.quads_first[splat_.beat] + static_cast<size_t>(std::popcount(below))]);
      rest_ &= ~lowest;
    }
    leave = open == lowest && (live_.moved() || open == 0);
  }
  if (!splat_valid_ || leave) next_splat(m, now);
  if (splat_valid_ || drain_.active() || !live_.idle(now + 1)) m.wheel.wake(unit(kSource, lane_), now + 1);
  if (!splat_valid_) m.wheel.wake(unit(kSource, lane_), queue.head_from());
}

void Ru::rows_source(Machine& m, Cycle now) {
  if (rows_.shown(now) && row_lines_.room(now)) {
    row_lines_.push(now, rows_.head());
    rows_.take(now);
    if (row_lines_.count() == 1) queued(m, row_lines_.head_from(), !row_lines_.front().end);
  }
  const bool data = !is_end(splat_.beat);
  const uint64_t regions = live();
  const bool drop = splat_valid_ && data && regions == 0;
  RowJob job;
  job.beat = splat_.beat;
  job.mask = regions;
  const bool taken = rows_.step(now, splat_valid_ && !drop ? &job : nullptr);
  if (taken && splat_.beat == kWindowEndBeat) ++ends_;
  if (window_done_at_ == now) --ends_;
  if (!splat_valid_ || drop || taken) next_splat(m, now);
  m.wheel.wake(unit(kSource, lane_), rows_.next(now));
  if (rows_.head_from() > now) m.wheel.wake(unit(kSource, lane_), rows_.head_from());
  if (splat_valid_ ? rows_.can_load() || (!is_end(splat_.beat) && live() == 0) : !queue.empty()) {
    m.wheel.wake(unit(kSource, lane_), splat_valid_ ? now + 1 : queue.head_from());
  }
}

// --- ru_memory and ru_resolve ----------------------------------------------------------------------------------------

// Rows of pixels of a window that are written: in raster order those inside the picture, else all.
int Ru::rows_written(const Machine& m, size_t window) const {
  if (m.trace.picture.format == 0) return m.config.window;
  const Windows& windows = m.frame.raster.windows;
  const uint64_t y = windows.first_y + window / (windows.last_x - windows.first_x + 1);
  return static_cast<int>(std::min(static_cast<uint64_t>(m.config.window),
                                   m.frame.raster.height - y * static_cast<uint64_t>(m.config.window)));
}

// Requests that write some rows of a region.
int Ru::requests(const Machine& m, size_t window, int region, int first_row, int rows) const {
  if (m.trace.picture.format == 0) return m.config.region_lines() * rows / 8;
  return std::clamp(rows_written(m, window) - 8 * region_y(m.config, region) - first_row, 0, rows);
}

// A line of pixels of a region to memory, or a row of them in raster order.
void Ru::write(Machine& m, size_t window, int region, uint64_t line) {
  memory_valid_ = true;
  const uint64_t columns =
      (m.frame.raster.width + static_cast<uint64_t>(m.config.window) - 1) / static_cast<uint64_t>(m.config.window);
  const uint64_t row_windows = m.frame.raster.windows.last_x - m.frame.raster.windows.first_x + 1;
  const uint64_t window_x = m.frame.raster.windows.first_x + window % row_windows,
                 window_y = m.frame.raster.windows.first_y + window / row_windows,
                 side = static_cast<uint64_t>(m.config.window);
  if (m.trace.picture.format != 0) {
    const uint64_t x = window_x * side + 8 * static_cast<uint64_t>(region_x(m.config, region)),
                   y = window_y * side + 8 * static_cast<uint64_t>(region_y(m.config, region)) + line;
    const bool wide = joined(m) && (x | 8) < m.frame.raster.width;
    return m.memory.ask(port_, ru_raster_line(m.trace.picture, x, y), true, 1, wide ? 3 : 1 << ru_raster_half(x));
  }
  const uint64_t number = window_y * columns + window_x;
  const uint64_t place = number * static_cast<uint64_t>(m.config.regions()) + static_cast<uint64_t>(region);
  m.memory.ask(port_, m.frame.tables.pixels + place * static_cast<uint64_t>(m.config.region_lines()) + line, true);
}

// With quads: the words that ru_drain has brought.
void Ru::drained(Machine& m, Cycle now) {
  if (!drain_.words.valid(now)) return m.wheel.wake(unit(kRuMemory, lane_), drain_.words.head_from());
  const Drain::Word word = drain_.words.front();
  const auto whole = static_cast<uint64_t>(m.trace.picture.format != 0 ? 2 : m.config.region_lines() / 4);  // of a word
  write(m, word.window, word.region, static_cast<uint64_t>(word.row) * whole + line_);
  if (++line_ < static_cast<uint64_t>(requests(m, word.window, word.region, 2 * word.row, 2))) return;
  line_ = 0;
  drain_.words.pop(now);
  if (joined(m)) other(m).drain_.words.pop(now);
}

void Ru::memory(Machine& m, Cycle now) {
  if (read_at_ == now) return;
  if (m.memory.granted(port_, now)) memory_valid_ = false;
  if (memory_valid_ || (joined(m) && lane_ % 2 != 0)) return;
  if (quads_) return drained(m, now);
  if (lines_left_ == 0 || (joined(m) && other(m).lines_left_ == 0)) return;
  const Cycle from = joined(m) ? std::max(line_from_, other(m).line_from_) : line_from_;
  if (now < from) return m.wheel.wake(unit(kRuMemory, lane_), from);
  size_t part = 0;
  while (regions_left_.mask[part] == 0) ++part;
  write(m, window_written_, region_number(m.config, part, std::countr_zero(regions_left_.mask[part])), line_);
  written_line(m, now);
  if (joined(m)) other(m).written_line(m, now);
}

// ru_resolve goes on to its next line.
void Ru::written_line(Machine& m, Cycle now) {
  size_t part = 0;
  while (regions_left_.mask[part] == 0) ++part;
  uint64_t& left = regions_left_.mask[part];
  const int region = region_number(m.config, part, std::countr_zero(left));
  if (++line_ == static_cast<uint64_t>(requests(m, window_written_, region, 0, 8))) line_ = 0, left &= left - 1;
  if (--lines_left_ == 0) {
    resolved_from_ = now + 1;
    m.wheel.wake(unit(kLanes, lane_), now + 1);
  }
}

// --- ru_walk ---------------------------------------------------------------------------------------------------------

void Ru::walk(Machine& m, Cycle now) {
  const bool out_free = !out_.valid, pick_free = !pick_valid_ || out_free, data = !is_end(splat_.beat);
  const uint64_t regions = walked(), others = regions & (regions - 1);
  const bool emit = splat_valid_ && (!data || regions != 0) && pick_free;
  const bool leave = splat_valid_ && (data ? regions == 0 || (others == 0 && pick_free) : pick_free);
  if (out_free && pick_valid_) {
    out_.set(now + 1, pick_);
    m.wheel.wake(unit(kSource, lane_), now + 1);
  }
  if (pick_free) pick_valid_ = emit;
  if (emit) {
    const int region = data ? std::countr_zero(regions) : 0;
    pick_ = {splat_.beat,
             static_cast<uint8_t>(region),
             splat_.unit,
             splat_.ext,
             data && (live() >> region & 1) == 0,
             splat_.address + static_cast<uint32_t>(std::popcount(splat_.mask & ((uint64_t{1} << region) - 1)))};
    rest_ = others;
    if (splat_.beat == kWindowEndBeat) ++ends_;
  }
  if (window_done_at_ == now) --ends_;
  if (!splat_valid_ || leave) next_splat(m, now);
  if ((pick_valid_ && !out_.valid) || (splat_valid_ && (!pick_valid_ || (!is_end(splat_.beat) && walked() == 0)))) {
    m.wheel.wake(unit(kWalk, lane_), now + 1);
  } else if (!splat_valid_) {
    m.wheel.wake(unit(kWalk, lane_), queue.head_from());
  }
}

void AlphaStores::want(Machine& m, int store, int ru) {
  wanted_[static_cast<size_t>(store)] |= uint32_t{1} << ru;
  m.wheel.wake_now(unit(kStore, store));
}

void AlphaStores::step(Machine& m, Cycle now, int store) {
  uint32_t& wanted = wanted_[static_cast<size_t>(store)];
  if (wanted == 0) return;
  const int ru = round_robin(wanted, last_[static_cast<size_t>(store)]);
  last_[static_cast<size_t>(store)] = ru;
  m.ru[static_cast<size_t>(ru)].fire(m, now);
  for (wanted &= ~(uint32_t{1} << ru); wanted != 0; wanted &= wanted - 1)
    m.wheel.wake(unit(kSource, std::countr_zero(wanted)), now + 1);
}

void LayerFree::done(Machine& m, Cycle now, int ru) {
  m.show(now, Border::kLayer, ru, 0);
  coming[static_cast<size_t>(ru)] = true;
  m.wheel.wake(unit(kPublish), now + 1);
}

void LayerFree::publish(Machine& m, Cycle now) {
  bool all = true;
  for (size_t i = 0; i < static_cast<size_t>(m.units); ++i) {
    count[i] += coming[i] ? 1 : 0;
    coming[i] = false;
    all = all && count[i] > 0;
  }
  if (!all) return;
  for (size_t i = 0; i < static_cast<size_t>(m.units); ++i) {
    --count[i];
    m.pu[i].layer_free(m, now);
  }
  m.wheel.wake(unit(kPublish), now + 1);
}

}  // namespace pipegs::timing
