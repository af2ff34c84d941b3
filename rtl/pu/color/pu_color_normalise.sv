// SPDX-License-Identifier: Apache-2.0
// pu_color_normalise: divides the world direction by its length.
//
// Idea    length2 = u * 4^h with u in [1, 4); unit = world * rsqrt(u) * 2^-h. Any length works, also an unnormalised
//         one; a zero direction gives zero.
// Stream  world_direction -> unit_direction, s1.16, rounded to nearest, saturated.
// Pace    One direction in 5 cycles, latency 7: normalise, two of rsqrt, then x, y, z through one multiplier and one
//         shifter.
// Model   cpp_model/pu/color/pu_color_normalise.hpp
//
//         step   (take)  0  1  2  3  4          r is there from step 2 on and stays while u_q does
//                u, h    rsqrt x  y  z  -> product -> shifted

module pu_color_normalise (
  input  logic                          clk_i,
  input  logic                          rst_ni,

  input  logic                          world_valid_i,
  output logic                          world_ready_o,
  input  pipegs_pkg::world_direction_t  world_i,

  output logic                          unit_valid_o,
  input  logic                          unit_ready_i,
  output pipegs_pkg::unit_direction_t   unit_o
);

  localparam int unsigned LengthW = pipegs_pkg::LengthW;
  localparam int unsigned WorldW = pipegs_pkg::WorldDirectionW;
  localparam int unsigned UnitW = pipegs_pkg::UnitDirectionW;
  localparam int unsigned RootW = 18;                                     // rsqrt, u0.18
  localparam int unsigned InW = 20;                                       // rsqrt's input, u2.18
  localparam int unsigned HalfW = $clog2(LengthW / 2);
  localparam int unsigned ProductW = WorldW + RootW + 1;
  localparam int unsigned ShiftLow = RootW - pipegs_pkg::UnitDirectionF;  // shift = h + ShiftLow, and 1 to round

  logic                       busy_q;
  logic [2:0]                 step_q;
  logic [HalfW-1:0]           half, half_q, product_half_q;
  logic [LengthW-1:0]         normal;
  logic [InW-1:0]             u_q;
  logic [RootW-1:0]           root;
  logic signed [WorldW-1:0]   x_q, y_q, z_q, factor;
  logic signed [ProductW-1:0] product_q, cut, near;
  logic signed [UnitW-1:0]    unit_d;
  logic                       product_valid_q, issue, last, take;
  logic [2:0]                 product_step_q;
  logic                       unit_valid_q;
  pipegs_pkg::unit_direction_t unit_q;

  // The output register is overwritten from the x product on: step 2 waits until it is free.
  assign issue         = busy_q && (step_q != 3'd2 || !unit_valid_q || unit_ready_i);
  assign last          = issue && step_q == 3'd4;
  assign world_ready_o = !busy_q || step_q == 3'd4;
  assign take          = world_valid_i && world_ready_o;

  // h is the place of the highest pair of bits that is not zero.
  always_comb begin
    half = '0;
    for (int unsigned i = 0; i < LengthW / 2; i += 1) begin
      if (world_i.length2[2*i +: 2] != 2'd0) half = HalfW'(i);
    end
    normal = world_i.length2 << {HalfW'(LengthW / 2 - 1) - half, 1'b0};
  end

  pipegs_rsqrt u_rsqrt (
    .clk_i,
    .u_i(u_q),
    .r_o(root)
  );

  always_comb begin
    unique case (step_q)
      3'd2:    factor = x_q;
      3'd3:    factor = y_q;
      default: factor = z_q;
    endcase
    cut    = product_q >>> ((HalfW + 1)'(product_half_q) + (HalfW + 1)'(ShiftLow));
    near   = (cut >>> 1) + ProductW'($signed({1'b0, cut[0]}));
  end
  pipegs_saturate #(.InW(ProductW), .OutW(UnitW)) u_unit (
    .in_i(near),
    .out_o(unit_d)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      busy_q          <= 1'b0;
      step_q          <= '0;
      product_valid_q <= 1'b0;
      unit_valid_q    <= 1'b0;
    end else begin
      if (take) busy_q <= 1'b1;
      else if (last) busy_q <= 1'b0;
      if (take) step_q <= '0;
      else if (issue) step_q <= step_q + 3'd1;
      product_valid_q <= issue && step_q >= 3'd2;
      if (product_valid_q && product_step_q == 3'd4) unit_valid_q <= 1'b1;
      else if (unit_ready_i) unit_valid_q <= 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (take) begin
      u_q    <= normal[LengthW-1:LengthW-InW];
      half_q <= half;
      x_q    <= world_i.x;
      y_q    <= world_i.y;
      z_q    <= world_i.z;
    end
    if (issue) begin
      product_q      <= ProductW'(factor) * ProductW'($signed({1'b0, root}));
      product_half_q <= half_q;
      product_step_q <= step_q;
    end
    if (product_valid_q) begin
      unique case (product_step_q)
        3'd2:    unit_q.x <= unit_d;
        3'd3:    unit_q.y <= unit_d;
        default: unit_q.z <= unit_d;
      endcase
    end
  end

  assign unit_valid_o = unit_valid_q;
  assign unit_o       = unit_q;

  wire unused_bits = &{1'b0, normal[LengthW-InW-1:0]};

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits(unit_o))) u_check_unit (
    .clk_i,
    .rst_ni,
    .valid_i(unit_valid_o),
    .ready_i(unit_ready_i),
    .beat_i(unit_o)
  );
`endif

endmodule
