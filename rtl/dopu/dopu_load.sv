// SPDX-License-Identifier: Apache-2.0
// dopu_load: whether a window holds so much that its eyes, or its parts, are walked one after the other.
//
// Paper   None: the paper's windows are walked whole.
// Idea    What must wait at once lies at about one depth. A group that passes counts, with as many Gaussians to a chunk
//         as it has room for, in every bucket of depth from its nearest to its farthest corner. What begins in a bucket
//         and what has ended before it are added up in two SRAMs, a word for Word buckets, with a bit that says whether
//         it was written. When all groups have come, and are more than most_i together, word after word is read. Too
//         much is a bucket that holds more than most_i, or more groups than half of the places in which they wait; for
//         both eyes together, which make two records of a Gaussian, one with more than half of most_i. The rule stands
//         here alone: whatever is judged gives the same pixels.
// Stream  judges_o: there are trials at all. group: one that passes; counted_i: all of the window have come, none in
//         the same cycle or the one before. judged_o ends the trial: split_o, it is given up, parts_o, for each part
//         alone and not for each eye; the next one begins with a group.
// Pace    A group per cycle; judged at once where all together is not too much, else after up to Words + 4 cycles.
// Model   cpp_model/dopu/dopu_load.hpp

module dopu_load #(
  localparam int unsigned MostW  = pipegs_pkg::WalkMostW,
  localparam int unsigned CountW = pipegs_pkg::CountW,
  localparam int unsigned LoadW  = pipegs_pkg::LoadW
) (
  input  logic              clk_i,
  input  logic              rst_ni,
  input  logic [MostW-1:0]  most_i,  // constant while a frame runs, as is
  input  logic              pair_i,  // both eyes are wanted

  output logic              judges_o,
  input  logic              group_valid_i,
  input  logic [CountW-1:0] group_chunks_i,  // at most Group
  input  logic [LoadW-1:0]  group_near_i,    // buckets
  input  logic [LoadW-1:0]  group_far_i,
  input  logic              counted_i,
  output logic              judged_o,
  output logic              split_o,
  output logic              parts_o
);

  localparam int unsigned ChunkF   = $clog2(pipegs_pkg::Chunk);
  localparam int unsigned Places   = pipegs_pkg::NearestNodes / 2;
  localparam int unsigned PlaceW   = $clog2(Places + 1);
  localparam int unsigned AddedW   = $clog2(pipegs_pkg::Group + 1);
  localparam int unsigned SumW     = $clog2((Places + 1) * pipegs_pkg::Group + 1);  // chunks of a window
  localparam int unsigned Word     = 4;
  localparam int unsigned Words    = 2 ** LoadW / Word;
  localparam int unsigned WordW    = $clog2(Words);
  localparam int unsigned WordBits = Word * SumW;

  // --- the verdict ---------------------------------------------------------------------------------------------------
  logic [SumW-1:0]         sum_q;     // chunks
  logic [PlaceW-1:0]       groups_q;
  logic [MostW-ChunkF-1:0] most;      // chunks that are not too much
  logic [MostW-ChunkF-1:0] together;  // likewise for all eyes that are wanted
  logic                    fits, parts_q, eyes_q, whole_q, counted_q, reading_q, over, crowded, last;
  logic                    come;      // a group of the window on trial

  assign most     = most_i[MostW-1:ChunkF];
  assign judges_o = most_i != '0;
  assign together = pipegs_pkg::Eyes > 1 && pair_i ? most >> 1 : most;
  assign fits     = (MostW-ChunkF)'(sum_q) <= together;
  assign judged_o = (counted_i && fits) || parts_q || eyes_q || whole_q;
  assign split_o  = parts_q || eyes_q;
  assign parts_o  = parts_q;
  assign come     = group_valid_i && !judged_o;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      sum_q     <= '0;
      groups_q  <= '0;
      parts_q   <= 1'b0;
      eyes_q    <= 1'b0;
      whole_q   <= 1'b0;
      counted_q <= 1'b0;
      reading_q <= 1'b0;
    end else if (judged_o) begin
      sum_q     <= '0;
      groups_q  <= '0;
      parts_q   <= 1'b0;
      eyes_q    <= 1'b0;
      whole_q   <= 1'b0;
      counted_q <= 1'b0;
      reading_q <= 1'b0;
    end else begin
      if (group_valid_i) begin
        sum_q    <= sum_q + SumW'(group_chunks_i);
        groups_q <= groups_q + 1'b1;
      end
      counted_q <= counted_i;
      if (counted_q) reading_q <= 1'b1;
      parts_q <= over || (group_valid_i && groups_q == PlaceW'(Places));
      eyes_q  <= last && !over && crowded;
      whole_q <= last && !over && !crowded;
    end
  end

  // --- groups by depth: in cycle 1 the words are read, in cycle 2 they are written -----------------------------------
  logic                come0_q, come1_q, come2_q;
  logic [AddedW-1:0]   chunks0_q, chunks1_q, chunks2_q;
  logic [LoadW-1:0]    near0_q, far0_q;
  logic [LoadW:0]      behind;               // the bucket behind the group's last one, beyond all when that is the last
  logic [LoadW-1:0]    bucket1_q [2];        // 0: where it begins, 1: behind
  logic                within1_q, within2_q;  // there is one behind
  logic [WordW:0]      word_q;               // the next one that is read for the verdict
  logic                reads, read1_q, read2_q;
  logic [WordBits-1:0] words [2];           // in cycle 2

  assign behind = {1'b0, far0_q > near0_q ? far0_q : near0_q} + 1'b1;
  assign reads  = reading_q && !word_q[WordW];
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      {come0_q, come1_q, come2_q} <= '0;
      {read1_q, read2_q} <= '0;
      word_q             <= '0;
    end else begin
      come0_q <= come;
      come1_q <= come0_q && !judged_o;
      come2_q <= come1_q && !judged_o;
      read1_q <= reads && !judged_o;
      read2_q <= read1_q && !judged_o;
      if (!reading_q) word_q <= '0;
      else if (reads) word_q <= word_q + 1'b1;
    end
  end
  always_ff @(posedge clk_i) begin
    {chunks0_q, near0_q, far0_q} <= {AddedW'(group_chunks_i), group_near_i, group_far_i};
    chunks1_q <= chunks0_q;
    chunks2_q <= chunks1_q;
    {within1_q, bucket1_q[1]} <= {!behind[LoadW], behind[LoadW-1:0]};
    bucket1_q[0] <= near0_q;
    within2_q    <= within1_q;
  end

  for (genvar k = 0; k < 2; k += 1) begin : gen_sums
    logic [Words-1:0]        some_q;          // words that were written
    logic [WordW-1:0]        at, at_q;
    logic [$clog2(Word)-1:0] place_q;
    logic                    write, again_q;  // again: what is read is the word that is just written
    logic [WordBits-1:0]     read, held, sums, sums_q;

    assign at    = reads ? word_q[WordW-1:0] : bucket1_q[k][LoadW-1:$clog2(Word)];
    assign write = come2_q && !judged_o && (k == 0 || within2_q);
    assign held  = again_q ? sums_q : some_q[at_q] ? read : '0;
    always_comb begin
      sums = held;
      sums[place_q*SumW +: SumW] = held[place_q*SumW +: SumW] + SumW'(chunks2_q);
    end
    assign words[k] = held;
    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) some_q <= '0;
      else if (judged_o) some_q <= '0;
      else if (write) some_q[at_q] <= 1'b1;
    end
    always_ff @(posedge clk_i) begin
      at_q    <= at;
      place_q <= bucket1_q[k][$clog2(Word)-1:0];
      again_q <= write && at == at_q;
      if (write) sums_q <= sums;
    end

    pipegs_sram #(.DataW(WordBits), .Depth(Words)) u_sums (
      .clk_i,
      .write_i(write),
      .waddr_i(at_q),
      .wdata_i(sums),
      .read_i(reads || come1_q),
      .raddr_i(at),
      .rdata_o(read)
    );
  end

  // --- what each bucket of a word holds, from the nearest on ---------------------------------------------------------
  logic [SumW-1:0] change [Word];  // from the bucket before
  logic [SumW-1:0] first_q, second_q, third_q, fourth_q;  // changes: one bucket's, two's; again of the next two
  logic [SumW-1:0] before_q;       // the last bucket of the word before
  logic [SumW-1:0] load [Word];

  always_comb begin
    load[0] = before_q + first_q;
    load[1] = before_q + second_q;
    load[2] = load[1] + third_q;
    load[3] = load[1] + fourth_q;
    over    = 1'b0;
    for (int unsigned i = 0; i < Word; i += 1) begin
      change[i] = words[0][i*SumW +: SumW] - words[1][i*SumW +: SumW];
      if (read2_q && (MostW-ChunkF)'(load[i]) > most) over = 1'b1;
    end
  end
  assign last = read2_q && !read1_q;

  // --- too much for both eyes --------------------------------------------------------------------------------------
  if (pipegs_pkg::Eyes > 1) begin : gen_eyes
    logic some, some_q;
    always_comb begin
      some = 1'b0;
      for (int unsigned i = 0; i < Word; i += 1) if (read2_q && (MostW-ChunkF)'(load[i]) > together) some = 1'b1;
    end
    assign crowded = some || some_q;
    always_ff @(posedge clk_i) some_q <= reading_q && crowded;
  end else begin : gen_one_eye
    assign crowded = 1'b0;
  end

  always_ff @(posedge clk_i) begin
    first_q  <= change[0];
    second_q <= change[0] + change[1];
    third_q  <= change[2];
    fourth_q <= change[2] + change[3];
    before_q <= read2_q ? load[Word-1] : '0;
  end

  logic unused_chunks;  // no group has so many
  assign unused_chunks = ^group_chunks_i;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!(counted_i && (group_valid_i || come0_q)));
`endif

endmodule
