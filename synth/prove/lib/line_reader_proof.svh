// SPDX-License-Identifier: Apache-2.0
// The end of rtl/lib/pipegs_line_reader.sv in its proof: no line without its place, and both ports keep the stream
// contract.
//
// Rule    Lines are asked for only when their places in the buffer are kept free, so an answer is never refused; they
//         lie in one aligned group, and belong to the job; address and number of lines stay until the memory takes
//         them, the item shown until it is taken; no item beyond the count of its job. No line is asked for that lies
//         outside the table, whatever the jobs name; behind a bad job none is.
// Assumes The memory answers what was asked for; the table is constant and ends where the memory does or before; a job
//         that reads shows an item only when it names one, since a bad one has no lines (the queue of jobs changes
//         nothing, proof `fifo`).
// Invariant  Every place is free (a credit), asked for or stored; the ring's ends are apart by the lines stored.

logic [CreditW-1:0] flight_q;  // lines asked for and not answered
logic [PtrW-1:0]    ring_end;
localparam int unsigned AddressW = pipegs_pkg::AddressW;

proof_reset u_proof_reset (.clk_i, .rst_ni);
proof_hold #(.DataW(pipegs_pkg::AddressW + BurstW)) u_hold_mem (
  .clk_i, .rst_ni, .valid_i(mem_valid_o), .ready_i(mem_ready_i), .beat_i({mem_address_o, mem_lines_o})
);
proof_hold #(.DataW(2 + IndexW + TagW)) u_hold_out (
  .clk_i, .rst_ni, .valid_i(out_valid_o), .ready_i(out_ready_i),
  .beat_i({out_read_o, out_index_o, out_last_o, out_tag_o})
);
proof_hold #(.DataW(ItemW)) u_hold_item (
  .clk_i, .rst_ni, .valid_i(out_valid_o && out_read_o), .ready_i(out_ready_i), .beat_i(out_item_o)
);
proof_hold #(.DataW(2 * AddressW), .Assumed(1'b1)) u_hold_table (
  .clk_i, .rst_ni, .valid_i(1'b1), .ready_i(1'b0), .beat_i(table_i)
);

always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) flight_q <= '0;
  else flight_q <= flight_q + (issue ? CreditW'(mem_lines_o) + CreditW'(1) : CreditW'(0)) - CreditW'(rsp_valid_i);
end

assign ring_end = head_q + stored_q[PtrW-1:0];
always_comb begin
  assume (!rsp_valid_i || flight_q != '0);
  assume (!(job_valid && job_read && line_valid_q) || job_count != '0);
  assume ((AddressW+1)'(table_i.first) + (AddressW+1)'(table_i.lines) <= (AddressW+1)'(1) << AddressW);
  if (rst_ni) begin
    assert (!mem_valid_o || (mem_address_o >= table_i.first && mem_address_o - table_i.first < table_i.lines));
    assert (!bad_q || (lines_left_q == '0 && !take));
    assert (lines_left_q == '0 || (line_q >= table_i.first && (MostW+1)'(line_q - table_i.first) +
            (MostW+1)'(lines_left_q) <= (MostW+1)'(table_i.lines)));
    assert (!rsp_valid_i || stored_q < CreditW'(Lines));
    assert (!(take && job_read_i && !bad) || (lines != '0 && lines <= (CountW+1)'(job_count_i) + (CountW+1)'(Place)));
    assert (lines_left_q <= (CountW+1)'(1) << CountW);
    assert (!(out_valid_o && out_read_o) || item_q < job_count);
    assert (idle_o == !job_valid);
    assert (!mem_valid_o || (BurstW+1)'(mem_address_o[BurstW-1:0]) + (BurstW+1)'(mem_lines_o) < (BurstW+1)'(2**BurstW));
    assert (!mem_valid_o || (CountW+1)'(mem_lines_o) < lines_left_q);
    // invariants
    assert (asks_q == (lines_left_q != '0 && credits_q >= CreditW'(Group)));
    assert (credits_q <= CreditW'(Lines) && stored_q <= CreditW'(Lines) && flight_q <= CreditW'(Lines));
    assert ((CreditW+2)'(credits_q) + (CreditW+2)'(stored_q) + (CreditW+2)'(flight_q) == (CreditW+2)'(Lines));
    assert (tail_q == ring_end);
    assert (item_q == '0 || (job_valid && job_read && item_q < job_count));
  end
end
