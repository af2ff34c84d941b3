import re
def sub(f,a,b,n=1):
    s=open(f).read()
    assert s.count(a)>=1,(f,a)
    s=s.replace(a,b) if n==0 else s.replace(a,b,n)
    open(f,"w").write(s)
T="sim/timing/"
# --- knobs
open(T+"knobs.hpp","w").write('''#pragma once
#include <cstdlib>
namespace pipegs {
inline int knob(const char* name, int none) { const char* v = std::getenv(name); return v ? std::atoi(v) : none; }
inline int x_occ() { static const int v = knob("X_OCC", 0); return v; }        // 1: chunks and groups, 2: + Gaussians before the PUs
inline int x_pace() { static const int v = knob("X_PACE", 8); return v; }
inline int x_cpace() { static const int v = knob("X_CPACE", 8); return v; }
inline int x_split() { static const int v = knob("X_SPLIT", 1 << 30); return v; }    // Gaussians of a window from which it is four walks
inline int x_split2() { static const int v = knob("X_SPLIT2", 1 << 30); return v; }  // of a part, from which it is four walks of 32
inline int x_nobehind() { static const int v = knob("X_NOBEHIND", 0); return v; }
inline int x_grow() { static const int v = knob("X_GROW", 0); return v; }  // regions that a chunk's rectangle is too large on each side
inline int x_oracle() { static const int v = knob("X_ORACLE", 0); return v; }
}
''')
# --- beats
sub(T+"cycle.hpp","kWindowEndBeat = 0xffffffff, kBubble = 0xfffffffd;","kWindowEndBeat = 0xffffffff, kPartEndBeat = 0xfffffffd, kBubble = 0xfffffffc;")
sub(T+"cycle.hpp","return beat >= kLayerEndBeat; }","return beat >= kPartEndBeat; }")
# --- trace
f=T+"trace/trace.hpp"
sub(f,"  uint16_t bucket = 0;     // of depth, order 2\n","  uint16_t bucket = 0;     // of depth, order 2\n  RegionSet box;\n  uint32_t gaussians = 0;\n")
sub(f,"  uint16_t bucket = 0;\n};","  uint16_t bucket = 0;\n  RegionSet box;\n};")
sub(f,"  size_t first_chunk = 0, chunks = 0;  ","  size_t window = 0;\n  int part = -1;  // of the window, -1: all\n  RegionSet rect;\n  bool last = true;  // of its window\n  size_t first_chunk = 0, chunks = 0;  ")
sub(f,"  std::vector<uint8_t> dropped;  //","  std::vector<RegionSet> reach_box;  // by survivor\n  std::vector<uint8_t> dropped;  //")
f=T+"trace/trace.cpp"
sub(f,'#include "sim/timing/trace/trace_splat.hpp"\n','#include "sim/timing/trace/trace_splat.hpp"\n#include "sim/timing/knobs.hpp"\n#include "cpp_model/pu/front/pu_cull.hpp"\n#include "cpp_model/pu/front/pu_reach.hpp"\n#include "cpp_model/pu/conic/pu_coeff.hpp"\n#include "cpp_model/pu/conic/pu_intersect.hpp"\n#include "cpp_model/su/su.hpp"\n')
sub(f,"  TimingWalk walk;\n  TimingWindow window;","  std::vector<TimingWalk> walks;\n  TimingWalk walk;\n  std::vector<RegionSet> reach_box;\n  TimingWindow window;")
sub(f,"    config_.has_watermarks() ? ranked() : slabs();\n","""    if (config_.has_watermarks()) {
      layers_.emplace_back();
      plan();
    } else {
      slabs();
      part_.walk.rect = ~RegionSet{};
      part_.walk.chunks = part_.chunks.size();
      part_.walks.push_back(std::move(part_.walk));
    }
""")
sub(f,"  // In the order of the tables, with buckets of depth.\n  void ranked() {\n    layers_.emplace_back();\n","""  uint64_t count(const Planes& planes) const {  // Gaussians of the chunks that pass
    uint64_t sum = 0;
    for (const Node& cell : packed_.cells) {
      if (cell.count == 0 || !dopu_test(config_, frame_, planes, cell, dopu_depth_edge(config_, frame_, 0))) continue;
      const int cb = dopu_depth(config_, frame_, planes, cell, 0);
      for (uint64_t g = cell.first; g < cell.first + cell.count; ++g) {
        const Node& group = packed_.groups[g];
        if (!dopu_test(config_, frame_, planes, group, dopu_depth_edge(config_, frame_, cb))) continue;
        sum += group.count * static_cast<uint64_t>(config_.chunk);
      }
    }
    return sum;
  }
  void sub(int side, int sx, int sy, int part, RegionSet rect) {
    side_ = side, sx_ = sx, sy_ = sy;
    rect_ = rect;
    sub_ = config_;
    sub_.window = side;
    planes_ = dopu_planes(sub_, frame_, sx, sy);
    part_.walk = {};
    part_.walk.first_chunk = part_.chunks.size();
    part_.walk.part = part;
    part_.walk.rect = rect;
    part_.walk.last = false;
    ranked();
    part_.walk.chunks = part_.chunks.size() - part_.walk.first_chunk;
    part_.walks.push_back(std::move(part_.walk));
  }
  void plan() {
    const auto width = static_cast<int>(frame_.raster.width), height = static_cast<int>(frame_.raster.height);
    if (config_.window == 128 && count(planes_) > static_cast<uint64_t>(x_split())) {
      for (int p = 0; p < 4; ++p) {
        const int px = 2 * x_ + (p & 1), py = 2 * y_ + (p >> 1);
        if (px * 64 >= width || py * 64 >= height) continue;
        Config c64 = config_;
        c64.window = 64;
        RegionSet whole;
        whole.mask[static_cast<size_t>(p)] = ~uint64_t{0};
        if (count(dopu_planes(c64, frame_, px, py)) > static_cast<uint64_t>(x_split2())) {
          for (int q = 0; q < 4; ++q) {
            const int qx = 2 * px + (q & 1), qy = 2 * py + (q >> 1);
            if (qx * 32 >= width || qy * 32 >= height) continue;
            RegionSet rect;
            for (int y = 0; y < 4; ++y)
              rect.mask[static_cast<size_t>(p)] |= uint64_t{0xf} << (8 * (4 * (q >> 1) + y) + 4 * (q & 1));
            sub(32, qx, qy, p, rect);
          }
        } else {
          sub(64, px, py, p, whole);
        }
      }
    } else {
      sub(config_.window, x_, y_, -1, ~RegionSet{});
    }
    part_.walks.back().last = true;
  }

  // In the order of the tables, with buckets of depth.
  void ranked() {
""")
sub(f,"        part_.walk.groups_ranked.push_back({static_cast<uint32_t>(g), static_cast<uint32_t>(part_.chunks.size()),\n                                            static_cast<uint16_t>(group_bucket)});\n        chunks(group, group_bucket);",
"""        part_.walk.groups_ranked.push_back({static_cast<uint32_t>(g), static_cast<uint32_t>(part_.chunks.size()),
                                            static_cast<uint16_t>(group_bucket), {}});
        const size_t at = part_.chunks.size();
        chunks(group, group_bucket);
        for (size_t i = at; i < part_.chunks.size(); ++i) part_.walk.groups_ranked.back().box |= part_.chunks[i].box;
        part_.walk.groups_ranked.back().box = rectangle(part_.walk.groups_ranked.back().box, x_grow());""")
