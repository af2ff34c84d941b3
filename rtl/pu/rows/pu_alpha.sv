// SPDX-License-Identifier: Apache-2.0
// pu_alpha: the alpha code of a pixel from its power, in two steps.
//
// Paper   Eq. 1 and Sec. 4.2.1.
// Idea    power -> pu_clamp -> register -> pu_code, which has one more register.
// Stream  enable_clamp_i takes the power, enable_exp_i a cycle later what was clamped; then its code.
// Model   cpp_model/pu/rows/pu_alpha.hpp

module pu_alpha (
  input  logic                                 clk_i,

  input  logic                                 enable_clamp_i,
  input  logic                                 enable_exp_i,
  input  logic signed [pipegs_pkg::PowerW-1:0] power_i,  // s20.PowerF
  output logic [pipegs_pkg::AlphaW-1:0]        code_o    // u0.AlphaW
);

  pipegs_pkg::exponent_t exponent, exponent_q;

  pu_clamp u_clamp (
    .power_i,
    .exponent_o(exponent)
  );
  always_ff @(posedge clk_i) if (enable_clamp_i) exponent_q <= exponent;
  pu_code u_code (
    .clk_i,
    .enable_i(enable_exp_i),
    .exponent_i(exponent_q),
    .code_o
  );

endmodule
