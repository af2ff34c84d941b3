// SPDX-License-Identifier: Apache-2.0
// The end of rtl/pipegs_layer_free.sv in its proof: a layer is freed once, when every RU has finished it.
//
// Rule    No counter leaves 0 to AlphaLayers; a layer is freed only while one lives; each RU has finished it.
// Assumes Of pu_allocate (its proof): at most AlphaLayers have ended and are not free. Of the RUs: none finishes a
//         layer that has not ended.

(* anyseq *)   logic ended;             // a layer ends in the PUs
(* anyconst *) logic [$clog2(pipegs_pkg::Units + 1)-1:0] unit;  // any RU
logic [CountW-1:0] live_q;              // layers ended and not free
logic [CountW-1:0] finished_q, freed_q; // by this RU, and freed, modulo 2^CountW

proof_reset u_proof_reset (.clk_i, .rst_ni);
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    live_q     <= '0;
    finished_q <= '0;
    freed_q    <= '0;
  end else begin
    live_q     <= live_q + CountW'(ended) - CountW'(free_o);
    finished_q <= finished_q + CountW'(done_i[unit]);
    freed_q    <= freed_q + CountW'(free_o);
  end
end

always_comb begin
  assume (32'(unit) < pipegs_pkg::Units);
  assume (!ended || 32'(live_q) < pipegs_pkg::AlphaLayers);
  for (int unsigned i = 0; i < pipegs_pkg::Units; i += 1) assume (!done_i[i] || count_q[i] < live_q);
  if (rst_ni) begin
    assert (!free_o || live_q != '0);
    assert (!free_o || finished_q != freed_q);
    assert (32'(live_q) <= pipegs_pkg::AlphaLayers);
    for (int unsigned i = 0; i < pipegs_pkg::Units; i += 1) assert (count_q[i] <= live_q);
    assert (count_q[unit] == finished_q - freed_q);
  end
end
