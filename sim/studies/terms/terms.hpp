// SPDX-License-Identifier: Apache-2.0
// terms.hpp: what must be assumed of a machine before its ladder has figures, each assumption with the paper's words.
//
// Paper   Sec. 5.3, Fig. 3, 8 and 9: the ladder Baseline, DPC, DPC+TSPP (HGR), DPC+TSPP+DOP.
// Idea    The paper gives counts of units, the names of their parts and speed-ups, but neither cycles nor what a lane
//         does in one. So each such thing is a field here with a small set of values. `our_terms` are those of our RTL;
//         `paper_terms` the set of the search (search.hpp) that is nearest to the paper's six figures on terrace.
// Units   Cycles; operations (an addition, multiplication or comparison of one pixel); pixels; bytes.
#pragma once

#include <array>
#include <iterator>
#include <string>
#include <vector>

namespace pipegs {

// Which pixels a Gaussian costs in a list.
enum class PixelSet {
  kSquareTiles,    // 256 for each 16-px tile of the 3-sigma square
  kOrientedTiles,  // 256 for each that the oriented box touches
  kOrientedParts,  // 64 for each 8x8 part of those that the oriented box touches: a 4-bit bitmap
  kExactParts,     // 64 for each 8x8 part with a pixel of alpha >= 1/255
  kReached,        // pixels with alpha >= 1/255, none else
};
inline constexpr int kWorks = 5;

// What a lane of an RU does in a cycle.
enum class LanePace {
  kPixel,   // a pixel, whatever that takes; as many lanes in every rung
  kArea,    // a pixel, but a rung has lanes in inverse proportion to its operations; 16 in the final design's RU
  kSerial,  // one operation; as many lanes in every rung
};

// How an SU sorts a list of n keys, p = passes of a splitter by 8 pivots until groups have 16: ceil(log8(n / 16)).
enum class SortPace {
  kWide,      // ceil(n / 16) (2 + p) cycles: MinMax Finder, Splitter and Sorter take 16 keys a cycle
  kSplitter,  // n (1 + p) + 10 ceil(n / 16): Finder and Splitter take a key a cycle, the Sorter a stage a cycle
  kCompare,   // n ceil(log2 n): a comparison a cycle, as few as there must be
  kNetwork,   // the bitonic network of the whole list, eight exchanges a cycle
  kExchange,  // the same, one exchange a cycle
  kRecords,   // kSplitter, and three cycles a key: two to take a record, one to send it, as our RTL's SU
};
inline constexpr int kKeySorts = 5;  // without kRecords

// What a Row Unit of a PU does in a cycle; there are 4 x 8.
enum class RowPace { kSerial, kOne, kTwo };  // one operation; one pixel; two pixels

// Where alphas wait from the PUs to the RUs.
enum class AlphaStore {
  kFree,    // on chip without limit
  kChip,    // as many as fit kChipBytes; the rest through memory. Without layers all of a frame waits.
  kMemory,  // through memory
};
inline constexpr double kChipBytes = 256 * 1024;  // four stores of 1024 lines of 64 alphas, of Table 2's 428 KB

struct Terms {
  int list = 16;                               // side of the tiles that have lists, pixels: 16 or 64
  PixelSet raster = PixelSet::kOrientedParts;  // that an RU computes in Baseline and DPC
  PixelSet active = PixelSet::kOrientedParts;  // for which the PUs compute alphas and the RUs blend, from TSPP on
  bool stop = true;                            // RUs leave out what is opaque
  LanePace lane = LanePace::kSerial;
  int exp = 16;  // operations of exponential and opacity
  SortPace sort = SortPace::kCompare;
  RowPace rows = RowPace::kOne;
  bool opaque = true;    // the PUs compute alphas of pixels that turn out opaque, too
  bool in_turn = false;  // a PU computes alphas after its projections, not beside them
  AlphaStore store = AlphaStore::kFree;
  int alpha_bytes = 1;
  bool dram = false;       // memory takes time
  bool packed = false;     // the records of our RTL, not 59 FP32 a Gaussian
  int pre = 8;             // cycles of a Gaussian in a PU
  bool all = true;         // for every Gaussian of the file, not only those in the frustum
  bool turns = false;      // `pre` for every 64-px window of a Gaussian, at least a cycle a region of its box
  bool by_window = false;  // all layers of a list before the next list, not all lists of a layer
  int grid = 4;            // N of the N x N x N grid
  bool operator==(const Terms&) const = default;
};

Terms our_terms();
Terms paper_terms();

// An assumption: how it reads, on what it stands, and what it says in a set.
struct Assumption {
  const char *key, *what;
  const char* words;  // the paper's, or that it is silent
  std::string (*value)(const Terms&);
  void (*take)(Terms& to, const Terms& from);
};
const std::vector<Assumption>& assumptions();
std::string describe(const Terms& terms);  // "key value, key value ..."

enum class Rung { kBaseline, kDpc, kHgr, kDop };
inline constexpr std::array<Rung, 4> kRungs = {Rung::kBaseline, Rung::kDpc, Rung::kHgr, Rung::kDop};
const char* rung_name(Rung rung);

// Operations of a pixel, counted: Power of Eq. 1 (7 multiplications, 4 additions), Eq. 3 in a 16x16 tile (2, and 8 for
// each row and 10 for each pair, shared by their pixels), Eq. 2 (T alpha, three products, three sums, 1 - alpha, T).
inline constexpr double kPowerOps = 11, kDpcOps = 2 + 8.0 / 16 + 10.0 / 256, kRowOps = 2 + 8.0 / 16, kBlendOps = 9;

// Operations of a pixel in an RU, and in a Row Unit, which has the coefficients of a Gaussian for all of its tiles.
double raster_ops(Rung rung, int exp);
inline double row_ops(int exp) { return kRowOps + exp; }

// Cycles of an SU. n of 0 or 1: none to sort, n cycles.
double sort_cycles(SortPace sort, double n);

}  // namespace pipegs
