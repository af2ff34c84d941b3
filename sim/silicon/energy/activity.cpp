// SPDX-License-Identifier: Apache-2.0
// activity.cpp: see activity.hpp.
#include "sim/silicon/energy/activity.hpp"

#include <fmt/format.h>
#include <gtkwave/fstapi.h>

#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "scenes/input_error.hpp"

namespace pipegs {
namespace {

constexpr uint64_t kCycle = 10;                // units of time
constexpr uint32_t kWidest = 1u << 20;         // bits of a signal; more is a broken file
constexpr std::string_view kCore = "u_core";   // the instance of rtl/pipegs_top.sv
constexpr std::string_view kReset = "rst_ni";  // of the core, low when it resets

struct Signal {
  Switching* sum = nullptr;  // of its group; null when it is left out
  std::string value;         // the latest
  std::string before;        // what it was before the time of the latest change; kept when an enable depends on it
  uint64_t changed = 0;
  bool kept = false;
  bool placed = false;  // it has appeared in the core
  const std::string& sampled(uint64_t time) const { return changed == time ? before : value; }
};

// A signal of one bit, with what it was before the latest change: what an edge at that time has sampled.
struct Line {
  bool now = false, before = false;
  uint64_t changed = 0;
  bool sampled(uint64_t time) const { return changed == time ? before : now; }
};

struct Sram {
  fstHandle clock = 0, read = 0, write = 0;
  SramAccesses* accesses = nullptr;
};

// A name without that of the core, which is the outermost scope.
std::string below_top(const std::string& name) { return name.substr(name.find('.') + 1); }

class Reader {
 public:
  Reader(void* file, const std::filesystem::path& path, const std::function<std::string(const std::string&)>& group,
         const Enables& enables, const std::function<void(const Activity&)>& on_sample)
      : file_(file), on_sample_(on_sample), enables_(enables, group, activity_.enabled) {
    signals_.resize(fstReaderGetMaxHandle(file) + 1);
    if (!read_names(group))
      throw InputError(path.string(), "", fmt::format("expected waves of a machine with the scope {}", kCore));
    for (const uint32_t clock : enables_.clocks()) lines_[clock];
    activity_.unseen = enables_.unseen();
  }

  void change(uint64_t time, fstHandle handle, const unsigned char* text, uint32_t width) {
    if (handle >= signals_.size()) return;
    step(time);
    Signal& signal = signals_[handle];
    const std::string_view value(reinterpret_cast<const char*>(text), width);
    if (!first_ && signal.sum != nullptr && signal.value.size() == value.size()) {
      for (size_t i = 0; i < value.size(); ++i) signal.sum->toggles += value[i] != signal.value[i];
    }
    if (signal.kept && signal.changed != time) {
      signal.before.swap(signal.value);
      signal.changed = time;
    }
    signal.value = value;
    if (const auto found = lines_.find(handle); found != lines_.end()) {
      Line& line = found->second;
      line = {value == "1", line.now, time};
      if (!first_ && line.now && !line.before) rising_.push_back(handle);
    }
  }

  // The sample is over.
  void finish() {
    flush();
    enables_.finish();
    activity_.cycles = (phases_ + 1) / 2;
    phases_ = 0;
    if (activity_.cycles > 0) on_sample_(activity_);
    activity_.clear();
  }

 private:
  // To the next time of waves. Behind a gap it begins another sample, and what has changed in the gap is nobody's.
  void step(uint64_t time) {
    if (!begun_ || time > time_ + kCycle / 2) {
      if (begun_) finish();
      first_ = begun_ = true;
    } else if (time != time_) {
      flush();
      first_ = false;
      ++phases_;
    }
    time_ = time;
  }

  // What rose at the latest time has sampled what was there before. A reset moves flip-flops past closed gates, so no
  // enable is looked at in one, and the edge before it has none that follows.
  void flush() {
    const bool resets = reset_ != 0 && !lines_.at(reset_).sampled(time_);
    for (const fstHandle clock : rising_) {
      for (size_t i : srams_of_[clock]) {
        const Sram& sram = srams_[i];
        sram.accesses->reads += lines_.at(sram.read).sampled(time_);
        sram.accesses->writes += lines_.at(sram.write).sampled(time_);
      }
      for (uint64_t* edges : edges_of_[clock]) ++*edges;
      if (resets) continue;
      enables_.rise(clock, [&](uint32_t handle) -> const std::string& { return signals_[handle].sampled(time_); });
    }
    rising_.clear();
    if (reset_ != 0 && !lines_.at(reset_).now) enables_.finish();
  }

