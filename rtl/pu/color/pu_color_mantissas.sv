// SPDX-License-Identifier: Apache-2.0
// pu_color_mantissas: the SH coefficients of one step out of a line of mantissas (Record = 96).
//
// Idea    A line, or at degree 1 a quarter of it, begins with the exponent; 45 mantissas follow in the order of f_rest.
//         Steps that the scene's degree has no functions for give zeros.
// Stream  Combinational.
// Pace    One step per cycle.
// Model   sh_mantissas() in cpp_model/pu/color/sh_code.hpp

module pu_color_mantissas (
  input  logic [pipegs_pkg::KindW-1:0]    sh_degree_i,  // of the scene
  input  logic [1:0]                      degree_i,     // that is evaluated
  input  logic [2:0]                      step_i,       // two functions: 2 step_i and the one behind it
  input  logic [pipegs_pkg::QuarterW-1:0] quarter_i,    // of the line, at degree 1
  input  logic [pipegs_pkg::MemoryW-1:0]  line_i,
  output logic [6*pipegs_pkg::ShMW-1:0]   pair_o,       // three channels of one function, then of the other; signed
  output logic [pipegs_pkg::ShEW-1:0]     exponent_o    // that they share
);

  localparam int unsigned ExpW   = pipegs_pkg::ShEW;
  localparam int unsigned PairW  = 6 * pipegs_pkg::ShMW;
  localparam int unsigned Steps  = 8;
  localparam int unsigned Slot1W = pipegs_pkg::MemoryW / 4;

  typedef struct packed {logic [Steps-1:0][PairW-1:0] of;} coefs_t;
  logic [pipegs_pkg::MemoryW-1:0] slot;
  coefs_t                         coefs;

  always_comb begin
    slot = line_i;
    if (sh_degree_i == pipegs_pkg::KindW'(1)) begin
      for (int unsigned i = 1; i < 4; i += 1) begin
        if (quarter_i == pipegs_pkg::QuarterW'(i)) slot[Slot1W-1:0] = line_i[Slot1W*i +: Slot1W];
      end
    end
    coefs = (Steps*PairW)'(slot[pipegs_pkg::MemoryW-1:ExpW]);
    if (degree_i == 2'd1) coefs.of[1][PairW-1:PairW/2] = '0;        // bands hold 3, 8 and 15 functions
    if (degree_i == 2'd3) coefs.of[Steps-1][PairW-1:PairW/2] = '0;
    pair_o = '0;
    for (int unsigned i = 0; i < Steps; i += 1) if (step_i == 3'(i)) pair_o = coefs.of[i];
  end
  assign exponent_o = slot[ExpW-1:0];

  wire unused_slot = &{1'b0, slot};

endmodule
