// SPDX-License-Identifier: Apache-2.0
// pu_four_coeff: pu_coeff in four cycles: the six coefficients of Eq. 3 for one Gaussian and one part of a window.
//
// Paper   Eq. 3, step 1 of Fig. 5a, once per Gaussian and window; the anchor is the window's first pixel.
// Idea    (p, q) = (x, y), exchanged if swap; u = narrow m, w = mean_p - m mean_q, both as mantissa and exponent:
//           A = -(narrow w^2 + wide mean_q^2) - opacity      D = -narrow      E = -(u m + wide)
//           B = 2 narrow w      C = 2 (wide mean_q - u w)                    F = 2 u
//         Out of range: dead; no pixel of the window can count (the proof is in the model's head).
// Stream  conic in, coeff out, in order; an end beat passes with all other fields zero.
// Pace    One record in four cycles, latency 11. Two multipliers behind registers of their operands, an aligner for
//         each, one normaliser:
//           cycle   0       1       2       3         4        5         6      7          8    9
//           first   m q     wide q  u       narrow w
//           norm    mean_q          w
//           second                  wide qq u m       nar. ww  u w
//           sums                            C D       F E      B A       E      A          C    out
// Record  The sums are the output register: from the claim in cycle 6 on they are this record's.
// Model   cpp_model/pu/conic/pu_coeff.hpp

