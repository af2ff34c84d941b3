// SPDX-License-Identifier: Apache-2.0
// The end of rtl/control/pipegs_control_bus.sv in its proof: AXI4-Lite outside, one strobe for each request inside.
//
// Rule    axi_lite_check. A write strobe has the address and data of the oldest write, is one for each, and its error
//         is the answer; likewise for a read with its data. An answer comes within two cycles.
// Invariant  What is not answered lies in the register in front or shows in the answer.

logic [1:0]          addresses, words, reads;  // by u_proof, see axi_lite_check
logic [1:0]          write_wait, read_wait;
logic [AddressW-1:0] aw_q, ar_q;               // what the bus showed when it was taken
logic [35:0]         w_q;
logic                error_q, read_error_q;    // what was said at the strobe
logic [31:0]         data_q;

proof_reset u_proof_reset (.clk_i, .rst_ni);
axi_lite_check u_proof (
  .clk_i, .rst_ni, .ask_i(s_axi_i), .answer_i(s_axi_o),
  .addresses_o(addresses), .words_o(words), .reads_o(reads), .write_wait_o(write_wait), .read_wait_o(read_wait)
);

always_ff @(posedge clk_i) begin
  if (s_axi_i.aw_valid && s_axi_o.aw_ready) aw_q <= s_axi_i.aw_addr;
  if (s_axi_i.w_valid && s_axi_o.w_ready) w_q <= {s_axi_i.w_strb, s_axi_i.w_data};
  if (s_axi_i.ar_valid && s_axi_o.ar_ready) ar_q <= s_axi_i.ar_addr;
  if (write_o) error_q <= write_error_i;
  if (read_o) {read_error_q, data_q} <= {read_error_i, read_data_i};
end

always_comb begin
  if (rst_ni) begin
    assert (addresses == {1'b0, !aw_ready_q} + {1'b0, b_valid_q});
    assert (words == {1'b0, !w_ready_q} + {1'b0, b_valid_q});
    assert (reads == {1'b0, !ar_ready_q} + {1'b0, r_valid_q});
    assert (aw_ready_q || aw_word_q == aw_q[AddressW-1:2]);
    assert (w_ready_q || {w_strobe_q, w_data_q} == w_q);
    assert (ar_ready_q || ar_word_q == ar_q[AddressW-1:2]);
    assert (!write_o || (write_word_o == aw_q[AddressW-1:2] && write_data_o == w_q[31:0]));
    assert (!write_o || (write_mask_o[0] == w_q[32] && write_mask_o[31] == w_q[35]));
    assert (!read_o || read_word_o == ar_q[AddressW-1:2]);
    assert (!s_axi_o.b_valid || s_axi_o.b_resp == {error_q, 1'b0});
    assert (!s_axi_o.r_valid || (s_axi_o.r_resp == {read_error_q, 1'b0} && s_axi_o.r_data == data_q));
    assert (write_wait == 2'd0 || (addresses != 2'd0 && words != 2'd0 && b_valid_q));
    assert (read_wait == 2'd0 || (reads != 2'd0 && r_valid_q));
  end
end
