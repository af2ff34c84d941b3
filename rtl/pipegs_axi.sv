// SPDX-License-Identifier: Apache-2.0
// pipegs_axi: PipeGS as a block of a system: an AXI4-Lite subordinate for its registers, an AXI4 manager to memory.
//
// Idea    Flat ports with the names of AXI, which tools for systems on a chip find by themselves; inside, channels are
//         structs. Everything else is below: pipegs_host is the machine with its registers, pipegs_axi_manager its way
//         to memory. Only wiring here.
// Stream  s_axi_*: registers, package/pipegs_registers.csv. m_axi_*: memory, docs/units/shared.md. No path leads from
//         an input to an output without a register.
// Reset   aresetn falls and rises at any time (pipegs_reset_sync). Until it has been let go inside, registers are not
//         ready.
// Pace    pipegs_axi_manager's.
// Model   cpp_model/golden.hpp; the harness runs whole frames through these ports.

module pipegs_axi #(
  parameter int unsigned      AddrW    = 40,  // of a byte address on m_axi, 40 or more
  parameter logic [AddrW-1:0] Base     = '0,  // byte address of what registers call 0, a multiple of 4096
  localparam int unsigned     DataW    = pipegs_pkg::BusW,
  localparam int unsigned     IdW      = pipegs_pkg::AxiIdW,
  localparam int unsigned     ControlW = pipegs_pkg::ControlAddressW
) (
  input  logic                aclk,
  input  logic                aresetn,
  input  logic                test_mode,    // scan test: aresetn alone resets every flip-flop; else 0
  input  logic                scan_enable,  // patterns shift: every clock runs; else 0
  output logic                irq,        // level

  input  logic [ControlW-1:0] s_axi_awaddr,
  input  logic [2:0]          s_axi_awprot,  // not looked at
  input  logic                s_axi_awvalid,
  output logic                s_axi_awready,
  input  logic [31:0]         s_axi_wdata,
  input  logic [3:0]          s_axi_wstrb,
  input  logic                s_axi_wvalid,
  output logic                s_axi_wready,
  output logic [1:0]          s_axi_bresp,
  output logic                s_axi_bvalid,
  input  logic                s_axi_bready,
  input  logic [ControlW-1:0] s_axi_araddr,
  input  logic [2:0]          s_axi_arprot,  // not looked at
  input  logic                s_axi_arvalid,
  output logic                s_axi_arready,
  output logic [31:0]         s_axi_rdata,
  output logic [1:0]          s_axi_rresp,
  output logic                s_axi_rvalid,
  input  logic                s_axi_rready,

  output logic [IdW-1:0]      m_axi_awid,
  output logic [AddrW-1:0]    m_axi_awaddr,
  output logic [7:0]          m_axi_awlen,
  output logic [2:0]          m_axi_awsize,
  output logic [1:0]          m_axi_awburst,
  output logic [3:0]          m_axi_awcache,
  output logic [2:0]          m_axi_awprot,
  output logic                m_axi_awvalid,
  input  logic                m_axi_awready,
  output logic [DataW-1:0]    m_axi_wdata,
  output logic [DataW/8-1:0]  m_axi_wstrb,
  output logic                m_axi_wlast,
  output logic                m_axi_wvalid,
  input  logic                m_axi_wready,
  input  logic [IdW-1:0]      m_axi_bid,
  input  logic [1:0]          m_axi_bresp,
  input  logic                m_axi_bvalid,
  output logic                m_axi_bready,
  output logic [IdW-1:0]      m_axi_arid,
  output logic [AddrW-1:0]    m_axi_araddr,
  output logic [7:0]          m_axi_arlen,
  output logic [2:0]          m_axi_arsize,
  output logic [1:0]          m_axi_arburst,
  output logic [3:0]          m_axi_arcache,
  output logic [2:0]          m_axi_arprot,
  output logic                m_axi_arvalid,
  input  logic                m_axi_arready,
  input  logic [IdW-1:0]      m_axi_rid,
  input  logic [DataW-1:0]    m_axi_rdata,
  input  logic [1:0]          m_axi_rresp,
  input  logic                m_axi_rlast,
  input  logic                m_axi_rvalid,
  output logic                m_axi_rready
);

  if (AddrW < 40) begin : gen_narrow
    $error("pipegs_axi: AddrW is below 40, and addresses would wrap");
  end
  if (Base[11:0] != '0) begin : gen_unaligned
    $error("pipegs_axi: Base is not a multiple of 4096");
  end

  localparam int unsigned MemoryW = pipegs_pkg::MemoryW;
  localparam int unsigned LineW   = pipegs_pkg::AddressW;
  localparam int unsigned WritesW = $clog2(pipegs_pkg::BusWrites + 1);

  pipegs_pkg::axi_lite_manager_t     control;
  pipegs_pkg::axi_lite_subordinate_t answer;
  pipegs_pkg::axi_manager_t          bus;
  pipegs_pkg::axi_subordinate_t      memory;
  logic                         rst_n;
  logic                         valid, ready, rsp_valid, epoch, drained, answered;
  pipegs_pkg::memory_request_t  request;
  logic [MemoryW-1:0]           data, rsp_data;
  logic [pipegs_pkg::TagW-1:0]  rsp_tag;
  logic [WritesW-1:0]           writes;
  logic [3:0]                   error;
  logic [LineW-1:0]             error_line;
  pipegs_pkg::memory_wait_t     read_wait, write_wait;

  pipegs_reset_sync u_reset (
    .clk_i(aclk),
    .rst_ni(aresetn),
    .test_mode_i(test_mode),
    .rst_no(rst_n)
  );

  // --- the ports are the fields of the channels ----------------------------------------------------------------------
  assign control.aw_addr        = s_axi_awaddr;
  assign control.aw_valid       = s_axi_awvalid;
  assign control.w_data         = s_axi_wdata;
  assign control.w_strb         = s_axi_wstrb;
  assign control.w_valid        = s_axi_wvalid;
  assign control.b_ready        = s_axi_bready;
  assign control.ar_addr        = s_axi_araddr;
  assign control.ar_valid       = s_axi_arvalid;
  assign control.r_ready        = s_axi_rready;
  assign s_axi_awready          = answer.aw_ready && rst_n;
  assign s_axi_wready           = answer.w_ready && rst_n;
  assign s_axi_arready          = answer.ar_ready && rst_n;
  assign s_axi_bresp            = answer.b_resp;
  assign s_axi_bvalid           = answer.b_valid;
  assign s_axi_rdata            = answer.r_data;
  assign s_axi_rresp            = answer.r_resp;
  assign s_axi_rvalid           = answer.r_valid;
  assign m_axi_awid             = bus.write.aw.id;
  assign m_axi_awaddr           = bus.write.aw.addr[AddrW-1:0];
  assign m_axi_awlen            = bus.write.aw.len;
  assign m_axi_awsize           = bus.write.aw.size;
  assign m_axi_awburst          = bus.write.aw.burst;
  assign m_axi_awcache          = bus.write.aw.cache;
  assign m_axi_awprot           = bus.write.aw.prot;
  assign m_axi_awvalid          = bus.write.aw_valid;
  assign m_axi_wdata            = bus.write.w.data;
  assign m_axi_wstrb            = bus.write.w.strb;
  assign m_axi_wlast            = bus.write.w.last;
  assign m_axi_wvalid           = bus.write.w_valid;
  assign m_axi_bready           = bus.write.b_ready;
  assign m_axi_arid             = bus.read.ar.id;
  assign m_axi_araddr           = bus.read.ar.addr[AddrW-1:0];
  assign m_axi_arlen            = bus.read.ar.len;
  assign m_axi_arsize           = bus.read.ar.size;
  assign m_axi_arburst          = bus.read.ar.burst;
  assign m_axi_arcache          = bus.read.ar.cache;
  assign m_axi_arprot           = bus.read.ar.prot;
  assign m_axi_arvalid          = bus.read.ar_valid;
  assign m_axi_rready           = bus.read.r_ready;
  assign memory.write.aw_ready  = m_axi_awready;
  assign memory.write.w_ready   = m_axi_wready;
  assign memory.write.b.id      = m_axi_bid;
  assign memory.write.b.resp    = m_axi_bresp;
  assign memory.write.b_valid   = m_axi_bvalid;
  assign memory.read.ar_ready   = m_axi_arready;
  assign memory.read.r.id       = m_axi_rid;
  assign memory.read.r.data     = m_axi_rdata;
  assign memory.read.r.resp     = m_axi_rresp;
  assign memory.read.r.last     = m_axi_rlast;
  assign memory.read.r_valid    = m_axi_rvalid;

  pipegs_host u_host (
    .clk_i(aclk),
    .rst_ni(rst_n),
    .test_mode_i(test_mode),
    .scan_en_i(scan_enable),
    .s_axi_i(control),
    .s_axi_o(answer),
    .irq_o(irq),
    .mem_valid_o(valid),
    .mem_ready_i(ready),
    .mem_request_o(request),
    .mem_data_o(data),
    .mem_rsp_valid_i(rsp_valid),
    .mem_rsp_tag_i(rsp_tag),
    .mem_rsp_data_i(rsp_data),
    .mem_epoch_o(epoch),
    .mem_drained_i(drained),
    .mem_writes_i(writes),
    .mem_answered_i(answered),
    .mem_error_i(error),
    .mem_error_line_i(error_line),
    .mem_read_wait_i(read_wait),
    .mem_write_wait_i(write_wait)
  );

  pipegs_axi_manager #(.AddrW(AddrW)) u_manager (
    .clk_i(aclk),
    .rst_ni(rst_n),
    .base_i(Base),
    .epoch_i(epoch),
    .drained_o(drained),
    .pending_o(),
    .mem_valid_i(valid),
    .mem_ready_o(ready),
    .mem_request_i(request),
    .mem_data_i(data),
    .rsp_valid_o(rsp_valid),
    .rsp_tag_o(rsp_tag),
    .rsp_data_o(rsp_data),
    .error_o(error),
    .error_line_o(error_line),
    .writes_o(writes),
    .answered_o(answered),
    .read_wait_o(read_wait),
    .write_wait_o(write_wait),
    .m_axi_o(bus),
    .m_axi_i(memory)
  );

  logic unused;
  assign unused = &{1'b0, s_axi_awprot, s_axi_arprot, bus.read.ar.addr, bus.write.aw.addr};

endmodule
