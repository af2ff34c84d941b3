// SPDX-License-Identifier: Apache-2.0
// axi_check_bind: puts the checker of the proofs (synth/prove/parts/axi_check.sv) into pipegs_axi_manager.

bind pipegs_axi_manager axi_check #(
  .DataW(DataW), .AddrW(AddrW), .IdW(IdW), .Reads(Reads), .Writes(Writes)
) u_check (
  .clk_i, .rst_ni, .pick_i(1'b1),
  .m_axi_awid, .m_axi_awaddr, .m_axi_awlen, .m_axi_awsize, .m_axi_awburst, .m_axi_awvalid, .m_axi_awready,
  .m_axi_wdata, .m_axi_wstrb, .m_axi_wlast, .m_axi_wvalid, .m_axi_wready,
  .m_axi_bid, .m_axi_bresp, .m_axi_bvalid, .m_axi_bready,
  .m_axi_arid, .m_axi_araddr, .m_axi_arlen, .m_axi_arsize, .m_axi_arburst, .m_axi_arvalid, .m_axi_arready,
  .m_axi_rid, .m_axi_rdata, .m_axi_rresp, .m_axi_rlast, .m_axi_rvalid, .m_axi_rready,
  .manager_o(), .subordinate_o(), .reads_o(), .reads_of_o(), .addresses_o(), .lines_o(), .beat_o()
);
