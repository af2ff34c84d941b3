// SPDX-License-Identifier: Apache-2.0
// The end of rtl/dopu/dopu_windows.sv in its proof: two sets of planes take turns, filled, walked and released in that
// order; a window goes whole or by all its parts, or with two eyes either for each that is wanted.
//
// Rule    A set holds its place and its planes from the cycle in which it shows until it is released. Sets are filled,
//         and walked in that order, so that the first is the whole of the frame's first window, and behind a whole
//         window or its last part comes the whole of the next one, row by row, up to the frame's last; behind a window
//         that was given up its first part, behind that its next one, and behind the first eye's last one the second
//         eye's first one; or, as was judged, the whole of it for the first eye and then for the second. Where there
//         are trials each whole window has one,
//         and nothing is filled before it is over. The last walk of the frame is marked, but for one on trial. A set is
//         called done only if it was given up, or if every region of its own walk was done in the cycle before: never
//         on account of a walk that it held earlier.
//         With Occlusion planes of a set change only to those of its own walk, asked for with what pipegs_open said of
//         that walk of that window, and not on trial.
// Assumes An eye is wanted. Of dopu_planes the rule of free_planes; of the walk: a set is walked when it shows,
//         released in turn when walked, not while it is on trial; a frame begins when no set is held, and stays.
// Invariant  The sets held (walked or not) lie between the turns of release and of filling; what is filled next follows
//         the set filled last.

localparam int unsigned PlaneBit = $clog2(PlanesW);
localparam int unsigned EyeBits = pipegs_pkg::WalkEyeW;
localparam int unsigned WalkW = PlaceW - 2 * WindowW - EyeBits;  // of the squares
(* hierconn *) logic \u_planes.inside_q ;
(* hierconn *) logic [PlaceW-1:0] \u_planes.window_i ;
(* anyconst *) logic [$clog2(Regions)-1:0] region;
(* anyconst *) logic [PlaneBit-1:0]        bit_place;
logic [1:0]         held_q, to_walk_q;  // sets filled and not released; not walked
logic               filled_q;           // one of this frame
logic [PlaceW-1:0]  place_before_q [2], newest;
logic [1:0]         valid_before_q, last_before_q, ends_before_q, bit_before_q, region_before_q, planes_bit, region_now;
logic               judges_before_q;
logic                  parts_said_q;         // the last window that was given up goes by parts
logic [1:0]            eyes;                 // that are wanted
pipegs_pkg::rotation_t rotation_before_q;
pipegs_pkg::lens_t     lens_before_q;
pipegs_pkg::raster_t   raster_before_q;
logic [1:0]         refit_before_q;          // the set's planes were made anew in the cycle before
logic [PlaceW-1:0]  asked_q;                 // the walk that dopu_planes has
logic [ClosedBits-1:0] said;                 // by pipegs_open of the walk asked for
logic frame_stays;
assign frame_stays = rotation_i == rotation_before_q && lens_i == lens_before_q && raster_i == raster_before_q &&
                     judges_i == judges_before_q;

proof_reset u_proof_reset (.clk_i, .rst_ni);

logic [2*WindowW-1:0] first_window, frame_last;
assign first_window = {raster_i.windows.first_y, raster_i.windows.first_x};
assign frame_last   = {raster_i.windows.last_y, raster_i.windows.last_x};

function automatic logic [2*WindowW-1:0] next_window(input logic [2*WindowW-1:0] window);  // {y, x}
  next_window = window[WindowW-1:0] == raster_i.windows.last_x
              ? {window[2*WindowW-1:WindowW] + 1'b1, raster_i.windows.first_x}
              : {window[2*WindowW-1:WindowW], window[WindowW-1:0] + 1'b1};
endfunction
if (pipegs_pkg::Eyes > 1) begin : gen_wanted
  assign eyes = raster_i.eyes;
end else begin : gen_one
  assign eyes = 2'b01;
end
// Of a place: 0 is its whole window, 4 the first part; of one eye 2 or 3, else 0; the right column, the lower row have
// pixels; it is the last.
function automatic logic [2:0] walk_at(input logic [PlaceW-1:0] at);
  walk_at = WalkW == 0 ? 3'd0 : 3'(at >> (2 * WindowW + EyeBits));
endfunction
function automatic logic [1:0] eye_at(input logic [PlaceW-1:0] at);
  eye_at = EyeBits == 0 ? 2'd0 : 2'(at >> 2 * WindowW);
endfunction
function automatic logic right_at(input logic [PlaceW-1:0] at);
  right_at = 32'(at[WindowW-1:0]) * pipegs_pkg::Window + pipegs_pkg::Window / 2 < 32'(raster_i.width);
endfunction
function automatic logic lower_at(input logic [PlaceW-1:0] at);
  lower_at = 32'(at[2*WindowW-1:WindowW]) * pipegs_pkg::Window + pipegs_pkg::Window / 2 < 32'(raster_i.height);
endfunction
function automatic logic square_ends(input logic [PlaceW-1:0] at);
  square_ends = walk_at(at) == 3'd0 || walk_at(at) == {1'b1, lower_at(at), right_at(at)};
endfunction
function automatic logic ends_at(input logic [PlaceW-1:0] at);
  ends_at = square_ends(at) && (eye_at(at) == 2'd0 || eye_at(at) == {1'b1, eyes[1]});
