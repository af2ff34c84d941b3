// dram_channel.cpp: see dram_channel.hpp.
#include "sim/dram/dram_channel.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace pipegs {
namespace {

int log2_of(int value) { return std::bit_width(static_cast<unsigned>(value)) - 1; }
uint64_t low_bits(int count) { return count == 64 ? ~uint64_t{0} : (uint64_t{1} << count) - 1; }
void raise(DramCycle& at, DramCycle to) { at = std::max(at, to); }

}  // namespace

DramChannel::Counters& DramChannel::Counters::operator+=(const Counters& of) {
  bursts_read += of.bursts_read;
  bursts_written += of.bursts_written;
  reads_forwarded += of.reads_forwarded;
  writes_merged += of.writes_merged;
  row_hits += of.row_hits;
  row_misses += of.row_misses;
  row_conflicts += of.row_conflicts;
  activates += of.activates;
  precharges += of.precharges;
  refreshes += of.refreshes;
  wck_syncs += of.wck_syncs;
  return *this;
}

DramChannel::DramChannel(const DramTiming& timing)
    : timing_(timing),
      ranks_(timing.ranks),
      groups_(timing.ranks * timing.bank_groups),
      bank_bits_(log2_of(timing.banks)),
      rank_shift_(log2_of(timing.banks * timing.bank_groups)),
      drain_above_(static_cast<int>(std::floor(timing.write_high * timing.write_queue))),
      drain_below_(static_cast<int>(std::ceil(timing.write_low * timing.write_queue))),
      refresh_due_(timing.t_refi),
      next_(timing.t_refi),
      returns_limit_(timing.rl + timing.t_burst + timing.read_queue) {
  check_dram(timing);
  const DramTiming& t = timing_;
  const int banks = t.banks_per_channel();
  bank_.resize(banks);
  closed_ = low_bits(banks);
  ready_.fill(closed_);
  wheel_.fill(kNone);
  for (int rank = 0; rank < ranks_; ++rank) {
    rank_banks_[rank] = low_bits(banks / ranks_) << (rank << rank_shift_);
    last_activates_[rank].fill(-kNever);
  }
  for (int group = 0; group < groups_; ++group) group_banks_[group] = low_bits(t.banks) << (group << bank_bits_);
  pool_.resize(t.read_queue + t.write_queue);
  for (std::size_t i = 0; i < pool_.size(); ++i) pool_[i].next = static_cast<int16_t>(i + 1);
  return_.resize(std::bit_ceil(static_cast<unsigned>(2 * returns_limit_)));
  return_mask_ = static_cast<uint32_t>(return_.size() - 1);

  constexpr int kRead = 0, kWrite = 1;
  gap_[kRead][kRead] = {std::max(t.t_ccd_l, t.t_burst), std::max(t.t_ccd_s, t.t_burst), t.t_burst + t.t_cs};
  gap_[kWrite][kWrite] = {std::max(t.t_ccd_l, t.t_burst), std::max(t.t_ccd_s, t.t_burst), t.t_burst};
  gap_[kRead][kWrite] = {t.t_rtw, t.t_rtw, t.t_burst + t.t_cs};
  wck_after_ = {t.rl + t.t_burst + t.t_wckpst, t.wl + t.t_burst + t.t_wckpst};
  precharge_after_ = {t.t_rtp, t.wl + t.t_burst + t.t_wr};
  gap_[kWrite][kRead] = {t.wl + t.t_burst_l + t.t_wtr_l, t.wl + t.t_burst + t.t_wtr_s,
                         t.rl + t.t_burst + t.t_cs - t.wl};
}

// ---- lists of waiting bursts

inline void DramChannel::append(List& list, int16_t burst) {
  pool_[burst].next = -1;
  if (list.head < 0) {
    list.head = burst;
  } else {
    pool_[list.tail].next = burst;
  }
  list.tail = burst;
}

