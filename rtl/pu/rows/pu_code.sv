// SPDX-License-Identifier: Apache-2.0
// pu_code: the alpha code of a pixel from its clamped power.
//
// Paper   Eq. 1 and Sec. 4.2.1; the cap at 0.99 is that of the reference renderer.
// Idea    alpha = 2^power, opacity included. The whole part of the power is a shift, the fraction goes through
//         pipegs_exp2, behind which stands a register.
// Stream  exponent_i when enable_i; its code from the next cycle on. Rounded to nearest, 1 .. round(0.99 * 2^AlphaW),
//         0 where the pixel is not visible.
// Model   cpp_model/pu/rows/pu_alpha.hpp

module pu_code (
  input  logic                          clk_i,
  input  logic                          enable_i,
  input  pipegs_pkg::exponent_t         exponent_i,
  output logic [pipegs_pkg::AlphaW-1:0] code_o       // u0.AlphaW
);

  localparam int unsigned OutW   = pipegs_pkg::ExpOutW;
  localparam int unsigned AlphaW = pipegs_pkg::AlphaW;
  localparam int unsigned Drop   = OutW - 2 - AlphaW;  // the code's half bit moves to bit 0
  localparam int unsigned CodeW  = AlphaW + 2;

  logic                          visible_q;
  logic [pipegs_pkg::WholeW-1:0] whole_q;
  logic [OutW-1:0]               exponential, exponential_q;
  logic [CodeW-1:0]              halves, rounded;
  logic [AlphaW-1:0]             capped;

  pipegs_exp2 u_exp2 (
    .fraction_i(exponent_i.fraction),
    .exponential_o(exponential)
  );

  always_ff @(posedge clk_i) begin
    if (enable_i) begin
      visible_q     <= exponent_i.visible;
      whole_q       <= exponent_i.whole;
      exponential_q <= exponential;
    end
  end

  // The shift leaves one bit below the code; adding it rounds to nearest.
  assign halves  = CodeW'((exponential_q >> Drop) >> whole_q);
  assign rounded = (halves >> 1) + CodeW'(halves[0]);

  // As masks, not as branches: whether a pixel is visible is hard to foresee, for a simulator's processor too.
  assign capped = rounded > CodeW'(pipegs_pkg::AlphaMax) ? AlphaW'(pipegs_pkg::AlphaMax) : rounded[AlphaW-1:0];
  assign code_o = (capped | AlphaW'(rounded == '0)) & {AlphaW{visible_q}};

endmodule
