// SPDX-License-Identifier: Apache-2.0
// pu_coeff: the six coefficients of Eq. 3 for one Gaussian and one window.
//
// Paper   Eq. 3, step 1 of Fig. 5a, once per Gaussian and window; the anchor is the window's first pixel.
// Idea    (p, q) = (x, y), exchanged if swap; u = narrow m, w = mean_p - m mean_q, both as mantissa and exponent:
//           A = -(narrow w^2 + wide mean_q^2) - opacity      D = -narrow      E = -(u m + wide)
//           B = 2 narrow w      C = 2 (wide mean_q - u w)                    F = 2 u
//         Out of range: dead; no pixel of the window can count (the proof is in the model's head).
// Stream  conic in, coeff out, in order; an end beat passes through.
// Pace    One record in eight cycles, latency 13 (an end beat 4 and 6). One multiplier behind registers of its
//         operands, one normaliser, one aligner. A product is there two phases after its operands were chosen:
//           turn   0        1       2     3         4         5      6           7    | 0     1     2     3 of the next
//           chosen m q      wide q  u     wide q q  narrow w  u w    narrow w w  u m  |
//           norm   mean_q                 w                                           |
//           align                         wide q    u         w q q  narrow w    u w  | n w w u m
//           sums                                    C D       E F    A           B    | C     A     E     out
// Model   cpp_model/pu/conic/pu_coeff.hpp

