// SPDX-License-Identifier: Apache-2.0
// pu_expand: from one Gaussian of the frame to one beat for each window that its box touches.
//
// Paper   the tile intersection of a global preprocessing (GSCore's, as Sec. 5 reproduces it), before the exact test.
// Idea    The box mean +- extent as columns and rows of windows; a Gaussian without any is dropped. Its colour is asked
//         for once, while it waits in a queue; then the windows are walked row by row, the mean moved to the first
//         pixel of each by subtractions and saturated as pu_project does it. A nearly endless extent counts as endless.
//             conic -> box -> color_job        colored -> walk -> placed
//                         +-> queue ----------------------^
//         With the oriented box (TileTest 2) windows that it does not touch are passed over.
// Stream  conic and beside it the Gaussian's payload in; color_job out and colored back, in order; one conic beat per
//         window out, and one cycle before it shows what it stands for in the window's list. Ends of layers vanish, the
//         window's end passes behind all before it.
// Pace    One Gaussian per two cycles into the queue; one window per cycle, and one cycle between Gaussians.
// Model   cpp_model/pu/list/pu_expand.hpp

module pu_expand #(
  parameter int unsigned Depth = pipegs_pkg::ExpandDepth
) (
  input  logic                    clk_i,
  input  logic                    rst_ni,
  input  pipegs_pkg::windows_t    windows_i,

  input  logic                    conic_valid_i,
  output logic                    conic_ready_o,
  input  pipegs_pkg::conic_t      conic_i,
  input  pipegs_pkg::payload_t    payload_i,       // of the Gaussian in conic_i
  output logic                    payload_take_o,

  output logic                    color_job_valid_o,
  input  logic                    color_job_ready_i,
  output pipegs_pkg::color_job_t  color_job_o,

  input  logic                    colored_valid_i,
  output logic                    colored_ready_o,
  input  pipegs_pkg::colored_t    colored_i,

  output logic                    placed_valid_o,
  input  logic                    placed_ready_i,
  output pipegs_pkg::conic_t      placed_o,

  output logic                    listed_valid_o,  // placed_o shows this Gaussian from the next cycle on
  output pipegs_pkg::listed_t     listed_o,

  output logic                    passes_o,  // it passes over a window: it works, though no beat moves
  output logic                    busy_o     // a Gaussian is inside
);

  localparam int unsigned MeanW    = pipegs_pkg::MeanW;
  localparam int unsigned MeanF    = pipegs_pkg::MeanF;
  localparam int unsigned PlacedW  = pipegs_pkg::WindowMeanW;  // of a mean in its window
  localparam int unsigned ExtentW  = pipegs_pkg::ExtentW;
  localparam int unsigned WindowW  = pipegs_pkg::WindowW;
  localparam int unsigned NumberW  = pipegs_pkg::ListWindowW;
  localparam int unsigned SideF    = $clog2(pipegs_pkg::Window);
  localparam int unsigned ShapeW   = 2 * ExtentW + 1 + pipegs_pkg::SlopeW +
                                     2 * (pipegs_pkg::MantissaW + pipegs_pkg::FloatEW) + pipegs_pkg::OpacityW;
  localparam int unsigned OrientedW = pipegs_pkg::TiltW + 2 * pipegs_pkg::SideW;
  localparam int unsigned QueuedW  = ShapeW + 2 * MeanW + 4 * WindowW + OrientedW;
  localparam int unsigned MovedW   = MeanW + 1;                // of a mean that has been moved, exact

  // --- the box, in columns and rows of windows from the frame's first one --------------------------------------------
  typedef enum logic [0:0] {
    BoxFind,  // waits for a conic; finds its box
    BoxGive   // drops it, or waits until the colour and the queue have it
  } box_e;
  box_e               box_q;
  logic [WindowW-1:0] most_x, most_y;  // last column and row
  logic [WindowW-1:0] first_x, last_x, first_y, last_y, first_x_q, last_x_q, first_y_q, last_y_q;
  logic               none_x, none_y, none_q, data, give, room;

  assign most_x = windows_i.last_x - windows_i.first_x;
  assign most_y = windows_i.last_y - windows_i.first_y;
  pu_span #(.SideF(SideF)) u_columns (
    .mean_i(conic_i.mean_x),
    .extent_i(conic_i.extent_x),
    .most_i(most_x),
    .first_o(first_x),
    .last_o(last_x),
    .none_o(none_x)
  );
  pu_span #(.SideF(SideF)) u_rows (
    .mean_i(conic_i.mean_y),
    .extent_i(conic_i.extent_y),
    .most_i(most_y),
    .first_o(first_y),
    .last_o(last_y),
    .none_o(none_y)
  );

  assign data              = conic_i.kind == pipegs_pkg::KindData;
  assign color_job_valid_o = box_q == BoxGive && !none_q && (!data || room);
  assign give              = color_job_valid_o && color_job_ready_i;
  assign conic_ready_o     = box_q == BoxGive && (none_q || give);
  assign payload_take_o    = conic_ready_o && data;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) box_q <= BoxFind;
    else if (box_q == BoxFind) box_q <= conic_valid_i ? BoxGive : BoxFind;
    else if (conic_ready_o) box_q <= BoxFind;
  end
  always_ff @(posedge clk_i) begin
    if (box_q == BoxFind) begin
      {first_x_q, last_x_q, first_y_q, last_y_q} <= {first_x, last_x, first_y, last_y};
      none_q <= data ? none_x || none_y : conic_i.kind == pipegs_pkg::KindLayerEnd;
    end
  end

  always_comb begin
    color_job_o      = '0;
    color_job_o.kind = conic_i.kind;
    if (data) begin
      color_job_o.depth  = payload_i.depth;
      color_job_o.index  = pipegs_pkg::SplatIndexW'(payload_i.index);
      color_job_o.slot   = payload_i.slot;
      color_job_o.dir_x  = payload_i.dir_x;
      color_job_o.dir_y  = payload_i.dir_y;
      color_job_o.dir_z  = payload_i.dir_z;
      color_job_o.base_r = payload_i.base_r;
      color_job_o.base_g = payload_i.base_g;
      color_job_o.base_b = payload_i.base_b;
    end
  end

  // --- the queue: all of a Gaussian but its colour -------------------------------------------------------------------
  logic                       queued_valid, done;
  logic [QueuedW-1:0]         queued;
  logic [$clog2(Depth+1)-1:0] count;
  logic [ShapeW-1:0]          shape;
  logic signed [MeanW-1:0]    mean_x, mean_y;
  logic [WindowW-1:0]         from_x, to_x, from_y, to_y;

  localparam int unsigned PlainW = QueuedW - OrientedW;
  logic [QueuedW-1:0] queueing;
  assign queueing[PlainW-1:0] =
    {conic_i.extent_x, conic_i.extent_y, conic_i.swap, conic_i.slope_m, conic_i.narrow_m, conic_i.narrow_e,
     conic_i.wide_m, conic_i.wide_e, conic_i.opacity,
     conic_i.mean_x, conic_i.mean_y, first_x_q, last_x_q, first_y_q, last_y_q};
  pipegs_sram_fifo #(.DataW(QueuedW), .Depth(Depth)) u_queue (
    .clk_i,
    .rst_ni,
    .in_valid_i(give && data),
    .in_ready_o(room),
    .in_i(queueing),
    .out_valid_o(queued_valid),
    .out_ready_i(done),
    .out_o(queued),
    .count_o(count)
  );
  assign {shape, mean_x, mean_y, from_x, to_x, from_y, to_y} = queued[PlainW-1:0];

  // --- the walk ------------------------------------------------------------------------------------------------------
  logic                     walking_q, start, move, touches, step, last_column, out_free, is_end, pass, out_valid_q;
  logic [WindowW-1:0]       column_q, row_q;
  logic [NumberW-1:0]       number_q, number_row_q, columns;
  logic signed [MovedW-1:0] x_q, x_row_q, y_q, x_start, y_start;  // the mean in the window that is next
  pipegs_pkg::conic_t       placed, placed_q;
  localparam logic signed [MovedW-1:0] Side = MovedW'(1) << (SideF + MeanF);

  assign is_end      = colored_i.kind != pipegs_pkg::KindData;
  assign out_free    = !out_valid_q || placed_ready_i;
  assign start       = !walking_q && colored_valid_i && !is_end && queued_valid;
  assign pass        = !walking_q && colored_valid_i && is_end && out_free;
  assign move        = walking_q && (out_free || !touches);
  assign step        = move && touches;
  assign last_column = column_q == to_x;
  assign done        = move && last_column && row_q == to_y;
  assign columns     = NumberW'(most_x) + NumberW'(1);
  assign x_start     = MovedW'(mean_x) - ($signed(MovedW'(from_x)) <<< (SideF + MeanF));
  assign y_start     = MovedW'(mean_y) - ($signed(MovedW'(from_y)) <<< (SideF + MeanF));
  assign colored_ready_o = done || pass;
  assign placed_valid_o  = out_valid_q;
  assign passes_o        = move && !touches;
  assign busy_o          = box_q != BoxFind || count != '0 || walking_q || out_valid_q;

  logic signed [PlacedW-1:0] placed_x, placed_y;
  pipegs_saturate #(.InW(MovedW), .OutW(PlacedW)) u_placed_x (
    .in_i(x_q),
    .out_o(placed_x)
  );
  pipegs_saturate #(.InW(MovedW), .OutW(PlacedW)) u_placed_y (
    .in_i(y_q),
    .out_o(placed_y)
  );
  always_comb begin
    placed = '0;
    placed.kind = colored_i.kind;
    if (!is_end) begin
      {placed.extent_x, placed.extent_y, placed.swap, placed.slope_m, placed.narrow_m, placed.narrow_e, placed.wide_m,
       placed.wide_e, placed.opacity} = shape;
      placed.mean_x = MeanW'(placed_x);
      placed.mean_y = MeanW'(placed_y);
    end
  end

  if (pipegs_pkg::Oriented) begin : gen_oriented
    logic [OrientedW-1:0]         oriented_q;
    logic [pipegs_pkg::TiltW-1:0] tilt;
    logic [pipegs_pkg::SideW-1:0] side_u, side_v;
    localparam int unsigned WayW = MovedW + 2;
    localparam logic signed [WayW-1:0] Middle = (WayW'(pipegs_pkg::Window) - WayW'(1)) <<< MeanF;
    logic [pipegs_pkg::TiltW-1:0] from_tilt;
    logic [pipegs_pkg::SideW-1:0] from_u, from_v;
    assign {from_tilt, from_u, from_v} = queued[QueuedW-1:PlainW];
    pu_touch #(.Side(pipegs_pkg::Window), .DataW(WayW)) u_touch (
      .clk_i,
      .load_i(start),
      .dx_i((WayW'(x_start) <<< 1) - Middle),
      .dy_i((WayW'(y_start) <<< 1) - Middle),
      .tilt_i(from_tilt),
      .side_u_i(from_u),
      .side_v_i(from_v),
      .step_i(move),
      .down_i(last_column),
      .touches_o(touches)
    );
    assign queueing[QueuedW-1:PlainW] = {conic_i.tilt, conic_i.side_u, conic_i.side_v};
    assign {tilt, side_u, side_v} = oriented_q;
    always_ff @(posedge clk_i) if (step || pass) oriented_q <= is_end ? '0 : queued[QueuedW-1:PlainW];
    always_comb begin
      placed_o        = placed_q;
      placed_o.tilt   = tilt;
      placed_o.side_u = side_u;
      placed_o.side_v = side_v;
    end
  end else begin : gen_reached
    assign touches  = 1'b1;
    assign placed_o = placed_q;
  end

  assign listed_valid_o = step;
  always_comb begin
    listed_o.depth  = colored_i.depth;
    listed_o.index  = colored_i.index;
    listed_o.window = number_q;
    listed_o.red    = colored_i.red;
    listed_o.green  = colored_i.green;
    listed_o.blue   = colored_i.blue;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      walking_q   <= 1'b0;
      out_valid_q <= 1'b0;
    end else begin
      if (start) walking_q <= 1'b1;
      else if (done) walking_q <= 1'b0;
      if (out_free) out_valid_q <= step || pass;
    end
  end
  always_ff @(posedge clk_i) begin
    if (step || pass) placed_q <= placed;
    if (start) begin
      column_q     <= from_x;
      row_q        <= from_y;
      x_q          <= x_start;
      x_row_q      <= x_start;
      y_q          <= y_start;
      number_q     <= NumberW'(from_y) * columns + NumberW'(from_x);
      number_row_q <= NumberW'(from_y) * columns + NumberW'(from_x);
    end else if (move && last_column) begin
      column_q     <= from_x;
      row_q        <= row_q + WindowW'(1);
      x_q          <= x_row_q;
      y_q          <= y_q - Side;
      number_q     <= number_row_q + columns;
      number_row_q <= number_row_q + columns;
    end else if (move) begin
      column_q     <= column_q + WindowW'(1);
      x_q          <= x_q - Side;
      number_q     <= number_q + NumberW'(1);
    end
  end

  logic unused_in;
  assign unused_in = &{1'b0, colored_i};

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits(color_job_o))) u_check_color_job (
    .clk_i,
    .rst_ni,
    .valid_i(color_job_valid_o),
    .ready_i(color_job_ready_i),
    .beat_i(color_job_o)
  );
  pipegs_stream_check #(.DataW($bits(placed_o))) u_check_placed (
    .clk_i,
    .rst_ni,
    .valid_i(placed_valid_o),
    .ready_i(placed_ready_i),
    .beat_i(placed_o)
  );
`endif

endmodule
