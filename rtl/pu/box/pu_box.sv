// SPDX-License-Identifier: Apache-2.0
// pu_box: the oriented box of three standard deviations along both axes of a covariance, and the box around it.
//
// Paper   the oriented box of GSCore, from which the paper's baseline is reproduced (Sec. 5.2).
// Idea    With n^2 = 1 + tilt^2 the half lengths times n are those that (1, tilt) and (-tilt, 1) measure:
//           long = 3 sqrt(larger n^2),  short = 3 sqrt(det / larger n^2),  both grown by 2^-13 long and two units
//           extents (long + short |tilt|) / n^2,  (long |tilt| + short) / n^2
//         Two multipliers, one root:
//           cycle  0         1        2   3         4    5    6     7     8     9      10      11      12
//           mult   long n^2  det/long     short n^2 root            root
//           root                      in                 in
//           mult                                                    L |t|       S |t|  across  along
//           here                          ratio          L                S                    extent  extent
// Stream  axes in, covariance with its box out, in order; an end beat passes with all other fields zero.
// Pace    One record in eight cycles, latency 14.
// Model   cpp_model/pu/box/pu_box.hpp

module pu_box (
  input  logic                     clk_i,
  input  logic                     rst_ni,

  input  logic                     axes_valid_i,
  output logic                     axes_ready_o,
  input  pipegs_pkg::axes_t        axes_i,

  output logic                     covariance_valid_o,
  input  logic                     covariance_ready_i,
  output pipegs_pkg::covariance_t  covariance_o,

  output logic                     busy_o
);

  localparam int unsigned MantissaW = pipegs_pkg::MantissaW;
  localparam int unsigned AxisMW    = pipegs_pkg::AxisMW;
  localparam int unsigned ShareW    = pipegs_pkg::ShareW;
  localparam int unsigned ShareF    = ShareW - 1;
  localparam int unsigned TiltW     = pipegs_pkg::TiltW;
  localparam int unsigned TiltF     = TiltW - 2;
  localparam int unsigned SideW     = pipegs_pkg::SideW;
  localparam int unsigned SideF     = 8;
  localparam int unsigned ExtentW   = pipegs_pkg::ExtentW;
  localparam int unsigned ExtentF   = 4;
  localparam int unsigned GrowthBy  = 13;
  localparam int unsigned TopW      = AxisMW + ShareF;        // of a mantissa times stretch, or one bit less
  localparam int unsigned ExpW      = pipegs_pkg::AxisEW + 2;  // sums of exponents
  localparam int unsigned ProductW  = 2 * AxisMW;
  localparam int unsigned RsqrtInW  = 20;
  localparam int unsigned RsqrtOutW = 18;
  localparam int unsigned RootW     = 20;                      // u1.19
  localparam int unsigned ThreeW    = RootW + 2;
  localparam int unsigned WholeW    = SideW + 1;               // a side, and part of the other one
  localparam int unsigned LengthPW  = WholeW + ShareW;
  localparam int unsigned Depth     = pipegs_pkg::BoxDepth;

  typedef struct packed {logic [Depth-1:0][3:0] of;} slots_t;
  logic               take, claim, step, data;
  logic [7:0]         phase;
  slots_t             slots;
  logic [Depth:1]     late;  // cycle 7 + i: what was issued i cycles ago is the last phase of a record
  for (genvar i = 1; i <= Depth; i += 1) begin : gen_late
    assign late[i] = slots.of[i-1] == 4'hf;
  end

  pu_phases #(.Depth(Depth), .Claim(pipegs_pkg::BoxClaim)) u_phases (
    .clk_i,
    .rst_ni,
    .in_valid_i(axes_valid_i),
    .in_ready_o(axes_ready_o),
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

  pipegs_pkg::axes_t       in_q;
  pipegs_pkg::covariance_t out_q;
  assign data = in_q.kind == pipegs_pkg::KindData;

  // --- what a root is taken of: a product in phases 1 and 4 --------------------------------------------------------
  // product 2^e = u 2^(2 n), u in [1, 4), u2.18: of the two leading bits the exponent's parity says which are whole.
  logic [ProductW-1:0]    product_q;
  logic signed [ExpW-1:0] e, ratio_e_q;
  logic [TopW-1:0]        square;
  logic                   odd, high;
  logic [RsqrtInW-1:0]    u, u_q;
  logic signed [ExpW-1:0] whole_e, long_up_q, short_up_q;
  assign square  = product_q[TopW-1:0];
  assign e       = phase[1] ? ExpW'(in_q.long_e) - $signed(ExpW'(ShareF - 1)) : ratio_e_q - $signed(ExpW'(ShareF - 1));
  assign odd     = e[0];
  assign high   = square[TopW-1];
  assign u       = odd ? (high ? {1'b0, square[TopW-1:TopW+1-RsqrtInW]} : square[TopW-2:TopW-1-RsqrtInW]) :
                   square[TopW-1:TopW-RsqrtInW];
  assign whole_e = e + $signed(ExpW'(TopW - RsqrtInW + 18)) +
                   (odd ? (high ? $signed(ExpW'(1)) : -$signed(ExpW'(1))) : $signed(ExpW'(0)));

  logic [RsqrtOutW-1:0] inverse;
  pipegs_rsqrt u_rsqrt (
    .clk_i,
    .u_i(u_q),
    .r_o(inverse)
  );

  // --- the first multiplier ------------------------------------------------------------------------------------------
  logic [AxisMW-1:0]      left, right, ratio_m, ratio_m_q, det;
  logic                   top;
  logic signed [ExpW-1:0] ratio_e;
  if (MantissaW > AxisMW) begin : gen_cut
    assign det = in_q.det_m[MantissaW-1:MantissaW-AxisMW];
  end else begin : gen_fill
    assign det = AxisMW'(in_q.det_m) << (AxisMW - MantissaW);
  end
  assign top     = product_q[ProductW-1];
  assign ratio_m = top ? product_q[ProductW-1:ProductW-AxisMW] : product_q[ProductW-2:ProductW-1-AxisMW];
  assign ratio_e = ExpW'(in_q.det_e) - ExpW'(in_q.long_e) + $signed(ExpW'(MantissaW) - ExpW'(2 * AxisMW)) +
                   $signed({{(ExpW - 1){1'b0}}, top});
  always_comb begin
    left  = AxisMW'(u_q);
    right = AxisMW'(inverse);
    (* parallel_case *) case (1'b1)
      phase[0]: begin left = in_q.long_m; right = AxisMW'(in_q.stretch); end
      phase[1]: begin left = det;         right = in_q.inverse_m;        end
      phase[3]: begin left = ratio_m_q;   right = AxisMW'(in_q.stretch); end
      default: ;
    endcase
  end

  // --- three roots, in units of 1/256 pixel: cycles 5 and 8 ----------------------------------------------------------
  localparam int unsigned ByW = 6;
  logic [ThreeW-1:0]       three;
  logic signed [ExpW-1:0]  up, down;
  logic [SideW+ThreeW-1:0] raised;
  logic [SideW-1:0]        length, length_q, breadth_q;
  logic [RootW-1:0]        root;
  assign root   = RootW'(product_q >> 17);
  assign three  = ThreeW'(root) + (ThreeW'(root) << 1) + ThreeW'(1);
  assign up     = ((phase[5] ? long_up_q : short_up_q) >>> 1) + $signed(ExpW'(SideF) - ExpW'(RootW - 1));
  assign down   = -up;
  assign raised = (SideW + ThreeW)'(three) << up[ByW-1:0];
  always_comb begin
    if (up >= $signed(ExpW'(SideW))) length = '1;
    else if (up >= 0) length = raised[SideW+ThreeW-1:SideW] != '0 ? '1 : raised[SideW-1:0];
    else length = (down >= $signed(ExpW'(2 ** ByW)) ? '0 : SideW'(three) >> down[ByW-1:0]) + SideW'(1);
  end

  logic [SideW:0]   grown_long, grown_short;
  logic [SideW-1:0] growth, side_long, side_short;
  assign growth      = (length_q >> GrowthBy) + SideW'(1);
  assign grown_long  = {1'b0, length_q} + {1'b0, growth};
  assign grown_short = {1'b0, breadth_q} + {1'b0, growth};
  assign side_long   = grown_long[SideW] ? '1 : grown_long[SideW-1:0];
  assign side_short  = grown_short[SideW] ? '1 : grown_short[SideW-1:0];

  // --- the second multiplier: the extents ----------------------------------------------------------------------------
  logic [ShareW-1:0]   slope, shrink_q, share;
  logic [WholeW-1:0]   of, along_q;
  logic [LengthPW-1:0] part_q;
  logic [SideW-1:0]    tilted, tilted_q;
  logic [LengthPW-1:0] exact;
  logic [ExtentW-1:0]  extent;
  logic                swap_q;
  assign slope  = ShareW'(TiltW'(phase[6] ? (in_q.tilt[TiltW-1] ? -in_q.tilt : in_q.tilt) :
                                 (out_q.tilt[TiltW-1] ? -out_q.tilt : out_q.tilt)));
  assign tilted = SideW'(part_q >> TiltF);
  always_comb begin
    of    = {1'b0, side_long};
    share = slope;
    if (late[2]) of = {1'b0, side_short};
    if (late[3]) begin of = WholeW'(side_short) + WholeW'(tilted_q) + WholeW'(1); share = shrink_q; end
    if (late[4]) begin of = along_q;                                             share = shrink_q; end
  end
  assign exact  = (part_q >> (ShareF + SideF - ExtentF)) + LengthPW'(1);
  assign extent = exact[LengthPW-1:ExtentW] != '0 ? '1 : exact[ExtentW-1:0];

  always_ff @(posedge clk_i) begin
    if (take) in_q <= axes_i;
    if (step) begin
      product_q <= ProductW'(left) * ProductW'(right);
      part_q    <= LengthPW'(of) * LengthPW'(share);
      if (phase[1] || phase[4]) u_q <= u;
      if (phase[1]) long_up_q <= whole_e;
      if (phase[4]) short_up_q <= whole_e;
      if (phase[2]) begin
        ratio_m_q <= ratio_m;
        ratio_e_q <= ratio_e;
      end
      if (phase[5]) length_q <= length;
      if (late[1]) breadth_q <= length;
      if (phase[7]) tilted_q <= tilted;
      if (late[3]) along_q <= WholeW'(side_long) + WholeW'(tilted) + WholeW'(1);
    end
    if (claim) begin
      out_q      <= '0;
      out_q.kind <= in_q.kind;
      swap_q     <= in_q.swap;
      shrink_q   <= in_q.shrink;
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
        out_q.tilt    <= in_q.tilt;
      end
    end
    if (step && out_q.kind == pipegs_pkg::KindData) begin
      if (late[2]) begin
        out_q.side_u <= swap_q ? side_long : side_short;
        out_q.side_v <= swap_q ? side_short : side_long;
      end
      if (late[4]) begin  // across
        if (swap_q) out_q.box_y <= extent;
        else out_q.box_x <= extent;
      end
      if (late[5]) begin  // along
        if (swap_q) out_q.box_x <= extent;
        else out_q.box_y <= extent;
      end
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
      covariance_o         = out_q;
      covariance_o.sharp_m = sharp_m_q;
      covariance_o.sharp_e = sharp_e_q;
    end
  end else begin : gen_no_sharp
    assign covariance_o = out_q;
  end

  wire unused_bits = &{1'b0, phase, late, in_q, product_q, part_q};

endmodule
