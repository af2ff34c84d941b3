// SPDX-License-Identifier: Apache-2.0
// event.hpp: what crosses a border between two units in a cycle, in one form for RTL and timing model.
//
// Idea    When the two differ in a cycle count, the first event that only one of them has names the place and the cycle
//         in which they part (lockstep.hpp).
#pragma once

#include <compare>
#include <cstdint>

namespace pipegs::timing {

// In the order of the data.
enum class Border : uint8_t {
  kRequest,  // of lines, to external memory; the lane is the port
  kChunk,    // DOPU -> PU
  kSplat,    // PU -> SU, or lists -> SU
  kSorted,   // merge -> RUs
  kLine,     // a line of alphas has gone into an RU's lanes, or with quads one into a group of them
  kLayer,    // an RU has blended a layer
};

struct TimingEvent {
  int64_t cycle = 0;
  Border border = Border::kRequest;
  uint8_t lane = 0;
  uint64_t what = 0;

  auto operator<=>(const TimingEvent&) const = default;
};

// TimingEvent::what: of a request; of a beat's splat by its sort key; of an end its kind. A chunk is 0.
constexpr uint64_t shown_request(uint64_t line, bool write, int lines) {
  return line << 4 | static_cast<uint64_t>(lines - 1) << 1 | (write ? 1 : 0);
}
constexpr uint64_t shown_splat(uint64_t key) { return key << 2; }
constexpr uint64_t shown_line(int region, int quarter) { return static_cast<uint64_t>(4 * region + quarter); }

}  // namespace pipegs::timing
