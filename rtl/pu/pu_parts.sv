// SPDX-License-Identifier: Apache-2.0
// pu_parts: from one Gaussian of a window to one beat for each square of the window that its box touches.
//
// Paper   Sec. 4.2: the paper's windows have one part.
// Idea    The box mean +- extent as columns and rows of squares; a Gaussian without any is dropped. They are walked
//         row by row, where one is walked only this one, the mean moved to the first pixel of each by a subtraction and
//         saturated as pu_project does it in a window of that size. The payload waits in a queue and goes along with
//         each; its eye and the square are the part.
// Stream  payload in, one for each Gaussian, in order, not refused; its conic in; one conic beat per part out, and one
//         cycle before it the payload with the part. Ends pass.
// Pace    One part per cycle, and one cycle between Gaussians.
// Model   cpp_model/pu/pu_parts.hpp

module pu_parts (
  input  logic                  clk_i,
  input  logic                  rst_ni,

  input  logic                  payload_valid_i,
  input  pipegs_pkg::payload_t  payload_i,

  input  logic                  conic_valid_i,
  output logic                  conic_ready_o,
  input  pipegs_pkg::conic_t    conic_i,

  output logic                  parted_valid_o,  // placed_o shows this Gaussian from the next cycle on
  output pipegs_pkg::parted_t   parted_o,
  output logic                  placed_valid_o,
  input  logic                  placed_ready_i,
  output pipegs_pkg::conic_t    placed_o,

  output logic                  moved_o,  // a beat moved inside or out
  output logic                  busy_o    // a Gaussian is inside
);

  localparam int unsigned MeanW   = pipegs_pkg::MeanW;
  localparam int unsigned PlacedW = pipegs_pkg::WindowMeanW;  // of a mean in its part
  localparam int unsigned SideF   = $clog2(pipegs_pkg::PartSide);
  localparam int unsigned AxisW   = pipegs_pkg::Squares > 1 ? pipegs_pkg::SquareW / 2 : 1;
  localparam int unsigned Places  = pipegs_pkg::ShapePlaces;
  localparam logic [AxisW-1:0] Most = AxisW'(pipegs_pkg::PartsX - 1);

  // --- the payloads --------------------------------------------------------------------------------------------------
  logic                        payload_room, payload_held, payload_take;
  logic [$clog2(Places+1)-1:0] payload_count;
  pipegs_pkg::payload_t        payload;

  pipegs_sram_fifo #(.DataW(pipegs_pkg::PayloadBits), .Depth(Places)) u_payload (
    .clk_i,
    .rst_ni,
    .in_valid_i(payload_valid_i),
    .in_ready_o(payload_room),
    .in_i(payload_i),
    .out_valid_o(payload_held),
    .out_ready_i(payload_take),
    .out_o(payload),
    .count_o(payload_count)
  );

  // --- the box -------------------------------------------------------------------------------------------------------
  logic [AxisW-1:0] first_x, last_x, first_y, last_y, begin_x, end_x, begin_y, end_y;  // begin: of those walked
  logic             none_x, none_y, one_part;
  logic [AxisW-1:0] one_x, one_y;  // that is walked
  pu_span #(.SideF(SideF), .IndexW(AxisW)) u_columns (
    .mean_i(conic_i.mean_x),
    .extent_i(conic_i.extent_x),
    .most_i(Most),
    .first_o(first_x),
    .last_o(last_x),
    .none_o(none_x)
  );
  pu_span #(.SideF(SideF), .IndexW(AxisW)) u_rows (
    .mean_i(conic_i.mean_y),
    .extent_i(conic_i.extent_y),
    .most_i(Most),
    .first_o(first_y),
    .last_o(last_y),
    .none_o(none_y)
  );

  // --- the walk: the conic stays at the input until its last part ----------------------------------------------------
  logic             walking_q, data, none, none_q, start, step, pass, last_column, last, out_free, out_valid_q;
  logic [AxisW-1:0] column_q, row_q, from_x_q, to_x_q, to_y_q;

  assign data        = conic_i.kind == pipegs_pkg::KindData;
  assign none        = none_x || none_y || (one_part && (one_x < first_x || one_x > last_x ||
                                                         one_y < first_y || one_y > last_y));
  assign begin_x     = one_part ? one_x : first_x;
  assign begin_y     = one_part ? one_y : first_y;
  assign end_x       = one_part ? one_x : last_x;
  assign end_y       = one_part ? one_y : last_y;
  if (pipegs_pkg::HasWalks) begin : gen_walk
    assign {one_part, one_y, one_x} = payload.walk[pipegs_pkg::WalkW-1 -: 3];
  end else begin : gen_whole
    assign {one_part, one_y, one_x} = '0;
  end
  assign out_free    = !out_valid_q || placed_ready_i;
  assign start       = !walking_q && conic_valid_i && data;
  assign pass        = !walking_q && conic_valid_i && !data && out_free;
  assign step        = walking_q && !none_q && out_free;
  assign last_column = column_q == to_x_q;
  assign last        = step && last_column && row_q == to_y_q;

  assign conic_ready_o = last || pass || (walking_q && none_q);
  assign payload_take  = conic_ready_o && data;
  assign moved_o       = start || step || conic_ready_o;
  assign busy_o        = walking_q || out_valid_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      walking_q   <= 1'b0;
      out_valid_q <= 1'b0;
    end else begin
      if (start) walking_q <= 1'b1;
      else if (conic_ready_o) walking_q <= 1'b0;
      if (out_free) out_valid_q <= step || pass;
    end
  end
  always_ff @(posedge clk_i) begin
    if (start) begin
      none_q                     <= none;
      {from_x_q, to_x_q, to_y_q} <= {begin_x, end_x, end_y};
      {column_q, row_q}          <= {begin_x, begin_y};
    end else if (step) begin
      column_q <= last_column ? from_x_q : column_q + 1'b1;
      if (last_column) row_q <= row_q + 1'b1;
    end
  end

  // --- the part ------------------------------------------------------------------------------------------------------
  logic signed [MeanW:0]     moved_x, moved_y;  // exact
  logic signed [PlacedW-1:0] placed_x, placed_y;
  pipegs_pkg::conic_t        placed, placed_q;
  assign moved_x = (MeanW + 1)'(conic_i.mean_x) -
                   $signed((MeanW + 1)'({column_q, {(SideF + pipegs_pkg::MeanF){1'b0}}}));
  assign moved_y = (MeanW + 1)'(conic_i.mean_y) -
                   $signed((MeanW + 1)'({row_q, {(SideF + pipegs_pkg::MeanF){1'b0}}}));
  pipegs_saturate #(.InW(MeanW + 1), .OutW(PlacedW)) u_placed_x (
    .in_i(moved_x),
    .out_o(placed_x)
  );
  pipegs_saturate #(.InW(MeanW + 1), .OutW(PlacedW)) u_placed_y (
    .in_i(moved_y),
    .out_o(placed_y)
  );
  always_comb begin
    placed = conic_i;
    if (data) begin
      placed.mean_x = MeanW'(placed_x);
      placed.mean_y = MeanW'(placed_y);
    end
  end
  always_ff @(posedge clk_i) if (step || pass) placed_q <= placed;

  assign placed_valid_o   = out_valid_q;
  assign placed_o         = placed_q;
  assign parted_valid_o   = step;
  assign parted_o.payload = payload;
  logic [pipegs_pkg::PartW-1:0] part;
  if (pipegs_pkg::Squares > 1) begin : gen_square
    assign part[2*AxisW-1:0] = {row_q, column_q};
  end
  if (pipegs_pkg::Eyes > 1) begin : gen_eye
    assign part[pipegs_pkg::PartW-1] = payload.eye;
  end
  assign parted_o.part = part;

  logic unused;
  assign unused = &{1'b0, payload_room, payload_held, payload_count};

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!payload_valid_i || payload_room)
    else $error("more Gaussians than places for their payloads");
  always_ff @(posedge clk_i) if (rst_ni) assert (!start || payload_held)
    else $error("a payload is not there in time");
  pipegs_stream_check #(.DataW($bits(placed_o))) u_check_placed (
    .clk_i,
    .rst_ni,
    .valid_i(placed_valid_o),
    .ready_i(placed_ready_i),
    .beat_i(placed_o)
  );
`endif

endmodule
