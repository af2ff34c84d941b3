// SPDX-License-Identifier: Apache-2.0
// pu_covariance: the projected covariance in square pixels, dilated by 0.3, and its determinant.
//
// Paper   Eq. 1; the dilation of the reference rasteriser.
// Idea    a = gx^2 |u0|^2 + 0.3,  c = c0 + 0.3,  b = gx gy (u0 . u1),  det = (gx gy)^2 |u0 x u1|^2 + 0.3 (a + c0).
//         One multiplier and one adder of positive normalised numbers (align, then add):
//           cycle      0   1   2      3      4     5  6        7            8 = 0 of the next
//           multiply   a0  c0  d0     b               0.3 sum
//           align              a0+.3  c0+.3  a+c0              d0+.3 sum
//           add                       a      c     sum                      det
// Stream  squares in, covariance out, in order; an end beat passes with all other fields zero. What rides beside the
//         stages before, the mean and the opacity, joins here: pu_conic is the first that needs it.
// Pace    One record in eight cycles, latency 10; the output register is needed for two of the eight cycles only.
// Model   cpp_model/pu/project/pu_covariance.hpp

module pu_covariance (
  input  logic                     clk_i,
  input  logic                     rst_ni,

  input  logic                     squares_valid_i,
  output logic                     squares_ready_o,
  input  pipegs_pkg::squares_t     squares_i,
  input  pipegs_pkg::center_t      center_i,       // of the Gaussian in its last phase, in the same order
  output logic                     center_take_o,

  output logic                     covariance_valid_o,
  input  logic                     covariance_ready_i,
  output pipegs_pkg::covariance_t  covariance_o,

  output logic                     busy_o
);

  localparam int unsigned MantissaW = pipegs_pkg::MantissaW;
  localparam int unsigned FactorW   = pipegs_pkg::FactorW;
  localparam int unsigned SlopeW    = pipegs_pkg::SlopeW;
  localparam int unsigned FloatEW   = pipegs_pkg::FloatEW;
  localparam int unsigned ExponentW = pipegs_pkg::WideEW;
  localparam int unsigned ProductW  = MantissaW + 1 + FactorW;
  localparam int unsigned GuardW    = 2;
  localparam int unsigned AlignedW  = MantissaW + GuardW;

  // 0.3 = m 2^-(MantissaW+1), rounded to nearest.
  localparam logic [MantissaW-1:0] SmallM = MantissaW'(((64'd3 << (MantissaW + 1)) + 64'd5) / 64'd10);
  localparam logic signed [ExponentW-1:0] SmallE = ExponentW'(0) - ExponentW'(MantissaW + 1);

  logic        take, claim, step;
  logic [7:0]  phase;  // whose operands are chosen now
  logic [3:0]  slots;
  logic        late_valid;
  logic [2:0]  late;  // the phase one cycle ago
  assign {late_valid, late} = slots;

  pu_phases #(.Depth(pipegs_pkg::CovarianceDepth), .Claim(pipegs_pkg::CovarianceClaim)) u_phases (
    .clk_i,
    .rst_ni,
    .in_valid_i(squares_valid_i),
    .in_ready_o(squares_ready_o),
    .out_valid_o(covariance_valid_o),
    .out_ready_i(covariance_ready_i),
    .take_o(take),
    .claim_o(claim),
    .step_o(step),
    .held_o(),
    .phase_o(phase),
    .slots_o(slots),
    .busy_o
  );

  pipegs_pkg::squares_t    in_q;
  pipegs_pkg::covariance_t out_q;
  assign center_take_o = claim && in_q.kind == pipegs_pkg::KindData;

  // --- multiplier ---------------------------------------------------------------------------------------------------
  logic        [MantissaW-1:0]  left;
  logic signed [FactorW-1:0]    right;
  logic signed [ProductW-1:0]   product_q;
  logic        [MantissaW-1:0]  sum_m_q;  // the adder's last result
  logic signed [ExponentW-1:0]  sum_e_q;
  always_comb begin
    (* parallel_case *) case (1'b1)
      phase[0]: begin left = in_q.gxx_m; right = $signed({1'b0, in_q.a_m}); end
      phase[1]: begin left = in_q.gyy_m; right = $signed({1'b0, in_q.c_m}); end
      phase[2]: begin left = in_q.gg_m;  right = $signed({1'b0, in_q.d_m}); end
      phase[3]: begin left = in_q.gxy_m; right = in_q.b_m;                  end
      default: begin left = SmallM;     right = $signed({1'b0, sum_m_q});  end
    endcase
  end

  // A positive product has its leading one in bit 2 MantissaW - 1 or below; b the same with a sign.
  localparam int unsigned TopW = 2 * MantissaW;
  localparam int unsigned CutB = MantissaW + FactorW - SlopeW;
  logic                         top, top_b;
  logic        [MantissaW-1:0]  factor_m;
  logic signed [ExponentW-1:0]  rise, factor_e;
  logic signed [SlopeW-1:0]     b_m;
  assign top      = product_q[TopW-1];
  assign factor_m = top ? product_q[TopW-1:TopW-MantissaW] : product_q[TopW-2:TopW-1-MantissaW];
  assign rise     = ExponentW'(MantissaW - 1) + $signed({{(ExponentW - 1){1'b0}}, top});
  assign top_b    = product_q[TopW] != product_q[TopW-1];
  assign b_m      = top_b ? product_q[CutB+:SlopeW] : product_q[CutB-1+:SlopeW];
  always_comb begin
    case (late)
      3'd0:    factor_e = in_q.a_e + rise;
      3'd1:    factor_e = in_q.c_e + rise;
      3'd2:    factor_e = in_q.d_e + rise;
      default: factor_e = sum_e_q + SmallE + rise;
    endcase
  end

  // --- adder: align (x is the larger, zero counts as infinitely small), then add -----------------------------------
  logic        [MantissaW-1:0]  a0_m_q, c0_m_q, d0_m_q, a_m_q, c_m_q;
  logic signed [ExponentW-1:0]  a0_e_q, c0_e_q, d0_e_q, a_e_q, c_e_q;
  logic signed [SlopeW-1:0]     b_m_q;
  logic signed [ExponentW-1:0]  b_e_q;
  logic        [MantissaW-1:0]  x_m, y_m, big_m, little_m, big_m_q;
  logic signed [ExponentW-1:0]  x_e, y_e, big_e, big_e_q, apart;
  logic                         swap;
  logic        [AlignedW-1:0]   aligned, aligned_q;
  logic        [AlignedW:0]     sum;
  logic        [MantissaW-1:0]  sum_m;
  logic signed [ExponentW-1:0]  sum_e;
  always_comb begin
    y_m = SmallM;
    y_e = SmallE;
    (* parallel_case *) case (1'b1)
      phase[2]: begin x_m = a0_m_q; x_e = a0_e_q; end
      phase[3]: begin x_m = c0_m_q; x_e = c0_e_q; end
      phase[4]: begin x_m = a_m_q;  x_e = a_e_q;  y_m = c0_m_q;   y_e = c0_e_q;   end
      default: begin x_m = d0_m_q; x_e = d0_e_q; y_m = factor_m; y_e = factor_e; end
    endcase
    swap     = x_m == '0 || (y_m != '0 && y_e > x_e);
    big_m    = swap ? y_m : x_m;
    big_e    = swap ? y_e : x_e;
    little_m = swap ? x_m : y_m;
    apart    = swap ? y_e - x_e : x_e - y_e;
    aligned  = little_m == '0 ? '0 : {little_m, {GuardW{1'b0}}} >> $unsigned(apart);
    sum      = {1'b0, big_m_q, {GuardW{1'b0}}} + {1'b0, aligned_q};
    sum_m    = sum[AlignedW] ? sum[AlignedW-:MantissaW] : sum[AlignedW-1:AlignedW-MantissaW];
    sum_e    = big_e_q + $signed({{(ExponentW - 1){1'b0}}, sum[AlignedW]});
  end

  logic signed [FloatEW-1:0] a_e, b_e, c_e, det_e;
  pipegs_saturate #(.InW(ExponentW), .OutW(FloatEW)) u_a_e (
    .in_i(a_e_q),
    .out_o(a_e)
  );
  pipegs_saturate #(.InW(ExponentW), .OutW(FloatEW)) u_b_e (
    .in_i(b_e_q),
    .out_o(b_e)
  );
  pipegs_saturate #(.InW(ExponentW), .OutW(FloatEW)) u_c_e (
    .in_i(c_e_q),
    .out_o(c_e)
  );
  pipegs_saturate #(.InW(ExponentW), .OutW(FloatEW)) u_det_e (
    .in_i(sum_e),
    .out_o(det_e)
  );

  always_ff @(posedge clk_i) begin
    if (take) in_q <= squares_i;
    if (step) begin
      product_q <= ProductW'($signed({1'b0, left})) * ProductW'(right);
      big_m_q   <= big_m;
      big_e_q   <= big_e;
      aligned_q <= aligned;
      case (late)
        3'd0: begin a0_m_q <= factor_m; a0_e_q <= factor_e; end
        3'd1: begin c0_m_q <= factor_m; c0_e_q <= factor_e; end
        3'd2: begin d0_m_q <= factor_m; d0_e_q <= factor_e; a_m_q <= sum_m; a_e_q <= sum_e; end
        3'd3: begin
          b_m_q <= b_m;
          b_e_q <= in_q.b_e + ExponentW'(CutB - 1) + $signed({{(ExponentW - 1){1'b0}}, top_b});
          c_m_q <= sum_m;
          c_e_q <= sum_e;
        end
        3'd4: begin sum_m_q <= sum_m; sum_e_q <= sum_e; end
        default: ;
      endcase
    end
    if (claim) begin
      out_q      <= '0;
      out_q.kind <= in_q.kind;
      if (in_q.kind == pipegs_pkg::KindData) begin
        out_q.a_m <= a_m_q;
        out_q.a_e <= a_e;
        out_q.b_m <= b_m_q;
        out_q.b_e <= b_e;
        out_q.c_m <= c_m_q;
        out_q.c_e <= c_e;
        out_q.mean_x  <= center_i.mean_x;
        out_q.mean_y  <= center_i.mean_y;
        out_q.opacity <= center_i.opacity;
      end
    end
    if (step && late_valid && late == 3'd7 && out_q.kind == pipegs_pkg::KindData) begin
      out_q.det_m <= sum_m;
      out_q.det_e <= det_e;
    end
  end

  // --- the determinant before dilation, for pu_compensate ------------------------------------------------------------
  if (pipegs_pkg::Antialias == 1) begin : gen_sharp
    localparam int unsigned SharpW = pipegs_pkg::SharpW;
    logic        [SharpW-1:0]  sharp_m_q;
    logic signed [FloatEW-1:0] d0_e, sharp_e_q;
    pipegs_saturate #(.InW(ExponentW), .OutW(FloatEW)) u_d0_e (
      .in_i(d0_e_q),
      .out_o(d0_e)
    );
    always_ff @(posedge clk_i) begin
      if (claim) begin
        sharp_m_q <= in_q.kind == pipegs_pkg::KindData ? d0_m_q[MantissaW-1:MantissaW-SharpW] : '0;
        sharp_e_q <= in_q.kind == pipegs_pkg::KindData ? d0_e : '0;
      end
    end
    always_comb begin
      covariance_o         = out_q;
      covariance_o.sharp_m = sharp_m_q;
      covariance_o.sharp_e = sharp_e_q;
    end
  end else begin : gen_no_sharp
    assign covariance_o = out_q;
  end

  // Valid is only looked at beside results; bits below a mantissa and copies of the sign are cut.
  wire unused_bits = &{1'b0, phase, product_q[ProductW-1:TopW+1], product_q[CutB-2:0], sum[0]};

endmodule
