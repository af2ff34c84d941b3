// SPDX-License-Identifier: Apache-2.0
// package_sv.cpp: prints rtl/pipegs_pkg.sv from config.def, records.def, registers.def: `package_sv [key=value ...]`.
// `package_sv --corner SEED` prints instead the settings of the legal configuration that this seed makes (corners.hpp).
//
// The committed rtl/pipegs_pkg.sv is of the default machine without taps, so rtl/ reads and builds on its own; a test
// compares it with this program's output. What is simulated or tested gets a package of its own in the build folder.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <map>

#include "cpp_model/areas/areas.hpp"
#include "cpp_model/config.hpp"
#include "cpp_model/control/print/print.hpp"
#include "cpp_model/lib/corners.hpp"
#include "cpp_model/lib/math/exp2.hpp"
#include "cpp_model/lib/record_table.hpp"
#include "cpp_model/pu/front/pu_cull.hpp"
#include "cpp_model/pu/front/pu_decode.hpp"
#include "cpp_model/pu/front/pu_reach.hpp"
#include "cpp_model/pu/stages.hpp"
#include "scenes/text/number.hpp"

namespace {

using Field = pipegs::RecordField;
using Record = pipegs::RecordEntry;

// The table of rtl/lib/math/pipegs_exp2.sv: entry i is {0, delta, value}, entry 0 in the low bits. An entry fills a
// machine word, so that a simulator reads it with one load; synthesis drops the zeros.
void print_exp2_table(const pipegs::Config& config) {
  const pipegs::Exp2 table(config);
  const int last = (1 << config.exp_index_w) - 1, width = config.exp_delta_w() + config.exp_value_w() > 32 ? 64 : 32;
  std::printf(
      "\n  // Chords of 2^f (delta 0: steps): entry i is {0, delta, value}, entry 0 lowest. See "
      "cpp_model/lib/math/exp2.hpp.\n"
      "  localparam int unsigned Exp2EntryW = %d;\n"
      "  localparam logic [%d*Exp2EntryW-1:0] Exp2Table = {",
      width, last + 1);
  for (int i = last; i >= 0; --i) {
    std::printf("%s%d'h%llx%s", (last - i) % 8 == 0 ? "\n    " : " ", width,
                static_cast<unsigned long long>(table.delta[i]) << config.exp_value_w() | table.value[i],
                i > 0 ? "," : "\n  };\n");
  }
}

// A table, entry 0 lowest.
void print_entries(const char* name, int entries, int width, const char* what,
                   uint64_t (*entry)(const pipegs::Config&, int), const pipegs::Config& config) {
  std::printf("\n  // %s\n  localparam logic [%d*%d-1:0] %s = {", what, entries, width, name);
  for (int i = entries - 1; i >= 0; --i) {
    std::printf("%s%d'd%llu%s", i % 8 == 7 ? "\n    " : " ", width, static_cast<unsigned long long>(entry(config, i)),
                i > 0 ? "," : "\n  };\n");
  }
}

// A declaration and what it is: behind it where the line has room, before it where not.
void print_line(const std::string& declaration, std::string_view what) {
  constexpr size_t kColumns = 120;
  if (what.empty()) {
    std::printf("%s\n", declaration.c_str());
    return;
  }
  if (declaration.size() + 5 + what.size() <= kColumns) {
    std::printf("%s  // %.*s\n", declaration.c_str(), static_cast<int>(what.size()), what.data());
    return;
  }
  const std::string indent = declaration.substr(0, declaration.find_first_not_of(' ')) + "// ";
  while (!what.empty()) {
    const size_t room = kColumns - indent.size();
    const size_t end = what.size() <= room ? what.size() : what.rfind(' ', room);
    std::printf("%s%.*s\n", indent.c_str(), static_cast<int>(end), what.data());
    what.remove_prefix(std::min(end + 1, what.size()));
  }
  std::printf("%s\n", declaration.c_str());
}

// Prints the constants of config.def and the packed structs of records.def.
class Printer {
 public:
  explicit Printer(const pipegs::Config& config) {
    for (const pipegs::ConfigEntry& entry : pipegs::config_entries(config)) entries_.emplace(entry.name, entry);
    for (const Record& record : pipegs::record_table()) by_name_.emplace(record.camel_name, &record);
  }

