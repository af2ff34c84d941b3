// SPDX-License-Identifier: Apache-2.0
// pu_intersect: which 8x8 regions of a part hold a pixel with alpha >= 1/AlphaCut.
//
// Paper   the tile test and the 4-bit bitmap of each tile (Sec. 4.2), for all sixteen tiles of 64x64 pixels at once.
// Idea    The box mean +- extent gives columns and rows of regions, walked row by row, Tests regions side by side.
//         P = power - cut goes from region to region by additions (pu_step). Keep a region if it holds the mean, if
//         P >= 0 at a corner, or if along an edge that faces the mean P rises, then falls, and its peak
//         P + g^2 / (4 |E|) >= 0:   g^2 >= 4 |E| (-P)   (pu_edge).
//         TileTest 0: every region of the box, at the same pace; 2: those that the oriented box touches (pu_touch).
//         Three records are inside at once: one is set up, one walks, the regions of one are being tested.
// Stream  coeff in, tiles out, in order; a Gaussian without a region is not emitted. An end beat passes through. For
//         the payloads (pu_regions): drop_o, one has no box and is gone, whatever walks before it; walk_o, one begins
//         its walk; leave_o, the oldest of those that walk leaves, its mask may be empty.
// Pace    The regions in the box, of each row Tests in a cycle, but at least 3 cycles; 2 for a Gaussian without a box;
//         an end beat waits for those before it.
//         box | start | place | walk ... | ends of edges | products | compare, out
// Model   cpp_model/pu/conic/pu_intersect.hpp