inline int16_t DramChannel::take_head(List& list) {
  const int16_t burst = list.head;
  list.head = pool_[burst].next;
  return burst;
}

// The list of a bank has a new head, or none.
inline void DramChannel::new_head(int bank, bool write, bool hit) {
  const Lists& lists = bank_[bank].waiting[write];
  const int16_t head = hit ? lists.hit.head : lists.miss.head;
  uint64_t& has = has_[write][hit];
  has = (has & ~bit(bank)) | uint64_t{head >= 0} << bank;
  if (head >= 0) age_[write][hit][bank] = pool_[head].order << 7 | uint64_t{hit} << 6 | static_cast<uint64_t>(bank);
}

// A burst leaves its queue.
inline void DramChannel::release(int16_t index, int bank, bool write) {
  Burst& burst = pool_[index];
  if (write) {
    --writes_;
    --write_filter_[filter_slot(static_cast<uint32_t>(bank), burst.row, burst.column)];
  } else {
    --reads_;
  }
  burst.next = free_;
  free_ = index;
}

void DramChannel::merge_into_miss(Lists& lists) {
  if (lists.hit.head < 0) return;
  List merged;
  while (lists.hit.head >= 0 && lists.miss.head >= 0) {
    const bool hit_first = pool_[lists.hit.head].order < pool_[lists.miss.head].order;
    append(merged, take_head(hit_first ? lists.hit : lists.miss));
  }
  List& rest = lists.hit.head >= 0 ? lists.hit : lists.miss;
  while (rest.head >= 0) append(merged, take_head(rest));
  lists.hit = {};
  lists.miss = merged;
}

void DramChannel::split_by_row(Lists& lists, uint32_t row) {
  List all = lists.miss;
  lists.miss = {};
  while (all.head >= 0) {
    const int16_t burst = take_head(all);
    append(pool_[burst].row == row ? lists.hit : lists.miss, burst);
  }
}

// Does a write to the same burst wait?
bool DramChannel::write_waits(const DramPlace& place) const {
  if (write_filter_[filter_slot(place.bank, place.row, place.column)] == 0) return false;
  const Lists& lists = bank_[place.bank].waiting[1];
  for (const List& list : {lists.hit, lists.miss}) {
    for (int16_t i = list.head; i >= 0; i = pool_[i].next) {
      if (pool_[i].row == place.row && pool_[i].column == place.column) return true;
    }
  }
  return false;
}

void DramChannel::accept(DramCycle now, bool write, const DramPlace& place, uint32_t tag) {
  if (write_waits(place)) {
    if (write) {
      ++counters_.writes_merged;
      return;
    }
    // Answers leave in one order, so a forwarded one waits for those before it.
    ++counters_.reads_forwarded;
    ++reads_open_;
    DramCycle when = now + 1;
    if (returns_ > 0) when = std::max(when, return_[(first_return_ + returns_ - 1) & return_mask_].when);
    return_[(first_return_ + returns_++) & return_mask_] = {when, tag};
    return;
  }
  const int16_t index = free_;
  Burst& burst = pool_[index];
  free_ = burst.next;
  burst.order = order_++;
  burst.arrived = now;
  burst.row = place.row;
  burst.column = place.column;
  burst.tag = tag;
  burst.counted = false;
  const int bank = static_cast<int>(place.bank);
  Lists& lists = bank_[bank].waiting[write];
  const bool hit = (open_ & bit(bank)) != 0 && bank_[bank].row == place.row;
  append(hit ? lists.hit : lists.miss, index);
  const bool first = (has_[write][hit] & bit(bank)) == 0;
  if (first) new_head(bank, write, hit);
  if (write) {
    ++writes_;
    ++writes_open_;
    ++write_filter_[filter_slot(place.bank, place.row, place.column)];
  } else {
    ++reads_;
    ++reads_open_;
  }
  // A burst behind others of its list changes nothing, unless it makes reads and writes change places.
  if (first || writes_ > drain_above_ || (!write && reads_ == 1)) next_ = std::min(next_, now + 1);
}