endfunction
function automatic logic [2:0] next_part(input logic [PlaceW-1:0] at);
  next_part = walk_at(at) == 3'd4 ? (right_at(at) ? 3'd5 : 3'd6) : walk_at(at) == 3'd5 ? 3'd6 : 3'd7;
endfunction
function automatic logic known(input logic [PlaceW-1:0] at);  // a walk that there is
  known = (walk_at(at) == 3'd0 || walk_at(at) == 3'd4 || (walk_at(at) == 3'd5 && right_at(at)) ||
           (walk_at(at) == 3'd6 && lower_at(at)) || (walk_at(at) == 3'd7 && right_at(at) && lower_at(at))) &&
          (eye_at(at) == 2'd0 ? EyeBits == 0 || walk_at(at) == 3'd0 :
           eye_at(at) == 2'd2 ? eyes[0] : eye_at(at) == 2'd3 && eyes[1]);
endfunction
// `at` comes behind `earlier`, which was given up or not; without one it is the frame's first.
function automatic logic follows(input logic some, input logic [PlaceW-1:0] earlier, input logic given,
                                 input logic [PlaceW-1:0] at);
  follows = !some ? at[2*WindowW-1:0] == first_window && walk_at(at) == 3'd0 && eye_at(at) == 2'd0 :
            given ? at[2*WindowW-1:0] == earlier[2*WindowW-1:0] &&
                    walk_at(at) == (parts_said_q || EyeBits == 0 ? 3'd4 : 3'd0) &&
                    eye_at(at) == (EyeBits == 0 ? 2'd0 : {1'b1, !eyes[0]}) :
            ends_at(earlier) ? earlier[2*WindowW-1:0] != frame_last && walk_at(at) == 3'd0 && eye_at(at) == 2'd0 &&
                               at[2*WindowW-1:0] == next_window(earlier[2*WindowW-1:0]) :
            at[2*WindowW-1:0] == earlier[2*WindowW-1:0] &&
            (square_ends(earlier) ? eye_at(at) == 2'd3 && walk_at(at) == (walk_at(earlier) == 3'd0 ? 3'd0 : 3'd4)
                                  : eye_at(at) == eye_at(earlier) && walk_at(at) == next_part(earlier));
endfunction

logic [ClosedBits-1:0] said_first;
assign said_first = walk_at(place_q[refit_pick]) == 3'd4 ? open_i.part_0 :
                    walk_at(place_q[refit_pick]) == 3'd5 ? open_i.part_1 :
                    walk_at(place_q[refit_pick]) == 3'd6 ? open_i.part_2 :
                    walk_at(place_q[refit_pick]) == 3'd7 ? open_i.part_3 : open_i.whole;
if (EyeBits != 0) begin : gen_said
  logic [4:0] pick;
  assign pick = {eye_at(place_q[refit_pick]), walk_at(place_q[refit_pick])};
  assign said = pick == 5'o20 ? open_i.eye_0 : pick == 5'o30 ? open_i.eye_1 :
                pick == 5'o34 ? open_i.part_4 : pick == 5'o35 ? open_i.part_5 :
                pick == 5'o36 ? open_i.part_6 : pick == 5'o37 ? open_i.part_7 : said_first;
end else begin : gen_said_one
  assign said = said_first;
end

