// SPDX-License-Identifier: Apache-2.0
// su_range: the smallest and the largest sort key of a bucket.
//
// Idea    The bucket's step is the leading part of all its depth keys. With watermarks the first and the last bucket
//         also hold all that is nearer and farther.
// Stream  bucket_i, octave_i -> min_o, max_o. Combinational.
// Model   su_bucket_range in cpp_model/su/su.hpp

module su_range (
  input  logic [pipegs_pkg::ExpW-1:0]    octave_i,
  input  logic [pipegs_pkg::BucketW-1:0] bucket_i,
  output logic [pipegs_pkg::KeyW-1:0]    min_o,
  output logic [pipegs_pkg::KeyW-1:0]    max_o
);

  localparam int unsigned StepW = pipegs_pkg::StepW;
  localparam int unsigned KeyW = pipegs_pkg::KeyW;
  localparam int unsigned LowW = KeyW - StepW;

  logic [StepW-1:0] step, low, high;
  logic             first, last;

  if (pipegs_pkg::HasWatermarks) begin : gen_near
    assign step  = StepW'(bucket_i) + (StepW'(octave_i) << pipegs_pkg::BucketBits);
    assign first = bucket_i == '0;
    assign last  = bucket_i == '1;
  end else begin : gen_all
    assign step  = bucket_i;
    assign first = 1'b0;
    assign last  = 1'b0;
    logic unused_octave;
    assign unused_octave = &{1'b0, octave_i};
  end
  // LowW may be 0: the step is the whole key.
  assign low   = first ? StepW'(0) : step;
  assign high  = last ? {StepW{1'b1}} : step;
  assign min_o = KeyW'(low) << LowW;
  assign max_o = (KeyW'(high) << LowW) | ~({KeyW{1'b1}} << LowW);

endmodule
