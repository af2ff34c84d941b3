// SPDX-License-Identifier: Apache-2.0
// The end of rtl/su/su_port.sv in its proof: every line asked for has room when it comes.
//
// Rule    Lines asked for and not used are at most Answers, so the store never refuses an answer; what the memory is
//         shown stays until it is taken; of those who ask, only the one shown is told that it was taken. Whatever lines
//         are asked for, none is shown that lies outside the area of its kind in the unit's share.
// Assumes The memory answers what was asked for; each who asks holds its request (proof_hold); with a line its owner is
//         shown, whose queue is filled before (asserted in simulation). The overflow area and the unit are constant.
// Invariant  A line in flight was asked for and not answered, or it is in the store.

(* hierconn *) logic [FlightW-1:0] \u_answers.held_q ;
(* hierconn *) logic [FlightW-1:0] \u_owners.held_q ;
(* anyconst *) logic [2*AddressW-1:0] overflow;
(* anyconst *) logic [pipegs_pkg::UnitW-1:0] unit;
logic [AddressW-1:0]          at;      // of the line shown, in its area

proof_reset u_proof_reset (.clk_i, .rst_ni);
proof_hold #(.DataW(1 + pipegs_pkg::AddressW)) u_hold (
  .clk_i, .rst_ni, .valid_i(mem_valid_o), .ready_i(mem_ready_i), .beat_i({mem_write_o, mem_address_o})
);
proof_hold #(.DataW(pipegs_pkg::MemoryW)) u_hold_data (
  .clk_i, .rst_ni, .valid_i(mem_valid_o && mem_write_o), .ready_i(mem_ready_i), .beat_i(mem_data_o)
);
proof_hold #(.DataW(pipegs_pkg::SplatBits), .Assumed(1'b1)) u_hold_record (
  .clk_i, .rst_ni, .valid_i(record_valid_i), .ready_i(record_ready_o), .beat_i(record_i)
);
proof_hold #(.DataW(pipegs_pkg::MemoryW), .Assumed(1'b1)) u_hold_keys (
  .clk_i, .rst_ni, .valid_i(keys_valid_i), .ready_i(keys_ready_o), .beat_i(keys_i)
);
proof_hold #(.DataW(pipegs_pkg::MemoryW), .Assumed(1'b1)) u_hold_run (
  .clk_i, .rst_ni, .valid_i(run_valid_i), .ready_i(run_ready_o), .beat_i(run_i)
);
proof_hold #(.DataW(WayW), .Assumed(1'b1)) u_hold_fetch (
  .clk_i, .rst_ni, .valid_i(fetch_valid_i), .ready_i(fetch_ready_o), .beat_i(fetch_way_i)
);
proof_hold #(.DataW(1), .Assumed(1'b1)) u_hold_read (
  .clk_i, .rst_ni, .valid_i(read_valid_i), .ready_i(read_ready_o), .beat_i(1'b0)
);

assign at = mem_address_o - overflow_i.first - pipegs_pkg::area_first(overflow_i.lines, unit_i, area_q);

always_comb begin
  assume (overflow_i == overflow && unit_i == unit);
  assume (!rsp_valid_i || await_q != '0);
  assume (!line_valid_o || owner_valid);
  if (rst_ni) begin
    assert (!mem_valid_o || at < pipegs_pkg::area_lines(overflow_i.lines, area_q));
    assert (!mem_valid_o || (at == AddressW'(line_q) && line_q != '1));
    assert (choice_q == None || area_q == pipegs_pkg::AreaKeys || area_q == pipegs_pkg::AreaMerged ||
            area_q == pipegs_pkg::AreaRuns || area_q == pipegs_pkg::AreaRecords);
    assert ((choice_q != Record && choice_q != Read) || area_q == pipegs_pkg::AreaRecords);
    assert (choice_q != Keys || area_q == pipegs_pkg::AreaKeys);
    assert (choice_q != Run || area_q == pipegs_pkg::AreaMerged || area_q == pipegs_pkg::AreaRuns);
    assert (choice_q != Fetch || area_q != pipegs_pkg::AreaRecords);
    assert (share_q == overflow_i.first + pipegs_pkg::area_first(overflow_i.lines, unit_i, pipegs_pkg::AreaKeys));
    assert (flight_q <= FlightW'(Answers));
    assert (!rsp_valid_i || unused_queue_ready);
    assert (!asked || unused_owner_ready);
    assert (3'(record_ready_o) + 3'(keys_ready_o) + 3'(run_ready_o) + 3'(fetch_ready_o) + 3'(read_ready_o) ==
            3'(taken));
    assert ((record_valid_i || !record_ready_o) && (keys_valid_i || !keys_ready_o) && (run_valid_i || !run_ready_o) &&
            (fetch_valid_i || !fetch_ready_o) && (read_valid_i || !read_ready_o));
    // invariants
    assert (choice_q <= Read);  // of eight codes six are choices
    assert ((FlightW+1)'(flight_q) == (FlightW+1)'(await_q) + (FlightW+1)'(\u_answers.held_q ));
    assert ((choice_q != Fetch && choice_q != Read) || flight_q != FlightW'(Answers));
    assert (flight_q == \u_owners.held_q );
    assert (choice_q != Record || record_valid_i);
    assert (choice_q != Keys || keys_valid_i);
    assert (choice_q != Run || run_valid_i);
    assert (choice_q != Fetch || fetch_valid_i);
    assert (choice_q != Read || read_valid_i);
  end
end
