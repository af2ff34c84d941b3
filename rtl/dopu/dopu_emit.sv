// SPDX-License-Identifier: Apache-2.0
// dopu_emit: hands chunks to the PUs, and ends to all of them.
//
// Paper   Fig. 7 (DOPU feeds four PUs).
// Idea    A chunk goes to one PU: the next one in turn that says it has room, which a PU without a front never does;
//         once shown it stays there. An end goes to every PU, each takes it in its own time. A layer end is sent only
//         if the layer had a chunk.
// Stream  chunk in, in the order of the walk; chunk_valid_o has one bit per PU, the beat is shared. Room is no ready:
//         it may not wait for valid, and a PU that cannot tell says yes.
// Pace    One chunk in two cycles.
// Model   None: the bit-accurate model's chunks and ends, in any split among the PUs (verif/dopu/dopu_test.cpp).

module dopu_emit (
  input  logic                          clk_i,
  input  logic                          rst_ni,

  input  logic                          in_valid_i,
  output logic                          in_ready_o,
  input  pipegs_pkg::chunk_t            in_i,

  output logic [pipegs_pkg::Units-1:0]  chunk_valid_o,
  input  logic [pipegs_pkg::Units-1:0]  chunk_ready_i,
  input  logic [pipegs_pkg::Units-1:0]  chunk_room_i,   // PUs that one may choose for a chunk
  output pipegs_pkg::chunk_t            chunk_o
);

  localparam int unsigned Units = pipegs_pkg::Units;
  localparam int unsigned ChoiceW = Units > 1 ? $clog2(Units) : 1;

  logic [Units-1:0]   valid_q, chosen;
  logic [ChoiceW-1:0]   last_q, choice;  // who got the chunk before, who gets the next
  logic               had_chunk_q;     // in this layer
  logic               is_data, drop, take;
  pipegs_pkg::chunk_t chunk_q;

  pipegs_round_robin #(.Ports(Units)) u_turn (
    .mask_i(chunk_room_i),
    .last_i(last_q),
    .choice_o(choice)
  );
  always_comb begin
    chosen = '0;
    chosen[choice] = 1'b1;
  end

  assign is_data    = in_i.kind == pipegs_pkg::KindData;
  assign drop       = in_i.kind == pipegs_pkg::KindLayerEnd && !had_chunk_q;
  assign in_ready_o = valid_q == '0 && (!is_data || chunk_room_i != '0);
  assign take       = in_valid_i && in_ready_o;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      valid_q     <= '0;
      last_q      <= '0;
      had_chunk_q <= 1'b0;
    end else begin
      valid_q <= valid_q & ~chunk_ready_i;
      if (take) begin
        valid_q     <= is_data ? chosen : {Units{!drop}};
        had_chunk_q <= is_data;
        if (is_data) last_q <= choice;
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (take) chunk_q <= in_i;
  end
  assign chunk_valid_o = valid_q;
  assign chunk_o       = chunk_q;

`ifndef SYNTHESIS
  pipegs_stream_check #(.Ports(pipegs_pkg::Units), .Shared(1), .DataW($bits(chunk_o))) u_check_chunk (
    .clk_i,
    .rst_ni,
    .valid_i(chunk_valid_o),
    .ready_i(chunk_ready_i),
    .beat_i(chunk_o)
  );
`endif

endmodule
