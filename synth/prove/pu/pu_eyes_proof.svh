// SPDX-License-Identifier: Apache-2.0
// The end of rtl/pu/front/pu_eyes.sv in its proof: what both eyes share is shown to each of them.
//
// Rule    A Gaussian is taken when it has been shown to each eye that it is for, once, the first one before the second:
//         those of the frame, or the one of its walk. All else is shown once. What is shown is what came.
// Assumes An eye is wanted, and which stays; what is offered stays until it is taken.

logic [1:0] shown_q, whom, now;  // to whom the item has been shown; is to be; is shown now
logic       waits_q;
pipegs_pkg::fetched_t before_q;
logic [1:0] wanted_before_q;

proof_reset u_proof_reset (.clk_i, .rst_ni);

if (pipegs_pkg::WalkEyeW != 0) begin : gen_whom
  assign whom = !data ? 2'b01 : !fetched_i.walk[1] ? wanted_i : fetched_i.walk[0] ? 2'b10 : 2'b01;
end else begin : gen_whom_all
  assign whom = data ? wanted_i : 2'b01;
end
assign now  = eye_o ? 2'b10 : 2'b01;
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    shown_q <= '0;
    waits_q <= 1'b0;
  end else begin
    waits_q <= fetched_valid_i && !fetched_ready_o;
    if (fetched_valid_i && fetched_ready_o) shown_q <= '0;
    else if (seen_valid_o && seen_ready_i) shown_q <= shown_q | now;
  end
end
always_ff @(posedge clk_i) begin
  before_q        <= fetched_i;
  wanted_before_q <= wanted_i;
end
always_comb begin
  assume (wanted_i != '0);
  assume (!rst_ni || !waits_q || (fetched_valid_i && fetched_i == before_q && wanted_i == wanted_before_q));
  if (rst_ni) begin
    assert (seen_o == fetched_i);
    if (seen_valid_o) begin
      assert (fetched_valid_i && (whom & now) != '0 && (shown_q & now) == '0);
      assert (shown_q == '0 || now == 2'b10);
    end
    if (fetched_valid_i && fetched_ready_o) assert (seen_valid_o && seen_ready_i && (shown_q | now) == whom);
    // invariants
    assert (second_q == (shown_q == 2'b01) && shown_q != 2'b10 && shown_q != 2'b11);
    assert (shown_q == '0 || (waits_q && data && whom == 2'b11));
  end
end
