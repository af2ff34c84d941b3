// SPDX-License-Identifier: Apache-2.0
// pu_factors: brings in the scales: the rows of U = J W R diag(s) and their cross product, each with one exponent.
//
// Paper   Eq. 1: Sigma = R S S^T R^T, kept as its factor.
// Idea    u0_j = v0_j s_j,  u1_j = v1_j s_j,  t_k = n_k s_i s_j. A row's largest exponent is known before its
//         products, so each product is aligned in the cycle after it. Two multipliers, each with its operands in
//         registers:
//           phase 0  s1 s2, s2 s0    1  s0 s1, gx gy    2..4  u0_j, u1_j
//                 5  t_0, t_1        6  t_2, gx^2       7     gy^2, (gx gy)^2
// Stream  jacobian in, factors out, in order; an end beat passes with all other fields zero.
// Pace    One record in eight cycles, latency 11.
// Model   cpp_model/pu/project/pu_factors.hpp

module pu_factors (
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
  localparam int unsigned ProductW  = 2 * FactorW;
  localparam int unsigned OneW      = ScaleMW + 1;                                  // a scale with its leading one
  localparam int unsigned BothW     = MantissaW < 2 * OneW ? MantissaW : 2 * OneW;  // a scale or two, left-aligned
  localparam int unsigned PowerW    = ScaleEW + 1;                                  // exponent field, or the sum of two
  localparam int unsigned Lowest    = 128;                                          // - exponent of a row of zeros
  localparam int unsigned Bias      = 8;                                            // of a scale's exponent field

  logic        take, claim, step;
  logic [7:0]  phase;  // whose operands are chosen now
  logic [7:0]  slots;
  logic        next_valid, late_valid;
  logic [2:0]  next, late;  // the phase one cycle ago: its operands; and two: its products
  assign {late_valid, late, next_valid, next} = slots;

  pu_phases #(.Depth(pipegs_pkg::FactorsDepth), .Claim(pipegs_pkg::FactorsClaim)) u_phases (
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

  // --- two products ------------------------------------------------------------------------------------------------
  logic signed [FactorW-1:0]  left0, left1, right0, right1;
  logic signed [FactorW-1:0]  left0_q, left1_q, right0_q, right1_q;
  logic signed [ProductW-1:0] product0_q, product1_q;
  logic [BothW-1:0]           pair0_q, pair1_q, pair2_q;  // s1 s2, s2 s0, s0 s1
  logic [MantissaW-1:0]       gxy_m_q;
  always_comb begin
    left0  = in_q.n_2_m;
    left1  = $signed({1'b0, in_q.gx_m});
    right0 = $signed(FactorW'(pair2_q));
    right1 = $signed({1'b0, in_q.gx_m});
    (* parallel_case *) case (1'b1)
      phase[0]: begin
        left0 = $signed(FactorW'(one1)); right0 = $signed(FactorW'(one2));
        left1 = $signed(FactorW'(one2)); right1 = $signed(FactorW'(one0));
      end
      phase[1]: begin
        left0 = $signed(FactorW'(one0)); right0 = $signed(FactorW'(one1));
        right1 = $signed({1'b0, in_q.gy_m});
      end
      phase[2]: begin left0 = in_q.v0_0_m; left1 = in_q.v1_0_m; right0 = $signed(FactorW'(one0)) <<< (BothW - OneW); end
      phase[3]: begin left0 = in_q.v0_1_m; left1 = in_q.v1_1_m; right0 = $signed(FactorW'(one1)) <<< (BothW - OneW); end
      phase[4]: begin left0 = in_q.v0_2_m; left1 = in_q.v1_2_m; right0 = $signed(FactorW'(one2)) <<< (BothW - OneW); end
      phase[5]: begin
        left0 = in_q.n_0_m; right0 = $signed(FactorW'(pair0_q));
        left1 = in_q.n_1_m; right1 = $signed(FactorW'(pair1_q));
      end
      phase[7]: begin
        left0 = $signed({1'b0, in_q.gy_m}); right0 = $signed({1'b0, in_q.gy_m});
        left1 = $signed({1'b0, gxy_m_q});   right1 = $signed({1'b0, gxy_m_q});
      end
      default: ;
    endcase
    if (phase[4:2] != '0) right1 = right0;
  end

  // --- a row's largest exponent: in phase 2 those of u0 and u1, in phase 5 that of t -------------------------------
  logic signed [ExponentW-1:0] e [6];
  logic                        some [6];
  logic        [PowerW-1:0]    power [3];
  logic signed [ExponentW-1:0] top0, top1, top0_q, top1_q;
  logic                        any0, any1, any0_q, any1_q;
  always_comb begin
    power[0] = power0;
    power[1] = power1;
    power[2] = power2;
    e[0] = in_q.v0_0_e; some[0] = some0 && in_q.v0_0_m != '0;
    e[1] = in_q.v0_1_e; some[1] = some1 && in_q.v0_1_m != '0;
    e[2] = in_q.v0_2_e; some[2] = some2 && in_q.v0_2_m != '0;
    e[3] = in_q.v1_0_e; some[3] = some0 && in_q.v1_0_m != '0;
    e[4] = in_q.v1_1_e; some[4] = some1 && in_q.v1_1_m != '0;
    e[5] = in_q.v1_2_e; some[5] = some2 && in_q.v1_2_m != '0;
    if (phase[5]) begin
      power[0] = power1 + power2;
      power[1] = power2 + power0;
      power[2] = power0 + power1;
      e[0] = in_q.n_0_e; some[0] = some1 && some2 && in_q.n_0_m != '0;
      e[1] = in_q.n_1_e; some[1] = some2 && some0 && in_q.n_1_m != '0;
      e[2] = in_q.n_2_e; some[2] = some0 && some1 && in_q.n_2_m != '0;
    end
    for (int unsigned i = 0; i < 6; i += 1) e[i] = e[i] + $signed(ExponentW'(power[i%3]));
    any0 = some[0];
    top0 = e[0];
    if (some[1] && (!any0 || e[1] > top0)) top0 = e[1];
    any0 = any0 || some[1];
    if (some[2] && (!any0 || e[2] > top0)) top0 = e[2];
    any0 = any0 || some[2];
    any1 = some[3];
    top1 = e[3];
    if (some[4] && (!any1 || e[4] > top1)) top1 = e[4];
    any1 = any1 || some[4];
    if (some[5] && (!any1 || e[5] > top1)) top1 = e[5];
    any1 = any1 || some[5];
  end

  // The exponent of the aligned row; the biases of one scale or of two are taken off here.
  function automatic logic signed [ExponentW-1:0] row_e(input logic any, input logic signed [ExponentW-1:0] top,
                                                        input int unsigned scales);
    row_e = any ? top - ExponentW'(scales * (Bias - 1)) : ExponentW'(BothW) - ExponentW'(Lowest);
  endfunction

  // --- one cycle later: how far its row is above the product; then the product is aligned, rounded to nearest --------
  localparam int unsigned KeptW = ProductW - BothW + 1;  // with one bit for rounding
  logic signed [ExponentW-1:0] e0, e1, apart0_q, apart1_q;
  logic        [PowerW-1:0]    next_power0, next_power1;
  logic signed [KeptW-1:0]     aligned0, aligned1;
  logic signed [FactorW-1:0]   m0, m1;
  always_comb begin
    case (next)
      3'd2:    begin e0 = in_q.v0_0_e; e1 = in_q.v1_0_e; next_power0 = power0; next_power1 = power0; end
      3'd3:    begin e0 = in_q.v0_1_e; e1 = in_q.v1_1_e; next_power0 = power1; next_power1 = power1; end
      3'd4:    begin e0 = in_q.v0_2_e; e1 = in_q.v1_2_e; next_power0 = power2; next_power1 = power2; end
      3'd5: begin
        e0 = in_q.n_0_e; next_power0 = power1 + power2;
        e1 = in_q.n_1_e; next_power1 = power2 + power0;
      end
      default: begin
        e0 = in_q.n_2_e; next_power0 = power0 + power1;
        e1 = in_q.n_2_e; next_power1 = power0 + power1;
      end
    endcase
    aligned0 = $signed(product0_q[ProductW-1:ProductW-KeptW]) >>> $unsigned(apart0_q);
    aligned1 = $signed(product1_q[ProductW-1:ProductW-KeptW]) >>> $unsigned(apart1_q);
    m0       = FactorW'((aligned0 + KeptW'(1)) >>> 1);
    m1       = FactorW'((aligned1 + KeptW'(1)) >>> 1);
  end

  // --- products of the gains, normalised ---------------------------------------------------------------------------
  localparam int unsigned TopW = 2 * MantissaW;
  logic                        high0, high1;
  logic        [MantissaW-1:0] gain0, gain1;
  logic signed [ExponentW-1:0] gxy_e_q;
  assign high0 = product0_q[TopW-1];
  assign high1 = product1_q[TopW-1];
  assign gain0 = high0 ? product0_q[TopW-1:TopW-MantissaW] : product0_q[TopW-2:TopW-1-MantissaW];
  assign gain1 = high1 ? product1_q[TopW-1:TopW-MantissaW] : product1_q[TopW-2:TopW-1-MantissaW];

  function automatic logic signed [ExponentW-1:0] flag(input logic bit_value);
    flag = $signed({{(ExponentW - 1){1'b0}}, bit_value});
  endfunction

  always_ff @(posedge clk_i) begin
    if (take) in_q <= jacobian_i;
    if (step) begin
      {left0_q, left1_q, right0_q, right1_q} <= {left0, left1, right0, right1};
      product0_q <= ProductW'(left0_q) * ProductW'(right0_q);
      product1_q <= ProductW'(left1_q) * ProductW'(right1_q);
      // Negative only beside a product of zero.
      apart0_q <= top0_q - e0 - $signed(ExponentW'(next_power0));
      apart1_q <= top1_q - e1 - $signed(ExponentW'(next_power1));
      if (phase[2] || phase[5]) begin
        {any0_q, top0_q} <= {any0, top0};
        {any1_q, top1_q} <= phase[5] ? {any0, top0} : {any1, top1};
      end
      if (late == 3'd0) pair0_q <= product0_q[2*OneW-1-:BothW];
      if (late == 3'd0) pair1_q <= product1_q[2*OneW-1-:BothW];
      if (late == 3'd1) begin
        pair2_q <= product0_q[2*OneW-1-:BothW];
        gxy_m_q <= gain1;
        gxy_e_q <= in_q.gx_e + in_q.gy_e + ExponentW'(MantissaW - 1) + flag(high1);
      end
    end
    if (claim) begin
      out_q      <= '0;
      out_q.kind <= in_q.kind;
      if (in_q.kind == pipegs_pkg::KindData) begin
        // One is added below when the product is 2 or more.
        out_q.gxx_e <= (in_q.gx_e <<< 1) + ExponentW'(MantissaW - 1);
        out_q.gyy_e <= (in_q.gy_e <<< 1) + ExponentW'(MantissaW - 1);
      end
    end
    if (step && late_valid && out_q.kind == pipegs_pkg::KindData) begin
      case (late)
        3'd2: begin
          out_q.u0_0  <= m0;
          out_q.u1_0  <= m1;
          out_q.u0_e  <= row_e(any0_q, top0_q, 1);
          out_q.u1_e  <= row_e(any1_q, top1_q, 1);
          out_q.gxy_m <= gxy_m_q;
          out_q.gxy_e <= gxy_e_q;
          out_q.gg_e  <= (gxy_e_q <<< 1) + ExponentW'(MantissaW - 1);
        end
        3'd3: begin out_q.u0_1 <= m0; out_q.u1_1 <= m1; end
        3'd4: begin out_q.u0_2 <= m0; out_q.u1_2 <= m1; end
        3'd5: begin
          out_q.t_0 <= m0;
          out_q.t_1 <= m1;
          out_q.t_e <= row_e(any0_q, top0_q, 2);
        end
        3'd6: begin
          out_q.t_2   <= m0;
          out_q.gxx_m <= gain1;
          out_q.gxx_e <= out_q.gxx_e + flag(high1);
        end
        3'd7: begin
          out_q.gyy_m <= gain0;
          out_q.gyy_e <= out_q.gyy_e + flag(high0);
          out_q.gg_m  <= gain1;
          out_q.gg_e  <= out_q.gg_e + flag(high1);
        end
        default: ;
      endcase
    end
  end

  wire unused_bits = &{1'b0, phase, next_valid};  // the phase is only looked at beside products that count

endmodule