// ---- time

inline void DramChannel::schedule_wake(Kind kind, int bank, DramCycle now, DramCycle at) {
  const auto slot = static_cast<std::size_t>(std::min(at, now + kWheel - 1) & (kWheel - 1));
  const auto event = static_cast<uint8_t>(kind * 64 + bank);
  armed_[kind] |= bit(bank);
  after_[event] = wheel_[slot];
  wheel_[slot] = event;
  wheel_busy_ |= uint64_t{1} << slot;
}

// No command of this kind to this bank before `until`. Times only grow: an earlier wake renews itself.
inline void DramChannel::hold(Kind kind, int bank, DramCycle until) {
  DramCycle& at = bank_[bank].ready_at[kind];
  raise(at, until);
  if (at <= wheel_now_) return;
  ready_[kind] &= ~bit(bank);
  if ((armed_[kind] & bit(bank)) == 0) schedule_wake(kind, bank, wheel_now_, at);
}

inline void DramChannel::wake(DramCycle now) {
  const int shift = static_cast<int>((wheel_now_ + 1) & (kWheel - 1));
  const DramCycle passed = std::min<DramCycle>(now - wheel_now_, kWheel - 1);
  wheel_now_ = now;
  uint64_t due = std::rotr(wheel_busy_, shift) & low_bits(static_cast<int>(passed));
  for (; due != 0; due &= due - 1) {
    const int slot = (std::countr_zero(due) + shift) & (kWheel - 1);
    wheel_busy_ &= ~(uint64_t{1} << slot);
    for (uint8_t event = std::exchange(wheel_[slot], kNone); event != kNone;) {
      const auto kind = static_cast<Kind>(event / 64);
      const int bank = event % 64;
      event = after_[event];
      if (bank_[bank].ready_at[kind] <= now) {
        armed_[kind] &= ~bit(bank);
        ready_[kind] |= bit(bank);
      } else {
        schedule_wake(kind, bank, now, bank_[bank].ready_at[kind]);
      }
    }
  }
}

// Banks whose rank and bank group allow a command.
inline uint64_t DramChannel::allowed(DramCycle now, const Distances& distances) const {
  uint64_t banks = 0;
  for (int group = 0; group < groups_; ++group) banks |= now >= distances.group_at[group] ? group_banks_[group] : 0;
  uint64_t ranks = 0;
  for (int rank = 0; rank < ranks_; ++rank) ranks |= now >= distances.rank_at[rank] ? rank_banks_[rank] : 0;
  return banks & ranks;
}

// When ranks and bank groups allow a command to the first of these banks.
inline DramCycle DramChannel::earliest(uint64_t banks, const Distances& distances) const {
  DramCycle first = kNever;
  if (banks == 0) return first;
  for (int group = 0; group < groups_; ++group) {
    const DramCycle at = std::max(distances.group_at[group], distances.rank_at[group >> (rank_shift_ - bank_bits_)]);
    first = std::min(first, (banks & group_banks_[group]) != 0 ? at : kNever);
  }
  return first;
}

