// SPDX-License-Identifier: Apache-2.0
// The end of rtl/su/sort/su_bitonic.sv in its proofs: batches leave in order, sorted, and made of the records that
// came.
//
// Idea    0-1 principle, with a threshold of the solver's choice: z says of each item whether its key is above it.
//         Exchanging keys exchanges their z as if they were the keys, so a network that sorts z for every threshold
//         sorts the keys. No width is left out. Permutation: one beat, again of the solver's choice, carries a mark in
//         the top bit of its slot (RecordW is one more here than in the machine); it leaves once, in its batch, with
//         its key and slot.
// Rule    Seen from the ports: a batch leaves after the one before it, complete, as often as it has keys; in a batch no
//         key at or below the threshold follows one above it; a beat shown stays; the first beat shows exactly 1 + 0,
//         1, 3, 6 or 10 cycles after the batch is complete and the one before it has left.
// Assumes Batches of 1 to 16, and an end alone in its batch (the module's own promises).
// Invariant  Before the stage at `distance` of the merge of `size`: blocks of 2 * distance channels are bitonic (z
//         changes at most twice on the way round), and follow each other in the direction of their group of `size`
//         channels. The void bits lie where the network moves them from the places behind the batch; one item has the
//         mark.

(* anyconst *) logic [pipegs_pkg::KeyW-1:0] threshold;
(* anyconst *) logic [$clog2(DataW)-1:0]    place;      // a bit of the marked beat
(* anyseq *)   logic                        pick;
logic [ChannelW:0] coming_q, left_q;                // keys of the batch that comes in; to come of the one that leaves
logic              complete_q, end_coming_q, end_leaving_q, first, above_q;
logic              mark_coming_q, mark_leaving_q, bit_q;  // the marked beat is one of them; its bit
logic [3:0]        waits_q;                         // cycles that a complete batch waits for its first beat to show
logic              mark_in, mark_out, above;
logic [DataW-1:0]  in_beat, out_beat;

proof_reset u_proof_reset (.clk_i, .rst_ni);
proof_hold #(.DataW(DataW + 1)) u_hold (
  .clk_i, .rst_ni, .valid_i(out_valid_o), .ready_i(out_ready_i), .beat_i({out_end_o, out_key_o, out_slot_o})
);

assign in_beat  = {in_key_i, in_slot_i};
assign out_beat = {out_key_o, out_slot_o};
assign first    = left_q == '0;  // the next beat begins a batch
assign mark_in  = in_slot_i[pipegs_pkg::RecordW-1];
assign mark_out = out_slot_o[pipegs_pkg::RecordW-1];
assign above    = out_key_o > threshold;

always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    coming_q        <= '0;
    complete_q      <= 1'b0;
    left_q          <= '0;
    mark_coming_q  <= 1'b0;
    mark_leaving_q <= 1'b0;
    above_q         <= 1'b0;
    waits_q         <= '0;
  end else begin
    if (in_valid_i && in_ready_o) begin
      coming_q        <= coming_q + 1'b1;
      complete_q      <= in_last_i;
      mark_coming_q <= mark_coming_q || mark_in;
    end
    if (out_valid_o && out_ready_i) begin
      above_q       <= above;
      left_q        <= (first ? coming_q : left_q) - 1'b1;
      mark_leaving_q <= (first ? mark_coming_q : mark_leaving_q) && !mark_out;
      if (first) begin
        coming_q        <= '0;
        complete_q      <= 1'b0;
        mark_coming_q <= 1'b0;
      end
    end
    waits_q <= complete_q && first && !out_valid_o ? waits_q + 1'b1 : out_valid_o && !out_ready_i ? waits_q : '0;
  end
end
always_ff @(posedge clk_i) begin
  if (in_valid_i && in_ready_o) begin
    end_coming_q <= in_end_i;
    if (mark_in) bit_q <= in_beat[place];
  end
  if (out_valid_o && out_ready_i && first) end_leaving_q <= end_coming_q;
end

function automatic logic [3:0] proof_stages(input logic [ChannelW:0] keys);
  proof_stages = keys > 5'd8 ? 4'd10 : keys > 5'd4 ? 4'd6 : keys > 5'd2 ? 4'd3 : keys > 5'd1 ? 4'd1 : 4'd0;
endfunction

