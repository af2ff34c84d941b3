// SPDX-License-Identifier: Apache-2.0
// dram_channel.cpp: see dram_channel.hpp.
#include "sim/memory/dram/dram_channel.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace pipegs {
namespace {

constexpr int32_t kLongAgo = -(1 << 30);
constexpr int32_t kRenumberTime = 1 << 30;         // from here on times start again near 0
constexpr int32_t kRenumberOrder = (1 << 24) - 1;  // an age has 24 bits for the order

int log2_of(int value) { return std::bit_width(static_cast<unsigned>(value)) - 1; }
template <class T>
void raise(T& at, T to) {
  at = std::max(at, to);
}

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
      bank_refresh_(timing.t_rfcpb > 0),
      lanes_((timing.banks_per_channel() + kDramBlock - 1) / kDramBlock * kDramBlock),
      ranks_(timing.ranks),
      rank_shift_(log2_of(timing.banks * timing.bank_groups)),
      group_shift_(log2_of(timing.banks)),
      read_queue_(timing.read_queue),
      write_queue_(timing.write_queue),
      drain_above_(static_cast<int>(std::floor(timing.write_high * timing.write_queue))),
      drain_below_(static_cast<int>(std::ceil(timing.write_low * timing.write_queue))),
      refresh_every_(bank_refresh_ ? timing.t_refi / timing.banks_per_channel() : timing.t_refi),
      refresh_due_(refresh_every_),
      next_(refresh_every_),
      returns_limit_(timing.rl + timing.t_burst + timing.read_queue) {
  check_dram(timing);
  const DramTiming& t = timing_;
  const int banks = t.banks_per_channel();
  bank_.resize(banks);
  for (DramWaiting& waiting : waiting_) {
    waiting.hit_age.fill(kDramNone);
    waiting.miss_age.fill(kDramNone);
  }
  not_before_.no_precharge.fill(kDramNone);
  for (int bank = 0; bank < banks; ++bank) rank_banks_[rank_of(bank)] |= bit(bank);
  for (auto& last : last_activates_) last.fill(kLongAgo);
  pool_.resize(t.read_queue + t.write_queue);
  for (std::size_t i = 0; i < pool_.size(); ++i) pool_[i].next = static_cast<int32_t>(i + 1);
  return_.resize(std::bit_ceil(static_cast<unsigned>(2 * returns_limit_)));
  return_mask_ = static_cast<uint32_t>(return_.size() - 1);

  constexpr int kRead = 0, kWrite = 1;
  wck_after_ = {t.rl + t.t_burst + t.t_wckpst, t.wl + t.t_burst + t.t_wckpst};
  precharge_after_ = {t.t_rtp, t.wl + t.t_burst + t.t_wr};
  after_.resize(banks >> group_shift_);
  for (int group = 0; group < static_cast<int>(after_.size()); ++group) {
    Distances& after = after_[group];
    for (int bank = 0; bank < banks; ++bank) {
      const bool same_rank = rank_of(bank) == rank_of(group << group_shift_);
      const bool same_group = bank >> group_shift_ == group;
      const auto distance = [&](int in_group, int in_rank, int elsewhere) {
        return same_group ? in_group : same_rank ? in_rank : elsewhere;
      };
      const int follow = distance(std::max(t.t_ccd_l, t.t_burst), std::max(t.t_ccd_s, t.t_burst), t.t_burst);
      const int turn = t.wl + t.t_burst;
      after.column[kRead][kRead][bank] = same_rank ? follow : t.t_burst + t.t_cs;
      after.column[kWrite][kWrite][bank] = follow;
      after.column[kRead][kWrite][bank] = same_rank ? t.t_rtw : t.t_burst + t.t_cs;
      after.column[kWrite][kRead][bank] =
          distance(t.wl + t.t_burst_l + t.t_wtr_l, turn + t.t_wtr_s, t.rl + t.t_burst + t.t_cs - t.wl);
      after.activate[bank] = distance(t.t_rrd_l, t.t_rrd_s, 0);
      after.fourth_activate[bank] = same_rank ? t.t_faw : 0;
      after.precharge[bank] = same_rank ? t.t_ppd : 0;
    }
  }
}

// ---- lists of waiting bursts

inline void DramChannel::append(List& list, int32_t burst) {
  pool_[burst].next = -1;
  if (list.head < 0) {
    list.head = burst;
  } else {
    pool_[list.tail].next = burst;
  }
  list.tail = burst;
}

inline int32_t DramChannel::take_head(List& list) {
  const int32_t burst = list.head;
  list.head = pool_[burst].next;
  return burst;
}

// The list of a bank has another head, or none. With hits_first a burst for another row is not seen while hits wait.
inline void DramChannel::new_head(int bank, bool write, bool hit) {
  const Lists& lists = bank_[bank].waiting[write];
  const int32_t head = hit ? lists.hit.head : lists.miss.head;
  DramLanes& ages = hit ? waiting_[write].hit_age : waiting_[write].miss_age;
  ages[bank] = head < 0 ? kDramNone : pool_[head].order << 7 | (hit ? 64 : 0) | bank;
  if (!timing_.hits_first) return;
  const int32_t miss = lists.hit.head >= 0 ? -1 : lists.miss.head;
  waiting_[write].miss_age[bank] = miss < 0 ? kDramNone : pool_[miss].order << 7 | bank;
}

// A burst leaves its queue.
inline uint32_t DramChannel::release(int32_t index, int bank, bool write) {
  Burst& burst = pool_[index];
  if (write) {
    --writes_;
    --write_filter_[filter_slot(static_cast<uint32_t>(bank), burst.row, burst.column)];
  } else {
    --reads_;
  }
  burst.next = free_;
  free_ = index;
  return burst.tag;
}

void DramChannel::merge_into_miss(Lists& lists) {
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
    const int32_t burst = take_head(all);
    append(pool_[burst].row == row ? lists.hit : lists.miss, burst);
  }
}

