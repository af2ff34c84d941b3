// SPDX-License-Identifier: Apache-2.0
// pu_record: the back of a PU that makes lists of records with coefficients: a record is what pu_intersect gives.
//
// Paper   the reproduced GSCore of Sec. 5 (baseline): rasterization computes alphas from the record.
// Idea    Wires: A to F and the mask come with the tiles, what the list needs beside them.
// Stream  tiles in; splat and its window's number out, in the same cycle.
// Pace    One record per cycle.
// Model   golden_lists in cpp_model/golden.cpp

module pu_record #(
  localparam int unsigned NumberW = pipegs_pkg::ListWindowW
) (
  input  pipegs_pkg::tiles_t  tiles_i,
  input  pipegs_pkg::listed_t listed_i,  // of the Gaussian in tiles_i
  output pipegs_pkg::splat_t  splat_o,
  output logic [NumberW-1:0]  number_o   // of the splat's window
);

  always_comb begin
    splat_o.kind  = tiles_i.kind;
    splat_o.depth = listed_i.depth;
    splat_o.index = listed_i.index;
    splat_o.mask  = tiles_i.mask;
    splat_o.red   = listed_i.red;
    splat_o.green = listed_i.green;
    splat_o.blue  = listed_i.blue;
    splat_o.a     = tiles_i.a;
    splat_o.b     = tiles_i.b;
    splat_o.c     = tiles_i.c;
    splat_o.d     = tiles_i.d;
    splat_o.e     = tiles_i.e;
    splat_o.f     = tiles_i.f;
  end
  assign number_o = listed_i.window;

endmodule