  void print(const pipegs::ConfigEntry& entry) const {
    const bool flag = entry.member == nullptr && entry.unit == "flag";
    print_line(flag ? fmt::format("  localparam bit {:<23} = 1'b{};", entry.camel_name, entry.value)
                    : fmt::format("  localparam int unsigned {:<14} = {};", entry.camel_name, entry.value),
               entry.what);
  }

  // A record of no bits does not exist, nor does a field of it.
  void print(const Record& record) const {
    if (bits(record) == 0) return;
    std::printf("\n  typedef struct packed {\n");
    for (auto field = record.fields.rbegin(); field != record.fields.rend(); ++field) {
      if (bits(*field) > 0) print_line(fmt::format("    {}{};", type(*field), field->name), field->what);
    }
    std::printf("  } %s_t;\n  localparam int unsigned %sBits = %d;\n", record.name, record.camel_name, bits(record));
  }

 private:
  int bits(const Field& field) const {
    return field.form == Field::kRecord ? bits(*by_name_.at(field.type)) : entries_.at(field.type).value;
  }
  int bits(const Record& record) const {
    int sum = 0;
    for (const Field& field : record.fields) sum += bits(field);
    return sum;
  }
  std::string type(const Field& field) const {
    if (field.form == Field::kRecord) return fmt::format("{}_t ", by_name_.at(field.type)->name);
    const pipegs::ConfigEntry& width = entries_.at(field.type);
    if (field.form == Field::kSigned) return fmt::format("logic signed [{}-1:0] ", width.camel_name);
    return width.value == 1 ? "logic " : fmt::format("logic [{}-1:0] ", width.camel_name);
  }

  std::map<std::string_view, pipegs::ConfigEntry> entries_;
  std::map<std::string_view, const Record*> by_name_;
};

// What goes between the parts of the machine beside the streams: wires of all units side by side, wider than a record
// of records.def may be.
constexpr const char* kBundles = R"(
  // Bundles: wires of all units side by side, the first unit lowest.
  localparam int unsigned ReadPorts = MemoryPorts - WritePorts;
  typedef struct packed {  // ports that only read: geometry of each PU, its colours, then the DOPU
    logic [Units-1:0][HalvesW-1:0] halves;  // of the line of colours, what is needed
    logic [ReadPorts-1:0][BurstW-1:0] lines;  // less one
    logic [ReadPorts-1:0][AddressW-1:0] address;
    logic [ReadPorts-1:0] valid;
  } memory_reads_t;
  typedef struct packed {
    logic [ReadPorts-1:0] line;  // an answer is there
    logic [ReadPorts-1:0] ready;
  } memory_reads_answer_t;

  typedef struct packed {  // one port of each unit that may write
    logic [Units-1:0][MemoryW-1:0] data;
    logic [Units-1:0][AddressW-1:0] address;
    logic [Units-1:0] write;
    logic [Units-1:0] valid;
  } memory_lanes_t;
  typedef struct packed {
    logic [Units-1:0] line;
    logic [Units-1:0] ready;
  } memory_lanes_answer_t;

  typedef struct packed {  // the one port of the lists
    logic [MemoryW-1:0] data;
    logic [BurstW-1:0] lines;  // of a read, less one
    logic [AddressW-1:0] address;
    logic write;
    logic valid;
  } memory_lists_t;
  typedef struct packed {
    logic line;
    logic ready;
  } memory_lists_answer_t;

  typedef struct packed {  // PUs -> their alpha stores
    logic [Units-1:0][LineW-1:0] line;
    logic [Units-1:0][AlphaAddressW-1:0] address;
    logic [Units-1:0] write;
  } store_writes_t;

  typedef struct packed {  // what the RUs have finished, to the front
    logic [Units-1:0][WindowW-1:0] y;  // the window that they are in
    logic [Units-1:0][WindowW-1:0] x;
    logic [Units-1:0][Regions-1:0] done;  // regions of it that need no more alphas
  } progress_t;

