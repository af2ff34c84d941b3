// SPDX-License-Identifier: Apache-2.0
// su_tree: merges sorted runs: a tournament whose losers stay where they lost, and the winner leaves.
//
// Paper   None: its buffers hold every layer.
// Idea    A tree of losers (Knuth, vol. 3, 5.4.1). Its nodes lie in one SRAM, node n above nodes 2n and 2n + 1; a key
//         rises from its way's leaf, at each node the farther one stays. When the nearest of all has left, the next key
//         of the same way rises on the same path: as many comparisons as the tree has levels, with one comparator. At
//         the start an empty node takes the first key that comes. A way that has run out sends a void key, which is
//         above every key; when that wins, all were sent.
// Stream  setup: the number of keys of each way; start_i with the levels of the tree; read: keys in the pool, one cycle
//         later; item: the keys with their slots, nearest first; release_o: a line of way_o in the pool is used up.
// Pace    A key in levels_i + 2 cycles.
// Model   std::sort in the test of su.

module su_tree #(
  localparam int unsigned WayW = $clog2(pipegs_pkg::SuWays),
  localparam int unsigned LevelW = $clog2(WayW + 1)
) (
  input  logic                           clk_i,
  input  logic                           rst_ni,

  input  logic                           setup_i,
  input  logic [WayW-1:0]                setup_way_i,
  input  logic [pipegs_pkg::SlotW-1:0]   setup_keys_i,
  input  logic                           start_i,
  input  logic [LevelW-1:0]              levels_i,  // 1 .. WayW; ways 0 .. 2^levels_i - 1 are merged

  output logic [WayW-1:0]                way_o,
  input  logic [1:0]                     ready_i,   // of way_o: lines in the pool, more than one, some
  output logic                           release_o,

  output logic                           read_o,
  output logic [pipegs_pkg::RecordW-1:0] read_slot_o,
  input  logic [pipegs_pkg::KeyW-1:0]    key_i,

  output logic                           item_valid_o,
  input  logic                           item_ready_i,  // not in the first cycle
  output logic [pipegs_pkg::KeyW-1:0]    item_key_o,
  output logic [pipegs_pkg::RecordW-1:0] item_slot_o,

  output logic                           idle_o,
  output logic                           active_o
);

  localparam int unsigned KeyW = pipegs_pkg::KeyW;
  localparam int unsigned SlotW = pipegs_pkg::SlotW;
  localparam int unsigned RecordW = pipegs_pkg::RecordW;
  localparam int unsigned Ways = pipegs_pkg::SuWays;
  localparam int unsigned Lines = pipegs_pkg::SuWayLines;
  localparam int unsigned RunKeys = pipegs_pkg::SuRunKeys;
  localparam int unsigned PlaceW = 3;
  localparam int unsigned HeadW = PlaceW + (Lines > 1 ? $clog2(Lines) : 0);  // {line, place in it} of a way
  localparam int unsigned NodeW = 1 + KeyW + WayW + HeadW;                   // {void, key, way, head}

  typedef enum logic [1:0] {
    Idle,    // waits for start_i
    Look,    // how many keys the way has; the item is shown
    Take,    // until the item is taken and the way's next key is read
    Compare  // that key rises, one level per cycle
  } state_e;
  state_e state_q;

  // The key that rises; when it has won, the item.
  logic              void_q, seeding_q;  // seeding: the ways' first keys are brought into the tree
  logic [KeyW-1:0]   key_q;
  logic [WayW-1:0]   way_q, seed_q;      // seed: the way whose first key it is
  logic [HeadW-1:0]  head_q, head;
  logic              taken_q, fetched_q, take, fetch, ended, wraps, leaves;
  logic [SlotW-1:0]  left;  // keys of the way that were not taken

  assign wraps = !seeding_q && head_q[PlaceW-1:0] == PlaceW'(RunKeys - 1);
  assign head  = seeding_q ? '0 : head_q + (wraps ? HeadW'(9 - RunKeys) : HeadW'(1));  // the next line, or place
  assign ended = left == (seeding_q ? '0 : SlotW'(1));
  assign take  = state_q == Take && item_valid_o && item_ready_i;
  assign fetch = state_q == Take && !ended && !fetched_q && ready_i[wraps && !taken_q];
  assign leaves = state_q == Take && (seeding_q || taken_q || take) && (ended || fetched_q || fetch);

  assign way_o        = way_q;
  assign release_o    = take && (wraps || ended);
  assign read_o       = fetch;
  assign read_slot_o  = RecordW'({way_q, head});
  assign item_valid_o = (state_q == Look || state_q == Take) && !seeding_q && !taken_q;
  assign item_key_o   = key_q;
  assign item_slot_o  = RecordW'({way_q, head_q});

  pipegs_sram #(.DataW(SlotW), .Depth(Ways)) u_left (
    .clk_i,
    .write_i(setup_i || take),
    .waddr_i(setup_i ? setup_way_i : way_q),
    .wdata_i(setup_i ? setup_keys_i : left - 1'b1),
    .read_i(state_q == Look),
    .raddr_i(way_q),
    .rdata_o(left)
  );

  // --- the tree -----------------------------------------------------------------------------------------------------
  logic              first_q;  // the key that rises comes out of the pool
  logic [Ways-1:0]   filled_q; // nodes
  logic [WayW-1:0]   node_q, leaf;
  logic [NodeW-1:0]  rising, loser, winner;
  logic              filled, swap, done, won;

  assign leaf   = WayW'((((WayW+1)'(1) << levels_i) | (WayW+1)'(way_q)) >> 1);  // the node above it
  assign rising = {void_q, first_q ? key_i : key_q, way_q, head_q};
  assign filled = filled_q[node_q];
  assign swap   = loser[NodeW-1 -: KeyW+1] < rising[NodeW-1 -: KeyW+1];
  assign winner = swap ? loser : rising;
  assign done   = state_q == Compare && (!filled || node_q == WayW'(1));
  assign won    = done && filled;

  pipegs_sram #(.DataW(NodeW), .Depth(Ways)) u_nodes (
    .clk_i,
    .write_i(state_q == Compare && (!filled || swap)),
    .waddr_i(node_q),
    .wdata_i(rising),
    .read_i(leaves || state_q == Compare),
    .raddr_i(leaves ? leaf : node_q >> 1),
    .rdata_o(loser)
  );

  assign idle_o   = state_q == Idle;
  assign active_o = setup_i || start_i || state_q == Look || state_q == Compare || take || fetch || leaves;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q <= Idle;
    end else begin
      unique case (state_q)
        Idle:    if (start_i) state_q <= Look;
        Look:    state_q <= Take;
        Take:    if (leaves) state_q <= Compare;
        default: if (done) state_q <= won && winner[NodeW-1] ? Idle : Look;
      endcase
    end
  end

  always_ff @(posedge clk_i) begin
    if (state_q == Idle) begin
      seeding_q <= 1'b1;
      filled_q  <= '0;
      way_q     <= '0;
      seed_q    <= '0;
    end
    if (take) taken_q <= 1'b1;
    if (fetch) fetched_q <= 1'b1;
    if (state_q == Idle || leaves) begin
      taken_q   <= 1'b0;
      fetched_q <= 1'b0;
    end
    if (leaves) begin
      void_q  <= ended;
      head_q  <= head;
      node_q  <= leaf;
      first_q <= 1'b1;
    end
    if (state_q == Compare) begin
      {void_q, key_q, way_q, head_q} <= winner;
      node_q           <= node_q >> 1;
      first_q          <= 1'b0;
      filled_q[node_q] <= 1'b1;
      if (!filled) begin  // the key stays; the next way's rises
        way_q  <= seed_q + 1'b1;
        seed_q <= seed_q + 1'b1;
      end
      if (won) seeding_q <= 1'b0;
    end
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!start_i || (idle_o && levels_i != '0));
  always_ff @(posedge clk_i) if (rst_ni) assert (!(state_q == Look && item_valid_o) || !item_ready_i);
  pipegs_stream_check #(.DataW($bits({item_key_o, item_slot_o}))) u_check_item (
    .clk_i,
    .rst_ni,
    .valid_i(item_valid_o),
    .ready_i(item_ready_i),
    .beat_i({item_key_o, item_slot_o})
  );
`endif

endmodule
