// SPDX-License-Identifier: Apache-2.0
// The end of rtl/pu/rows/pu_allocate.sv in its proof: an address, and an overflow area, is given again only after its
// layer is free.
//
// Idea    Any one address, of the solver's choice, is followed from the beat that gets it until its layer is free; and
//         any one layer from its first line in an overflow area on.
// Rule    At most AlphaLayers live, and no beat comes in behind that many; no more lines are given than have a slot; an
//         address that lives, or an area, is not given to another beat or layer; both outputs keep what they show.
// Assumes Of pipegs_layer_free (its proof): a layer is freed only while one has ended. Of pipegs_alpha_store (its
//         proof): a line is freed once. Of scheduler: a frame begins in an empty PU, when no layer lives.
// Invariant  An address that lives lies behind the head, farther than the lines of all younger layers and nearer than
//         those and its own layer's. Layers with an area have the two in turn.
// Not said  overflow_q counts the lines of a layer in memory: that an area has room for them depends on the scene, see
//           the module's own assertion.

localparam int unsigned BeatW = pipegs_pkg::KindW + Regions + AlphaAddressW + 1;
(* anyconst *) logic [HeadW-1:0] line;
(* anyseq *) logic pick;             // follow the layer that overflows for the first time
logic              lives_q, area_lives_q, followed_q;
logic [EndedW-1:0] age_q, area_age_q;  // layers before the address's layer, before the followed one
logic              given, first;
logic [HeadW-1:0]  ahead, past;
logic [31:0]       from [Layers+1];  // lines of the layers from this place on, the present one's too
logic [1:0]        later;            // layers with an area behind the followed one
logic [31:0]       spilled;
logic [BeatW-1:0]  beat;             // all but the fields that stand in tiles_q untouched

proof_reset u_proof_reset (.clk_i, .rst_ni);
proof_hold #(.DataW(BeatW)) u_hold_row (
  .clk_i, .rst_ni, .valid_i(row_job_valid_o), .ready_i(row_job_ready_i), .beat_i(beat)
);
proof_hold #(.DataW(BeatW)) u_hold_color (
  .clk_i, .rst_ni, .valid_i(color_job_valid_o), .ready_i(color_job_ready_i), .beat_i(beat)
);

assign beat   = {tiles_q.kind, tiles_q.mask, address_q, ext_q};
assign ahead  = line - head_q;
assign past   = head_q - 1'b1 - line;
assign given  = local_lines && SumW'(ahead) < SumW'(count_q);
assign first  = spills && !own_spilled_q;
always_comb begin
  from[Layers] = 32'(own_q);
  later        = '0;
  spilled      = 32'(own_spilled_q);
  for (int unsigned i = Layers; i > 0; i -= 1) begin
    from[i-1] = from[i] + (EndedW'(i - 1) < ended_q ? 32'(lines_q[i-1]) : 0);
    if (EndedW'(i - 1) < ended_q && spilled_q[i-1]) begin
      spilled = spilled + 1;
      if (EndedW'(i - 1) > area_age_q) later = later + 1'b1;
    end
  end
end
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    lives_q      <= 1'b0;
    age_q        <= '0;
    area_lives_q <= 1'b0;
    area_age_q   <= '0;
    followed_q   <= 1'b0;
  end else begin
    if (given) begin
      lives_q <= 1'b1;
      age_q   <= ended_q - EndedW'(layer_free_i);
    end else if (layer_free_i) begin
      lives_q <= lives_q && age_q != '0;
      age_q   <= age_q - 1'b1;
    end
    if (first && pick && !area_lives_q) begin
      area_lives_q <= 1'b1;
      area_age_q   <= ended_q - EndedW'(layer_free_i);
      followed_q   <= area_q;
    end else if (layer_free_i) begin
      area_lives_q <= area_lives_q && area_age_q != '0;
      area_age_q   <= area_age_q - 1'b1;
    end
  end
end

always_comb begin
  assume (!layer_free_i || ended_q != '0);
  assume (!line_free_i || used_q != '0);
  assume (!restart_i || (state_q == StateTake && !take && {ended_q, held_q, areas_q, used_q} == '0));
  if (rst_ni) begin
    assert (ended_q <= EndedW'(Layers));
    assert (!take || ended_q != EndedW'(Layers));
    assert (SumW'(used_q) <= SumW'(pipegs_pkg::AlphaLines));
    assert (SumW'(held_q) <= SumW'(pipegs_pkg::AlphaAddresses));
    assert (!given || !lives_q);
    assert (!first || !area_lives_q || followed_q != area_q);
    // invariants
    assert (state_q == StateOffer || !(row_valid_q || color_valid_q));
    assert (state_q == StateTake || state_q == StateOffer || ended_q != EndedW'(Layers));
    assert (count_q <= CountW'(Regions) || state_q != StateDecide);
    assert (32'(held_q) == from[0]);
    assert (32'(areas_q) == spilled && areas_q <= 2'd2);
    if (lives_q) begin
      assert (age_q <= ended_q);
      assert (32'(past) < from[age_q]);
      assert (age_q == ended_q || 32'(past) >= from[age_q+1'b1]);
    end
    if (area_lives_q) begin
      assert (area_age_q <= ended_q);
      assert (area_age_q == ended_q ? own_spilled_q : spilled_q[area_age_q]);
      assert (followed_q == (area_q ^ (area_age_q != ended_q) ^ later[0]));
    end
  end
end
