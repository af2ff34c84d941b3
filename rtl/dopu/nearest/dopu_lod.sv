// SPDX-License-Identifier: Apache-2.0
// dopu_lod: which children of a group are opened: its chunks, or those of its proxies, which lie behind them.
//
// Paper   None: level of detail.
// Idea    Both sides of "error <= lod_pixels depth / focal" are logarithms, steps of the depth key: the group's error
//         and the frame's lod are one sum, the near plane's step and the group's bucket the other. Of the bucket, which
//         comes last, only a comparison is needed.
// Stream  None: of a group its range in, the range that is opened out.
// Pace    Combinational.
// Model   cpp_model/dopu/nearest/dopu_lod.hpp

module dopu_lod #(
  localparam int unsigned SlotW     = pipegs_pkg::SlotW,
  localparam int unsigned CountW    = pipegs_pkg::CountW,
  localparam int unsigned ErrorW    = pipegs_pkg::ErrorW,
  localparam int unsigned ChildrenW = pipegs_pkg::ChildrenW,
  localparam int unsigned StepW     = pipegs_pkg::StepW,
  localparam int unsigned BucketW   = pipegs_pkg::BucketW
) (
  input  logic [StepW-1:0]            lod_i,        // of the frame; 0: no proxies
  input  logic [StepW-1:0]            near_step_i,  // of the near plane
  input  logic [ChildrenW+SlotW-1:0]  range_i,      // error, count, first
  input  logic [BucketW-1:0]          bucket_i,
  output logic [ChildrenW+SlotW-1:0]  range_o       // count, first
);

  localparam int unsigned Coarser = pipegs_pkg::BucketBits - pipegs_pkg::ErrorBits;  // bits that an error's step lacks
  localparam int unsigned Shift   = $clog2(pipegs_pkg::Chunk) - $clog2(pipegs_pkg::ChunkProxies);
  localparam int unsigned SumW    = StepW + 2;

  logic [ErrorW-1:0]       error;
  logic [CountW-1:0]       count, proxy_chunks;
  logic [SlotW-1:0]        first;
  logic signed [SumW-1:0]  least;  // the first bucket that takes proxies; negative: all do
  logic                    never, coarse;

  assign {error, count, first} = range_i;
  assign never        = lod_i == '0 || error == '1;
  assign least        = $signed(SumW'(error) << Coarser) + $signed(SumW'(lod_i)) - $signed(SumW'(near_step_i));
  assign coarse       = !never && (least[SumW-1] || SumW'(bucket_i) >= $unsigned(least));
  assign proxy_chunks = (count + CountW'(2 ** Shift - 1)) >> Shift;
  assign range_o      = coarse ? {{ErrorW{1'b0}}, proxy_chunks, first + SlotW'(count)} : {{ErrorW{1'b0}}, count, first};

endmodule
