// SPDX-License-Identifier: Apache-2.0
// The end of rtl/dopu/dopu_windows.sv in its proof: two sets of planes take turns, filled, walked and released in that
// order.
//
// Rule    A set holds its window and its planes from the cycle in which it shows until it is released; the windows are
//         walked row by row, each once, the last one marked; a set is called done only if every region of its own
//         window was done in the cycle before: never on account of a window that it held earlier.
// Assumes Of dopu_planes the rule of free_planes; of the walk: a set is walked when it shows, released in turn when
//         walked; a frame begins when no set is held, and stays.
// Invariant  The sets held (walked or not) lie between the turns of release and of filling; the window to fill next is
//         as many steps ahead of the one to walk next as there are sets to walk.

localparam int unsigned PlaneBit = $clog2(PlanesW);
(* hierconn *) logic \u_planes.inside_q ;
(* anyconst *) logic [$clog2(Regions)-1:0] region;
(* anyconst *) logic [PlaneBit-1:0]        place;
logic [1:0]         held_q, to_walk_q;  // sets filled and not released; not walked
logic               left_q;             // windows are left to walk
logic [WindowW-1:0] walk_x_q, walk_y_q, set_x_before_q [2], set_y_before_q [2];
logic [1:0]         valid_before_q, last_before_q, bit_before_q, region_before_q, planes_bit, region_now;
logic               last_walk;
pipegs_pkg::rotation_t rotation_before_q;
pipegs_pkg::lens_t     lens_before_q;
pipegs_pkg::raster_t   raster_before_q;
logic frame_stays;
assign frame_stays = rotation_i == rotation_before_q && lens_i == lens_before_q && raster_i == raster_before_q;

proof_reset u_proof_reset (.clk_i, .rst_ni);

function automatic logic [2*WindowW-1:0] proof_next(input logic [2*WindowW-1:0] window);  // {y, x}
  proof_next = window[WindowW-1:0] == raster_i.windows.last_x
             ? {window[2*WindowW-1:WindowW] + 1'b1, raster_i.windows.first_x}
             : {window[2*WindowW-1:WindowW], window[WindowW-1:0] + 1'b1};
endfunction

logic fill;
logic [2*WindowW-1:0] walk, frame_last;
assign walk       = {walk_y_q, walk_x_q};
assign frame_last = {raster_i.windows.last_y, raster_i.windows.last_x};
assign fill       = planes_valid && planes_ready;
assign last_walk  = Whole || walk == frame_last;
always_comb begin
  for (int unsigned s = 0; s < 2; s += 1) begin
    planes_bit[s] = planes_o[s*PlanesW + 32'(place)];
    region_now[s] = 1'b0;
    for (int unsigned u = 0; u < Units; u += 1) begin
      if (done_x_i[u*WindowW +: WindowW] == set_x_o[s*WindowW +: WindowW] &&
          done_y_i[u*WindowW +: WindowW] == set_y_o[s*WindowW +: WindowW] && done_i[u*Regions + 32'(region)])
        region_now[s] = 1'b1;
    end
  end
end

always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    held_q         <= '0;
    to_walk_q      <= '0;
    left_q         <= 1'b0;
    valid_before_q <= '0;
  end else begin
    held_q         <= held_q + 2'(fill) - 2'(release_i);
    to_walk_q      <= to_walk_q + 2'(fill) - 2'(walked_i);
    left_q         <= start_i || (left_q && !(walked_i && last_walk));
    valid_before_q <= valid_q;
    if (release_i) valid_before_q[oldest_q] <= 1'b0;
  end
end
always_ff @(posedge clk_i) begin
  rotation_before_q <= rotation_i;
  lens_before_q     <= lens_i;
  raster_before_q   <= raster_i;
  if (start_i) {walk_y_q, walk_x_q} <= {raster_i.windows.first_y, raster_i.windows.first_x};
  else if (walked_i) {walk_y_q, walk_x_q} <= proof_next(walk);
  for (int unsigned s = 0; s < 2; s += 1) begin
    set_x_before_q[s] <= set_x_o[s*WindowW +: WindowW];
    set_y_before_q[s] <= set_y_o[s*WindowW +: WindowW];
  end
  last_before_q   <= set_last_o;
  bit_before_q    <= planes_bit;
  region_before_q <= region_now;
end

logic idle;
assign idle = !left_q && held_q == '0;
always_comb begin
  assume ({1'b0, place} < (PlaneBit+1)'(PlanesW));
  assume (!rst_ni || !start_i || idle);
  assume (!rst_ni || idle || frame_stays);
  assume (!rst_ni || !walked_i || set_valid_o[walk_q]);
  assume (!rst_ni || !release_i || held_q > to_walk_q);
  if (rst_ni) begin
    assert (held_q <= 2'd2 && to_walk_q <= held_q);
    for (int unsigned s = 0; s < 2; s += 1) begin
      if (valid_before_q[s]) begin
        assert (set_x_o[s*WindowW +: WindowW] == set_x_before_q[s] &&
                set_y_o[s*WindowW +: WindowW] == set_y_before_q[s]);
        assert (set_last_o[s] == last_before_q[s] && planes_bit[s] == bit_before_q[s]);
      end
      assert (!set_done_o[s] || (valid_before_q[s] && region_before_q[s]));
    end
    if (set_valid_o[walk_q]) begin
      assert (left_q && set_last_o[walk_q] == last_walk);
      if (!Whole) assert ({set_y_o[walk_q*WindowW +: WindowW], set_x_o[walk_q*WindowW +: WindowW]} == walk);
    end
    assert ((set_valid_o != '0) == (to_walk_q != '0) && set_valid_o[walk_q] == (to_walk_q != '0));
    // invariants
    assert (valid_q == (held_q == 2'd0 ? 2'b00 : held_q == 2'd2 ? 2'b11 : oldest_q ? 2'b10 : 2'b01));
    assert (fresh_q == (to_walk_q == 2'd0 ? 2'b00 : to_walk_q == 2'd2 ? 2'b11 : walk_q ? 2'b10 : 2'b01));
    assert (fill_q == oldest_q ^ held_q[0] && fill_q == walk_q ^ to_walk_q[0]);
    for (int unsigned s = 0; s < 2; s += 1) assert (!valid_before_q[s] || valid_q[s]);
    assert (asking_q == \u_planes.inside_q && (!asking_q || more_q));
    assert (left_q == (more_q || to_walk_q != '0));
    if (Whole) begin
      assert (to_walk_q <= 2'd1 && (!left_q || more_q == (to_walk_q == 2'd0)));
      assert (to_walk_q == '0 || last_q[walk_q]);
    end else begin
      if (more_q && to_walk_q == 2'd0) assert ({y, x} == walk);
      if (more_q && to_walk_q == 2'd1) assert ({y, x} == proof_next(walk));
      if (more_q && to_walk_q == 2'd2) assert ({y, x} == proof_next(proof_next(walk)));
      if (to_walk_q != 2'd0) begin
        assert ({set_y_q[walk_q], set_x_q[walk_q]} == walk && last_q[walk_q] == (walk == frame_last));
        assert (more_q == (to_walk_q == 2'd1 ? !last_q[walk_q] : !last_q[!walk_q]));
      end
      if (to_walk_q == 2'd2) begin
        assert (walk != frame_last && last_q[!walk_q] == (proof_next(walk) == frame_last));
        assert ({set_y_q[!walk_q], set_x_q[!walk_q]} == proof_next(walk));
      end
    end
  end
end
