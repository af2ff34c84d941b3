// SPDX-License-Identifier: Apache-2.0
// pu_marks: keeps the watermark of a layer's end while that end goes through the PU (Order 2).
//
// Idea    Ends leave in the order in which they came, so a queue of watermarks is enough. An end waits before the PU
//         when sixteen are inside.
// Stream  chunk in and out: an end only when there is room for its watermark. splat in and out: a layer's end gets the
//         oldest watermark as its depth.
// Pace    Combinational both ways.
// Model   None: the streams of the machine show it.

module pu_marks (
  input  logic               clk_i,
  input  logic               rst_ni,

  input  logic               chunk_valid_i,
  output logic               chunk_ready_o,
  input  pipegs_pkg::chunk_t chunk_i,
  output logic               chunk_valid_o,  // to the PU
  input  logic               chunk_ready_i,

  input  pipegs_pkg::splat_t splat_i,        // from the PU
  output pipegs_pkg::splat_t splat_o,
  input  logic               splat_taken_i
);

  localparam int unsigned Marks  = pipegs_pkg::PuMarks;
  localparam int unsigned DepthW = pipegs_pkg::DepthW;

  logic                       chunk_is_end, splat_is_end, room, held;
  logic [DepthW-1:0]          mark;
  logic [$clog2(Marks+1)-1:0] count;

  assign chunk_is_end  = chunk_i.kind == pipegs_pkg::KindLayerEnd;
  assign splat_is_end  = splat_i.kind == pipegs_pkg::KindLayerEnd;
  assign chunk_valid_o = chunk_valid_i && (room || !chunk_is_end);
  assign chunk_ready_o = chunk_ready_i && (room || !chunk_is_end || !chunk_valid_i);

  pipegs_fifo #(.DataW(DepthW), .Depth(Marks)) u_marks (
    .clk_i,
    .rst_ni,
    .in_valid_i(chunk_valid_i && chunk_ready_i && chunk_is_end),
    .in_ready_o(room),
    .in_i(chunk_i.watermark),
    .out_valid_o(held),
    .out_ready_i(splat_taken_i && splat_is_end),
    .out_o(mark),
    .count_o(count)
  );

  always_comb begin
    splat_o = splat_i;
    if (splat_is_end) splat_o.depth = mark;
  end

  logic unused;
  assign unused = &{1'b0, chunk_i, held, count};

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!(splat_taken_i && splat_is_end) || held)
    else $error("a layer's end has no watermark");
  pipegs_stream_check u_check_chunk (
    .clk_i,
    .rst_ni,
    .valid_i(chunk_valid_o),
    .ready_i(chunk_ready_i),
    .beat_i(1'b0)
  );
`endif

endmodule
