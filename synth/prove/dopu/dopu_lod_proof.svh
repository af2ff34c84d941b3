// SPDX-License-Identifier: Apache-2.0
// The end of rtl/dopu/nearest/dopu_lod.sv in its proof: a group opens its own chunks or those of its proxies, never
// both and never neither.
//
// Rule    What is opened is all of the group's own chunks, or begins behind the last of them, holds at least one and
//         room for two proxies of each; without a level, or with the largest error, it is the group's own. Nearer or
//         with a finer level no group takes proxies that does not where it lies.
// Assumes A group has 1 to Group chunks, and slots enough behind them.

logic [CountW-1:0]          opened_count;
logic [SlotW-1:0]           opened_first;
logic [ErrorW-1:0]          opened_error;
(* anyseq *) logic [StepW-1:0]   finer_lod;
(* anyseq *) logic [BucketW-1:0] nearer_bucket;
logic signed [SumW-1:0]     finer_least;
logic                       finer_coarse;

assign {opened_error, opened_count, opened_first} = range_o;
assign finer_least  = $signed(SumW'(error) << Coarser) + $signed(SumW'(finer_lod)) - $signed(SumW'(near_step_i));
assign finer_coarse = finer_lod != '0 && error != '1 &&
                      (finer_least[SumW-1] || SumW'(nearer_bucket) >= $unsigned(finer_least));

always_comb begin
  assume (count != '0 && 32'(count) <= pipegs_pkg::Group);
  assume (first < SlotW'(2 ** (SlotW - 1)));
  assume (finer_lod >= lod_i && nearer_bucket <= bucket_i);
  assert (opened_error == '0 && opened_count != '0);
  if (opened_first == first) assert (opened_count == count);
  else begin
    assert (opened_first == first + SlotW'(count));
    assert (32'(opened_count) * pipegs_pkg::Chunk >= 32'(count) * pipegs_pkg::ChunkProxies);
    assert ((32'(opened_count) - 1) * pipegs_pkg::Chunk < 32'(count) * pipegs_pkg::ChunkProxies);
    assert (lod_i != '0 && error != '1);
  end
  assert (!finer_coarse || opened_first != first || lod_i == '0);
end
