// SPDX-License-Identifier: Apache-2.0
// pu_four_squares: pu_squares in four cycles: |u0|^2, |u1|^2, u0 . u1 and |u0 x u1|^2.
//
// Paper   Eq. 1: Sigma' = U U^T.
// Idea    Three squares in a cycle and no product: 2 u0 . u1 = |u0 + u1|^2 - |u0|^2 - |u1|^2, exact as all sums are.
//           phase 0  a = |u0|^2     1  c = |u1|^2     2  b = u0 . u1     3  d = |t|^2
//         Squares, sum, mantissa, exponent are the register levels behind a phase, each there once.
// Stream  factors in, squares out, in order; an end beat passes with all other fields zero.
// Pace    One record in four cycles, latency 8.
// Model   cpp_model/pu/project/pu_squares.hpp

module pu_four_squares (
  input  logic                  clk_i,
  input  logic                  rst_ni,

  input  logic                  factors_valid_i,
  output logic                  factors_ready_o,
  input  pipegs_pkg::factors_t  factors_i,

  output logic                  squares_valid_o,
  input  logic                  squares_ready_i,
  output pipegs_pkg::squares_t  squares_o,

  output logic                  busy_o
);

  localparam int unsigned MantissaW = pipegs_pkg::MantissaW;
  localparam int unsigned FactorW   = pipegs_pkg::FactorW;
  localparam int unsigned ExponentW = pipegs_pkg::WideEW;
  localparam int unsigned BaseW     = FactorW + 1;          // of what is squared
  localparam int unsigned SquareW   = 2 * BaseW - 1;
  localparam int unsigned WholeW    = SquareW + 2;          // three squares
  localparam int unsigned SumW      = 2 * FactorW + 1;
  localparam int unsigned ShiftW    = $clog2(SumW);
  localparam int unsigned Cut       = SumW - FactorW;       // bits below a mantissa

  logic        take, claim, step;
  logic [3:0]  phase;  // whose operands are chosen now
  logic [11:0] slots;
  logic        last_valid;
  logic [2:0]  sum, last;  // phase of the squares, of what is normalised
  assign sum                = slots[2:0];
  assign {last_valid, last} = slots[11:8];

  pu_phases #(
    .Phases(4),
    .Depth(pipegs_pkg::SquaresDepth),
    .Claim(pipegs_pkg::SquaresClaim)
  ) u_phases (
    .clk_i,
    .rst_ni,
    .in_valid_i(factors_valid_i),
    .in_ready_o(factors_ready_o),
    .out_valid_o(squares_valid_o),
    .out_ready_i(squares_ready_i),
    .take_o(take),
    .claim_o(claim),
    .step_o(step),
    .held_o(),
    .phase_o(phase),
    .slots_o(slots),
    .busy_o
  );

  pipegs_pkg::factors_t in_q;
  pipegs_pkg::squares_t out_q;
  assign squares_o = out_q;

  // --- three squares; what is to be added before is added a phase earlier --------------------------------------------
  logic signed [FactorW-1:0] u0 [3], u1 [3], t [3];
  logic signed [BaseW-1:0]   base [3], both_q [3];
  logic [SquareW-1:0]        square [3], square_q [3];
  assign u0[0] = in_q.u0_0;
  assign u0[1] = in_q.u0_1;
  assign u0[2] = in_q.u0_2;
  assign u1[0] = in_q.u1_0;
  assign u1[1] = in_q.u1_1;
  assign u1[2] = in_q.u1_2;
  assign t[0]  = in_q.t_0;
  assign t[1]  = in_q.t_1;
  assign t[2]  = in_q.t_2;
  for (genvar i = 0; i < 3; i += 1) begin : gen_square
    always_comb begin
      (* parallel_case *) case (1'b1)
        phase[0]: base[i] = BaseW'(u0[i]);
        phase[1]: base[i] = BaseW'(u1[i]);
        phase[2]: base[i] = both_q[i];
        default: base[i] = BaseW'(t[i]);
      endcase
    end
    pipegs_square #(.DataW(BaseW)) u_square (
      .in_i(base[i]),
      .out_o(square[i])
    );
    always_ff @(posedge clk_i) if (step) begin
      both_q[i]   <= BaseW'(u0[i]) + BaseW'(u1[i]);
      square_q[i] <= square[i];
    end
  end

  // --- their sum, then normalised ------------------------------------------------------------------------------------
  logic        [WholeW-1:0]    whole, alone_q;  // alone: |u0|^2 + |u1|^2
  logic signed [SumW-1:0]      sum_q, normal;
  logic        [ShiftW-1:0]    shift, shift_q;
  logic signed [ExponentW-1:0] row_e, other_e, gain_e, e_q [3], e;  // e_q: of the squares, the sum, the mantissa
  logic signed [FactorW-1:0]   m_q;
  assign whole = WholeW'(square_q[0]) + WholeW'(square_q[1]) + WholeW'(square_q[2]);
  pipegs_normalize #(.DataW(SumW)) u_normalize (
    .in_i(sum_q),
    .out_o(normal),
    .shift_o(shift)
  );
  always_comb begin
    (* parallel_case *) case (1'b1)
      phase[0]: begin row_e = in_q.u0_e; other_e = in_q.u0_e; gain_e = in_q.gxx_e; end
      phase[1]: begin row_e = in_q.u1_e; other_e = in_q.u1_e; gain_e = in_q.gyy_e; end
      phase[2]: begin row_e = in_q.u0_e; other_e = in_q.u1_e; gain_e = in_q.gxy_e; end
      default: begin row_e = in_q.t_e; other_e = in_q.t_e; gain_e = in_q.gg_e; end
    endcase
  end
  assign e = e_q[2] - $signed(ExponentW'(shift_q));

  logic data;  // a Gaussian claims the output
  assign data = claim && in_q.kind == pipegs_pkg::KindData;
  always_ff @(posedge clk_i) begin
    if (take) in_q <= factors_i;
    if (step) begin
      alone_q  <= sum == 3'd0 ? whole : alone_q + whole;
      e_q[0]   <= row_e + other_e + gain_e + ExponentW'(Cut);
      e_q[1]   <= e_q[0];
      e_q[2]   <= e_q[1];
      m_q      <= normal[SumW-1:Cut];
      shift_q  <= shift;
      sum_q    <= sum == 3'd2 ? SumW'($signed(whole - alone_q) >>> 1) : SumW'(whole);
    end
    if (claim) begin
      out_q      <= '0;
      out_q.kind <= in_q.kind;
    end
    if (data) begin
      out_q.a_m   <= m_q[MantissaW-1:0];
      out_q.a_e   <= e;
      out_q.gxx_m <= in_q.gxx_m;
      out_q.gyy_m <= in_q.gyy_m;
      out_q.gxy_m <= in_q.gxy_m;
      out_q.gg_m  <= in_q.gg_m;
    end
    if (step && last_valid && out_q.kind == pipegs_pkg::KindData) begin
      case (last)
        3'd1: {out_q.c_m, out_q.c_e} <= {m_q[MantissaW-1:0], e};
        3'd2: {out_q.b_m, out_q.b_e} <= {m_q, e};
        3'd3: {out_q.d_m, out_q.d_e} <= {m_q[MantissaW-1:0], e};
        default: ;  // a goes with the claim
      endcase
    end
  end

  // Valid is only looked at beside results; bits below a mantissa are cut.
  wire unused_bits = &{1'b0, phase, slots, normal[Cut-1:0], whole};

endmodule
