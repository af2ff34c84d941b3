// SPDX-License-Identifier: Apache-2.0
// pu_axes: the eigenvectors of a covariance as a slope, its larger eigenvalue, and how the slope stretches lengths.
//
// Paper   the oriented box of GSCore, from which the paper's baseline is reproduced (Sec. 5.2).
// Idea    d = A - C of the larger and the smaller variance, r = sqrt(d^2 + 4 b^2), g = d + r:
//           slope = 2 b / g,  stretch = r / g = (1 + slope^2) / 2,  shrink = g / 2 r,  long = (A + C + r) / 2
//         Two multipliers, as the next record may come at any time from cycle 8 on, one root, one reciprocal:
//           cycle     0      1      2    3     4    5  6     7       8        9    10  11  12     13       14
//           multiply                x x  y y         u/r
//           multiply                                                 g/r               slope  stretch
//           root                               in      out
//           recip                                                    g        sum          1/g    1/sum
//           here      align  lead              sum           r, g             shrink              slope    stretch
// Stream  covariance in, axes out, in order; an end beat passes with all other fields zero.
// Pace    One record in eight cycles, latency 16.
// Model   cpp_model/pu/box/pu_axes.hpp

module pu_axes (
  input  logic                     clk_i,
  input  logic                     rst_ni,

  input  logic                     covariance_valid_i,
  output logic                     covariance_ready_o,
  input  pipegs_pkg::covariance_t  covariance_i,

  output logic                     axes_valid_o,
  input  logic                     axes_ready_i,
  output pipegs_pkg::axes_t        axes_o,

  output logic                     busy_o
);

  localparam int unsigned MantissaW = pipegs_pkg::MantissaW;
  localparam int unsigned FloatEW   = pipegs_pkg::FloatEW;
  localparam int unsigned SlopeW    = pipegs_pkg::SlopeW;
  localparam int unsigned AxisMW    = pipegs_pkg::AxisMW;
  localparam int unsigned AxisEW    = pipegs_pkg::AxisEW;
  localparam int unsigned ShareW    = pipegs_pkg::ShareW;
  localparam int unsigned ShareF    = ShareW - 1;
  localparam int unsigned TiltW     = pipegs_pkg::TiltW;
  localparam int unsigned TiltF     = TiltW - 2;
  localparam int unsigned GuardW    = 8;                        // bits below the last place of the larger variance
  localparam int unsigned LeadW     = 20;                       // leading bits that are squared
  localparam int unsigned RoundW    = 18;                       // no more bits than this: a round covariance
  localparam int unsigned SizeW     = SlopeW - 1;               // bits of |b|, but for -2^SizeW
  localparam int unsigned VarianceW = MantissaW + GuardW;
  localparam int unsigned DoubleW   = VarianceW + 2;            // 2|b|, at most 2^(VarianceW + 1)
  localparam int unsigned LengthW   = $clog2(DoubleW + 1);
  localparam int unsigned SumW      = 26;                       // A + C + r
  localparam int unsigned SumCut    = MantissaW - 15;
  localparam int unsigned RootW     = 23;                       // r, two fraction bits
  localparam int unsigned ByW       = 6;                        // of shifts
  localparam int unsigned ApartW    = FloatEW + 2;
  localparam int unsigned ProductW  = 2 * AxisMW;
  localparam int unsigned RsqrtInW  = 20;
  localparam int unsigned RsqrtOutW = 18;
  localparam int unsigned Depth     = pipegs_pkg::AxesDepth;

  typedef struct packed {logic [Depth-1:0][3:0] of;} slots_t;
  logic               take, claim, step, data;
  logic [7:0]         phase;
  slots_t             slots;
  logic [Depth:1]     late;  // cycle 7 + i: what was issued i cycles ago is the last phase of a record
  for (genvar i = 1; i <= Depth; i += 1) begin : gen_late
    assign late[i] = slots.of[i-1] == 4'hf;
  end

  pu_phases #(.Depth(Depth), .Claim(pipegs_pkg::AxesClaim)) u_phases (
    .clk_i,
    .rst_ni,
    .in_valid_i(covariance_valid_i),
    .in_ready_o(covariance_ready_o),
    .out_valid_o(axes_valid_o),
    .out_ready_i(axes_ready_i),
    .take_o(take),
    .claim_o(claim),
    .step_o(step),
    .held_o(),
    .phase_o(phase),
    .slots_o(slots),
    .busy_o
  );

  pipegs_pkg::covariance_t in_q;
  pipegs_pkg::axes_t       out_q;
  assign data   = in_q.kind == pipegs_pkg::KindData;

  // --- 0: all in the unit of the larger variance ---------------------------------------------------------------------
  logic                      swap;
  logic [MantissaW-1:0]      larger_m, smaller_m;
  logic signed [FloatEW-1:0] larger_e, smaller_e;
  logic signed [ApartW-1:0]  apart, b_apart;
  logic [ByW-1:0]            by, b_by;
  logic [SizeW:0]            b_size;
  logic [VarianceW-1:0]      larger, smaller, d_q;
  logic [VarianceW:0]        whole;
  logic [DoubleW-1:0]        double_b_q;
  logic [AxisMW-1:0]         whole_q;  // A + C, in the unit of the sum
  assign swap      = in_q.a_e > in_q.c_e || (in_q.a_e == in_q.c_e && in_q.a_m > in_q.c_m);
  assign larger_m  = swap ? in_q.a_m : in_q.c_m;
  assign smaller_m = swap ? in_q.c_m : in_q.a_m;
  assign larger_e  = swap ? in_q.a_e : in_q.c_e;
  assign smaller_e = swap ? in_q.c_e : in_q.a_e;
  assign apart     = ApartW'(larger_e) - ApartW'(smaller_e);
  assign b_apart   = ApartW'(larger_e) - ApartW'(in_q.b_e) + $signed(ApartW'(MantissaW) - ApartW'(SizeW));
  assign by        = apart >= ApartW'(2 ** ByW) ? '1 : apart[ByW-1:0];
  assign b_by      = b_apart < 0 ? '0 : b_apart >= ApartW'(2 ** ByW) ? '1 : b_apart[ByW-1:0];
  assign b_size    = in_q.b_m[SlopeW-1] ? (SizeW + 1)'(-in_q.b_m) : (SizeW + 1)'(in_q.b_m);
  assign larger    = {larger_m, {GuardW{1'b0}}};
  assign smaller   = {smaller_m, {GuardW{1'b0}}} >> by;
  assign whole     = {1'b0, larger} + {1'b0, smaller};

  // --- 1: the leading bits of d and 2|b| -----------------------------------------------------------------------------
  logic [LengthW-1:0] length, length_by;
  logic [DoubleW:0]   x_cut, y_cut;
  logic [LeadW-1:0]   x_q, y_q, y_late_q;
  logic [ByW-1:0]     cut_q;
  logic               round, round_q;
  pipegs_bit_length #(.DataW(DoubleW)) u_length (
    .in_i(DoubleW'(d_q) | double_b_q),
    .length_o(length)
  );
  assign round     = length <= LengthW'(RoundW);
  assign length_by = round ? '0 : length - LengthW'(LeadW - 1);
  assign x_cut     = {DoubleW'(d_q), 1'b0} >> length_by;
  assign y_cut     = {double_b_q, 1'b0} >> length_by;

  // --- 2 to 4: the sum of the squares, and its root ------------------------------------------------------------------
  logic [LeadW-1:0]     lead_left, lead_right;
  logic [2*LeadW-1:0]   lead_q, square_q;  // the first multiplier's product
  logic [2*LeadW:0]     squares;
  logic                 high, high_q;
  logic [RsqrtInW-1:0]  u, u_q;
  logic [RsqrtOutW-1:0] inverse_r, inverse_r_q;
  assign squares = {1'b0, square_q} + {1'b0, lead_q};
  assign high    = squares[2*LeadW];
  assign u       = round_q ? RsqrtInW'(1 << 18) :
                   RsqrtInW'(high ? squares >> (2 * LeadW + 2 - RsqrtInW) : squares >> (2 * LeadW - RsqrtInW));
  always_comb begin
    lead_left  = u_q;
    lead_right = LeadW'(inverse_r);
    (* parallel_case *) case (1'b1)
      phase[2]: begin lead_left = x_q; lead_right = x_q; end
      phase[3]: begin lead_left = y_q; lead_right = y_q; end
      default: ;
    endcase
  end
  pipegs_rsqrt u_rsqrt (
    .clk_i,
    .u_i(u),
    .r_o(inverse_r)
  );

  // --- 7: r and g = d + r, with two fraction bits; 8: the reciprocals ------------------------------------------------
  logic [RootW-1:0]   root, root_q;
  logic [AxisMW-1:0]  g_q, g_normal, sum_m, sum_m_q, recip_in, inverse, inverse_g_q;
  logic [1:0]         g_up, g_up_q, sum_up, sum_up_q;
  logic [SumW-1:0]    sum, sum_q, sum_normal;
  logic               round_late_q, high_late_q;
  assign root     = high_q ? RootW'(lead_q >> 14) : RootW'(lead_q >> 15);
  assign sum      = SumW'(whole_q) + (round_q ? '0 : (SumW'(root_q) << 3) >> (ByW'(MantissaW - 9) - cut_q));
  assign g_up     = g_q[AxisMW-1] ? 2'd0 : g_q[AxisMW-2] ? 2'd1 : g_q[AxisMW-3] ? 2'd2 : 2'd3;
  assign g_normal = g_q << g_up;
  always_comb begin
    sum_up = 2'd3;
    if (sum_q[SumW-1]) sum_up = 2'd0;
    else if (sum_q[SumW-2]) sum_up = 2'd1;
    else if (sum_q[SumW-3]) sum_up = 2'd2;
  end
  assign sum_normal = sum_q << sum_up;
  assign sum_m      = sum_normal[SumW-1:SumW-AxisMW];
  assign recip_in   = late[1] ? g_normal : sum_m;
  pipegs_recip #(.DataW(AxisMW)) u_recip (
    .clk_i,
    .rst_ni,
    .in_valid_i(late[1] || late[2]),
    .in_i(recip_in),
    .out_valid_o(),
    .out_o(inverse)
  );

  // --- the second multiplier: cycles 8, 12 and 13 --------------------------------------------------------------------
  logic [AxisMW-1:0]   left, right;
  logic [ProductW-1:0] product_q;
  always_comb begin
    left  = AxisMW'(root_q);
    right = inverse_g_q;
    if (late[1]) begin left = g_q;               right = AxisMW'(inverse_r_q); end
    if (late[5]) begin left = AxisMW'(y_late_q); right = inverse;              end
  end

  // 13 and 14: to nearest, at most 1; 9: the floor.
  localparam int unsigned NearW = ProductW - 25;
  logic [4:0]       near_by;
  logic [NearW-1:0] halves, near, most, nearest;
  logic [ProductW-1:0] shrink;
  assign near_by = 5'd28 - {3'b0, g_up_q};
  assign halves  = NearW'(product_q >> near_by);
  assign near    = (halves >> 1) + NearW'(halves[0]);
  assign most    = NearW'(1) << (late[6] ? TiltF : ShareF);
  assign nearest = near > most ? most : near;
  assign shrink  = product_q >> (high_late_q ? 5'd23 : 5'd22);

  always_ff @(posedge clk_i) begin
    if (take) in_q <= covariance_i;
    if (step) begin
      lead_q    <= (2 * LeadW)'(lead_left) * (2 * LeadW)'(lead_right);
      product_q <= ProductW'(left) * ProductW'(right);
      if (phase[0]) begin
        d_q        <= larger - smaller;
        double_b_q <= {b_size, {(DoubleW - SizeW - 1){1'b0}}} >> b_by;
      end
      if (phase[1]) begin
        x_q     <= round ? '0 : x_cut[LeadW-1:0];
        y_q     <= round ? '0 : y_cut[LeadW-1:0];
        cut_q   <= ByW'(length_by);
        round_q <= round;
        whole_q <= AxisMW'(whole >> SumCut);
      end
      if (phase[3]) square_q <= lead_q;
      if (phase[4]) begin
        u_q    <= u;
        high_q <= high;
      end
      if (phase[6]) inverse_r_q <= inverse_r;
      if (phase[7]) begin
        root_q       <= round_q ? '0 : root;
        g_q          <= round_q ? {1'b1, {(AxisMW - 1){1'b0}}} : (AxisMW'(x_q) << 2) + AxisMW'(root);
        y_late_q     <= y_q;
        round_late_q <= round_q;
        high_late_q  <= high_q;
      end
      if (late[1]) begin
        g_up_q <= g_up;
        sum_q  <= sum;
      end
      if (late[2]) begin
        sum_m_q  <= sum_m;
        sum_up_q <= sum_up;
      end
      if (late[5]) inverse_g_q <= inverse;
    end
    if (claim) begin
      out_q      <= '0;
      out_q.kind <= in_q.kind;
      if (data) begin
        out_q.mean_x  <= in_q.mean_x;
        out_q.mean_y  <= in_q.mean_y;
        out_q.a_m     <= in_q.a_m;
        out_q.a_e     <= in_q.a_e;
        out_q.b_m     <= in_q.b_m;
        out_q.b_e     <= in_q.b_e;
        out_q.c_m     <= in_q.c_m;
        out_q.c_e     <= in_q.c_e;
        out_q.det_m   <= in_q.det_m;
        out_q.det_e   <= in_q.det_e;
        out_q.opacity <= in_q.opacity;
        out_q.swap    <= swap;
        out_q.long_e  <= AxisEW'(larger_e) + $signed(AxisEW'(MantissaW) - AxisEW'(22));  // the shift goes away below
      end
    end
    if (step && out_q.kind == pipegs_pkg::KindData) begin
      if (late[2]) out_q.shrink <= round_late_q ? ShareW'(1 << ShareF) :
                                   shrink > ProductW'(1 << ShareF) ? ShareW'(1 << ShareF) : ShareW'(shrink);
      if (late[3]) begin
        out_q.long_m <= sum_m_q;
        out_q.long_e <= out_q.long_e - $signed({{(AxisEW - 2){1'b0}}, sum_up_q});
      end
      if (late[6]) begin
        out_q.tilt      <= round_late_q ? '0 : out_q.b_m[SlopeW-1] == out_q.swap ? -$signed(TiltW'(nearest)) :
                           $signed(TiltW'(nearest));
        out_q.inverse_m <= inverse;
      end
      if (late[7]) out_q.stretch <= round_late_q ? ShareW'(1 << (ShareF - 1)) : ShareW'(nearest);
    end
  end

  // --- the determinant before dilation, for pu_compensate ------------------------------------------------------------
  if (pipegs_pkg::Antialias == 1) begin : gen_sharp
    logic        [pipegs_pkg::SharpW-1:0]  sharp_m_q;
    logic signed [pipegs_pkg::SharpEW-1:0] sharp_e_q;
    always_ff @(posedge clk_i) if (claim) begin
      sharp_m_q <= data ? in_q.sharp_m : '0;
      sharp_e_q <= data ? in_q.sharp_e : '0;
    end
    always_comb begin
      axes_o         = out_q;
      axes_o.sharp_m = sharp_m_q;
      axes_o.sharp_e = sharp_e_q;
    end
  end else begin : gen_no_sharp
    assign axes_o = out_q;
  end

  // Bits below what is kept; what pu_box makes.
  wire unused_bits = &{1'b0, phase, late, in_q, x_cut, y_cut, sum_normal, halves, near, nearest, covariance_i};

endmodule