  typedef struct packed {  // what the RUs do, for the harness
    logic [Units-1:0][TapLanes*TapWordW-1:0] pixels;
    logic [Units-1:0][TapLanes*2-1:0] pixels_quarter;
    logic [Units-1:0][TapLanes*RegionW-1:0] pixels_region;
    logic [Units-1:0][TapLanes-1:0] pixels_valid;
    logic [Units-1:0][TapLanes*TapLineW-1:0] alphas;
    logic [Units-1:0][TapLanes*2-1:0] alphas_quarter;
    logic [Units-1:0][TapLanes*RegionW-1:0] alphas_region;
    logic [Units-1:0][TapLanes*TapIndexW-1:0] alphas_index;
    logic [Units-1:0][TapLanes-1:0] alphas_valid;
  } raster_taps_t;

  // AXI4 to memory: its channels, and what manager and subordinate show of reads and of writes.
  localparam int unsigned AxiIdW = TagW + 1;  // the epoch of the core, the tag
  localparam int unsigned AxiAddrW = 64;  // of a byte address; high bits that a manager has not are 0
  localparam int unsigned AxiDataW = BusW == 0 ? MemoryW : BusW;
  localparam logic [3:0] AxiCache = 4'b0010;  // normal, not cached, not buffered: an answer means "in memory"
  localparam logic [2:0] AxiProt = 3'b000;  // unprivileged, secure, data
  localparam logic [1:0] AxiIncr = 2'b01;
  typedef struct packed {  // AR, AW
    logic [AxiIdW-1:0] id;
    logic [AxiAddrW-1:0] addr;
    logic [7:0] len;  // beats, less one
    logic [2:0] size;
    logic [1:0] burst;
    logic [3:0] cache;
    logic [2:0] prot;
  } axi_address_t;
  typedef struct packed {
    logic [AxiIdW-1:0] id;
    logic [AxiDataW-1:0] data;
    logic [1:0] resp;
    logic last;
  } axi_r_t;
  typedef struct packed {
    logic [AxiDataW-1:0] data;
    logic [AxiDataW/8-1:0] strb;
    logic last;
  } axi_w_t;
  typedef struct packed {
    logic [AxiIdW-1:0] id;
    logic [1:0] resp;
  } axi_b_t;
  typedef struct packed {
    axi_address_t ar;
    logic ar_valid;
    logic r_ready;
  } axi_reads_t;
  typedef struct packed {
    logic ar_ready;
    axi_r_t r;
    logic r_valid;
  } axi_reads_answer_t;
  typedef struct packed {
    axi_address_t aw;
    logic aw_valid;
    axi_w_t w;
    logic w_valid;
    logic b_ready;
  } axi_writes_t;
  typedef struct packed {
    logic aw_ready;
    logic w_ready;
    axi_b_t b;
    logic b_valid;
  } axi_writes_answer_t;
  typedef struct packed {
    axi_writes_t write;
    axi_reads_t read;
  } axi_manager_t;
  typedef struct packed {
    axi_writes_answer_t write;
    axi_reads_answer_t read;
  } axi_subordinate_t;

  typedef struct packed {  // what the manager waits for, of reads or of writes
    logic [AddressW-1:0] line;  // of one that is not taken or not answered
    logic located;  // it is known
    logic moves;  // something is taken or answered in this cycle
    logic waits;  // something is not
  } memory_wait_t;

  // AXI4-Lite of the registers, 32 bits, without the protection bits, which nothing looks at.
  typedef struct packed {
    logic [ControlAddressW-1:0] aw_addr;  // byte; its two low bits do not count
    logic aw_valid;
    logic [31:0] w_data;
    logic [3:0] w_strb;
    logic w_valid;
    logic b_ready;
    logic [ControlAddressW-1:0] ar_addr;  // likewise
    logic ar_valid;
    logic r_ready;
  } axi_lite_manager_t;
  typedef struct packed {
    logic aw_ready;
    logic w_ready;
    logic [1:0] b_resp;
    logic b_valid;
    logic ar_ready;
    logic [31:0] r_data;
    logic [1:0] r_resp;
    logic r_valid;
  } axi_lite_subordinate_t;

