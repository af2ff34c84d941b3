// SPDX-License-Identifier: Apache-2.0
// dram_timing.cpp: see dram_timing.hpp.
#include "sim/memory/dram/dram_timing.hpp"

#include <array>
#include <bit>
#include <stdexcept>

namespace pipegs {
namespace {

DramTiming lpddr5_6400(int channels) {
  DramTiming t;
  t.name = "lpddr5-6400x" + std::to_string(channels);
  t.channels = channels;
  t.t_aad = 8;
  t.t_wckpst = 1;
  return t;
}

DramTiming ddr4_3200(int channels) {
  DramTiming t;
  t.name = "ddr4-3200x" + std::to_string(channels);
  t.channels = channels;
  t.rows = 65536;
  t.channel_width = 64;
  t.burst_length = 8;
  t.t_ck_ps = 625;
  t.rl = 22, t.wl = 16, t.t_burst = 4, t.t_burst_l = 4;
  t.t_rcd = 22, t.t_rp = 22, t.t_rpab = 22, t.t_ras = 52, t.t_rc = 74;
  t.t_rrd_s = 4, t.t_rrd_l = 8, t.t_faw = 34;
  t.t_ccd_s = 4, t.t_ccd_l = 8;
  t.t_rtp = 12, t.t_wr = 24, t.t_wtr_s = 4, t.t_wtr_l = 12, t.t_rtw = 12;
  t.t_ppd = 0;
  t.t_refi = 12480, t.t_rfc = 576;
  return t;
}

// LPDDR4 has no bank groups: the short and the long distances are the same.
DramTiming lpddr4_3200() {
  DramTiming t;
  t.name = "lpddr4-3200";
  t.channels = 8;
  t.bank_groups = 1, t.banks = 8;
  t.rows = 32768;
  t.t_ck_ps = 625;
  t.rl = 28, t.wl = 14, t.t_burst = 8, t.t_burst_l = 8;
  t.t_rcd = 29, t.t_rp = 29, t.t_rpab = 34, t.t_ras = 68, t.t_rc = 97;
  t.t_rrd_s = 16, t.t_rrd_l = 16, t.t_faw = 64;
  t.t_ccd_s = 8, t.t_ccd_l = 8;
  t.t_rtp = 12, t.t_wr = 29, t.t_wtr_s = 16, t.t_wtr_l = 16, t.t_rtw = 30;
  t.t_ppd = 4;
  t.t_refi = 6246, t.t_rfc = 288;
  t.ca_act = 4, t.ca_pre = 2, t.ca_column = 4;
  return t;
}

const std::array<DramTiming, 7>& presets() {
  static const std::array<DramTiming, 7> kPresets = {lpddr5_6400(4), lpddr5_6400(1), lpddr5_6400(2), lpddr5_6400(8),
                                                     lpddr4_3200(),  ddr4_3200(1),   ddr4_3200(2)};
  return kPresets;
}

}  // namespace

void check_dram(const DramTiming& t) {
  const auto demand = [&](bool holds, const char* what, double value) {
    if (!holds) throw std::invalid_argument("dram " + t.name + ": " + what + " is " + std::to_string(value));
  };
  const auto power_of_two = [](int value) { return value > 0 && std::has_single_bit(static_cast<unsigned>(value)); };
  demand(power_of_two(t.channels) && t.channels <= 32, "channels, a power of two up to 32,", t.channels);
  demand(power_of_two(t.ranks), "ranks, a power of two,", t.ranks);
  demand(power_of_two(t.bank_groups) && t.ranks * t.bank_groups <= 16, "bank groups, a power of two,", t.bank_groups);
  demand(power_of_two(t.banks) && t.banks_per_channel() <= 64, "banks, at most 64 in a channel,", t.banks);
  demand(power_of_two(t.rows) && power_of_two(t.columns), "rows, with columns a power of two,", t.rows);
  demand(power_of_two(t.burst_bytes()) && t.burst_bytes() >= 16, "bytes of a burst", t.burst_bytes());
  demand(power_of_two(t.burst_length) && t.columns >= 4 * t.burst_length, "beats of a burst", t.burst_length);
  demand(t.interleave_bytes == 0 || (power_of_two(t.interleave_bytes) && t.interleave_bytes >= t.burst_bytes()),
         "bytes in one channel", t.interleave_bytes);
  demand(power_of_two(t.group_bytes) && t.group_bytes <= t.columns * t.channel_width / 8, "bytes in one bank group",
         t.group_bytes);
  demand(t.t_ck_ps > 0 && t.t_burst > 0 && t.rl > 0 && t.wl > 0, "clock period in ps", t.t_ck_ps);
  demand(t.t_refi > t.t_rfc + t.t_rc, "refresh interval", t.t_refi);
  demand(t.t_rfcpb >= 0 && t.t_rfcpb + t.t_rc < t.t_refi / t.banks_per_channel(), "refresh of a bank", t.t_rfcpb);
  demand(t.read_queue >= 1 && t.write_queue >= 1 && t.read_queue + t.write_queue <= 4096, "read queue", t.read_queue);
  demand(t.write_low >= 0 && t.write_low < t.write_high && t.write_high <= 1, "high watermark of writes", t.write_high);
  demand(t.front_queue >= 1, "front queue", t.front_queue);
}

const DramTiming* dram_preset(std::string_view name) {
  for (const DramTiming& preset : presets()) {
    if (preset.name == name) return &preset;
  }
  return nullptr;
}

std::vector<std::string> dram_memory_names() {
  std::vector<std::string> names;
  for (const DramTiming& preset : presets()) names.push_back(preset.name);
  return names;
}

}  // namespace pipegs
