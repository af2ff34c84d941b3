// SPDX-License-Identifier: Apache-2.0
// su_merge: joins the sorted streams of all lanes into one.
//
// Paper   Fig. 7, between SU and RU.
// Idea    When every lane shows its head, the head with the smallest key {end, su_key} goes. Each pair of heads is
//         compared once, side by side; the winner is the one that is below all others. End beats are above every splat,
//         so they are left when the layer is out of splats; then all are taken at once and one goes out. Watermarks
//         (the ends of layers, if there are any) and ends of parts have done their work here and do not go out.
// Stream  in: one sorted stream per lane, a layer each up to an end beat of the same kind. out: the merged layers;
//         `unit` is the lane. A lane's ready depends on the other lanes' valid, as in every join.
// Pace    One beat per cycle, latency one cycle; a layer's end costs one beat.
// Model   std::merge; in the test.

module su_merge (
  input  logic                                               clk_i,
  input  logic                                               rst_ni,

  input  logic [pipegs_pkg::Units-1:0]                       in_valid_i,
  output logic [pipegs_pkg::Units-1:0]                       in_ready_o,
  input  logic [pipegs_pkg::Units*pipegs_pkg::SplatBits-1:0] in_i,

  output logic                                               out_valid_o,
  input  logic                                               out_ready_i,
  output pipegs_pkg::sorted_t                                out_o,

  output logic                                               active_o  // something moves in this cycle
);

  localparam int unsigned Units = pipegs_pkg::Units;
  localparam int unsigned KindW = pipegs_pkg::KindW;
  localparam int unsigned DepthW = pipegs_pkg::DepthW;
  localparam int unsigned NameW = pipegs_pkg::PartW + pipegs_pkg::SplatIndexW;  // {index, part}
  localparam int unsigned TapNameW = pipegs_pkg::PartW + pipegs_pkg::ShownIndexW;
  localparam int unsigned KeyW = pipegs_pkg::KeyW;
  localparam int unsigned HeadW = KeyW + 1;

  logic                   out_valid_q, go, mark;
  pipegs_pkg::sorted_t    out_q, out_d;
  typedef struct packed {logic [Units-1:0][HeadW-1:0] of;} heads_t;
  typedef struct packed {logic [Units-1:0][pipegs_pkg::SplatBits-1:0] of;} splats_t;
  heads_t                 heads;
  splats_t                splats;
  logic [Units-1:0]       ends, nearest;
  logic [Units*Units-1:0] beats;
  logic                   unused_heads;  // with one lane nothing is compared
  logic [pipegs_pkg::UnitW-1:0]     winner_unit;
  logic [pipegs_pkg::SplatBits-1:0] winner_bits;

  assign splats = in_i;
  for (genvar i = 0; i < Units; i += 1) begin : gen_head
    logic [KeyW-1:0] key;
    su_key u_key (
      .splat_i(splats.of[i]),
      .key_o(key)
    );
    assign ends[i] = splats.of[i][KindW-1:0] != pipegs_pkg::KindData;
    assign heads.of[i] = {ends[i], key};
  end
  assign unused_heads = &{1'b0, heads};

  assign go         = in_valid_i == '1 && (!out_valid_q || out_ready_i);
  assign mark       = pipegs_pkg::HasWatermarks && ends == '1 &&
                      in_i[pipegs_pkg::KindW-1:0] != pipegs_pkg::KindWindowEnd;
  assign in_ready_o = !go ? '0 : ends == '1 ? '1 : nearest;
  assign active_o   = go || (out_valid_q && out_ready_i);

  // Lane i beats lane j: bit i * Units + j; one comparator for each pair.
  always_comb begin
    for (int unsigned i = 0; i < Units; i += 1) begin
      for (int unsigned j = i; j < Units; j += 1) begin
        beats[i*Units+j] = heads.of[i] <= heads.of[j];
        if (i != j) beats[j*Units+i] = !beats[i*Units+j];
      end
    end
    for (int unsigned i = 0; i < Units; i += 1) nearest[i] = beats[i*Units +: Units] == '1;
  end

  always_comb begin
    winner_bits = '0;
    winner_unit = '0;
    for (int unsigned i = 0; i < Units; i += 1) begin
      if (nearest[i]) begin
        winner_bits |= splats.of[i];
        winner_unit |= pipegs_pkg::UnitW'(i);
      end
    end
  end

  // A sorted splat is the splat with its unit on top; when nothing is stored in units, without. Depth and index are
  // there for the taps.
  assign out_d = pipegs_pkg::SortedBits'({winner_unit, winner_bits[pipegs_pkg::SplatBits-1:KindW+DepthW+NameW],
                                          winner_bits[KindW+DepthW +: TapNameW],
                                          winner_bits[KindW+pipegs_pkg::ShownDepthW-1:KindW], winner_bits[KindW-1:0]});

  assign out_valid_o = out_valid_q;
  assign out_o       = out_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) out_valid_q <= 1'b0;
    else if (!out_valid_q || out_ready_i) out_valid_q <= go && !mark;
  end

  always_ff @(posedge clk_i) begin
    if (go) out_q <= out_d;
  end

`ifndef SYNTHESIS
  if (pipegs_pkg::IndexTies == 0) begin : gen_no_ties
    logic            before_q;  // a splat of this layer has gone, with this key
    logic [KeyW-1:0] key, key_q;
    su_key u_winner (
      .splat_i(winner_bits),
      .key_o(key)
    );
    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) before_q <= 1'b0;
      else if (go && !(mark && in_i[KindW-1:0] == pipegs_pkg::KindLayerEnd)) before_q <= ends != '1;
    end
    always_ff @(posedge clk_i) if (go && !mark) key_q <= key;
    always_ff @(posedge clk_i) if (rst_ni) assert (!(go && before_q && ends != '1) || key > key_q)
      else $error("su_merge: two splats of one depth, and IndexTies is 0");
  end
  pipegs_stream_check #(.DataW($bits(out_o))) u_check_out (
    .clk_i,
    .rst_ni,
    .valid_i(out_valid_o),
    .ready_i(out_ready_i),
    .beat_i(out_o)
  );
`endif

endmodule
