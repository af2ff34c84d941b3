// SPDX-License-Identifier: Apache-2.0
// dram_references.cpp: see dram_references.hpp.
#include "sim/memory/dram/check/dram_references.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "scenes/text/csv.hpp"
#include "scenes/text/text_file.hpp"
#include "sim/memory/dram/check/dram_trace.hpp"

namespace pipegs {
namespace {

constexpr std::string_view kHeader = "source,configuration,trace,max_out,bursts,cycles,gbps,latency_ns";
constexpr int kMostOut = 1 << 20;
constexpr uint64_t kMostBytes = uint64_t{1} << 20;

// The configuration files of DRAMsim3 in our terms. Its 32 transactions and 8 commands for each bank become one queue
// of 48 bursts: a stream works on one or two banks. Its DDR4 channel of 16 GB has two ranks.
DramTiming lpddr4_2400_dramsim3() {
  DramTiming t;
  t.name = "lpddr4-2400";
  t.bank_groups = 2, t.banks = 4, t.rows = 65536;
  t.t_ck_ps = 830;
  t.rl = 17, t.wl = 14, t.t_burst = 8, t.t_burst_l = 8;
  t.t_rcd = 15, t.t_rp = 15, t.t_rpab = 15, t.t_ras = 32, t.t_rc = 47;
  t.t_rrd_s = 8, t.t_rrd_l = 8, t.t_faw = 32;
  t.t_ccd_s = 4, t.t_ccd_l = 6;
  t.t_rtp = 12, t.t_wr = 30, t.t_wtr_s = 8, t.t_wtr_l = 16, t.t_rtw = 13;
  t.t_cs = 1, t.t_ppd = 2;
  t.t_refi = 8660, t.t_rfc = 392;
  t.read_queue = 48;
  return t;
}

DramTiming ddr4_3200_dramsim3() {
  DramTiming t = *dram_preset("ddr4-3200x1");
  t.ranks = 2;
  t.t_ck_ps = 630;
  t.t_rtw = 12;
  t.t_cs = 1;
  t.t_rfc = 560;
  t.read_queue = 48;
  return t;
}

DramReference reference_of(const CsvRow& row) {
  DramReference reference;
  reference.source = row.text("source");
  reference.configuration = row.text("configuration");
  reference.trace = row.text("trace");
  reference.max_out = row.integer<int>("max_out", 1, kMostOut);
  reference.bursts = row.integer<uint64_t>("bursts", 1);
  reference.cycles = row.integer<int64_t>("cycles", 1);
  reference.gbps = row.real("gbps", kPositive);
  reference.latency_ns = row.real("latency_ns", kNotNegative);
  try {
    dram_reference_timing(reference.configuration);
  } catch (const std::invalid_argument&) {
    row.fail("configuration", "found " + quote(reference.configuration) + ", expected one that we have the timing of");
  }
  if (std::find(kDramTraces.begin(), kDramTraces.end(), reference.trace) == kDramTraces.end())
    row.fail("trace", "found " + quote(reference.trace) + ", expected one of dram_trace.hpp");
  return reference;
}

}  // namespace

std::vector<DramReference> parse_dram_references(std::string_view file, std::string_view text) {
  std::vector<DramReference> references;
  parse_csv(file, text, kHeader, [&](const CsvRow& row) {
    const DramReference r = reference_of(row);
    const bool twice = std::any_of(references.begin(), references.end(), [&](const DramReference& other) {
      return other.source == r.source && other.configuration == r.configuration && other.trace == r.trace &&
             other.max_out == r.max_out;
    });
    if (twice) row.fail("trace", "found a second run of " + quote(r.trace) + " with this configuration and max_out");
    references.push_back(r);
  });
  return references;
}

std::vector<DramReference> read_dram_references(const std::filesystem::path& csv) {
  return parse_dram_references(csv.string(), read_text_file(csv, "reference runs", kMostBytes));
}

DramTiming dram_reference_timing(const std::string& configuration) {
  const auto preset = [](const char* name, DramMapping mapping) {
    DramTiming timing = *dram_preset(name);
    timing.mapping = mapping;
    return timing;
  };
  constexpr DramMapping kRo = DramMapping::kRoBaRaCoCh, kMop4 = DramMapping::kMop4ClXor;
  if (configuration == "lpddr5_1ch_robaraco") return preset("lpddr5-6400x1", kRo);
  if (configuration == "lpddr5_1ch_mop4") return preset("lpddr5-6400x1", kMop4);
  if (configuration == "lpddr5_2ch_robaraco") return preset("lpddr5-6400x2", kRo);
  if (configuration == "lpddr5_4ch_robaraco") return preset("lpddr5-6400x4", kRo);
  if (configuration == "lpddr5_4ch_mop4") return preset("lpddr5-6400x4", kMop4);
  if (configuration == "ddr4_3200_1ch_robaraco") return preset("ddr4-3200x1", kRo);
  if (configuration == "ddr4_3200_1ch_mop4") return preset("ddr4-3200x1", kMop4);
  if (configuration == "ddr4_3200_2ch_robaraco") return preset("ddr4-3200x2", kRo);
  if (configuration == "lpddr4_2400_16b") return lpddr4_2400_dramsim3();
  if (configuration == "DDR4_8Gb_x8_3200") return ddr4_3200_dramsim3();
  throw std::invalid_argument("dram: no reference configuration is called " + configuration);
}

}  // namespace pipegs
