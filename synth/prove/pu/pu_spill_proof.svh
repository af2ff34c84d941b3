// SPDX-License-Identifier: Apache-2.0
// The end of rtl/pu/rows/pu_spill.sv in its proof: a line goes to the store at once, or to memory whole, in order and
// before its end.
//
// Idea    One bit of the line taken last for memory is remembered, at a place of the solver's choice.
// Rule    Every line taken goes to one of the two; pieces are shown one after another, each with its part of the line
//         and its address, until it is taken; no end passes while a piece waits. Whatever number a line has, nothing is
//         shown that lies outside the area that it is for; behind such a line nothing is shown.
// Assumes pu_rows holds what it shows. The overflow area and the unit are constant.
// Invariant  The pieces left stand in the low end of the register; its address is the line's, while that has room.

(* anyconst *) logic [$clog2(HeldW)-1:0] place;
logic [$clog2(Pieces+1)-1:0] shown_q;  // pieces taken by the memory
(* anyconst *) logic [2*AddressW-1:0] overflow;
(* anyconst *) logic [pipegs_pkg::UnitW-1:0] unit;
logic                        busy_q, bit_q, odd_q;
logic [NumberW-1:0]          number_q;
logic [AddressW-1:0]         begins, at;  // of the area; of the piece in it
logic                        to_memory, mem_bit;

proof_reset u_proof_reset (.clk_i, .rst_ni);
proof_hold #(.DataW(pipegs_pkg::AlphasBits), .Assumed(1'b1)) u_hold_in (
  .clk_i, .rst_ni, .valid_i(alphas_valid_i), .ready_i(alphas_ready_o), .beat_i(alphas_i)
);
proof_hold #(.DataW(AddressW + MemoryW)) u_hold (
  .clk_i, .rst_ni, .valid_i(mem_valid_o), .ready_i(mem_ready_i), .beat_i({mem_address_o, mem_data_o})
);

assign to_memory = alphas_valid_i && alphas_ready_o && is_data && ext;
assign mem_bit   = mem_data_o[32'(place) % MemoryW];
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    busy_q  <= 1'b0;
    shown_q <= '0;
  end else begin
    if (to_memory) begin
      busy_q  <= 1'b1;
      shown_q <= '0;
    end else if (mem_valid_o && mem_ready_i) begin
      shown_q <= shown_q + 1'b1;
      busy_q  <= 32'(shown_q) + 1 != Pieces;
    end
  end
end
assign begins = overflow_i.first + pipegs_pkg::area_first(overflow_i.lines, unit_i,
                                                         odd_q ? pipegs_pkg::AreaOdd : pipegs_pkg::AreaEven);
assign at     = mem_address_o - begins;
always_ff @(posedge clk_i) begin
  if (to_memory) {number_q, odd_q} <= {gen_outside.number, alphas_i.address[AlphaAddressW-1]};
end
always_ff @(posedge clk_i) if (to_memory) bit_q <= 32'(place) < LineW ? line_i[place] : 1'b0;

always_comb begin
  assume (32'(place) < HeldW);
  assume (overflow_i == overflow && unit_i == unit);
  if (rst_ni) begin
    assert (mem_valid_o == (busy_q && !full_o));
    assert (!mem_valid_o || at < pipegs_pkg::area_lines(overflow_i.lines, pipegs_pkg::AreaEven));
    assert (!full_o || busy_q);
    assert (!busy_q || full_o || MostW'((MostW'(number_q) + MostW'(1)) * MostW'(Pieces)) <=
            MostW'(pipegs_pkg::area_lines(overflow_i.lines, pipegs_pkg::AreaEven)));
    assert (!busy_q || full_o || at == AddressW'(number_q) * AddressW'(Pieces) + AddressW'(shown_q));
    assert (gen_outside.first_q == overflow_i.first + pipegs_pkg::area_first(overflow_i.lines, unit_i,
                                                                             pipegs_pkg::AreaEven));
    assert ((store_write_o || to_memory) == (alphas_valid_i && alphas_ready_o && is_data));
    assert (!to_memory || !busy_q);
    assert (!rows_end_valid_o || !busy_q);
    assert (!(busy_q && 32'(shown_q) == 32'(place) / MemoryW) || mem_bit == bit_q);
    // invariants
    assert (32'(gen_outside.left_q) == (busy_q ? Pieces - 32'(shown_q) : 0));
    assert (!busy_q || 32'(shown_q) < Pieces);
    assert (!(busy_q && 32'(shown_q) <= 32'(place) / MemoryW) ||
            gen_outside.held_q[32'(place) - 32'(shown_q) * MemoryW] == bit_q);
  end
end
