// SPDX-License-Identifier: Apache-2.0
// pu_color_rotate: turns the view direction into world axes and measures its squared length.
//
// Idea    world = W^T view by two multiplier-accumulators in six steps; the length comes from the view components:
//           step   0       1       2       3       4       5
//           mac_a  x x     y y     z z     w02 x   w12 y   w22 z      length2, then world z
//           mac_b  w00 x   w10 y   w20 z   w01 x   w11 y   w21 z      world x, then world y
// Stream  view_direction -> world_direction (s(DirectionW).1, saturated) with the exact squared length.
// Pace    One direction in 6 cycles, latency 9. Each product is registered before it is added.
// Model   cpp_model/pu/color/pu_color_rotate.hpp

module pu_color_rotate (
  input  logic                          clk_i,
  input  logic                          rst_ni,
  input  pipegs_pkg::rotation_t         rotation_i,

  input  logic                          direction_valid_i,
  output logic                          direction_ready_o,
  input  pipegs_pkg::view_direction_t   direction_i,

  output logic                          world_valid_o,
  input  logic                          world_ready_i,
  output pipegs_pkg::world_direction_t  world_o
);

  localparam int unsigned ViewW = pipegs_pkg::DirectionW;
  localparam int unsigned WorldW = pipegs_pkg::WorldDirectionW;
  localparam int unsigned FactorF = 18;                                // W is cut to s1.18
  localparam int unsigned Cut = pipegs_pkg::RotF - FactorF;
  localparam int unsigned FactorW = pipegs_pkg::RotW - Cut;
  localparam int unsigned ProductW = ViewW + FactorW;
  localparam int unsigned SumW = ProductW + 2;                         // three products
  localparam int unsigned Drop = FactorF - 1;                          // one fraction bit stays

  logic                       busy_q;
  logic [2:0]                 step_q;
  logic signed [ViewW-1:0]    x_q, y_q, z_q;
  logic                       issue, last, take;

  logic signed [ViewW-1:0]    view;
  logic signed [pipegs_pkg::RotW-1:0] row_a, row_b;
  logic signed [FactorW-1:0]  factor_a, factor_b;
  logic signed [ProductW-1:0] product_a_q, product_b_q;
  logic                       product_valid_q, finish_q;
  logic [2:0]                 product_step_q;
  logic signed [SumW-1:0]     sum_a_q, sum_b_q;
  logic                       first;

  pipegs_pkg::world_direction_t world_q;
  logic                         world_valid_q;

  // With step 3 the results of step 0 to 2 move to the output register: wait there until it is free.
  assign issue             = busy_q && (step_q != 3'd3 || !world_valid_q || world_ready_i);
  assign last              = issue && step_q == 3'd5;
  assign take              = direction_valid_i && direction_ready_o;
  assign direction_ready_o = !busy_q || step_q == 3'd5;

  always_comb begin
    unique case (step_q)
      3'd0:    begin view = x_q; row_a = '0;          row_b = rotation_i.w00; end
      3'd1:    begin view = y_q; row_a = '0;          row_b = rotation_i.w10; end
      3'd2:    begin view = z_q; row_a = '0;          row_b = rotation_i.w20; end
      3'd3:    begin view = x_q; row_a = rotation_i.w02; row_b = rotation_i.w01; end
      3'd4:    begin view = y_q; row_a = rotation_i.w12; row_b = rotation_i.w11; end
      default: begin view = z_q; row_a = rotation_i.w22; row_b = rotation_i.w21; end
    endcase
    factor_b = FactorW'(row_b >>> Cut);
    factor_a = step_q < 3'd3 ? FactorW'(view) : FactorW'(row_a >>> Cut);
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      busy_q          <= 1'b0;
      step_q          <= '0;
      product_valid_q <= 1'b0;
      finish_q        <= 1'b0;
      world_valid_q   <= 1'b0;
    end else begin
      if (take) busy_q <= 1'b1;
      else if (last) busy_q <= 1'b0;
      if (take) step_q <= '0;
      else if (issue) step_q <= step_q + 3'd1;
      product_valid_q <= issue;
      finish_q        <= product_valid_q && product_step_q == 3'd5;
      if (finish_q) world_valid_q <= 1'b1;
      else if (world_ready_i) world_valid_q <= 1'b0;
    end
  end

  assign first = product_step_q == 3'd0 || product_step_q == 3'd3;

  always_ff @(posedge clk_i) begin
    if (take) begin
      x_q <= direction_i.x;
      y_q <= direction_i.y;
      z_q <= direction_i.z;
    end
    if (issue) begin
      product_a_q    <= ProductW'(factor_a) * ProductW'(view);
      product_b_q    <= ProductW'(factor_b) * ProductW'(view);
      product_step_q <= step_q;
    end
    if (product_valid_q) begin
      sum_a_q <= first ? SumW'(product_a_q) : sum_a_q + SumW'(product_a_q);
      sum_b_q <= first ? SumW'(product_b_q) : sum_b_q + SumW'(product_b_q);
    end
  end

  // Rounding to nearest, then saturation (only a W that is no rotation needs it).
  logic signed [SumW-1:0]   near_a, near_b;
  logic signed [WorldW-1:0] world_a, world_b;
  assign near_a = (sum_a_q + (SumW'(1) << (Drop - 1))) >>> Drop;
  assign near_b = (sum_b_q + (SumW'(1) << (Drop - 1))) >>> Drop;
  pipegs_saturate #(.InW(SumW), .OutW(WorldW)) u_world_a (
    .in_i(near_a),
    .out_o(world_a)
  );
  pipegs_saturate #(.InW(SumW), .OutW(WorldW)) u_world_b (
    .in_i(near_b),
    .out_o(world_b)
  );

  always_ff @(posedge clk_i) begin
    if (product_valid_q && product_step_q == 3'd3) begin
      world_q.length2 <= pipegs_pkg::LengthW'(sum_a_q);
      world_q.x       <= world_b;
    end
    if (finish_q) begin
      world_q.z <= world_a;
      world_q.y <= world_b;
    end
  end

  assign world_valid_o = world_valid_q;
  assign world_o       = world_q;


`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits(world_o))) u_check_world (
    .clk_i,
    .rst_ni,
    .valid_i(world_valid_o),
    .ready_i(world_ready_i),
    .beat_i(world_o)
  );
`endif

endmodule