sub(f,"                                         static_cast<uint16_t>(cell_bucket)});","                                         static_cast<uint16_t>(cell_bucket), ~RegionSet{}});")
sub(f,"  void chunks(const Node& group, int group_bucket) {","""  // The rectangle around regions, `grow` larger on each side.
  RegionSet rectangle(const RegionSet& of, int grow) const {
    int x0 = 99, x1 = -1, y0 = 99, y1 = -1;
    for (int r = 0; r < config_.regions(); ++r) {
      if (!of.has(config_, r)) continue;
      x0 = std::min(x0, region_x(config_, r)), x1 = std::max(x1, region_x(config_, r));
      y0 = std::min(y0, region_y(config_, r)), y1 = std::max(y1, region_y(config_, r));
    }
    RegionSet result;
    if (x1 < 0) return result;
    const int most = config_.window / 8 - 1;
    for (int y = std::max(0, y0 - grow); y <= std::min(most, y1 + grow); ++y)
      for (int x = std::max(0, x0 - grow); x <= std::min(most, x1 + grow); ++x) result.add(config_, region_at(config_, x, y));
    return result;
  }
  std::optional<GoldenConic> conic_of(const Chunk& chunk, uint64_t slot, bool* late) const {
    Gap gap;
    std::optional<Visible> visible =
        pu_cull(sub_, frame_, golden_fetched(chunk, packed_.gaussians[slot], slot), nullptr, &gap);
    if (!visible) return std::nullopt;
    *late = config_.tight_cull && !pu_reach(sub_, frame_, *visible, gap);
    if (*late) return std::nullopt;
    visible->window_x = static_cast<uint64_t>(x_), visible->window_y = static_cast<uint64_t>(y_);
    return golden_conic(config_, frame_, *visible);
  }
  void chunks(const Node& group, int group_bucket) {""")
