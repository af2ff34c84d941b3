// SPDX-License-Identifier: Apache-2.0
// pu_reach: drops a Gaussian whose own ellipse ends before the window; pu_cull tests only its largest scale.
//
// Paper   Sec. 4.2, frustum culling; the paper tests a sphere only.
// Idea    keep iff the gap G to the window is not positive or (G z)^2 < (r f w)^2 sum_k s_k^2 (|n . R_k| + Error)^2,
//         with n = W^T (z, 0, -x') (see the model). The Gaussian waits in a queue while a pipeline that never stands
//         still works out one bit; the queue's places are the pipeline's. Stages:
//           1 the axis   2 normalised gap, guard band   3 clamped x, z   4 products of W, of q   5 n, R
//           6 nine products   7 |n . R_k|   8 times s_k   9 squares   10 their sum   11 times (r f w)^2
//           12 comparison -> queue of bits
// Stream  culled in, visible out: only those that are kept, and every end beat, in order.
// Pace    One per cycle, latency 12. What is dropped leaves its queue in one cycle. A stage's registers are clocked for
//         a Gaussian only.
// Model   cpp_model/pu/front/pu_reach.hpp

module pu_reach (
  input  logic                  clk_i,
  input  logic                  rst_ni,

  input  pipegs_pkg::rotation_t rotation_i,
  input  pipegs_pkg::lens_t     lens_i,

  input  logic                  culled_valid_i,
  output logic                  culled_ready_o,
  input  pipegs_pkg::culled_t   culled_i,

  output logic                  visible_valid_o,
  input  logic                  visible_ready_i,
  output pipegs_pkg::visible_t  visible_o,

  output logic                  busy_o
);

  localparam int unsigned QuatW   = pipegs_pkg::QuatW;
  localparam int unsigned ScaleW  = pipegs_pkg::ScaleW;
  localparam int unsigned ScaleMW = pipegs_pkg::ScaleMW;
  localparam int unsigned ScaleEW = pipegs_pkg::ScaleEW;
  localparam int unsigned RotW    = pipegs_pkg::RotW;
  localparam int unsigned TanF    = pipegs_pkg::TanF;
  localparam int unsigned GapW    = pipegs_pkg::GapW;
  localparam int unsigned MagW    = pipegs_pkg::CutW - 1;  // magnitude bits
  localparam int unsigned Depth   = pipegs_pkg::ReachDepth;
  localparam int unsigned Stages  = 11;                    // before the comparison

  // --- what waits, and the bits that tell what becomes of it -------------------------------------------------------
  localparam int unsigned CountW = $clog2(Depth + 1);
  pipegs_pkg::visible_t culled;
  pipegs_pkg::gap_t     gap;
  logic [Stages:1]      valid_q, load;  // register n holds a Gaussian; it takes one
  logic                 take, word_valid, bit_valid, kept, next, keep;
  logic [CountW-1:0]    count;
  assign culled          = culled_i.visible;
  assign gap             = culled_i.gap;
  assign take            = culled_valid_i && culled_ready_o;
  assign visible_valid_o = word_valid && bit_valid && kept;
  assign next            = word_valid && bit_valid && (!kept || visible_ready_i);
  assign busy_o          = count != '0;

  pipegs_sram_fifo #(.DataW(pipegs_pkg::VisibleBits), .Depth(Depth)) u_words (
    .clk_i,
    .rst_ni,
    .in_valid_i(culled_valid_i),
    .in_ready_o(culled_ready_o),
    .in_i(culled),
    .out_valid_o(word_valid),
    .out_ready_i(next),
    .out_o(visible_o),
    .count_o(count)
  );

  // As many bits as words at most.
  logic              bit_ready;
  logic [CountW-1:0] bit_count;
  pipegs_fifo #(.DataW(1), .Depth(Depth)) u_bits (
    .clk_i,
    .rst_ni,
    .in_valid_i(valid_q[Stages]),
    .in_ready_o(bit_ready),
    .in_i(keep),
    .out_valid_o(bit_valid),
    .out_ready_i(next),
    .out_o(kept),
    .count_o(bit_count)
  );

  assign load = {valid_q[Stages-1:1], take};
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else valid_q <= load;
  end

  // --- what rides along --------------------------------------------------------------------------------------------
  logic       test_q    [Stages+1];  // 1 to 11: it may be dropped; beside an end the gap is zero
  logic       along_x_q [Stages];    // 1 to 8: the axis
  logic [5:0] opacity_q [Stages];    // 1 to 8

  // --- stage 1: the axis along which the mean is farther out -------------------------------------------------------
  logic                     along_x;
  logic signed [GapW-1:0]   gap1_q;
  logic signed [MagW:0]     side1_q;
  logic        [MagW-1:0]   z1_q, z2_q;
  typedef struct packed {logic [2:0][ScaleEW-1:0] of;} exps_t;
  typedef struct packed {logic [2:0][6:0] of;} ones_t;  // mantissas of the scales, 32 to 64, or 0
  exps_t                    exps1_q;
  ones_t                    ones1_q;
  logic [ScaleEW-1:0]       largest1_q, larger;
  logic [ScaleEW-1:0]       e0, e1, e2;
  logic signed [8:0]        exponent1_q;
  assign along_x = gap.gap_x >= gap.gap_y;
  assign e0      = culled.scale_0[ScaleW-1:ScaleMW];
  assign e1      = culled.scale_1[ScaleW-1:ScaleMW];
  assign e2      = culled.scale_2[ScaleW-1:ScaleMW];
  assign larger  = e0 > e1 ? e0 : e1;
  // The six leading bits, rounded up.
  function automatic logic [6:0] six(input logic [ScaleW-1:0] scale);
    logic [ScaleMW:0] padded;
    padded = {1'b1, scale[ScaleMW-1:0]} + (ScaleMW + 1)'((64'd1 << (ScaleMW - 5)) - 64'd1);
    // A carry out of the leading one leaves zeros.
    six = scale[ScaleW-1:ScaleMW] == '0 ? '0 : padded[ScaleMW] ? 7'(padded >> (ScaleMW - 5)) : 7'd64;
  endfunction
  always_ff @(posedge clk_i) begin
    if (load[1]) begin
      along_x_q[1] <= along_x;
      opacity_q[1] <= culled.opacity[pipegs_pkg::OpacityW-1:pipegs_pkg::OpacityW-6];
      test_q[1]    <= !gap.untested && (gap.gap_x > 0 || gap.gap_y > 0);
      gap1_q       <= along_x ? gap.gap_x : gap.gap_y;
      side1_q      <= along_x ? gap.x : gap.y;
      z1_q         <= gap.z[MagW-1:0];
      exps1_q      <= {e2, e1, e0};
      ones1_q      <= {six(culled.scale_2), six(culled.scale_1), six(culled.scale_0)};
      largest1_q   <= larger > e2 ? larger : e2;
      exponent1_q  <= $signed(9'(culled.view_exp)) + $signed(9'(gap.cut));
    end
    for (int unsigned i = 1; i < Stages; i += 1) if (load[i+1]) test_q[i+1] <= test_q[i];
    for (int unsigned i = 1; i < Stages - 1; i += 1) begin
      if (load[i+1]) begin
        along_x_q[i+1] <= along_x_q[i];
        opacity_q[i+1] <= opacity_q[i];
      end
    end
  end

  // The quaternion: ten leading bits behind the sign, and a one for the middle of the rest.
  localparam int unsigned F = 11;
  localparam int unsigned QuatWideW = QuatW > F ? QuatW : F + 1;
  localparam int unsigned QuatDown  = QuatW > F ? QuatW - F : 0;
  localparam int unsigned QuatUp    = QuatW > F ? 1 : F + 1 - QuatW;
  function automatic logic signed [F:0] middle_q(input logic signed [QuatW-1:0] q);
    logic signed [QuatWideW-1:0] wide;
    wide     = QuatWideW'(q);
    middle_q = ((F + 1)'(wide >>> QuatDown) <<< QuatUp) | $signed((F + 1)'(QuatW > F));
  endfunction
  logic signed [F:0] qw_q [4], qx_q [4], qy_q [4], qz_q [4];  // 1 to 3
  always_ff @(posedge clk_i) begin
    if (load[1]) begin
      qw_q[1] <= middle_q(culled.qw);
      qx_q[1] <= middle_q(culled.qx);
      qy_q[1] <= middle_q(culled.qy);
      qz_q[1] <= middle_q(culled.qz);
    end
    for (int unsigned i = 1; i < 3; i += 1) begin
      if (load[i+1]) begin
        qw_q[i+1] <= qw_q[i];
        qx_q[i+1] <= qx_q[i];
        qy_q[i+1] <= qy_q[i];
        qz_q[i+1] <= qz_q[i];
      end
    end
  end

  // --- stage 2: the gap's leading bits; how far the guard band goes ------------------------------------------------
  localparam int unsigned LimitW = 4 + F;
  localparam int unsigned GapMW  = 9;
  logic signed [GapW-1:0]         normal;
  logic        [$clog2(GapW)-1:0] gap_shift;
  logic        [GapMW-1:0]        gap2_q, gap3_q;
  logic        [LimitW-1:0]       limit;
  logic        [LimitW+MagW-1:0]  bound2_q;   // with F fraction bits
  logic signed [MagW:0]           side2_q;
  ones_t                          ones2_q;
  exps_t                          below2_q;   // exponents below the largest
  logic signed [8:0]              exponent2_q;
  assign limit = along_x_q[1] ? lens_i.limit_x[TanF+3:TanF+4-LimitW] : lens_i.limit_y[TanF+3:TanF+4-LimitW];
  pipegs_normalize #(.DataW(GapW)) u_gap (
    .in_i(gap1_q),
    .out_o(normal),
    .shift_o(gap_shift)
  );
  always_ff @(posedge clk_i) if (load[2]) begin
    gap2_q      <= normal[GapW-2:GapW-1-GapMW];
    bound2_q    <= (LimitW + MagW)'(limit) * (LimitW + MagW)'(z1_q);
    side2_q     <= side1_q;
    z2_q        <= z1_q;
    ones2_q     <= ones1_q;
    exponent2_q <= exponent1_q - $signed(9'(gap_shift)) - $signed(9'(largest1_q));
    for (int unsigned k = 0; k < 3; k += 1)
      below2_q.of[k] <= largest1_q - exps1_q.of[k];
  end

  // --- stage 3: x or y clamped, shifted up with z; the scales at the exponent of the largest ------------------------
  localparam int unsigned ZW     = 9;
  localparam int unsigned BoundW = LimitW + MagW - F + 1;  // signed
  logic signed [BoundW-1:0] bound, wide_side;
  logic signed [MagW:0]     side, raised_side;
  logic        [MagW-1:0]   sizes, raised_z;
  logic        [1:0]        lift;
  logic signed [ZW:0]       t3_q;
  logic        [ZW-1:0]     z3_q;
  ones_t                    scales;
  logic        [20:0]       scales_q [8];  // 3 to 7
  ones_t                    scales7;
  logic signed [8:0]        exponent3_q;
  assign bound       = $signed({1'b0, bound2_q[LimitW+MagW-1:F]});
  assign wide_side   = BoundW'(side2_q);
  assign side        = wide_side > bound     ? (MagW + 1)'(bound) :
                       wide_side + bound < 0 ? (MagW + 1)'(BoundW'(0) - bound) : side2_q;
  assign sizes       = z2_q | (side[MagW-1:0] ^ {MagW{side[MagW]}});
  assign lift        = sizes[MagW-1] ? 2'd0 : sizes[MagW-2] ? 2'd1 : sizes[MagW-3] ? 2'd2 : 2'd3;
  assign raised_side = side <<< lift;
  assign raised_z    = z2_q << lift;
  // Rounded up: one less than it, shifted, and one more; zero stays zero.
  function automatic logic [6:0] scaled(input logic [6:0] one, input logic [ScaleEW-1:0] below);
    scaled = one == '0 ? '0 : ((one - 7'd1) >> below) + 7'd1;
  endfunction
  for (genvar k = 0; k < 3; k += 1) begin : gen_scale
    assign scales.of[k] = scaled(ones2_q.of[k], below2_q.of[k]);
  end
  assign scales7 = scales_q[7];
  always_ff @(posedge clk_i) begin
    if (load[3]) begin
      gap3_q      <= gap2_q;
      t3_q        <= raised_side[MagW:MagW-ZW];
      z3_q        <= raised_z[MagW-1:MagW-ZW];
      exponent3_q <= exponent2_q;
      scales_q[3] <= scales;
    end
    for (int unsigned i = 3; i < 7; i += 1) if (load[i+1]) scales_q[i+1] <= scales_q[i];
  end

  // --- stage 4: products of the camera's axes, of the quaternion; gap times z; the comparison's shift ---------------
  // Of an axis of the camera two bits before the point and ten behind it, and a one for the middle of the rest.
  localparam int unsigned AxisW = F + 2;
  localparam int unsigned NpW   = AxisW + ZW + 2;
  logic signed [AxisW-1:0] across [3], forward [3];
  logic signed [NpW-1:0]   nz4_q [3], nt4_q [3];
  logic signed [2*F+1:0]   ww4_q, xx4_q, yy4_q, zz4_q, xy4_q, xz4_q, yz4_q, wx4_q, wy4_q, wz4_q;
  logic        [11:0]      far_q [10];      // 4 to 9
  logic        [5:0]       down_q [11];     // 4 to 10: how far 2^31 far^2 goes down, 31 - shift
  logic signed [9:0]       down4, twice3;
  logic        [4:0]       spread_e;
  function automatic logic signed [AxisW-1:0] middle_w(input logic [RotW-1:0] w);
    middle_w = {(AxisW - 1)'(w >> (RotW + 1 - AxisW)), 1'b1};
  endfunction
  assign across[0]  = middle_w(along_x_q[3] ? rotation_i.w00 : rotation_i.w10);
  assign across[1]  = middle_w(along_x_q[3] ? rotation_i.w01 : rotation_i.w11);
  assign across[2]  = middle_w(along_x_q[3] ? rotation_i.w02 : rotation_i.w12);
  assign forward[0] = middle_w(rotation_i.w20);
  assign forward[1] = middle_w(rotation_i.w21);
  assign forward[2] = middle_w(rotation_i.w22);
  assign spread_e   = along_x_q[3] ? lens_i.spread_x[12:8] : lens_i.spread_y[12:8];
  // Bits of the gap above its leading nine are GapW - 10 less its shift; 8 is the bias of the scales.
  assign twice3 = 10'(exponent3_q) <<< 1;
  assign down4  = $signed(10'(31 - 9 - 2 * (GapW - 1 - GapMW + 8))) - twice3 + $signed(10'(spread_e));
  logic [17:0] gap_z;
  assign gap_z = 18'(gap3_q) * 18'(z3_q);
  always_ff @(posedge clk_i) begin
    if (load[4]) begin
      for (int unsigned i = 0; i < 3; i += 1) begin
        nz4_q[i] <= NpW'(across[i]) * $signed(NpW'({z3_q, 1'b1}));
        nt4_q[i] <= NpW'(forward[i]) * NpW'($signed({t3_q, 1'b1}));
      end
      ww4_q <= (2 * F + 2)'(qw_q[3]) * (2 * F + 2)'(qw_q[3]);
      xx4_q <= (2 * F + 2)'(qx_q[3]) * (2 * F + 2)'(qx_q[3]);
      yy4_q <= (2 * F + 2)'(qy_q[3]) * (2 * F + 2)'(qy_q[3]);
      zz4_q <= (2 * F + 2)'(qz_q[3]) * (2 * F + 2)'(qz_q[3]);
      xy4_q <= (2 * F + 2)'(qx_q[3]) * (2 * F + 2)'(qy_q[3]);
      xz4_q <= (2 * F + 2)'(qx_q[3]) * (2 * F + 2)'(qz_q[3]);
      yz4_q <= (2 * F + 2)'(qy_q[3]) * (2 * F + 2)'(qz_q[3]);
      wx4_q <= (2 * F + 2)'(qw_q[3]) * (2 * F + 2)'(qx_q[3]);
      wy4_q <= (2 * F + 2)'(qw_q[3]) * (2 * F + 2)'(qy_q[3]);
      wz4_q <= (2 * F + 2)'(qw_q[3]) * (2 * F + 2)'(qz_q[3]);
      far_q[4]  <= gap_z[17:6];
      down_q[4] <= down4 < 0 ? 6'd0 : down4 > 10'sd62 ? 6'd62 : 6'(down4);
    end
    for (int unsigned i = 4; i < 9; i += 1) if (load[i+1]) far_q[i+1] <= far_q[i];
    for (int unsigned i = 4; i < 10; i += 1) if (load[i+1]) down_q[i+1] <= down_q[i];
  end

  // --- stage 5: the direction n, the Gaussian's axes ---------------------------------------------------------------
  localparam int unsigned NW    = 12;
  localparam int unsigned EntryW = F + 2;
  localparam int unsigned SumW  = 2 * F + 4;
  logic signed [NW-1:0]     n5_q [3];
  logic signed [EntryW-1:0] r5_q [9];  // column by column
  logic signed [NpW:0]      n4 [3];
  logic signed [SumW-1:0]   r4 [9];
  for (genvar i = 0; i < 3; i += 1) begin : gen_n
    assign n4[i] = (NpW + 1)'(nz4_q[i]) - (NpW + 1)'(nt4_q[i]) + $signed((NpW + 1)'(1 << (F - 1)));
  end
  assign r4[0] = SumW'(ww4_q) + SumW'(xx4_q) - SumW'(yy4_q) - SumW'(zz4_q);
  assign r4[1] = (SumW'(xy4_q) + SumW'(wz4_q)) <<< 1;
  assign r4[2] = (SumW'(xz4_q) - SumW'(wy4_q)) <<< 1;
  assign r4[3] = (SumW'(xy4_q) - SumW'(wz4_q)) <<< 1;
  assign r4[4] = SumW'(ww4_q) - SumW'(xx4_q) + SumW'(yy4_q) - SumW'(zz4_q);
  assign r4[5] = (SumW'(yz4_q) + SumW'(wx4_q)) <<< 1;
  assign r4[6] = (SumW'(xz4_q) + SumW'(wy4_q)) <<< 1;
  assign r4[7] = (SumW'(yz4_q) - SumW'(wx4_q)) <<< 1;
  assign r4[8] = SumW'(ww4_q) - SumW'(xx4_q) - SumW'(yy4_q) + SumW'(zz4_q);
  always_ff @(posedge clk_i) if (load[5]) begin
    for (int unsigned i = 0; i < 3; i += 1) n5_q[i] <= NW'(n4[i] >>> F);
    for (int unsigned i = 0; i < 9; i += 1) r5_q[i] <= {r4[i][F+1 +: EntryW-1], 1'b1};
  end

  // --- stages 6 and 7: |n . R_k| -----------------------------------------------------------------------------------
  localparam int unsigned PpW   = NW + EntryW;
  localparam int unsigned Error = 13 + (9992 >> (QuatW - 1));
  logic signed [PpW-1:0] p6_q [9];
  logic signed [PpW:0]   p6 [3];
  logic signed [NW-1:0]  near6 [3];
  logic        [NW-2:0]  p7_q [3];
  for (genvar k = 0; k < 3; k += 1) begin : gen_p
    assign p6[k] = (PpW + 1)'(p6_q[3*k]) + (PpW + 1)'(p6_q[3*k+1]) + (PpW + 1)'(p6_q[3*k+2]) +
                   $signed((PpW + 1)'(1 << (F - 1)));
    assign near6[k] = NW'(p6[k] >>> F);
  end
  always_ff @(posedge clk_i) begin
    for (int unsigned k = 0; k < 3; k += 1) begin
      for (int unsigned i = 0; i < 3; i += 1) if (load[6]) p6_q[3*k+i] <= PpW'(n5_q[i]) * PpW'(r5_q[3*k+i]);
      if (load[7]) p7_q[k] <= (NW-1)'(near6[k] < 0 ? NW'(0) - near6[k] : near6[k]) + (NW-1)'(Error);
    end
  end

  // --- stages 8 to 10: times the scales, squares, their sum; beside them (r f w)^2 and the square of the gap --------
  localparam int unsigned ReachSumW = 17;
  localparam int unsigned WeightW   = 13;
  localparam int unsigned SpreadMW  = 9;
  localparam int unsigned SpanW     = 14;
  logic [NW-2:0]        q8_q [3];
  logic [2*NW-3:0]      q9_q [3];
  logic [2*NW-1:0]      sum9;
  logic [ReachSumW-1:0] sum10_q;
  logic [WeightW-1:0]   weight9_q;
  logic [SpreadMW-1:0]  spread9_q;
  logic [WeightW+SpreadMW-1:0] weighted9;
  logic [SpanW-1:0]     span10_q;
  logic [23:0]          far10_q;
  logic [NW+5:0]        q7 [3];
  for (genvar k = 0; k < 3; k += 1) begin : gen_q
    assign q7[k] = (NW + 6)'(p7_q[k]) * (NW + 6)'(scales7.of[k]) + (NW + 6)'(63);
  end
  assign sum9      = (2 * NW)'(q9_q[0]) + (2 * NW)'(q9_q[1]) + (2 * NW)'(q9_q[2]) + (2 * NW)'(127);
  assign weighted9 = (WeightW + SpreadMW)'(weight9_q) * (WeightW + SpreadMW)'(spread9_q) +
                     (WeightW + SpreadMW)'(255);
  always_ff @(posedge clk_i) begin
    for (int unsigned k = 0; k < 3; k += 1) begin
      if (load[8]) q8_q[k] <= q7[k][6 +: NW - 1];
      if (load[9]) q9_q[k] <= (2 * NW - 2)'(q8_q[k]) * (2 * NW - 2)'(q8_q[k]);
    end
    if (load[9]) begin
      weight9_q <= pipegs_pkg::ReachWeights[WeightW*32'(opacity_q[8]) +: WeightW];
      spread9_q <= {1'b1, along_x_q[8] ? lens_i.spread_x[7:0] : lens_i.spread_y[7:0]};
    end
    if (load[10]) begin
      sum10_q  <= sum9[2*NW-1:7];
      span10_q <= weighted9[WeightW+SpreadMW-1:8];
      far10_q  <= 24'(far_q[9]) * 24'(far_q[9]);
    end
  end

  // --- stages 11 and 12: what is compared --------------------------------------------------------------------------
  localparam int unsigned ReachW = SpanW + ReachSumW;
  logic [ReachW-1:0] reach11_q;
  logic [54:0]       far11_q;
  always_ff @(posedge clk_i) if (load[11]) begin
    reach11_q <= ReachW'(span10_q) * ReachW'(sum10_q);
    far11_q   <= {far10_q, 31'd0} >> down_q[10];
  end
  assign keep = !test_q[Stages] || far11_q < 55'(reach11_q);

  wire unused_bits = &{1'b0, lens_i, bit_ready, bit_count, normal, bound2_q[F-1:0], gap.z[MagW], gap_z[5:0],
                       raised_z, raised_side, weighted9, sum9, n4[0], n4[1], n4[2]};

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!valid_q[Stages] || bit_ready)
    else $error("pu_reach: a bit without room");
  pipegs_stream_check #(.DataW($bits(visible_o))) u_check_visible (
    .clk_i,
    .rst_ni,
    .valid_i(visible_valid_o),
    .ready_i(visible_ready_i),
    .beat_i(visible_o)
  );
`endif

endmodule
