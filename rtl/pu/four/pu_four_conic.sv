// SPDX-License-Identifier: Apache-2.0
// pu_four_conic: pu_conic in four cycles: the inverse of the covariance, as two curvatures, a slope, and a box.
//
// Paper   Eq. 1 (the exponent), k = log2(e)/2 folded in: alpha = 2^power.
// Idea    Eliminate the narrower axis (x if c >= a, else exchange x and y); larger = max(a, c):
//           wide = k / larger,  narrow = k larger / det,  slope = b / larger,  extent = sqrt(variance * budget)
// Stream  covariance in, conic out, in order; an end beat passes with all other fields zero.
// Pace    One record in four cycles, latency 16. One multiplier, one by the constant k, one reciprocal, four roots: two
//         for each of two records, as a root takes seven cycles.
//           cycle  0    1      2     3      4      5      6       7   ..  12    13     14
//           recip  det  larger       ->     ->
//           mult                     less t more t slope  narrow
//           times k                         1/det  wide
//           roots                           less: 5 .. 11
//                                                  more: 6 .. 12          scale scale  out
// Model   cpp_model/pu/conic/pu_conic.hpp

module pu_four_conic (
  input  logic                     clk_i,
  input  logic                     rst_ni,

  input  logic                     covariance_valid_i,
  output logic                     covariance_ready_o,
  input  pipegs_pkg::covariance_t  covariance_i,

  output logic                     conic_valid_o,
  input  logic                     conic_ready_i,
  output pipegs_pkg::conic_t       conic_o,

  output logic                     busy_o  // a record is inside
);

  localparam int unsigned MantissaW = pipegs_pkg::MantissaW;
  localparam int unsigned FloatEW   = pipegs_pkg::FloatEW;
  localparam int unsigned SlopeW    = pipegs_pkg::SlopeW;
  localparam int unsigned SlopeF    = SlopeW - 2;
  localparam int unsigned OpacityW  = pipegs_pkg::OpacityW;
  localparam int unsigned ExtentW   = pipegs_pkg::ExtentW;
  localparam int unsigned LeftW     = MantissaW + 1 > SlopeW ? MantissaW + 1 : SlopeW;
  localparam int unsigned RightW    = MantissaW > OpacityW ? MantissaW + 1 : OpacityW + 1;
  localparam int unsigned ProductW  = LeftW + RightW;
  localparam int unsigned ShiftW    = 7;
  localparam int unsigned SumW      = FloatEW + 4;  // sums of exponents

  // log2(e)/2, u0.MantissaW, from 32 fraction bits.
  localparam int unsigned KF  = 32;
  localparam logic [KF-1:0] KFull = 32'd3098164009;
  localparam logic [MantissaW-1:0] K = MantissaW'(((KFull >> (KF - MantissaW - 1)) + KF'(1)) >> 1);

  localparam int unsigned Depth = pipegs_pkg::ConicDepth;

  // What a record keeps behind its phases while it is calculated.
  typedef struct packed {
    logic signed [SlopeW-1:0]  b_m;
    logic signed [FloatEW-1:0] b_e;
    logic [MantissaW-1:0]      more_m;  // the larger variance
    logic signed [FloatEW-1:0] more_e;
    logic signed [FloatEW-1:0] less_e;  // of the other one
    logic signed [FloatEW-1:0] det_e;
  } front_t;
  // What passes.
  typedef struct packed {
    logic [pipegs_pkg::KindW-1:0]        kind;
    logic                                swap;
    logic                                second;  // which set of roots
    logic signed [pipegs_pkg::MeanW-1:0] mean_x;
    logic signed [pipegs_pkg::MeanW-1:0] mean_y;
    logic [OpacityW-1:0]                 opacity;
  } ride_t;
  // What is known in cycle 8.
  typedef struct packed {
    logic [MantissaW-1:0]      wide_m;
    logic signed [FloatEW-1:0] wide_e;
    logic [MantissaW-1:0]      narrow_m;
    logic signed [FloatEW-1:0] narrow_e;
    logic signed [SlopeW-1:0]  slope;
  } known_t;

  logic                    take, claim, step, held;
  logic [3:0]              phase;
  logic [4*Depth-1:0]      slots;
  pipegs_pkg::covariance_t in_q;
  front_t                  front_q;
  ride_t                   ride_4_q, ride_8_q, ride_12_q;  // from these cycles on
  known_t                  known_9_q, known_13_q;
  pipegs_pkg::conic_t      conic_q;

  pu_phases #(
    .Phases(4),
    .Depth(Depth),
    .Claim(pipegs_pkg::ConicClaim)
  ) u_phases (
    .clk_i,
    .rst_ni,
    .in_valid_i(covariance_valid_i),
    .in_ready_o(covariance_ready_o),
    .out_valid_o(conic_valid_o),
    .out_ready_i(conic_ready_i),
    .take_o(take),
    .claim_o(claim),
    .step_o(step),
    .held_o(held),
    .phase_o(phase),
    .slots_o(slots),
    .busy_o
  );
  // A record's cycle from 4 on: its last phase is so many levels away.
  logic [14:4] cycle;
  for (genvar i = 4; i <= 14; i += 1) begin : gen_cycle
    assign cycle[i] = slots[4*(i-4)+:4] == 4'b1011;
  end

  // --- which variance is the larger one ----------------------------------------------------------------------------
  logic                      swap;
  logic [MantissaW-1:0]      less_m, more_m, less_m_q;  // less_m_q: in front of the multiplier there is no comparison
  logic signed [FloatEW-1:0] less_e, more_e;
  assign swap   = in_q.a_e > in_q.c_e || (in_q.a_e == in_q.c_e && in_q.a_m > in_q.c_m);
  assign more_m = swap ? in_q.a_m : in_q.c_m;
  assign more_e = swap ? in_q.a_e : in_q.c_e;
  assign less_m = swap ? in_q.c_m : in_q.a_m;
  assign less_e = swap ? in_q.c_e : in_q.a_e;

  // --- reciprocals: they come four cycles later, whether the stage stands still or not: then each is kept ----------
  logic                 recip_valid, second_q;
  logic [MantissaW-1:0] recip, inverse_det, inverse, inverse_q, inverse_det_q;

  pipegs_recip #(.DataW(MantissaW)) u_recip (
    .clk_i,
    .rst_ni,
    .in_valid_i(held && step && (phase[0] || phase[1])),
    .in_i(phase[0] ? in_q.det_m : more_m),
    .out_valid_o(recip_valid),
    .out_o(recip)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) second_q <= 1'b0;
    else if (recip_valid) second_q <= !second_q;
  end
  always_ff @(posedge clk_i) begin
    if (recip_valid && !second_q) inverse_det_q <= recip;
    if (recip_valid && second_q) inverse_q <= recip;
  end
  assign inverse_det = recip_valid && !second_q ? recip : inverse_det_q;
  assign inverse     = recip_valid && second_q ? recip : inverse_q;

  // --- the multipliers ---------------------------------------------------------------------------------------------
  logic [3:0]                  turn_q;        // cycles 3 to 6
  logic [MantissaW-1:0]        scaled_det_q;  // k / det
  logic [OpacityW-1:0]         t;             // the budget of the box
  logic signed [LeftW-1:0]     left;
  logic signed [RightW-1:0]    right;
  logic signed [ProductW-1:0]  product_q;
  logic [MantissaW-1:0]        turned;        // to be multiplied by k
  logic [2*MantissaW-1:0]      constant_q;

  always_comb begin
    left  = LeftW'($signed({1'b0, front_q.more_m}));
    right = RightW'($signed({1'b0, t}));
    (* parallel_case *) case (1'b1)
      turn_q[0]: left = LeftW'($signed({1'b0, less_m_q}));
      turn_q[2]: begin  // slope
        left  = LeftW'(front_q.b_m);
        right = RightW'($signed({1'b0, inverse}));
      end
      turn_q[3]: right = RightW'($signed({1'b0, scaled_det_q}));  // narrow
      default: ;
    endcase
  end
  assign turned = turn_q[1] ? inverse_det : inverse;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) turn_q <= '0;
    else if (step) for (int unsigned i = 0; i < 4; i += 1) turn_q[i] <= slots[4+:4] == 4'(8 + i);
  end
  always_ff @(posedge clk_i) if (step) begin
    less_m_q   <= less_m;
    product_q  <= ProductW'(left) * ProductW'(right);
    constant_q <= (2 * MantissaW)'(turned) * (2 * MantissaW)'(K);
  end

  // A product of two normalised mantissas: MantissaW leading bits, to nearest, and what its exponent gains.
  localparam int unsigned RoundedW = MantissaW + FloatEW;
  logic [2*RoundedW-1:0]     rounded;
  logic [MantissaW-1:0]      narrow_m, scaled_m;
  logic signed [FloatEW-1:0] narrow_gain, scaled_gain;
  for (genvar i = 0; i < 2; i += 1) begin : gen_round
    logic [2*MantissaW-1:0] whole;
    logic                   top;
    logic [MantissaW:0]     leading, nearest;
    assign whole   = i == 0 ? product_q[2*MantissaW-1:0] : constant_q;
    assign top     = whole[2*MantissaW-1];
    assign leading = top ? whole[2*MantissaW-1-:MantissaW+1] : whole[2*MantissaW-2-:MantissaW+1];
    assign nearest = {1'b0, leading[MantissaW:1]} + (MantissaW + 1)'(leading[0]);
    assign rounded[i*RoundedW+:RoundedW] = {
      nearest[MantissaW] ? nearest[MantissaW:1] : nearest[MantissaW-1:0],
      FloatEW'({1'b0, top}) + FloatEW'({1'b0, nearest[MantissaW]})
    };
  end
  assign {scaled_m, scaled_gain, narrow_m, narrow_gain} = rounded;

  // b / larger = product * 2^(b_e - larger_e + 1 - 2 MantissaW), to SlopeF fraction bits, at most 1.
  logic signed [SumW-1:0]     slope_shift_q;
  logic [ShiftW-1:0]          slope_by;
  logic signed [ProductW-1:0] half_slope, near_slope, one, minus_one;
  logic signed [SlopeW-1:0]   slope, slope_q;
  assign slope_by    = slope_shift_q[SumW-2:ShiftW] != '0 ? '1 : slope_shift_q[ShiftW-1:0] - ShiftW'(1);
  assign half_slope  = product_q >>> slope_by;
  assign near_slope  = (half_slope >>> 1) + $signed(ProductW'(half_slope[0]));
  assign one         = {{(ProductW - SlopeF - 1){1'b0}}, 1'b1, {SlopeF{1'b0}}};
  assign minus_one   = {{(ProductW - SlopeF){1'b1}}, {SlopeF{1'b0}}};
  always_comb begin
    slope = SlopeW'(near_slope);
    if (slope_shift_q <= 0) slope = product_q[ProductW-1] ? SlopeW'(minus_one) : product_q == '0 ? '0 : SlopeW'(one);
    else if (near_slope > one) slope = SlopeW'(one);
    else if (near_slope < minus_one) slope = SlopeW'(minus_one);
  end

  logic [MantissaW-1:0]      wide_m_q, narrow_m_q;
  logic signed [FloatEW-1:0] wide_e_q, narrow_e_q, scaled_det_e_q;
  always_ff @(posedge clk_i) if (step) begin
    slope_shift_q <= SumW'(front_q.more_e) - SumW'(front_q.b_e) + SumW'(2 * MantissaW - 1) - SumW'(SlopeF);
    if (cycle[5]) begin
      scaled_det_q   <= scaled_m;
      scaled_det_e_q <= scaled_gain - front_q.det_e - FloatEW'(2 * MantissaW);
    end
    if (cycle[6]) begin
      wide_m_q <= scaled_m;
      wide_e_q <= scaled_gain - front_q.more_e - FloatEW'(2 * MantissaW);
      slope_q  <= slope;
    end
    if (cycle[7]) begin
      narrow_m_q <= narrow_m;
      narrow_e_q <= narrow_gain + front_q.more_e + scaled_det_e_q + FloatEW'(MantissaW - 1);
    end
  end

  // --- the box of alpha >= 1/AlphaCut --------------------------------------------------------------------------------
  logic [ExtentW-1:0] extent_x, extent_y;
  pu_four_extent u_extent (
    .clk_i,
    .step_i(step),
    .phase_i(phase[1:0]),
    .opacity_i(in_q.opacity),
    .t_o(t),
    .load_i(cycle[5:4]),
    .load_set_i(ride_4_q.second),
    .product_i(product_q[MantissaW+OpacityW-1:0]),
    .less_e_i(front_q.less_e),
    .more_e_i(front_q.more_e),
    .give_i(cycle[13:12]),
    .give_set_i(ride_12_q.second),
    .swap_i(ride_12_q.swap),
    .extent_x_o(extent_x),
    .extent_y_o(extent_y)
  );

  // --- what is kept, what leaves -----------------------------------------------------------------------------------
  logic second_set_q;  // of roots
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) second_set_q <= 1'b0;
    else if (step && phase[3]) second_set_q <= !second_set_q;
  end

  assign conic_o = conic_q;
  always_ff @(posedge clk_i) begin
    if (take) in_q <= covariance_i;
    if (step) begin
      if (phase[3]) begin
        front_q.b_m    <= in_q.b_m;
        front_q.b_e    <= in_q.b_e;
        front_q.more_m <= more_m;
        front_q.more_e <= more_e;
        front_q.less_e <= less_e;
        front_q.det_e  <= in_q.det_e;
        ride_4_q.kind    <= in_q.kind;
        ride_4_q.swap    <= swap;
        ride_4_q.second  <= second_set_q;
        ride_4_q.mean_x  <= in_q.mean_x;
        ride_4_q.mean_y  <= in_q.mean_y;
        ride_4_q.opacity <= in_q.opacity;
      end
      if (cycle[7]) ride_8_q <= ride_4_q;
      if (cycle[8]) begin
        known_9_q.wide_m   <= wide_m_q;
        known_9_q.wide_e   <= wide_e_q;
        known_9_q.narrow_m <= narrow_m_q;
        known_9_q.narrow_e <= narrow_e_q;
        known_9_q.slope    <= slope_q;
      end
      if (cycle[11]) ride_12_q <= ride_8_q;
      if (cycle[12]) known_13_q <= known_9_q;
    end
    if (claim) begin
      conic_q      <= '0;
      conic_q.kind <= ride_12_q.kind;
      if (ride_12_q.kind == pipegs_pkg::KindData) begin
        conic_q.extent_x <= extent_x;
        conic_q.extent_y <= extent_y;
        conic_q.slope_m  <= known_13_q.slope;
        conic_q.narrow_m <= known_13_q.narrow_m;
        conic_q.narrow_e <= known_13_q.narrow_e;
        conic_q.wide_m   <= known_13_q.wide_m;
        conic_q.wide_e   <= known_13_q.wide_e;
        conic_q.mean_x   <= ride_12_q.mean_x;
        conic_q.mean_y   <= ride_12_q.mean_y;
        conic_q.swap     <= ride_12_q.swap;
        conic_q.opacity  <= ride_12_q.opacity;
      end
    end
  end

  wire unused_bits = &{1'b0, phase, slots, cycle, in_q};  // with Antialias sharp has served already

endmodule
