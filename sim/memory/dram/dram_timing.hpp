// SPDX-License-Identifier: Apache-2.0
// dram_timing.hpp: one kind of DRAM: organisation, timing parameters, address mapping and queues of its controller.
//
// Idea    Every timing parameter is a number of clock cycles of the DRAM (t_ck_ps each), named as in the JEDEC
//         standards; all presets are tables of these numbers. Derived: a burst moves channel_width / 8 * burst_length
//         bytes and holds the pins for t_burst cycles, so that the pins carry
//           GB/s = channels * burst_bytes / (t_burst * t_ck_ps) * 1000.
// Docs    docs/cycles/memory_timing.md gives the source of each preset.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pipegs {

enum class DramMapping {
  kRoBaRaCoCh,  // from the top: row, bank, bank group, rank, column, channel
  kRoBaCoGrCh,  // row, bank, rank, column, bank group, group_bytes, channel; bank and group XORed with the row
  kMop4ClXor,   // four bursts, then the next bank; rank, group, bank and row are XORed with the column
};

struct DramTiming {
  std::string name;

  // organisation
  int channels = 1, ranks = 1, bank_groups = 4, banks = 4;  // banks in each group
  int rows = 32768, columns = 1024;                         // columns of channel_width bits
  int channel_width = 16, burst_length = 16;                // bits, beats
  DramMapping mapping = DramMapping::kRoBaRaCoCh;
  int interleave_bytes = 0;  // consecutive bytes in one channel; 0: one burst
  int group_bytes = 512;     // RoBaCoGrCh: consecutive bytes of a channel in one bank group

  // timing
  int t_ck_ps = 1250;
  int rl = 17, wl = 9, t_burst = 2;
  int t_burst_l = 4;  // cycles that a burst holds its bank group, as counted by t_wtr_l (JESD209-5: BL/n_max)
  int t_rcd = 15, t_rp = 15, t_rpab = 17, t_ras = 34, t_rc = 49;
  int t_rrd_s = 4, t_rrd_l = 4, t_faw = 16;
  int t_ccd_s = 2, t_ccd_l = 4;  // column to column of the same direction, in another and in the same bank group
  int t_rtp = 8, t_wr = 28, t_wtr_s = 5, t_wtr_l = 10;
  int t_rtw = 12;  // read command to write command of the same rank
  int t_cs = 2;    // gap on the pins between ranks
  int t_ppd = 2;   // precharge to precharge
  int t_refi = 3125, t_rfc = 168;
  int t_rfcpb = 0;    // > 0: bank by bank instead of all of a rank at once, each bank once in t_refi
  int t_pbr2act = 6;  // from such a refresh to an activation elsewhere
  int t_aad = 0;      // > 0: two commands activate, the second at most t_aad after the first
  int t_wckpst = -1;  // >= 0: WCK stops t_wckpst after a burst, then a CAS command precedes
  int ca_act = 1, ca_pre = 1, ca_column = 1;  // cycles of the command bus

  // controller
  int read_queue = 32, write_queue = 32;     // bursts, for each channel
  double write_high = 0.8, write_low = 0.2;  // of write_queue: start and end of draining writes
  bool hits_first = false;  // a bank stays open while bursts of its row wait, though an older one waits for another row
  int front_queue = 16;     // lines that wait in order before the channels

  int burst_bytes() const { return channel_width / 8 * burst_length; }
  int banks_per_channel() const { return ranks * bank_groups * banks; }
  double peak_gbps() const { return 1000.0 * channels * burst_bytes() / (double(t_burst) * t_ck_ps); }
};

// Throws with the value if a parameter is out of the range that the model can hold.
void check_dram(const DramTiming& timing);

// A preset by name, or nullptr.
const DramTiming* dram_preset(std::string_view name);
std::vector<std::string> dram_memory_names();  // of all presets

}  // namespace pipegs
