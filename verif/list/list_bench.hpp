// SPDX-License-Identifier: Apache-2.0
// list_bench.hpp: the PUs before the lists, the SUs behind them, the SRAM of the counts, and random frames of windows.
#pragma once

#include <map>

#include "cpp_model/list/list_write.hpp"
#include "verif/support/config.hpp"
#include "verif/support/frame_ports.hpp"
#include "verif/support/gated_bench.hpp"

namespace pipegs {

inline Frame list_frame(const Config& config, std::mt19937_64& rng, uint64_t columns, uint64_t rows) {
  Frame frame = random_record<Frame>(config, rng);
  frame.raster.windows.first_x = rng() % (1024 - columns),
  frame.raster.windows.last_x = frame.raster.windows.first_x + columns - 1;
  frame.raster.windows.first_y = rng() % (1024 - rows),
  frame.raster.windows.last_y = frame.raster.windows.first_y + rows - 1;
  frame.tables.overflow &= (uint64_t{1} << 32) - 1;
  return frame;
}

// Records of one frame: in the order of their index, each with its window.
struct ListRecords {
  std::vector<Splat> splats;
  std::vector<uint64_t> numbers;
  // Runs of the same window are what hurts.
  void add(const Config& config, std::mt19937_64& rng, uint64_t windows, size_t count) {
    uint64_t number = 0;
    for (size_t i = 0; i < count; ++i) {
      if (rng() % 3 != 0) number = rng() % windows;
      Splat splat = random_record<Splat>(config, rng);
      splat.kind = kData;
      splat.index = splats.size();
      splats.push_back(splat);
      numbers.push_back(number);
    }
  }
};

// The PUs: each offers its records and then the frame's end.
template <class Dut, class ValidPort, class DataPort, class NumberPort>
class ListPus : public Endpoint {
 public:
  ListPus(BenchBase& bench, const Config& config, ValidPort& valid, const ValidPort& ready, DataPort& data,
          NumberPort& number)
      : bench_(bench),
        config_(config),
        valid_(valid),
        ready_(ready),
        data_(data),
        number_(number),
        queue(config.units),
        up_(config.units) {
    valid_ = 0;
    bench.add(*this);
  }
  void offer(const ListRecords& records) {
    for (size_t i = 0; i < records.splats.size(); ++i)
      queue[bench_.rng() % queue.size()].push_back({records.splats[i], records.numbers[i]});
    for (auto& one : queue) {
      one.push_back({Splat{}, 0});
      one.back().first.kind = kWindowEnd;
    }
  }
  bool empty() const {
    for (const auto& one : queue)
      if (!one.empty()) return false;
    return true;
  }
  void drive() override {
    const int width = record_width<Splat>(config_), number_w = config_.list_window_w();
    Words data(port_words<DataPort>() + 4), numbers(port_words<NumberPort>() + 4);
    for (uint32_t& word : data) word = static_cast<uint32_t>(bench_.rng());
    for (uint32_t& word : numbers) word = static_cast<uint32_t>(bench_.rng());
    uint32_t valid = 0;
    for (size_t u = 0; u < queue.size(); ++u) {
      if (!up_[u]) up_[u] = !queue[u].empty() && goes(pace, bench_.rng);
      if (!up_[u]) continue;
      valid |= 1u << u;
      Words one(static_cast<size_t>(width) / 32 + 2);
      pack(config_, queue[u].front().first, one.data());
      for (int bit = 0; bit < width; bit += 32) {
        const int take = std::min(32, width - bit);
        put_bits(data.data(), static_cast<int>(u) * width + bit, take, get_bits(one.data(), bit, take));
      }
      put_bits(numbers.data(), static_cast<int>(u) * number_w, number_w, queue[u].front().second);
    }
    valid_ = static_cast<ValidPort>(valid);
    write_port(data_, data.data());
    write_port(number_, numbers.data());
  }
  void observe() override {
    for (size_t u = 0; u < queue.size(); ++u) {
      if (!up_[u] || ((ready_ >> u) & 1) == 0) continue;
      queue[u].pop_front();
      up_[u] = false;
      ++taken;
    }
  }
  Pace pace = Pace::kAlways;
  uint64_t taken = 0;

