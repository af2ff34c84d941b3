// SPDX-License-Identifier: Apache-2.0
// Printed by package/machine.py: signals for pipegs_axi and its instance, to be put into a module and edited.
  logic         aclk;           // input  the only clock; units inside have gated ones of their own
  logic         aresetn;        // input  low: reset; falls and rises at any time
  logic         test_mode;      // input  1, and it stays so for the scan test: aresetn goes straight to the reset of
                                //        every flip-flop, the core's too; tie to 0
  logic         scan_enable;    // input  1 while patterns shift: every gated clock runs; tie to 0
  logic         irq;            // output level, a register: high while a bit of IRQ_STATUS is set that IRQ_ENABLE has
  logic [11:0]  s_axi_awaddr;   // input  byte; the two low bits do not count. The system decodes the bits above: 4 KiB
                                //        of registers
  logic [2:0]   s_axi_awprot;   // input  not looked at; tie to 0
  logic         s_axi_awvalid;  // input  AW and W come in any order
  logic         s_axi_awready;  // output an answer comes two cycles behind its request
  logic [31:0]  s_axi_wdata;    // input  a register's word
  logic [3:0]   s_axi_wstrb;    // input  honoured everywhere; tie to 4'b1111 where only words are written
  logic         s_axi_wvalid;   // input  AW and W come in any order
  logic         s_axi_wready;   // output an answer comes two cycles behind its request
  logic [1:0]   s_axi_bresp;    // output OKAY or SLVERR
  logic         s_axi_bvalid;   // output an answer comes two cycles behind its request
  logic         s_axi_bready;   // input  AW and W come in any order
  logic [11:0]  s_axi_araddr;   // input  byte; the two low bits do not count. The system decodes the bits above: 4 KiB
                                //        of registers
  logic [2:0]   s_axi_arprot;   // input  not looked at; tie to 0
  logic         s_axi_arvalid;  // input  AW and W come in any order
  logic         s_axi_arready;  // output an answer comes two cycles behind its request
  logic [31:0]  s_axi_rdata;    // output a register's word
  logic [1:0]   s_axi_rresp;    // output OKAY or SLVERR
  logic         s_axi_rvalid;   // output an answer comes two cycles behind its request
  logic         s_axi_rready;   // input  AW and W come in any order
  logic [5:0]   m_axi_awid;     // output 0
  logic [39:0]  m_axi_awaddr;   // output a multiple of 64; with record = 48 a read's of 32
  logic [7:0]   m_axi_awlen;    // output one line: 512 / D - 1
  logic [2:0]   m_axi_awsize;   // output all of D: 4, 5 or 6; with record = 48 and D = 512 5 for half a line
  logic [1:0]   m_axi_awburst;  // output 2'b01: INCR
  logic [3:0]   m_axi_awcache;  // output 4'b0010: normal, not cached, not buffered
  logic [2:0]   m_axi_awprot;   // output 3'b000: data, secure, unprivileged
  logic         m_axi_awvalid;  // output a line's AW and first W show in the same cycle; either may be taken first
  logic         m_axi_awready;  // input  may come before what they answer, or behind
  logic [511:0] m_axi_wdata;    // output the byte of address a in bits 8 * (a mod D/8) and up
  logic [63:0]  m_axi_wstrb;    // output set or clear for 32 aligned bytes at a time; beats without any occur
  logic         m_axi_wlast;    // output the last beat of a line
  logic         m_axi_wvalid;   // output a line's AW and first W show in the same cycle; either may be taken first
  logic         m_axi_wready;   // input  may come before what they answer, or behind
  logic [5:0]   m_axi_bid;      // input  not looked at
  logic [1:0]   m_axi_bresp;    // input  OKAY and EXOKAY are good, SLVERR and DECERR end the frame
  logic         m_axi_bvalid;   // input  rlast is needed
  logic         m_axi_bready;   // output 1 while a write is unanswered
  logic [5:0]   m_axi_arid;     // output {epoch, tag}: all I bits come back in rid
  logic [39:0]  m_axi_araddr;   // output a multiple of 64; with record = 48 a read's of 32
  logic [7:0]   m_axi_arlen;    // output 1 to 8 lines of 64 bytes: n * 512 / D - 1, within 512 aligned bytes; with
                                //        record = 48 also half a line: 256 / D - 1, of D = 512 one beat
  logic [2:0]   m_axi_arsize;   // output all of D: 4, 5 or 6; with record = 48 and D = 512 5 for half a line
  logic [1:0]   m_axi_arburst;  // output 2'b01: INCR
  logic [3:0]   m_axi_arcache;  // output 4'b0010: normal, not cached, not buffered
  logic [2:0]   m_axi_arprot;   // output 3'b000: data, secure, unprivileged
  logic         m_axi_arvalid;  // output a line's AW and first W show in the same cycle; either may be taken first
  logic         m_axi_arready;  // input  may come before what they answer, or behind
  logic [5:0]   m_axi_rid;      // input  answers of different IDs may come in any order, beats interleaved
  logic [511:0] m_axi_rdata;    // input  the byte of address a in bits 8 * (a mod D/8) and up
  logic [1:0]   m_axi_rresp;    // input  OKAY and EXOKAY are good, SLVERR and DECERR end the frame
  logic         m_axi_rlast;    // input  rlast is needed
  logic         m_axi_rvalid;   // input  rlast is needed
  logic         m_axi_rready;   // output always 1

  pipegs_axi #(
    .AddrW(40),  // bits of an address on m_axi
    .Base(40'h0)  // what is added to every address that software gives, a multiple of 4096
  ) u_pipegs (
    .aclk(aclk),
    .aresetn(aresetn),
    .test_mode(test_mode),
    .scan_enable(scan_enable),
    .irq(irq),
    .s_axi_awaddr(s_axi_awaddr),
    .s_axi_awprot(s_axi_awprot),
    .s_axi_awvalid(s_axi_awvalid),
    .s_axi_awready(s_axi_awready),
    .s_axi_wdata(s_axi_wdata),
    .s_axi_wstrb(s_axi_wstrb),
    .s_axi_wvalid(s_axi_wvalid),
    .s_axi_wready(s_axi_wready),
    .s_axi_bresp(s_axi_bresp),
    .s_axi_bvalid(s_axi_bvalid),
    .s_axi_bready(s_axi_bready),
    .s_axi_araddr(s_axi_araddr),
    .s_axi_arprot(s_axi_arprot),
    .s_axi_arvalid(s_axi_arvalid),
    .s_axi_arready(s_axi_arready),
    .s_axi_rdata(s_axi_rdata),
    .s_axi_rresp(s_axi_rresp),
    .s_axi_rvalid(s_axi_rvalid),
    .s_axi_rready(s_axi_rready),
    .m_axi_awid(m_axi_awid),
    .m_axi_awaddr(m_axi_awaddr),
    .m_axi_awlen(m_axi_awlen),
    .m_axi_awsize(m_axi_awsize),
    .m_axi_awburst(m_axi_awburst),
    .m_axi_awcache(m_axi_awcache),
    .m_axi_awprot(m_axi_awprot),
    .m_axi_awvalid(m_axi_awvalid),
    .m_axi_awready(m_axi_awready),
    .m_axi_wdata(m_axi_wdata),
    .m_axi_wstrb(m_axi_wstrb),
    .m_axi_wlast(m_axi_wlast),
    .m_axi_wvalid(m_axi_wvalid),
    .m_axi_wready(m_axi_wready),
    .m_axi_bid(m_axi_bid),
    .m_axi_bresp(m_axi_bresp),
    .m_axi_bvalid(m_axi_bvalid),
    .m_axi_bready(m_axi_bready),
    .m_axi_arid(m_axi_arid),
    .m_axi_araddr(m_axi_araddr),
    .m_axi_arlen(m_axi_arlen),
    .m_axi_arsize(m_axi_arsize),
    .m_axi_arburst(m_axi_arburst),
    .m_axi_arcache(m_axi_arcache),
    .m_axi_arprot(m_axi_arprot),
    .m_axi_arvalid(m_axi_arvalid),
    .m_axi_arready(m_axi_arready),
    .m_axi_rid(m_axi_rid),
    .m_axi_rdata(m_axi_rdata),
    .m_axi_rresp(m_axi_rresp),
    .m_axi_rlast(m_axi_rlast),
    .m_axi_rvalid(m_axi_rvalid),
    .m_axi_rready(m_axi_rready)
  );