  typedef struct packed {  // in an SU: an end that waits for what lies before it
    logic all;  // the whole set, not only nearer buckets
    logic [KindW-1:0] kind;
    logic [BucketW-1:0] bucket;
  } su_mark_t;
  typedef struct packed {  // in an SU: slots of one bucket, linked, or an end
    logic [KindW-1:0] kind;
    logic [BucketW-1:0] bucket;
    logic [RecordW-1:0] head;  // the first slot
    logic [RecordW:0] count;
  } su_chain_t;
  typedef struct packed {  // in an SU: keys of a set that spilled come back into the pool
    logic write;
    logic [RecordW-1:0] slot;
    logic [KeyW-1:0] key;
    logic [SlotW-1:0] number;  // its record's, in external memory
    logic read;  // of the key in read_slot
    logic [RecordW-1:0] read_slot;
  } su_external_t;
  typedef struct packed {  // in an SU: such keys, to be sorted in the pool; linked from the last slot to the first
    logic [RecordW:0] count;
    logic [KeyW-1:0] min;
    logic [KeyW-1:0] max;
  } su_group_t;
  typedef struct packed {  // in an SU: a sorted key, or an end with its kind as slot
    logic is_end;
    logic [KeyW-1:0] key;
    logic [RecordW-1:0] slot;
  } su_item_t;
)";

// The division of the overflow area, see areas.hpp: its C++ twin reads the same table.
void print_areas(const pipegs::Config& c) {
  using pipegs::Area;
  static constexpr const char* kNames[] = {"AreaKeys", "AreaMerged", "AreaRuns", "AreaRecords",
                                           "AreaEven", "AreaOdd",    "AreaLists"};
  constexpr const char* kHead =
      "  function automatic logic [AddressW-1:0] {}(input logic [AddressW-1:0] size, {}input logic [2:0] area);\n";
  std::printf("\n  // Parts of an overflow area of `size` lines: see cpp_model/areas/areas.hpp.\n");
  for (const Area area : pipegs::kAllAreas) {
    std::printf("  localparam logic [2:0] %s = 3'd%d;\n", kNames[static_cast<int>(area)], static_cast<int>(area));
  }
  const auto cases = [&](const char* function, const auto& value) {
    std::printf("%s    case (area)\n", fmt::format(fmt::runtime(kHead), function, "").c_str());
    for (const Area area : pipegs::kAllAreas) {
      std::printf("      %s: %s = %s;\n", kNames[static_cast<int>(area)], function, value(area).c_str());
    }
    std::printf("      default: %s = '0;\n    endcase\n  endfunction\n", function);
  };
  std::printf("  // lines of it\n");
  cases("area_lines", [&](Area area) { return fmt::format("size >> {}", pipegs::area_plan(c, area).lines_shift); });
  std::printf("  // its first line, from the first one of its unit's share on\n");
  cases("area_place", [&](Area area) -> std::string {
    const pipegs::AreaPlan plan = pipegs::area_plan(c, area);
    if (plan.times == 0) return "'0";
    const std::string part = fmt::format("(size >> {})", plan.place_shift);
    return plan.times == 1   ? part
           : plan.times == 2 ? fmt::format("{} << 1", part)
                             : fmt::format("({0} << 1) + {0}", part);
  });
  const int share = pipegs::area_share_shift(c);
  std::printf("  // its first line, from the first one of all on; lists have no unit\n%s",
              fmt::format(fmt::runtime(kHead), "area_first", "input logic [UnitW-1:0] unit,\n      ").c_str());
  std::printf("    area_first = %s(unit[0] ? size >> %d : '0) +", c.has_lists() ? "(size >> 1) + " : "", share);
  for (int bit = 1; bit < c.unit_w(); ++bit) {
    std::printf(" (unit[%d] ? (size >> %d) << %d : '0) +", bit, share, bit);
  }
  std::printf("\n");
  std::printf("                 area_place(size, area);\n    if (area == AreaLists) area_first = '0;\n  endfunction\n");
  std::printf(
      "  // the first line of a window's list, from the first one of all on, where each has 2^log lines\n"
      "  function automatic logic [AddressW-1:0] list_first(input logic [ListWindowW-1:0] window,\n"
      "      input logic [$clog2(ListEntryW+1)-1:0] log);\n"
      "    list_first = (AddressW'(window) << log) + AddressW'(window) * AddressW'(ListGap);\n  endfunction\n");
}

