// SPDX-License-Identifier: Apache-2.0
// pipegs_exp2: 2^f for a fraction f, by a table of 2^ExpIndexW chords, or without chords (ExpLinear = 0).
//
// Paper   "applying exponential function to the power" (Sec. 4.2.1).
// Idea    f = (i + r / 2^R) / 2^ExpIndexW:   2^f ~ value[i] + delta[i] * r / 2^R
//
//           fraction   | i: ExpIndexW | r: R = ExpF - ExpIndexW |
//           exponential   value[i] << 1  +  (delta[i] * r) >> (R - 1)      u1.(ExpOutW-1), truncated
//
//         Without chords the value is that of the middle of its interval, and there is no multiplier.
//         The table is a constant of the package: pipegs_pkg::Exp2Table, entry i = {0, delta, value}.
// Stream  None: combinational; the user registers the result (one small multiplier and an adder).
// Model   cpp_model/lib/math/exp2.hpp

module pipegs_exp2 (
  input  logic [pipegs_pkg::ExpF-1:0]    fraction_i,    // u0.ExpF
  output logic [pipegs_pkg::ExpOutW-1:0] exponential_o  // u1.(ExpOutW-1)
);

  localparam int unsigned IndexW   = pipegs_pkg::ExpIndexW;
  localparam int unsigned RestW    = pipegs_pkg::ExpF - IndexW;
  localparam int unsigned DeltaW   = pipegs_pkg::ExpDeltaW;
  localparam int unsigned ValueW   = pipegs_pkg::ExpValueW;
  localparam int unsigned EntryW   = pipegs_pkg::Exp2EntryW;
  localparam int unsigned OutW     = pipegs_pkg::ExpOutW;
  localparam int unsigned ProductW = OutW + RestW;  // the leading bits are 0

  logic [IndexW-1:0] index;
  logic [RestW-1:0]  rest;
  logic [EntryW-1:0] entry;

  assign index = fraction_i[pipegs_pkg::ExpF-1 -: IndexW];
  assign rest  = fraction_i[RestW-1:0];
  assign entry = pipegs_pkg::Exp2Table[index*EntryW +: EntryW];
  if (pipegs_pkg::ExpLinear != 0) begin : gen_chord
    logic [ProductW-1:0] product;
    assign product       = ProductW'(entry[ValueW +: DeltaW]) * ProductW'(rest);
    assign exponential_o = {entry[ValueW-1:0], 1'b0} + OutW'(product >> (RestW - 1));
  end else begin : gen_step
    assign exponential_o = {entry[ValueW-1:0], 1'b0};
  end

  logic unused_bits;  // leading zeros of the entry; without chords the rest
  assign unused_bits = &{1'b0, entry, rest};

endmodule
