// SPDX-License-Identifier: Apache-2.0
// pu_conic: the inverse of the covariance, as what the coefficients need: two curvatures, a slope, and a box.
//
// Paper   Eq. 1 (the exponent), k = log2(e)/2 folded in: alpha = 2^power.
// Idea    Eliminate the narrower axis (x if c >= a, else exchange x and y); larger = max(a, c):
//           wide = k / larger,  narrow = k larger / det,  slope = b / larger,  extent = sqrt(variance * budget)
// Stream  covariance in, conic out, in order; an end beat passes through.
// Pace    One record in eight cycles, latency 14 (an end beat 6). One multiplier, one reciprocal, two roots.
//           turn  0     1    2     3     4     5     6     7   | 0      1      2  3      4      5  next turn
//           recip larger det             ->    ->              |
//           mult             a t   c t         wide  k/det slope narrow
//           root                         a: 4 .. 7             | .. 2          scale
//                                              c: 5 .. 7       | .. 3                  scale   out
//         A record stays in covariance_i up to cycle 5, then in front_q up to cycle 5 of the next turn.
// Model   cpp_model/pu/conic/pu_conic.hpp

module pu_conic (
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

  // What a record keeps while it is calculated.
  typedef struct packed {
    logic signed [SlopeW-1:0]              b_m;
    logic signed [FloatEW-1:0]             b_e;
    logic [MantissaW-1:0]                  larger_m;
    logic signed [FloatEW-1:0]             larger_e;
    logic signed [FloatEW-1:0]             det_e;
    logic                                  swap;
    logic [pipegs_pkg::KindW-1:0]          kind;
    logic signed [pipegs_pkg::MeanW-1:0]   mean_x;
    logic signed [pipegs_pkg::MeanW-1:0]   mean_y;
    logic [OpacityW-1:0]                   opacity;
  } front_t;

  logic [7:0]          phase;
  logic                fresh, advance, move, leave, data;
  front_t              front, front_q;
  pipegs_pkg::conic_t  conic, conic_q;

  assign data = covariance_i.kind == pipegs_pkg::KindData;

  pu_turns #(.Out(5)) u_turns (
    .clk_i,
    .rst_ni,
    .in_valid_i(covariance_valid_i),
    .in_ready_o(covariance_ready_o),
    .in_data_i(data),
    .out_valid_o(conic_valid_o),
    .out_ready_i(conic_ready_i),
    .phase_o(phase),
    .fresh_o(fresh),
    .advance_o(advance),
    .move_o(move),
    .leave_o(leave),
    .busy_o
  );

  // --- which axis is the wider one ---------------------------------------------------------------------------------
  logic                      swap;
  logic [MantissaW-1:0]      larger_m;
  logic signed [FloatEW-1:0] larger_e;
  assign swap     = covariance_i.a_e > covariance_i.c_e ||
                    (covariance_i.a_e == covariance_i.c_e && covariance_i.a_m > covariance_i.c_m);
  assign larger_m = swap ? covariance_i.a_m : covariance_i.c_m;
  assign larger_e = swap ? covariance_i.a_e : covariance_i.c_e;

  // --- reciprocals: they come four cycles later, whether the turn waits or not -------------------------------------
  logic                 recip_in_valid, recip_valid, second_q;
  logic [MantissaW-1:0] recip_in, recip, inverse_q, inverse_det_q;
  assign recip_in_valid = fresh && data && (phase[0] || phase[1]);
  assign recip_in       = phase[0] ? larger_m : covariance_i.det_m;

  pipegs_recip #(.DataW(MantissaW)) u_recip (
    .clk_i,
    .rst_ni,
    .in_valid_i(recip_in_valid),
    .in_i(recip_in),
    .out_valid_o(recip_valid),
    .out_o(recip)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) second_q <= 1'b0;
    else if (recip_valid) second_q <= !second_q;
  end
  always_ff @(posedge clk_i) begin
    if (recip_valid && !second_q) inverse_q <= recip;
    if (recip_valid && second_q) inverse_det_q <= recip;
  end

  // --- the multiplier ----------------------------------------------------------------------------------------------
  logic [MantissaW-1:0]        scaled_det_q;  // k / det
  logic [OpacityW-1:0]         t;             // the budget of the box
  logic signed [LeftW-1:0]     left;
  logic signed [RightW-1:0]    right;
  logic signed [ProductW-1:0]  product_q;

  always_comb begin
    left  = LeftW'($signed({1'b0, covariance_i.a_m}));
    right = RightW'($signed({1'b0, t}));
    (* parallel_case *) case (1'b1)
      phase[0]: begin  // narrow
        left  = LeftW'($signed({1'b0, front_q.larger_m}));
        right = RightW'($signed({1'b0, scaled_det_q}));
      end
      phase[3]: left = LeftW'($signed({1'b0, covariance_i.c_m}));
      phase[5]: begin  // wide
        left  = LeftW'($signed({1'b0, K}));
        right = RightW'($signed({1'b0, inverse_q}));
      end
      phase[6]: begin
        left  = LeftW'($signed({1'b0, K}));
        right = RightW'($signed({1'b0, inverse_det_q}));
      end
      phase[7]: begin  // slope
        left  = LeftW'(front_q.b_m);
        right = RightW'($signed({1'b0, inverse_q}));
      end
      default: ;
    endcase
  end
  always_ff @(posedge clk_i) product_q <= ProductW'(left) * ProductW'(right);

  // A product of two normalised mantissas: MantissaW leading bits, to nearest, and what its exponent gains.
  logic                      top;
  logic [MantissaW:0]        leading, rounded;
  logic [MantissaW-1:0]      mantissa;
  logic signed [FloatEW-1:0] gain;
  assign top      = product_q[2*MantissaW-1];
  assign leading  = top ? product_q[2*MantissaW-1-:MantissaW+1] : product_q[2*MantissaW-2-:MantissaW+1];
  assign rounded  = {1'b0, leading[MantissaW:1]} + (MantissaW + 1)'(leading[0]);
  assign mantissa = rounded[MantissaW] ? rounded[MantissaW:1] : rounded[MantissaW-1:0];
  assign gain     = FloatEW'({1'b0, top}) + FloatEW'({1'b0, rounded[MantissaW]});

  // b / larger = product * 2^(b_e - larger_e + 1 - 2 MantissaW), to SlopeF fraction bits, at most 1.
  logic signed [SumW-1:0]     slope_shift, slope_shift_q;
  logic [ShiftW-1:0]          slope_by;
  logic signed [ProductW-1:0] half_slope, near_slope, one, minus_one;
  logic signed [SlopeW-1:0]   slope;
  assign slope_shift = SumW'(front_q.larger_e) - SumW'(front_q.b_e) + SumW'(2 * MantissaW - 1) - SumW'(SlopeF);
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
  logic signed [SlopeW-1:0]  slope_q;
  always_ff @(posedge clk_i) begin
    if (phase[6]) begin
      wide_m_q <= mantissa;
      wide_e_q <= gain - front_q.larger_e - FloatEW'(2 * MantissaW);
    end
    if (phase[7]) begin
      scaled_det_q   <= mantissa;
      scaled_det_e_q <= gain - front_q.det_e - FloatEW'(2 * MantissaW);
      slope_shift_q  <= slope_shift;
    end
    if (phase[0]) slope_q <= slope;
    if (phase[1]) begin
      narrow_m_q <= mantissa;
      narrow_e_q <= gain + front_q.larger_e + scaled_det_e_q + FloatEW'(MantissaW - 1);
    end
  end

  // --- the box: that of alpha >= 1/AlphaCut, or around the oriented one, which came with the covariance -----------
  logic [ExtentW-1:0] extent_x, extent_y;
  if (pipegs_pkg::Oriented) begin : gen_oriented
    localparam int unsigned BoxBits = pipegs_pkg::TiltW + 2 * pipegs_pkg::SideW;
    logic [BoxBits-1:0]           front_box_q, box_q;
    logic [pipegs_pkg::TiltW-1:0] tilt;
    logic [pipegs_pkg::SideW-1:0] side_u, side_v;
    assign t = '0;
    assign {tilt, side_u, side_v} = box_q;
    always_ff @(posedge clk_i) begin
      if (move) begin
        {extent_x, extent_y} <= {covariance_i.box_x, covariance_i.box_y};
        front_box_q <= {covariance_i.tilt, covariance_i.side_u, covariance_i.side_v};
      end
      if (leave) box_q <= front_q.kind == pipegs_pkg::KindData ? front_box_q : '0;
    end
    always_comb begin
      conic_o        = conic_q;
      conic_o.tilt   = tilt;
      conic_o.side_u = side_u;
      conic_o.side_v = side_v;
    end
  end else begin : gen_reached
    assign conic_o = conic_q;
    pu_extent u_extent (
      .clk_i,
      .phase_i(phase),
      .advance_i(advance),
      .opacity_i(covariance_i.opacity),
      .a_e_i(covariance_i.a_e),
      .c_e_i(covariance_i.c_e),
      .t_o(t),
      .product_i(product_q[MantissaW+OpacityW-1:0]),
      .extent_x_o(extent_x),
      .extent_y_o(extent_y)
    );
  end

  // --- what is kept, what leaves -----------------------------------------------------------------------------------
  always_comb begin
    front          = '0;
    front.kind     = covariance_i.kind;
    if (data) begin
      front.b_m      = covariance_i.b_m;
      front.b_e      = covariance_i.b_e;
      front.larger_m = larger_m;
      front.larger_e = larger_e;
      front.det_e    = covariance_i.det_e;
      front.swap     = swap;
      front.mean_x   = covariance_i.mean_x;
      front.mean_y   = covariance_i.mean_y;
      front.opacity  = covariance_i.opacity;
    end

    conic      = '0;
    conic.kind = front_q.kind;
    if (front_q.kind == pipegs_pkg::KindData) begin
      conic.extent_x = extent_x;
      conic.extent_y = extent_y;
      conic.slope_m  = slope_q;
      conic.narrow_m = narrow_m_q;
      conic.narrow_e = narrow_e_q;
      conic.wide_m   = wide_m_q;
      conic.wide_e   = wide_e_q;
      conic.mean_x   = front_q.mean_x;
      conic.mean_y   = front_q.mean_y;
      conic.swap     = front_q.swap;
      conic.opacity  = front_q.opacity;
    end
  end

  always_ff @(posedge clk_i) begin
    if (leave) conic_q <= conic;
    if (move) front_q <= front;
  end

  wire unused_sharp = &{1'b0, advance, phase, covariance_i};  // with Antialias it has served already

endmodule
