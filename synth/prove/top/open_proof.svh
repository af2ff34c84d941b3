// SPDX-License-Identifier: Apache-2.0
// The end of rtl/pipegs_open.sv in its proof: the rectangle of a walk holds each of its open regions, and only shrinks.
//
// Rule    Any region that its owner has not closed lies in the rectangle of its walk, said a cycle later and of the
//         window that all RUs are in. While they stay in it no count falls, unless no region of the walk is open any
//         more; then nothing is said.
// Assumes Within a window an RU opens no region again.

(* anyconst *) logic [$clog2(Regions)-1:0] region;
(* anyconst *) logic [2:0]                 walk;  // 0 the window, 1 to 4 a part
localparam int unsigned WindowW = pipegs_pkg::WindowW;
localparam int unsigned DoneW   = Units * Regions;
localparam int unsigned PlaceAt = Units * WindowW;
logic [DoneW+2*PlaceAt-1:0] progress, progress_before_q;  // windows above what is done
assign progress = progress_i;
pipegs_pkg::open_t     open_before_q;
logic                  two_q;  // what was before is what came in
logic [Bits-1:0]       now, before;
logic [31:0]           number, in_part, x, y, side;  // of the region: its part, its place in the walk
logic                  region_open_q, in_walk, some_q, same;

proof_reset u_proof_reset (.clk_i, .rst_ni);

assign number  = 32'(region) / MaskW;
assign in_part = 32'(region) % MaskW;
assign in_walk = walk == 3'd0 || (32'(walk) == number + 1 && pipegs_pkg::HasWalks);
assign side    = walk == 3'd0 ? SideX : PartX;
assign x       = (walk == 3'd0 ? number % PartsX * PartX : 0) + in_part % PartX;
assign y       = (walk == 3'd0 ? number / PartsX * PartX : 0) + in_part / PartX;

logic region_open, some;
always_comb begin
  region_open = 1'b1;
  some        = 1'b0;
  for (int unsigned j = 0; j < Units; j += 1) begin
    if ((in_part % PartX + Units / 2 * (in_part / PartX)) % Units == j && progress[j*Regions + 32'(region)])
      region_open = 1'b0;
  end
  for (int unsigned r = 0; r < Regions; r += 1) begin
    if (walk == 3'd0 || r / MaskW + 1 == 32'(walk)) some |= open[r];
  end
  case (walk)
    3'd1: {now, before} = {open_q.part_0, open_before_q.part_0};
    3'd2: {now, before} = {open_q.part_1, open_before_q.part_1};
    3'd3: {now, before} = {open_q.part_2, open_before_q.part_2};
    3'd4: {now, before} = {open_q.part_3, open_before_q.part_3};
    default: {now, before} = {open_q.whole, open_before_q.whole};
  endcase
end
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    two_q         <= 1'b0;
    region_open_q <= 1'b0;
    some_q        <= 1'b0;
    open_before_q <= '0;
  end else begin
    two_q         <= 1'b1;
    region_open_q <= region_open;
    some_q        <= some;
    open_before_q <= open_q;
  end
end
always_ff @(posedge clk_i) progress_before_q <= progress;

assign same = progress[DoneW +: 2*PlaceAt] == progress_before_q[DoneW +: 2*PlaceAt];
always_comb begin
  assume (32'(region) < Regions);
  assume (walk <= 3'd4);
  assume (!rst_ni || !two_q || !same || (progress_before_q[0 +: DoneW] & ~progress[0 +: DoneW]) == '0);
  if (rst_ni && open_q.known) begin
    if (in_walk && region_open_q) begin
      assert (x >= 32'(now[0 +: ClosedW]) && x + 32'(now[ClosedW +: ClosedW]) < side);
      assert (y >= 32'(now[2*ClosedW +: ClosedW]) && y + 32'(now[3*ClosedW +: ClosedW]) < side);
    end
    if (!some_q) assert (now == '0);
    if (some_q && open_before_q.known && open_before_q.window_x == open_q.window_x &&
        open_before_q.window_y == open_q.window_y) begin
      for (int unsigned i = 0; i < 4; i += 1)
        assert (now[i*ClosedW +: ClosedW] >= before[i*ClosedW +: ClosedW]);
    end
  end
  // invariants
  if (rst_ni && two_q) begin
    for (int unsigned j = 0; j < Units; j += 1) begin
      assert (!open_q.known || (progress_before_q[DoneW + j*WindowW +: WindowW] == open_q.window_x &&
                                progress_before_q[DoneW + PlaceAt + j*WindowW +: WindowW] == open_q.window_y));
    end
  end
end
