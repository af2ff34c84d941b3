// SPDX-License-Identifier: Apache-2.0
// The end of rtl/su/sort/su_bitonic.sv in the proof of its cells at the widths of the machine.
//
// Idea    The proof `su_bitonic` sorts narrow keys. What it says of z, keys against any threshold, it says of wide keys
//         too, if a stage moves z as there: whatever the threshold, a cell leaves the AND of both z on one side and the
//         OR on the other, as its direction asks. Cell and threshold are the solver's choice.
// Rule    The two items of a cell stay as they are or are exchanged, whole; z(low side) = AND, z(high side) = OR.

localparam int unsigned ProofValueW = pipegs_pkg::KeyW + 1;  // {void, key}
(* anyconst *) logic [ProofValueW-1:0]   threshold;
(* anyconst *) logic [$clog2(Cells)-1:0] cell_number;
logic [2*ItemW-1:0]  before, behind;
logic [ChannelW-1:0] channel;
logic                down, za, zb, z_first, z_second;

assign before   = items_q[cell_number*2*ItemW +: 2*ItemW];
assign behind   = exchanged[cell_number*2*ItemW +: 2*ItemW];
assign za       = before[ItemW-1 -: ProofValueW] > threshold;
assign zb       = before[2*ItemW-1 -: ProofValueW] > threshold;
assign z_first  = behind[ItemW-1 -: ProofValueW] > threshold;
assign z_second = behind[2*ItemW-1 -: ProofValueW] > threshold;
always_comb begin
  unique case (distance_q)  // the channel in the cell's first place: places are channels rotated right by the distance
    2'd0:    channel = {cell_number, 1'b0};
    2'd1:    channel = {cell_number[1:0], 1'b0, cell_number[2]};
    2'd2:    channel = {cell_number[0], 1'b0, cell_number[2:1]};
    default: channel = {1'b0, cell_number};
  endcase
  down = size_q < (DistanceW+1)'(ChannelW) && channel[size_q[DistanceW-1:0]];
end

always_comb begin
  if (size_q > '0 && size_q <= (DistanceW+1)'(ChannelW) && {1'b0, distance_q} < size_q) begin
    assert (z_first == (down ? za || zb : za && zb));
    assert (z_second == (down ? za && zb : za || zb));
    assert (behind == before || behind == {before[ItemW-1:0], before[2*ItemW-1:ItemW]});
  end
end
