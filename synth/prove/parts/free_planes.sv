// SPDX-License-Identifier: Apache-2.0
// free_planes: stands for rtl/dopu/dopu_planes.sv: any planes at any time, one set for each window.
//
// Idea    Of the real one the proof `dopu_planes` says: one window inside at most, planes only for a window that was
//         taken, and what is shown stays until taken. Nothing else is known here.

module dopu_planes (
  input  logic                                clk_i,
  input  logic                                rst_ni,

  input  pipegs_pkg::rotation_t               rotation_i,
  input  pipegs_pkg::lens_t                   lens_i,
  input  pipegs_pkg::raster_t                 raster_i,

  input  logic                                window_valid_i,
  output logic                                window_ready_o,
  input  logic [pipegs_pkg::PlaceW-1:0]       window_i,
  input  logic [pipegs_pkg::ClosedBits-1:0]   closed_i,

  output logic                                planes_valid_o,
  input  logic                                planes_ready_i,
  output logic [5*pipegs_pkg::PlaneBits-1:0]  planes_o
);

  (* anyseq *) logic ready, valid;
  (* anyseq *) logic [5*pipegs_pkg::PlaneBits-1:0] any;
  logic inside_q;

  assign window_ready_o = ready;
  assign planes_valid_o = valid;
  assign planes_o       = any;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) inside_q <= 1'b0;
    else inside_q <= (window_valid_i && window_ready_o) || (inside_q && !(planes_valid_o && planes_ready_i));
  end
  always_comb begin
    assume (!rst_ni || !ready || !inside_q);
    assume (!rst_ni || !valid || inside_q);
  end
  proof_hold #(.DataW(5 * pipegs_pkg::PlaneBits), .Assumed(1'b1)) u_hold (
    .clk_i, .rst_ni, .valid_i(planes_valid_o), .ready_i(planes_ready_i), .beat_i(planes_o)
  );

  logic unused;
  assign unused = &{1'b0, rotation_i, lens_i, raster_i, window_i, closed_i};

endmodule
