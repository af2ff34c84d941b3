// SPDX-License-Identifier: Apache-2.0
// dopu_bucket: nodes that wait, sorted by bucket of depth: lists of them share one memory.
//
// Paper   None.
// Idea    Each bucket of each list is a chain of nodes in one SRAM, newest first; a second SRAM holds the chains'
//         heads. A bit for each chain says whether there is one, in words in a third SRAM; a register says which words
//         hold one. The first chain of a list is its nearest bucket, which stands in a register; while a node is
//         fetched the bucket behind it is found, in its own word or in the next one, for the case that its chain ends.
// Stream  insert: a node for a bucket of a list, refused while full_o. pop: the newest node of the list's first bucket;
//         it comes out two cycles later and must be taken. first_*: the nearest bucket of each list; a node counts from
//         the cycle after its insert on, until it has come out.
// Pace    An insert in two cycles, a pop in three; a pop goes first.
// Model   An array of stacks (verif/dopu/nearest/dopu_bucket_test.cpp).

module dopu_bucket #(
  parameter int unsigned Lists = 6,
  parameter int unsigned Nodes = pipegs_pkg::NearestNodes,
  parameter int unsigned DataW = 170,
  localparam int unsigned ListW = $clog2(Lists),
  localparam int unsigned BucketW = pipegs_pkg::BucketW
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,

  input  logic                     insert_valid_i,
  output logic                     insert_ready_o,
  input  logic [ListW-1:0]         insert_list_i,
  input  logic [BucketW-1:0]       insert_bucket_i,
  input  logic [DataW-1:0]         insert_data_i,
  output logic                     full_o,
  output logic                     crowded_o,       // three quarters of the places are taken

  input  logic                     pop_valid_i,     // only of a list that has a node
  output logic                     pop_ready_o,
  input  logic [ListW-1:0]         pop_list_i,
  output logic                     out_valid_o,
  output logic [ListW-1:0]         out_list_o,
  output logic [BucketW-1:0]       out_bucket_o,
  output logic [DataW-1:0]         out_data_o,

  output logic [Lists-1:0]         first_valid_o,
  output logic [Lists*BucketW-1:0] first_bucket_o,
  output logic                     idle_o           // no insert or pop under way
);

  localparam int unsigned NodeW = $clog2(Nodes);
  localparam int unsigned Buckets = 2 ** BucketW;
  localparam int unsigned WordW = BucketW / 2;  // buckets in a word of 2^WordW, words in a list
  localparam int unsigned Word = 2 ** WordW;
  localparam int unsigned Words = Buckets / Word;

  typedef enum logic [1:0] {
    Idle,    // for an insert or a pop; reads the chain's head
    Insert,  // the head is there: writes the node before it
    Fetch,   // the head is there: reads its node
    Out      // the node is there
  } state_e;

  // --- one insert or pop at a time ----------------------------------------------------------------------------------
  state_e             state_q;
  logic [ListW-1:0]   list_q, list_d;
  logic [BucketW-1:0] bucket_q, bucket_d;
  logic [DataW-1:0]   data_q;
  logic               more;       // the chain had a node before the insert
  logic [NodeW-1:0]   place_q;    // of the node written or read
  logic [NodeW-1:0]   free_place, head;
  logic               take_insert, take_pop, out_more, chain_ends;
  logic [NodeW-1:0]   out_next;

  assign idle_o         = state_q == Idle;
  assign pop_ready_o    = idle_o;
  assign insert_ready_o = idle_o && !pop_valid_i && !full_o;
  assign take_pop       = pop_valid_i && pop_ready_o;
  assign take_insert    = insert_valid_i && insert_ready_o;
  assign list_d         = take_pop ? pop_list_i : insert_list_i;
  assign bucket_d       = take_pop ? first_bucket_o[32'(pop_list_i)*BucketW +: BucketW] : insert_bucket_i;
  assign out_valid_o    = state_q == Out;
  assign out_list_o     = list_q;
  assign out_bucket_o   = bucket_q;
  assign chain_ends     = out_valid_o && !out_more;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q <= Idle;
    end else case (state_q)
      Idle:    if (take_pop) state_q <= Fetch; else if (take_insert) state_q <= Insert;
      Fetch:   state_q <= Out;
      default: state_q <= Idle;
    endcase
  end

  always_ff @(posedge clk_i) begin
    if (idle_o) begin
      list_q   <= list_d;
      bucket_q <= bucket_d;
      data_q   <= insert_data_i;
      place_q  <= free_place;
    end else if (state_q == Fetch) begin
      place_q  <= head;
    end
  end

  pipegs_sram #(.DataW(NodeW), .Depth(Lists * Buckets), .Ports(1)) u_heads (
    .clk_i,
    .write_i(state_q == Insert || (out_valid_o && out_more)),
    .waddr_i({list_q, bucket_q}),
    .wdata_i(state_q == Insert ? place_q : out_next),
    .read_i(take_pop || take_insert),
    .raddr_i({list_d, bucket_d}),
    .rdata_o(head)
  );

  pipegs_sram #(.DataW(DataW + NodeW + 1), .Depth(Nodes), .Ports(1)) u_nodes (
    .clk_i,
    .write_i(state_q == Insert),
    .waddr_i(place_q),
    .wdata_i({more, head, data_q}),
    .read_i(state_q == Fetch),
    .raddr_i(head),
    .rdata_o({out_more, out_next, out_data_o})
  );

  // --- which chains there are, and the first of each list -----------------------------------------------------------
  logic [Words-1:0]         some_q [Lists];        // words that have a chain
  logic [Words-1:0]         others;                // of the list at work, but for the bucket's own
  logic                     some_own_q;            // its own had one when the insert or pop began
  logic [Word-1:0]          read, word, own, own_q;  // own: without the chain of the node that is fetched
  logic [Word-1:0]          place_one;
  logic [BucketW-WordW-1:0] at, other, other_q;
  logic [WordW-1:0]         place;
  logic                     any_other_q, own_left;
  logic [Lists-1:0]         first_valid_q;
  logic [BucketW-1:0]       first_q [Lists];

  assign at       = bucket_q[BucketW-1:WordW];
  assign word     = some_own_q ? read : '0;  // Insert, Fetch; behind Fetch the other word was read
  assign more     = word[bucket_q[WordW-1:0]];
  assign own_left = own_q != '0;
  always_comb begin
    place_one = '0;
    place_one[bucket_q[WordW-1:0]] = 1'b1;
    own    = word & ~place_one;
    others = some_q[list_q];
    others[at] = 1'b0;
    for (int unsigned l = 0; l < Lists; l += 1) first_bucket_o[l*BucketW +: BucketW] = first_q[l];
  end
  pipegs_first_set #(.DataW(Words)) u_other (
    .mask_i(others),
    .one_hot_o(),
    .number_o(other)
  );
  pipegs_first_set #(.DataW(Word)) u_place (
    .mask_i(own_left ? own_q : read),
    .one_hot_o(),
    .number_o(place)
  );
  assign first_valid_o = first_valid_q;

  pipegs_sram #(.DataW(Word), .Depth(Lists * Words), .Ports(1)) u_words (
    .clk_i,
    .write_i(state_q == Insert || chain_ends),
    .waddr_i({list_q, at}),
    .wdata_i(state_q == Insert ? word | place_one : own_q),
    .read_i(take_pop || take_insert || state_q == Fetch),
    .raddr_i(state_q == Fetch ? {list_q, other} : {list_d, bucket_d[BucketW-1:WordW]}),
    .rdata_o(read)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      first_valid_q <= '0;
      for (int unsigned l = 0; l < Lists; l += 1) some_q[l] <= '0;
    end else begin
      if (take_insert) begin
        some_q[insert_list_i][insert_bucket_i[BucketW-1:WordW]] <= 1'b1;
        first_valid_q[insert_list_i] <= 1'b1;
      end
      if (chain_ends) begin
        if (!own_left) some_q[list_q][at] <= 1'b0;
        first_valid_q[list_q] <= own_left || any_other_q;
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (idle_o) some_own_q <= some_q[list_d][bucket_d[BucketW-1:WordW]];
    if (state_q == Fetch) begin
      own_q       <= own;
      other_q     <= other;
      any_other_q <= others != '0;
    end
    if (take_insert && (!first_valid_q[insert_list_i] || insert_bucket_i < first_q[insert_list_i])) begin
      first_q[insert_list_i] <= insert_bucket_i;
    end
    if (chain_ends) first_q[list_q] <= {own_left ? at : other_q, place};
  end

  // --- free places --------------------------------------------------------------------------------------------------
  logic           place_valid;
  logic [NodeW:0] taken;

  pipegs_slot_pool #(.Slots(Nodes)) u_places (
    .clk_i,
    .rst_ni,
    .renew_i(1'b0),
    .slot_valid_o(place_valid),
    .slot_ready_i(take_insert),
    .slot_o(free_place),
    .free_i(out_valid_o),
    .free_slot_i(place_q),
    .used_o(taken),
    .active_o()
  );
  assign full_o    = !place_valid;
  assign crowded_o = taken >= (NodeW+1)'(Nodes / 4 * 3);

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!take_pop || first_valid_o[pop_list_i]);
`endif

endmodule