module pu_intersect (
  input  logic                clk_i,
  input  logic                rst_ni,

  input  logic                coeff_valid_i,
  output logic                coeff_ready_o,
  input  pipegs_pkg::coeff_t  coeff_i,

  output logic                tiles_valid_o,
  input  logic                tiles_ready_i,
  output pipegs_pkg::tiles_t  tiles_o,

  output logic                drop_o,
  output logic                walk_o,
  output logic                leave_o,  // tiles_o shows it from the next cycle on

  output logic                busy_o  // a record is inside
);

  localparam int unsigned Regions  = pipegs_pkg::MaskW;
  localparam int unsigned RegionW  = pipegs_pkg::MaskIndexW;
  localparam int unsigned AxisW    = RegionW / 2;         // column or row of a region
  localparam int unsigned FactorW  = AxisW + 1;           // the same with a sign
  localparam int unsigned EightW   = 3;                   // log2 of a region's side
  localparam int unsigned PixelW   = AxisW + EightW;
  localparam int unsigned MeanW    = pipegs_pkg::MeanW;
  localparam int unsigned MeanF    = pipegs_pkg::MeanF;
  localparam int unsigned ExtentW  = pipegs_pkg::ExtentW;
  localparam int unsigned ExtentF  = 4;
  localparam int unsigned CoeffF   = pipegs_pkg::CoeffF;
  localparam int unsigned PowerF   = pipegs_pkg::PowerF;
  localparam int unsigned DefW     = pipegs_pkg::DefW;
  localparam int unsigned GradW    = pipegs_pkg::BcW + 1;  // gradients in the window, s13.CoeffF
  localparam int unsigned PowerW   = pipegs_pkg::AW + 4;   // P in the window, s20.CoeffF
  localparam int unsigned CurveW   = DefW + FactorW;       // a curvature times a column or row

  localparam logic signed [PowerW-1:0] MinusCut =
    PowerW'((64'(pipegs_pkg::PowerCut) << (CoeffF - PowerF)) + 64'(pipegs_pkg::CutSlack));

  typedef enum logic [1:0] {
    StateBox,    // waits for a record; makes its box
    StateStart,  // gradients at the first region
    StatePlace   // P there; waits until the walk takes the record
  } state_e;

  state_e              state_q;
  logic                tiles_valid_q, walk_valid_q, drain_valid_q, none_q;
  logic                is_end, take_end, drop, load, step, test_last, hold, out_free, leave;
  pipegs_pkg::coeff_t  walk_q;   // the record whose regions are walked
  pipegs_pkg::tiles_t  walked, drain_q, tiles_q;  // drain: its last region is being tested
  logic [Regions-1:0]  mask, mask_q;

  // --- the box of pixels, as columns and rows of regions -----------------------------------------------------------
  localparam int unsigned HalfW = ExtentW + MeanF - ExtentF + 1;
  localparam int unsigned BoxW  = (HalfW > MeanW ? HalfW : MeanW) + 2;
  localparam logic signed [BoxW-1:0] Side = BoxW'(pipegs_pkg::PartSide);
  logic signed [BoxW-1:0] half_x, half_y, x_low, x_high, y_low, y_high;
  logic [PixelW-1:0]      x_first, x_last, y_first, y_last;
  logic                   none;
  logic [AxisW-1:0]       box_left_q, box_right_q, box_top_q, box_bottom_q;

  assign half_x  = BoxW'(coeff_i.extent_x) << (MeanF - ExtentF);
  assign half_y  = BoxW'(coeff_i.extent_y) << (MeanF - ExtentF);
  assign x_low   = (BoxW'(coeff_i.mean_x) - half_x + $signed(BoxW'((1 << MeanF) - 1))) >>> MeanF;
  assign y_low   = (BoxW'(coeff_i.mean_y) - half_y + $signed(BoxW'((1 << MeanF) - 1))) >>> MeanF;
  assign x_high  = (BoxW'(coeff_i.mean_x) + half_x) >>> MeanF;
  assign y_high  = (BoxW'(coeff_i.mean_y) + half_y) >>> MeanF;
  assign x_first = x_low < 0 ? '0 : PixelW'(x_low);
  assign y_first = y_low < 0 ? '0 : PixelW'(y_low);
  assign x_last  = x_high >= Side ? '1 : PixelW'(x_high);
  assign y_last  = y_high >= Side ? '1 : PixelW'(y_high);
  assign none    = coeff_i.dead || x_low >= Side || y_low >= Side || x_high < 0 || y_high < 0 ||
                   x_first > x_last || y_first > y_last;

  // --- first region: gradients, then P -----------------------------------------------------------------------------
  logic signed [FactorW-1:0] column, row;
  logic signed [pipegs_pkg::AW-1:0]  a_q;                 // the record's, out of the memory that it waits in
  logic signed [pipegs_pkg::BcW-1:0] b_q, c_q;
  logic signed [DefW-1:0]    d_q, e_q, f_q;
  logic signed [CurveW-1:0]  e_row, f_row, f_column, d_column;
  logic signed [GradW-1:0]   b, c, along_x_q, along_y_q, first_gx_q, first_gy_q;  // along: B + F y + D x,  C + E y
  logic signed [PowerW-1:0]  above_q, place, first_power;  // above: A, the cut taken away
  assign column   = {1'b0, box_left_q};
  assign row      = {1'b0, box_top_q};
  assign d_column = CurveW'(d_q) * CurveW'(column);
  assign e_row    = CurveW'(e_q) * CurveW'(row);
  assign f_column = CurveW'(f_q) * CurveW'(column);
  assign f_row    = CurveW'(f_q) * CurveW'(row);
  assign b        = GradW'(b_q);
  assign c        = GradW'(c_q);
  assign place    = PowerW'(along_x_q) * PowerW'(column) + PowerW'(along_y_q) * PowerW'(row);
  assign first_power = above_q + (place <<< EightW);

  always_ff @(posedge clk_i) begin
    if (state_q == StateBox) begin
      box_left_q   <= x_first[PixelW-1:EightW];
      box_right_q  <= x_last[PixelW-1:EightW];
      box_top_q    <= y_first[PixelW-1:EightW];
      box_bottom_q <= y_last[PixelW-1:EightW];
      none_q       <= none;
      {a_q, b_q, c_q, d_q, e_q, f_q} <= {coeff_i.a, coeff_i.b, coeff_i.c, coeff_i.d, coeff_i.e, coeff_i.f};
    end
    if (state_q == StateStart) begin
      above_q    <= PowerW'(a_q) + MinusCut;
      along_x_q  <= b + (GradW'(f_row) <<< EightW) + (GradW'(d_column) <<< EightW);
      along_y_q  <= c + (GradW'(e_row) <<< EightW);
      first_gx_q <= b + (GradW'(f_row) <<< EightW) + (GradW'(d_column) <<< (EightW + 1));
      first_gy_q <= c + (GradW'(f_column) <<< EightW) + (GradW'(e_row) <<< (EightW + 1));
    end
  end

  // --- the walk: Tests columns at a time ---------------------------------------------------------------------------
  localparam int unsigned Tests = pipegs_pkg::Tests;
  logic                   last_column, last_region;
  logic [AxisW-1:0]       column_first_q, column_last_q, row_last_q, column_q, row_q;
  logic [AxisW-1:0]       right;  // columns of the box to the right of this one
  assign right       = column_last_q - column_q;
  assign last_column = {1'b0, right} < (AxisW + 1)'(Tests);
  assign last_region = last_column && row_q == row_last_q;

  always_ff @(posedge clk_i) begin
    if (load) begin
      walk_q         <= coeff_i;
      column_q       <= box_left_q;
      column_first_q <= box_left_q;
      column_last_q  <= box_right_q;
      row_q          <= box_top_q;
      row_last_q     <= box_bottom_q;
    end else if (step) begin
      column_q <= last_column ? column_first_q : column_q + AxisW'(Tests);
      if (last_column) row_q <= row_q + AxisW'(1);
    end
  end

  logic [Tests-1:0]         keep, last;
  logic [Tests*RegionW-1:0] region;
  // With the oriented box: from the middle of the box's first region to the mean, twice.
  localparam int unsigned WayW = MeanW + 2;
  localparam logic signed [WayW-1:0] Middle = WayW'(7) <<< MeanF;
  logic signed [WayW-1:0] way_x_q, way_y_q;
  always_ff @(posedge clk_i) if (state_q == StateStart) begin
    way_x_q <= (WayW'(coeff_i.mean_x) <<< 1) - $signed(WayW'({column, {(EightW + MeanF + 1){1'b0}}})) - Middle;
    way_y_q <= (WayW'(coeff_i.mean_y) <<< 1) - $signed(WayW'({row, {(EightW + MeanF + 1){1'b0}}})) - Middle;
  end

  for (genvar k = 0; k < Tests; k += 1) begin : gen_test
    logic                     touches;
    if (pipegs_pkg::Oriented) begin : gen_oriented
      pu_touch #(.Stride(Tests), .Ahead(k)) u_touch (
        .clk_i,
        .load_i(load),
        .dx_i(way_x_q),
        .dy_i(way_y_q),
        .tilt_i(coeff_i.tilt),
        .side_u_i(coeff_i.side_u),
        .side_v_i(coeff_i.side_v),
        .step_i(step),
        .down_i(last_column),
        .touches_o(touches)
      );
    end else begin : gen_reached
      assign touches = 1'b0;
    end
    logic signed [PowerW-1:0] start, power;
    logic signed [GradW-1:0]  start_gx, start_gy, gx, gy;
    logic                     in_box;
    if (k == 0) begin : gen_first
      assign in_box   = 1'b1;
      assign start    = first_power;
      assign start_gx = first_gx_q;
      assign start_gy = first_gy_q;
    end else begin : gen_right  // a region further; beside the products, not behind them
      logic signed [PowerW-1:0] beside;
      assign beside   = above_q + (PowerW'(first_gx_q) <<< EightW) + (PowerW'(d_q) <<< (2 * EightW));
      assign in_box   = right >= AxisW'(k);
      assign start    = beside + (place <<< EightW);
      assign start_gx = first_gx_q + (GradW'(d_q) <<< (EightW + 1));
      assign start_gy = first_gy_q + (GradW'(f_q) <<< EightW);
    end
    pu_step #(.Stride(Tests)) u_step (
      .clk_i,
      .load_i(load),
      .power_i(start),
      .gx_i(start_gx),
      .gy_i(start_gy),
      .step_i(step),
      .down_i(last_column),
      .d_i(walk_q.d),
      .e_i(walk_q.e),
      .f_i(walk_q.f),
      .power_o(power),
      .gx_o(gx),
      .gy_o(gy)
    );
    pu_edge u_edge (
      .clk_i,
      .rst_ni,
      .hold_i(hold),
      .valid_i(step && in_box),
      .last_i(last_region),
      .column_i(column_q + AxisW'(k)),
      .row_i(row_q),
      .mean_x_i(walk_q.mean_x),
      .mean_y_i(walk_q.mean_y),
      .d_i(walk_q.d),
      .e_i(walk_q.e),
      .f_i(walk_q.f),
      .power_i(power),
      .gx_i(gx),
      .gy_i(gy),
      .touches_i(touches),
      .keep_o(keep[k]),
      .region_o(region[k*RegionW +: RegionW]),
      .last_o(last[k])
    );
  end
  assign test_last = last != '0;

  always_comb begin
    mask = mask_q;
    for (int unsigned k = 0; k < Tests; k += 1) if (keep[k]) mask[region[k*RegionW +: RegionW]] = 1'b1;
  end

  // --- control -----------------------------------------------------------------------------------------------------
  assign is_end   = coeff_i.kind != pipegs_pkg::KindData;
  assign out_free = !tiles_valid_q || tiles_ready_i;
  assign hold     = test_last && !out_free;
  assign leave    = test_last && out_free;
  assign step     = walk_valid_q && !hold && (!last_region || !drain_valid_q || leave);
  assign drop     = state_q == StateStart && none_q;
  assign load     = state_q == StatePlace && (!walk_valid_q || (step && last_region));
  assign take_end = state_q == StateBox && coeff_valid_i && is_end && !walk_valid_q && !drain_valid_q && out_free;

  assign coeff_ready_o  = drop || load || take_end;
  assign drop_o         = drop;
  assign walk_o         = load;
  assign leave_o        = leave;
  assign tiles_valid_o  = tiles_valid_q;
  assign tiles_o        = tiles_q;
  assign busy_o         = state_q != StateBox || walk_valid_q || drain_valid_q || tiles_valid_q;

  always_comb begin
    walked = '0;  // a data beat
    walked.a      = walk_q.a;
    walked.b      = walk_q.b;
    walked.c      = walk_q.c;
    walked.d      = walk_q.d;
    walked.e      = walk_q.e;
    walked.f      = walk_q.f;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q       <= StateBox;
      walk_valid_q  <= 1'b0;
      drain_valid_q <= 1'b0;
      tiles_valid_q <= 1'b0;
      mask_q        <= '0;
    end else begin
      case (state_q)
        StateBox: if (coeff_valid_i && !is_end) state_q <= StateStart;
        StateStart: state_q <= none_q ? StateBox : StatePlace;
        default: if (load) state_q <= StateBox;
      endcase
      if (load) walk_valid_q <= 1'b1;
      else if (step && last_region) walk_valid_q <= 1'b0;
      if (step && last_region) drain_valid_q <= 1'b1;
      else if (leave) drain_valid_q <= 1'b0;
      mask_q <= leave ? '0 : mask;
      if (leave) tiles_valid_q <= mask != '0;
      else if (take_end) tiles_valid_q <= 1'b1;
      else if (tiles_ready_i) tiles_valid_q <= 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (step && last_region) drain_q <= walked;
    if (leave) begin
      tiles_q      <= drain_q;
      tiles_q.mask <= mask;
    end else if (take_end) begin
      tiles_q      <= '0;
      tiles_q.kind <= coeff_i.kind;
    end
  end

  logic unused_walk;
  assign unused_walk = ^walk_q ^ ^way_x_q ^ ^way_y_q;

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits(tiles_o))) u_check_tiles (
    .clk_i,
    .rst_ni,
    .valid_i(tiles_valid_o),
    .ready_i(tiles_ready_i),
    .beat_i(tiles_o)
  );
`endif

endmodule