sub(f,"      const Chunk chunk = dopu_origin(config_, frame_, node, x_, y_);","      const Chunk chunk = dopu_origin(config_, frame_, node, sx_, sy_);")
sub(f,"                       static_cast<uint16_t>(own_bucket)};","                       static_cast<uint16_t>(own_bucket), {}, static_cast<uint32_t>(chunk.count)};")
sub(f,"trace_conic(input_, chunk, chunk.slot + k, &dropped);","sub_conic(chunk, chunk.slot + k, &dropped);")
sub(f,"sub_conic(chunk","config_.has_watermarks() ? conic_of(chunk, chunk.slot + k, &dropped) : trace_conic(input_, chunk")
sub(f,"        part_.dropped.push_back(dropped);","        part_.dropped.push_back(dropped);\n        part_.reach_box.emplace_back();")
sub(f,"""        part_.pairs.push_back(static_cast<uint32_t>(parts.size()));
        for (const PuPart& one : parts) {
          const TracePair pair = trace_pair(input_, one.conic, found->payload, one.part);
""","""        uint32_t number = 0;
        RegionSet box;
        for (const PuPart& one : parts) {
          if (rect_.mask[one.part] == 0) continue;
          ++number;
          TracePair pair = trace_pair(input_, one.conic, found->payload, one.part);
          if (~rect_.mask[one.part] != 0) {
            pair.splat.mask &= rect_.mask[one.part];
            if (pair.boxes != 0)
              pair.boxes = static_cast<uint8_t>(std::max(1, std::min<int>(pair.boxes, (std::popcount(pair.splat.mask) + 2) / 2)));
          }
          box.mask[one.part] |= pair.splat.mask;
""")
sub(f,"          if (pair.splat.mask != 0) layers_.back().push_back(pair.splat);\n        }\n","          if (pair.splat.mask != 0) layers_.back().push_back(pair.splat);\n        }\n        part_.pairs.push_back(number);\n        box = rectangle(box, 0);\n        part_.reach_box.back() = box;\n        sent.box |= box;\n")
sub(f,"      part_.chunks.push_back(sent);","      sent.box = rectangle(sent.box, x_grow());\n      part_.chunks.push_back(sent);")
sub(f,"  const Planes planes_;\n","  Planes planes_;\n  Config sub_ = config_;\n  int side_ = 0, sx_ = x_, sy_ = y_;\n  RegionSet rect_ = ~RegionSet{};\n")
sub(f,"""    part.walk.first_chunk = chunks;
    part.walk.chunks = part.chunks.size();
    for (TimingParent& group : part.walk.groups_ranked) group.first += chunks;
""","""    for (TimingWalk& walk : part.walks) {
      walk.first_chunk += chunks;
      walk.window = trace.windows.size();
      for (TimingParent& group : walk.groups_ranked) group.first += chunks;
      trace.walks.push_back(std::move(walk));
    }
    trace.reach_box.insert(trace.reach_box.end(), part.reach_box.begin(), part.reach_box.end());
""")
sub(f,"    trace.walks.push_back(std::move(part.walk));\n","")
sub(f,"#include <algorithm>\n","#include <algorithm>\n#include <bit>\n#include <optional>\n")
# --- DOPU
f=T+"dopu/dopu_item.hpp"
sub(f,"  size_t window = 0;\n","  size_t window = 0;  // a walk\n  RegionSet open;\n")
f=T+"dopu/dopu.cpp"
sub(f,"""    bool done = sets_[s].valid && !m.config.has_lists();
    for (const Ru& ru : m.ru) done = done && ru.window() == sets_[s].window && ru.all_done();
""","""    bool done = sets_[s].valid && !m.config.has_lists();
    if (done) {
      const TimingWalk& walk = m.trace.walks[sets_[s].window];
      RegionSet closed;
      for (const Ru& ru : m.ru) {
        if (ru.window() == walk.window) closed |= ru.done();
      }
      sets_[s].open = ~closed & walk.rect;
      if (walk.part < 0) {
        for (const Ru& ru : m.ru) done = done && ru.window() == walk.window && ru.all_done();
      } else {
        for (const Ru& ru : m.ru) done = done && ru.window() == walk.window;
        RegionSet outside = m.trace.windows[walk.window].outside;
        done = done && (sets_[s].open & ~outside) == RegionSet{};
      }
    }
""")
sub(f,"  emit_chunk_.end = shifted_.end;","  emit_chunk_.end = shifted_.end;",1) if False else None
sub(f,"    emit_chunk_.end = shifted_.end;","    emit_chunk_.end = shifted_.end == kWindowEndBeat && nearest_ && !m.trace.walks[shifted_.node].last ? kPartEndBeat : shifted_.end;")
f=T+"dopu/nearest.cpp"
sub(f,"    out_.end = kWindowEndBeat;","    out_.end = kWindowEndBeat;\n    out_.node = static_cast<uint32_t>(sets[out_.set].window);")
sub(f,"  is.load_popped = queue_->out() && queue_->list() >= 4 && !is.done;","  is.load_popped = queue_->out() && queue_->list() >= 4 && !is.done &&\n                   !closed(trace_.chunks_sent[queue_->node().number].box, sets[sent]);")
sub(f,"        queue_->out() && queue_->list() >> 1 == l && !sets[static_cast<size_t>(queue_->list() & 1)].done;",
"""        queue_->out() && queue_->list() >> 1 == l && !sets[static_cast<size_t>(queue_->list() & 1)].done &&
        !(l == 1 && closed(trace_.walks[sets[static_cast<size_t>(queue_->list() & 1)].window].groups_ranked[queue_->node().number].box,
                           sets[static_cast<size_t>(queue_->list() & 1)]));""")
