// SPDX-License-Identifier: Apache-2.0
// The end of rtl/list/pipegs_list_read.sv in its proof: every window's list is read once, and each record goes to one
// SU, an end to all.
//
// Idea    pipegs_line_reader shows what it likes (free_line_reader); any one SU is watched.
// Rule    The windows are counted from 0 to the frame's last, and no count leaves that range; a record goes to one SU,
//         an end to every one; nobody sees a record twice, and what is shown stays until taken.
// Assumes A frame has at least one window and at most 2^ListWindowW; it starts when nothing is inside.

(* anyconst *) logic [$clog2(Units + 1)-1:0] su;
logic             end_q;    // the record shown is an end
logic [LeftW-1:0] total_q;             // windows of the frame, less one
logic [Units-1:0] others;

proof_reset u_proof_reset (.clk_i, .rst_ni);
proof_hold #(.DataW(SplatBits)) u_hold (
  .clk_i, .rst_ni, .valid_i(splat_valid_o[su]), .ready_i(splat_ready_i[su]), .beat_i(splat_o)
);
assign others = waiting_q & (waiting_q - 1'b1);
always_ff @(posedge clk_i) begin
  if (give) end_q <= !item_read;
  if (start_i) total_q <= windows - 1'b1;
end
always_comb begin
  assume (32'(su) < Units);
  assume (windows_i.first_x <= windows_i.last_x && windows_i.first_y <= windows_i.last_y);
  assume (!start_i || (windows != '0 && windows <= LeftW'(1) << NumberW));
  assume (!start_i || !busy_o);
  if (rst_ni) begin
    assert (end_q || others == '0);
    assert (!give || (waiting_q & ~splat_ready_i) == '0);
    assert (!give || !item_read || (target != '0 && (target & (target - 1'b1)) == '0));
    if (state_q != StateIdle) begin
      assert (total_q < LeftW'(1) << NumberW && (LeftW+1)'(number_q) + (LeftW+1)'(left_q) == (LeftW+1)'(total_q));
    end
  end
end
