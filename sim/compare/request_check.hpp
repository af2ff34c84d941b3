// SPDX-License-Identifier: Apache-2.0
// request_check.hpp: which lines of external memory each requester of the core may touch while it renders a frame.
//
// Idea    Every port has its areas: nodes, geometry and colours are read and nothing else; a unit writes what overflows
//         into its own share, and reads what it keeps there; pixels go to the picture. A request that leaves them reads
//         what is not meant for it, or overwrites what others rely on, though the picture may come out right.
// Units   Lines of external memory.
#pragma once

#include <string>
#include <vector>

#include "cpp_model/areas/frame_areas.hpp"
#include "cpp_model/golden.hpp"

namespace pipegs {

class RequestCheck {
 public:
  RequestCheck(const GoldenInput& input, const Areas& areas);

  bool allows(int tag, bool write, uint64_t line, int lines) const;
  // The lines that are allowed.
  std::string allowed(int tag, bool write) const;

 private:
  struct Port {
    std::vector<Span> reads, writes;
    const std::vector<Span>& of(bool write) const { return write ? writes : reads; }
  };
  std::vector<Port> ports_;
};

}  // namespace pipegs
