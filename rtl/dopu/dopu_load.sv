// SPDX-License-Identifier: Apache-2.0
// dopu_load: whether a window holds so much that its parts are walked one after the other.
//
// Paper   None: the paper's windows are walked whole.
// Idea    The Gaussians of the groups that pass are added up, as many to a chunk as it has room for. One sum above
//         most_i is above it for good. The rule stands here alone: whatever is judged gives the same pixels.
// Stream  counts_o: windows are to be counted at all. group: one that passes; counted_i: all of the window have come,
//         none in the same cycle; then too_much_o is the answer, and the next window begins.
// Pace    A group per cycle.
// Model   cpp_model/dopu/dopu_load.hpp

module dopu_load #(
  localparam int unsigned MostW  = pipegs_pkg::WalkMostW,
  localparam int unsigned CountW = pipegs_pkg::CountW
) (
  input  logic              clk_i,
  input  logic              rst_ni,
  input  logic [MostW-1:0]  most_i,  // constant while a frame runs

  output logic              counts_o,
  input  logic              group_valid_i,
  input  logic [CountW-1:0] group_chunks_i,
  input  logic              counted_i,
  output logic              too_much_o
);

  localparam int unsigned ChunkF = $clog2(pipegs_pkg::Chunk);
  localparam int unsigned AddedW = CountW + ChunkF;
  localparam int unsigned SumW   = (MostW > AddedW ? MostW : AddedW) + 1;

  logic [MostW-1:0] sum_q;  // while it is not too much
  logic [SumW-1:0]  sum;
  logic             too_much_q;

  assign counts_o   = most_i != '0;
  assign too_much_o = too_much_q;
  assign sum        = SumW'(sum_q) + (SumW'(group_chunks_i) << ChunkF);

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      too_much_q <= 1'b0;
      sum_q      <= '0;
    end else if (counted_i) begin
      too_much_q <= 1'b0;
      sum_q      <= '0;
    end else if (group_valid_i) begin
      too_much_q <= too_much_q || sum > SumW'(most_i);
      sum_q      <= MostW'(sum);
    end
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!(counted_i && group_valid_i));
`endif

endmodule
