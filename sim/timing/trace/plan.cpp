// SPDX-License-Identifier: Apache-2.0
// plan.cpp: an experiment: which walks a window is, from a file; what would wait in the SUs in each of them.
//
// Plan    A line for a window: its number, then walks "W", "H0", "F3:40:128": variant, place, and the buckets of depth
//         from which to which it goes. Windows without a line are one walk.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>

#include "cpp_model/dopu/nearest/dopu_depth.hpp"
#include "sim/timing/trace/trace.hpp"

namespace pipegs {
namespace {

struct File {
  FILE* f;
  bool write;
  void raw(void* p, size_t n) {
    const size_t done = write ? std::fwrite(p, 1, n, f) : std::fread(p, 1, n, f);
    if (done != n) throw std::runtime_error("trace file is short");
  }
  template <class T> void operator()(T& v) { static_assert(std::is_trivially_copyable_v<T>); raw(&v, sizeof(T)); }
  template <class T> void operator()(std::vector<T>& v) {
    uint64_t n = v.size();
    raw(&n, 8);
    if (!write) v.resize(n);
    if constexpr (std::is_trivially_copyable_v<T>) {
      if (n != 0) raw(v.data(), n * sizeof(T));
    } else {
      for (T& one : v) (*this)(one);
    }
  }
  void operator()(TimingWalk& w) {
    (*this)(w.window), (*this)(w.part), (*this)(w.rect), (*this)(w.last), (*this)(w.variant), (*this)(w.place);
    (*this)(w.first_chunk), (*this)(w.chunks), (*this)(w.cells), (*this)(w.groups), (*this)(w.cells_ranked), (*this)(w.groups_ranked);
  }
  void operator()(TimingWindow& w) {
    (*this)(w.outside), (*this)(w.done_after), (*this)(w.quads_outside), (*this)(w.quad_done_after);
  }
  void all(TimingTrace& t) {
    (*this)(t.walks), (*this)(t.chunks_sent), (*this)(t.windows), (*this)(t.slot), (*this)(t.pairs), (*this)(t.reach_box), (*this)(t.dropped);
    (*this)(t.mask), (*this)(t.key), (*this)(t.boxes), (*this)(t.number), (*this)(t.survivor), (*this)(t.quads), (*this)(t.quads_first);
  }
};

int buckets(const TimingTrace& t) { return 1 << t.config.bucket_w(); }

// Bucket of depth of a pair, counted as the DOPU's.
int bucket_of(const TimingTrace& t, uint32_t pair) {
  const uint64_t depth = t.key[pair] >> (t.config.key_w() - t.config.depth_w);
  return std::clamp(static_cast<int>(depth >> (t.config.depth_w - t.config.step_w())) - dopu_depth_near(t.config, t.frame), 0, buckets(t) - 1);
}

struct Bounds { int first, end; };

// A copy of a walk with what lies in some buckets.
TimingWalk cut(TimingTrace& t, const TimingWalk& from, Bounds b) {
  TimingWalk walk = from;
  walk.first_chunk = t.chunks_sent.size();
  walk.chunks = 0;
  walk.cells_ranked.clear(), walk.groups_ranked.clear();
  const auto in = [&](const auto& node) { return node.bucket < b.end && node.far >= b.first; };
  for (size_t c = 0; c < from.cells_ranked.size(); ++c) {
    TimingParent cell = from.cells_ranked[c];
    const size_t g_end = c + 1 < from.cells_ranked.size() ? from.cells_ranked[c + 1].first : from.groups_ranked.size();
    if (!in(cell)) continue;
    const size_t first_group = cell.first;
    cell.first = static_cast<uint32_t>(walk.groups_ranked.size());
    cell.bucket = static_cast<uint16_t>(std::max<int>(cell.bucket, b.first));
    walk.cells_ranked.push_back(cell);
    for (size_t g = first_group; g < g_end; ++g) {
      TimingParent group = from.groups_ranked[g];
      if (!in(group)) continue;
      const size_t first = group.first, end = g + 1 < from.groups_ranked.size() ? from.groups_ranked[g + 1].first : from.first_chunk + from.chunks;
      group.first = static_cast<uint32_t>(t.chunks_sent.size());
      group.bucket = static_cast<uint16_t>(std::max<int>(group.bucket, b.first));
      walk.groups_ranked.push_back(group);
      for (size_t i = first; i < end; ++i) {
        TimingChunk chunk = t.chunks_sent[i];
        if (!in(chunk)) continue;
        const uint32_t old_first = chunk.first;
        const uint64_t old = chunk.survivors;
        chunk.first = static_cast<uint32_t>(t.slot.size());
        chunk.survivors = 0;
        chunk.bucket = static_cast<uint16_t>(std::max<int>(chunk.bucket, b.first));
        uint32_t s = old_first;
        for (uint64_t rest = old; rest != 0; rest &= rest - 1, ++s) {
          const uint32_t p0 = t.pairs[s], p1 = t.pairs[s + 1];
          int at = -1;
          for (uint32_t p = p0; p < p1; ++p)
            if (t.key[p] != 0) at = bucket_of(t, p);
          if (at >= 0 && (at < b.first || at >= b.end)) continue;
          chunk.survivors |= rest & -rest;
          const auto number = static_cast<uint32_t>(t.slot.size());
          t.slot.push_back(uint32_t{t.slot[s]});
          t.reach_box.push_back(RegionSet{t.reach_box[s]});
          t.dropped.push_back(uint8_t{t.dropped[s]});
          for (uint32_t p = p0; p < p1; ++p) {
            t.mask.push_back(uint64_t{t.mask[p]}), t.key.push_back(uint64_t{t.key[p]}), t.boxes.push_back(uint8_t{t.boxes[p]});
            t.number.push_back(uint16_t{t.number[p]}), t.survivor.push_back(number);
            t.quads_first.push_back(uint32_t{t.quads_first[p]});
          }
          t.pairs.push_back(static_cast<uint32_t>(t.mask.size()));
        }
        t.chunks_sent.push_back(chunk);
        ++walk.chunks;
      }
    }
  }
  return walk;
}

}  // namespace

void save_trace(const TimingTrace& trace, const char* name) {
  File file{std::fopen(name, "wb"), true};
  if (file.f == nullptr) return;
  file.all(const_cast<TimingTrace&>(trace));
  std::fclose(file.f);
}

bool load_trace(TimingTrace& trace, const char* name) {
  File file{std::fopen(name, "rb"), false};
  if (file.f == nullptr) return false;
  file.all(trace);
  std::fclose(file.f);
  return true;
}

void apply_plan(TimingTrace& t, const char* plan) {
  std::map<std::tuple<size_t, char, int>, size_t> at;
  bool variants = false;
  for (size_t i = 0; i < t.walks.size(); ++i) {
    at[{t.walks[i].window, t.walks[i].variant, t.walks[i].place}] = i;
    variants = variants || t.walks[i].variant != 'W';
  }
  std::vector<std::vector<std::string>> wanted(t.windows.size(), {"W"});
  if (plan != nullptr) {
    std::ifstream lines(plan);
    if (!lines) throw std::runtime_error(std::string("no plan ") + plan);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      size_t window;
      if (!(words >> window)) continue;
      wanted.at(window).clear();
      for (std::string word; words >> word;) wanted[window].push_back(word);
    }
  }
  std::vector<TimingWalk> walks;
  for (size_t w = 0; w < wanted.size(); ++w) {
    const size_t before = walks.size();
    for (const std::string& word : wanted[w]) {
      const size_t colon = word.find(':');
      const std::string place = word.substr(1, colon == std::string::npos ? colon : colon - 1);
      const auto found = at.find({w, word[0], place.empty() ? 0 : std::stoi(place)});
      if (found == at.end()) continue;
      if (colon == std::string::npos) {
        walks.push_back(t.walks[found->second]);
      } else {
        const size_t second = word.find(':', colon + 1);
        const TimingWalk from = t.walks[found->second];
        walks.push_back(cut(t, from, {std::stoi(word.substr(colon + 1)), std::stoi(word.substr(second + 1))}));
      }
      walks.back().last = false;
    }
    if (walks.size() == before) walks.push_back(t.walks[at.at({w, 'W', 0})]);
    walks.back().last = true;
  }
  t.walks = std::move(walks);
}

