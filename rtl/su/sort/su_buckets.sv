// SPDX-License-Identifier: Apache-2.0
// su_buckets: the records of an SU in buckets of depth, and their release, nearest bucket first.
//
// Paper   Sec. 4.2.2 sorts what is complete; the buckets let go of what is complete earlier.
// Idea    A bucket is the leading bits of the depth, absolute; its records are a chain of slots {head, tail, count}.
//         Two sets of buckets, so that one layer is collected while the former is released. Which buckets are filled
//         stands in words of bits (SRAM), which words are not zero in registers: the first filled bucket is the first
//         bit of the first word. A release takes the words below its mark, clears them, and walks along their bits;
//         neighbours are joined while they hold at most sixteen records. Records that come later lie above the mark.
// Stream  insert: a slot to a bucket. job: release everything below job_bucket_i, or all; stays until job_done_o.
//         chain: released chains, then the end of kind job_kind_i (none when that is KindData). link: writes of links.
// Pace    One record per two cycles, one bucket per cycle where none comes, a record and a bucket per three cycles; an
//         empty bucket costs nothing.
// Model   Plumbing; the whole SU is tested against cpp_model/su/su.hpp.

module su_buckets (
  input  logic                           clk_i,
  input  logic                           rst_ni,

  input  logic                           insert_valid_i,
  output logic                           insert_ready_o,
  input  logic                           insert_set_i,
  input  logic [pipegs_pkg::BucketW-1:0] insert_bucket_i,
  input  logic [pipegs_pkg::BucketW-1:0] arrives_bucket_i,  // the same, where there may be a job
  input  logic [pipegs_pkg::RecordW-1:0] insert_slot_i,

  input  logic                           job_valid_i,
  output logic                           job_done_o,
  input  logic                           job_set_i,
  input  logic                           job_all_i,
  input  logic [pipegs_pkg::BucketW-1:0] job_bucket_i,
  input  logic [pipegs_pkg::KindW-1:0]   job_kind_i,

  output logic                           chain_push_o,    // into a queue, ...
  input  logic                           chain_room_i,    // ... which has room
  output logic [pipegs_pkg::KindW-1:0]   chain_kind_o,    // KindData: a chain
  output logic [pipegs_pkg::RecordW-1:0] chain_head_o,
  output logic [pipegs_pkg::RecordW:0]   chain_count_o,
  output logic [pipegs_pkg::BucketW-1:0] chain_bucket_o,  // of all its records if they are more than sixteen
  input  logic                           hungry_i,        // nobody sorts: do not wait for neighbours

  output logic                           link_write_o,
  input  logic                           link_ready_i,
  output logic [pipegs_pkg::RecordW-1:0] link_slot_o,
  output logic [pipegs_pkg::RecordW-1:0] link_o,

  output logic                           active_o
);

  localparam int unsigned BucketW = pipegs_pkg::BucketW;
  localparam int unsigned RecordW = pipegs_pkg::RecordW;
  localparam int unsigned LowW = (BucketW + 1) / 2;  // bucket = {word, bit}
  localparam int unsigned HighW = BucketW - LowW;
  localparam int unsigned Words = 2 ** HighW;
  localparam int unsigned WordBits = 2 ** LowW;
  localparam int unsigned Group = 16;
  localparam int unsigned GroupW = $clog2(Group + 1);

  // Each operation reads in one cycle and ends in the next; the next one may read in that cycle unless it needs what
  // the former writes, or the table, which has one port, while the former writes there.
  typedef enum logic [1:0] {
    None,
    Insert,  // a record enters its bucket
    Word,    // the filled buckets of a word are taken for release
    Entry    // one of them is read and leaves
  } operation_e;
  operation_e operation_q, operation_d;
  logic       ends;  // the present operation ends in this cycle

  // --- the record that is inserted ----------------------------------------------------------------------------------
  logic               set_q;
  logic [BucketW-1:0] bucket_q;
  logic [RecordW-1:0]   slot_q;
  logic               filled, held;  // its bucket, its word
  logic [RecordW-1:0]   head, tail;
  logic [RecordW:0]     count;

  // --- the release --------------------------------------------------------------------------------------------------
  logic [2*Words-1:0]  held_q;       // words that are not zero, of both sets
  logic                some_word;    // the present job still has words to take
  logic [HighW-1:0]    first_word, first_0, first_1, word_q;
  logic                edge_q;       // the word that the mark cuts was taken
  logic [WordBits-1:0] work_q;       // buckets of word_q that were taken and not yet read
  logic [LowW-1:0]     first_bit;
  logic [WordBits-1:0] word, below, left, with_bucket;
  logic                word_wanted, quiet;
  logic [HighW-1:0]    job_high;
  logic [LowW-1:0]     job_low;

  assign {job_high, job_low} = job_bucket_i;
  // A job takes a set's first words; whether it takes the very first one is all that hangs on its mark, a late signal.
  pipegs_first_set #(.DataW(Words)) u_first_0 (
    .mask_i(held_q[Words-1:0]),
    .one_hot_o(),
    .number_o(first_0)
  );
  pipegs_first_set #(.DataW(Words)) u_first_1 (
    .mask_i(held_q[2*Words-1:Words]),
    .one_hot_o(),
    .number_o(first_1)
  );
  assign first_word = job_set_i ? first_1 : first_0;
  assign some_word  = job_valid_i && (job_set_i ? held_q[2*Words-1:Words] != '0 : held_q[Words-1:0] != '0) &&
                      (job_all_i || first_word < job_high ||
                       (first_word == job_high && !edge_q && job_low != '0));
  always_comb begin
    for (int unsigned i = 0; i < WordBits; i += 1) below[i] = job_all_i || word_q != job_high || LowW'(i) < job_low;
  end
  pipegs_first_set #(.DataW(WordBits)) u_bit (
    .mask_i(work_q),
    .one_hot_o(),
    .number_o(first_bit)
  );
  assign word_wanted = some_word && work_q == '0 && operation_q != Word;
  assign quiet       = !some_word && work_q == '0 && operation_q == None;  // an insertion may still fill a bucket

  // --- what is done next --------------------------------------------------------------------------------------------
  logic insert_reads, entry_reads, word_reads, same_word, insert_waits, chain_due;
  logic inserted_q, entry_turn;  // an insertion has ended: now a bucket that waits, before the next one
  assign entry_turn   = inserted_q && work_q != '0 && chain_room_i;
  // Is the word that an insertion is about to read, or has read, the one that the release takes?
  assign same_word    = operation_q == Insert ? {set_q, bucket_q[BucketW-1:LowW]} == {job_set_i, first_word}
                                              : {insert_set_i, arrives_bucket_i[BucketW-1:LowW]} == {job_set_i, word_q};
  assign insert_waits = word_wanted || operation_q == Insert || (operation_q == Word && same_word) || entry_turn;
  always_comb begin
    operation_d = None;
    if (word_wanted) operation_d = operation_q == Insert && same_word ? None : Word;
    else if (insert_valid_i && !insert_waits) operation_d = Insert;
    else if (work_q != '0 && chain_room_i && !chain_due && operation_q != Insert) operation_d = Entry;
    if (!ends) operation_d = None;
  end
  assign insert_ready_o = ends && !insert_waits;
  assign insert_reads   = operation_d == Insert;
  assign word_reads     = operation_d == Word;
  assign entry_reads    = operation_d == Entry;

  pipegs_sram #(.DataW(2 * RecordW + RecordW + 1), .Depth(2 ** (BucketW + 1)), .Ports(1)) u_table (
    .clk_i,
    .write_i(operation_q == Insert && ends),
    .waddr_i({set_q, bucket_q}),
    .wdata_i({filled ? tail : slot_q, slot_q, filled ? count + 1'b1 : (RecordW+1)'(1)}),
    .read_i(insert_reads || entry_reads),
    .raddr_i(insert_reads ? {insert_set_i, insert_bucket_i} : {job_set_i, word_q, first_bit}),
    .rdata_o({tail, head, count})
  );
  pipegs_sram #(.DataW(WordBits), .Depth(2 * Words)) u_words (
    .clk_i,
    .write_i((operation_q == Insert && !filled) || operation_q == Word),
    .waddr_i(operation_q == Insert ? {set_q, bucket_q[BucketW-1:LowW]} : {job_set_i, word_q}),
    .wdata_i(operation_q == Insert ? with_bucket : left),
    .read_i(insert_reads || word_reads),
    .raddr_i(insert_reads ? {insert_set_i, insert_bucket_i[BucketW-1:LowW]} : {job_set_i, first_word}),
    .rdata_o(word)
  );
  assign held   = held_q[{set_q, bucket_q[BucketW-1:LowW]}];
  assign filled = held && word[bucket_q[LowW-1:0]];
  assign left   = word & ~below;
  always_comb begin
    with_bucket = held ? word : '0;
    with_bucket[bucket_q[LowW-1:0]] = 1'b1;
  end

  // --- the group that is being joined -------------------------------------------------------------------------------
  logic               group_valid_q, fits, join_group, push_group;
  logic [RecordW-1:0]   group_head_q, group_tail_q;
  logic [RecordW:0]     group_count_q;
  logic [BucketW-1:0] group_bucket_q, entry_bucket_q;

  // Neither alone is more than a group, so that the sum is short.
  assign fits       = group_count_q <= (RecordW+1)'(Group) && count <= (RecordW+1)'(Group) &&
                      {1'b0, group_count_q[GroupW-1:0]} + {1'b0, count[GroupW-1:0]} <= (GroupW+1)'(Group);
  assign join_group = operation_q == Entry && group_valid_q && fits;
  assign push_group = group_valid_q && (operation_q == Entry ? !fits : (quiet || hungry_i));

  assign link_write_o = (operation_q == Insert && filled) || join_group;
  assign link_slot_o  = operation_q == Insert ? slot_q : group_tail_q;
  assign link_o       = head;
  assign ends         = !link_write_o || link_ready_i;

  assign chain_due      = push_group || (job_valid_i && quiet && job_kind_i != pipegs_pkg::KindData);
  assign chain_push_o   = chain_due && chain_room_i;
  assign chain_kind_o   = push_group ? pipegs_pkg::KindData : job_kind_i;
  assign chain_head_o   = group_head_q;
  assign chain_count_o  = group_count_q;
  assign chain_bucket_o = group_bucket_q;
  assign job_done_o     = job_valid_i && quiet && !group_valid_q && (chain_room_i ||
                          job_kind_i == pipegs_pkg::KindData);
  assign active_o       = operation_q != None || operation_d != None || inserted_q || chain_push_o || job_done_o;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      operation_q   <= None;
      inserted_q    <= 1'b0;
      held_q        <= '0;
      work_q        <= '0;
      edge_q        <= 1'b0;
      group_valid_q <= 1'b0;
    end else begin
      if (ends) operation_q <= operation_d;
      inserted_q <= operation_q == Insert;
      if (operation_q == Insert) held_q[{set_q, bucket_q[BucketW-1:LowW]}] <= 1'b1;
      if (operation_q == Word) begin
        held_q[{job_set_i, word_q}] <= left != '0;
        work_q <= word & below;
      end
      if (entry_reads) work_q[first_bit] <= 1'b0;
      if (job_done_o) edge_q <= 1'b0;
      else if (operation_q == Word && word_q == job_high) edge_q <= 1'b1;
      if (push_group && chain_room_i) group_valid_q <= 1'b0;
      if (operation_q == Entry && ends) group_valid_q <= 1'b1;
    end
  end

  always_ff @(posedge clk_i) begin
    if (insert_reads) begin
      set_q    <= insert_set_i;
      bucket_q <= insert_bucket_i;
      slot_q   <= insert_slot_i;
    end
    if (word_reads) word_q <= first_word;
    if (entry_reads) entry_bucket_q <= {word_q, first_bit};
    if (operation_q == Entry && ends) begin
      group_tail_q <= tail;
      if (join_group) begin
        group_count_q <= group_count_q + count;
      end else begin
        group_head_q   <= head;
        group_count_q  <= count;
        group_bucket_q <= entry_bucket_q;
      end
    end
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!(operation_q == Entry && push_group) || chain_room_i);
  always_ff @(posedge clk_i) if (rst_ni)
    assert (!(insert_valid_i && operation_q == Word) || insert_bucket_i == arrives_bucket_i);
`endif

endmodule
