// SPDX-License-Identifier: Apache-2.0
// pu_four_project: pu_project in four cycles: mean, 1/z, tangents, depth key and direction.
//
// Paper   Sec. 2.1, EWA projection of the mean; depth of the sort key.
// Idea    Normaliser and multiplier are used four times for a Gaussian. Only the direction's shift is there twice:
//           cycle      0  1      2     3     4  5     6     7     8      9      10        11
//           normalise  z  any    x     y
//           recip         1/z ------------->
//           dir                  x, y  z
//           multiply                                  x/z   y/z   fx tx  fy ty
//           round                                           x/z   y/z   tan x, y: 8, 9;  mean: shift 9, 10; add 10, 11
// Stream  visible in, projected out, in order; an end beat passes with all other fields zero. Beside a Gaussian's
//         record two others leave, each for one cycle as soon as it is known: its payload in phase 3, its centre in
//         cycle 12.
// Pace    One record in four cycles, latency 11.
// Model   cpp_model/pu/project/pu_project.hpp

module pu_four_project (
  input  logic                    clk_i,
  input  logic                    rst_ni,

  input  pipegs_pkg::lens_t       lens_i,

  input  logic                    visible_valid_i,
  output logic                    visible_ready_o,
  input  pipegs_pkg::visible_t    visible_i,

  output logic                    projected_valid_o,
  input  logic                    projected_ready_i,
  output pipegs_pkg::projected_t  projected_o,

  output logic                    center_valid_o,   // of each Gaussian, two cycles behind its record; not refused
  output pipegs_pkg::center_t     center_o,
  output logic                    payload_valid_o,  // before its record; not refused
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

  localparam int unsigned Depth = pipegs_pkg::ProjectDepth;
  logic                  take, claim, step, held, record_busy;
  logic [3:0]            phase;  // whose operands are chosen now
  logic [4*Depth-1:0]    slots;
  logic [3:0]            first;  // the phase one cycle ago
  for (genvar i = 0; i < 4; i += 1) begin : gen_first
    assign first[i] = slots[0+:4] == 4'(8 + i);
  end

  pu_phases #(
    .Phases(4),
    .Depth(Depth),
    .Claim(pipegs_pkg::ProjectClaim)
  ) u_phases (
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
    .busy_o(record_busy)
  );

  // What is kept of a record behind its phases.
  typedef struct packed {
    logic [pipegs_pkg::KindW-1:0]      kind;
    logic signed [FloatEW-1:0]         inv_z_e;
    logic [4*pipegs_pkg::QuatW-1:0]    quaternion;
    logic [3*pipegs_pkg::ScaleW-1:0]   scales;
    logic [WindowW-1:0]                window_x;
    logic [WindowW-1:0]                window_y;
    logic [pipegs_pkg::OpacityW-1:0]   opacity;
  } behind_t;
  pipegs_pkg::visible_t   in_q;
  behind_t                behind_q;
  pipegs_pkg::projected_t out_q;
  pipegs_pkg::center_t    center_q;
  assign projected_o = out_q;

  // Cycles 6 to 9 of a record, each a register: they choose the multiplier's operands; then 10 and 11, and in 12 its
  // centre is complete.
  logic [3:0] turn_q;
  logic       divided_q, cycle8_q, cycle10_q, cycle11_q, cycle12_q, center_data_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      {turn_q, divided_q, cycle8_q, cycle10_q, cycle11_q, cycle12_q} <= '0;
    end else begin
      if (step) begin
        for (int unsigned i = 0; i < 4; i += 1) turn_q[i] <= slots[16+:4] == 4'(8 + i);
        divided_q <= turn_q[0];
        cycle8_q  <= turn_q[1];
        cycle10_q <= turn_q[3];
        cycle11_q <= cycle10_q;
      end
      cycle12_q <= step && cycle11_q && center_data_q;
    end
  end
  assign busy_o = record_busy || cycle10_q || cycle11_q || cycle12_q;

  // --- normalise: cycles 0 to 3 ------------------------------------------------------------------------------------
  logic signed [ViewW-1:0]  number, normal, normal_q, any;
  logic        [ShiftW-1:0] shift, shift_q;
  assign any = (in_q.view_x ^ (in_q.view_x >>> (ViewW - 1))) | (in_q.view_y ^ (in_q.view_y >>> (ViewW - 1))) |
               (in_q.view_z ^ (in_q.view_z >>> (ViewW - 1)));
  assign number = phase[0] ? in_q.view_z : phase[1] ? any : phase[2] ? in_q.view_x : in_q.view_y;
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
  logic [MantissaW-1:0] inv, inv_q, use_q;  // the next record's may come while this one stands still
  pipegs_recip u_recip (
    .clk_i,
    .rst_ni,
    .in_valid_i(step && first[0]),
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
    left  = turn_q[0] ? x_q : y_q;
    right = $signed(FactorW'(use_q));
    if (turn_q[2]) begin
      left  = x_ratio_q;
      right = $signed(FactorW'(lens_i.focal_x));
    end
    if (turn_q[3]) begin
      left  = y_ratio_q;
      right = $signed(FactorW'(lens_i.focal_y));
    end
  end
  assign ratio = (product_q[MantissaW-1+:ViewW+1] + (ViewW + 1)'(1)) >>> 1;  // rounded to nearest

  // --- tangents: cycles 8 and 9 ------------------------------------------------------------------------------------
  localparam int unsigned WideW = ViewW + TanF + 1;  // a ratio with TanF and one more fraction bits
  logic signed [WideW-1:0] tan_down, tan_rounded;
  logic signed [TanW-1:0]  tan;
  assign tan_down    = $signed({turn_q[2] ? x_ratio_q : y_ratio_q, {(TanF + 1){1'b0}}}) >>>
                       (turn_q[2] ? x_down_q : y_down_q);
  assign tan_rounded = (tan_down + WideW'(1)) >>> 1;
  if (pipegs_pkg::GuardBand != 0) begin : gen_guard
    logic signed [WideW-1:0] bound;
    logic        [TanW-1:0]  limit;
    assign limit = turn_q[2] ? lens_i.limit_x : lens_i.limit_y;
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
  logic        [DownW:0]      pixel_down_q;
  logic        [DownW-1:0]    down;  // of the one that is shifted next
  logic signed [PixelW-1:0]   pixel_q, mean_wide;
  logic signed [MeanW-1:0]    center, offset_q, mean;
  logic        [WindowW-1:0]  window_x_q, window_y_q, window;
  logic signed [CenterW-1:0]  principal;
  assign down      = turn_q[3] ? y_down_q : x_down_q;
  assign window    = turn_q[3] ? window_x_q : window_y_q;
  assign principal = turn_q[3] ? lens_i.center_x : lens_i.center_y;
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

  // --- direction: x and y in cycle 2, z in 3; the shift that leaves the largest component normalised ----------------
  logic        [ShiftW-1:0]     any_shift_q;
  logic signed [ViewW-1:0]      component, component_y;
  logic signed [DirectionW-1:0] direction, dir_x_q, dir_y_q;
  assign component   = phase[2] ? in_q.view_x <<< shift_q : in_q.view_z <<< any_shift_q;
  assign component_y = in_q.view_y <<< shift_q;
  assign direction   = component[ViewW-1:ViewW-DirectionW];

  logic [pipegs_pkg::OpacityW-1:0] opacity_q;
  always_ff @(posedge clk_i) begin
    if (take) in_q <= visible_i;
    if (inv_valid) inv_q <= inv;
    if (step) begin
      normal_q <= normal;
      shift_q  <= shift;
      if (first[0]) begin
        z_place_q <= ShiftW'(ViewW - 2) - shift_q;
        depth_q   <= {z_log[ExpW] ? {ExpW{1'b1}} : z_log[ExpW-1:0], below[ViewW+KeyW-3-:KeyW]};
      end
      if (phase[2]) begin
        any_shift_q <= shift_q;
        dir_x_q     <= direction;
        dir_y_q     <= component_y[ViewW-1:ViewW-DirectionW];
      end
      if (phase[3]) begin
        behind_q.kind       <= in_q.kind;
        behind_q.inv_z_e    <= -$signed(FloatEW'(MantissaW) + FloatEW'(z_place_q) + FloatEW'(in_q.view_exp));
        behind_q.quaternion <= {in_q.qw, in_q.qx, in_q.qy, in_q.qz};
        behind_q.scales     <= {in_q.scale_0, in_q.scale_1, in_q.scale_2};
        behind_q.window_x   <= in_q.window_x;
        behind_q.window_y   <= in_q.window_y;
        behind_q.opacity    <= in_q.opacity;
      end
      if (first[2]) {x_q, x_shift_q} <= {normal_q, shift_q};
      if (first[3]) {y_q, y_shift_q} <= {normal_q, shift_q};
      if (slots[16+:4] == 4'd8) begin  // cycle 5
        use_q    <= inv_valid ? inv : inv_q;
        x_down_q <= DownW'(x_shift_q) + DownW'(z_place_q);
        y_down_q <= DownW'(y_shift_q) + DownW'(z_place_q);
      end
      product_q <= ProductW'(left) * ProductW'(right);
      if (divided_q) x_ratio_q <= ratio[ViewW-1:0];
      if (cycle8_q) y_ratio_q <= ratio[ViewW-1:0];
      pixel_down_q <= (DownW + 1)'(down) + (DownW + 1)'(FocalF - MeanF);
      pixel_q  <= $signed({product_q, 1'b0}) >>> pixel_down_q;
      offset_q <= center - $signed(MeanW'(window) << (MeanF + $clog2(pipegs_pkg::Window)));
    end
    if (claim) begin
      window_x_q <= behind_q.window_x;
      window_y_q <= behind_q.window_y;
      opacity_q  <= behind_q.opacity;
      out_q      <= '0;
      out_q.kind <= behind_q.kind;
      if (behind_q.kind == pipegs_pkg::KindData) begin
        out_q.inv_z_m <= use_q;
        out_q.inv_z_e <= behind_q.inv_z_e;
        {out_q.qw, out_q.qx, out_q.qy, out_q.qz}          <= behind_q.quaternion;
        {out_q.scale_0, out_q.scale_1, out_q.scale_2} <= behind_q.scales;
      end
    end
    if (step && out_q.kind == pipegs_pkg::KindData) begin
      if (turn_q[2]) out_q.tan_x <= tan;
      if (turn_q[3]) out_q.tan_y <= tan;
    end
    if (step && cycle10_q) begin
      center_data_q    <= out_q.kind == pipegs_pkg::KindData;
      center_q.mean_x  <= mean;
      center_q.opacity <= opacity_q;
    end
    if (step && cycle11_q) center_q.mean_y <= mean;
  end

  // --- what rides beside the stages that follow ----------------------------------------------------------------------
  assign center_valid_o  = cycle12_q;
  assign center_o        = center_q;
  assign payload_valid_o = step && held && phase[3] && in_q.kind == pipegs_pkg::KindData;
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
  wire unused_bits = &{1'b0, phase, first, slots, lens_i, product_q, ratio[ViewW], below, component, component_y};

endmodule
