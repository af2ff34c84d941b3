// SPDX-License-Identifier: Apache-2.0
// soc: PipeGS in a system: this is how one puts it in. A processor at its registers, a crossbar and a memory that a DMA
// shares with it, and a bus between that is a fourth as wide as the core's.
//
// Idea    pipegs_axi -> soc_width (512 to 128 bits) -> soc_crossbar, with the DMA beside it -> soc_ram. The processor
//         and the DMA are the test's (soc_test.cpp): s_axi_* AXI4-Lite, d_* AXI4 of 128 bits. The DMA brings the scene
//         into memory and reads the picture while it is rendered.
// Rule    Everything is INCR in beats of the whole bus. The memory answers bursts one after the other, so IDs come back
//         in order; the crossbar puts the number of a manager above its ID and takes it off again.
// Reset   One reset for all: what is on its way on one side of a bus must not outlive the other side.
// Look    m_*: the port of the memory, for the checker of the test (sim/memory/axi/axi_rules.hpp).

module soc #(
  localparam int unsigned AddrW = 40,
  localparam int unsigned DataW = 128,
  localparam int unsigned IdW   = pipegs_pkg::AxiIdW,
  localparam int unsigned WideW = pipegs_pkg::AxiDataW,
  localparam int unsigned AskW  = IdW + AddrW + 8,    // a burst: length, address, ID
  localparam int unsigned BeatW = DataW + DataW / 8,  // strobes, data
  localparam int unsigned ReadW = DataW + 2 + 1       // last, response, data
) (
  input  logic             aclk,
  input  logic             aresetn,
  output logic             irq,

  input  pipegs_pkg::axi_lite_manager_t     s_axi_i,
  output pipegs_pkg::axi_lite_subordinate_t s_axi_o,

  input  logic             d_arvalid,
  output logic             d_arready,
  input  logic [AddrW-1:0] d_araddr,
  input  logic [7:0]       d_arlen,
  output logic             d_rvalid,
  input  logic             d_rready,
  output logic [DataW-1:0] d_rdata,
  output logic [1:0]       d_rresp,
  output logic             d_rlast,
  input  logic             d_awvalid,
  output logic             d_awready,
  input  logic [AddrW-1:0] d_awaddr,
  input  logic [7:0]       d_awlen,
  input  logic             d_wvalid,
  output logic             d_wready,
  input  logic [DataW-1:0] d_wdata,
  input  logic             d_wlast,
  output logic             d_bvalid,
  input  logic             d_bready,
  output logic [1:0]       d_bresp,

  output logic             m_arvalid, m_arready, m_rvalid, m_rready, m_rlast,
  output logic             m_awvalid, m_awready, m_wvalid, m_wready, m_wlast, m_bvalid, m_bready,
  output logic [AskW:0]    m_ar, m_aw,  // with the manager on top
  output logic [BeatW-1:0] m_w
);

  // --- the core and its ports ----------------------------------------------------------------------------------------
  logic [IdW-1:0]     awid, arid, bid, rid;
  logic [AddrW-1:0]   awaddr, araddr;
  logic [7:0]         awlen, arlen;
  logic [WideW-1:0]   wdata, rdata;
  logic [WideW/8-1:0] wstrb;
  logic [1:0]         bresp, rresp;
  logic               awvalid, awready, wlast, wvalid, wready, bvalid, bready;
  logic               arvalid, arready, rlast, rvalid, rready;

  pipegs_axi #(.AddrW(AddrW), .Base(40'h0)) u_pipegs (
    .aclk,
    .aresetn,
    .test_mode(1'b0),
    .scan_enable(1'b0),
    .irq,
    .s_axi_awaddr(s_axi_i.aw_addr),
    .s_axi_awprot(3'b000),
    .s_axi_awvalid(s_axi_i.aw_valid),
    .s_axi_awready(s_axi_o.aw_ready),
    .s_axi_wdata(s_axi_i.w_data),
    .s_axi_wstrb(s_axi_i.w_strb),
    .s_axi_wvalid(s_axi_i.w_valid),
    .s_axi_wready(s_axi_o.w_ready),
    .s_axi_bresp(s_axi_o.b_resp),
    .s_axi_bvalid(s_axi_o.b_valid),
    .s_axi_bready(s_axi_i.b_ready),
    .s_axi_araddr(s_axi_i.ar_addr),
    .s_axi_arprot(3'b000),
    .s_axi_arvalid(s_axi_i.ar_valid),
    .s_axi_arready(s_axi_o.ar_ready),
    .s_axi_rdata(s_axi_o.r_data),
    .s_axi_rresp(s_axi_o.r_resp),
    .s_axi_rvalid(s_axi_o.r_valid),
    .s_axi_rready(s_axi_i.r_ready),
    .m_axi_awid(awid),
    .m_axi_awaddr(awaddr),
    .m_axi_awlen(awlen),
    .m_axi_awsize(),
    .m_axi_awburst(),
    .m_axi_awcache(),
    .m_axi_awprot(),
    .m_axi_awvalid(awvalid),
    .m_axi_awready(awready),
    .m_axi_wdata(wdata),
    .m_axi_wstrb(wstrb),
    .m_axi_wlast(wlast),
    .m_axi_wvalid(wvalid),
    .m_axi_wready(wready),
    .m_axi_bid(bid),
    .m_axi_bresp(bresp),
    .m_axi_bvalid(bvalid),
    .m_axi_bready(bready),
    .m_axi_arid(arid),
    .m_axi_araddr(araddr),
    .m_axi_arlen(arlen),
    .m_axi_arsize(),
    .m_axi_arburst(),
    .m_axi_arcache(),
    .m_axi_arprot(),
    .m_axi_arvalid(arvalid),
    .m_axi_arready(arready),
    .m_axi_rid(rid),
    .m_axi_rdata(rdata),
    .m_axi_rresp(rresp),
    .m_axi_rlast(rlast),
    .m_axi_rvalid(rvalid),
    .m_axi_rready(rready)
  );

  // --- two managers: 0 the core, narrowed; 1 the DMA -----------------------------------------------------------------
  logic [1:0]            ar_valid, ar_ready, r_valid, r_ready, aw_valid, aw_ready, w_valid, w_ready, w_last;
  logic [1:0]            b_valid, b_ready;
  logic [1:0][AskW-1:0]  ar, aw;
  logic [1:0][BeatW-1:0] w;
  logic [ReadW+IdW:0]    m_r;
  logic [IdW+2:0]        m_b;  // manager, ID, response
  logic [7:0]            narrow_arlen, narrow_awlen;
  logic [DataW-1:0]      narrow_wdata;
  logic [DataW/8-1:0]    narrow_wstrb;

  soc_width #(.IdW(IdW), .WideW(WideW), .NarrowW(DataW)) u_width (
    .clk_i(aclk), .rst_ni(aresetn),
    .arlen_i(arlen), .arlen_o(narrow_arlen), .awlen_i(awlen), .awlen_o(narrow_awlen),
    .w_valid_i(wvalid), .w_ready_o(wready), .w_data_i(wdata), .w_strb_i(wstrb), .w_last_i(wlast),
    .w_valid_o(w_valid[0]), .w_ready_i(w_ready[0]), .w_data_o(narrow_wdata), .w_strb_o(narrow_wstrb),
    .w_last_o(w_last[0]),
    .r_valid_i(r_valid[0]), .r_ready_o(r_ready[0]), .r_id_i(m_r[ReadW +: IdW]), .r_data_i(m_r[DataW-1:0]),
    .r_resp_i(m_r[DataW +: 2]), .r_last_i(m_r[DataW+2]),
    .r_valid_o(rvalid), .r_ready_i(rready), .r_id_o(rid), .r_data_o(rdata), .r_resp_o(rresp), .r_last_o(rlast)
  );
  assign ar[0]       = {arid, araddr, narrow_arlen};
  assign aw[0]       = {awid, awaddr, narrow_awlen};
  assign w[0]        = {narrow_wstrb, narrow_wdata};
  assign ar_valid[0] = arvalid;
  assign arready     = ar_ready[0];
  assign aw_valid[0] = awvalid;
  assign awready     = aw_ready[0];
  assign bvalid      = b_valid[0];
  assign b_ready[0]  = bready;
  assign bid         = m_b[2 +: IdW];
  assign bresp       = m_b[1:0];

  assign ar[1]       = {IdW'(0), d_araddr, d_arlen};
  assign aw[1]       = {IdW'(0), d_awaddr, d_awlen};
  assign w[1]        = {{DataW / 8{1'b1}}, d_wdata};
  assign ar_valid[1] = d_arvalid;
  assign d_arready   = ar_ready[1];
  assign d_rvalid    = r_valid[1];
  assign r_ready[1]  = d_rready;
  assign d_rdata     = m_r[DataW-1:0];
  assign d_rresp     = m_r[DataW +: 2];
  assign d_rlast     = m_r[DataW+2];
  assign aw_valid[1] = d_awvalid;
  assign d_awready   = aw_ready[1];
  assign w_valid[1]  = d_wvalid;
  assign d_wready    = w_ready[1];
  assign w_last[1]   = d_wlast;
  assign d_bvalid    = b_valid[1];
  assign b_ready[1]  = d_bready;
  assign d_bresp     = m_b[1:0];

  soc_crossbar #(.AskW(AskW), .BeatW(BeatW)) u_crossbar (
    .clk_i(aclk), .rst_ni(aresetn),
    .ar_valid_i(ar_valid), .ar_ready_o(ar_ready), .ar_i(ar),
    .aw_valid_i(aw_valid), .aw_ready_o(aw_ready), .aw_i(aw),
    .w_valid_i(w_valid), .w_ready_o(w_ready), .w_i(w), .w_last_i(w_last),
    .r_valid_o(r_valid), .r_ready_i(r_ready), .b_valid_o(b_valid), .b_ready_i(b_ready),
    .ar_valid_o(m_arvalid), .ar_ready_i(m_arready), .ar_o(m_ar),
    .aw_valid_o(m_awvalid), .aw_ready_i(m_awready), .aw_o(m_aw),
    .w_valid_o(m_wvalid), .w_ready_i(m_wready), .w_o(m_w), .w_last_o(m_wlast),
    .r_valid_i(m_rvalid), .r_ready_o(m_rready), .r_to_i(m_r[ReadW+IdW]),
    .b_valid_i(m_bvalid), .b_ready_o(m_bready), .b_to_i(m_b[IdW+2])
  );

  soc_ram #(.IdW(IdW + 1), .AddrW(AddrW), .DataW(DataW)) u_ram (
    .clk_i(aclk), .rst_ni(aresetn),
    .ar_valid_i(m_arvalid), .ar_ready_o(m_arready), .ar_i(m_ar),
    .r_valid_o(m_rvalid), .r_ready_i(m_rready), .r_o(m_r),
    .aw_valid_i(m_awvalid), .aw_ready_o(m_awready), .aw_i(m_aw),
    .w_valid_i(m_wvalid), .w_ready_o(m_wready), .w_i(m_w), .w_last_i(m_wlast),
    .b_valid_o(m_bvalid), .b_ready_i(m_bready), .b_o(m_b)
  );
  assign m_rlast = m_r[DataW+2];

endmodule