module pu_coeff (
  input  logic                clk_i,
  input  logic                rst_ni,

  input  logic                conic_valid_i,
  output logic                conic_ready_o,
  input  pipegs_pkg::conic_t  conic_i,

  output logic                coeff_valid_o,
  input  logic                coeff_ready_i,
  output pipegs_pkg::coeff_t  coeff_o,

  output logic                busy_o  // a record is inside
);

  localparam int unsigned MantissaW = pipegs_pkg::MantissaW;
  localparam int unsigned FloatEW   = pipegs_pkg::FloatEW;
  localparam int unsigned SlopeW    = pipegs_pkg::SlopeW;
  localparam int unsigned SlopeF    = SlopeW - 2;
  localparam int unsigned MeanW     = pipegs_pkg::MeanW;
  localparam int unsigned MeanF     = pipegs_pkg::MeanF;
  localparam int unsigned OpacityF  = pipegs_pkg::OpacityF;
  localparam int unsigned OpacityW  = pipegs_pkg::OpacityW;
  localparam int unsigned CoeffF    = pipegs_pkg::CoeffF;
  localparam int unsigned AW        = pipegs_pkg::AW;
  localparam int unsigned BcW       = pipegs_pkg::BcW;
  localparam int unsigned DefW      = pipegs_pkg::DefW;
  localparam int unsigned SumAW     = AW + 2;
  localparam int unsigned SumBcW    = BcW + 1;
  localparam int unsigned SumDefW   = DefW + 1;
  localparam int unsigned OutPhase  = 3;  // the record before leaves, this one moves to front_q
  localparam int unsigned FactorF   = 34;                // magnitude bits of a product that is a factor again
  localparam int unsigned NormalF   = MantissaW + 2;     // magnitude bits of mean_q and w as factors
  localparam int unsigned NormalW   = NormalF + 1;
  localparam int unsigned WideW     = SlopeF + MeanW + 1;  // w, exact
  localparam int unsigned LeftW     = FactorF + 1 > MeanW ? FactorF + 1 : MeanW;
  localparam int unsigned RightW    = NormalW > SlopeW ? NormalW : SlopeW;
  localparam int unsigned ProductW  = LeftW + RightW;
  localparam int unsigned Drop      = MantissaW + NormalF - FactorF;
  localparam int unsigned SlopeDrop = MantissaW + SlopeF - FactorF;
  localparam int unsigned Guard     = MantissaW < 22 ? 2 * (22 - MantissaW) : 0;
  localparam int unsigned FlatGuard = CoeffF + 4 > MantissaW ? CoeffF + 4 - MantissaW : 0;
  localparam int unsigned SumW      = FloatEW + 4;  // sums of exponents
  localparam int unsigned FlatByW   = 7;
  localparam int unsigned LengthW   = $clog2(WideW);

  logic [7:0]          phase;
  logic                advance, move, leave;
  pipegs_pkg::conic_t  front_q;
  pipegs_pkg::coeff_t  coeff, coeff_q;

  pu_turns #(.Out(OutPhase)) u_turns (
    .clk_i,
    .rst_ni,
    .in_valid_i(conic_valid_i),
    .in_ready_o(conic_ready_o),
    .in_data_i(conic_i.kind == pipegs_pkg::KindData),
    .out_valid_o(coeff_valid_o),
    .out_ready_i(coeff_ready_i),
    .phase_o(phase),
    .fresh_o(),
    .advance_o(advance),
    .move_o(move),
    .leave_o(leave),
    .busy_o
  );

  // --- the two numbers that need their leading bits: mean_q and w --------------------------------------------------
  logic signed [MeanW-1:0]    mean_q, mean_p;
  logic signed [WideW-1:0]    w_q, wide;
  logic signed [NormalW-1:0]  raised;
  logic [LengthW-1:0]         length, spare;  // bits from the leading one on; between the sign and that
  logic signed [NormalW-1:0]  normal_q;
  logic signed [SumW-1:0]     normal_e_q;
  logic signed [ProductW-1:0] product;
  assign mean_q = conic_i.swap ? conic_i.mean_x : conic_i.mean_y;
  assign mean_p = conic_i.swap ? conic_i.mean_y : conic_i.mean_x;
  assign wide   = phase[0] ? WideW'(mean_q) : w_q;

  pipegs_bit_length #(.DataW(WideW - 1)) u_length (
    .in_i(wide[WideW-2:0] ^ {(WideW - 1){wide[WideW-1]}}),
    .length_o(length)
  );
  assign spare  = LengthW'(WideW - 1) - length;
  assign raised = NormalW'($signed(wide <<< spare) >>> (WideW - NormalW));

  always_ff @(posedge clk_i) begin
    if (phase[2]) w_q <= (WideW'(mean_p) <<< SlopeF) - WideW'(product);
    if (phase[0] || (phase[3] && advance)) begin
      normal_q   <= raised;
      normal_e_q <= $signed(SumW'(WideW - 1 - NormalF) - SumW'(spare) -
                            (phase[0] ? SumW'(MeanF) : SumW'(MeanF + SlopeF)));
    end
  end

  // --- the multiplier, and beside it the shift that aligns its product ---------------------------------------------
  // A product m * 2^e is shifted right by Guard - CoeffF - e (shift_q is one less); e is a constant plus an exponent
  // plus 0, 1 or 2 times normal_e.
  logic signed [LeftW-1:0]   left, left_q, u_q;
  logic signed [RightW-1:0]  right, right_q;
  logic signed [SumW-1:0]    shift, shift_next_q, shift_q, curve_e, normal_e;
  localparam logic signed [SumW-1:0] Base = $signed(SumW'(Guard) - SumW'(CoeffF + 1));

  always_comb begin
    left     = LeftW'($signed({1'b0, front_q.narrow_m}));
    right    = RightW'(normal_q);
    curve_e  = SumW'(front_q.narrow_e);
    normal_e = '0;
    shift    = Base;
    (* parallel_case *) case (1'b1)
      phase[0]: begin  // m mean_q
        left  = LeftW'(mean_q);
        right = RightW'(conic_i.slope_m);
      end
      phase[1]: begin  // wide mean_q
        left     = LeftW'($signed({1'b0, conic_i.wide_m}));
        curve_e  = SumW'(conic_i.wide_e);
        normal_e = normal_e_q;
        shift    = Base - $signed(SumW'(1));
      end
      phase[2]: begin  // u
        left    = LeftW'($signed({1'b0, conic_i.narrow_m}));
        right   = RightW'(conic_i.slope_m);
        curve_e = SumW'(conic_i.narrow_e);
        shift   = Base + $signed(SumW'(SlopeF - 1));
      end
      phase[3]: begin  // wide mean_q^2
        left     = LeftW'(product >>> Drop);
        curve_e  = SumW'(conic_i.wide_e);
        normal_e = normal_e_q <<< 1;
        shift    = Base - $signed(SumW'(Drop));
      end
      phase[4]: begin  // narrow w
        normal_e = normal_e_q;
        shift    = Base - $signed(SumW'(1));
      end
      phase[5]: begin  // u w
        left     = u_q;
        normal_e = normal_e_q;
        shift    = Base + $signed(SumW'(SlopeF) - SumW'(SlopeDrop + 1));
      end
      phase[6]: begin  // narrow w^2
        left     = LeftW'(product >>> Drop);
        normal_e = normal_e_q <<< 1;
        shift    = Base - $signed(SumW'(Drop));
      end
      default: begin  // u m
        left  = u_q;
        right = RightW'(front_q.slope_m);
        shift = Base + $signed(SumW'(2 * SlopeF) - SumW'(SlopeDrop));
      end
    endcase
  end

  // Two products, of the right operand's low and high bits, are added behind their registers.
  localparam int unsigned LowW  = RightW / 2;
  localparam int unsigned HighW = RightW - LowW;
  logic signed [LeftW+LowW:0]    low_q;
  logic signed [LeftW+HighW-1:0] high_q;
  logic signed [RightW-1:0]      right_high;
  logic signed [LowW:0]          right_low;
  assign right_low  = {1'b0, right_q[LowW-1:0]};
  assign right_high = right_q >>> LowW;
  assign product    = ProductW'(low_q) + (ProductW'(high_q) <<< LowW);

  always_ff @(posedge clk_i) begin
    if (advance) begin
      left_q       <= left;
      right_q      <= right;
      low_q        <= (LeftW + LowW + 1)'(left_q) * (LeftW + LowW + 1)'(right_low);
      high_q       <= (LeftW + HighW)'(left_q) * (LeftW + HighW)'(right_high);
      shift_next_q <= shift - curve_e - normal_e;
      shift_q      <= shift_next_q;
    end
    if (phase[4]) u_q <= LeftW'(product >>> SlopeDrop);
  end

  // --- products to CoeffF fraction bits, to nearest ----------------------------------------------------------------
  logic signed [AW-1:0] aligned;
  logic                 up, fits_a, fits_bc, fits_def;
  pu_align #(.DataW(ProductW), .Guard(Guard), .ShiftW(SumW)) u_align (
    .clk_i,
    .enable_i(advance),
    .product_i(product),
    .shift_i(shift_q),
    .floor_o(aligned),
    .up_o(up),
    .fits_a_o(fits_a),
    .fits_bc_o(fits_bc),
    .fits_def_o(fits_def)
  );

  // narrow and wide themselves: cycles 2 and 3 the shift, 3 and 4 the number, 4 and 5 its use.
  localparam int unsigned FlatW = MantissaW + FlatGuard;
  logic [MantissaW-1:0]      flat_m;
  logic signed [FloatEW-1:0] flat_e;
  logic signed [SumW-1:0]    flat_shift_q;
  logic [FlatByW-1:0]        flat_by;
  logic [FlatW-1:0]          flat_halves, flat_q;
  logic                      flat_right_q, fits_flat;
  assign flat_m      = phase[OutPhase] ? conic_i.narrow_m : front_q.wide_m;
  assign flat_e      = phase[2] ? conic_i.narrow_e : conic_i.wide_e;
  assign flat_by     = flat_shift_q[SumW-2:FlatByW] != '0 ? '1 : flat_shift_q[FlatByW-1:0];
  assign flat_halves = (FlatW'(flat_m) << FlatGuard) >> flat_by;
  assign fits_flat   = flat_right_q && flat_q[FlatW-1:DefW-1] == '0;
  always_ff @(posedge clk_i) if (advance) begin
    flat_shift_q <= $signed(SumW'(FlatGuard) - SumW'(CoeffF + 1)) - SumW'(flat_e);
    flat_right_q <= !flat_shift_q[SumW-1];
    flat_q       <= (flat_halves >> 1) + FlatW'(flat_halves[0]);
  end

  // --- sums --------------------------------------------------------------------------------------------------------
  logic signed [SumAW-1:0]   a_q;
  logic signed [BcW-1:0]     b_q;  // with respect to p
  logic signed [SumBcW-1:0]  c_q;  // with respect to q
  logic signed [DefW-1:0]    d_q, f_q;
  logic signed [SumDefW-1:0] e_q;
  logic                      dead_q;

  always_ff @(posedge clk_i) begin
    (* parallel_case *) case (1'b1)
      phase[4]: begin
        d_q <= $signed(DefW'(0) - DefW'(flat_q));
        c_q <= SumBcW'(aligned) + $signed(SumBcW'(up));
      end
      phase[5]: begin
        e_q <= $signed(SumDefW'(0) - SumDefW'(flat_q));
        f_q <= DefW'(aligned) + $signed(DefW'(up));
      end
      phase[6]: a_q <= $signed(SumAW'(0) - (SumAW'(front_q.opacity) << (CoeffF - OpacityF))) - SumAW'(aligned) -
                         $signed(SumAW'(up));
      phase[7]: b_q <= BcW'(aligned) + $signed(BcW'(up));
      phase[0]: c_q <= c_q - SumBcW'(aligned) - $signed(SumBcW'(up));
      phase[1]: a_q <= a_q - SumAW'(aligned) - $signed(SumAW'(up));
      phase[2]: e_q <= e_q - SumDefW'(aligned) - $signed(SumDefW'(up));
      default: ;  // the record leaves
    endcase
    (* parallel_case *) case (1'b1)
      phase[4]: dead_q <= !fits_bc || !fits_flat || front_q.opacity >= OpacityW'(pipegs_pkg::CutBudget);
      phase[5]: dead_q <= dead_q || !fits_def || !fits_flat;
      phase[6], phase[1]: dead_q <= dead_q || !fits_a;
      phase[7], phase[0]: dead_q <= dead_q || !fits_bc;
      phase[2]: dead_q <= dead_q || !fits_def;
      default: ;
    endcase
  end

  // --- what leaves -------------------------------------------------------------------------------------------------
  logic dead;
  assign dead = dead_q || !(a_q[AW+1:AW-1] == '0 || &a_q[AW+1:AW-1]) || c_q[BcW] != c_q[BcW-1] ||
                e_q[DefW] != e_q[DefW-1];
  always_comb begin
    coeff      = '0;
    coeff.kind = front_q.kind;
    if (front_q.kind == pipegs_pkg::KindData) begin
      coeff.mean_x   = front_q.mean_x;
      coeff.mean_y   = front_q.mean_y;
      coeff.extent_x = front_q.extent_x;
      coeff.extent_y = front_q.extent_y;
      coeff.dead     = dead;
      if (!dead) begin
        coeff.a = AW'(a_q);
        coeff.b = front_q.swap ? BcW'(c_q) : b_q;
        coeff.c = front_q.swap ? b_q : BcW'(c_q);
        coeff.d = front_q.swap ? DefW'(e_q) : d_q;
        coeff.e = front_q.swap ? d_q : DefW'(e_q);
        coeff.f = f_q;
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (leave) coeff_q <= coeff;
    if (move) front_q <= conic_i;
  end

  if (pipegs_pkg::Oriented) begin : gen_oriented
    localparam int unsigned BoxBits = pipegs_pkg::TiltW + 2 * pipegs_pkg::SideW;
    logic [BoxBits-1:0]           box_q;
    logic [pipegs_pkg::TiltW-1:0] tilt;
    logic [pipegs_pkg::SideW-1:0] side_u, side_v;
    assign {tilt, side_u, side_v} = box_q;
    always_ff @(posedge clk_i) begin
      if (leave) box_q <= front_q.kind == pipegs_pkg::KindData ? {front_q.tilt, front_q.side_u, front_q.side_v} : '0;
    end
    always_comb begin
      coeff_o        = coeff_q;
      coeff_o.tilt   = tilt;
      coeff_o.side_u = side_u;
      coeff_o.side_v = side_v;
    end
  end else begin : gen_reached
    assign coeff_o = coeff_q;
  end

  wire unused_bits = &{1'b0, front_q.wide_e};  // looked at while the record is still in front of the stage

endmodule