// The next cycle in which a command may become possible if no burst is accepted before.
inline DramCycle DramChannel::when_next(DramCycle now) const {
  if (half_open_ >= 0 || synced_.bank >= 0 || (refreshes_owed_ == 0 && next_mode() != draining_)) return now + 1;
  DramCycle next = refresh_due_;
  if (wheel_busy_ != 0) {
    const int shift = static_cast<int>((now + 1) & (kWheel - 1));
    next = std::min(next, now + 1 + std::countr_zero(std::rotr(wheel_busy_, shift)));
  }
  for (int write = 0; write < 2; ++write) {
    next = std::min(next, earliest(opened_[write] & ready_[kColumn], columns_[write]));
  }
  const uint64_t opened = opened_[0] | opened_[1];
  if (refreshes_owed_ == 0) {
    next = std::min(next, earliest(has_[draining_][1] & ready_[kColumn], columns_[draining_]));
    next = std::min(next, earliest(has_[draining_][0] & closed_ & ready_[kActivate], activates_));
    const uint64_t conflicts = has_[draining_][0] & open_ & ~opened & ready_[kPrecharge];
    for (int rank = 0; rank < ranks_; ++rank) {
      if ((conflicts & rank_banks_[rank]) != 0) next = std::min(next, precharge_at_[rank]);
    }
  } else {
    const uint64_t banks = rank_banks_[refresh_rank_];
    if ((open_ & banks) == 0) {
      next = std::min(next, refresh_at_[refresh_rank_]);
    } else if ((opened & banks) == 0 && (ready_[kPrecharge] & banks) == banks) {
      next = std::min(next, precharge_at_[refresh_rank_]);
    }
  }
  return std::max(next, now + 1);
}

void DramChannel::tick(DramCycle now) {
  if (now < next_) return;
  wake(now);
  if (now >= refresh_due_) {
    refresh_due_ += timing_.t_refi;
    refreshes_owed_ += static_cast<uint64_t>(ranks_);
  }
  // Another command mostly follows an activation or a precharge at once; after an access it is worth a look.
  const bool again = now >= command_bus_at_ && issue(now);
  next_ = std::max(again ? now + 1 : when_next(now), command_bus_at_);
}

bool DramChannel::finished(DramCycle now, uint32_t& tag) {
  if (returns_ == 0 || return_[first_return_].when > now) return false;
  tag = return_[first_return_].tag;
  first_return_ = (first_return_ + 1) & return_mask_;
  --returns_;
  --reads_open_;
  return true;
}

// ---- commands

bool DramChannel::next_mode() const {
  if (draining_) return writes_ >= drain_below_ || reads_ == 0;
  return writes_ > drain_above_ || reads_ == 0;
}

// Returns whether another command may well follow in the next cycle.
inline bool DramChannel::issue(DramCycle now) {
  if (half_open_ >= 0 && now >= half_open_until_) {
    open_row(now);
    return true;
  }
  uint64_t oldest = UINT64_MAX;
  Access access = synced_;
  if (access.bank < 0 && ((opened_[0] | opened_[1]) & ready_[kColumn]) != 0) {
    oldest = choose_opened(now);
    if (oldest != UINT64_MAX) access = {static_cast<int>(oldest & 63), true, (oldest & 64) != 0};
  }
  if (access.bank < 0 && refreshes_owed_ > 0) {
    if (refresh(now)) return true;
  } else if (access.bank < 0) {
    draining_ = next_mode();
    oldest = choose(now);
    if (oldest != UINT64_MAX) {
      const int bank = static_cast<int>(oldest & 63);
      if ((oldest & 64) != 0) {
        access = {bank, false, draining_};
      } else {
        if ((closed_ & bit(bank)) != 0) {
          activate(now, bank, draining_);
        } else {
          count(pool_[bank_[bank].waiting[draining_].miss.head], counters_.row_conflicts);
          precharge(now, bank);
        }
        return true;
      }
    }
  }
  if (access.bank >= 0) {
    column(now, access);
    return false;
  }
  if (half_open_ < 0) return false;
  open_row(now);
  return true;
}

// The oldest burst for which a row was opened and whose column access is allowed.
inline uint64_t DramChannel::choose_opened(DramCycle now) const {
  uint64_t oldest = UINT64_MAX;
  for (int write = 0; write < 2; ++write) {
    uint64_t banks = opened_[write] & ready_[kColumn];
    if (banks == 0) continue;
    banks &= allowed(now, columns_[write]);
    for (; banks != 0; banks &= banks - 1) oldest = std::min(oldest, opened_age_[std::countr_zero(banks)]);
  }
  return oldest;
}