always_comb begin
  assume (!(in_valid_i && coming_q == (ChannelW+1)'(Channels - 1)) || in_last_i);
  assume (!(in_valid_i && in_end_i) || (in_last_i && coming_q == '0));
  assume (!(in_valid_i && mark_in) || (pick && !mark_coming_q && !mark_leaving_q));
  assume ({1'b0, place} < ($clog2(DataW)+1)'(DataW));
  if (rst_ni) begin
    assert (!in_ready_o || (!complete_q && coming_q < (ChannelW+1)'(Channels)));
    assert (!out_valid_o || !first || complete_q);
    assert (!out_valid_o || out_end_o == (first ? end_coming_q : end_leaving_q));
    assert (!out_valid_o || first || !above_q || above);
    assert (!(out_valid_o && mark_out) || (first ? mark_coming_q : mark_leaving_q));
    assert (!(out_valid_o && mark_out) || out_beat[place] == bit_q);
    assert (!(first && mark_leaving_q));
    assert (!complete_q || !first || waits_q <= 1'b1 + proof_stages(coming_q));
    assert (!(out_valid_o && first) || waits_q == 1'b1 + proof_stages(coming_q));
    assert (first || out_valid_o);
  end
end

// --- invariants ------------------------------------------------------------------------------------------------------
logic [Channels-1:0] z, marks, bits, void_z, coming, leaving;
logic                shown;  // of the sorted batch nothing has left yet, so at the ports it is still the one that comes
assign shown = !sorting_q && sent_q == '0 && live_q != '0;

always_comb begin
  for (int unsigned i = 0; i < Channels; i += 1) begin
    z[i]       = items_q[i*ItemW + pipegs_pkg::RecordW +: pipegs_pkg::KeyW+1] > {1'b0, threshold};
    marks[i]   = items_q[i*ItemW + pipegs_pkg::RecordW - 1];
    bits[i]    = items_q[i*ItemW + 32'(place)];
    void_z[i]  = items_q[i*ItemW+ItemW-1];
    coming[i]  = sorting_q ? !void_z[i] : (ChannelW+1)'(i) < fill_q;  // keys of the coming batch lie here
    leaving[i] = (ChannelW+1)'(i) >= sent_q && (ChannelW+1)'(i) < live_q;
  end
end

function automatic logic proof_marked(input logic [Channels-1:0] at, input logic [Channels-1:0] ones);
  proof_marked = at != '0 && (at & (at - 1'b1)) == '0 && ((at & ones) != '0) == bit_q;
endfunction

always_comb begin
  if (rst_ni) begin
    assert (fill_q <= (ChannelW+1)'(Channels) && live_q <= (ChannelW+1)'(Channels) && sent_q <= live_q);
    assert (sent_q == live_q || fill_q <= sent_q);
    assert (!loaded_q || fill_q != '0);
    assert (fill_q != (ChannelW+1)'(Channels) || loaded_q);
    assert (!(mark_coming_q && mark_leaving_q));
    if (shown) begin
      assert (fill_q == '0 && !loaded_q && first && coming_q == live_q && complete_q && end_coming_q == live_end_q);
      assert (mark_coming_q ? proof_marked(marks & leaving, bits) : (marks & leaving) == '0);
      assert (waits_q == 1'b1 + proof_stages(coming_q));
    end else begin
      assert (coming_q == fill_q && complete_q == loaded_q && left_q == live_q - sent_q);
      assert (fill_q == '0 || end_q == end_coming_q);
      assert (first || end_leaving_q == live_end_q);
      assert (mark_coming_q ? proof_marked(marks & coming, bits) : (marks & coming) == '0);
      assert (first || (mark_leaving_q ? proof_marked(marks & leaving, bits) : (marks & leaving) == '0));
    end
    for (int unsigned i = 0; i < Channels; i += 1) begin
      if (!sorting_q) begin
        assert (!(coming[i] || leaving[i]) || !void_z[i]);
        assert (!leaving[i] || first || !above_q || z[i]);
        if (i > 0) assert (!leaving[i] || !leaving[i-1] || !z[i-1] || z[i]);
      end
    end
    if (sorting_q) begin
      assert (loaded_q && sent_q == live_q && fill_q > (ChannelW+1)'(1));
      assert (size_q > '0 && size_q <= (DistanceW+1)'(ChannelW) && {1'b0, distance_q} < size_q);
      assert ((ChannelW+1)'(1) << (size_q - 1'b1) < fill_q);
    end else if (loaded_q && first) begin
      assert (waits_q == '0);
    end
  end
end

// The network on the void bits alone: stage k finds void_at[k] and leaves void_at[k+1].
logic [11*Channels-1:0] void_at;
for (genvar i = 0; i < Channels; i += 1) begin : gen_void
  assign void_at[i] = (ChannelW+1)'(i) >= fill_q;
end
for (genvar size = 1; size <= ChannelW; size += 1) begin : gen_size
  for (genvar distance = 0; distance < size; distance += 1) begin : gen_distance
    localparam int unsigned Stage = size * (size + 1) / 2 - 1 - distance;
    localparam int unsigned Block = 2 << distance;
    logic [Channels-1:0] up;  // z by channel, as if sorted upwards
    logic                now;
    assign now = rst_ni && sorting_q && size_q == (DistanceW+1)'(size) && distance_q == DistanceW'(distance);
    always_comb if (now) assert (waits_q == 4'(Stage + 1));
    for (genvar i = 0; i < Channels; i += 1) begin : gen_channel
      localparam int unsigned Place = (i >> distance) + (i << (ChannelW - distance)) % Channels;
      localparam int unsigned Other = (i / Block) * Block + (i + Block / 2) % Block;  // exchanged with it
      localparam bit Down = (i >> size) % 2 != 0 && size < ChannelW;
      localparam bit Upper = (i >> distance) % 2 != 0;
      assign up[i] = z[Place] != Down;
      assign void_at[(Stage+1)*Channels+i] = Upper != Down
          ? void_at[Stage*Channels+i] || void_at[Stage*Channels+Other]
          : void_at[Stage*Channels+i] && void_at[Stage*Channels+Other];
      always_comb if (now) assert (void_z[Place] == void_at[Stage*Channels+i]);
    end
    for (genvar b = 0; b < Channels / Block; b += 1) begin : gen_block
      logic [Block-1:0] block, changes;
      assign block   = up[b*Block +: Block];
      assign changes = block ^ {block[0], block[Block-1:1]};
      always_comb if (now) assert ($countones(changes) <= 2);
      if (((b + 1) * Block) % (1 << size) != 0) begin : gen_next
        always_comb if (now) assert (block == '0 || up[(b+1)*Block +: Block] == '1);
      end
    end
  end
end
