// SPDX-License-Identifier: Apache-2.0
// pu_alpha: the alpha code of a pixel from its power.
//
// Paper   Eq. 1 and Sec. 4.2.1; the cut at 1/AlphaCut (255) and the cap at 0.99 are those of the reference renderer.
// Idea    alpha = 2^power, opacity included: the integer part is a shift, the fraction goes through exp2.
//           power < -PowerCut -> code 0   (a compare: no exponential decides the cut)
//           power > 0         -> power 0  (rounding may lift the peak just above 0; it must not vanish)
// Stream  power_i in a cycle with enable_clamp_i; its code_o after one enable_clamp_i and one enable_exp_i edge.
// Pace    One pixel per cycle. Registers after the compare and after exp2's multiplier.
// Model   cpp_model/pu/rows/pu_alpha.hpp

module pu_alpha (
  input  logic                                 clk_i,

  input  logic                                 enable_clamp_i,
  input  logic                                 enable_exp_i,
  input  logic signed [pipegs_pkg::PowerW-1:0] power_i,  // s20.PowerF
  output logic [pipegs_pkg::AlphaW-1:0]        code_o    // u0.AlphaW
);

  localparam int unsigned PowerW = pipegs_pkg::PowerW;
  localparam int unsigned PowerF = pipegs_pkg::PowerF;
  localparam int unsigned ExpF   = pipegs_pkg::ExpF;
  localparam int unsigned OutW   = pipegs_pkg::ExpOutW;
  localparam int unsigned AlphaW = pipegs_pkg::AlphaW;
  localparam int unsigned WholeW = 4;              // the whole part of a visible power is 0 .. -10
  localparam int unsigned Drop   = OutW - 2 - AlphaW;  // the code's half bit moves to bit 0
  localparam int unsigned CodeW  = AlphaW + 2;

  logic              positive, visible;
  logic              visible_q, visible_exp_q;
  logic [WholeW-1:0] whole_q, whole_exp_q;         // minus the whole part
  logic [ExpF-1:0]   fraction_q;
  logic [OutW-1:0]   exponential, exponential_q;
  logic [CodeW-1:0]  halves, rounded;
  logic [AlphaW-1:0] capped;

  assign positive = !power_i[PowerW-1];
  assign visible  = positive | (PowerW'(~power_i) < PowerW'(pipegs_pkg::PowerCut));  // -1 - power < PowerCut

  always_ff @(posedge clk_i) begin
    if (enable_clamp_i) begin
      visible_q  <= visible;
      whole_q    <= positive ? '0 : -power_i[PowerF +: WholeW];
      fraction_q <= positive ? '0 : power_i[PowerF-1 -: ExpF];
    end
    if (enable_exp_i) begin
      visible_exp_q <= visible_q;
      whole_exp_q   <= whole_q;
      exponential_q <= exponential;
    end
  end

  exp2 u_exp2 (.fraction_i(fraction_q), .exponential_o(exponential));

  // The shift leaves one bit below the code; adding it rounds to nearest.
  assign halves  = CodeW'((exponential_q >> Drop) >> whole_exp_q);
  assign rounded = (halves >> 1) + CodeW'(halves[0]);

  // As masks, not as branches: whether a pixel is visible is hard to foresee, for a simulator's processor too.
  assign capped = rounded > CodeW'(pipegs_pkg::AlphaMax) ? AlphaW'(pipegs_pkg::AlphaMax) : rounded[AlphaW-1:0];
  assign code_o = (capped | AlphaW'(rounded == '0)) & {AlphaW{visible_exp_q}};

endmodule
