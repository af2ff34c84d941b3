// SPDX-License-Identifier: Apache-2.0
// pu_project: the mean on the screen, 1/z, the clamped tangents of the Jacobian, the depth key and the view direction.
//
// Paper   Sec. 2.1, EWA projection of the mean; depth of the sort key.
// Idea    One normaliser takes z, x, y in turn, then the bits that any of them has; one reciprocal; one multiplier:
//           cycle      0  1      2  3  4   5     6     7     8      9      10        11
//           normalise  z  x      y  any
//           recip         1/z --------->
//           dir                            x     y     z
//           multiply                             x/z   y/z   fx tx  fy ty
//           round                                      x/z   y/z    tan x, y: 8, 9;  mean x, y: shift 9, 10; add 10, 11
//         Cycles 8 to 11 are the first ones of the next record, but for stalls.
// Stream  visible in, projected out, in order; an end beat passes with all other fields zero. Beside a Gaussian's
//         record two others leave, each for one cycle as soon as it is known: its payload in phase 7, its centre in
//         cycle 12.
// Pace    One record in eight cycles, latency 13.
// Model   cpp_model/pu/project/pu_project.hpp

module pu_project (
  input  logic                    clk_i,
  input  logic                    rst_ni,

  input  pipegs_pkg::lens_t       lens_i,

  input  logic                    visible_valid_i,
  output logic                    visible_ready_o,
  input  pipegs_pkg::visible_t    visible_i,

  output logic                    projected_valid_o,
  input  logic                    projected_ready_i,
  output pipegs_pkg::projected_t  projected_o,

  output logic                    center_valid_o,   // of each Gaussian, before its record can be taken; not refused
  output pipegs_pkg::center_t     center_o,
  output logic                    payload_valid_o,  // the same
  output pipegs_pkg::payload_t    payload_o,

  output logic                    busy_o
);

  localparam int unsigned ViewW      = pipegs_pkg::ViewW;
  localparam int unsigned ExpW       = pipegs_pkg::ExpW;
  localparam int unsigned TanF       = pipegs_pkg::TanF;
  localparam int unsigned TanW       = pipegs_pkg::TanW;
  localparam int unsigned MeanF      = pipegs_pkg::MeanF;
  localparam int unsigned MeanW      = pipegs_pkg::MeanW;
  localparam int unsigned DepthW     = pipegs_pkg::DepthW;
  localparam int unsigned FocalW     = pipegs_pkg::FocalW;
  localparam int unsigned FocalF     = pipegs_pkg::FocalF;
  localparam int unsigned CenterW    = pipegs_pkg::CenterW;
  localparam int unsigned CenterF    = pipegs_pkg::CenterF;
  localparam int unsigned WindowW    = pipegs_pkg::WindowW;
  localparam int unsigned FloatEW    = pipegs_pkg::FloatEW;
  localparam int unsigned MantissaW  = pipegs_pkg::MantissaW;
  localparam int unsigned DirectionW = pipegs_pkg::DirectionW;
  localparam int unsigned ShiftW     = $clog2(ViewW);
  localparam int unsigned DownW      = ShiftW + 1;                    // shift of a ratio: of x and of z
  localparam int unsigned FactorW    = MantissaW > FocalW ? MantissaW + 1 : FocalW + 1;
  localparam int unsigned ProductW   = ViewW + FactorW;
  localparam int unsigned KeyW       = DepthW - ExpW;

  logic        take, claim, step, held;
  logic [7:0]  phase;  // whose operands are chosen now
  logic [15:0] slots;
  logic        level1_valid, level2_valid, level3_valid, level4_valid;
  logic [2:0]  level1, level2, level3, level4;  // the phases one to four cycles ago
  assign {level4_valid, level4, level3_valid, level3, level2_valid, level2, level1_valid, level1} = slots;

  pu_phases #(.Depth(pipegs_pkg::ProjectDepth), .Claim(pipegs_pkg::ProjectClaim)) u_phases (
    .clk_i,
    .rst_ni,
    .in_valid_i(visible_valid_i),
    .in_ready_o(visible_ready_o),
    .out_valid_o(projected_valid_o),
    .out_ready_i(projected_ready_i),
    .take_o(take),
    .claim_o(claim),
    .step_o(step),
    .held_o(held),
    .phase_o(phase),
    .slots_o(slots),
    .busy_o
  );

  pipegs_pkg::visible_t   in_q;
  pipegs_pkg::projected_t out_q;
  pipegs_pkg::center_t    center_q;
  assign projected_o = out_q;

  // Cycles 8 to 12 of the record in the output register.
  logic cycle8, cycle9, cycle10, cycle11;  // 8 and 9 choose the multiplier's operands: registers
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) {cycle8, cycle9} <= '0;
    else if (step) {cycle8, cycle9} <= {held && phase[7], cycle8};
  end
  logic cycle12;  // the record becomes valid, its centre is complete
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) cycle12 <= 1'b0;
    else cycle12 <= step && cycle11 && out_q.kind == pipegs_pkg::KindData;
  end
  assign cycle10 = level3_valid && level3 == 3'd7;
  assign cycle11 = level4_valid && level4 == 3'd7;


  // --- normalise: cycles 0 to 3 ------------------------------------------------------------------------------------
  logic signed [ViewW-1:0]  number, normal, normal_q, any;
  logic        [ShiftW-1:0] shift, shift_q;
  assign any = (in_q.view_x ^ (in_q.view_x >>> (ViewW - 1))) | (in_q.view_y ^ (in_q.view_y >>> (ViewW - 1))) |
               (in_q.view_z ^ (in_q.view_z >>> (ViewW - 1)));
  assign number = phase[0] ? in_q.view_z : phase[1] ? in_q.view_x : phase[2] ? in_q.view_y : any;
  pipegs_normalize #(.DataW(ViewW)) u_normalize (
    .in_i(number),
    .out_o(normal),
    .shift_o(shift)
  );

  // --- z: cycle 1 --------------------------------------------------------------------------------------------------
  // Its mantissa in MantissaW bits, rounded to nearest and saturated; its leading one is bit ViewW - 2.
  logic [MantissaW-1:0] z_m;
  if (ViewW - 1 > MantissaW) begin : gen_narrow
    logic [MantissaW:0] rounded;
    assign rounded = {1'b0, normal_q[ViewW-2:ViewW-1-MantissaW]} + (MantissaW + 1)'(normal_q[ViewW-2-MantissaW]);
    assign z_m     = rounded[MantissaW] ? '1 : rounded[MantissaW-1:0];
  end else begin : gen_wide
    assign z_m = {normal_q[ViewW-2:0], {(MantissaW - ViewW + 1){1'b0}}};
  end

  logic                 inv_valid;
  logic [MantissaW-1:0] inv, inv_q;
  pipegs_recip u_recip (
    .clk_i,
    .rst_ni,
    .in_valid_i(step && level1_valid && level1 == 3'd0),
    .in_i(z_m),
    .out_valid_o(inv_valid),
    .out_o(inv)
  );

  logic [ExpW:0]         z_log;              // floor(log2 z) in world units
  logic [ShiftW-1:0]     z_place_q;          // the same in view units
  logic [DepthW-1:0]     depth_q;
  logic [ViewW+KeyW-3:0] below;              // what follows the leading one, and zeros
  assign z_log = (ExpW + 1)'(in_q.view_exp) + (ExpW + 1)'(ViewW - 2) - (ExpW + 1)'(shift_q);
  assign below = {normal_q[ViewW-3:0], {KeyW{1'b0}}};

  // --- one multiplier: x/z, y/z, then focal times these; a ratio is m 2^-down --------------------------------------
  logic signed [ViewW-1:0]    x_q, y_q, x_ratio_q, y_ratio_q, left;
  logic        [ShiftW-1:0]   x_shift_q, y_shift_q;
  logic        [DownW-1:0]    x_down_q, y_down_q;
  logic signed [FactorW-1:0]  right;
  logic signed [ProductW-1:0] product_q;
  logic signed [ViewW:0]      ratio;
  always_comb begin
    left  = phase[6] ? x_q : y_q;
    right = $signed(FactorW'(inv_q));
    if (cycle8) begin
      left  = x_ratio_q;
      right = $signed(FactorW'(lens_i.focal_x));
    end
    if (cycle9) begin
      left  = y_ratio_q;
      right = $signed(FactorW'(lens_i.focal_y));
    end
  end
  assign ratio = (product_q[MantissaW-1+:ViewW+1] + (ViewW + 1)'(1)) >>> 1;  // rounded to nearest

  // --- tangents: cycles 8 and 9 ------------------------------------------------------------------------------------
  localparam int unsigned WideW = ViewW + TanF + 1;  // a ratio with TanF and one more fraction bits
  logic signed [WideW-1:0] tan_down, tan_rounded;
  logic signed [TanW-1:0]  tan;
  assign tan_down    = $signed({cycle8 ? x_ratio_q : y_ratio_q, {(TanF + 1){1'b0}}}) >>> (cycle8 ? x_down_q : y_down_q);
  assign tan_rounded = (tan_down + WideW'(1)) >>> 1;
  if (pipegs_pkg::GuardBand != 0) begin : gen_guard
    logic signed [WideW-1:0] bound;
    logic        [TanW-1:0]  limit;
    assign limit = cycle8 ? lens_i.limit_x : lens_i.limit_y;
    assign bound = $signed(WideW'(limit));
    assign tan   = tan_rounded > bound ? TanW'(bound) : tan_rounded < -bound ? TanW'(-bound) : TanW'(tan_rounded);
  end else begin : gen_format
    pipegs_saturate #(.InW(WideW), .OutW(TanW)) u_tan (
      .in_i(tan_rounded),
      .out_o(tan)
    );
  end

  // --- means: shifted in cycles 9 and 10, rounded, moved to the window and saturated in 10 and 11 ------------------
  localparam int unsigned PixelW = ProductW + 1;
  logic        [DownW:0]      pixel_down;
  logic signed [PixelW-1:0]   pixel_q, mean_wide;
  logic signed [MeanW-1:0]    center, offset_q, mean;
  logic        [WindowW-1:0]  window_x_q, window_y_q, window;
  logic        [DownW-1:0]    down;
  logic signed [CenterW-1:0]  principal;
  assign down       = cycle9 ? x_down_q : y_down_q;
  assign window     = cycle9 ? window_x_q : window_y_q;
  assign principal  = cycle9 ? lens_i.center_x : lens_i.center_y;
  assign pixel_down = (DownW + 1)'(down) + (DownW + 1)'(FocalF - MeanF);
  if (MeanF >= CenterF) begin : gen_fine
    assign center = MeanW'(principal) <<< (MeanF - CenterF);
  end else begin : gen_coarse
    localparam int unsigned FineW = MeanW > CenterW + 1 ? MeanW : CenterW + 1;
    logic signed [FineW-1:0] fine;
    assign fine   = FineW'(principal) >>> (CenterF - MeanF - 1);
    assign center = MeanW'((fine + FineW'(1)) >>> 1);
  end
  assign mean_wide = ((pixel_q + PixelW'(1)) >>> 1) + PixelW'(offset_q);
  pipegs_saturate #(.InW(PixelW), .OutW(MeanW)) u_mean (
    .in_i(mean_wide),
    .out_o(mean)
  );

  // --- direction: cycles 5 to 7, the shift that leaves the largest component normalised ----------------------------
  logic signed [ViewW-1:0] component;
  logic signed [DirectionW-1:0] direction, dir_x_q, dir_y_q;
  assign direction = component[ViewW-1:ViewW-DirectionW];
  assign component = (phase[5] ? in_q.view_x : phase[6] ? in_q.view_y : in_q.view_z) <<< shift_q;

  always_ff @(posedge clk_i) begin
    if (take) in_q <= visible_i;
    if (inv_valid) inv_q <= inv;
    if (step) begin
      if (phase[3:0] != '0) begin
        normal_q <= normal;
        shift_q  <= shift;
      end
      if (level1 == 3'd0) begin
        z_place_q <= ShiftW'(ViewW - 2) - shift_q;
        depth_q   <= {z_log[ExpW] ? {ExpW{1'b1}} : z_log[ExpW-1:0], below[ViewW+KeyW-3-:KeyW]};
      end
      if (level1 == 3'd1) begin
        x_q       <= normal_q;
        x_shift_q <= shift_q;
      end
      if (level1 == 3'd2) begin
        y_q       <= normal_q;
        y_shift_q <= shift_q;
      end
      product_q <= ProductW'(left) * ProductW'(right);
      if (level1 == 3'd6) x_ratio_q <= ratio[ViewW-1:0];
      if (level1 == 3'd7) y_ratio_q <= ratio[ViewW-1:0];
      pixel_q  <= $signed({product_q, 1'b0}) >>> pixel_down;
      offset_q <= center - $signed(MeanW'(window) << (MeanF + $clog2(pipegs_pkg::Window)));
    end
    if (claim) begin
      x_down_q   <= DownW'(x_shift_q) + DownW'(z_place_q);
      y_down_q   <= DownW'(y_shift_q) + DownW'(z_place_q);
      window_x_q <= in_q.window_x;
      window_y_q <= in_q.window_y;
      out_q      <= '0;
      out_q.kind <= in_q.kind;
      if (in_q.kind == pipegs_pkg::KindData) begin
        out_q.inv_z_e <= -$signed(FloatEW'(MantissaW) + FloatEW'(z_place_q) + FloatEW'(in_q.view_exp));
        out_q.qw      <= in_q.qw;
        out_q.qx      <= in_q.qx;
        out_q.qy      <= in_q.qy;
        out_q.qz      <= in_q.qz;
        out_q.scale_0 <= in_q.scale_0;
        out_q.scale_1 <= in_q.scale_1;
        out_q.scale_2 <= in_q.scale_2;
      end
    end
    if (step && out_q.kind == pipegs_pkg::KindData) begin
      if (held && phase[7]) out_q.inv_z_m <= inv_q;
      if (cycle8) out_q.tan_x <= tan;
      if (cycle9) out_q.tan_y <= tan;
    end
    if (cycle10) center_q.mean_x <= mean;
    if (cycle11) center_q.mean_y <= mean;
    if (claim) center_q.opacity <= in_q.opacity;
    if (phase[5]) dir_x_q <= direction;
    if (phase[6]) dir_y_q <= direction;
  end

  // --- what rides beside the stages that follow ----------------------------------------------------------------------
  assign center_valid_o  = cycle12;
  assign center_o        = center_q;
  assign payload_valid_o = held && phase[7] && in_q.kind == pipegs_pkg::KindData;
  pipegs_pkg::payload_t payload;  // but for its walk
  always_comb begin
    payload        = '0;
    payload.depth  = depth_q;
    payload.dir_x  = dir_x_q;
    payload.dir_y  = dir_y_q;
    payload.dir_z  = direction;
    payload.base_r = in_q.base_r;
    payload.base_g = in_q.base_g;
    payload.base_b = in_q.base_b;
    payload.index  = in_q.index;
    payload.slot   = in_q.slot;
  end
  pipegs_pkg::payload_t walked;  // but for its eye
  if (pipegs_pkg::HasWalks) begin : gen_walk
    always_comb begin
      walked      = payload;
      walked.walk = in_q.walk;
    end
  end else begin : gen_whole
    assign walked = payload;
  end
  if (pipegs_pkg::Eyes > 1) begin : gen_eyes
    always_comb begin
      payload_o     = walked;
      payload_o.eye = in_q.eye;
    end
  end else begin : gen_one_eye
    assign payload_o = walked;
  end

  // Bits that a narrowing cuts, and what of the lens does not matter here.
  wire unused_bits = &{1'b0, phase, lens_i, product_q, ratio[ViewW], below, component, level2_valid, level2};

endmodule
