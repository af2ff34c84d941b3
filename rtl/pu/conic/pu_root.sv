// SPDX-License-Identifier: Apache-2.0
// pu_root: the integer square root of a 28-bit number, two bits of the root per cycle.
//
// Idea    Digit by digit, from the top: two bits of the radicand give one bit of the root, a compare and a subtraction.
//           rest = 4 rest + two bits;   if (rest >= 4 root + 1) rest -= 4 root + 1, the new bit is 1
// Stream  load_i takes the radicand; each step_i makes two bits. The root holds until the next load or step.
// Pace    RootW / 2 = 7 steps.
// Model   cpp_model/pu/conic/pu_root.hpp

module pu_root #(
  localparam int unsigned RadicandW = 28,
  localparam int unsigned RootW     = RadicandW / 2
) (
  input  logic                 clk_i,

  input  logic                 load_i,
  input  logic                 step_i,
  input  logic [RadicandW-1:0] radicand_i,
  output logic [RootW-1:0]     root_o  // floor(sqrt(radicand))
);

  localparam int unsigned Digits = 2;           // bits of the root per step
  localparam int unsigned RestW  = RootW + 2;   // rest <= 2 root before the shift by two

  logic [RadicandW-1:0] radicand, radicand_q;
  logic [RootW-1:0]     root, root_q;
  logic [RestW-1:0]     rest, trial, rest_q;

  always_comb begin
    radicand = radicand_q;
    root     = root_q;
    rest     = rest_q;
    trial    = '0;
    for (int unsigned i = 0; i < Digits; i += 1) begin
      rest     = {rest[RestW-3:0], radicand[RadicandW-1:RadicandW-2]};
      radicand = {radicand[RadicandW-3:0], 2'b00};
      trial    = {root[RestW-3:0], 2'b01};
      root     = {root[RootW-2:0], rest >= trial};
      if (rest >= trial) rest = rest - trial;
    end
  end

  always_ff @(posedge clk_i) begin
    if (load_i) begin
      radicand_q <= radicand_i;
      root_q     <= '0;
      rest_q     <= '0;
    end else if (step_i) begin
      radicand_q <= radicand;
      root_q     <= root;
      rest_q     <= rest;
    end
  end

  assign root_o = root_q;

endmodule
