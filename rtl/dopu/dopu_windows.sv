// SPDX-License-Identifier: Apache-2.0
// dopu_windows: the windows of the frame in rows, each with its planes, one ahead of the walk.
//
// Paper   Sec. 4.1 (scheduling); early termination of a whole window is the feedback of Fig. 7's RU.
// Idea    Two sets of planes: while the walk uses one, dopu_planes fills the other. A set is done when every region of
//         its window is done; region (rx, ry) counts only if the RU that owns it is in this window. With lists there is
//         one set, of all windows as one rectangle, and it is never done.
// Stream  start_i for one cycle; set_valid_o: a set may be walked, until walked_i; release_i gives back the oldest set.
// Pace    One window per 52 cycles.
// Model   cpp_model/dopu/dopu_planes.hpp

module dopu_windows (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,

  input  logic                                  start_i,
  input  pipegs_pkg::rotation_t                 rotation_i,
  input  pipegs_pkg::lens_t                     lens_i,
  input  pipegs_pkg::raster_t                   raster_i,

  input  logic [pipegs_pkg::Units*pipegs_pkg::Regions-1:0] done_i,    // from the RUs
  input  logic [pipegs_pkg::Units*pipegs_pkg::WindowW-1:0] done_x_i,
  input  logic [pipegs_pkg::Units*pipegs_pkg::WindowW-1:0] done_y_i,

  output logic [1:0]                            set_valid_o,  // filled and not walked yet
  input  logic                                  walked_i,     // all cells of the next one are on their way
  output logic [1:0]                            set_last_o,   // the frame's last window
  output logic [1:0]                            set_done_o,   // nothing of it can be seen any more
  output logic                                  done_news_o,  // that changes with this cycle's end
  output logic [2*pipegs_pkg::WindowW-1:0]      set_x_o,
  output logic [2*pipegs_pkg::WindowW-1:0]      set_y_o,
  output logic [2*5*pipegs_pkg::PlaneBits-1:0]  planes_o,
  input  logic                                  release_i     // the oldest one is not needed any more
);

  localparam int unsigned WindowW = pipegs_pkg::WindowW;
  localparam int unsigned PlanesW = 5 * pipegs_pkg::PlaneBits;
  localparam int unsigned Units = pipegs_pkg::Units;
  localparam int unsigned Regions = pipegs_pkg::Regions;
  localparam logic Whole = pipegs_pkg::HasLists;  // one walk of all windows: nothing is done before it ends

  // --- windows, row by row ----------------------------------------------------------------------------------------
  logic               asking_q, more_q;  // a window is with dopu_planes; windows are left
  logic [WindowW-1:0] x, y;
  logic               window_valid, window_ready, planes_valid, planes_ready, row_ends, last;
  logic [PlanesW-1:0] planes;
  logic [1:0]         valid_q, fresh_q, last_q, done_d, done_q;
  logic               fill_q, walk_q, oldest_q;  // the set filled, walked, released next
  logic [WindowW-1:0] set_x_q [2];
  logic [WindowW-1:0] set_y_q [2];
  logic [PlanesW-1:0] planes_q [2];

  assign window_valid = more_q && !asking_q;
  assign planes_ready = !valid_q[fill_q];
  assign last         = Whole || (row_ends && y == raster_i.windows.last_y);

  pipegs_window_walk u_walk (
    .clk_i,
    .rst_ni,
    .first_x_i(raster_i.windows.first_x),
    .first_y_i(raster_i.windows.first_y),
    .last_x_i(raster_i.windows.last_x),
    .start_i,
    .advance_i(planes_valid && planes_ready),
    .x_o(x),
    .y_o(y),
    .next_x_o(),
    .next_y_o(),
    .row_ends_o(row_ends)
  );

  dopu_planes u_planes (
    .clk_i,
    .rst_ni,
    .rotation_i,
    .lens_i,
    .raster_i,
    .window_valid_i(window_valid),
    .window_ready_o(window_ready),
    .window_x_i(x),
    .window_y_i(y),
    .planes_valid_o(planes_valid),
    .planes_ready_i(planes_ready),
    .planes_o(planes)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      asking_q <= 1'b0;
      more_q   <= 1'b0;
      valid_q  <= '0;
      fresh_q  <= '0;
      fill_q   <= 1'b0;
      walk_q   <= 1'b0;
      oldest_q <= 1'b0;
    end else begin
      if (start_i) more_q <= 1'b1;
      if (window_valid && window_ready) asking_q <= 1'b1;
      if (planes_valid && planes_ready) begin
        asking_q        <= 1'b0;
        valid_q[fill_q] <= 1'b1;
        fresh_q[fill_q] <= 1'b1;
        fill_q          <= !fill_q;
        if (last) more_q <= 1'b0;
      end
      if (walked_i) begin
        fresh_q[walk_q] <= 1'b0;
        walk_q          <= !walk_q;
      end
      if (release_i) begin
        valid_q[oldest_q] <= 1'b0;
        oldest_q          <= !oldest_q;
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (planes_valid && planes_ready) begin
      planes_q[fill_q] <= planes;
      set_x_q[fill_q]  <= x;
      set_y_q[fill_q]  <= y;
      last_q[fill_q]   <= last;
    end
  end

  assign set_valid_o = fresh_q;
  assign set_last_o  = last_q;
  assign set_x_o     = {set_x_q[1], set_x_q[0]};
  assign set_y_o     = {set_y_q[1], set_y_q[0]};
  assign planes_o    = {planes_q[1], planes_q[0]};

  // --- done feedback ------------------------------------------------------------------------------------------------
  pipegs_pkg::progress_t progress;
  logic [Units-1:0]   here [2];  // the RU is in the set's window
  logic [Regions-1:0] region_done [2];
  assign progress = {done_y_i, done_x_i, done_i};

  always_comb begin
    for (int unsigned s = 0; s < 2; s += 1) begin
      for (int unsigned u = 0; u < Units; u += 1) begin
        here[s][u] = progress.x[u] == set_x_q[s] && progress.y[u] == set_y_q[s];
      end
      region_done[s] = '0;
      for (int unsigned u = 0; u < Units; u += 1) if (here[s][u]) region_done[s] |= progress.done[u];
    end
  end

  always_comb begin
    for (int unsigned s = 0; s < 2; s += 1) done_d[s] = !Whole && valid_q[s] && region_done[s] == '1;
  end
  always_ff @(posedge clk_i) done_q <= done_d;
  assign done_news_o = done_d != done_q;
  assign set_done_o = done_q & valid_q;

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits({x, y}))) u_check_window (
    .clk_i,
    .rst_ni,
    .valid_i(window_valid),
    .ready_i(window_ready),
    .beat_i({x, y})
  );
`endif

endmodule
