// SPDX-License-Identifier: Apache-2.0
// The end of rtl/dopu/dopu_windows.sv in its proof: two sets of planes take turns, filled, walked and released in that
// order; a window goes whole or by all its parts.
//
// Rule    A set holds its place and its planes from the cycle in which it shows until it is released, or gives way to
//         the parts of a window that was counted. Sets are walked, but for counting, so that each is the whole of the
//         window behind that of the one before, row by row, or the first of its parts, or the next part of the same
//         window; a window is left with its whole or its last part; where windows are counted each is judged once; the
//         last walk of the frame is marked. A set is called done only if every region of its own walk was done in the
//         cycle before: never on account of a walk that it held earlier.
//         With Occlusion planes of a set change only to those of its own walk, asked for with what pipegs_open said of
//         that walk of that window.
// Assumes Of dopu_planes the rule of free_planes; of the walk: a set is walked when it shows, released in turn when
//         walked, judged when walked to be counted; a frame begins when no set is held, and stays.
// Invariant  The sets held (walked or not) lie between the turns of release and of filling; what is filled next follows
//         the set filled last, or where none waits that walked last.

localparam int unsigned PlaneBit = $clog2(PlanesW);
localparam int unsigned WalkW = PlaceW - 2 * WindowW;
(* hierconn *) logic \u_planes.inside_q ;
(* anyconst *) logic [$clog2(Regions)-1:0] region;
(* anyconst *) logic [PlaneBit-1:0]        bit_place;
logic [1:0]         held_q, to_walk_q;  // sets filled for a walk and not released; not walked
logic               left_q;             // windows are left to walk
logic               fresh_count_q;      // the set that is counted is not walked yet
logic               began_q;            // a set was walked
logic [PlaceW-1:0]  before_q, place_before_q [2], newest;  // the set walked last; the set filled last, or that
logic [1:0]         valid_before_q, last_before_q, ends_before_q, bit_before_q, region_before_q, planes_bit, region_now;
logic               counts_before_q;
pipegs_pkg::rotation_t rotation_before_q;
pipegs_pkg::lens_t     lens_before_q;
pipegs_pkg::raster_t   raster_before_q;
logic [1:0]         refit_before_q;          // the set's planes were made anew in the cycle before
logic [PlaceW-1:0]  asked_q;                 // the walk that dopu_planes has
logic [ClosedBits-1:0] said;                 // by pipegs_open of the walk asked for
logic frame_stays;
assign frame_stays = rotation_i == rotation_before_q && lens_i == lens_before_q && raster_i == raster_before_q &&
                     counts_i == counts_before_q;

proof_reset u_proof_reset (.clk_i, .rst_ni);

logic [2*WindowW-1:0] first_window, frame_last;
assign first_window = {raster_i.windows.first_y, raster_i.windows.first_x};
assign frame_last   = {raster_i.windows.last_y, raster_i.windows.last_x};

