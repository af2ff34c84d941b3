// SPDX-License-Identifier: Apache-2.0
// dopu_depth: the step of depth of a number: exponent and leading mantissa bits of its depth key.
//
// Paper   None.
// Idea    A depth key is a float of the view depth: six exponent bits, then the mantissa. Its exponent and first bits
//         of mantissa name its step. Steps rise with the number, so the step of a lower bound of depths is a lower
//         bound of their steps. Numbers below one world unit are in step 0.
// Stream  None: value_i * 2^(exponent_i - Down) world units in, the step out.
// Pace    Combinational.
// Model   cpp_model/dopu/nearest/dopu_depth.hpp (dopu_depth_step)

module dopu_depth #(
  parameter int unsigned ValueW = 42,
  parameter int unsigned Down = 18,
  localparam int unsigned ExpW = pipegs_pkg::ExpW,
  localparam int unsigned StepW = pipegs_pkg::StepW
) (
  input  logic signed [ValueW-1:0]     value_i,
  input  logic        [ExpW-1:0]       exponent_i,
  output logic        [StepW-1:0]      step_o
);

  localparam int unsigned StepBits = pipegs_pkg::BucketBits;
  localparam int unsigned HighW = ExpW + 2;

  logic [ValueW+StepBits-2:0] wide;      // the magnitude above StepBits zeros
  logic [HighW-1:0]           position;  // of the leading one
  logic signed [HighW-1:0]    high;
  logic [StepBits-1:0]        leading;

  assign wide = {value_i[ValueW-2:0], {StepBits{1'b0}}};
  always_comb begin
    position = '0;
    leading  = '0;
    for (int unsigned i = 0; i < ValueW - 1; i += 1) begin
      if (value_i[i]) begin
        position = HighW'(i);
        leading  = wide[i +: StepBits];
      end
    end
  end
  assign high   = $signed(position + HighW'(exponent_i) - HighW'(Down));
  assign step_o = value_i[ValueW-1] || value_i == '0 || high[HighW-1] ? '0 : {high[ExpW-1:0], leading};

  logic unused_high;  // no depth has so many bits
  assign unused_high = high[HighW-2];

endmodule
