// SPDX-License-Identifier: Apache-2.0
// axi_lite_check: the rules of AXI4-Lite at a subordinate.
//
// Idea    Counts requests that are not answered, for addresses and data of writes and for reads. The rules of the
//         manager are assumed, those of the subordinate asserted. The answer to a write comes in order, so its address
//         and data are the oldest ones.
// Rule    What is valid stays, unchanged, until it is taken (AMBA IHI 0022, A3.2.1); B follows an address and its data,
//         R an address, none of them in the same cycle (A3.3.1); no EXOKAY (B1.1.1); no more than Most requests inside;
//         nobody who has asked, and takes answers, waits longer than Wait cycles.

module axi_lite_check #(
  parameter int unsigned Most = 2,
  parameter int unsigned Wait = 2,
  localparam int unsigned CountW = $clog2(Most + 2),
  localparam int unsigned WaitW = $clog2(Wait + 2)
) (
  input  logic                clk_i,
  input  logic                rst_ni,
  input  pipegs_pkg::axi_lite_manager_t     ask_i,
  input  pipegs_pkg::axi_lite_subordinate_t answer_i,
  output logic [CountW-1:0]   addresses_o,  // writes that are not answered: their addresses, their data
  output logic [CountW-1:0]   words_o,
  output logic [CountW-1:0]   reads_o,
  output logic [WaitW-1:0]    write_wait_o, // cycles since there was something to answer, and no answer
  output logic [WaitW-1:0]    read_wait_o
);

  logic [CountW-1:0] addresses_q, words_q, reads_q;
  logic [WaitW-1:0]  write_wait_q, read_wait_q;
  logic              write_due, read_due, write_done, read_done;

  assign write_due  = addresses_q != '0 && words_q != '0 && !answer_i.b_valid;
  assign write_done = answer_i.b_valid && ask_i.b_ready;
  assign read_done  = answer_i.r_valid && ask_i.r_ready;
  assign read_due   = reads_q != '0 && !answer_i.r_valid;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      addresses_q  <= '0;
      words_q      <= '0;
      reads_q      <= '0;
      write_wait_q <= '0;
      read_wait_q  <= '0;
    end else begin
      addresses_q  <= addresses_q + CountW'(ask_i.aw_valid && answer_i.aw_ready) - CountW'(write_done);
      words_q      <= words_q + CountW'(ask_i.w_valid && answer_i.w_ready) - CountW'(write_done);
      reads_q      <= reads_q + CountW'(ask_i.ar_valid && answer_i.ar_ready) - CountW'(read_done);
      write_wait_q <= write_due ? write_wait_q + 1'b1 : '0;
      read_wait_q  <= read_due ? read_wait_q + 1'b1 : '0;
    end
  end

  assign addresses_o  = addresses_q;
  assign words_o      = words_q;
  assign reads_o      = reads_q;
  assign write_wait_o = write_wait_q;
  assign read_wait_o  = read_wait_q;

  always_comb begin
    if (rst_ni) begin
      assert (addresses_q <= CountW'(Most) && words_q <= CountW'(Most) && reads_q <= CountW'(Most));
      assert (!answer_i.b_valid || (addresses_q != '0 && words_q != '0));
      assert (!answer_i.r_valid || reads_q != '0);
      assert (!answer_i.b_valid || answer_i.b_resp != 2'b01);
      assert (!answer_i.r_valid || answer_i.r_resp != 2'b01);
      assert (!write_due || write_wait_q < WaitW'(Wait));
      assert (!read_due || read_wait_q < WaitW'(Wait));
    end
  end

  proof_hold #(.DataW(pipegs_pkg::ControlAddressW), .Assumed(1'b1)) u_aw (
    .clk_i, .rst_ni, .valid_i(ask_i.aw_valid), .ready_i(answer_i.aw_ready), .beat_i(ask_i.aw_addr)
  );
  proof_hold #(.DataW(36), .Assumed(1'b1)) u_w (
    .clk_i, .rst_ni, .valid_i(ask_i.w_valid), .ready_i(answer_i.w_ready), .beat_i({ask_i.w_strb, ask_i.w_data})
  );
  proof_hold #(.DataW(pipegs_pkg::ControlAddressW), .Assumed(1'b1)) u_ar (
    .clk_i, .rst_ni, .valid_i(ask_i.ar_valid), .ready_i(answer_i.ar_ready), .beat_i(ask_i.ar_addr)
  );
  proof_hold #(.DataW(2)) u_b (
    .clk_i, .rst_ni, .valid_i(answer_i.b_valid), .ready_i(ask_i.b_ready), .beat_i(answer_i.b_resp)
  );
  proof_hold #(.DataW(34)) u_r (
    .clk_i, .rst_ni, .valid_i(answer_i.r_valid), .ready_i(ask_i.r_ready), .beat_i({answer_i.r_resp, answer_i.r_data})
  );

endmodule
