// SPDX-License-Identifier: Apache-2.0
// su_bucket: the bucket of a depth key: its octave and leading bits of its mantissa.
//
// Idea    With watermarks octaves are counted from the near plane's, so that 16 of them do: all that is nearer is in
//         the first bucket, all that is farther in the last one. Without them every exponent has its buckets.
// Stream  depth_i, octave_i -> bucket_o. Combinational.
// Model   su_bucket in cpp_model/su/su.hpp

module su_bucket (
  input  logic [pipegs_pkg::ExpW-1:0]    octave_i,  // in which the buckets begin; constant while a frame runs
  input  logic [pipegs_pkg::DepthW-1:0]  depth_i,
  output logic [pipegs_pkg::BucketW-1:0] bucket_o
);

  localparam int unsigned StepW = pipegs_pkg::StepW;
  localparam int unsigned BucketW = pipegs_pkg::BucketW;

  logic [StepW-1:0] step;
  assign step = depth_i[pipegs_pkg::DepthW-1 -: StepW];

  if (pipegs_pkg::HasWatermarks) begin : gen_near
    logic [StepW:0] beyond;
    assign beyond   = {1'b0, step} - ((StepW + 1)'(octave_i) << pipegs_pkg::BucketBits);
    assign bucket_o = beyond[StepW] ? '0 : beyond[StepW-1:BucketW] != '0 ? '1 : beyond[BucketW-1:0];
  end else begin : gen_all
    assign bucket_o = step;
    logic unused_octave;
    assign unused_octave = &{1'b0, octave_i};
  end

  logic unused_low;
  assign unused_low = &{1'b0, depth_i};

endmodule
