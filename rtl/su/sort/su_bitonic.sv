// SPDX-License-Identifier: Apache-2.0
// su_bitonic: sorts up to sixteen keys at a time with eight compare-exchange cells.
//
// Paper   Sec. 4.2.2, "16-channel Bitonic Sorter". Table 2 gives an SU 33 kGE, so one stage of the network is built and
//         used ten times; all ten stages side by side would need 60 kGE.
// Idea    for (size = 1..4) for (distance = size-1..0): channels a and a + 2^distance are compared and exchanged,
//         downwards where bit `size` of a is set. A batch of n keys needs only the sizes up to log2(n). Unused
//         channels are void, which is above every key.
// Stream  in: keys with their slots, `last` ends a batch of 1 to 16. out: the batch in ascending order. A batch of one
//         may be the end of a layer instead of a key: it only keeps its place among the others.
// Pace    One key per cycle in and out; 0, 1, 3, 6 or 10 cycles of sorting. While a batch leaves, the next is loaded
//         into the channels already emptied.
// Model   cpp_model/su/sort/su_bitonic.hpp

module su_bitonic (
  input  logic                           clk_i,
  input  logic                           rst_ni,

  input  logic                           in_valid_i,
  output logic                           in_ready_o,
  input  logic                           in_last_i,
  input  logic                           in_end_i,   // the batch is an end
  input  logic [pipegs_pkg::KeyW-1:0]    in_key_i,
  input  logic [pipegs_pkg::RecordW-1:0] in_slot_i,

  output logic                           out_valid_o,
  input  logic                           out_ready_i,
  output logic                           out_end_o,
  output logic [pipegs_pkg::KeyW-1:0]    out_key_o,
  output logic [pipegs_pkg::RecordW-1:0] out_slot_o,

  output logic                           idle_o,    // no key inside
  output logic                           active_o   // something moves in this cycle
);

  localparam int unsigned Channels = 16;
  localparam int unsigned Cells = Channels / 2;
  localparam int unsigned ChannelW = $clog2(Channels);
  localparam int unsigned DistanceW = $clog2(ChannelW);
  localparam int unsigned DataW = pipegs_pkg::KeyW + pipegs_pkg::RecordW;
  localparam int unsigned ItemW = DataW + 1;  // {void, key, slot}

  typedef struct packed {logic [Channels-1:0][ItemW-1:0] of;} items_t;  // one a place
  items_t                    items_q, exchanged, sorted;
  logic [DistanceW-1:0]      turn, down_bit;
  logic [ChannelW:0]         fill_q;      // keys of the coming batch that are loaded
  logic                      loaded_q;    // ... and that is all of them
  logic                      sorting_q;
  logic [DistanceW-1:0]      distance_q;  // log2
  logic [DistanceW:0]        size_q;      // log2, 1 to 4
  logic [ChannelW:0]         live_q, sent_q;  // keys of the sorted batch, those already sent
  logic                      load, send, start, last_stage, sorted_now;
  logic                      end_q, live_end_q;  // the coming and the sorted batch are ends

  assign in_ready_o  = !sorting_q && !loaded_q && (fill_q >= live_q || fill_q < sent_q);
  assign out_valid_o = !sorting_q && sent_q < live_q;
  // Chosen place by place: as an index it is a shifter of all bits where ItemW is no power of 2.
  logic [DataW-1:0] head;
  always_comb begin
    head = '0;
    for (int unsigned i = 0; i < Channels; i += 1) begin
      if (sent_q[ChannelW-1:0] == ChannelW'(i)) head = items_q.of[i][DataW-1:0];
    end
  end
  assign {out_key_o, out_slot_o} = head;
  assign load        = in_valid_i && in_ready_o;
  assign send        = out_valid_o && out_ready_i;
  assign start       = !sorting_q && loaded_q && sent_q == live_q;
  assign last_stage  = distance_q == '0 && ((ChannelW+1)'(1) << size_q) >= fill_q;
  assign sorted_now  = (start && fill_q == (ChannelW+1)'(1)) || (sorting_q && last_stage);
  assign out_end_o   = live_end_q;
  assign idle_o      = !sorting_q && fill_q == '0 && sent_q == live_q;
  assign active_o    = sorting_q || start || load || send;

  // The eight cells stand on neighbouring places, 2c and 2c + 1. At distance d, channel i lies in place i rotated right
  // by d, so that bit d of i is the lowest; an exchange ends by rotating the places for the next distance.
  assign turn = last_stage ? '0 : distance_q == '0 ? size_q[DistanceW-1:0] : '1;
  assign down_bit = size_q[DistanceW-1:0] - distance_q - 1'b1;
  for (genvar c = 0; c < Cells; c += 1) begin : gen_cell
    localparam logic [ChannelW-1:0] Number = ChannelW'(c);
    logic [ItemW-1:0] a, b;
    logic             swap;
    always_comb begin
      a = items_q.of[2*c];
      b = items_q.of[2*c+1];
      swap = (a[ItemW-1:pipegs_pkg::RecordW] > b[ItemW-1:pipegs_pkg::RecordW]) !=
             (Number[down_bit] && !size_q[DistanceW]);
      exchanged.of[2*c]   = swap ? b : a;
      exchanged.of[2*c+1] = swap ? a : b;
    end
  end

  for (genvar i = 0; i < Channels; i += 1) begin : gen_place
    localparam int unsigned From1 = (i * 2) % Channels + i / 8;  // i rotated left
    localparam int unsigned From2 = (i * 4) % Channels + i / 4;
    localparam int unsigned From3 = (i * 8) % Channels + i / 2;
    always_comb begin
      unique case (turn)
        2'd0:    sorted.of[i] = exchanged.of[i];
        2'd1:    sorted.of[i] = exchanged.of[From1];
        2'd2:    sorted.of[i] = exchanged.of[From2];
        default: sorted.of[i] = exchanged.of[From3];
      endcase
    end
    always_ff @(posedge clk_i) begin
      if (sorting_q) items_q.of[i] <= sorted.of[i];
      else if (load && fill_q == (ChannelW+1)'(i)) items_q.of[i] <= {1'b0, in_key_i, in_slot_i};
      else if (start) items_q.of[i][DataW:DataW] <= (ChannelW+1)'(i) >= fill_q;
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      fill_q    <= '0;
      loaded_q  <= 1'b0;
      sorting_q <= 1'b0;
      live_q    <= '0;
      sent_q    <= '0;
    end else begin
      if (load) begin
        fill_q   <= fill_q + 1'b1;
        loaded_q <= in_last_i;
      end
      if (send) sent_q <= sent_q + 1'b1;
      if (start) sorting_q <= fill_q != (ChannelW+1)'(1);
      if (sorting_q) sorting_q <= !last_stage;
      if (sorted_now) begin
        live_q   <= fill_q;
        sent_q   <= '0;
        fill_q   <= '0;
        loaded_q <= 1'b0;
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (load) end_q <= in_end_i;
    if (sorted_now) live_end_q <= end_q;
    if (start) begin
      size_q     <= (DistanceW+1)'(1);
      distance_q <= '0;
    end else if (sorting_q) begin
      distance_q <= distance_q == '0 ? size_q[DistanceW-1:0] : distance_q - 1'b1;
      if (distance_q == '0) size_q <= size_q + 1'b1;
    end
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!load || fill_q < (ChannelW+1)'(Channels));
  always_ff @(posedge clk_i) if (rst_ni) assert (!(load && in_end_i) || (fill_q == '0 && in_last_i));
  pipegs_stream_check #(.DataW($bits({out_end_o, out_key_o, out_slot_o})), .Proven(1)) u_check_out (
    .clk_i,
    .rst_ni,
    .valid_i(out_valid_o),
    .ready_i(out_ready_i),
    .beat_i({out_end_o, out_key_o, out_slot_o})
  );
`endif

endmodule