module pu_four_coeff (
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

  localparam int unsigned Depth     = pipegs_pkg::CoeffDepth;

  // What is kept behind the phases.
  typedef struct packed {
    logic [pipegs_pkg::KindW-1:0] kind;
    logic                         swap;
    logic signed [MeanW-1:0]      mean_x;
    logic signed [MeanW-1:0]      mean_y;
    logic [pipegs_pkg::ExtentW-1:0] extent_x;
    logic [pipegs_pkg::ExtentW-1:0] extent_y;
    logic [OpacityW-1:0]          opacity;
    logic signed [FloatEW-1:0]    narrow_e;
  } behind_t;

  logic                  take, claim, step;
  logic [3:0]            phase;
  logic [4*Depth-1:0]    slots;
  pipegs_pkg::conic_t    in_q;
  behind_t               behind_q;

  pu_phases #(
    .Phases(4),
    .Depth(Depth),
    .Claim(pipegs_pkg::CoeffClaim)
  ) u_phases (
    .clk_i,
    .rst_ni,
    .in_valid_i(conic_valid_i),
    .in_ready_o(conic_ready_o),
    .out_valid_o(coeff_valid_o),
    .out_ready_i(coeff_ready_i),
    .take_o(take),
    .claim_o(claim),
    .step_o(step),
    .held_o(),
    .phase_o(phase),
    .slots_o(slots),
    .busy_o
  );
  // A record's cycle from 4 on: its last phase is so many levels away.
  logic [8:4] cycle;
  for (genvar i = 4; i <= 8; i += 1) begin : gen_cycle
    assign cycle[i] = slots[4*(i-4)+:4] == 4'b1011;
  end
  logic [3:0] turn_q;  // cycles 2 to 5
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) turn_q <= '0;
    else if (step) for (int unsigned i = 0; i < 4; i += 1) turn_q[i] <= slots[0+:4] == 4'(8 + i);
  end

  // --- the two numbers that need their leading bits: mean_q and w --------------------------------------------------
  logic signed [MeanW-1:0]    mean_q, mean_p;
  logic signed [WideW-1:0]    w_q, wide;
  logic signed [NormalW-1:0]  raised;
  logic [LengthW-1:0]         length, spare;  // bits from the leading one on; between the sign and that
  logic signed [NormalW-1:0]  normal_q_q, normal_w_q;
  logic signed [SumW-1:0]     normal_q_e_q, normal_w_e_q;
  assign mean_q = in_q.swap ? in_q.mean_x : in_q.mean_y;
  assign mean_p = in_q.swap ? in_q.mean_y : in_q.mean_x;
  assign wide   = phase[0] ? WideW'(mean_q) : w_q;

  pipegs_bit_length #(.DataW(WideW - 1)) u_length (
    .in_i(wide[WideW-2:0] ^ {(WideW - 1){wide[WideW-1]}}),
    .length_o(length)
  );
  assign spare  = LengthW'(WideW - 1) - length;
  assign raised = NormalW'($signed(wide <<< spare) >>> (WideW - NormalW));

  // --- the first multiplier ----------------------------------------------------------------------------------------
  // A product m * 2^e is shifted right by Guard - CoeffF - e (its shift is one less); e is a constant plus an exponent
  // plus 0, 1 or 2 times normal_e.
  localparam int unsigned ShortW  = MeanW > MantissaW + 1 ? MeanW : MantissaW + 1;  // left operand
  localparam int unsigned FirstW  = ShortW + RightW;
  localparam logic signed [SumW-1:0] Base = $signed(SumW'(Guard) - SumW'(CoeffF + 1));
  logic signed [ShortW-1:0] short_left_q;
  logic signed [RightW-1:0] short_right_q;
  logic signed [FirstW-1:0] first_q;
  logic signed [SumW-1:0]   first_shift, first_shift_q;
  always_comb begin
    first_shift = Base - $signed(SumW'(1)) - SumW'(in_q.narrow_e) - normal_w_e_q;  // narrow w
    (* parallel_case *) case (1'b1)
      phase[1]: first_shift = Base - $signed(SumW'(1)) - SumW'(in_q.wide_e) - normal_q_e_q;  // wide mean_q
      phase[2]: first_shift = Base + $signed(SumW'(SlopeF - 1)) - SumW'(in_q.narrow_e);  // u
      default: ;
    endcase
  end
  // Operands of the next cycle.
  always_ff @(posedge clk_i) begin
    if (take) begin  // m mean_q
      short_left_q  <= conic_i.swap ? ShortW'(conic_i.mean_x) : ShortW'(conic_i.mean_y);
      short_right_q <= RightW'(conic_i.slope_m);
    end else if (step) begin
      short_left_q  <= ShortW'($signed({1'b0, phase[0] ? in_q.wide_m : in_q.narrow_m}));
      short_right_q <= phase[1] ? RightW'(in_q.slope_m) : RightW'(raised);
    end
  end
  always_ff @(posedge clk_i) if (step) begin
    first_q       <= FirstW'(short_left_q) * FirstW'(short_right_q);
    first_shift_q <= first_shift;
    if (phase[0]) begin
      normal_q_q   <= raised;
      normal_q_e_q <= $signed(SumW'(WideW - 1 - NormalF) - SumW'(spare) - SumW'(MeanF));
    end
    if (phase[1]) w_q <= (WideW'(mean_p) <<< SlopeF) - WideW'(first_q);
    if (phase[2]) begin
      normal_w_q   <= raised;
      normal_w_e_q <= $signed(SumW'(WideW - 1 - NormalF) - SumW'(spare) - SumW'(MeanF + SlopeF));
    end
  end

  // --- the second multiplier, and beside it the shift that aligns its product --------------------------------------
  logic signed [LeftW-1:0]   left, left_q, u, u_q;
  logic signed [RightW-1:0]  right, right_q;
  logic signed [SumW-1:0]    shift, shift_next_q, shift_q;
  assign u = LeftW'(first_q >>> SlopeDrop);
  always_comb begin
    left  = LeftW'(first_q >>> Drop);
    right = RightW'(normal_w_q);
    shift = Base - $signed(SumW'(Drop)) - SumW'(behind_q.narrow_e) - (normal_w_e_q <<< 1);
    (* parallel_case *) case (1'b1)
      turn_q[0]: begin  // wide mean_q^2
        right = RightW'(normal_q_q);
        shift = Base - $signed(SumW'(Drop)) - SumW'(in_q.wide_e) - (normal_q_e_q <<< 1);
      end
      turn_q[1]: begin  // u m
        left  = u;
        right = RightW'(in_q.slope_m);
        shift = Base + $signed(SumW'(2 * SlopeF) - SumW'(SlopeDrop)) - SumW'(in_q.narrow_e);
      end
      turn_q[3]: begin  // u w
        left  = u_q;
        shift = Base + $signed(SumW'(SlopeF) - SumW'(SlopeDrop + 1)) - SumW'(behind_q.narrow_e) - normal_w_e_q;
      end
      default: ;  // narrow w^2
    endcase
  end

  // Two products, of the right operand's low and high bits, are added behind their registers.
  localparam int unsigned LowW  = RightW / 2;
  localparam int unsigned HighW = RightW - LowW;
  logic signed [LeftW+LowW:0]    low_q;
  logic signed [LeftW+HighW-1:0] high_q;
  logic signed [RightW-1:0]      right_high;
  logic signed [LowW:0]          right_low;
  logic signed [ProductW-1:0]    product;
  assign right_low  = {1'b0, right_q[LowW-1:0]};
  assign right_high = right_q >>> LowW;
  assign product    = ProductW'(low_q) + (ProductW'(high_q) <<< LowW);

  always_ff @(posedge clk_i) if (step) begin
    left_q       <= left;
    right_q      <= right;
    low_q        <= (LeftW + LowW + 1)'(left_q) * (LeftW + LowW + 1)'(right_low);
    high_q       <= (LeftW + HighW)'(left_q) * (LeftW + HighW)'(right_high);
    shift_next_q <= shift;
    shift_q      <= shift_next_q;
    if (turn_q[1]) u_q <= u;
  end

  // --- products to CoeffF fraction bits, to nearest ----------------------------------------------------------------
  logic signed [AW-1:0] first_aligned, aligned;
  logic                 first_up, first_fits_a, first_fits_bc, first_fits_def, up, fits_a, fits_bc, fits_def;
  pu_align #(.DataW(FirstW), .Guard(Guard), .ShiftW(SumW)) u_align_first (
    .clk_i,
    .enable_i(step),
    .product_i(first_q),
    .shift_i(first_shift_q),
    .floor_o(first_aligned),
    .up_o(first_up),
    .fits_a_o(first_fits_a),
    .fits_bc_o(first_fits_bc),
    .fits_def_o(first_fits_def)
  );
  pu_align #(.DataW(ProductW), .Guard(Guard), .ShiftW(SumW)) u_align (
    .clk_i,
    .enable_i(step),
    .product_i(product),
    .shift_i(shift_q),
    .floor_o(aligned),
    .up_o(up),
    .fits_a_o(fits_a),
    .fits_bc_o(fits_bc),
    .fits_def_o(fits_def)
  );

  // narrow and wide themselves: cycles 1 and 2 the shift, 2 and 3 the number, 3 and 4 its use.
  localparam int unsigned FlatW = MantissaW + FlatGuard;
  logic [MantissaW-1:0]      flat_m;
  logic signed [FloatEW-1:0] flat_e;
  logic signed [SumW-1:0]    flat_shift_q;
  logic [FlatByW-1:0]        flat_by;
  logic [FlatW-1:0]          flat_halves, flat_q;
  logic                      flat_right_q, fits_flat;
  assign flat_m      = phase[2] ? in_q.narrow_m : in_q.wide_m;
  assign flat_e      = phase[1] ? in_q.narrow_e : in_q.wide_e;
  assign flat_by     = flat_shift_q[SumW-2:FlatByW] != '0 ? '1 : flat_shift_q[FlatByW-1:0];
  assign flat_halves = (FlatW'(flat_m) << FlatGuard) >> flat_by;
  assign fits_flat   = flat_right_q && flat_q[FlatW-1:DefW-1] == '0;
  always_ff @(posedge clk_i) if (step) begin
    flat_shift_q <= $signed(SumW'(FlatGuard) - SumW'(CoeffF + 1)) - SumW'(flat_e);
    flat_right_q <= !flat_shift_q[SumW-1];
    flat_q       <= (flat_halves >> 1) + FlatW'(flat_halves[0]);
  end

  // --- sums: up to the claim, and from it on ------------------------------------------------------------------------
  logic signed [BcW-1:0]     first_bc;
  logic signed [SumBcW-1:0]  c_early_q, c_q;  // with respect to q
  logic signed [BcW-1:0]     b_early_q, b_q;  // with respect to p
  logic signed [DefW-1:0]    d_early_q, f_early_q, d_q, f_q;
  logic signed [SumDefW-1:0] e_early_q, e_q;
  logic signed [SumAW-1:0]   a_early_q, a_q;
  logic                      dead_early_q, dead_q;
  behind_t                   out_q;
  assign first_bc = BcW'(first_aligned) + $signed(BcW'(first_up));

  always_ff @(posedge clk_i) begin
    if (take) in_q <= conic_i;
    if (step) begin
      if (phase[3]) begin
        behind_q.kind     <= in_q.kind;
        behind_q.swap     <= in_q.swap;
        behind_q.mean_x   <= in_q.mean_x;
        behind_q.mean_y   <= in_q.mean_y;
        behind_q.extent_x <= in_q.extent_x;
        behind_q.extent_y <= in_q.extent_y;
        behind_q.opacity  <= in_q.opacity;
        behind_q.narrow_e <= in_q.narrow_e;
        d_early_q    <= $signed(DefW'(0) - DefW'(flat_q));
        c_early_q    <= SumBcW'(first_aligned) + $signed(SumBcW'(first_up));
        dead_early_q <= !first_fits_bc || !fits_flat || in_q.opacity >= OpacityW'(pipegs_pkg::CutBudget);
      end
      if (cycle[4]) begin
        e_early_q    <= $signed(SumDefW'(0) - SumDefW'(flat_q));
        f_early_q    <= DefW'(first_aligned) + $signed(DefW'(first_up));
        dead_early_q <= dead_early_q || !first_fits_def || !fits_flat;
      end
      if (cycle[5]) begin
        b_early_q    <= first_bc;
        a_early_q    <= $signed(SumAW'(0) - (SumAW'(behind_q.opacity) << (CoeffF - OpacityF))) - SumAW'(aligned) -
                        $signed(SumAW'(up));
        dead_early_q <= dead_early_q || !first_fits_bc || !fits_a;
      end
      if (cycle[7]) a_q <= a_q - SumAW'(aligned) - $signed(SumAW'(up));
      if (cycle[8]) c_q <= c_q - SumBcW'(aligned) - $signed(SumBcW'(up));
      if (cycle[7]) dead_q <= dead_q || !fits_a;
      if (cycle[8]) dead_q <= dead_q || !fits_bc;
    end
    if (claim) begin  // cycle 6
      out_q  <= behind_q;
      a_q    <= a_early_q;
      b_q    <= b_early_q;
      c_q    <= c_early_q;
      d_q    <= d_early_q;
      e_q    <= e_early_q - SumDefW'(aligned) - $signed(SumDefW'(up));
      f_q    <= f_early_q;
      dead_q <= dead_early_q || !fits_def;
    end
  end

  // --- what leaves -------------------------------------------------------------------------------------------------
  logic dead;
  assign dead = dead_q || !(a_q[AW+1:AW-1] == '0 || &a_q[AW+1:AW-1]) || c_q[BcW] != c_q[BcW-1] ||
                e_q[DefW] != e_q[DefW-1];
  always_comb begin
    coeff_o      = '0;
    coeff_o.kind = out_q.kind;
    if (out_q.kind == pipegs_pkg::KindData) begin
      coeff_o.mean_x   = out_q.mean_x;
      coeff_o.mean_y   = out_q.mean_y;
      coeff_o.extent_x = out_q.extent_x;
      coeff_o.extent_y = out_q.extent_y;
      coeff_o.dead     = dead;
      if (!dead) begin
        coeff_o.a = AW'(a_q);
        coeff_o.b = out_q.swap ? BcW'(c_q) : b_q;
        coeff_o.c = out_q.swap ? b_q : BcW'(c_q);
        coeff_o.d = out_q.swap ? DefW'(e_q) : d_q;
        coeff_o.e = out_q.swap ? d_q : DefW'(e_q);
        coeff_o.f = f_q;
      end
    end
  end

  // Bits that a narrowing cuts, and what only the claim needs.
  wire unused_bits = &{1'b0, phase, slots, cycle, turn_q, out_q, first_aligned, first_fits_a, first_q};

endmodule
