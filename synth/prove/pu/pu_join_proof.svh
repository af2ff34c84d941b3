// SPDX-License-Identifier: Apache-2.0
// The end of rtl/pu/pu_join.sv in its proof: a layer's end passes once, after all lines of the layer are written.
//
// Rule    An end of the splats passes for each end of the rows, never before it; a splat passes as it comes; what is
//         shown stays.
// Assumes Of pu_allocate (its proof): at most AlphaLayers have ended there and are not free; a layer that did not pass
//         here is not free. The colours hold what they show.
// Invariant  Ends counted: of the rows, not yet of the splats.

(* anyseq *) logic freed;
logic [CountW-1:0] passed_q;  // layers that passed and are not free
logic              passes;

proof_reset u_proof_reset (.clk_i, .rst_ni);
proof_hold #(.DataW(pipegs_pkg::ColoredBits), .Assumed(1'b1)) u_hold_in (
  .clk_i, .rst_ni, .valid_i(colored_valid_i), .ready_i(colored_ready_o), .beat_i(colored_i)
);
proof_hold #(.DataW(pipegs_pkg::SplatBits)) u_hold (
  .clk_i, .rst_ni, .valid_i(splat_valid_o), .ready_i(splat_ready_i), .beat_i(splat_o)
);

assign passes = splat_valid_o && splat_ready_i && is_end;
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) passed_q <= '0;
  else passed_q <= passed_q + CountW'(passes) - CountW'(freed);
end

always_comb begin
  assume (!freed || passed_q != '0);
  assume (!rows_end_valid_i || 32'(ends_q) + 32'(passed_q) < pipegs_pkg::AlphaLayers);
  if (rst_ni) begin
    assert (32'(ends_q) + 32'(passed_q) <= pipegs_pkg::AlphaLayers);
    assert (!passes || ends_q != '0);
    assert (!colored_valid_i || is_end || splat_valid_o);
    assert ((colored_valid_i && colored_ready_o) == (splat_valid_o && splat_ready_i));
  end
end