void print_stages(const pipegs::Config& config) {
  std::printf("\n  // Stages of a PU on pu_phases: see cpp_model/pu/stages.def.\n");
  const std::vector<pipegs::PuStage> stages = pipegs::pu_stages(config);
  for (const pipegs::PuStage& stage : stages) {
    const bool other = std::ranges::any_of(stages, [&](const auto& s) { return s.name == stage.name && s.built; });
    if (stage.depth == 0 || (other && !stage.built)) continue;
    const auto print = [&](const char* what, int value) {
      print_line(fmt::format("  localparam int unsigned {:<14} = {};", std::string(stage.camel_name) + what, value),
                 "");
    };
    print("Depth", stage.depth);
    print("Claim", stage.claim);
  }
}

void print_package(const pipegs::Config& config) {
  std::printf(
      "// SPDX-License-Identifier: Apache-2.0\n"
      "// pipegs_pkg: widths, counts, capacities, records and registers of the machine. Printed by\n"
      "// cpp_model/package_sv.cpp from config.def, records.def and control/registers.def of cpp_model (`make "
      "package`):\n"
      "// change those, never this file.\n"
      "//\n// Configuration: %s.   Model  cpp_model/config.hpp, cpp_model/records.hpp\n"
      "// Fixed point is written sI.F / uI.F; the first field of a record lies in its low bits.\n\n"
      "package pipegs_pkg;\n\n",
      pipegs::config_difference(config).c_str());
  const Printer printer(config);
  for (const pipegs::ConfigEntry& entry : pipegs::config_entries(config)) printer.print(entry);
  std::printf(
      "\n  // What a beat of a stream is.\n"
      "  localparam logic [1:0] KindData = 2'd0;\n  localparam logic [1:0] KindLayerEnd = 2'd1;\n"
      "  localparam logic [1:0] KindWindowEnd = 2'd2;\n  localparam logic [1:0] KindPartEnd = 2'd3;\n"
      "\n  // What a unit does in a cycle, see pipegs_perf: starved has nothing to do, blocked waits for who takes its "
      "output.\n"
      "  localparam logic [1:0] PerfBusy = 2'd0;\n  localparam logic [1:0] PerfStarved = 2'd1;\n"
      "  localparam logic [1:0] PerfBlocked = 2'd2;\n  localparam logic [1:0] PerfMemory = 2'd3;\n");
  print_exp2_table(config);
  print_entries("CullWeights", pipegs::kCullWeights, 9,
                "Weights of a Gaussian's reach, u1.8, by the six leading bits of -log2(opacity). See "
                "cpp_model/pu/front/pu_cull.hpp.",
                pipegs::cull_weight, config);
  print_entries("ReachWeights", pipegs::kCullWeights, 13,
                "Their squares for pu_reach, u1.12. See cpp_model/pu/front/pu_reach.hpp.", pipegs::reach_weight,
                config);
  print_entries("OpacityCodes", pipegs::kMostOpacity + 1, config.opacity_w(),
                "-log2(opacity), u4.OpacityF, of each code. See cpp_model/pu/front/pu_decode.hpp.",
                pipegs::opacity_of_code, config);
  print_entries("ScaleSteps", pipegs::kScaleSteps, config.scale_m_w, "Mantissas of the sixteenths of an octave.",
                pipegs::scale_step, config);
  for (const Record& record : pipegs::record_table()) printer.print(record);
  print_stages(config);
  print_areas(config);
  std::printf("%s", pipegs::print_package(pipegs::register_map(config)).c_str());
  std::printf("%s\nendpackage\n", kBundles);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc == 3 && std::string_view(argv[1]) == "--corner") {
      const auto seed = pipegs::parse_integer<uint64_t>(argv[2]);
      std::printf("%s\n", pipegs::config_arguments(pipegs::config_corner(seed)).c_str());
      return 0;
    }
    pipegs::Config config;
    for (int i = 1; i < argc; ++i) pipegs::config_set(config, argv[i]);
    pipegs::config_check(config);
    print_package(config);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "package_sv: %s\n", error.what());
    return 2;
  }
}
