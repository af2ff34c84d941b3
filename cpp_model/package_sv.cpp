// package_sv.cpp: prints rtl/pipegs_pkg.sv from config.def and records.def: `package_sv [key=value ...] > pipegs_pkg.sv`.
//
// The committed rtl/pipegs_pkg.sv is the default configuration, so rtl/ reads and builds on its own; a test compares it
// with this program's output. Other configurations get a package of their own in their build folder.
#include <cstdio>
#include <exception>
#include <map>

#include "cpp_model/config.hpp"
#include "cpp_model/lib/exp2.hpp"
#include "cpp_model/pu/pu_cull.hpp"

namespace {

struct Field {
  const char* name;
  const char* width;
  bool is_signed;
  const char* what;
};
struct Record {
  const char* name;
  const char* camel_name;
  std::vector<Field> fields;
};

const std::vector<Record>& records() {
  static const std::vector<Record> table = {
#define PIPEGS_RECORD(Name, name) {#name, #Name, {
#define FIELD_U(field, width, what) {#field, #width, false, what},
#define FIELD_S(field, width, what) {#field, #width, true, what},
#define PIPEGS_END(Name) }},
#include "cpp_model/records.def"
  };
  return table;
}

// The table of rtl/lib/exp2.sv: entry i is {0, delta, value}, entry 0 in the low bits. An entry fills a machine word, so
// that a simulator reads it with one load (1.7 times faster rows); synthesis drops the zeros.
void print_exp2_table(const pipegs::Config& config) {
  const pipegs::Exp2 table(config);
  const int last = (1 << config.exp_index_w) - 1, width = config.exp_delta_w() + config.exp_value_w() > 32 ? 64 : 32;
  std::printf("\n  // Chords of 2^f (delta 0: steps): entry i is {0, delta, value}, entry 0 lowest. See cpp_model/lib/exp2.hpp.\n"
              "  localparam int unsigned Exp2EntryW = %d;\n"
              "  localparam logic [%d*Exp2EntryW-1:0] Exp2Table = {",
              width, last + 1);
  for (int i = last; i >= 0; --i) {
    std::printf("%s%d'h%llx%s", (last - i) % 8 == 0 ? "\n    " : " ", width,
                static_cast<unsigned long long>(table.delta[i]) << config.exp_value_w() | table.value[i], i > 0 ? "," : "\n  };\n");
  }
}

// The table of rtl/pu/pu_cull.sv: weights of the reach by the leading bits of the opacity, entry 0 lowest.
void print_cull_weights(const pipegs::Config& config) {
  std::printf("\n  // Weights of a Gaussian's reach, u1.8, by the six leading bits of -log2(opacity). See cpp_model/pu/pu_cull.hpp.\n"
              "  localparam logic [%d*9-1:0] CullWeights = {",
              pipegs::kCullWeights);
  for (int i = pipegs::kCullWeights - 1; i >= 0; --i) {
    std::printf("%s9'd%llu%s", i % 16 == 15 ? "\n    " : " ", static_cast<unsigned long long>(pipegs::cull_weight(config, i)), i > 0 ? "," : "\n  };\n");
  }
}

void print_package(const pipegs::Config& config) {
  std::map<std::string_view, pipegs::ConfigEntry> entries;
  std::printf("// pipegs_pkg: widths, counts, capacities and records of the machine. Printed by cpp_model/package_sv.cpp from\n"
              "// cpp_model/config.def and cpp_model/records.def (`make package`): change those, never this file.\n"
              "//\n// Configuration: %s.   Model  cpp_model/config.hpp, cpp_model/records.hpp\n"
              "// Fixed point is written sI.F / uI.F; the first field of a record lies in its low bits.\n\n"
              "package pipegs_pkg;\n\n",
              pipegs::config_difference(config).c_str());
  for (const pipegs::ConfigEntry& entry : pipegs::config_entries(config)) {
    entries.emplace(entry.name, entry);
    std::printf("  localparam int unsigned %-14s = %d;  // %.*s\n", std::string(entry.camel_name).c_str(), entry.value,
                static_cast<int>(entry.what.size()), entry.what.data());
  }
  std::printf("\n  // What a beat of a stream is.\n"
              "  localparam logic [1:0] KindData = 2'd0;\n  localparam logic [1:0] KindLayerEnd = 2'd1;\n"
              "  localparam logic [1:0] KindWindowEnd = 2'd2;\n");
  print_exp2_table(config);
  print_cull_weights(config);
  for (const Record& record : records()) {
    int bits = 0;
    for (const Field& field : record.fields) bits += entries.at(field.width).value;
    std::printf("\n  typedef struct packed {\n");
    for (auto field = record.fields.rbegin(); field != record.fields.rend(); ++field) {
      const pipegs::ConfigEntry& width = entries.at(field->width);
      if (width.value == 0) continue;
      const std::string range = width.value == 1 && !field->is_signed ? "" : "[" + std::string(width.camel_name) + "-1:0] ";
      std::printf("    logic %s%s%s;%s%s\n", field->is_signed ? "signed " : "", range.c_str(), field->name,
                  *field->what ? "  // " : "", field->what);
    }
    std::printf("  } %s_t;\n  localparam int unsigned %sBits = %d;\n", record.name, record.camel_name, bits);
  }
  std::printf("\nendpackage\n");
}

}  // namespace

int main(int argc, char** argv) {
  try {
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
