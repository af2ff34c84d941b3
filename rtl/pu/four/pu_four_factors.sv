// SPDX-License-Identifier: Apache-2.0
// pu_four_factors: pu_factors in four cycles: the rows of U = J W R diag(s) and their cross product.
//
// Paper   Eq. 1: Sigma = R S S^T R^T, kept as its factor.
// Idea    u0_j = v0_j s_j,  u1_j = v1_j s_j,  t_k = n_k s_i s_j. A row's largest exponent is known before its
//         products, so each product is aligned in the cycle after it. Multipliers as wide as they need to be, with
//         their operands in registers but for that of two scales:
//           phase    0        1        2        3
//           scales   s1 s2    s2 s0    s0 s1
//           rows     u0_0     u0_1     u0_2                  and the same of u1
//           cross    gx gy    t_0      t_1      t_2
//           square   gx^2     gy^2     (gx gy)^2
// Stream  jacobian in, factors out, in order; an end beat passes with all other fields zero.
// Pace    One record in four cycles, latency 7.
// Model   cpp_model/pu/project/pu_factors.hpp

module pu_four_factors (
  input  logic                   clk_i,
  input  logic                   rst_ni,

  input  logic                   jacobian_valid_i,
  output logic                   jacobian_ready_o,
  input  pipegs_pkg::jacobian_t  jacobian_i,

  output logic                   factors_valid_o,
  input  logic                   factors_ready_i,
  output pipegs_pkg::factors_t   factors_o,

  output logic                   busy_o
);

  localparam int unsigned MantissaW = pipegs_pkg::MantissaW;
  localparam int unsigned FactorW   = pipegs_pkg::FactorW;
  localparam int unsigned ScaleMW   = pipegs_pkg::ScaleMW;
  localparam int unsigned ScaleEW   = pipegs_pkg::ScaleEW;
  localparam int unsigned ScaleW    = pipegs_pkg::ScaleW;
  localparam int unsigned ExponentW = pipegs_pkg::WideEW;
  localparam int unsigned OneW      = ScaleMW + 1;                                  // a scale with its leading one
  localparam int unsigned BothW     = MantissaW < 2 * OneW ? MantissaW : 2 * OneW;  // a scale or two, left-aligned
  localparam int unsigned PowerW    = ScaleEW + 1;                                  // exponent field, or the sum of two
  localparam int unsigned Lowest    = 128;                                          // - exponent of a row of zeros
  localparam int unsigned Bias      = 8;                                            // of a scale's exponent field

  logic        take, claim, step;
  logic [3:0]  phase;  // whose operands are chosen now
  logic [7:0]  slots;
  logic        next_valid, late_valid;
  logic [2:0]  next, late;  // the phase one cycle ago: its operands; and two: its products
  assign {late_valid, late, next_valid, next} = slots;

  pu_phases #(
    .Phases(4),
    .Depth(pipegs_pkg::FactorsDepth),
    .Claim(pipegs_pkg::FactorsClaim)
  ) u_phases (
    .clk_i,
    .rst_ni,
    .in_valid_i(jacobian_valid_i),
    .in_ready_o(jacobian_ready_o),
    .out_valid_o(factors_valid_o),
    .out_ready_i(factors_ready_i),
    .take_o(take),
    .claim_o(claim),
    .step_o(step),
    .held_o(),
    .phase_o(phase),
    .slots_o(slots),
    .busy_o
  );

  pipegs_pkg::jacobian_t in_q;
  pipegs_pkg::factors_t  out_q;
  assign factors_o = out_q;

  // --- scales: leading one, zero when the exponent field is zero ---------------------------------------------------
  logic             some0, some1, some2;
  logic [OneW-1:0]  one0, one1, one2;
  logic [PowerW-1:0] power0, power1, power2;
  assign some0  = in_q.scale_0[ScaleW-1:ScaleMW] != '0;
  assign some1  = in_q.scale_1[ScaleW-1:ScaleMW] != '0;
  assign some2  = in_q.scale_2[ScaleW-1:ScaleMW] != '0;
  assign one0   = {some0, in_q.scale_0[ScaleMW-1:0] & {ScaleMW{some0}}};
  assign one1   = {some1, in_q.scale_1[ScaleMW-1:0] & {ScaleMW{some1}}};
  assign one2   = {some2, in_q.scale_2[ScaleMW-1:0] & {ScaleMW{some2}}};
  assign power0 = PowerW'(in_q.scale_0[ScaleW-1:ScaleMW]);
  assign power1 = PowerW'(in_q.scale_1[ScaleW-1:ScaleMW]);
  assign power2 = PowerW'(in_q.scale_2[ScaleW-1:ScaleMW]);

  // --- products ------------------------------------------------------------------------------------------------------
  localparam int unsigned RowW   = FactorW + OneW + 1;
  localparam int unsigned TopW   = 2 * MantissaW;
  localparam int unsigned RightW = BothW > MantissaW ? BothW + 1 : MantissaW + 1;
  logic [OneW-1:0]                scale_left, scale_right;
  logic [2*OneW-1:0]              pair;
  logic [BothW-1:0]               pair_q;                    // s1 s2, then s2 s0, then s0 s1
  logic signed [FactorW-1:0]      cross_left, cross_left_q, row0, row1, row0_q, row1_q;
  logic signed [RightW-1:0]       cross_right, cross_right_q;
  logic        [OneW-1:0]         row_right, row_right_q;
  logic signed [MantissaW:0]      gain, gain_q;              // a gain to be squared, with a sign of 0
  logic        [2*MantissaW:0]    square;
  logic        [TopW-1:0]         square_q;
  logic signed [FactorW+RightW-1:0] cross_q;
  logic signed [RowW-1:0]         product0_q, product1_q;
  logic                           cross_high, square_high;
  logic        [MantissaW-1:0]    cross_gain, square_gain;
  always_comb begin
    scale_left  = phase[1] ? one2 : phase[2] ? one0 : one1;
    scale_right = phase[1] ? one0 : phase[2] ? one1 : one2;
    (* parallel_case *) case (1'b1)
      phase[1]: begin row0 = in_q.v0_1_m; row1 = in_q.v1_1_m; row_right = one1; end
      phase[2]: begin row0 = in_q.v0_2_m; row1 = in_q.v1_2_m; row_right = one2; end
      default: begin row0 = in_q.v0_0_m; row1 = in_q.v1_0_m; row_right = one0; end
    endcase
    cross_right = $signed(RightW'(pair_q));
    gain        = $signed({1'b0, cross_gain});
    (* parallel_case *) case (1'b1)
      phase[0]: begin
        cross_left  = $signed({1'b0, in_q.gx_m});
        cross_right = $signed(RightW'(in_q.gy_m));
        gain        = $signed({1'b0, in_q.gx_m});
      end
      phase[1]: begin cross_left = in_q.n_0_m; gain = $signed({1'b0, in_q.gy_m}); end
      phase[2]: cross_left = in_q.n_1_m;
      default: cross_left = in_q.n_2_m;
    endcase
  end
  assign pair = (2 * OneW)'(scale_left) * (2 * OneW)'(scale_right);
  pipegs_square #(.DataW(MantissaW + 1)) u_square (
    .in_i(gain_q),
    .out_o(square)
  );
  // Of the products of two gains: normalised.
  assign cross_high  = cross_q[TopW-1];
  assign square_high = square_q[TopW-1];
  assign cross_gain  = cross_high ? cross_q[TopW-1-:MantissaW] : cross_q[TopW-2-:MantissaW];
  assign square_gain = square_high ? square_q[TopW-1-:MantissaW] : square_q[TopW-2-:MantissaW];

  // --- a row's largest exponent, in phase 0 -------------------------------------------------------------------------
  logic signed [ExponentW-1:0] e [9], top [3], top_q [3];
  logic                        some [9], any [3], any_q [3];
  logic        [PowerW-1:0]    power [6];  // of a scale, then of the two others
  always_comb begin
    power[0] = power0;
    power[1] = power1;
    power[2] = power2;
    power[3] = power1 + power2;
    power[4] = power2 + power0;
    power[5] = power0 + power1;
    e[0] = in_q.v0_0_e; some[0] = some0 && in_q.v0_0_m != '0;
    e[1] = in_q.v0_1_e; some[1] = some1 && in_q.v0_1_m != '0;
    e[2] = in_q.v0_2_e; some[2] = some2 && in_q.v0_2_m != '0;
    e[3] = in_q.v1_0_e; some[3] = some0 && in_q.v1_0_m != '0;
    e[4] = in_q.v1_1_e; some[4] = some1 && in_q.v1_1_m != '0;
    e[5] = in_q.v1_2_e; some[5] = some2 && in_q.v1_2_m != '0;
    e[6] = in_q.n_0_e;  some[6] = some1 && some2 && in_q.n_0_m != '0;
    e[7] = in_q.n_1_e;  some[7] = some2 && some0 && in_q.n_1_m != '0;
    e[8] = in_q.n_2_e;  some[8] = some0 && some1 && in_q.n_2_m != '0;
    for (int unsigned i = 0; i < 9; i += 1) e[i] = e[i] + $signed(ExponentW'(power[i < 6 ? i % 3 : i - 3]));
    for (int unsigned r = 0; r < 3; r += 1) begin
      any[r] = some[3*r];
      top[r] = e[3*r];
      for (int unsigned i = 3 * r + 1; i < 3 * r + 3; i += 1) begin
        if (some[i] && (!any[r] || e[i] > top[r])) top[r] = e[i];
        any[r] = any[r] || some[i];
      end
    end
  end

  // The exponent of the aligned row; the biases of one scale or of two are taken off here.
  function automatic logic signed [ExponentW-1:0] row_e(input logic any_one,
                                                        input logic signed [ExponentW-1:0] highest,
                                                        input int unsigned scales);
    row_e = any_one ? highest - ExponentW'(scales * (Bias - 1)) : ExponentW'(BothW) - ExponentW'(Lowest);
  endfunction

  // --- how far its row is above a product; then the product is aligned, rounded to nearest ---------------------------
  // Of u one cycle behind the phase, of t in it, as t_2 is issued in the last one.
  localparam int unsigned KeptW = 2 * FactorW - BothW + 1;  // with one bit for rounding
  localparam int unsigned WideW = KeptW + FactorW + RightW;  // no product is wider, nor what is kept
  logic signed [ExponentW-1:0] e0, e1, et, apart0_q, apart1_q, apart_t_q, ahead_q;
  // The bits that are kept, of a product as if both factors were FactorW wide and a scale at its left end.
  function automatic logic signed [KeptW-1:0] kept_row(input logic signed [RowW-1:0] product);
    kept_row = KeptW'(WideW'(product) >>> (OneW - 1));
  endfunction
  function automatic logic signed [KeptW-1:0] kept_cross(input logic signed [FactorW+RightW-1:0] product);
    kept_cross = KeptW'(WideW'(product) >>> (BothW - 1));
  endfunction

  logic signed [KeptW-1:0]     aligned0, aligned1, aligned_t;
  logic signed [FactorW-1:0]   m0, m1, mt;
  always_comb begin
    case (next)
      3'd0:    begin e0 = e[0]; e1 = e[3]; end
      3'd1:    begin e0 = e[1]; e1 = e[4]; end
      default: begin e0 = e[2]; e1 = e[5]; end
    endcase
    et        = phase[1] ? e[6] : phase[2] ? e[7] : e[8];
    aligned0  = kept_row(product0_q) >>> $unsigned(apart0_q);
    aligned1  = kept_row(product1_q) >>> $unsigned(apart1_q);
    aligned_t = kept_cross(cross_q) >>> $unsigned(apart_t_q);
    m0        = FactorW'((aligned0 + KeptW'(1)) >>> 1);
    m1        = FactorW'((aligned1 + KeptW'(1)) >>> 1);
    mt        = FactorW'((aligned_t + KeptW'(1)) >>> 1);
  end

  function automatic logic signed [ExponentW-1:0] flag(input logic bit_value);
    flag = $signed({{(ExponentW - 1){1'b0}}, bit_value});
  endfunction

  logic                        data;  // a Gaussian claims the output
  logic signed [ExponentW-1:0] gxy_e;
  assign data  = claim && in_q.kind == pipegs_pkg::KindData;
  assign gxy_e = in_q.gx_e + in_q.gy_e + ExponentW'(MantissaW - 1) + flag(cross_high);
  always_ff @(posedge clk_i) begin
    if (take) in_q <= jacobian_i;
    if (step) begin
      pair_q        <= pair[2*OneW-1-:BothW];
      {row0_q, row1_q, row_right_q} <= {row0, row1, row_right};
      cross_left_q  <= cross_left;
      cross_right_q <= cross_right;
      gain_q        <= gain;
      product0_q    <= RowW'(row0_q) * RowW'($signed({1'b0, row_right_q}));
      product1_q    <= RowW'(row1_q) * RowW'($signed({1'b0, row_right_q}));
      cross_q       <= (FactorW + RightW)'(cross_left_q) * (FactorW + RightW)'(cross_right_q);
      square_q      <= TopW'(square);
      for (int unsigned r = 0; r < 3; r += 1) if (phase[0]) {any_q[r], top_q[r]} <= {any[r], top[r]};
      // Negative only beside a product of zero.
      apart0_q      <= top_q[0] - e0;
      apart1_q      <= top_q[1] - e1;
      ahead_q       <= top_q[2] - et;
      apart_t_q     <= ahead_q;
    end
    if (claim) begin
      out_q      <= '0;
      out_q.kind <= in_q.kind;
    end
    if (data) begin  // what was issued in phase 0 is there
      out_q.u0_0  <= m0;
      out_q.u1_0  <= m1;
      out_q.u0_e  <= row_e(any_q[0], top_q[0], 1);
      out_q.u1_e  <= row_e(any_q[1], top_q[1], 1);
      out_q.t_e   <= row_e(any_q[2], top_q[2], 2);
      out_q.gxy_m <= cross_gain;
      out_q.gxy_e <= gxy_e;
      out_q.gxx_m <= square_gain;
      // Of the squares that follow one is added below when they are 2 or more.
      out_q.gxx_e <= (in_q.gx_e <<< 1) + ExponentW'(MantissaW - 1) + flag(square_high);
      out_q.gyy_e <= (in_q.gy_e <<< 1) + ExponentW'(MantissaW - 1);
      out_q.gg_e  <= (gxy_e <<< 1) + ExponentW'(MantissaW - 1);
    end
    if (step && late_valid && out_q.kind == pipegs_pkg::KindData) begin
      case (late)
        3'd1: begin
          out_q.u0_1  <= m0;
          out_q.u1_1  <= m1;
          out_q.t_0   <= mt;
          out_q.gyy_m <= square_gain;
          out_q.gyy_e <= out_q.gyy_e + flag(square_high);
        end
        3'd2: begin
          out_q.u0_2 <= m0;
          out_q.u1_2 <= m1;
          out_q.t_1  <= mt;
          out_q.gg_m <= square_gain;
          out_q.gg_e <= out_q.gg_e + flag(square_high);
        end
        3'd3: out_q.t_2 <= mt;
        default: ;  // what was issued in phase 0 goes with the claim
      endcase
    end
  end

  // The phase is only looked at beside products that count.
  wire unused_bits = &{1'b0, phase, next_valid, pair, square};

endmodule
