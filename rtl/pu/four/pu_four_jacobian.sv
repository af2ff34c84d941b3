// SPDX-License-Identifier: Apache-2.0
// pu_four_jacobian: pu_jacobian in four cycles: the rows of J R' and their cross product.
//
// Paper   Eq. 1: J W of Sigma' = J W Sigma W^T J^T.
// Idea    v0_j = R'0j - tan_x R'2j,  v1_j = R'1j - tan_y R'2j,  n_j = R'0j tan_x + R'1j tan_y + R'2j, exact; then
//         each value is normalised. Four multipliers: product, sum, normalise are the three register levels behind a
//         phase:
//           phase 0..2  v0_j, v1_j and n_j,  j = 0..2      3  gx = focal_x / z, gy, from two halves of a focal length
// Stream  oriented in, jacobian out, in order; an end beat passes with all other fields zero.
// Pace    One record in four cycles, latency 7.
// Model   cpp_model/pu/project/pu_jacobian.hpp

module pu_four_jacobian (
  input  logic                   clk_i,
  input  logic                   rst_ni,

  input  logic [pipegs_pkg::FocalW-1:0] focal_x_i,
  input  logic [pipegs_pkg::FocalW-1:0] focal_y_i,

  input  logic                   oriented_valid_i,
  output logic                   oriented_ready_o,
  input  pipegs_pkg::oriented_t  oriented_i,

  output logic                   jacobian_valid_o,
  input  logic                   jacobian_ready_i,
  output pipegs_pkg::jacobian_t  jacobian_o,

  output logic                   busy_o
);

  localparam int unsigned TanF      = pipegs_pkg::TanF;
  localparam int unsigned TanW      = pipegs_pkg::TanW;
  localparam int unsigned FocalW    = pipegs_pkg::FocalW;
  localparam int unsigned MantissaW = pipegs_pkg::MantissaW;
  localparam int unsigned FactorW   = pipegs_pkg::FactorW;
  localparam int unsigned RotationW = pipegs_pkg::RotationW;
  localparam int unsigned ExponentW = pipegs_pkg::WideEW;
  localparam int unsigned HalfW     = (FocalW + 1) / 2;
  localparam int unsigned LeftW     = TanW > MantissaW + 1 ? TanW : MantissaW + 1;    // a tangent or 1/z
  localparam int unsigned RightW    = RotationW > HalfW + 1 ? RotationW : HalfW + 1;  // an entry or half a focal length
  localparam int unsigned ProductW  = LeftW + RightW;
  localparam int unsigned SumW      = TanF + 27 > FocalW + MantissaW + 1 ? TanF + 27 : FocalW + MantissaW + 1;
  localparam int unsigned ShiftW    = $clog2(SumW);
  localparam int unsigned Cut       = SumW - FactorW;  // bits below a mantissa

  logic        take, claim, step;
  logic [3:0]  phase;  // whose operands are chosen now
  logic [7:0]  slots;
  logic        sum_valid, last_valid;
  logic [2:0]  sum, last;  // phase of the products, of the sums
  assign {last_valid, last, sum_valid, sum} = slots;

  pu_phases #(
    .Phases(4),
    .Depth(pipegs_pkg::JacobianDepth),
    .Claim(pipegs_pkg::JacobianClaim)
  ) u_phases (
    .clk_i,
    .rst_ni,
    .in_valid_i(oriented_valid_i),
    .in_ready_o(oriented_ready_o),
    .out_valid_o(jacobian_valid_o),
    .out_ready_i(jacobian_ready_i),
    .take_o(take),
    .claim_o(claim),
    .step_o(step),
    .held_o(),
    .phase_o(phase),
    .slots_o(slots),
    .busy_o
  );

  pipegs_pkg::oriented_t in_q;
  pipegs_pkg::jacobian_t out_q;
  assign jacobian_o = out_q;

  // --- phase: the operands of the four multipliers -------------------------------------------------------------------
  logic signed [RotationW-1:0] r0, r1, r2;  // column j
  logic signed [LeftW-1:0]     left0, left1;
  logic signed [RightW-1:0]    right [4];
  logic signed [ProductW-1:0]  product_q [4];
  always_comb begin
    (* parallel_case *) case (1'b1)
      phase[1]: begin r0 = in_q.r01; r1 = in_q.r11; r2 = in_q.r21; end
      phase[2]: begin r0 = in_q.r02; r1 = in_q.r12; r2 = in_q.r22; end
      default: begin r0 = in_q.r00; r1 = in_q.r10; r2 = in_q.r20; end
    endcase
    left0    = phase[3] ? $signed(LeftW'(in_q.inv_z_m)) : LeftW'(in_q.tan_x);
    left1    = phase[3] ? $signed(LeftW'(in_q.inv_z_m)) : LeftW'(in_q.tan_y);
    right[0] = phase[3] ? $signed(RightW'(focal_x_i[HalfW-1:0])) : RightW'(r2);
    right[1] = phase[3] ? $signed(RightW'(focal_y_i[HalfW-1:0])) : RightW'(r2);
    right[2] = phase[3] ? $signed(RightW'(focal_x_i[FocalW-1:HalfW])) : RightW'(r0);
    right[3] = phase[3] ? $signed(RightW'(focal_y_i[FocalW-1:HalfW])) : RightW'(r1);
  end

  // --- one later: v = R' - product, n = R' + both products, fraction 18 + TanF; a gain of its halves ----------------
  logic                        gain;
  logic signed [RotationW-1:0] entry0, entry1, entry2;
  logic signed [SumW-1:0]      sum0_q, sum1_q, sum2_q, product [4], whole0, whole1, whole2;
  always_comb begin
    case (sum)
      3'd0:    begin entry0 = in_q.r00; entry1 = in_q.r10; entry2 = in_q.r20; end
      3'd1:    begin entry0 = in_q.r01; entry1 = in_q.r11; entry2 = in_q.r21; end
      default: begin entry0 = in_q.r02; entry1 = in_q.r12; entry2 = in_q.r22; end
    endcase
  end
  assign gain = sum == 3'd3;
  for (genvar i = 0; i < 4; i += 1) begin : gen_product
    assign product[i] = SumW'(product_q[i]);
  end
  assign whole0 = gain ? product[2] <<< HalfW : SumW'(entry0) <<< TanF;
  assign whole1 = gain ? product[3] <<< HalfW : SumW'(entry1) <<< TanF;
  assign whole2 = SumW'(entry2) <<< TanF;

  // --- two later: normalise ----------------------------------------------------------------------------------------
  logic signed [SumW-1:0]      normal0, normal1, normal2;
  logic        [ShiftW-1:0]    shift0, shift1, shift2;
  logic signed [FactorW-1:0]   m0, m1, m2;
  logic signed [ExponentW-1:0] base, e0, e1, e2, gain_e_q;
  pipegs_normalize #(.DataW(SumW)) u_normalize0 (
    .in_i(sum0_q),
    .out_o(normal0),
    .shift_o(shift0)
  );
  pipegs_normalize #(.DataW(SumW)) u_normalize1 (
    .in_i(sum1_q),
    .out_o(normal1),
    .shift_o(shift1)
  );
  pipegs_normalize #(.DataW(SumW)) u_normalize2 (
    .in_i(sum2_q),
    .out_o(normal2),
    .shift_o(shift2)
  );
  localparam logic signed [ExponentW-1:0] Base = $signed(ExponentW'(Cut) - ExponentW'(RotationW - 2 + TanF));
  assign m0   = normal0[SumW-1:Cut];
  assign m1   = normal1[SumW-1:Cut];
  assign m2   = normal2[SumW-1:Cut];
  assign base = last == 3'd3 ? gain_e_q : Base;
  assign e0   = base - $signed(ExponentW'(shift0));
  assign e1   = base - $signed(ExponentW'(shift1));
  assign e2   = Base - $signed(ExponentW'(shift2));

  logic data;  // a Gaussian claims the output
  assign data = claim && in_q.kind == pipegs_pkg::KindData;
  always_ff @(posedge clk_i) begin
    if (take) in_q <= oriented_i;
    if (step) begin
      product_q[0] <= ProductW'(left0) * ProductW'(right[0]);
      product_q[1] <= ProductW'(left1) * ProductW'(right[1]);
      product_q[2] <= ProductW'(left0) * ProductW'(right[2]);
      product_q[3] <= ProductW'(left1) * ProductW'(right[3]);
      sum0_q       <= whole0 + (product[0] ^ {SumW{!gain}}) + $signed(SumW'(!gain));
      sum1_q       <= whole1 + (product[1] ^ {SumW{!gain}}) + $signed(SumW'(!gain));
      sum2_q       <= whole2 + product[2] + product[3];
    end
    if (claim) begin
      gain_e_q   <= ExponentW'(in_q.inv_z_e) + ExponentW'(Cut) - ExponentW'(pipegs_pkg::FocalF);
      out_q      <= '0;
      out_q.kind <= in_q.kind;
    end
    if (data) begin  // the first column is there
      out_q.scale_0 <= in_q.scale_0;
      out_q.scale_1 <= in_q.scale_1;
      out_q.scale_2 <= in_q.scale_2;
      {out_q.v0_0_m, out_q.v1_0_m, out_q.n_0_m} <= {m0, m1, m2};
      {out_q.v0_0_e, out_q.v1_0_e, out_q.n_0_e} <= {e0, e1, e2};
    end
    if (step && last_valid && out_q.kind == pipegs_pkg::KindData) begin
      case (last)
        3'd1: begin
          {out_q.v0_1_m, out_q.v1_1_m, out_q.n_1_m} <= {m0, m1, m2};
          {out_q.v0_1_e, out_q.v1_1_e, out_q.n_1_e} <= {e0, e1, e2};
        end
        3'd2: begin
          {out_q.v0_2_m, out_q.v1_2_m, out_q.n_2_m} <= {m0, m1, m2};
          {out_q.v0_2_e, out_q.v1_2_e, out_q.n_2_e} <= {e0, e1, e2};
        end
        3'd3: begin
          {out_q.gx_m, out_q.gy_m} <= {m0[MantissaW-1:0], m1[MantissaW-1:0]};
          {out_q.gx_e, out_q.gy_e} <= {e0, e1};
        end
        default: ;  // the first column goes with the claim
      endcase
    end
  end

  // Valid is only looked at beside results.
  wire unused_bits = &{1'b0, phase, sum_valid, normal0[Cut-1:0], normal1[Cut-1:0],
                       normal2[Cut-1:0]};

endmodule
