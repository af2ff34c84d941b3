// SPDX-License-Identifier: Apache-2.0
// proof_axi_lite: the rules of AXI4-Lite at a subordinate.
//
// Idea    Counts requests that are not answered, for addresses and data of writes and for reads. The rules of the
//         manager are assumed, those of the subordinate asserted. The answer to a write comes in order, so its address
//         and data are the oldest ones.
// Rule    What is valid stays, unchanged, until it is taken (AMBA IHI 0022, A3.2.1); B follows an address and its data,
//         R an address, none of them in the same cycle (A3.3.1); no EXOKAY (B1.1.1); no more than Most requests inside;
//         nobody who has asked, and takes answers, waits longer than Wait cycles.

module proof_axi_lite #(
  parameter int unsigned AddressW = 12,
  parameter int unsigned Most = 2,
  parameter int unsigned Wait = 2,
  localparam int unsigned CountW = $clog2(Most + 2),
  localparam int unsigned WaitW = $clog2(Wait + 2)
) (
  input  logic                clk_i,
  input  logic                rst_ni,
  input  logic                awvalid_i, awready_i,
  input  logic [AddressW-1:0] awaddr_i,
  input  logic                wvalid_i, wready_i,
  input  logic [31:0]         wdata_i,
  input  logic [3:0]          wstrb_i,
  input  logic                bvalid_i, bready_i,
  input  logic [1:0]          bresp_i,
  input  logic                arvalid_i, arready_i,
  input  logic [AddressW-1:0] araddr_i,
  input  logic                rvalid_i, rready_i,
  input  logic [31:0]         rdata_i,
  input  logic [1:0]          rresp_i,
  output logic [CountW-1:0]   addresses_o,  // writes that are not answered: their addresses, their data
  output logic [CountW-1:0]   words_o,
  output logic [CountW-1:0]   reads_o,
  output logic [WaitW-1:0]    write_wait_o, // cycles since there was something to answer, and no answer
  output logic [WaitW-1:0]    read_wait_o
);

  logic [CountW-1:0] addresses_q, words_q, reads_q;
  logic [WaitW-1:0]  write_wait_q, read_wait_q;
  logic              write_due, read_due;

  assign write_due = addresses_q != '0 && words_q != '0 && !bvalid_i;
  assign read_due  = reads_q != '0 && !rvalid_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      addresses_q  <= '0;
      words_q      <= '0;
      reads_q      <= '0;
      write_wait_q <= '0;
      read_wait_q  <= '0;
    end else begin
      addresses_q  <= addresses_q + CountW'(awvalid_i && awready_i) - CountW'(bvalid_i && bready_i);
      words_q      <= words_q + CountW'(wvalid_i && wready_i) - CountW'(bvalid_i && bready_i);
      reads_q      <= reads_q + CountW'(arvalid_i && arready_i) - CountW'(rvalid_i && rready_i);
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
      assert (!bvalid_i || (addresses_q != '0 && words_q != '0));
      assert (!rvalid_i || reads_q != '0);
      assert (!bvalid_i || bresp_i != 2'b01);
      assert (!rvalid_i || rresp_i != 2'b01);
      assert (!write_due || write_wait_q < WaitW'(Wait));
      assert (!read_due || read_wait_q < WaitW'(Wait));
    end
  end

  proof_hold #(.DataW(AddressW), .Assumed(1'b1)) u_aw (
    .clk_i, .rst_ni, .valid_i(awvalid_i), .ready_i(awready_i), .beat_i(awaddr_i)
  );
  proof_hold #(.DataW(36), .Assumed(1'b1)) u_w (
    .clk_i, .rst_ni, .valid_i(wvalid_i), .ready_i(wready_i), .beat_i({wstrb_i, wdata_i})
  );
  proof_hold #(.DataW(AddressW), .Assumed(1'b1)) u_ar (
    .clk_i, .rst_ni, .valid_i(arvalid_i), .ready_i(arready_i), .beat_i(araddr_i)
  );
  proof_hold #(.DataW(2)) u_b (.clk_i, .rst_ni, .valid_i(bvalid_i), .ready_i(bready_i), .beat_i(bresp_i));
  proof_hold #(.DataW(34)) u_r (
    .clk_i, .rst_ni, .valid_i(rvalid_i), .ready_i(rready_i), .beat_i({rresp_i, rdata_i})
  );

endmodule