 private:
  BenchBase& bench_;
  Config config_;
  ValidPort& valid_;
  const ValidPort& ready_;
  DataPort& data_;
  NumberPort& number_;

 public:
  std::vector<std::deque<std::pair<Splat, uint64_t>>> queue;

 private:
  std::vector<bool> up_;
};

// The SUs: a ready one stays so until it is given something, and has room. Lazy ones say that they have room, and are
// ready only for what was shown. Each keeps its entries by window.
template <class ValidPort, class SplatPort>
class ListSus : public Endpoint {
 public:
  ListSus(BenchBase& bench, const Config& config, const ValidPort& valid, ValidPort& ready, ValidPort& room,
          const SplatPort& splat)
      : bench_(bench),
        config_(config),
        valid_(valid),
        ready_(ready),
        room_(room),
        splat_(splat),
        window(config.units),
        count(config.units) {
    ready_ = room_ = 0;
    bench.add(*this);
  }
  void drive() override {
    const bool lazy = pace == Pace::kLazy;
    for (size_t u = 0; u < window.size(); ++u) {
      if ((full || lazy) && ((shown_ >> u) & 1) == 0) continue;
      if (goes(pace, bench_.rng)) up_ |= 1u << u;
    }
    ready_ = static_cast<ValidPort>(up_);
    room_ = static_cast<ValidPort>(lazy && !full ? (1u << window.size()) - 1 : up_);
  }
  void observe() override {
    if (shown_ != 0) {
      EXPECT_EQ(valid_ & shown_, shown_) << "valid fell before the beat was taken, cycle " << bench_.cycle;
      EXPECT_EQ(read_record<Splat>(config_, splat_), last_)
          << "the beat changed before it was taken, cycle " << bench_.cycle;
    }
    const uint32_t taken = valid_ & up_;
    last_ = read_record<Splat>(config_, splat_);
    shown_ = valid_ & ~up_;
    up_ &= ~taken;
    EXPECT_TRUE(valid_ == 0 || last_.kind != kData || (valid_ & (valid_ - 1)) == 0)
        << "an entry for several SUs, cycle " << bench_.cycle;
    for (size_t u = 0; u < window.size(); ++u) {
      if (((taken >> u) & 1) == 0) continue;
      if (last_.kind == kData) {
        entries[window[u]].push_back(last_);
        ++count[u];
      } else {
        EXPECT_EQ(last_.kind, uint64_t{kWindowEnd});
        ++window[u];
      }
    }
  }
  bool ended(uint64_t windows) const {
    for (const uint64_t w : window)
      if (w != windows) return false;
    return true;
  }
  void clear() {
    entries.clear();
    for (uint64_t& w : window) w = 0;
  }
  Pace pace = Pace::kAlways;
  bool full = false;  // ready only for what is offered already

 private:
  BenchBase& bench_;
  Config config_;
  const ValidPort& valid_;
  ValidPort& ready_;
  ValidPort& room_;
  const SplatPort& splat_;
  uint32_t up_ = 0, shown_ = 0;
  Splat last_;

 public:
  std::vector<uint64_t> window, count;             // of each SU: windows ended, entries taken in all
  std::map<uint64_t, std::vector<Splat>> entries;  // of each window, all SUs together
};

// The SRAM of the counts: what is read shows from the next cycle on; a word that is written in the same cycle reads
// old.
template <class Dut>
class ListCounts : public Endpoint {
 public:
  ListCounts(BenchBase& bench, const Config& config, Dut& dut)
      : counts(size_t{1} << config.list_window_w()), dut_(dut), rng_(bench.rng) {
    for (uint64_t& count : counts) count = rng_() & ((uint64_t{1} << config.list_entry_w()) - 1);  // noise
    bench.add(*this);
  }
  void drive() override { dut_.count_i = static_cast<IData>(shown_); }
  void observe() override {
    if (dut_.count_read_o) shown_ = counts[dut_.count_number_o];
    if constexpr (requires { dut_.count_write_o; }) {
      if (dut_.count_write_o) counts[dut_.count_at_o] = dut_.count_o;
    }
  }
  std::vector<uint64_t> counts;

 private:
  Dut& dut_;
  std::mt19937_64& rng_;
  uint64_t shown_ = 0;
};

}  // namespace pipegs
