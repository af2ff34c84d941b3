// SPDX-License-Identifier: Apache-2.0
// pu_orient: the Gaussian's axes in view space, from its quaternion and the camera's.
//
// Paper   Eq. 1: the rotation of Sigma = R S S^T R^T and the viewing transform W, as one rotation.
// Idea    q' = camera_q (x) q, R' = matrix of q'. Four multipliers, one phase per line:
//           phase 0..3  the four products of q'w, q'x, q'y, q'z     5  xx yy zz    6  xy wz xz wy    7  yz wx
//         One cycle later the products are summed and rounded.
// Stream  projected in, oriented out, in order; an end beat passes with all other fields zero.
// Pace    One record in eight cycles, latency 10.
// Model   cpp_model/pu/project/pu_orient.hpp

module pu_orient (
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

  logic        take, claim, step;
  logic [7:0]  phase;  // whose operands are chosen now
  logic [3:0]  slots;
  logic        sum_valid;
  logic [2:0]  sum;  // phase whose products are in use
  assign {sum_valid, sum} = slots;

  pu_phases #(.Depth(pipegs_pkg::OrientDepth), .Claim(pipegs_pkg::OrientClaim)) u_phases (
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

  pipegs_pkg::projected_t projected_q;
  pipegs_pkg::oriented_t  out_q;
  assign oriented_o = out_q;

  // --- four products -------------------------------------------------------------------------------------------------
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
      phase[5]: begin
        left[0] = x_q; right[0] = x_q;
        left[1] = y_q; right[1] = y_q;
        left[2] = z_q; right[2] = z_q;
      end
      phase[6]: begin
        left[0] = x_q; right[0] = y_q;
        left[1] = w_q; right[1] = z_q;
        left[2] = x_q; right[2] = z_q;
        left[3] = w_q; right[3] = y_q;
      end
      phase[7]: begin
        left[0] = y_q; right[0] = z_q;
        left[1] = w_q; right[1] = x_q;
      end
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

  // --- R': phase 5 gives the diagonal, 6 and 7 the pairs around it -------------------------------------------------
  localparam logic signed [SumW-1:0] One = SumW'(1) <<< (2 * RotationF);
  logic signed [SumW-1:0] twice [4];
  logic signed [RotationW-1:0] entry [4];
  always_comb begin
    twice[0] = (p0 - p1) <<< 1;
    twice[1] = (p0 + p1) <<< 1;
    twice[2] = (p2 + p3) <<< 1;
    twice[3] = (p2 - p3) <<< 1;
    if (sum == 3'd5) begin
      twice[0] = One - ((p1 + p2) <<< 1);
      twice[1] = One - ((p0 + p2) <<< 1);
      twice[2] = One - ((p0 + p1) <<< 1);
    end
  end
  for (genvar i = 0; i < 4; i += 1) begin : gen_entry
    pipegs_saturate #(.InW(SumW), .OutW(RotationW)) u_entry (
      .in_i(round(twice[i], RotationF)),
      .out_o(entry[i])
    );
  end

  always_ff @(posedge clk_i) begin
    if (take) projected_q <= projected_i;
    if (step) begin
      for (int unsigned i = 0; i < 4; i += 1) product_q[i] <= ProductW'(left[i]) * ProductW'(right[i]);
      if (sum == 3'd0) w_q <= component;
      if (sum == 3'd1) x_q <= component;
      if (sum == 3'd2) y_q <= component;
      if (sum == 3'd3) z_q <= component;
    end
    if (claim) begin
      out_q      <= '0;
      out_q.kind <= projected_q.kind;
      if (projected_q.kind == pipegs_pkg::KindData) begin
        out_q.tan_x   <= projected_q.tan_x;
        out_q.tan_y   <= projected_q.tan_y;
        out_q.inv_z_m <= projected_q.inv_z_m;
        out_q.inv_z_e <= projected_q.inv_z_e;
        out_q.scale_0 <= projected_q.scale_0;
        out_q.scale_1 <= projected_q.scale_1;
        out_q.scale_2 <= projected_q.scale_2;
      end
    end
    if (step && sum_valid && out_q.kind == pipegs_pkg::KindData) begin
      case (sum)
        3'd5: begin
          out_q.r00 <= entry[0];
          out_q.r11 <= entry[1];
          out_q.r22 <= entry[2];
        end
        3'd6: begin
          out_q.r01 <= entry[0];
          out_q.r10 <= entry[1];
          out_q.r02 <= entry[2];
          out_q.r20 <= entry[3];
        end
        3'd7: begin
          out_q.r12 <= entry[0];
          out_q.r21 <= entry[1];
        end
        default: ;
      endcase
    end
  end

  // The phase is only looked at beside products that count.
  wire unused_bits = &{1'b0, phase};

endmodule
