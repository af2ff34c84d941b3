// SPDX-License-Identifier: Apache-2.0
// pu_four_covariance: pu_covariance in four cycles: the covariance, dilated by 0.3, and its determinant.
//
// Paper   Eq. 1; the dilation of the reference rasteriser.
// Idea    a = gx^2 |u0|^2 + 0.3,  c = c0 + 0.3,  b = gx gy (u0 . u1),  det = (gx gy)^2 |u0 x u1|^2 + 0.3 (a + c0).
//         One multiplier, one by the constant 0.3, an adder for each of two times behind a phase (align, then add):
//           cycle      0   1      2      3  4      5    6        7            8
//           multiply   a0  c0     b      d0
//           align          a0+.3  c0+.3     a+c0                 d0+.3 sum
//           add                   a      c         sum                        det
//           times 0.3                                   sum
// Stream  squares in, covariance out, in order; an end beat passes with all other fields zero. What rides beside the
//         stages before, the mean and the opacity, joins here: pu_conic is the first that needs it.
// Pace    One record in four cycles, latency 10.
// Model   cpp_model/pu/project/pu_covariance.hpp

module pu_four_covariance (
  input  logic                     clk_i,
  input  logic                     rst_ni,

  input  logic                     squares_valid_i,
  output logic                     squares_ready_o,
  input  pipegs_pkg::squares_t     squares_i,
  input  pipegs_pkg::center_t      center_i,       // of the Gaussian that claims the output, in order
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

  localparam int unsigned Depth = pipegs_pkg::CovarianceDepth;
  logic                 take, claim, step;
  logic [3:0]           phase;  // whose operands are chosen now
  logic [4*Depth-1:0]    slots;

  pu_phases #(
    .Phases(4),
    .Depth(Depth),
    .Claim(pipegs_pkg::CovarianceClaim)
  ) u_phases (
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

  pipegs_pkg::squares_t         in_q;
  pipegs_pkg::covariance_t      out_q;
  logic [pipegs_pkg::KindW-1:0] kind_q;  // of the record behind its phases
  logic [3:0]                   first;   // the phase one cycle ago
  for (genvar i = 0; i < 4; i += 1) begin : gen_first
    assign first[i] = slots[2:0] == 3'(i);
  end
  assign center_take_o = claim && kind_q == pipegs_pkg::KindData;

  // --- multiplier ---------------------------------------------------------------------------------------------------
  logic        [MantissaW-1:0]  left;
  logic signed [FactorW-1:0]    right;
  logic signed [ProductW-1:0]   product_q;
  logic signed [ExponentW-1:0]  exponent, exponent_q;  // beside the product
  always_comb begin
    (* parallel_case *) case (1'b1)
      phase[0]: begin left = in_q.gxx_m; right = $signed({1'b0, in_q.a_m}); exponent = in_q.a_e; end
      phase[1]: begin left = in_q.gyy_m; right = $signed({1'b0, in_q.c_m}); exponent = in_q.c_e; end
      phase[2]: begin left = in_q.gxy_m; right = in_q.b_m;                  exponent = in_q.b_e; end
      default: begin left = in_q.gg_m;  right = $signed({1'b0, in_q.d_m}); exponent = in_q.d_e; end
    endcase
  end

  // A positive product has its leading one in bit 2 MantissaW - 1 or below; b the same with a sign.
  localparam int unsigned TopW = 2 * MantissaW;
  localparam int unsigned CutB = MantissaW + FactorW - SlopeW;
  logic                         top, top_b;
  logic        [MantissaW-1:0]  factor_m;
  logic signed [ExponentW-1:0]  factor_e;
  logic signed [SlopeW-1:0]     b_m;

  function automatic logic signed [ExponentW-1:0] flag(input logic bit_value);
    flag = $signed({{(ExponentW - 1){1'b0}}, bit_value});
  endfunction
  assign top      = product_q[TopW-1];
  assign factor_m = top ? product_q[TopW-1:TopW-MantissaW] : product_q[TopW-2:TopW-1-MantissaW];
  assign factor_e = exponent_q + ExponentW'(MantissaW - 1) + flag(top);
  assign top_b    = product_q[TopW] != product_q[TopW-1];
  assign b_m      = top_b ? product_q[CutB+:SlopeW] : product_q[CutB-1+:SlopeW];

  // --- adders: align (x is the larger, zero counts as infinitely small), then add ------------------------------------
  typedef struct packed {
    logic        [MantissaW-1:0] m;
    logic signed [ExponentW-1:0] e;
  } number_t;
  localparam int unsigned NumberW = MantissaW + ExponentW;
  localparam number_t Small = {SmallM, SmallE};
  logic [2*NumberW-1:0]        totals;
  number_t                     factor, sum, sum_q, a_q, c0_q, c_q, d0_q, part, det;
  logic signed [SlopeW-1:0]    b_m_q;
  logic signed [ExponentW-1:0] b_e_q, part_e_q;
  logic        [TopW-1:0]      part_q;  // 0.3 times the sum
  assign factor = {factor_m, factor_e};
  assign {det, sum} = totals;
  assign part.m = part_q[TopW-1] ? part_q[TopW-1-:MantissaW] : part_q[TopW-2-:MantissaW];
  assign part.e = part_e_q + flag(part_q[TopW-1]);

  for (genvar i = 0; i < 2; i += 1) begin : gen_adder
    logic        [MantissaW-1:0] x_m, y_m;
    logic signed [ExponentW-1:0] x_e, y_e;
    assign {x_m, x_e} = i == 1 ? d0_q : first[3] ? a_q : factor;
    assign {y_m, y_e} = i == 1 ? part : first[3] ? c0_q : Small;
    logic                        swap;
    logic        [MantissaW-1:0] little;
    logic signed [ExponentW-1:0] apart;
    logic        [MantissaW-1:0] big_m_q;
    logic signed [ExponentW-1:0] big_e_q;
    logic        [AlignedW-1:0]  aligned_q;
    logic        [AlignedW:0]    exact;
    assign swap       = x_m == '0 || (y_m != '0 && y_e > x_e);
    assign little     = swap ? x_m : y_m;
    assign apart      = swap ? y_e - x_e : x_e - y_e;
    assign exact      = {1'b0, big_m_q, {GuardW{1'b0}}} + {1'b0, aligned_q};
    assign totals[i*NumberW+:NumberW] = {
      exact[AlignedW] ? exact[AlignedW-:MantissaW] : exact[AlignedW-1:AlignedW-MantissaW],
      big_e_q + flag(exact[AlignedW])
    };
    always_ff @(posedge clk_i) if (step) begin
      big_m_q   <= swap ? y_m : x_m;
      big_e_q   <= swap ? y_e : x_e;
      aligned_q <= little == '0 ? '0 : {little, {GuardW{1'b0}}} >> $unsigned(apart);
    end
  end

  logic signed [FloatEW-1:0] a_e, b_e, c_e, det_e;
  pipegs_saturate #(.InW(ExponentW), .OutW(FloatEW)) u_a_e (
    .in_i(a_q.e),
    .out_o(a_e)
  );
  pipegs_saturate #(.InW(ExponentW), .OutW(FloatEW)) u_b_e (
    .in_i(b_e_q),
    .out_o(b_e)
  );
  pipegs_saturate #(.InW(ExponentW), .OutW(FloatEW)) u_c_e (
    .in_i(c_q.e),
    .out_o(c_e)
  );
  pipegs_saturate #(.InW(ExponentW), .OutW(FloatEW)) u_det_e (
    .in_i(det.e),
    .out_o(det_e)
  );

  always_ff @(posedge clk_i) begin
    if (take) in_q <= squares_i;
    if (step) begin
      if (phase[3]) kind_q <= in_q.kind;
      product_q  <= ProductW'($signed({1'b0, left})) * ProductW'(right);
      exponent_q <= exponent;
      if (first[1]) {a_q, c0_q} <= {sum, factor};
      if (first[2]) begin
        c_q   <= sum;
        b_m_q <= b_m;
        b_e_q <= exponent_q + ExponentW'(CutB - 1) + flag(top_b);
      end
      if (first[3]) d0_q <= factor;
      sum_q    <= sum;
      part_q   <= TopW'(sum_q.m) * TopW'(SmallM);
      part_e_q <= sum_q.e + SmallE + ExponentW'(MantissaW - 1);
    end
    if (claim) begin
      out_q      <= '0;
      out_q.kind <= kind_q;
      if (kind_q == pipegs_pkg::KindData) begin
        out_q.a_m <= a_q.m;
        out_q.a_e <= a_e;
        out_q.b_m <= b_m_q;
        out_q.b_e <= b_e;
        out_q.c_m <= c_q.m;
        out_q.c_e <= c_e;
        out_q.mean_x  <= center_i.mean_x;
        out_q.mean_y  <= center_i.mean_y;
        out_q.opacity <= center_i.opacity;
      end
    end
    if (step && slots[4*Depth-4+:4] == 4'b1011 && out_q.kind == pipegs_pkg::KindData) begin
      out_q.det_m <= det.m;
      out_q.det_e <= det_e;
    end
  end

  // --- the determinant before dilation, for pu_compensate ------------------------------------------------------------
  if (pipegs_pkg::Antialias == 1) begin : gen_sharp
    localparam int unsigned SharpW = pipegs_pkg::SharpW;
    logic        [SharpW-1:0]  sharp_m_q;
    logic signed [FloatEW-1:0] d0_e, sharp_e_q;
    pipegs_saturate #(.InW(ExponentW), .OutW(FloatEW)) u_d0_e (
      .in_i(d0_q.e),
      .out_o(d0_e)
    );
    always_ff @(posedge clk_i) begin
      if (claim) begin
        sharp_m_q <= kind_q == pipegs_pkg::KindData ? d0_q.m[MantissaW-1:MantissaW-SharpW] : '0;
        sharp_e_q <= kind_q == pipegs_pkg::KindData ? d0_e : '0;
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
  wire unused_bits = &{1'b0, phase, first, slots, product_q[ProductW-1:TopW+1], product_q[CutB-2:0]};

endmodule
