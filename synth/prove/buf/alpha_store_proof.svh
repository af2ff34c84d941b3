// SPDX-License-Identifier: Apache-2.0
// The end of rtl/buf/pipegs_alpha_store.sv in its proof: every reader gets what was written, once, one cycle after it
// was taken.
//
// Idea    Scoreboard of one line: the word of the SRAM that proof_memory watches is any word, the reader is any reader.
// Rule    At most one reader is taken, always one if any asks; the answer goes to the reader taken in the cycle before
//         and to no other; it shows what was written last to that line, the address taken modulo AlphaLines. No reader
//         that asks waits more than Units - 1 cycles.
// Assumes No line is read in the cycle in which it is written (the module's own promise).
// Invariant  What is remembered here stands in the SRAM. The cycles that the reader waits are the grants that pass it,
//         which arbiter_proof.svh bounds.

(* hierconn *) logic [RingW-1:0] \u_lines.u_proof.word_o ;
(* hierconn *) logic [$clog2(LineW)-1:0] \u_lines.u_proof.place_o ;
(* hierconn *) logic \u_lines.u_proof.written_o ;
(* hierconn *) logic \u_lines.u_proof.bit_o ;
(* hierconn *) logic \u_lines.u_proof.shown_o ;
(* hierconn *) logic \u_lines.u_proof.shown_bit_o ;

(* hierconn *) logic [PortW-1:0] \u_arbiter.who ;
(* hierconn *) logic [$clog2(2*Units+1)-1:0] \u_arbiter.waits_q ;

(* anyconst *) logic [PortW-1:0] reader;
logic [$clog2(2*Units+1)-1:0] cycles_q;  // the reader waits
logic [Units-1:0]    taken_q;
logic                written_q = 1'b0, bit_q, expect_q, expect_bit_q;  // the line; the answer to come
logic [AddressW-1:0] asked;
logic                takes;

assign asked = read_address_i[reader*AddressW +: AddressW];
assign takes = read_valid_i[reader] && read_ready_o[reader];

always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    taken_q  <= '0;
    expect_q <= 1'b0;
    cycles_q <= '0;
  end else begin
    taken_q  <= read_valid_i & read_ready_o;
    expect_q <= takes && asked[RingW-1:0] == \u_lines.u_proof.word_o && written_q;
    cycles_q <= read_valid_i[reader] && !read_ready_o[reader] ? cycles_q + 1'b1 : '0;
  end
end
always_ff @(posedge clk_i) begin
  expect_bit_q <= bit_q;
  if (write_i && address_i[RingW-1:0] == \u_lines.u_proof.word_o ) begin
    written_q <= 1'b1;
    bit_q     <= line_i[\u_lines.u_proof.place_o ];
  end
end

always_comb begin
  assume ((PortW+1)'(reader) < (PortW+1)'(Units) && reader == \u_arbiter.who );
  assume (!(read && write_i) || read_address[RingW-1:0] != address_i[RingW-1:0]);
  assert (written_q == \u_lines.u_proof.written_o && (!written_q || bit_q == \u_lines.u_proof.bit_o ));
  if (rst_ni) begin
    assert ((read_ready_o & (read_ready_o - 1'b1)) == '0);
    assert ((read_ready_o & ~read_valid_i) == '0);
    assert (read_valid_i == '0 || read_ready_o != '0);
    assert (32'(cycles_q) < Units);
    assert (cycles_q == \u_arbiter.waits_q );
    assert (answer_valid_o == taken_q);
    assert (active_o || (!write_i && read_valid_i == '0 && answer_valid_o == '0));
    assert (!expect_q || answer_o[\u_lines.u_proof.place_o ] == expect_bit_q);
    assert (!expect_q || (\u_lines.u_proof.shown_o && \u_lines.u_proof.shown_bit_o == expect_bit_q));
  end
end
