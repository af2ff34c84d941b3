// SPDX-License-Identifier: Apache-2.0
// pu_four_orient: pu_orient in four cycles: the Gaussian's axes in view space.
//
// Paper   Eq. 1: the rotation of Sigma = R S S^T R^T and the viewing transform W, as one rotation.
// Idea    q' = camera_q (x) q, R' = matrix of q'. Four multipliers make q', two and a square make R':
//           cycle       0    1    2    3    4    5    6    7    8
//           products    w    x    y    z
//           rounded          w    x    y    z
//           products                        wx   wy   xy   yz
//                                                wz   xz
//           squares                         xx   yy   zz
//           entries                                   22   00   12
//                                                          11   21
//                                                          01 10 02 20
// Stream  projected in, oriented out, in order; an end beat passes with all other fields zero.
// Pace    One record in four cycles, latency 10.
// Model   cpp_model/pu/project/pu_orient.hpp

module pu_four_orient (
  input  logic                    clk_i,
  input  logic                    rst_ni,

  input  pipegs_pkg::quaternion_t quaternion_i,

  input  logic                    projected_valid_i,
  output logic                    projected_ready_o,
  input  pipegs_pkg::projected_t  projected_i,

  output logic                    oriented_valid_o,
  input  logic                    oriented_ready_i,
  output pipegs_pkg::oriented_t   oriented_o,

  output logic                    busy_o
);

  localparam int unsigned QuatW     = pipegs_pkg::QuatW;
  localparam int unsigned RotationW = pipegs_pkg::RotationW;  // also of q' and the camera's quaternion
  localparam int unsigned RotationF = RotationW - 2;
  localparam int unsigned ProductW  = 2 * RotationW;
  localparam int unsigned SumW      = ProductW + 3;

  localparam int unsigned Depth = pipegs_pkg::OrientDepth;
  logic                  take, claim, step;
  logic [3:0]            phase;  // whose operands are chosen now
  logic [4*Depth-1:0]    slots;
  logic [2:0]            sum;    // phase whose products are in use
  assign sum = slots[2:0];

  pu_phases #(
    .Phases(4),
    .Depth(Depth),
    .Claim(pipegs_pkg::OrientClaim)
  ) u_phases (
    .clk_i,
    .rst_ni,
    .in_valid_i(projected_valid_i),
    .in_ready_o(projected_ready_o),
    .out_valid_o(oriented_valid_o),
    .out_ready_i(oriented_ready_i),
    .take_o(take),
    .claim_o(claim),
    .step_o(step),
    .held_o(),
    .phase_o(phase),
    .slots_o(slots),
    .busy_o
  );

  pipegs_pkg::projected_t projected_q, behind_q;  // in its phases, behind them
  pipegs_pkg::oriented_t  out_q;
  assign oriented_o = out_q;

  // --- four products for q' ----------------------------------------------------------------------------------------
  logic signed [RotationW-1:0] w_q, x_q, y_q, z_q;  // q', s1.18
  logic signed [RotationW-1:0] left [4], right [4];
  logic signed [ProductW-1:0]  product_q [4];
  logic signed [RotationW-1:0] qw, qx, qy, qz;

  assign qw = RotationW'(projected_q.qw);
  assign qx = RotationW'(projected_q.qx);
  assign qy = RotationW'(projected_q.qy);
  assign qz = RotationW'(projected_q.qz);

  always_comb begin
    left[0] = quaternion_i.w;
    left[1] = quaternion_i.x;
    left[2] = quaternion_i.y;
    left[3] = quaternion_i.z;
    right[0] = qw;
    right[1] = qx;
    right[2] = qy;
    right[3] = qz;
    (* parallel_case *) case (1'b1)
      phase[1]: begin right[0] = qx; right[1] = qw; right[2] = qz; right[3] = qy; end
      phase[2]: begin right[0] = qy; right[1] = qz; right[2] = qw; right[3] = qx; end
      phase[3]: begin right[0] = qz; right[1] = qy; right[2] = qx; right[3] = qw; end
      default: ;
    endcase
  end

  // --- q': signs of the Hamilton product, rounded from s2.33 to s1.18 ----------------------------------------------
  logic signed [SumW-1:0] p0, p1, p2, p3, hamilton;
  assign p0 = SumW'(product_q[0]);
  assign p1 = SumW'(product_q[1]);
  assign p2 = SumW'(product_q[2]);
  assign p3 = SumW'(product_q[3]);
  always_comb begin
    case (sum[1:0])
      2'd0:    hamilton = p0 - p1 - p2 - p3;
      2'd1:    hamilton = p0 + p1 + p2 - p3;
      2'd2:    hamilton = p0 - p1 + p2 + p3;
      default: hamilton = p0 + p1 - p2 + p3;
    endcase
  end

  // Rounded to nearest, then saturated to s1.18.
  function automatic logic signed [SumW-1:0] round(input logic signed [SumW-1:0] value, input int unsigned shift);
    round = (value + (SumW'(1) <<< (shift - 1))) >>> shift;
  endfunction

  logic signed [RotationW-1:0] component;
  pipegs_saturate #(.InW(SumW), .OutW(RotationW)) u_component (
    .in_i(round(hamilton, QuatW - 1)),
    .out_o(component)
  );

  // --- R': products in cycles 4 to 7 -------------------------------------------------------------------------------
  logic [3:0]                  turn_q;  // the cycles 4 to 7
  logic signed [RotationW-1:0] left0, right0, left1, right1, squared;
  logic signed [ProductW-1:0]  product0_q, product1_q, wx_q, wy_q, wz_q;
  logic [ProductW-2:0]         square, square_q, xx_q, yy_q;
  always_comb begin
    left0  = w_q;
    right0 = x_q;
    (* parallel_case *) case (1'b1)
      turn_q[1]: right0 = y_q;
      turn_q[2]: begin left0 = x_q; right0 = y_q; end
      turn_q[3]: begin left0 = y_q; right0 = z_q; end
      default: ;
    endcase
    left1   = turn_q[1] ? w_q : x_q;
    right1  = z_q;
    squared = turn_q[1] ? y_q : turn_q[2] ? z_q : x_q;
  end
  pipegs_square #(.DataW(RotationW)) u_square (
    .in_i(squared),
    .out_o(square)
  );

  // --- a cycle later: the diagonal, and the pairs around it ----------------------------------------------------------
  localparam logic signed [SumW-1:0] One = SumW'(1) <<< (2 * RotationF);
  logic [3:0]                  write;    // the cycles 5 to 8
  logic signed [SumW-1:0]      twice [6];
  logic signed [RotationW-1:0] entry [6];
  logic signed [ProductW-1:0]  beside;   // of the first pair
  logic [ProductW-2:0]         above;    // of the diagonal
  for (genvar i = 0; i < 4; i += 1) begin : gen_write
    assign write[i] = slots[4*Depth-4+:4] == 4'(8 + i);
  end
  assign beside = write[3] ? wx_q : wz_q;
  assign above  = write[1] ? xx_q : yy_q;
  always_comb begin
    twice[0] = One - ((SumW'(above) + SumW'(square_q)) <<< 1);  // 22, 00
    twice[1] = One - ((SumW'(xx_q) + SumW'(square_q)) <<< 1);                    // 11
    twice[2] = (SumW'(product0_q) - SumW'(beside)) <<< 1;                        // 01, 12
    twice[3] = (SumW'(product0_q) + SumW'(beside)) <<< 1;                        // 10, 21
    twice[4] = (SumW'(product1_q) + SumW'(wy_q)) <<< 1;                          // 02
    twice[5] = (SumW'(product1_q) - SumW'(wy_q)) <<< 1;                          // 20
  end
  for (genvar i = 0; i < 6; i += 1) begin : gen_entry
    pipegs_saturate #(.InW(SumW), .OutW(RotationW)) u_entry (
      .in_i(round(twice[i], RotationF)),
      .out_o(entry[i])
    );
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) turn_q <= '0;
    else if (step) for (int unsigned i = 0; i < 4; i += 1) turn_q[i] <= slots[8+:4] == 4'(8 + i);
  end
  always_ff @(posedge clk_i) begin
    if (take) projected_q <= projected_i;
    if (step) begin
      if (phase[3]) behind_q <= projected_q;
      for (int unsigned i = 0; i < 4; i += 1) product_q[i] <= ProductW'(left[i]) * ProductW'(right[i]);
      if (sum == 3'd0) w_q <= component;
      if (sum == 3'd1) x_q <= component;
      if (sum == 3'd2) y_q <= component;
      if (sum == 3'd3) z_q <= component;
      product0_q <= ProductW'(left0) * ProductW'(right0);
      product1_q <= ProductW'(left1) * ProductW'(right1);
      square_q   <= square;
      if (write[0]) {wx_q, xx_q} <= {product0_q, square_q};
      if (write[1]) {wy_q, wz_q, yy_q} <= {product0_q, product1_q, square_q};
    end
    if (claim) begin
      out_q      <= '0;
      out_q.kind <= behind_q.kind;
      if (behind_q.kind == pipegs_pkg::KindData) begin
        out_q.tan_x   <= behind_q.tan_x;
        out_q.tan_y   <= behind_q.tan_y;
        out_q.inv_z_m <= behind_q.inv_z_m;
        out_q.inv_z_e <= behind_q.inv_z_e;
        out_q.scale_0 <= behind_q.scale_0;
        out_q.scale_1 <= behind_q.scale_1;
        out_q.scale_2 <= behind_q.scale_2;
      end
    end
    if (step && out_q.kind == pipegs_pkg::KindData) begin
      if (write[1]) out_q.r22 <= entry[0];
      if (write[2]) {out_q.r00, out_q.r11} <= {entry[0], entry[1]};
      if (write[2]) {out_q.r01, out_q.r10, out_q.r02, out_q.r20} <= {entry[2], entry[3], entry[4], entry[5]};
      if (write[3]) {out_q.r12, out_q.r21} <= {entry[2], entry[3]};
    end
  end

  // The phase is only looked at beside products that count.
  wire unused_bits = &{1'b0, phase, turn_q, slots, behind_q};

endmodule