sub(f,"    return {last, true, {walk.groups_ranked[cursor].bucket, cursor}};","    return {last, !closed(walk.groups_ranked[cursor].box, sets[static_cast<size_t>(set_[static_cast<size_t>(level)])]), {walk.groups_ranked[cursor].bucket, cursor}};")
sub(f,"  return {last, true, {trace_.chunks_sent[cursor].bucket, cursor}};","  return {last, !closed(trace_.chunks_sent[cursor].box, sets[static_cast<size_t>(set_[static_cast<size_t>(level)])]), {trace_.chunks_sent[cursor].bucket, cursor}};")
f=T+"dopu/nearest.hpp"
sub(f,"  bool dropped(const DopuSets& sets) const {","""  static bool closed(const RegionSet& box, const DopuSet& set) {
    return x_occ() > 0 && set.valid && (box & set.open) == RegionSet{};
  }
  bool dropped(const DopuSets& sets) const {
    if (out_.end == 0 && out_.chunk != nullptr && !shown_ && closed(out_.chunk->box, sets[out_.set])) return true;""")
sub(f,'#include "cpp_model/config.hpp"\n','#include "cpp_model/config.hpp"\n#include "sim/timing/knobs.hpp"\n')
# set.open must hold from the first cycle of a set
sub(T+"dopu/dopu.cpp","    set.valid = set.fresh = true;","    set.valid = set.fresh = true;\n    set.open = ~RegionSet{};")
# --- PU
f=T+"pu/pu_front.cpp"
sub(f,"  const auto dropped = [&] { return !is_end(reach_.front()) && m.trace.dropped[reach_.front()] != 0; };","""  const auto dropped = [&] {
    if (is_end(reach_.front())) return false;
    if (m.trace.dropped[reach_.front()] != 0) return true;
    if (x_occ() < 2 || reach_offered_) return false;
    RegionSet shut;
    for (const Ru& ru : m.ru) {
      if (ru.window() == front_window_) shut |= ru.done();
    }
    return (m.trace.reach_box[reach_.front()] & ~shut) == RegionSet{};
  };""")