// Does a write to the same burst wait?
inline bool DramChannel::write_waits(const DramPlace& place) const {
  if (write_filter_[filter_slot(place.bank, place.row, place.column)] == 0) return false;
  const Lists& lists = bank_[place.bank].waiting[1];
  for (const List& list : {lists.hit, lists.miss}) {
    for (int32_t i = list.head; i >= 0; i = pool_[i].next) {
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
    if (returns_ > 0) raise(when, return_[(first_return_ + static_cast<uint32_t>(returns_) - 1) & return_mask_].when);
    return_[(first_return_ + static_cast<uint32_t>(returns_++)) & return_mask_] = {when, tag};
    next_return_ = std::min(next_return_, when);
    return;
  }
  if (order_ == kRenumberOrder) renumber_order();
  const int32_t index = free_;
  Burst& burst = pool_[index];
  free_ = burst.next;
  burst = {order_++, -1, now, place.row, place.column, tag, false};
  const int bank = static_cast<int>(place.bank);
  Lists& lists = bank_[bank].waiting[write];
  const bool hit = (open_ & bit(bank)) != 0 && bank_[bank].row == place.row;
  List& list = hit ? lists.hit : lists.miss;
  const bool first = list.head < 0;
  append(list, index);
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

// Times count from a new base, so that they stay within 31 bits.
void DramChannel::renumber_time() {
  constexpr Time kBack = kRenumberTime - 4096;
  base_ += kBack;
  const auto back = [](auto& times) {
    for (Time& time : times) time = std::max(time - kBack, kLongAgo);
  };
  for (auto& times : not_before_.column) back(times);
  back(not_before_.activate);
  back(not_before_.precharge);
  back(refresh_at_);
  for (auto& last : last_activates_) back(last);
  for (Time* time : {&command_bus_at_, &half_open_until_, &wck_until_, &refresh_due_}) *time -= kBack;
}

// The waiting bursts are numbered anew from 0.
void DramChannel::renumber_order() {
  int32_t oldest = order_;
  for (const Bank& bank : bank_) {
    for (const Lists& lists : bank.waiting) {
      for (const List& list : {lists.hit, lists.miss}) {
        if (list.head >= 0) oldest = std::min(oldest, pool_[list.head].order);
      }
    }
  }
  for (Burst& burst : pool_) burst.order -= oldest;
  order_ -= oldest;
  for (int bank = 0; bank < static_cast<int>(bank_.size()); ++bank) {
    for (const bool write : {false, true}) {
      for (const bool hit : {false, true}) new_head(bank, write, hit);
    }
  }
}

// The next cycle in which a command may become possible if no burst is accepted before.
inline DramChannel::Time DramChannel::when_next(Time now) const {
  if (half_open_ >= 0 || synced_ || ((bank_refresh_ || refreshes_owed_ == 0) && next_mode() != draining_))
    return now + 1;
  Time next = refresh_due_;
  for (int i = 0; i < opened_count_; ++i) {
    next = std::min(next, not_before_.column[opened_[i].write][opened_[i].bank]);
  }
  if (refreshes_owed_ > 0 && bank_refresh_) {
    const bool open = (open_ & bit(refresh_bank_)) != 0;
    if ((opened_banks_ & bit(refresh_bank_)) == 0)
      next = std::min(next, (open ? not_before_.precharge : not_before_.activate)[refresh_bank_]);
  } else if (refreshes_owed_ > 0) {
    const uint64_t banks = rank_banks_[refresh_rank_];
    if ((opened_banks_ & banks) != 0) return std::max(next, now + 1);
    Time at = refresh_at_[refresh_rank_];
    if ((open_ & banks) != 0) {
      at = 0;
      for (uint64_t rest = banks; rest != 0; rest &= rest - 1) raise(at, not_before_.precharge[std::countr_zero(rest)]);
    }
    return std::max(std::min(next, at), now + 1);
  }
  next = std::min(next, earliest_ready(waiting_[draining_], not_before_, draining_, lanes_));
  return std::max(next, now + 1);
}

void DramChannel::act(DramCycle cycle) {
  if (cycle - base_ >= kRenumberTime) renumber_time();
  const Time now = static_cast<Time>(cycle - base_);
  if (now >= refresh_due_) {
    refresh_due_ += refresh_every_;
    refreshes_owed_ += bank_refresh_ ? 1 : static_cast<uint64_t>(ranks_);
  }
  if (now >= command_bus_at_) issue(now);
  next_ = base_ + std::max(when_next(now), command_bus_at_);
}

// ---- commands

bool DramChannel::next_mode() const {
  if (draining_) return writes_ >= drain_below_ || reads_ == 0;
  return writes_ > drain_above_ || reads_ == 0;
}

inline void DramChannel::issue(Time now) {
  if (half_open_ >= 0 && now >= half_open_until_) {
    open_row(now);
    return;
  }
  if (synced_ && !synced_opened_) {
    column_hit(now, synced_bank_, synced_write_);
    return;
  }
  const int opened = ready_opened(now);
  if (opened >= 0) {
    column_opened(now, opened);
    return;
  }
  if (refreshes_owed_ > 0 && (bank_refresh_ ? refresh_bank(now) : refresh(now))) return;
  if (refreshes_owed_ == 0 || bank_refresh_) {
    draining_ = next_mode();
    // Between the two commands of an activation no other may begin.
    const Age oldest = oldest_ready(waiting_[draining_], not_before_, draining_, half_open_ >= 0, now, lanes_);
    if (oldest != kDramNone) {
      const int bank = oldest & 63;
      if ((oldest & 64) != 0) {
        column_hit(now, bank, draining_);
      } else if (not_before_.no_activate[bank] == 0) {
        activate(now, bank, draining_);
      } else {
        count(pool_[bank_[bank].waiting[draining_].miss.head], counters_.row_conflicts);
        precharge(now, bank);
      }
      return;
    }
  }
  if (half_open_ >= 0) open_row(now);
}

// The oldest burst for which a row was opened and whose column access is allowed, or -1.
inline int DramChannel::ready_opened(Time now) const {
  for (int i = 0; i < opened_count_; ++i) {
    const Opened& burst = opened_[i];
    if (not_before_.column[burst.write][burst.bank] <= now && (!synced_ || synced_bank_ == burst.bank)) return i;
  }
  return -1;
}

// LPDDR5: if WCK has stopped, a CAS command takes this cycle and the access the next; true if so.
inline bool DramChannel::sync(Time now, int bank, bool opened, bool write) {
  if (timing_.t_wckpst < 0 || synced_ || now < wck_until_) {
    synced_ = false;
    return false;
  }
  // The cycle after a CAS belongs to its access: no second half of an activation may be due then.
  if (half_open_ >= 0 && half_open_until_ <= now + 1) {
    open_row(now);
    return true;
  }
  synced_ = true;
  synced_bank_ = bank;
  synced_opened_ = opened;
  synced_write_ = write;
  ++counters_.wck_syncs;
  return true;
}

inline void DramChannel::column_opened(Time now, int index) {
  const Opened burst = opened_[index];
  if (sync(now, burst.bank, true, burst.write)) return;
  --opened_count_;
  for (int i = index; i < opened_count_; ++i) opened_[i] = opened_[i + 1];
  opened_banks_ &= ~bit(burst.bank);
  not_before_.no_precharge[burst.bank] = 0;
  access(now, burst.bank, burst.write, burst.tag);
}

inline void DramChannel::column_hit(Time now, int bank, bool write) {
  if (sync(now, bank, false, write)) return;
  const int32_t index = take_head(bank_[bank].waiting[write].hit);
  new_head(bank, write, true);
  count(pool_[index], counters_.row_hits);
  access(now, bank, write, release(index, bank, write));
}

inline void DramChannel::access(Time now, int bank, bool write, uint32_t tag) {
  const Distances& after = after_[bank >> group_shift_];
  raise_lanes(not_before_.column, after.column[write], now, lanes_);
  raise(not_before_.precharge[bank], now + precharge_after_[write]);
  raise(wck_until_, now + wck_after_[write]);
  command_bus_at_ = now + timing_.ca_column;
  if (write) {
    --writes_open_;
    ++counters_.bursts_written;
  } else {
    const DramCycle when = base_ + now + timing_.rl + timing_.t_burst;
    return_[(first_return_ + static_cast<uint32_t>(returns_++)) & return_mask_] = {when, tag};
    next_return_ = std::min(next_return_, when);
    ++counters_.bursts_read;
  }
}

// Opens the row of the oldest burst that waits for this bank; that burst then goes before all others.
inline void DramChannel::activate(Time now, int bank, bool write) {
  const DramTiming& t = timing_;
  const int32_t index = take_head(bank_[bank].waiting[write].miss);
  new_head(bank, write, false);
  Burst& burst = pool_[index];
  count(burst, counters_.row_misses);
  bank_[bank].row = burst.row;
  half_opened_ = {burst.arrived, bank, write, release(index, bank, write)};
  not_before_.no_activate[bank] = kDramNone;

  const int rank = rank_of(bank);
  auto& last = last_activates_[rank];
  last = {last[1], last[2], last[3], now};
  raise_lanes(not_before_.activate, after_[bank >> group_shift_].activate, now, lanes_);
  raise_lanes(not_before_.activate, after_[bank >> group_shift_].fourth_activate, last[0], lanes_);
  raise(not_before_.activate[bank], now + t.t_rc);
  raise(not_before_.column[0][bank], now + t.t_rcd);
  raise(not_before_.column[1][bank], now + t.t_rcd);
  raise(not_before_.precharge[bank], now + t.t_ras);
  raise(refresh_at_[rank], now + t.t_rc);
  command_bus_at_ = now + t.ca_act;
  ++counters_.activates;
  half_open_ = bank;
  half_open_until_ = now + t.t_aad;
  if (t.t_aad == 0) open_row(now);
}

// The activation is complete: the bank's bursts of this row become hits.
void DramChannel::open_row(Time now) {
  const int bank = half_open_;
  half_open_ = -1;
  open_ |= bit(bank);
  opened_banks_ |= bit(bank);
  int place = opened_count_++;
  for (; place > 0 && opened_[place - 1].arrived > half_opened_.arrived; --place) opened_[place] = opened_[place - 1];
  opened_[place] = half_opened_;
  for (const bool write : {false, true}) {
    if (waiting_[write].miss_age[bank] == kDramNone) continue;
    split_by_row(bank_[bank].waiting[write], bank_[bank].row);
    new_head(bank, write, true);
    new_head(bank, write, false);
  }
  raise(command_bus_at_, now + 1);
}

void DramChannel::close_bank(int bank) {
  open_ &= ~bit(bank);
  not_before_.no_activate[bank] = 0;
  not_before_.no_precharge[bank] = kDramNone;
  for (const bool write : {false, true}) {
    if (waiting_[write].hit_age[bank] == kDramNone) continue;
    merge_into_miss(bank_[bank].waiting[write]);
    new_head(bank, write, true);
    new_head(bank, write, false);
  }
}

inline void DramChannel::precharge(Time now, int bank) {
  close_bank(bank);
  raise(not_before_.activate[bank], now + timing_.t_rp);
  raise_lanes(not_before_.precharge, after_[bank >> group_shift_].precharge, now, lanes_);
  raise(refresh_at_[rank_of(bank)], now + timing_.t_rp);
  command_bus_at_ = now + timing_.ca_pre;
  ++counters_.precharges;
}

// The next command of a due refresh of one bank. The others go on; in this one no access begins any more.
bool DramChannel::refresh_bank(Time now) {
  const int bank = refresh_bank_;
  if ((opened_banks_ & bit(bank)) != 0 || half_open_ == bank) return false;
  if ((open_ & bit(bank)) != 0) {
    if (not_before_.precharge[bank] <= now) {
      precharge(now, bank);
      return true;
    }
    for (DramLanes& column : not_before_.column) raise(column[bank], not_before_.precharge[bank]);
    return false;
  }
  if (not_before_.activate[bank] > now) return false;
  for (int other = 0; other < static_cast<int>(bank_.size()); ++other)
    raise(not_before_.activate[other], now + timing_.t_pbr2act);
  raise(not_before_.activate[bank], now + timing_.t_rfcpb);
  command_bus_at_ = now + 1;
  ++counters_.refreshes;
  --refreshes_owed_;
  refresh_bank_ = (refresh_bank_ + 1) % static_cast<int>(bank_.size());
  return true;
}

// The next command of a due refresh: all banks of the rank are precharged, then refreshed.
bool DramChannel::refresh(Time now) {
  const DramTiming& t = timing_;
  const uint64_t banks = rank_banks_[refresh_rank_];
  if ((opened_banks_ & banks) != 0 || (half_open_ >= 0 && (bit(half_open_) & banks) != 0)) return false;
  const bool precharge_first = (open_ & banks) != 0;
  if (!precharge_first && now < refresh_at_[refresh_rank_]) return false;
  for (uint64_t rest = precharge_first ? banks : 0; rest != 0; rest &= rest - 1) {
    if (not_before_.precharge[std::countr_zero(rest)] > now) return false;
  }
  for (uint64_t rest = banks; rest != 0; rest &= rest - 1) {
    const int bank = std::countr_zero(rest);
    if (precharge_first && (open_ & bit(bank)) != 0) close_bank(bank);
    raise(not_before_.activate[bank], now + (precharge_first ? t.t_rpab : t.t_rfc));
    raise(not_before_.precharge[bank], now + (precharge_first ? t.t_ppd : t.t_rfc));
  }
  raise(refresh_at_[refresh_rank_], now + (precharge_first ? t.t_rp : t.t_rfc));
  if (precharge_first) {
    command_bus_at_ = now + t.ca_pre;
    ++counters_.precharges;
  } else {
    command_bus_at_ = now + 1;
    ++counters_.refreshes;
    --refreshes_owed_;
    refresh_rank_ = (refresh_rank_ + 1) & (ranks_ - 1);
  }
  return true;
}

}  // namespace pipegs