// The oldest burst whose command is allowed.
inline uint64_t DramChannel::choose(DramCycle now) const {
  uint64_t oldest = UINT64_MAX;
  uint64_t columns = has_[draining_][1] & ready_[kColumn];
  if (columns != 0) columns &= allowed(now, columns_[draining_]);
  for (; columns != 0; columns &= columns - 1) {
    oldest = std::min(oldest, age_[draining_][1][std::countr_zero(columns)]);
  }
  // Between the two commands of an activation no other may begin.
  uint64_t activates = half_open_ < 0 ? has_[draining_][0] & closed_ & ready_[kActivate] : 0;
  if (activates != 0) activates &= allowed(now, activates_);
  uint64_t precharges = has_[draining_][0] & open_ & ~opened_[0] & ~opened_[1] & ready_[kPrecharge];
  for (int rank = 0; rank < ranks_; ++rank) precharges &= now >= precharge_at_[rank] ? ~uint64_t{0} : ~rank_banks_[rank];
  for (uint64_t banks = activates | precharges; banks != 0; banks &= banks - 1) {
    oldest = std::min(oldest, age_[draining_][0][std::countr_zero(banks)]);
  }
  return oldest;
}

void DramChannel::count(Burst& burst, uint64_t& counter) {
  if (!burst.counted) ++counter;
  burst.counted = true;
}

// A column access; first a CAS command if WCK has stopped.
inline void DramChannel::column(DramCycle now, Access access) {
  const DramTiming& t = timing_;
  const auto [bank, opened, write] = access;
  if (t.t_wckpst >= 0 && synced_.bank < 0 && now >= wck_until_) {
    // The cycle after a CAS belongs to its access: no second half of an activation may be due then.
    if (half_open_ >= 0 && half_open_until_ <= now + 1) {
      open_row(now);
      return;
    }
    synced_ = access;
    ++counters_.wck_syncs;
    return;
  }
  synced_.bank = -1;
  uint32_t tag;
  if (opened) {
    opened_[write] &= ~bit(bank);
    tag = bank_[bank].opened_tag;
  } else {
    const int16_t index = take_head(bank_[bank].waiting[write].hit);
    new_head(bank, write, true);
    count(pool_[index], counters_.row_hits);
    tag = pool_[index].tag;
    release(index, bank, write);
  }

  const int group = group_of(bank), rank = rank_of(bank);
  for (int second = 0; second < 2; ++second) {
    const Gap& gap = gap_[write][second];
    raise(columns_[second].group_at[group], now + gap.same_group);
    if (ranks_ > 1) {
      for (int other = 0; other < ranks_; ++other) raise(columns_[second].rank_at[other], now + gap.other_rank);
    }
    raise(columns_[second].rank_at[rank], now + gap.same_rank);
  }
  raise(wck_until_, now + wck_after_[write]);
  command_bus_at_ = now + t.ca_column;
  hold(kPrecharge, bank, now + precharge_after_[write]);
  if (write) {
    --writes_open_;
    ++counters_.bursts_written;
  } else {
    return_[(first_return_ + returns_++) & return_mask_] = {now + t.rl + t.t_burst, tag};
    ++counters_.bursts_read;
  }
}

