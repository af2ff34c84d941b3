// SPDX-License-Identifier: Apache-2.0
// The end of rtl/ru/ru_fetch.sv in its proof: every line that was asked for has room when it comes.
//
// Rule    Lines from the memory in flight or waiting are at most FetchLines, local ones at most LocalLines; no queue
//         refuses a line; a record shown stays, with its line.
// Assumes The memory answers what was asked for, pipegs_alpha_store in the second cycle (its proof), a line that is
//         skipped not at all; ru_walk holds what it shows (its proof), and skips lines of stores only.
// Invariant  An external line is asked for and not answered, or in its queue; of a line in two parts the first is asked
//         for and answered first.

(* hierconn *) logic [FetchW-1:0] \gen_outside.u_external.held_q ;
(* hierconn *) logic [RecordsW-1:0] \u_records.held_q ;
localparam int unsigned PartW = FetchW + 3;
logic [PartW-1:0] parts_q;  // parts asked for and not answered
logic             ask_part, rsp_part;

proof_reset u_proof_reset (.clk_i, .rst_ni);
proof_hold #(.DataW(pipegs_pkg::BlendBits)) u_hold_out (
  .clk_i, .rst_ni, .valid_i(out_valid_o), .ready_i(out_ready_i), .beat_i(out_o)
);
proof_hold #(.DataW(LineW)) u_hold_line (
  .clk_i, .rst_ni, .valid_i(out_valid_o && out_o.kind == pipegs_pkg::KindData), .ready_i(out_ready_i),
  .beat_i(out_line_o)
);
proof_hold #(.DataW(AddressW)) u_hold_mem (
  .clk_i, .rst_ni, .valid_i(mem_valid_o), .ready_i(mem_ready_i), .beat_i(mem_address_o)
);
proof_hold #(.DataW(pipegs_pkg::FetchBits), .Assumed(1'b1)) u_hold_in (
  .clk_i, .rst_ni, .valid_i(in_valid_i), .ready_i(in_ready_o), .beat_i(in_i)
);
(* anyconst *) logic [2*AddressW-1:0] overflow;
for (genvar i = 0; i < Units; i += 1) begin : gen_proof_base
  always_comb if (rst_ni) begin
    assert (gen_outside.base_q[i] == overflow_i.first +
            pipegs_pkg::area_first(overflow_i.lines, pipegs_pkg::UnitW'(i), pipegs_pkg::AreaEven));
  end
end

if (Parts == 1) begin : gen_proof_one
  assign {ask_part, rsp_part} = '0;
end else begin : gen_proof_two
  assign ask_part = gen_outside.gen_two_parts.ask_part_q;
  assign rsp_part = gen_outside.gen_two_parts.rsp_part_q;
end
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) parts_q <= '0;
  else parts_q <= parts_q + PartW'(mem_valid_o && mem_ready_i) - PartW'(rsp_valid_i);
end

always_comb begin
  assume (overflow_i == overflow);
  assume (!rsp_valid_i || parts_q != '0);
  assume ((answer_valid_i != '0) == asked_q[1]);
  assume (!in_i.skip || !in_i.ext);
  if (rst_ni) begin
    assert (gen_outside.external_q <= FetchW'(FetchLines));
    assert (!gen_outside.external_push || gen_outside.external_ready);
    assert (answer_valid_i == '0 || local_ready);
    assert (local_count <= LocalW'(LocalLines));
    assert (!fire || skip || record_ready);
    // invariants
    assert (local_count + LocalW'(asked_q[0]) + LocalW'(asked_q[1]) <= LocalW'(LocalLines));
    assert (PartW'(parts_q) + PartW'(Parts) * PartW'(\gen_outside.u_external.held_q ) + PartW'(rsp_part) ==
            PartW'(Parts) * PartW'(gen_outside.external_q) + PartW'(ask_part));
    assert (32'(parts_q) <= Parts * FetchLines);
    assert (!ask_part || (in_valid_i && is_data && ext && gen_outside.external_q != FetchW'(FetchLines)));
    assert (!ask_part || \u_records.held_q != RecordsW'(Records));
  end
end
