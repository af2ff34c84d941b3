// SPDX-License-Identifier: Apache-2.0
// lists.cpp: see lists.hpp.
#include "sim/timing/list/lists.hpp"

#include "cpp_model/list/list_write.hpp"
#include "sim/timing/machine.hpp"

namespace pipegs::timing {

Lists::Lists(const Machine& m)
    : units_(m.units),
      port_(m.memory.list_port()),
      windows_(m.trace.windows.size()),
      log_(list_log(m.config, area_lines(m.config, m.overflow.lines, Area::kLists), windows_)),
      lists_(windows_),
      reader_(1, m.overflow.first, Config::list_jobs(), Config::list_lines()) {}

void Lists::step(Machine& m, Cycle now) {
  const bool granted = m.memory.granted(port_, now), answered = m.memory.answered(port_);
  moved_ = granted || answered;
  if (!written_) {
    write(m, now, granted);
  } else {
    read(m, now, granted, answered);
  }
  if (moved_) m.wheel.wake(unit(kLists), now + 1);
}

// --- pipegs_list_write -----------------------------------------------------------------------------------------------

void Lists::write(Machine& m, Cycle now, bool granted) {
  const bool clearing = now <= static_cast<Cycle>(windows_);  // the counts, one per cycle from the first on
  if (ended_ == (uint32_t{1} << units_) - 1 && !clearing && !held_valid_ && !out_valid_) {
    written_ = moved_ = true;
    state_ = kCount;
    return;
  }
  const bool move = held_valid_ && (!out_valid_ || granted);
  if (granted) out_valid_ = false;
  uint32_t data = 0, ends = 0;
  for (int k = 0; k < units_; ++k) {
    const Pu& pu = m.pu[static_cast<size_t>(k)];
    if (pu.made_shown(now)) (is_end(pu.made()) ? ends : data) |= uint32_t{1} << k;
  }
  const bool take = data != 0 && !clearing && (!held_valid_ || move);
  const int source = source_.port(data);
  source_.clock(data, take);
  if (move) {
    const size_t number = m.trace.number[held_.beat];
    m.memory.ask(port_, list_line(m.config, m.overflow, windows_, number, lists_[number].size()), true);
    lists_[number].push_back(held_);
    out_valid_ = true;
    held_valid_ = false;
    moved_ = true;
  }
  if (take) {
    held_ = m.pu[static_cast<size_t>(source)].take_made(m, now);
    held_valid_ = moved_ = true;
  }
  for (int k = 0; k < units_; ++k) {
    if ((ends >> k & 1) == 0) continue;
    m.pu[static_cast<size_t>(k)].take_made(m, now);
    ended_ |= uint32_t{1} << k;
    moved_ = true;
  }
  if (clearing) m.wheel.wake(unit(kLists), static_cast<Cycle>(windows_) + 1);
}

// --- pipegs_list_read ------------------------------------------------------------------------------------------------

void Lists::taken(Machine& m, int lane) {
  taken_ |= uint32_t{1} << lane;
  m.wheel.wake_now(unit(kLists));
}

void Lists::read(Machine& m, Cycle now, bool granted, bool answered) {
  // Jobs.
  decltype(reader_)::Job job;
  bool take = false, leave = state_ == kCount;
  if (state_ == kLines || state_ == kEnd) {
    const auto count = static_cast<uint32_t>(lists_[number_].size());
    const bool wanted = state_ == kEnd || count != 0;
    take = wanted && reader_.room_before_job(now);
    leave = take || !wanted;
    const auto first = static_cast<uint32_t>(list_first(number_, log_));
    if (take) job = {state_ == kLines, first, state_ == kLines ? count : 0, {number_}};
  }

  // Dealing.
  uint32_t ready = 0;
  for (int k = 0; k < units_; ++k) ready |= uint32_t{m.su[static_cast<size_t>(k)].ready(now)} << k;
  const bool free = (waiting_ & ~ready) == 0;
  const bool item = reader_.item_shown(now), data = item && reader_.job().read;
  uint32_t request = ready & ~waiting_;
  if (request != 0 || !item || !free) none_from_ = kNever;
  else if (none_from_ == kNever) none_from_ = now;
  if (request == 0 && item && free && now - none_from_ >= kNobody) request = (uint32_t{1} << units_) - 1;
  if (none_from_ != kNever) m.wheel.wake(unit(kLists), none_from_ + kNobody);
  const bool give = item && free && (!data || request != 0);
  const int target = target_.port(request);
  const bool wake = granted || answered || leave || give || (waiting_ & ready) != 0;
  if (wake || now - woken_ <= kPatience) target_.clock(request, give);  // else the clock stands
  if (wake) woken_ = now, moved_ = true;
  waiting_ &= ~taken_;
  taken_ = 0;
  if (give) {
    none_from_ = kNever;
    out_ = {};
    out_.beat = kWindowEndBeat;
    waiting_ = (uint32_t{1} << units_) - 1;
    if (data) {
      out_ = lists_[reader_.job().tag.window][reader_.item()];
      waiting_ = uint32_t{1} << target;
    }
    reader_.pop_item(now);
    for (int k = 0; k < units_; ++k) m.wheel.wake(unit(kSu, k), now + 1);
  }

  if (leave) {
    switch (state_) {
      case kIdle: break;
      case kCount: state_ = kLines; break;
      case kLines: state_ = kEnd; break;
      case kEnd: state_ = ++number_ == windows_ ? kIdle : kCount; break;
    }
  }
  if (reader_.step(now, granted, answered, take ? &job : nullptr)) moved_ = true;
  if (reader_.wants()) m.memory.ask(port_, reader_.line(), false, reader_.lines());
  m.wheel.wake(unit(kLists), reader_.next(now));
  m.wheel.wake(unit(kLists), reader_.item_from(now));
}

}  // namespace pipegs::timing