// Opens the row of the oldest burst that waits for this bank; that burst then goes before all others.
void DramChannel::activate(DramCycle now, int bank, bool write) {
  const DramTiming& t = timing_;
  const int16_t index = take_head(bank_[bank].waiting[write].miss);
  new_head(bank, write, false);
  Burst& burst = pool_[index];
  count(burst, counters_.row_misses);
  release(index, bank, write);
  bank_[bank].row = burst.row;
  bank_[bank].opened_tag = burst.tag;
  bank_[bank].opened_arrived = burst.arrived;
  closed_ &= ~bit(bank);

  const int group = group_of(bank), rank = rank_of(bank);
  auto& last = last_activates_[rank];
  last = {last[1], last[2], last[3], now};
  raise(activates_.group_at[group], now + t.t_rrd_l);
  raise(activates_.rank_at[rank], std::max(now + t.t_rrd_s, last[0] + t.t_faw));
  raise(refresh_at_[rank], now + t.t_rc);
  raise(bank_[bank].ready_at[kActivate], now + t.t_rc);
  hold(kColumn, bank, now + t.t_rcd);
  hold(kPrecharge, bank, now + t.t_ras);
  command_bus_at_ = now + t.ca_act;
  ++counters_.activates;
  half_open_ = bank;
  half_open_write_ = write;
  half_open_until_ = now + t.t_aad;
  if (t.t_aad == 0) open_row(now);
}

// The activation is complete: the bank's bursts of this row become hits.
void DramChannel::open_row(DramCycle now) {
  const int bank = half_open_;
  half_open_ = -1;
  open_ |= bit(bank);
  opened_[half_open_write_] |= bit(bank);
  opened_age_[bank] = (static_cast<uint64_t>(bank_[bank].opened_arrived) << 16 | (opened_count_++ & 0xffff)) << 7 |
                      uint64_t{half_open_write_} << 6 | static_cast<uint64_t>(bank);
  for (int write = 0; write < 2; ++write) {
    if ((has_[write][0] & bit(bank)) == 0) continue;
    split_by_row(bank_[bank].waiting[write], bank_[bank].row);
    new_head(bank, write, true);
    new_head(bank, write, false);
  }
  raise(command_bus_at_, now + 1);
}

void DramChannel::close_bank(int bank) {
  open_ &= ~bit(bank);
  closed_ |= bit(bank);
  for (int write = 0; write < 2; ++write) {
    if ((has_[write][1] & bit(bank)) == 0) continue;
    merge_into_miss(bank_[bank].waiting[write]);
    new_head(bank, write, true);
    new_head(bank, write, false);
  }
}

void DramChannel::precharge(DramCycle now, int bank) {
  const int rank = rank_of(bank);
  close_bank(bank);
  hold(kActivate, bank, now + timing_.t_rp);
  raise(precharge_at_[rank], now + timing_.t_ppd);
  raise(refresh_at_[rank], now + timing_.t_rp);
  command_bus_at_ = now + timing_.ca_pre;
  ++counters_.precharges;
}

// The next command of a due refresh: all banks of the rank are precharged, then refreshed.
bool DramChannel::refresh(DramCycle now) {
  const DramTiming& t = timing_;
  const int rank = refresh_rank_;
  const uint64_t banks = rank_banks_[rank];
  if (((opened_[0] | opened_[1]) & banks) != 0 || (half_open_ >= 0 && (bit(half_open_) & banks) != 0)) return false;
  if ((open_ & banks) != 0) {
    if ((ready_[kPrecharge] & banks) != banks || now < precharge_at_[rank]) return false;
    for (uint64_t open = open_ & banks; open != 0; open &= open - 1) {
      close_bank(std::countr_zero(open));
      hold(kActivate, std::countr_zero(open), now + t.t_rpab);
    }
    raise(precharge_at_[rank], now + t.t_ppd);
    raise(refresh_at_[rank], now + t.t_rp);
    command_bus_at_ = now + t.ca_pre;
    ++counters_.precharges;
    return true;
  }
  if (now < refresh_at_[rank]) return false;
  raise(activates_.rank_at[rank], now + t.t_rfc);
  raise(precharge_at_[rank], now + t.t_rfc);
  raise(refresh_at_[rank], now + t.t_rfc);
  command_bus_at_ = now + 1;
  ++counters_.refreshes;
  --refreshes_owed_;
  refresh_rank_ = (refresh_rank_ + 1) & (ranks_ - 1);
  return true;
}

}  // namespace pipegs