  // Whether the core is among the scopes. What stands around it, border and harness, is left out.
  bool read_names(const std::function<std::string(const std::string&)>& group) {
    struct Scope {
      std::string path;
      Switching* sum;
      std::map<std::string, std::pair<fstHandle, uint32_t>, std::less<>> ports;
      std::vector<std::pair<fstHandle, uint32_t>> own;  // signals that appear here first
    };
    std::vector<Scope> scopes;  // from the core down to the one that is read
    bool found = false;
    const auto leave = [&] {
      Scope& scope = scopes.back();
      const auto port = [&](const char* name) {
        const auto at = scope.ports.find(name);
        return at == scope.ports.end() ? fstHandle{0} : at->second.first;
      };
      if (const fstHandle clock = port("clk_o"); clock != 0) {
        lines_[clock];
        edges_of_[clock].push_back(&activity_.clocks[scope.path]);
      }
      const Sram sram = {port("clk_i"), port("read_i"), port("write_i"), nullptr};
      if (sram.clock != 0 && sram.read != 0 && sram.write != 0 && port("rdata_o") != 0) {
        SramAccesses& accesses = activity_.srams[scope.path];
        accesses.width = static_cast<int>(scope.ports["rdata_o"].second);
        for (const auto& [handle, bits] : scope.own) {  // its words are no nets between gates
          scope.sum->bits -= bits;
          signals_[handle].sum = nullptr;
        }
        for (const fstHandle line : {sram.clock, sram.read, sram.write}) lines_[line];
        srams_of_[sram.clock].push_back(srams_.size());
        srams_.push_back({sram.clock, sram.read, sram.write, &accesses});
      }
      scopes.pop_back();
    };
    while (const fstHier* item = fstReaderIterateHier(file_)) {
      if (item->htyp == FST_HT_SCOPE) {
        const std::string name = item->u.scope.name;
        if (scopes.empty() && name != kCore) continue;
        found = true;
        const std::string path = scopes.empty() ? name : scopes.back().path + "." + name;
        const std::string to = group(path);
        scopes.push_back({path, to.empty() ? nullptr : &activity_.groups[to], {}, {}});
      } else if (item->htyp == FST_HT_UPSCOPE && !scopes.empty()) {
        leave();
      } else if (item->htyp == FST_HT_VAR && !scopes.empty() && item->u.var.typ != FST_VT_VCD_PARAMETER) {
        const auto& var = item->u.var;
        if (var.length > kWidest || var.handle >= signals_.size()) throw std::length_error("a signal is too wide");
        std::string name = var.name;
        name = name.substr(0, name.find(' '));  // the range stands behind
        scopes.back().ports[name] = {var.handle, var.length};
        if (scopes.size() == 1 && name == kReset) lines_[reset_ = var.handle];
        Signal& signal = signals_[var.handle];
        if (enables_.declare(below_top(scopes.back().path + "." + name), var.handle, var.length)) signal.kept = true;
        if (std::exchange(signal.placed, true) || scopes.back().sum == nullptr) continue;
        signal.sum = scopes.back().sum;
        signal.sum->bits += var.length;
        scopes.back().own.emplace_back(var.handle, var.length);
      }
    }
    while (!scopes.empty()) leave();
    return found;
  }

  void* file_;
  const std::function<void(const Activity&)>& on_sample_;
  Activity activity_;  // of the sample; signals, clocks, SRAMs and enables point into it
  EnableSampler enables_;
  std::vector<Signal> signals_;
  std::vector<Sram> srams_;
  std::map<fstHandle, Line> lines_;
  std::map<fstHandle, std::vector<size_t>> srams_of_;
  std::map<fstHandle, std::vector<uint64_t*>> edges_of_;
  std::vector<fstHandle> rising_;
  fstHandle reset_ = 0;  // the core's; 0 if the waves have none
  uint64_t time_ = 0, phases_ = 0;
  bool begun_ = false, first_ = false;  // the time is the first of a sample: what the others are held against
};

void changed(void* reader, uint64_t time, fstHandle handle, const unsigned char* value, uint32_t width) {
  static_cast<Reader*>(reader)->change(time, handle, value, width);
}

void changed_short(void* reader, uint64_t time, fstHandle handle, const unsigned char* value) {
  changed(reader, time, handle, value,
          static_cast<uint32_t>(std::char_traits<char>::length(reinterpret_cast<const char*>(value))));
}

}  // namespace

void Activity::clear() {
  cycles = 0;
  for (auto& [name, group] : groups) group.toggles = 0;
  for (auto& [name, edges] : clocks) edges = 0;
  for (auto& [name, sram] : srams) sram.reads = sram.writes = 0;
  for (auto& [unit, modules] : enabled) {
    for (auto& [name, one] : modules) one = {0, std::vector<uint64_t>(one.passed.size())};
  }
}

void Activity::add(const Activity& more) {
  cycles += more.cycles;
  for (const auto& [name, group] : more.groups) groups[name] = {group.bits, groups[name].toggles + group.toggles};
  for (const auto& [name, edges] : more.clocks) clocks[name] += edges;
  for (const auto& [name, sram] : more.srams)
    srams[name] = {sram.width, srams[name].reads + sram.reads, srams[name].writes + sram.writes};
  for (const auto& [unit, modules] : more.enabled) {
    for (const auto& [name, one] : modules) {
      Enabled& sum = enabled[unit][name];
      sum.edges += one.edges;
      sum.passed.resize(one.passed.size());
      for (size_t i = 0; i < one.passed.size(); ++i) sum.passed[i] += one.passed[i];
    }
  }
  unseen = more.unseen;
}

void read_samples(const std::filesystem::path& fst, const std::function<std::string(const std::string& scope)>& group,
                  const Enables& enables, const std::function<void(const Activity&)>& on_sample) {
  const std::unique_ptr<void, void (*)(void*)> file(fstReaderOpen(fst.c_str()), [](void* f) {
    if (f != nullptr) fstReaderClose(f);
  });
  if (!file) throw InputError(fst.string() + ": expected waves (.fst)");
  Reader reader(file.get(), fst, group, enables, on_sample);
  fstReaderSetFacProcessMaskAll(file.get());
  if (fstReaderIterBlocks2(file.get(), changed_short, changed, &reader, nullptr) == 0)
    throw InputError(fst.string() + ": the waves are cut off");
  reader.finish();
}

Activity read_activity(const std::filesystem::path& fst,
                       const std::function<std::string(const std::string& scope)>& group, const Enables& enables) {
  Activity sum;
  read_samples(fst, group, enables, [&](const Activity& sample) { sum.add(sample); });
  return sum;
}

}  // namespace pipegs
