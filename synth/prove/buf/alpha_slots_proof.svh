// SPDX-License-Identifier: Apache-2.0
// The end of rtl/buf/pipegs_alpha_store.sv in its proof: every reader gets what was written, though slots change hands.
//
// Idea    One bit of one address, of the solver's choice, is remembered. A small store, of which every word is seen.
// Rule    Two cycles after a line was asked for the answer shows what was written last to its address.
// Assumes Of pu_allocate (its proof): an address is written again only after its line was read or skipped. Of the RUs:
//         each line is read or skipped once, after it was written. Of pipegs_slot_pool (its proof, free_slot_pool): it
//         hands out no slot in use.
// Invariant  Lines that live have slots of their own, all in use; what is remembered stands in the line's slot.
// Not said  That a slot is free when a line comes: the Row Units between pu_allocate and here take longer than the
//           pool, see the module's own assertion.

localparam int unsigned Addresses = pipegs_pkg::AlphaAddresses;
(* hierconn *) logic [Addresses*SlotW-1:0] \u_slots.words ;
(* hierconn *) logic [Lines*LineW-1:0]     \u_lines.words ;
(* hierconn *) logic [Lines-1:0]           \u_pool.in_use_q ;

(* anyconst *) logic [RingW-1:0]         line;
(* anyconst *) logic [$clog2(LineW)-1:0] place;
logic [Addresses-1:0] lives_q;
logic [RingW-1:0]     at;
logic [SlotW-1:0]     slot [Addresses];
logic                 bit_q, expect_q, expect_bit_q, expect_2_q, expect_bit_2_q;

proof_reset u_proof_reset (.clk_i, .rst_ni);
assign at = read_address[RingW-1:0];
for (genvar i = 0; i < Addresses; i += 1) begin : gen_proof_slot
  assign slot[i] = \u_slots.words [i*SlotW +: SlotW];
end
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    lives_q    <= '0;
    expect_q   <= 1'b0;
    expect_2_q <= 1'b0;
  end else begin
    if (read) lives_q[at] <= 1'b0;
    if (write_i) lives_q[address_i[RingW-1:0]] <= 1'b1;
    expect_q   <= read && at == line && (grant & read_skip_i) == '0;
    expect_2_q <= expect_q;
  end
end
always_ff @(posedge clk_i) begin
  if (write_i && address_i[RingW-1:0] == line) bit_q <= line_i[place];
  expect_bit_q   <= bit_q;
  expect_bit_2_q <= expect_bit_q;
end

always_comb begin
  assume (!read || lives_q[at]);
  assume (!write_i || (slot_valid && !lives_q[address_i[RingW-1:0]]));
  if (rst_ni) begin
    assert (!expect_2_q || (answer_valid_o != '0 && answer_o[place] == expect_bit_2_q));
    // invariants
    assert (!expect_q || (free_q && asked_q != '0 && \u_lines.words [read_slot*LineW+place] == expect_bit_q));
    assert (!free_q || \u_pool.in_use_q [read_slot]);
    assert (asked_q == '0 || free_q);
    assert (!lives_q[line] || \u_lines.words [slot[line]*LineW+place] == bit_q);
    for (int unsigned i = 0; i < Addresses; i += 1) begin
      assert (!lives_q[i] || (\u_pool.in_use_q [slot[i]] && !(free_q && slot[i] == read_slot)));
      for (int unsigned j = 0; j < i; j += 1) assert (!(lives_q[i] && lives_q[j]) || slot[i] != slot[j]);
    end
  end
end
