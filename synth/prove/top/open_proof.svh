// SPDX-License-Identifier: Apache-2.0
// The end of rtl/pipegs_open.sv in its proof: the rectangle of a walk holds each of its open regions, and only shrinks.
//
// Rule    Any region that its owner has not closed lies in the rectangle of its walk, said a cycle later and of the
//         window that all RUs are in. While they stay in it no count falls, unless no region of the walk is open any
//         more; then nothing is said.
// Assumes Within a window an RU opens no region again.

(* anyconst *) logic [$clog2(Regions)-1:0] region;
(* anyconst *) logic [3:0]                 walk;  // 0 the window, 1 to 8 a part, 9 and 10 the window for one eye
localparam int unsigned Walks = pipegs_pkg::WalkEyeW != 0 ? 11 : 5;
localparam int unsigned WindowW = pipegs_pkg::WindowW;
localparam int unsigned DoneW   = Units * Regions;
localparam int unsigned PlaceAt = Units * WindowW;
logic [DoneW+2*PlaceAt-1:0] progress, progress_before_q;  // windows above what is done
assign progress = progress_i;
pipegs_pkg::open_t     open_before_q;
logic                  two_q;  // what was before is what came in
logic [Walks*Bits-1:0] all, all_before_q;
logic [Bits-1:0]       now, before;
logic                  whole;
logic [31:0]           number, in_part, x, y, side;  // of the region: its part, its place in the walk
logic                  region_open_q, in_walk, some_q, same;

proof_reset u_proof_reset (.clk_i, .rst_ni);

assign number  = 32'(region) / MaskW;
assign in_part = 32'(region) % MaskW;
function automatic logic has_part(input logic [31:0] part);
  has_part = walk == 4'd0 || (walk <= 4'd8 ? 32'(walk) == part + 1 && pipegs_pkg::HasWalks
                                           : 32'(walk) == part / Squares + 9);
endfunction
assign in_walk = has_part(number);
assign whole   = walk == 4'd0 || walk > 4'd8;
assign side    = whole ? SideX : PartX;
assign x       = (whole ? number % PartsX * PartX : 0) + in_part % PartX;
assign y       = (whole ? number % Squares / PartsX * PartX : 0) + in_part / PartX;
if (pipegs_pkg::WalkEyeW != 0) begin : gen_all_eyes
  assign all = {open_q.eye_1, open_q.eye_0, open_q.part_7, open_q.part_6, open_q.part_5, open_q.part_4,
                open_q.part_3, open_q.part_2, open_q.part_1, open_q.part_0, open_q.whole};
end else begin : gen_all
  assign all = {open_q.part_3, open_q.part_2, open_q.part_1, open_q.part_0, open_q.whole};
end
assign now    = all[32'(walk)*Bits +: Bits];
assign before = all_before_q[32'(walk)*Bits +: Bits];

logic region_open, some;
always_comb begin
  region_open = 1'b1;
  some        = 1'b0;
  for (int unsigned j = 0; j < Units; j += 1) begin
    if ((in_part % PartX + Units / 2 * (in_part / PartX)) % Units == j && progress[j*Regions + 32'(region)])
      region_open = 1'b0;
  end
  for (int unsigned r = 0; r < Regions; r += 1) begin
    if (whole ? has_part(r / MaskW) : r / MaskW + 1 == 32'(walk)) some |= open[r];
  end
end
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    two_q         <= 1'b0;
    region_open_q <= 1'b0;
    some_q        <= 1'b0;
    open_before_q <= '0;
    all_before_q  <= '0;
  end else begin
    two_q         <= 1'b1;
    region_open_q <= region_open;
    some_q        <= some;
    open_before_q <= open_q;
    all_before_q  <= all;
  end
end
always_ff @(posedge clk_i) progress_before_q <= progress;

assign same = progress[DoneW +: 2*PlaceAt] == progress_before_q[DoneW +: 2*PlaceAt];
always_comb begin
  assume (32'(region) < Regions);
  assume (32'(walk) < Walks);
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
