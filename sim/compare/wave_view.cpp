// SPDX-License-Identifier: Apache-2.0
// wave_view.cpp: see wave_view.hpp.
#include "sim/compare/wave_view.hpp"

#include <fmt/format.h>
#include <gtkwave/fstapi.h>

#include <memory>
#include <string>
#include <vector>

#include "scenes/atomic_file.hpp"
#include "scenes/own_failure.hpp"
#include "sim/rtl/rtl_model.hpp"

namespace pipegs {
namespace {

struct Signal {
  std::string name;  // as GTKWave writes it: TOP.tap_splat_o[31:0]
  uint32_t bits;
};

// A group of the view: signals whose name begins so.
struct Group {
  const char *title, *begin;
};
constexpr Group kGroups[] = {
    {"PU -> SU", "tap_splat"},      {"merge -> RU", "tap_sorted"},   {"window of the RUs", "tap_window_"},
    {"alphas -> RU", "tap_alphas"}, {"RU: T and RGB", "tap_pixels"}, {"states of the units", "tap_state"}};

constexpr int kOfBits = 0x28, kOfWords = 0x22, kTitle = 0x200;  // how GTKWave shows what follows: binary, hexadecimal

// What stands at the top of the waves.
std::vector<Signal> ports(const std::filesystem::path& waves) {
  const std::unique_ptr<void, void (*)(void*)> file(fstReaderOpen(waves.c_str()), [](void* f) {
    if (f != nullptr) fstReaderClose(f);
  });
  if (!file) throw OwnFailure(waves.string() + ": the waves that were written cannot be read");
  std::vector<Signal> found;
  int depth = 0;
  while (const fstHier* item = fstReaderIterateHier(file.get())) {
    if (item->htyp == FST_HT_SCOPE) ++depth;
    if (item->htyp == FST_HT_UPSCOPE) --depth;
    if (item->htyp != FST_HT_VAR || depth != 1) continue;
    std::string name = item->u.var.name;  // its range stands behind a blank
    std::erase(name, ' ');
    found.push_back({"TOP." + name, item->u.var.length});
  }
  return found;
}

}  // namespace

void write_wave_view(const std::filesystem::path& waves, std::optional<int64_t> marker) {
  const std::vector<Signal> all = ports(waves);
  std::string text = fmt::format("[dumpfile] \"{}\"\n", std::filesystem::absolute(waves).string());
  if (marker) text += fmt::format("[timestart] {}\n*-6.0 {} -1\n", *marker - 10 * kWaveTime, *marker);
  const auto add = [&](const std::string& begin) {
    for (const Signal& signal : all) {
      if (signal.name.starts_with("TOP." + begin))
        text += fmt::format("@{:x}\n{}\n", signal.bits == 1 ? kOfBits : kOfWords, signal.name);
    }
  };
  add("aclk");
  for (const Group& group : kGroups) {
    text += fmt::format("@{:x}\n-{}\n", kTitle, group.title);
    add(group.begin);
  }
  write_whole(std::filesystem::path(waves).replace_extension(".gtkw"), text);
}

}  // namespace pipegs
