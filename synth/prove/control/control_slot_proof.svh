// SPDX-License-Identifier: Apache-2.0
// The end of rtl/control/pipegs_control_slot.sv in its proof: any bit of it reads as it was written.
//
// Rule    A bit of the value becomes the bit that is written at its place, else it stays; it is read there. Above it
//         reads the sign or 0, below 0, and beside the slot 0.

(* anyconst *) logic [5:0] place;  // any bit of the slot
logic past_q, was_q, bit_now, inside, written_q, data_q;

assign inside  = 32'(place) >= Shift && 32'(place) < Shift + Width;
assign bit_now = value_o[(32'(place) - Shift) % Width];
proof_reset u_proof_reset (.clk_i, .rst_ni);
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) past_q <= 1'b0;
  else past_q <= 1'b1;
end
always_ff @(posedge clk_i) begin
  was_q     <= bit_now;
  written_q <= write_i && write_word_i == WordW'(Word) + WordW'(place[5]) && write_mask_i[place[4:0]];
  data_q    <= write_data_i[place[4:0]];
end

always_comb begin
  if (rst_ni) begin
    if (past_q && inside) assert (bit_now == (written_q ? data_q : was_q));
    if (!past_q) assert (value_o == '0);
    if (read_word_i == WordW'(Word) + WordW'(place[5])) begin
      if (inside) assert (read_data_o[place[4:0]] == bit_now);
      else if (32'(place) < Shift) assert (!read_data_o[place[4:0]]);
      else assert (read_data_o[place[4:0]] == (Signed && value_o[Width-1]));
    end
    if (read_word_i[WordW-1:1] != (WordW-1)'(Word / 2)) assert (read_data_o == '0);
  end
end
