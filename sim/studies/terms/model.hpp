// SPDX-License-Identifier: Apache-2.0
// model.hpp: the ladder's four rungs on a view under a set of terms: cycles, and the quantities of Fig. 3, 8 and 9.
//
// Idea    Without layers: all preprocessing, then lists through SUs and RUs (run_pipeline); memory beside each phase.
//         With layers: PUs work on one while SUs and RUs have the one before (Sec. 4.1, double buffers).
//         A tile's list goes to one of four SUs and one of four RUs; a 64-px window has all of them, as in our RTL.
// Rule    Nothing is fitted: a set of terms gives its cycles from the view's counts and the DRAM's rates alone.
// Units   Cycles, bytes. Busy times of a kind of unit are those of all four over four.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "sim/studies/terms/view.hpp"

namespace pipegs {

// Cycles of a byte in each flow to and from memory, each played alone through the DRAM model (traffic.hpp).
struct MemoryRates {
  double scene = 0, list_write = 0, list_read = 0, alpha_write = 0, alpha_read = 0, pixels = 0;
};
MemoryRates memory_rates(const TermsView& view, const std::string& dram, double clock_ghz);

// Sorting and rasterization of a slice, without the PUs.
struct Passes {
  double cycles = 0, sort = 0, raster = 0;
  double ratio = std::numeric_limits<double>::quiet_NaN();  // raster over sort, mean of the lists that sort
};

struct RungTimes {
  double cycles = 0;
  double pre = 0, sort = 0, raster = 0;  // busy
  double front = 0;                      // before the first list is sorted
  double stall = 0;                      // without sorting and rasterization
  double ratio = std::numeric_limits<double>::quiet_NaN();
  double alpha_bytes = 0;  // that are computed
  double bytes = 0;        // over the pins, both ways
  // Share of PUs, SUs and RUs in which they do nothing, and of the frame in which a list's SU waits for its RU.
  double idle() const { return 1 - (pre + sort + raster) / (3 * cycles); }
  double gap() const { return (raster - sort) / cycles; }
};

struct TermsLadder {
  std::array<RungTimes, 4> rungs = {};
  const RungTimes& operator[](Rung rung) const { return rungs[static_cast<size_t>(rung)]; }
  double over(Rung slow, Rung fast) const { return (*this)[slow].cycles / (*this)[fast].cycles; }
};

class TermsModel {
 public:
  TermsModel(const TermsView& view, const MemoryRates& rates) : view_(view), rates_(rates) {}
  TermsLadder ladder(const Terms& terms);
  TermsLadder without_layers(const Terms& terms);  // Baseline, DPC and HGR alone
  // Of the frame; what many sets share is computed once.
  const Passes& passes(const Terms& terms, Rung rung);

 private:
  using Key = std::tuple<int, double, PixelSet, bool, SortPace, int>;  // side, cycles of a pixel, pixels, slices
  const std::vector<Passes>& all_passes(const Terms& terms, Rung rung, int grid);
  Passes passes_of(const Terms& terms, Rung rung, const Slice& slice) const;
  RungTimes serial(const Terms& terms, Rung rung);
  RungTimes layered(const Terms& terms);
  double front_cycles(const Terms& terms, const Slice& slice) const;
  double alpha_cycles(const Terms& terms, double pixels) const;
  double pu_cycles(const Terms& terms, double front, double alphas) const;
  double run_layers(const Terms& terms, RungTimes& times);
  double run_lists(const Terms& terms, RungTimes& times);

  const TermsView& view_;
  MemoryRates rates_;
  std::map<Key, std::vector<Passes>> known_;
};

}  // namespace pipegs
