// SPDX-License-Identifier: Apache-2.0
// The end of rtl/pu/rows/pu_allocate.sv in its proof: a line of the ring is given again only after its layer is free.
//
// Idea    Any one line of the ring, of the solver's choice, is followed from the beat that gets it until its layer is
//         free.
// Rule    At most two layers live, and no beat of a third comes in; the lines of both fit into the ring; a line that
//         lives is not given to another beat; both outputs keep what they show.
// Assumes Of pipegs_layer_free (its proof): a layer is freed only while one lives. Of scheduler: a frame begins in an
//         empty PU, when no layer lives.
// Invariant  A line that lives lies behind the head, nearer than all lines of its layer and of the layer after it.
// Not said  overflow_q counts the lines of a layer in memory: that an area has room for them depends on the scene, see
//           the module's own assertion.

localparam int unsigned BeatW = pipegs_pkg::KindW + Regions + AlphaAddressW + 1;
(* anyconst *) logic [HeadW-1:0] line;
logic             lives_q, newer_q;  // the line; its layer is not the oldest
logic             given;
logic [HeadW-1:0] ahead, behind;
logic [BeatW-1:0] beat;  // all but the fields that stand in tiles_q untouched

proof_reset u_proof_reset (.clk_i, .rst_ni);
proof_hold #(.DataW(BeatW + 1)) u_hold_row (
  .clk_i, .rst_ni, .valid_i(row_job_valid_o), .ready_i(row_job_ready_i), .beat_i({row_job_o.parity, beat})
);
proof_hold #(.DataW(BeatW)) u_hold_color (
  .clk_i, .rst_ni, .valid_i(color_job_valid_o), .ready_i(color_job_ready_i), .beat_i(beat)
);

assign beat   = {tiles_q.kind, tiles_q.mask, address_q, ext_q};
assign ahead  = line - head_q;
assign behind = head_q - 1'b1 - line;
assign given  = local_lines && SumW'(ahead) < SumW'(count_q);
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    lives_q <= 1'b0;
    newer_q <= 1'b0;
  end else begin
    if (given) begin
      lives_q <= 1'b1;
      newer_q <= ended_q != '0 && !layer_free_i;
    end else if (layer_free_i) begin
      lives_q <= lives_q && newer_q;
      newer_q <= 1'b0;
    end
  end
end

always_comb begin
  assume (!layer_free_i || ended_q != '0);
  assume (!restart_i || (state_q == StateTake && !take && ended_q == '0 && oldest_q == '0));
  if (rst_ni) begin
    assert (ended_q <= 2'd2);
    assert (!take || ended_q != 2'd2);
    assert (SumW'(oldest_q) + SumW'(newest_q) <= SumW'(pipegs_pkg::AlphaLines));
    assert (!given || !lives_q);
    // invariants
    assert (ended_q != '0 || newest_q == '0);
    assert (state_q == StateOffer || !(row_valid_q || color_valid_q));
    assert (state_q == StateTake || state_q == StateOffer || ended_q != 2'd2);
    assert (count_q <= CountW'(Regions) || state_q != StateDecide);
    assert (!lives_q || !newer_q || ended_q != '0);
    if (lives_q) begin
      if (newer_q) assert (SumW'(behind) < SumW'(newest_q));
      else assert (SumW'(behind) < SumW'(oldest_q) + SumW'(newest_q));
      if (!newer_q) assert (SumW'(behind) >= SumW'(newest_q));
    end
  end
end
