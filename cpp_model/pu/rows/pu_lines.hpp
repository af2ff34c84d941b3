// SPDX-License-Identifier: Apache-2.0
// pu_lines: gives each record of a list the lines of its alphas in external memory.
//
// Paper   TSPP (Sec. 3.1) without layers.        RTL  rtl/pu/rows/pu_lines.sv
// Idea    One line for each region of the mask, counted through the frame: address = {unit, lines given before}. All
//         lie in one area of external memory (ru_overflow_line in ru_walk.hpp).
// Stream  tiles in; row_job, splat and the number of its window out. An end passes; it takes no line.
#pragma once

#include <bit>

#include "cpp_model/records.hpp"

namespace pipegs {

struct PuLines {
  struct Out {
    RowJob row_job;
    Splat splat;
    uint64_t number;
  };

  PuLines(const Config& config, uint64_t unit) : base(unit << (config.alpha_address_w() - config.unit_w())) {}

  Out operator()(const Tiles& t, const Listed& listed) {
    const uint64_t address = base + lines;
    if (t.kind == kData) lines += static_cast<uint64_t>(std::popcount(t.mask));
    Out out;
    out.row_job = {t.kind, t.a, t.b, t.c, t.d, t.e, t.f, t.mask, address, 1, listed.index};
    out.splat.kind = t.kind, out.splat.depth = listed.depth, out.splat.index = listed.index, out.splat.mask = t.mask;
    out.splat.address = address, out.splat.ext = 1;
    out.splat.red = listed.red, out.splat.green = listed.green, out.splat.blue = listed.blue;
    out.number = listed.window;
    return out;
  }

  uint64_t base;
  uint64_t lines = 0;  // given in this frame; a new frame starts with a new PuLines
};

}  // namespace pipegs