function automatic logic [2*WindowW-1:0] next_window(input logic [2*WindowW-1:0] window);  // {y, x}
  next_window = window[WindowW-1:0] == raster_i.windows.last_x
              ? {window[2*WindowW-1:WindowW] + 1'b1, raster_i.windows.first_x}
              : {window[2*WindowW-1:WindowW], window[WindowW-1:0] + 1'b1};
endfunction
// Of a place: its first part is 4, and so on; the last part with pixels; none has more than one.
function automatic logic [2:0] walk_at(input logic [PlaceW-1:0] at);
  walk_at = WalkW == 0 ? 3'd0 : 3'(at >> 2 * WindowW);
endfunction
function automatic logic right_at(input logic [PlaceW-1:0] at);
  right_at = 32'(at[WindowW-1:0]) * pipegs_pkg::Window + pipegs_pkg::Window / 2 < 32'(raster_i.width);
endfunction
function automatic logic lower_at(input logic [PlaceW-1:0] at);
  lower_at = 32'(at[2*WindowW-1:WindowW]) * pipegs_pkg::Window + pipegs_pkg::Window / 2 < 32'(raster_i.height);
endfunction
function automatic logic ends_at(input logic [PlaceW-1:0] at);
  ends_at = walk_at(at) == 3'd0 || walk_at(at) == {1'b1, lower_at(at), right_at(at)};
endfunction
function automatic logic [2:0] next_part(input logic [PlaceW-1:0] at);
  next_part = walk_at(at) == 3'd4 ? (right_at(at) ? 3'd5 : 3'd6) : walk_at(at) == 3'd5 ? 3'd6 : 3'd7;
endfunction
// `at` may come behind `earlier`; without one it is the frame's first.
function automatic logic follows(input logic some, input logic [PlaceW-1:0] earlier, input logic [PlaceW-1:0] at);
  follows = !some ? at[2*WindowW-1:0] == first_window && (walk_at(at) == 3'd0 || walk_at(at) == 3'd4) :
            ends_at(earlier) ? at[2*WindowW-1:0] == next_window(earlier[2*WindowW-1:0]) &&
                               (walk_at(at) == 3'd0 || walk_at(at) == 3'd4) :
            at[2*WindowW-1:0] == earlier[2*WindowW-1:0] && walk_at(at) == next_part(earlier);
endfunction
function automatic logic known(input logic [PlaceW-1:0] at);  // a walk that there is
  known = walk_at(at) == 3'd0 || walk_at(at) == 3'd4 || (walk_at(at) == 3'd5 && right_at(at)) ||
          (walk_at(at) == 3'd6 && lower_at(at)) || (walk_at(at) == 3'd7 && right_at(at) && lower_at(at));
endfunction
function automatic logic last_at(input logic [PlaceW-1:0] at);
  last_at = Whole || (ends_at(at) && at[2*WindowW-1:0] == frame_last);
endfunction

assign said = walk_at(place_q[refit_pick]) == 3'd4 ? open_i.part_0 :
              walk_at(place_q[refit_pick]) == 3'd5 ? open_i.part_1 :
              walk_at(place_q[refit_pick]) == 3'd6 ? open_i.part_2 :
              walk_at(place_q[refit_pick]) == 3'd7 ? open_i.part_3 : open_i.whole;

logic real_fill, real_walked, some;
assign real_fill   = whole || (fill && !count);
assign real_walked = walked_i && !set_counts_o[walk_q];
always_comb begin
  for (int unsigned s = 0; s < 2; s += 1) begin
    planes_bit[s] = planes_o[s*PlanesW + 32'(bit_place)];
    region_now[s] = walk_at(place_q[s]) >= 3'd4 && 32'(walk_at(place_q[s])) != 32'd4 + 32'(region) / MaskW;
    for (int unsigned u = 0; u < Units; u += 1) begin
      if (done_x_i[u*WindowW +: WindowW] == place_q[s][WindowW-1:0] &&
          done_y_i[u*WindowW +: WindowW] == place_q[s][2*WindowW-1:WindowW] && done_i[u*Regions + 32'(region)])
        region_now[s] = 1'b1;
    end
  end
end

always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    held_q         <= '0;
    to_walk_q      <= '0;
    left_q         <= 1'b0;
    fresh_count_q  <= 1'b0;
    began_q        <= 1'b0;
    valid_before_q <= '0;
    refit_before_q <= '0;
  end else begin
    refit_before_q <= {refit && refit_set, refit && !refit_set};
    held_q         <= held_q + 2'(real_fill) - 2'(release_i);
    to_walk_q      <= to_walk_q + 2'(real_fill) - 2'(real_walked);
    left_q         <= start_i || (left_q && !(real_walked && set_last_o[walk_q]));
    fresh_count_q  <= (fill && count) || (fresh_count_q && !(walked_i && set_counts_o[walk_q]));
    began_q        <= !start_i && (began_q || real_walked);
    valid_before_q <= valid_q;
    if (release_i) valid_before_q[oldest_q] <= 1'b0;
    if (split) valid_before_q[fill_q] <= 1'b0;
  end
end
always_ff @(posedge clk_i) begin
  if (window_valid && window_ready) asked_q <= fill_due ? place : place_q[refit_pick];
  rotation_before_q <= rotation_i;
  lens_before_q     <= lens_i;
  raster_before_q   <= raster_i;
  counts_before_q   <= counts_i;
  if (real_walked) before_q <= place_q[walk_q];
  for (int unsigned s = 0; s < 2; s += 1) place_before_q[s] <= place_q[s];
  last_before_q   <= set_last_o;
  ends_before_q   <= set_ends_o;
  bit_before_q    <= planes_bit;
  region_before_q <= region_now;
end

assign newest = to_walk_q == 2'd0 ? before_q : place_q[!fill_q];
assign some   = began_q || to_walk_q != 2'd0;
logic idle;
assign idle = !left_q && held_q == '0;
always_comb begin
  assume ({1'b0, bit_place} < (PlaneBit+1)'(PlanesW));
  assume (!rst_ni || !start_i || idle);
  assume (!rst_ni || idle || frame_stays);
  assume (!rst_ni || !walked_i || set_valid_o[walk_q]);
  assume (!rst_ni || !release_i || held_q > to_walk_q);
  assume (!rst_ni || !judged_i || (counts_q && !fresh_count_q));
  if (rst_ni) begin
    assert (held_q <= 2'd2 && to_walk_q <= held_q);
    for (int unsigned s = 0; s < 2; s += 1) begin
      if (valid_before_q[s]) begin
        assert (place_q[s] == place_before_q[s]);
        assert (set_last_o[s] == last_before_q[s] && set_ends_o[s] == ends_before_q[s]);
        assert (refit_before_q[s] || planes_bit[s] == bit_before_q[s]);
      end
      assert (!set_done_o[s] || (valid_before_q[s] && region_before_q[s]));
    end
    // planes made anew
    assert (!(fill_due && refit_due) && !(asking_q && refitting));
    assert (!refit_due || (valid_q[refit_pick] && !set_counts_o[refit_pick] && open_i.known && refit_closed == said &&
                           {open_i.window_y, open_i.window_x} == place_q[refit_pick][2*WindowW-1:0]));
    assert (!refitting || !valid_q[refit_set] || asked_q == place_q[refit_set]);
    assert (!refitting || !set_counts_o[refit_set] || !valid_q[refit_set]);
    // what is shown to be walked
    if (to_walk_q != 2'd0) begin
      assert (left_q && set_valid_o[walk_q] && !set_counts_o[walk_q]);
      assert (set_last_o[walk_q] == last_at(place_q[walk_q]) && set_ends_o[walk_q] == ends_at(place_q[walk_q]));
      if (!Whole) assert (known(place_q[walk_q]) && follows(began_q, before_q, place_q[walk_q]));
    end else begin
      assert (set_valid_o == (fresh_count_q ? set_counts_o : 2'b00));
    end
    // invariants
    assert (valid_q == ((held_q == 2'd0 ? 2'b00 : held_q == 2'd2 ? 2'b11 : oldest_q ? 2'b10 : 2'b01) | set_counts_o));
    assert (!counts_q || (held_q != 2'd2 && more_q && !asking_q && counts_i && count));
    assert (fresh_q == ((to_walk_q == 2'd0 ? 2'b00 : to_walk_q == 2'd2 ? 2'b11 : walk_q ? 2'b10 : 2'b01) |
                        (fresh_count_q ? set_counts_o : 2'b00)));
    assert (!fresh_count_q || counts_q);
    assert (fill_q == oldest_q ^ held_q[0] && fill_q == walk_q ^ to_walk_q[0]);
    for (int unsigned s = 0; s < 2; s += 1) assert (!valid_before_q[s] || valid_q[s]);
    assert ((asking_q || refitting) == \u_planes.inside_q && (!asking_q || more_q));
    assert (left_q == (more_q || to_walk_q != '0));
    if (Whole) begin
      assert (to_walk_q <= 2'd1 && (!left_q || more_q == (to_walk_q == 2'd0)));
      assert (to_walk_q == '0 || (last_q[walk_q] && ends_q[walk_q]));
    end else begin
      if (counts_q) assert (place_q[fill_q] == place && ends_q[fill_q] && last_q[fill_q] == last_at(place));
      assert (more_q ? known(place) && follows(some, newest, place) : walk_at(place) == 3'd0);
      if (!more_q && to_walk_q != 2'd0) assert (last_q[!fill_q]);
      if (to_walk_q == 2'd2) begin
        assert (!last_q[walk_q] && follows(1'b1, place_q[walk_q], place_q[!walk_q]) && known(place_q[!walk_q]));
        assert (last_q[!walk_q] == last_at(place_q[!walk_q]) && ends_q[!walk_q] == ends_at(place_q[!walk_q]));
      end
      if (more_q && to_walk_q != 2'd0) assert (!last_q[!fill_q]);
      if (more_q && began_q && to_walk_q == 2'd0) assert (!last_at(before_q));
    end
  end
end
