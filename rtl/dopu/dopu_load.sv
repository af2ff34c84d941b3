// SPDX-License-Identifier: Apache-2.0
// dopu_load: whether a window holds so much that its parts are walked one after the other.
//
// Paper   None: the paper's windows are walked whole.
// Idea    The Gaussians of the groups that pass are added up, as many to a chunk as it has room for. Too much are more
//         than most_i, or more groups than half of the places in which they wait. The rule stands here alone: whatever
//         is judged gives the same pixels.
// Stream  judges_o: there are trials at all. group: one that passes; counted_i: all of the window have come, none in
//         the same cycle or the one before. judged_o ends the trial, in parts_o how; the next one begins with a group.
// Pace    A group per cycle.
// Model   cpp_model/dopu/dopu_load.hpp

module dopu_load #(
  localparam int unsigned MostW  = pipegs_pkg::WalkMostW,
  localparam int unsigned CountW = pipegs_pkg::CountW
) (
  input  logic              clk_i,
  input  logic              rst_ni,
  input  logic [MostW-1:0]  most_i,  // constant while a frame runs

  output logic              judges_o,
  input  logic              group_valid_i,
  input  logic [CountW-1:0] group_chunks_i,
  input  logic              counted_i,
  output logic              judged_o,
  output logic              parts_o
);

  localparam int unsigned ChunkF = $clog2(pipegs_pkg::Chunk);
  localparam int unsigned AddedW = CountW + ChunkF;
  localparam int unsigned SumW   = (MostW > AddedW ? MostW : AddedW) + 1;
  localparam int unsigned Places = pipegs_pkg::NearestNodes / 2;
  localparam int unsigned PlaceW = $clog2(Places + 1);

  logic [MostW-1:0]  sum_q;     // while it is not too much
  logic [PlaceW-1:0] groups_q;
  logic [SumW-1:0]   sum;
  logic              parts_q;

  assign judges_o = most_i != '0;
  assign judged_o = counted_i || parts_q;
  assign parts_o  = parts_q;
  assign sum      = SumW'(sum_q) + (SumW'(group_chunks_i) << ChunkF);

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      sum_q    <= '0;
      groups_q <= '0;
      parts_q  <= 1'b0;
    end else if (judged_o) begin
      sum_q    <= '0;
      groups_q <= '0;
      parts_q  <= 1'b0;
    end else if (group_valid_i) begin
      sum_q    <= MostW'(sum);
      groups_q <= groups_q + 1'b1;
      parts_q  <= sum > SumW'(most_i) || groups_q == PlaceW'(Places);
    end
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!(counted_i && group_valid_i));
`endif

endmodule
