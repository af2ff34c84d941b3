// SPDX-License-Identifier: Apache-2.0
// pu_four_orient: pu_orient in four cycles: the Gaussian's axes in view space.
//
// Paper   Eq. 1: the rotation of Sigma = R S S^T R^T and the viewing transform W, as one rotation.
// Idea    q' = camera_q (x) q, R' = matrix of q'. Four multipliers make q'; R' needs no product but squares:
//           2 (x y + w z) = (x+y)^2 + (w+z)^2 - |q'|^2     2 (x y - w z) = (x+y)^2 - (w+z)^2 + |q'|^2 - 2 (xx + yy)
//           cycle       0    1    2    3    4    5    6    7    8    9
//           products    w    x    y    z
//           rounded          w    x    y    z
//           squares                              xx   x+y  x+z  y+z
//                                                ww   w+z  w+y  w+x
//                                                yy   zz
//           entries                                        22   11   00
//                                                          10   02   21
//                                                          01   20   12
// Stream  projected in, oriented out, in order; an end beat passes with all other fields zero.
// Pace    One record in four cycles, latency 11.
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
  // - p is ~p + 1; one product is negative, of w three are.
  logic signed [SumW-1:0] hamilton, signed_product [4];
  logic        [3:0]      minus;
  assign minus = {sum[1:0] < 2'd2, sum[1:0] == 2'd0 || sum[1:0] == 2'd3, !sum[0], 1'b0};
  for (genvar i = 0; i < 4; i += 1) begin : gen_sign
    assign signed_product[i] = SumW'(product_q[i]) ^ {SumW{minus[i]}};
  end
  assign hamilton = signed_product[0] + signed_product[1] + signed_product[2] + signed_product[3] +
                    (sum[1:0] == 2'd0 ? SumW'(3) : SumW'(1));

  // Rounded to nearest, then saturated to s1.18.
  function automatic logic signed [SumW-1:0] round(input logic signed [SumW-1:0] value, input int unsigned shift);
    round = (value + (SumW'(1) <<< (shift - 1))) >>> shift;
  endfunction

  logic signed [RotationW-1:0] component;
  pipegs_saturate #(.InW(SumW), .OutW(RotationW)) u_component (
    .in_i(round(hamilton, QuatW - 1)),
    .out_o(component)
  );

  // --- R': squares of four numbers and of six sums, chosen in cycles 4 to 7, made in 5 to 8 -------------------------
  localparam int unsigned BothW   = RotationW + 1;
  localparam int unsigned SquareW = 2 * BothW - 1;
  logic [3:0]                  turn_q;  // the cycles 4 to 7
  logic signed [RotationW-1:0] x_or_y, y_or_z, with_xy, with_w, w_late_q, x_late_q;  // late: beside the next one's w, x
  logic signed [RotationW-1:0] base2_q;
  logic signed [BothW-1:0]     base0_q, base1_q;
  logic [SquareW-1:0]          square0, square1, square0_q, square1_q;
  logic [2*RotationW-2:0]      square2, square2_q, xx_q, yy_q;  // square2_q: yy in cycle 6, zz in 7 to 9
  logic signed [SumW-1:0]      three_q;                         // ww + xx + yy
  always_comb begin
    y_or_z  = turn_q[0] ? y_q : z_q;
    x_or_y  = turn_q[3] ? y_q : x_q;
    with_xy = turn_q[1] ? y_q : turn_q[0] ? '0 : z_q;
    with_w  = turn_q[1] ? z_q : turn_q[2] ? y_q : turn_q[3] ? x_late_q : '0;
  end
  pipegs_square #(.DataW(BothW)) u_square0 (
    .in_i(base0_q),
    .out_o(square0)
  );
  pipegs_square #(.DataW(BothW)) u_square1 (
    .in_i(base1_q),
    .out_o(square1)
  );
  pipegs_square #(.DataW(RotationW)) u_square2 (
    .in_i(base2_q),
    .out_o(square2)
  );

  // --- in cycles 7 to 9: a pair of entries and the diagonal beside it -----------------------------------------------
  localparam logic signed [SumW-1:0] One = SumW'(1) <<< (2 * RotationF);
  logic [2:0]                  write;    // the cycles 7 to 9
  logic [2*RotationW-2:0]      first, second;
  logic signed [SumW-1:0]      sum0, sum1, all, two, twice [3];
  logic signed [RotationW-1:0] entry [3];
  for (genvar i = 0; i < 3; i += 1) begin : gen_write
    assign write[i] = slots[4*Depth-4+:4] == 4'(9 + i);
  end
  always_comb begin
    sum0     = SumW'(square0_q);
    sum1     = SumW'(square1_q);
    all      = three_q + SumW'(square2_q);
    first    = write[2] ? yy_q : xx_q;
    second   = write[0] ? yy_q : square2_q;
    two      = (SumW'(first) + SumW'(second)) <<< 1;
    twice[0] = One - two;               // 22, 11, 00
    twice[1] = sum0 + sum1 - all;       // 10, 02, 21
    twice[2] = sum0 - sum1 + all - two; // 01, 20, 12
  end
  for (genvar i = 0; i < 3; i += 1) begin : gen_entry
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
      if (slots[8+:4] == 4'd8) w_late_q <= w_q;
      if (turn_q[2]) x_late_q <= x_q;
      base0_q   <= BothW'(x_or_y) + BothW'(with_xy);
      base1_q   <= BothW'(w_late_q) + BothW'(with_w);
      base2_q   <= y_or_z;
      square0_q <= square0;
      square1_q <= square1;
      square2_q <= square2;
      if (slots[4*Depth-4+:4] == 4'd8) begin  // cycle 6
        {xx_q, yy_q} <= {square0_q[2*RotationW-2:0], square2_q};
        three_q      <= SumW'(square0_q) + SumW'(square1_q) + SumW'(square2_q);
      end
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
      if (write[0]) {out_q.r22, out_q.r10, out_q.r01} <= {entry[0], entry[1], entry[2]};
      if (write[1]) {out_q.r11, out_q.r02, out_q.r20} <= {entry[0], entry[1], entry[2]};
      if (write[2]) {out_q.r00, out_q.r21, out_q.r12} <= {entry[0], entry[1], entry[2]};
    end
  end

  // The phase is only looked at beside products that count.
  wire unused_bits = &{1'b0, phase, turn_q, slots, behind_q, square0_q};

endmodule
