// SPDX-License-Identifier: Apache-2.0
// The end of rtl/ru/ru_walk.sv in its proof: the windows that ended here and not yet in the lanes are counted without
// overflow.
//
// Rule    The count is the ends that stand here behind the first register and those that have left and are not done; so
//         the done mask is looked at only when it is that of the splat's window. What is shown stays.
// Assumes Behind this module at most EndsMax - 2 ends fit: the records of ru_fetch, FetchLines + 8, and the lanes, 2.
//         The lanes leave a window only when its end has come to them.

localparam int unsigned Fit = EndsMax - 2;
logic [EndsW-1:0] behind_q, here;  // ends that have left and are not done; ends in the two registers
logic             leaves;

proof_reset u_proof_reset (.clk_i, .rst_ni);
proof_hold #(.DataW(pipegs_pkg::KindW + RegionW + AlphaAddressW + 1)) u_hold (
  .clk_i, .rst_ni, .valid_i(out_valid_o), .ready_i(out_ready_i),
  .beat_i({out_o.kind, out_o.region, out_o.address, out_o.skip})
);

assign leaves = out_valid_o && out_ready_i && out_o.kind == pipegs_pkg::KindWindowEnd;
assign here   = EndsW'(pick_valid_q && pick_q.kind == pipegs_pkg::KindWindowEnd) +
                EndsW'(out_valid_q && out_q.kind == pipegs_pkg::KindWindowEnd);
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) behind_q <= '0;
  else behind_q <= behind_q + EndsW'(leaves) - EndsW'(window_done_i);
end

always_comb begin
  assume (!window_done_i || behind_q != '0);
  assume (!leaves || window_done_i || behind_q < EndsW'(Fit));
  if (rst_ni) begin
    assert (ends_q <= EndsW'(EndsMax));
    assert (!window_done_i || ends_q != '0);
    assert (ends_q == here + behind_q && behind_q <= EndsW'(Fit));
  end
end
