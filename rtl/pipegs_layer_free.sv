// SPDX-License-Identifier: Apache-2.0
// pipegs_layer_free: tells the alpha stores that every RU has finished the oldest layer.
//
// Paper   Sec. 4.1 (inter-layer pipeline: results are double-buffered).
// Idea    RUs drift apart, so each has a counter of layers that it has finished ahead of the slowest. When all counters
//         are above zero the oldest layer is free everywhere and each counter goes down by one.
// Stream  done_i: one pulse per RU and layer. free_o: one pulse per layer.
// Pace    One layer per cycle, one cycle of latency.
// Model   None: what is freed is checked by the streams behind it.

module pipegs_layer_free (
  input  logic                         clk_i,
  input  logic                         rst_ni,

  input  logic [pipegs_pkg::Units-1:0] done_i,
  output logic                         free_o
);

  localparam int unsigned CountW = $clog2(pipegs_pkg::AlphaLayers + 1);  // as many live, see pu_allocate

  logic [CountW-1:0]            count_q [pipegs_pkg::Units];
  logic [pipegs_pkg::Units-1:0] some;

  always_comb begin
    for (int unsigned i = 0; i < pipegs_pkg::Units; i += 1) some[i] = count_q[i] != '0;
  end
  assign free_o = some == '1;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      for (int unsigned i = 0; i < pipegs_pkg::Units; i += 1) count_q[i] <= '0;
    end else begin
      for (int unsigned i = 0; i < pipegs_pkg::Units; i += 1) begin
        count_q[i] <= count_q[i] + CountW'(done_i[i]) - CountW'(free_o);
      end
    end
  end

endmodule
