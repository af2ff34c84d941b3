// SPDX-License-Identifier: Apache-2.0
// The end of rtl/mem/pipegs_axi_gather.sv in its proof: every bit of a line stands where its beat and its place in it
// say.
//
// Rule    Of the beats of one tag and one bit of a line, both of the solver's choice, that bit is remembered when its
//         beat comes; in the cycle after the last beat of the line the line shows, with the tag and the bit. No line
//         shows in another cycle, none in the cycle in which the epoch turns.
// Assumes Tags below Tags; no beat of the new epoch in the cycle of its turn, because nothing was asked for in it.
// Invariant  The counter of the tag is the beats counted here; its bit lies in the word of the SRAM of its beat.

(* anyconst *) logic [PortW-1:0] watched;
(* anyconst *) logic [$clog2(pipegs_pkg::MemoryW)-1:0] place;
localparam int unsigned CountW = $clog2(Beats) + 1;
logic [CountW-1:0] beats_of_q;  // of the watched tag's line
logic              bit_q, mine, ends, ended_q, mine_q, moved_q;

proof_reset u_proof_reset (.clk_i, .rst_ni);
assign mine = beat_valid_i && beat_tag_i == TagW'(watched);
assign ends = mine && beats_of_q == CountW'(Beats - 1);

always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    beats_of_q <= '0;
    ended_q    <= 1'b0;
    mine_q     <= 1'b0;
  end else begin
    ended_q <= ends;
    mine_q  <= mine;
    if (turn_i || ends) beats_of_q <= '0;
    else if (mine) beats_of_q <= beats_of_q + 1'b1;
  end
