// SPDX-License-Identifier: Apache-2.0
// The end of rtl/dopu/dopu_planes.sv in its proof: one window in, one set of planes out, which stays until taken.
//
// Rule    What free_planes assumes: a window is taken only while none is inside, planes are shown only while one is,
//         and they stay.
// Assumes The frame stays while a window is inside.

logic inside_q;
pipegs_pkg::rotation_t rotation_before_q;
pipegs_pkg::lens_t     lens_before_q;
pipegs_pkg::raster_t   raster_before_q;
logic frame_stays;
assign frame_stays = rotation_i == rotation_before_q && lens_i == lens_before_q && raster_i == raster_before_q;

proof_reset u_proof_reset (.clk_i, .rst_ni);
proof_hold #(.DataW(5 * pipegs_pkg::PlaneBits)) u_hold (
  .clk_i, .rst_ni, .valid_i(planes_valid_o), .ready_i(planes_ready_i), .beat_i(planes_o)
);
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) inside_q <= 1'b0;
  else inside_q <= (window_valid_i && window_ready_o) || (inside_q && !(planes_valid_o && planes_ready_i));
end
always_ff @(posedge clk_i) begin
  rotation_before_q <= rotation_i;
  lens_before_q     <= lens_i;
  raster_before_q   <= raster_i;
end
always_comb begin
  assume (!rst_ni || !inside_q || frame_stays);
  if (rst_ni) begin
    assert (!window_ready_o || !inside_q);
    assert (!planes_valid_o || inside_q);
    assert (inside_q == (busy_q || done_q) && !(busy_q && done_q));
  end
end
