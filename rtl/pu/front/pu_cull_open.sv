// SPDX-License-Identifier: Apache-2.0
// pu_cull_open: the sides of the rectangle around what is open of a walk, for the test of pu_cull.
//
// Paper   None: its windows are culled whole.
// Idea    What is closed at a side (pipegs_open, as it is known in stage 4) moves the side inwards by whole regions: 8
//         pixels times z for each. That of the near side is taken off its slack, which the test adds to it.
// Stream  Beside stages 4 to 7 of pu_cull: place4_i, z6_i and near_*6_i of the records in these stages; b*7 the far
//         sides times z, unit 2^-EdgeF; near_*7 the slack of the near ones, unit 2^-(EdgeF + ToEdge).
// Pace    pu_cull's: a Gaussian a cycle.
// Model   cpp_model/pu/front/pu_cull.hpp

module pu_cull_open #(
  parameter  int unsigned ZW      = 18,
  parameter  int unsigned NearW   = 40,
  parameter  int unsigned SideW   = 48,
  parameter  int unsigned EdgeF   = 4,
  parameter  int unsigned ToEdge  = 10,
  localparam int unsigned ClosedW = pipegs_pkg::ClosedW
) (
  input  logic                          clk_i,
  input  logic [2:0]                    load_i,  // of registers 5 to 7
  input  pipegs_pkg::open_t             open_i,
  input  logic [pipegs_pkg::PlaceW-1:0] place4_i,
  input  logic signed [ZW-1:0]          z6_i,
  input  logic signed [NearW-1:0]       near_x6_i,
  input  logic signed [NearW-1:0]       near_y6_i,
  input  logic signed [SideW-1:0]       bx7_i,
  input  logic signed [SideW-1:0]       by7_i,

  output logic signed [SideW-1:0]       near_x7_o,
  output logic signed [SideW-1:0]       near_y7_o,
  output logic signed [SideW-1:0]       bx7_o,
  output logic signed [SideW-1:0]       by7_o
);

  localparam int unsigned RegionF = 3 + EdgeF;  // of a region's side
  typedef struct packed {
    logic [ClosedW-1:0] left, right, top, bottom;
  } closed_t;

  closed_t                 closed4, closed5_q, closed6_q;
  logic signed [SideW-1:0] near_x7_q, near_y7_q, closed_x7_q, closed_y7_q;

  logic [4*ClosedW-1:0] closed;  // left, right, top, bottom
  pipegs_closed u_closed (
    .open_i,
    .place_i(place4_i),
    .closed_o(closed)
  );
  assign {closed4.bottom, closed4.top, closed4.right, closed4.left} = closed;

  function automatic logic signed [SideW-1:0] aside(input logic [ClosedW-1:0] regions, input logic signed [ZW-1:0] z);
    aside = ($signed(SideW'(regions)) * SideW'(z)) <<< RegionF;
  endfunction
  always_ff @(posedge clk_i) begin
    if (load_i[0]) closed5_q <= closed4;
    if (load_i[1]) closed6_q <= closed5_q;
    if (load_i[2]) begin
      near_x7_q   <= SideW'(near_x6_i) - (aside(closed6_q.left, z6_i) <<< ToEdge);
      near_y7_q   <= SideW'(near_y6_i) - (aside(closed6_q.top, z6_i) <<< ToEdge);
      closed_x7_q <= aside(closed6_q.right, z6_i);
      closed_y7_q <= aside(closed6_q.bottom, z6_i);
    end
  end
  assign near_x7_o = near_x7_q;
  assign near_y7_o = near_y7_q;
  assign bx7_o     = bx7_i - closed_x7_q;
  assign by7_o     = by7_i - closed_y7_q;

endmodule