end
always_ff @(posedge clk_i) if (mine && beats_of_q == CountW'(place / DataW)) bit_q <= beat_i[place % DataW];

always_comb begin
  assume ({1'b0, watched} < (PortW+1)'(Tags));
  assume (!beat_valid_i || beat_tag_i < TagW'(Tags));
  assume (!(turn_i && beat_valid_i));
  if (rst_ni) begin
    assert (!turn_i || !line_valid_o);
    assert (!ended_q || turn_i || (line_valid_o && line_tag_o == TagW'(watched)));
    assert (!(line_valid_o && line_tag_o == TagW'(watched)) || ended_q);
    assert (!ended_q || line_o[place] == bit_q);
    assert (active_o == line_valid_q && (!line_valid_o || active_o));
    assert (!(mine_q && !ended_q) || !line_valid_o);
    assert (beats_of_q < CountW'(Beats));
  end
end

// Where the bit lies while its line is not whole: a line has at most three parts beside its last beat.
logic [2:0] kept, kept_bit, shown, shown_bit;  // by the SRAM of each part, see proof_memory
(* hierconn *) logic [PortW-1:0] \gen_parts.gen_part[0].u_part.u_proof.word_o ;
(* hierconn *) logic [$clog2(DataW)-1:0] \gen_parts.gen_part[0].u_part.u_proof.place_o ;
(* hierconn *) logic \gen_parts.gen_part[0].u_part.u_proof.written_o ;
(* hierconn *) logic \gen_parts.gen_part[0].u_part.u_proof.bit_o ;
(* hierconn *) logic \gen_parts.gen_part[0].u_part.u_proof.shown_o ;
(* hierconn *) logic \gen_parts.gen_part[0].u_part.u_proof.shown_bit_o ;
(* hierconn *) logic [PortW-1:0] \gen_parts.gen_part[1].u_part.u_proof.word_o ;
(* hierconn *) logic [$clog2(DataW)-1:0] \gen_parts.gen_part[1].u_part.u_proof.place_o ;
(* hierconn *) logic \gen_parts.gen_part[1].u_part.u_proof.written_o ;
(* hierconn *) logic \gen_parts.gen_part[1].u_part.u_proof.bit_o ;
(* hierconn *) logic \gen_parts.gen_part[1].u_part.u_proof.shown_o ;
(* hierconn *) logic \gen_parts.gen_part[1].u_part.u_proof.shown_bit_o ;
(* hierconn *) logic [PortW-1:0] \gen_parts.gen_part[2].u_part.u_proof.word_o ;
(* hierconn *) logic [$clog2(DataW)-1:0] \gen_parts.gen_part[2].u_part.u_proof.place_o ;
(* hierconn *) logic \gen_parts.gen_part[2].u_part.u_proof.written_o ;
(* hierconn *) logic \gen_parts.gen_part[2].u_part.u_proof.bit_o ;
(* hierconn *) logic \gen_parts.gen_part[2].u_part.u_proof.shown_o ;
(* hierconn *) logic \gen_parts.gen_part[2].u_part.u_proof.shown_bit_o ;
if (Beats > 1) begin : gen_proof_0
  assign kept[0]      = \gen_parts.gen_part[0].u_part.u_proof.written_o ;
  assign kept_bit[0]  = \gen_parts.gen_part[0].u_part.u_proof.bit_o ;
  assign shown[0]     = \gen_parts.gen_part[0].u_part.u_proof.shown_o ;
  assign shown_bit[0] = \gen_parts.gen_part[0].u_part.u_proof.shown_bit_o ;
  always_comb begin
    assume (\gen_parts.gen_part[0].u_part.u_proof.word_o == watched);
    assume (32'(\gen_parts.gen_part[0].u_part.u_proof.place_o ) == place % DataW);
    if (rst_ni && place / DataW == 0) begin
      assert (beats_of_q <= CountW'(0) || (kept[0] && kept_bit[0] == bit_q));
      assert (!ended_q || (shown[0] && shown_bit[0] == bit_q));
    end
  end
end
if (Beats > 2) begin : gen_proof_1
  assign kept[1]      = \gen_parts.gen_part[1].u_part.u_proof.written_o ;
  assign kept_bit[1]  = \gen_parts.gen_part[1].u_part.u_proof.bit_o ;
  assign shown[1]     = \gen_parts.gen_part[1].u_part.u_proof.shown_o ;
  assign shown_bit[1] = \gen_parts.gen_part[1].u_part.u_proof.shown_bit_o ;
  always_comb begin
    assume (\gen_parts.gen_part[1].u_part.u_proof.word_o == watched);
    assume (32'(\gen_parts.gen_part[1].u_part.u_proof.place_o ) == place % DataW);
    if (rst_ni && place / DataW == 1) begin
      assert (beats_of_q <= CountW'(1) || (kept[1] && kept_bit[1] == bit_q));
      assert (!ended_q || (shown[1] && shown_bit[1] == bit_q));
    end
  end
end
if (Beats > 3) begin : gen_proof_2
  assign kept[2]      = \gen_parts.gen_part[2].u_part.u_proof.written_o ;
  assign kept_bit[2]  = \gen_parts.gen_part[2].u_part.u_proof.bit_o ;
  assign shown[2]     = \gen_parts.gen_part[2].u_part.u_proof.shown_o ;
  assign shown_bit[2] = \gen_parts.gen_part[2].u_part.u_proof.shown_bit_o ;
  always_comb begin
    assume (\gen_parts.gen_part[2].u_part.u_proof.word_o == watched);
    assume (32'(\gen_parts.gen_part[2].u_part.u_proof.place_o ) == place % DataW);
    if (rst_ni && place / DataW == 2) begin
      assert (beats_of_q <= CountW'(2) || (kept[2] && kept_bit[2] == bit_q));
      assert (!ended_q || (shown[2] && shown_bit[2] == bit_q));
    end
  end
end
if (Beats > 1) begin : gen_proof_beats
  always_comb if (rst_ni) assert (gen_parts.beats_q[watched*gen_parts.BeatW +: gen_parts.BeatW] == beats_of_q);
end else begin : gen_proof_whole
  always_comb if (rst_ni) assert (!ended_q || last_q[place] == bit_q);
end
