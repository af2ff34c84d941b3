// SPDX-License-Identifier: Apache-2.0
// frames.cpp: see frames.hpp.
#include "sim/studies/rivals/pixels/frames.hpp"

#include <algorithm>
#include <stdexcept>

#include "cpp_model/float/parallel.hpp"

namespace pipegs {
namespace {

// By index in the scene, whether it touches a tile of the view.
std::vector<uint8_t> seen_in(const PixelView& view, size_t gaussians) {
  std::vector<uint8_t> seen(gaussians, 0);
  for (const SeenGaussian& s : view.seen.gaussians) seen[s.index] = 1;
  return seen;
}

double depth_in(const Camera& camera, const Scene& scene, uint32_t index) {
  return (camera.world_to_camera * (glm::dvec3(scene.gaussians[index].mean) - camera.position)).z;
}

}  // namespace

std::vector<uint32_t> stale_order(const Scene& scene, const PixelView& now, const PixelView& last, Newcomers rule) {
  const std::vector<uint8_t> seen = seen_in(last, scene.gaussians.size());
  struct Turn {
    bool behind;
    double depth;
    uint32_t index, place;
  };
  std::vector<Turn> turns;
  for (uint32_t place = 0; place < now.seen.gaussians.size(); ++place) {
    const SeenGaussian& s = now.seen.gaussians[place];
    const bool behind = rule == Newcomers::kSeen && seen[s.index] == 0;
    turns.push_back({behind, behind ? s.depth : depth_in(last.camera, scene, s.index), s.index, place});
  }
  std::sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) {
    return std::tie(a.behind, a.depth, a.index) < std::tie(b.behind, b.depth, b.index);
  });
  std::vector<uint32_t> order;
  for (const Turn& turn : turns) order.push_back(turn.place);
  return order;
}

double newcomers(const PixelView& now, const PixelView& last, size_t gaussians) {
  const std::vector<uint8_t> seen = seen_in(last, gaussians);
  size_t all = 0, fresh = 0;
  for (const SeenGaussian& s : now.seen.gaussians) {
    if (s.reach.empty()) continue;
    ++all;
    fresh += seen[s.index] == 0;
  }
  return all == 0 ? 0 : static_cast<double>(fresh) / static_cast<double>(all);
}

Sequences SortedTables::next(const PixelView& view, const Sequences& exact, unsigned threads) {
  if (exact.side != kTableSide) throw std::invalid_argument("tables: sequences of another grid");
  tables_.resize(exact.places.size());
  Sequences sequences{kTableSide, {}};
  sequences.places.resize(exact.places.size());
  parallel_for(tables_.size(), threads,
               [&](size_t t) { sequences.places[t] = update(view, exact.places[t], tables_[t]); });
  ++frame_;
  last_ = view.camera;
  return sequences;
}

std::vector<uint32_t> SortedTables::update(const PixelView& view, const std::vector<uint32_t>& exact,
                                           std::vector<Entry>& table) const {
  const auto by_depth = [](const Entry& a, const Entry& b) {
    return a.depth != b.depth ? a.depth < b.depth : a.index < b.index;
  };
  struct Here {
    uint32_t index, place;
    bool operator<(const Here& o) const { return index < o.index; }
  };
  std::vector<Here> here;  // by index
  for (const uint32_t place : exact) here.push_back({view.seen.gaussians[place].index, place});
  std::sort(here.begin(), here.end());
  std::vector<uint32_t> known;
  for (const Entry& entry : table) known.push_back(entry.index);
  std::sort(known.begin(), known.end());

  size_t end = frame_ % 2 == 1 ? chunk_ : chunk_ / 2;
  for (size_t begin = 0; begin < table.size(); begin = end, end += chunk_) {
    const auto at = [&](size_t k) { return table.begin() + static_cast<std::ptrdiff_t>(std::min(k, table.size())); };
    std::sort(at(begin), at(end), by_depth);
  }
  std::vector<Entry> incoming, merged;
  for (const uint32_t place : exact) {
    const SeenGaussian& s = view.seen.gaussians[place];
    if (std::binary_search(known.begin(), known.end(), s.index)) continue;
    const bool old = ages_ == Ages::kEven && frame_ > 0;
    incoming.push_back({s.index, old ? depth_in(last_, scene_, s.index) : s.depth});
  }
  std::sort(incoming.begin(), incoming.end(), by_depth);
  // Two heads are compared, whether or not the table behind its head is in order.
  auto next = incoming.begin();
  for (const Entry& entry : table) {
    while (next != incoming.end() && by_depth(*next, entry)) merged.push_back(*next++);
    merged.push_back(entry);
  }
  merged.insert(merged.end(), next, incoming.end());

  std::vector<uint32_t> places;
  table.clear();
  for (const Entry& entry : merged) {
    const auto found = std::lower_bound(here.begin(), here.end(), Here{entry.index, 0});
    if (found == here.end() || found->index != entry.index) continue;
    places.push_back(found->place);
    table.push_back({entry.index, view.seen.gaussians[found->place].depth});
  }
  return places;
}

}  // namespace pipegs
