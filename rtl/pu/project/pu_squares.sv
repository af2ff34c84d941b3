// SPDX-License-Identifier: Apache-2.0
// pu_squares: the sums of squares and products of the factors: |u0|^2, |u1|^2, u0 . u1 and |u0 x u1|^2.
//
// Paper   Eq. 1: Sigma' = U U^T.
// Idea    Two multipliers and two accumulators: phase 0..2 u0_j^2 and u1_j^2, phase 3..5 u0_j u1_j and t_j^2. One
//         normaliser takes the four sums in turn; the second sum of a pair waits one cycle in spare_q:
//           cycle      0  1  2  3  4      5      6  7      8 = 0 of the next
//           multiply   ac ac ac bd bd     bd
//           add           ac ac ac bd     bd     bd
//           normalise              a      c         b      d
//         A normalised sum is written one cycle later.
// Stream  factors in, squares out, in order; an end beat passes with all other fields zero.
// Pace    One record in eight cycles, latency 11.
// Model   cpp_model/pu/project/pu_squares.hpp

module pu_squares (
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
  localparam int unsigned SumW      = 2 * FactorW + 1;
  localparam int unsigned ShiftW    = $clog2(SumW);
  localparam int unsigned Cut       = SumW - FactorW;  // bits below a mantissa

  logic        take, claim, step;
  logic [7:0]  phase;  // whose operands are chosen now
  logic [7:0]  slots;
  logic        sum_valid, write_valid;
  logic [2:0]  sum, write;  // phase of the products, of what is normal
  assign {write_valid, write, sum_valid, sum} = slots;

  pu_phases #(.Depth(pipegs_pkg::SquaresDepth), .Claim(pipegs_pkg::SquaresClaim)) u_phases (
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

  logic signed [FactorW-1:0]   left0, right0, left1, right1;
  logic signed [2*FactorW-1:0] product0_q, product1_q;
  logic signed [SumW-1:0]      sum0_q, sum1_q, spare_q;
  always_comb begin
    (* parallel_case *) case (1'b1)
      phase[0]: begin left0 = in_q.u0_0; right0 = in_q.u0_0; left1 = in_q.u1_0; right1 = in_q.u1_0; end
      phase[1]: begin left0 = in_q.u0_1; right0 = in_q.u0_1; left1 = in_q.u1_1; right1 = in_q.u1_1; end
      phase[2]: begin left0 = in_q.u0_2; right0 = in_q.u0_2; left1 = in_q.u1_2; right1 = in_q.u1_2; end
      phase[3]: begin left0 = in_q.u0_0; right0 = in_q.u1_0; left1 = in_q.t_0;  right1 = in_q.t_0;  end
      phase[4]: begin left0 = in_q.u0_1; right0 = in_q.u1_1; left1 = in_q.t_1;  right1 = in_q.t_1;  end
      default: begin left0 = in_q.u0_2; right0 = in_q.u1_2; left1 = in_q.t_2;  right1 = in_q.t_2;  end
    endcase
  end

  // The first sum of a pair is normalised when the phase after its last is being added, the other one cycle later.
  logic signed [SumW-1:0]      ready, normal;
  logic        [ShiftW-1:0]    shift;
  logic signed [FactorW-1:0]   m_q;
  logic signed [ExponentW-1:0] less_q;
  assign ready = sum == 3'd3 || sum == 3'd6 ? sum0_q : spare_q;
  pipegs_normalize #(.DataW(SumW)) u_normalize (
    .in_i(ready),
    .out_o(normal),
    .shift_o(shift)
  );

  logic signed [SumW-1:0] wide0, wide1;
  assign wide0 = SumW'(product0_q);
  assign wide1 = SumW'(product1_q);

  always_ff @(posedge clk_i) begin
    if (take) in_q <= factors_i;
    if (step) begin
      product0_q <= (2 * FactorW)'(left0) * (2 * FactorW)'(right0);
      product1_q <= (2 * FactorW)'(left1) * (2 * FactorW)'(right1);
      if (sum <= 3'd5) begin
        sum0_q <= sum == 3'd0 || sum == 3'd3 ? wide0 : sum0_q + wide0;
        sum1_q <= sum == 3'd0 || sum == 3'd3 ? wide1 : sum1_q + wide1;
      end
      if (sum == 3'd3 || sum == 3'd6) spare_q <= sum1_q;
      m_q    <= normal[SumW-1:SumW-FactorW];
      less_q <= $signed(ExponentW'(shift));
    end
    if (claim) begin
      out_q      <= '0;
      out_q.kind <= in_q.kind;
      if (in_q.kind == pipegs_pkg::KindData) begin
        // The shifts are subtracted below.
        out_q.a_e <= (in_q.u0_e <<< 1) + in_q.gxx_e + ExponentW'(Cut);
        out_q.c_e <= (in_q.u1_e <<< 1) + in_q.gyy_e + ExponentW'(Cut);
        out_q.d_e <= (in_q.t_e <<< 1) + in_q.gg_e + ExponentW'(Cut);
        out_q.b_e <= in_q.u0_e + in_q.u1_e + in_q.gxy_e + ExponentW'(Cut);
        out_q.gxx_m   <= in_q.gxx_m;
        out_q.gyy_m   <= in_q.gyy_m;
        out_q.gxy_m   <= in_q.gxy_m;
        out_q.gg_m    <= in_q.gg_m;
      end
    end
    if (step && write_valid && out_q.kind == pipegs_pkg::KindData) begin
      case (write)
        3'd3: begin out_q.a_m <= m_q[MantissaW-1:0]; out_q.a_e <= out_q.a_e - less_q; end
        3'd4: begin out_q.c_m <= m_q[MantissaW-1:0]; out_q.c_e <= out_q.c_e - less_q; end
        3'd6: begin out_q.b_m <= m_q;                out_q.b_e <= out_q.b_e - less_q; end
        3'd7: begin out_q.d_m <= m_q[MantissaW-1:0]; out_q.d_e <= out_q.d_e - less_q; end
        default: ;
      endcase
    end
  end

  // Valid is only looked at beside results; bits below a mantissa are cut.
  wire unused_bits = &{1'b0, phase, sum_valid, normal[Cut-1:0]};

endmodule