always_comb begin
  for (int unsigned s = 0; s < 2; s += 1) begin
    planes_bit[s] = planes_o[s*PlanesW + 32'(bit_place)];
    region_now[s] =
        (walk_at(place_q[s]) >= 3'd4 &&
         32'(walk_at(place_q[s])) != 32'd4 + 32'(region) / MaskW % pipegs_pkg::Squares) ||
        (eye_at(place_q[s]) >= 2'd2 && 32'(eye_at(place_q[s])) != 32'd2 + 32'(region) / MaskW / pipegs_pkg::Squares);
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
    filled_q       <= 1'b0;
    valid_before_q <= '0;
    refit_before_q <= '0;
  end else begin
    refit_before_q <= {refit && refit_set, refit && !refit_set};
    held_q         <= held_q + 2'(fill) - 2'(release_i);
    to_walk_q      <= to_walk_q + 2'(fill) - 2'(walked_i);
    filled_q       <= !start_i && (filled_q || fill);
    valid_before_q <= valid_q;
    if (release_i) valid_before_q[oldest_q] <= 1'b0;
  end
end
always_ff @(posedge clk_i) begin
  if (window_valid && window_ready) asked_q <= \u_planes.window_i ;
  rotation_before_q <= rotation_i;
  lens_before_q     <= lens_i;
  raster_before_q   <= raster_i;
  judges_before_q   <= judges_i;
  if (judged_i) parts_said_q <= parts_i;
  for (int unsigned s = 0; s < 2; s += 1) place_before_q[s] <= place_q[s];
  last_before_q   <= set_last_o;
  ends_before_q   <= set_ends_o;
  bit_before_q    <= planes_bit;
  region_before_q <= region_now;
end

assign newest = place_q[!fill_q];
logic idle;
assign idle = !more_q && held_q == '0;
always_comb begin
  assume ({1'b0, bit_place} < (PlaneBit+1)'(PlanesW));
  assume (!rst_ni || !start_i || idle);
  assume (!rst_ni || idle || frame_stays);
  assume (!rst_ni || !walked_i || set_valid_o[walk_q]);
  assume (!rst_ni || !release_i || (held_q > to_walk_q && !set_judges_o[oldest_q]));
  assume (!rst_ni || !judged_i || judges_q);
  assume (eyes != '0);
  if (rst_ni) begin
    assert (held_q <= 2'd2 && to_walk_q <= held_q);
    for (int unsigned s = 0; s < 2; s += 1) begin
      if (valid_before_q[s]) begin
        assert (place_q[s] == place_before_q[s]);
        assert (set_last_o[s] == last_before_q[s] && set_ends_o[s] == ends_before_q[s]);
        assert (refit_before_q[s] || planes_bit[s] == bit_before_q[s]);
      end
      assert (!set_done_o[s] || set_given_o[s] || (valid_before_q[s] && region_before_q[s]));
      assert (!set_given_o[s] || (walk_at(place_q[s]) == 3'd0 && eye_at(place_q[s]) == 2'd0 && !set_judges_o[s]));
    end
    // planes made anew
    assert (!(fill_due && refit_due) && !(asking_q && refitting));
    assert (!refit_due || (valid_q[refit_pick] && !set_judges_o[refit_pick] && open_i.known && refit_closed == said &&
                           {open_i.window_y, open_i.window_x} == place_q[refit_pick][2*WindowW-1:0]));
    assert (!asking_q || asked_q == place);
    assert (!refitting || !valid_q[refit_set] || asked_q == place_q[refit_set]);
    assert (!refitting || !valid_q[refit_set] || !set_judges_o[refit_set]);
    // what is filled
    if (fill) begin
      assert (!judges_q && more_q && (Whole || (known(place) && follows(filled_q, newest, given_q[!fill_q], place))));
      assert (ends == ends_at(place) && last == (Whole || place[2*WindowW-1:0] == frame_last));
      assert (on_trial == (!Whole && WalkW != 0 && judges_i && walk_at(place) == 3'd0 && eye_at(place) == 2'd0));
    end
    // invariants
    assert (valid_q == (held_q == 2'd0 ? 2'b00 : held_q == 2'd2 ? 2'b11 : oldest_q ? 2'b10 : 2'b01));
    assert (fresh_q == (to_walk_q == 2'd0 ? 2'b00 : to_walk_q == 2'd2 ? 2'b11 : walk_q ? 2'b10 : 2'b01));
    assert (fill_q == oldest_q ^ held_q[0] && fill_q == walk_q ^ to_walk_q[0]);
    for (int unsigned s = 0; s < 2; s += 1) assert (!valid_before_q[s] || valid_q[s]);
    assert ((asking_q || refitting) == \u_planes.inside_q && (!asking_q || (more_q && !judges_q)));
    assert (!judges_q || (held_q != '0 && more_q && filled_q && on_trial && place == newest && !given_q[!fill_q]));
    if (!Whole) begin
      for (int unsigned s = 0; s < 2; s += 1) begin
        assert (!valid_q[s] || (known(place_q[s]) && ends_q[s] == ends_at(place_q[s])));
      end
      assert (!more_q || !filled_q || known(newest));
      assert (more_q || (walk_at(place) == 3'd0 && eye_at(place) == 2'd0));
      if (more_q && !judges_q) assert (known(place) && follows(filled_q, newest, given_q[!fill_q], place));
    end
  end
end