void dump_waits(const TimingTrace& t, const char* name) {
  const std::string base = name;
  FILE* list = std::fopen((base + ".walks").c_str(), "w");
  FILE* records = std::fopen((base + ".rec").c_str(), "wb");
  FILE* nodes = std::fopen((base + ".chk").c_str(), "wb");
  FILE* groups = std::fopen((base + ".grp").c_str(), "wb");
  const int nb = buckets(t);
  std::fprintf(list, "# buckets %d\n", nb);
  const auto put = [](FILE* f, std::initializer_list<int> values) {
    for (const int v : values) std::fwrite(&v, 4, 1, f);
  };
  for (size_t n = 0; n < t.walks.size(); ++n) {
    const TimingWalk& walk = t.walks[n];
    std::map<std::pair<int, int>, std::array<int, 2>> rec, chk;
    int64_t count = 0, gaussians = 0, survivors = 0, pairs = 0;
    const int w = static_cast<int>(n);
    for (const TimingParent& g : walk.groups_ranked) {
      const int c = static_cast<int>(t.groups[g.node].count) * t.config.chunk;
      count += c;
      put(groups, {w, g.bucket, g.far, c, static_cast<int>(g.weight * 256 + 0.5f)});
    }
    for (size_t i = walk.first_chunk; i < walk.first_chunk + walk.chunks; ++i) {
      const TimingChunk& c = t.chunks_sent[i];
      auto& cell = chk[{c.bucket, c.far}];
      ++cell[0], cell[1] += static_cast<int>(c.gaussians);
      gaussians += c.gaussians;
      uint32_t s = c.first;
      for (uint64_t rest = c.survivors; rest != 0; rest &= rest - 1, ++s) {
        ++survivors;
        for (uint32_t p = t.pairs[s]; p < t.pairs[s + 1]; ++p) {
          if (t.mask[p] == 0) continue;
          ++pairs;
          ++rec[{c.bucket, bucket_of(t, p)}][0];
        }
      }
    }
    for (const auto& [key, v] : rec) put(records, {w, key.first, key.second, v[0]});
    for (const auto& [key, v] : chk) put(nodes, {w, key.first, key.second, v[0], v[1]});
    std::fprintf(list, "%zu %zu %c %d %lld %zu %lld %lld %lld\n", n, walk.window, walk.variant, walk.place, static_cast<long long>(count), walk.chunks,
                 static_cast<long long>(gaussians), static_cast<long long>(survivors), static_cast<long long>(pairs));
  }
  FILE* loads = std::fopen((base + ".load").c_str(), "wb");
  for (size_t n = 0; n < t.walks.size(); ++n) {
    const TimingWalk& walk = t.walks[n];
    if (walk.variant != 'W' || !t.config.quads) continue;
    std::vector<uint32_t> hits(static_cast<size_t>(t.config.regions() * 16));
    for (size_t i = walk.first_chunk; i < walk.first_chunk + walk.chunks; ++i) {
      uint32_t s = t.chunks_sent[i].first;
      for (uint64_t rest = t.chunks_sent[i].survivors; rest != 0; rest &= rest - 1, ++s) {
        for (uint32_t p = t.pairs[s]; p < t.pairs[s + 1]; ++p) {
          uint32_t q = t.quads_first[p];
          for (uint64_t m = t.mask[p]; m != 0; m &= m - 1, ++q) {
            const auto r = static_cast<size_t>(region_number(t.config, t.part(p), std::countr_zero(m)));
            for (unsigned live = t.quads[q]; live != 0; live &= live - 1) ++hits[16 * r + static_cast<size_t>(std::countr_zero(live))];
          }
        }
      }
    }
    const TimingWindow& window = t.windows[walk.window];
    for (size_t i = 0; i < hits.size(); ++i) {
      hits[i] = std::min(hits[i], window.quad_done_after[i]);
      if (window.quads_outside[i / 16] >> (i % 16) & 1) hits[i] = 0;
    }
    std::fwrite(hits.data(), 4, hits.size(), loads);
  }
  std::fclose(loads);
  for (FILE* f : {list, records, nodes, groups}) std::fclose(f);
}

}  // namespace pipegs
