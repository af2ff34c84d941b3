// SPDX-License-Identifier: Apache-2.0
// dopu_windows: the walks of the frame, window by window in rows, each with its planes, one ahead of the walk.
//
// Paper   Sec. 4.1 (scheduling); early termination of a whole window is the feedback of Fig. 7's RU.
// Idea    Two sets of planes: while the walk uses one, dopu_planes fills the other. A set is done when every region of
//         its walk is done; region (rx, ry) counts only if the RU that owns it is in this window. With lists there is
//         one set, of all windows as one rectangle, and it is never done. Where judges_i is up the walk of a whole
//         window is on trial (set_judges_o) until it is known how much there is; one with too much is given up, which
//         is as done, and the walks of its parts follow, or with two eyes those of either eye.
//         With Occlusion the planes of a set are made anew when more of its walk is closed: those of the rectangle
//         around what is open (pipegs_open). What they let pass that the old ones did not changes no pixel either, so
//         they may change while nodes are tested; not on trial, whose verdict is of the window. A set to be filled goes
//         first, once it is free.
// Stream  start_i for one cycle; set_valid_o: a set may be walked, until walked_i; release_i gives back the oldest set.
//         judged_i: the set on trial is walked on, or given up.
// Pace    One walk per 52 cycles.
// Model   cpp_model/dopu/dopu_planes.hpp, dopu_walks.hpp, cpp_model/open.hpp

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
  input  pipegs_pkg::open_t                     open_i,

  output logic [1:0]                            set_valid_o,  // filled and not walked yet
  input  logic                                  walked_i,     // all cells of the next one are on their way
  output logic [1:0]                            set_last_o,   // the frame's last walk, but for one on trial
  output logic [1:0]                            set_done_o,   // nothing of it can be seen any more
  output logic                                  done_news_o,  // that changes with this cycle's end; or planes are made
  output logic [1:0]                            set_ends_o,   // the last walk of its window
  output logic [2*pipegs_pkg::PlaceW-1:0]       set_place_o,
  output logic [2*5*pipegs_pkg::PlaneBits-1:0]  planes_o,
  input  logic                                  release_i,    // the oldest one is not needed any more

  input  logic                                  judges_i,      // for the whole frame: there are trials
  output logic [1:0]                            set_judges_o,  // on trial
  input  logic                                  judged_i,      // it is over, ...
  input  logic                                  split_i,       // ... and the walk is given up,
  input  logic                                  parts_i,       // ... for those of parts
  output logic [1:0]                            set_given_o    // given up
);

  localparam int unsigned WindowW = pipegs_pkg::WindowW;
  localparam int unsigned PlaceW = pipegs_pkg::PlaceW;
  localparam int unsigned MaskW = pipegs_pkg::MaskW;
  localparam int unsigned PlanesW = 5 * pipegs_pkg::PlaneBits;
  localparam int unsigned ClosedBits = pipegs_pkg::ClosedBits;
  localparam int unsigned Units = pipegs_pkg::Units;
  localparam int unsigned Regions = pipegs_pkg::Regions;
  localparam logic Whole = pipegs_pkg::HasLists;  // one walk of all windows: nothing is done before it ends

  // --- windows, row by row ----------------------------------------------------------------------------------------
  logic               asking_q, more_q;  // a walk is with dopu_planes; windows are left
  logic [WindowW-1:0] x, y;
  logic [PlaceW-1:0]  place;
  logic               window_valid, window_ready, planes_valid, planes_ready, row_ends, last;
  logic [PlanesW-1:0] planes;
  logic [1:0]         valid_q, fresh_q, last_q, ends_q, done_d, done_q;
  logic               fill_q, walk_q, oldest_q;  // the set filled, walked, released next
  logic               fill, on_trial, split, ends, next;  // next: the window has a set for each of its walks
  logic               judges_q;                  // the set filled last is on trial, and the next one waits
  logic [1:0]         given_q;
  logic [PlaceW-1:0]  place_q [2];
  logic [PlanesW-1:0] planes_q [2];
  // A set's planes are made anew: it is due, dopu_planes works on them, they come; of which set.
  logic                  refit_due, refitting, refit, refit_pick, refit_set, fill_due;
  logic [ClosedBits-1:0] refit_closed;  // what is closed of the walk that dopu_planes is asked for

  assign window_valid = fill_due || refit_due;
  assign planes_ready = !valid_q[fill_q] || refitting;
  assign fill         = planes_valid && planes_ready && !refitting;
  assign split        = judged_i && split_i;
  assign next         = (judged_i && !split_i) || (fill && !on_trial && ends);
  assign last         = Whole || (row_ends && y == raster_i.windows.last_y);

  pipegs_window_walk u_walk (
    .clk_i,
    .rst_ni,
    .first_x_i(raster_i.windows.first_x),
    .first_y_i(raster_i.windows.first_y),
    .last_x_i(raster_i.windows.last_x),
    .start_i,
    .advance_i(next),
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
    .window_i(fill_due ? place : place_q[refit_pick]),
    .closed_i(refit_closed),
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
      judges_q <= 1'b0;
      given_q  <= '0;
    end else begin
      if (start_i) more_q <= 1'b1;
      if (fill_due && window_ready) asking_q <= 1'b1;
      if (walked_i) begin
        fresh_q[walk_q] <= 1'b0;
        walk_q          <= !walk_q;
      end
      if (fill) begin
        asking_q        <= 1'b0;
        valid_q[fill_q] <= 1'b1;
        fresh_q[fill_q] <= 1'b1;
        given_q[fill_q] <= 1'b0;
        fill_q          <= !fill_q;
        judges_q        <= on_trial;
      end
      if (judged_i) judges_q <= 1'b0;
      if (split) given_q[!fill_q] <= 1'b1;
      if (next && last) more_q <= 1'b0;
      if (release_i) begin
        valid_q[oldest_q] <= 1'b0;
        oldest_q          <= !oldest_q;
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (refit) planes_q[refit_set] <= planes;
    if (fill) begin
      planes_q[fill_q] <= planes;
      place_q[fill_q]  <= place;
      ends_q[fill_q]   <= ends;
      last_q[fill_q]   <= ends && last && !on_trial;  // then nobody needs to know
    end
  end

  assign set_valid_o  = fresh_q;
  assign set_last_o   = last_q;
  assign set_ends_o   = ends_q;
  assign set_judges_o = {judges_q && !fill_q, judges_q && fill_q};
  assign set_given_o  = given_q & valid_q;
  assign set_place_o  = {place_q[1], place_q[0]};
  assign planes_o     = {planes_q[1], planes_q[0]};

  // --- planes made anew ---------------------------------------------------------------------------------------------
  if (pipegs_pkg::Occlusion != 0) begin : gen_refit
    logic [ClosedBits-1:0] closed [2];      // of the walk of either set
    logic [ClosedBits-1:0] closed_q [2];    // of its planes
    logic [ClosedBits-1:0] refit_closed_q;  // of those that are made
    logic                  set_q, busy_q;
    logic [1:0]            stale;
    for (genvar s = 0; s < 2; s += 1) begin : gen_set
      pipegs_closed u_closed (
        .open_i,
        .place_i(place_q[s]),
        .closed_o(closed[s])
      );
      assign stale[s] = valid_q[s] && !set_judges_o[s] && !given_q[s] && closed[s] != '0 && closed[s] != closed_q[s];
    end
    // A set filled holds on to dopu_planes until it is taken, so it is asked for only when it can be.
    assign fill_due     = more_q && !asking_q && !judges_q && !valid_q[fill_q] && !refitting;
    assign refit_due    = !fill_due && !asking_q && !refitting && stale != '0;
    assign refit_pick   = stale[oldest_q] ? oldest_q : !oldest_q;
    assign refit_closed = fill_due ? '0 : closed[refit_pick];
    assign refit        = planes_valid && refitting;
    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) busy_q <= 1'b0;
      else if (refit_due && window_ready) busy_q <= 1'b1;
      else if (refit) busy_q <= 1'b0;
    end
    assign refitting = busy_q;
    assign refit_set = set_q;
    always_ff @(posedge clk_i) begin
      if (refit_due && window_ready) begin
        set_q          <= refit_pick;
        refit_closed_q <= refit_closed;
      end
      // A set that was released meanwhile is not filled before: what it gets does no harm.
      if (refit) closed_q[refit_set] <= refit_closed_q;
      if (fill) closed_q[fill_q] <= '0;
    end
  end else begin : gen_no_refit
    assign fill_due     = more_q && !asking_q && !judges_q;
    assign refit_due    = 1'b0;
    assign refitting    = 1'b0;
    assign refit        = 1'b0;
    assign refit_pick   = 1'b0;
    assign refit_set    = 1'b0;
    assign refit_closed = '0;
    logic unused_open;
    assign unused_open  = ^open_i;
  end

  // --- the walks of a window: whole, or for each eye, and there its parts with a pixel of the picture, row by row ----
  if (pipegs_pkg::HasWalks) begin : gen_walks
    localparam int unsigned HalfF  = $clog2(pipegs_pkg::Window) - 1;
    localparam int unsigned PixelW = WindowW + pipegs_pkg::SizeW;
    logic       parts_q;         // the present window goes by parts
    logic [1:0] part_q;          // the next one of them
    logic       right_in, lower_in;  // the right column, the lower row have pixels
    logic       eyes_q, eye_q, last_eye;  // the window goes eye by eye: the next one, and the last
    logic       part_ends, by_parts;  // by_parts: the walk on trial is given up for those of parts
    logic       eye_turns;  // its last part is filled
    assign right_in = PixelW'({x, 1'b1}) << HalfF < PixelW'(raster_i.width);
    assign lower_in = PixelW'({y, 1'b1}) << HalfF < PixelW'(raster_i.height);
    assign part_ends = !parts_q || part_q == {lower_in, right_in};
    assign on_trial  = judges_i && !parts_q && !eyes_q;
    assign ends      = part_ends && (!eyes_q || eye_q == last_eye);
    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) begin
        parts_q <= 1'b0;
        part_q  <= '0;
      end else begin
        parts_q <= (parts_q && !next) || by_parts;
        if (next || eye_turns) part_q <= '0;
        else if (fill && parts_q) part_q <= part_q[0] || !right_in ? 2'd2 : part_q + 1'b1;
      end
    end
    if (pipegs_pkg::Eyes > 1) begin : gen_eyes
      assign by_parts  = split && parts_i;
      assign eye_turns = fill && part_ends;
      assign last_eye  = raster_i.eyes[1];
      assign place     = {parts_q, part_q, eyes_q, eye_q, y, x};
      always_ff @(posedge clk_i or negedge rst_ni) begin
        if (!rst_ni) begin
          eyes_q <= 1'b0;
          eye_q  <= 1'b0;
        end else begin
          eyes_q <= (eyes_q && !next) || split;
          if (next) eye_q <= 1'b0;
          else if (split) eye_q <= !raster_i.eyes[0];
          else if (eye_turns && eyes_q) eye_q <= 1'b1;
        end
      end
    end else begin : gen_one_eye
      assign eyes_q    = 1'b0;
      assign eye_q     = 1'b0;
      assign last_eye  = 1'b0;
      assign by_parts  = split;
      assign eye_turns = 1'b0;
      assign place     = {parts_q, part_q, y, x};
      logic unused_parts;
      assign unused_parts = parts_i;
    end
  end else begin : gen_whole
    assign on_trial = 1'b0;
    assign ends     = 1'b1;
    assign place    = {y, x};
    logic unused_judges;
    assign unused_judges = judges_i || parts_i;
  end

  // --- done feedback ------------------------------------------------------------------------------------------------
  pipegs_pkg::progress_t progress;
  logic [Units-1:0]   here [2];  // the RU is in the set's window
  logic [Regions-1:0] region_done [2], beside [2];  // beside: regions that are not the walk's
  assign progress = {done_y_i, done_x_i, done_i};

  always_comb begin
    for (int unsigned s = 0; s < 2; s += 1) begin
      for (int unsigned u = 0; u < Units; u += 1) begin
        here[s][u] = {progress.y[u], progress.x[u]} == place_q[s][2*WindowW-1:0];
      end
      region_done[s] = '0;
      for (int unsigned u = 0; u < Units; u += 1) if (here[s][u]) region_done[s] |= progress.done[u];
    end
  end

  always_comb begin
    for (int unsigned s = 0; s < 2; s += 1) begin
      done_d[s] = !Whole && valid_q[s] && !set_judges_o[s] && (region_done[s] | beside[s]) == '1;
    end
  end
  for (genvar s = 0; s < 2; s += 1) begin : gen_beside
    if (pipegs_pkg::HasWalks) begin : gen_parts
      for (genvar p = 0; p < pipegs_pkg::Parts; p += 1) begin : gen_part
        logic square, eye;  // another one
        assign square = place_q[s][PlaceW-1] && place_q[s][PlaceW-2 -: 2] != 2'(p % pipegs_pkg::Squares);
        if (pipegs_pkg::Eyes > 1) begin : gen_eye
          assign eye = place_q[s][2*WindowW+1] && place_q[s][2*WindowW] != 1'(p / pipegs_pkg::Squares);
        end else begin : gen_one_eye
          assign eye = 1'b0;
        end
        assign beside[s][p*MaskW +: MaskW] = {MaskW{square || eye}};
      end
    end else begin : gen_none
      assign beside[s] = '0;
    end
  end
  always_ff @(posedge clk_i) done_q <= done_d;
  assign done_news_o = done_d != done_q || refit_due || refitting;
  assign set_done_o  = (done_q | given_q) & valid_q;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!judged_i || judges_q);
  always_ff @(posedge clk_i) if (rst_ni) assert (!window_valid || window_ready);
  pipegs_stream_check #(.DataW(PlaceW)) u_check_window (
    .clk_i,
    .rst_ni,
    .valid_i(window_valid),
    .ready_i(window_ready),
    .beat_i(fill_due ? place : place_q[refit_pick])
  );
`endif

endmodule
