// SPDX-License-Identifier: Apache-2.0
// The end of rtl/list/pipegs_list_write.sv in its proof: the records of a window lie one behind another, none over
// another.
//
// Idea    Any one window, of the solver's choice, is followed: the records taken of it are counted beside the module.
//         The SRAM of the counts stands outside: of the window's count it is assumed that a read shows what was written
//         before, and nothing of a read in the cycle of a write.
// Rule    The line of a record of the window is the list's beginning plus the records before it in this frame; a line
//         shown stays until taken; the counts of all windows are cleared before the first record is taken. No line is
//         shown that lies outside the area of the lists or in the list of another window.
// Assumes The SRAM's rule (proof `sram`). A frame begins when nothing is inside; the numbers of windows are the
//         frame's; its windows and its area are constant, the area begins at line 0.
// Invariant  The count is in the SRAM, one less than the records taken while the last of them is still held. As many
//         lists as there are windows fit the area, or none has room.

(* anyconst *) logic [NumberW-1:0] window;
(* anyconst *) logic [AddressW-1:0] lines;
(* anyconst *) logic [LeftW-1:0] all;
(* hierconn *) logic [NumberW+1+EntryW:0] \u_room.twice_q ;
(* hierconn *) logic [AddressW:0] \u_room.gaps_q ;
logic [AddressW-1:0] area, gaps, begins;  // gaps: lines between all lists; begins: the list of the line shown
logic [NumberW-1:0]  moved_number_q;  // of the record that moved last
logic [EntryW-1:0] taken_q, stored_q, shown_q, expected;
logic              shows_q, takes, held_here, started_q;  // shows_q: the SRAM shows the window's count
logic [AddressW-1:0] list, at_q;    // at_q: where the record that moved last belongs, if it is of the window
logic                moved_q;

proof_reset u_proof_reset (.clk_i, .rst_ni);
proof_hold #(.DataW(AddressW)) u_hold (
  .clk_i, .rst_ni, .valid_i(mem_valid_o), .ready_i(mem_ready_i), .beat_i(mem_address_o)
);

assign takes     = take && number == window;
assign held_here = held_valid_q && held_number_q == window;
assign list      = pipegs_pkg::list_first(window, log_o);
assign gaps      = AddressW'(windows) * AddressW'(pipegs_pkg::ListGap);
assign begins    = pipegs_pkg::list_first(moved_number_q, log_o);
assign area      = pipegs_pkg::area_lines(overflow_i.lines, pipegs_pkg::AreaLists);
assign expected  = held_here ? taken_q - 1'b1 : taken_q;
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    taken_q   <= '0;
    started_q <= 1'b0;
    shows_q   <= 1'b0;
    moved_q   <= 1'b0;
  end else begin
    if (restart_i) taken_q <= '0;
    else if (takes) taken_q <= taken_q + 1'b1;
    if (restart_i) started_q <= 1'b1;
    if (move) moved_q <= held_here;
    if (count_read_o) shows_q <= count_number_o == window && !(count_write_o && count_at_o == window);
  end
end
always_ff @(posedge clk_i) begin
  if (count_write_o && count_at_o == window) stored_q <= count_o;
  if (count_read_o) shown_q <= stored_q;
  if (move) moved_number_q <= held_number_q;
  if (move) at_q <= list + AddressW'(expected);
end

always_comb begin
  assume (!shows_q || count_i == shown_q);
  assume (overflow_i.first == '0 && overflow_i.lines == lines && windows == all);
  assume (windows_i.first_x <= windows_i.last_x && windows_i.first_y <= windows_i.last_y);
  assume (windows <= LeftW'(1) << NumberW && LeftW'(window) < windows);
  assume (!restart_i || !(clearing || held_valid_q || out_valid_q || take));
  assume (started_q || splat_valid_i == '0);
  assume (!take || LeftW'(number) < windows);
  if (rst_ni) begin
    assert (!mem_valid_o || (address_q < area && address_q >= begins && (address_q - begins) >> log_o == '0));
    assert (!held_valid_q || LeftW'(held_number_q) < windows);
    assert (!out_valid_q || LeftW'(moved_number_q) < windows);
    assert (!started_q || \u_room.gaps_q == (AddressW+1)'(gaps));
    assert (!started_q || none == (AddressW'(windows) + gaps > area));
    assert (!started_q || none || (AddressW'(windows) << log_o) + gaps <= area);
    assert (!started_q || (\u_room.twice_q == ((NumberW+EntryW+2)'(windows) << log_o) << 1 && 32'(log_o) <= EntryW));
    assert (!started_q || !none || log_o == '0);
    assert (left_q <= LeftW'(1) << NumberW);
    assert (!take || (!clearing && roomy));
    assert (splat_ready_o == ((take ? source : '0) | is_end));
    assert (!moved_q || full_q || address_q == at_q);
    // invariants
    assert (!(held_valid_q || out_valid_q) || (started_q && !clearing && roomy));
    assert (!clearing || taken_q == '0);
    assert (!clearing || LeftW'(window) < left_q || stored_q == '0);
    assert (!started_q || clearing || stored_q == expected);
    if (held_here) begin
      assert (same_q ? kept_q == expected : (shows_q && shown_q == expected));
    end
  end
end