sub(f,"    reach_.pop(now);\n    reach_offered_ = false;","    if (reach_.front() == kWindowEndBeat) ++front_window_;\n    reach_.pop(now);\n    reach_offered_ = false;")
sub(f,"unit(lists_ || has_parts_ ? kExpand : kCoeff, lane_), 5, 3);","unit(lists_ || has_parts_ ? kExpand : kCoeff, lane_), x_pace() == 8 ? 5 : x_pace() == 4 ? 2 : 1, x_pace() == 8 ? 3 : x_pace() == 4 ? 2 : 1);")
sub(f,"       unit(kIntersect, lane_), 3, 5);","       unit(kIntersect, lane_), x_pace() == 8 ? 3 : x_pace() == 4 ? 2 : 1, x_pace() == 8 ? 5 : x_pace() == 4 ? 2 : 1);")
sub(T+"pu/pu.hpp","  size_t window_ = 0;  // of the beats","  size_t front_window_ = 0;\n  size_t window_ = 0;  // of the beats")
sub(T+"pu/pu.hpp",'#include "sim/timing/pu/rows.hpp"\n','#include "sim/timing/pu/rows.hpp"\n#include "sim/timing/knobs.hpp"\n')
sub(T+"pu/phases.hpp","      stage.begin = row.begin, stage.free = row.free, stage.length = row.result;","""      stage.begin = row.begin, stage.free = row.free, stage.length = row.result;
      if (x_pace() < 8 && row.begin + row.free == 8) {
        stage.begin = std::min(row.begin, x_pace() == 4 ? 1 + (row.begin - 1) / 2 : 1);
        stage.free = x_pace() - stage.begin;
        stage.length = row.begin + row.result - stage.begin;
      }""")
sub(T+"pu/phases.hpp",'#include "sim/timing/cycle.hpp"\n','#include "sim/timing/cycle.hpp"\n#include "sim/timing/knobs.hpp"\n')
f=T+"pu/color.cpp"
sub(f,"                                : 7),","                                : x_cpace() - 1),")
sub(f,'#include <algorithm>\n','#include <algorithm>\n#include "sim/timing/knobs.hpp"\n')
# --- SU
f=T+"su/su.cpp"
sub(f,"(!marks_cut_ || is.in->beat == kWindowEndBeat);","(!marks_cut_ || is.in->beat != kLayerEndBeat);")
sub(T+"ru/ru_order.cpp","m.su[0].head().splat.beat == kLayerEndBeat;","m.su[0].head().splat.beat != kWindowEndBeat;")
f=T+"su/su_spill.cpp"
sub(f,"  const bool writes = behind_ == 0;","  const bool writes = behind_ == 0 || x_nobehind() != 0;")
sub(f,'#include <algorithm>\n','#include <algorithm>\n#include "sim/timing/knobs.hpp"\n')
