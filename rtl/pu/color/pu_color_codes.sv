// SPDX-License-Identifier: Apache-2.0
// pu_color_codes: the SH coefficients of one step out of codes (Record = 48), as the mantissas that they stand for.
//
// Idea    Half a line, or at degree 1 an eighth of it, begins with the exponent. Above degree 1 each band's distance
//         from it follows, and a band's codes are shifted down by so much: they are the upper bits of mantissas.
//         Functions that the scene's degree has not give zeros.
// Stream  Combinational.
// Pace    One step per cycle.
// Model   sh_mantissas() in cpp_model/pu/color/sh_code.hpp

module pu_color_codes (
  input  logic [pipegs_pkg::KindW-1:0]    sh_degree_i,  // of the scene
  input  logic [1:0]                      degree_i,     // that is evaluated
  input  logic [2:0]                      step_i,       // two functions: 2 step_i and the one behind it
  input  logic [pipegs_pkg::QuarterW-1:0] quarter_i,    // of the line, at degree 1
  input  logic [pipegs_pkg::MemoryW-1:0]  line_i,
  output logic [6*pipegs_pkg::ShMW-1:0]   pair_o,       // three channels of one function, then of the other; signed
  output logic [pipegs_pkg::ShEW-1:0]     exponent_o    // that they share
);

  localparam int unsigned CoefW   = pipegs_pkg::ShMW;
  localparam int unsigned ExpW    = pipegs_pkg::ShEW;
  localparam int unsigned HalfW   = pipegs_pkg::MemoryW / 2;
  localparam int unsigned EighthW = pipegs_pkg::MemoryW / 8;
  localparam int unsigned DropW   = pipegs_pkg::ShDropW;
  localparam int unsigned Code1W  = pipegs_pkg::ShBand1W;
  localparam int unsigned Code2W  = pipegs_pkg::ShBand2W;
  localparam int unsigned ThreeW  = 3 * Code1W;        // three channels of one function
  localparam int unsigned Drops   = ExpW + 3 * DropW;  // where the codes begin, above degree 1
  localparam int unsigned Band2   = Drops + 9 * Code1W;
  localparam int unsigned Places  = 16;                // of functions: 15, and none

  typedef struct packed {logic [Places-1:0][ThreeW-1:0] of;} codes_t;
  typedef struct packed {logic [2:0][DropW-1:0] of;} shifts_t;  // of each band, its codes to mantissas
  typedef struct packed {logic [1:0][ThreeW-1:0] of;} code_pair_t;
  typedef struct packed {logic [1:0][DropW-1:0] of;} shift_pair_t;
  typedef struct packed {logic [5:0][CoefW-1:0] of;} pair_t;
  logic               one;  // degree of the scene
  logic [HalfW-1:0]   half;
  logic [EighthW-1:0] eighth;
  codes_t             codes;
  shifts_t            shifts;
  code_pair_t         code_pair;
  shift_pair_t        shift_pair;
  pair_t              pair;

  assign one        = sh_degree_i == pipegs_pkg::KindW'(1);
  assign half       = (one ? quarter_i[2] : quarter_i[0]) ? line_i[HalfW +: HalfW] : line_i[0 +: HalfW];
  assign eighth     = half[EighthW*32'(quarter_i[1:0]) +: EighthW];
  assign exponent_o = one ? eighth[ExpW-1:0] : half[ExpW-1:0];
  assign pair_o     = pair;

  always_comb begin
    for (int unsigned band = 0; band < 3; band += 1) begin
      shifts.of[band] = DropW'(CoefW - (band == 0 ? Code1W : Code2W));
      if (!one) begin
        if (half[ExpW+DropW*band +: DropW] > shifts.of[band]) shifts.of[band] = '0;
        else shifts.of[band] = shifts.of[band] - half[ExpW+DropW*band +: DropW];
      end
    end
    codes = '0;
    for (int unsigned n = 0; n < 3; n += 1) begin
      codes.of[n] = one ? eighth[ExpW+n*ThreeW +: ThreeW] : half[Drops+n*ThreeW +: ThreeW];
    end
    for (int unsigned n = 3; n < Places - 1; n += 1) begin
      for (int unsigned c = 0; c < 3; c += 1) begin
        codes.of[n][c*Code1W +: Code1W] = Code1W'($signed(half[Band2+(3*(n-3)+c)*Code2W +: Code2W]));
      end
    end
    if (degree_i == 2'd1) codes.of[3] = '0;  // bands hold 3, 8 and 15 functions
    code_pair  = '0;
    shift_pair = '0;
    for (int unsigned i = 0; i < Places; i += 1) begin
      if (step_i == 3'(i / 2)) begin
        code_pair.of[i%2]  = codes.of[i];
        shift_pair.of[i%2] = shifts.of[i < 3 ? 0 : i < 8 ? 1 : 2];
      end
    end
    for (int unsigned i = 0; i < 6; i += 1) begin
      pair.of[i] = CoefW'($signed(code_pair.of[i/3][i%3*Code1W +: Code1W])) << shift_pair.of[i/3];
    end
  end

endmodule
