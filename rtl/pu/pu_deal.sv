// SPDX-License-Identifier: Apache-2.0
// pu_deal: deals the Gaussians that survive the culls to the PUs, so that all of them have the same to do.
//
// Paper   Table 2 (four PUs); the paper does not say how Gaussians are shared among them.
// Idea    A chunk goes to the fetch and cull of one PU (of PuFronts that have them), but chunks differ a hundredfold in
//         work: 32 screen-filling splats or 32 specks. So survivors of all culls are dealt one by one to whichever PU
//         has room, in turn. The sort behind makes the image independent of who gets which. A layer's end waits until
//         all culls have reached it and goes to all PUs. What the second eye sees of the Gaussian dealt last goes to
//         the same PU: it has the line of its colours (pu_color_fetch). So with two eyes a PU has room when it has it
//         for two.
// Stream  visible from each cull; visible to each PU, one record for all with one valid each. Room is no ready: it may
//         not wait for valid, and a PU that cannot tell says yes.
// Pace    One Gaussian per cycle (with a single PU every second one), latency one. A second eye's view comes a cycle
//         later.
// Model   Any dealing is right: the test checks that each Gaussian arrives once, in its layer.

module pu_deal #(
  localparam int unsigned Units  = pipegs_pkg::Units,
  localparam int unsigned Fronts = pipegs_pkg::PuFronts,
  localparam int unsigned Bits   = pipegs_pkg::VisibleBits
) (
  input  logic                   clk_i,
  input  logic                   rst_ni,

  input  logic [Fronts-1:0]      in_valid_i,
  output logic [Fronts-1:0]      in_ready_o,
  input  logic [Fronts*Bits-1:0] in_i,

  output logic [Units-1:0]       out_valid_o,
  input  logic [Units-1:0]       out_ready_i,
  input  logic [Units-1:0]       out_room_i,   // PUs that one may choose; not to be asked for a second eye's view
  output pipegs_pkg::visible_t   out_o,

  output logic                   active_o
);

  localparam int unsigned FrontW = Fronts > 1 ? $clog2(Fronts) : 1;
  localparam int unsigned UnitW  = Units > 1 ? $clog2(Units) : 1;
  localparam int unsigned SlotAt = Bits - pipegs_pkg::EyeW - pipegs_pkg::SlotW;  // of a visible_t

  logic [Fronts-1:0]    is_end, data, asking, source;
  logic [FrontW-1:0]    source_port;
  logic [Units-1:0]     room, target;
  logic [UnitW-1:0]     in_turn, target_port, last_q;  // last_q: the PU that was dealt to last
  logic                 paired, free, take_data, take_end;
  logic [Units-1:0]     waiting_q;  // PUs that have still to take the record
  typedef struct packed {logic [Fronts-1:0][Bits-1:0] of;} visibles_t;
  visibles_t            heads;
  pipegs_pkg::visible_t out_q;

  assign heads = in_i;

  always_comb begin
    for (int unsigned i = 0; i < Fronts; i += 1) begin
      is_end[i] = in_valid_i[i] && heads.of[i][pipegs_pkg::KindW-1:0] != pipegs_pkg::KindData;
    end
  end
  assign data = in_valid_i & ~is_end;
  assign free = (waiting_q & ~out_ready_i) == '0;

  // --- the other eye's view of the Gaussian dealt last ---------------------------------------------------------------
  if (pipegs_pkg::Eyes > 1) begin : gen_pairs
    localparam int unsigned SlotW = pipegs_pkg::SlotW;
    logic [Fronts-1:0] second;
    logic              dealt_q;  // in this layer
    logic [SlotW-1:0]  slot_q;
    always_comb begin
      for (int unsigned i = 0; i < Fronts; i += 1) begin
        second[i] = dealt_q && data[i] && heads.of[i][SlotAt +: SlotW] == slot_q;
      end
    end
    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) dealt_q <= 1'b0;
      else if (take_data || take_end) dealt_q <= take_data;
    end
    always_ff @(posedge clk_i) if (take_data) slot_q <= heads.of[source_port][SlotAt +: SlotW];
    assign paired = second != '0;
    assign asking = paired ? second : data;
  end else begin : gen_alone
    assign paired = 1'b0;
    assign asking = data;
  end

  pipegs_arbiter #(.Ports(Fronts)) u_source (
    .clk_i,
    .rst_ni,
    .request_i(asking),
    .advance_i(take_data),
    .grant_o(source),
    .port_o(source_port)
  );
  // A PU that takes the present record in this cycle may have filled its queue with it.
  assign room = out_room_i & ~waiting_q;
  pipegs_round_robin #(.Ports(Units)) u_target (
    .mask_i(room),
    .last_i(last_q),
    .choice_o(in_turn)
  );
  assign target_port = paired ? last_q : in_turn;
  always_comb begin
    target              = '0;
    target[target_port] = paired ? !waiting_q[last_q] : room[target_port];
  end

  assign take_data  = free && data != '0 && target != '0;
  assign take_end   = free && is_end == '1;
  assign in_ready_o = take_end ? '1 : take_data ? source : '0;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) waiting_q <= '0;
    else if (take_end) waiting_q <= '1;
    else if (take_data) waiting_q <= target;
    else waiting_q <= waiting_q & ~out_ready_i;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) last_q <= '0;
    else if (take_data) last_q <= target_port;
  end

  always_ff @(posedge clk_i) begin
    if (take_data || take_end) out_q <= heads.of[source_port];
  end

  assign out_valid_o = waiting_q;
  assign out_o       = out_q;
  assign active_o    = in_valid_i != '0 || waiting_q != '0;

`ifndef SYNTHESIS
  pipegs_stream_check #(.Ports(Units), .Shared(1), .DataW($bits(out_o))) u_check_out (
    .clk_i,
    .rst_ni,
    .valid_i(out_valid_o),
    .ready_i(out_ready_i),
    .beat_i(out_o)
  );
`endif

endmodule
