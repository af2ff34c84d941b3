// SPDX-License-Identifier: Apache-2.0
// pipegs_sim: the machine as it is simulated: pipegs_axi, and what the harness sees of its inside.
//
// Idea    No port of the product shows a stream, so this one looks by name. With BusW = 0 there is no bus: pipegs_host
//         stands alone, its port to memory is mem_*, and m_axi is quiet; else mem_* only tell what the core asks
//         for. With Taps = 0 only the ports of the product, the memory port and the ends of frames show.
// Stream  As pipegs_axi. mem_valid_o with mem_ready_o: the core's request was accepted. tap_*: what moves on the
//         streams.
// Pace    No register of its own but a count of reads (BusW = 0).
// Model   sim/rtl/rtl_bridge.cpp clocks it.

`define PIPEGS_LOOK(CORE) \
  assign core_busy            = CORE.busy_o; \
  assign core_take            = CORE.front_take; \
  assign sorted_taken         = CORE.sorted_taken; \
  assign sorted               = CORE.sorted; \
  assign taps                 = CORE.taps; \
  assign window_x             = CORE.progress.x; \
  assign window_y             = CORE.progress.y; \
  assign splat_valid          = CORE.tap_splat_valid; \
  assign splat                = CORE.tap_splat; \
  assign chunk_valid          = CORE.tap_chunk_valid; \
  assign chunk                = CORE.tap_chunk; \
  assign state                = CORE.perf_state; \
  assign layer_done           = CORE.layer_done; \
  assign line_free            = CORE.line_free; \
  assign window_done          = CORE.window_done; \
  assign border               = { \
    CORE.u_raster.memory_o.write, CORE.u_raster.memory_o.valid & CORE.u_raster.memory_i.ready, \
    CORE.u_raster.memory_o.valid, \
    CORE.u_raster.splat_valid & CORE.u_raster.splat_ready, CORE.u_sorting.spilling, CORE.u_sorting.sort_o.valid, \
    CORE.u_sorting.in_order_ready, CORE.u_sorting.in_order_valid, CORE.u_sorting.su_active, \
    CORE.u_sorting.splat_valid & CORE.u_sorting.splat_ready, CORE.splat_ready, CORE.splat_valid, \
    CORE.u_front.reads_i.line[Units-1:0], CORE.u_front.reads_o.valid[Units-1:0], CORE.u_front.culled_valid, \
    CORE.u_front.dealt_valid & CORE.u_front.dealt_ready, CORE.u_front.pu_busy, CORE.u_front.chunk_room, \
    CORE.u_front.chunk_valid, Units'(CORE.u_front.reads_i.line[2*Units]), \
    Units'(CORE.u_front.reads_o.valid[2*Units] && CORE.u_front.reads_i.ready[2*Units]), \
    Units'(CORE.u_front.reads_o.valid[2*Units]), \
    Units'(CORE.u_front.dopu_busy)};

module pipegs_sim #(
  localparam int unsigned Bus       = pipegs_pkg::BusW,
  localparam int unsigned MemoryW   = pipegs_pkg::MemoryW,
  localparam int unsigned Units     = pipegs_pkg::Units,
  localparam int unsigned PerfUnits = 1 + 3 * Units,
  localparam int unsigned Borders   = 23,
  localparam int unsigned TapsN     = Units * pipegs_pkg::TapLanes
) (
  input  logic                aclk,
  input  logic                aresetn,
  output logic                irq,

  input  pipegs_pkg::axi_lite_manager_t     s_axi_i,
  output pipegs_pkg::axi_lite_subordinate_t s_axi_o,
  output pipegs_pkg::axi_manager_t          m_axi_o,
  input  pipegs_pkg::axi_subordinate_t      m_axi_i,

  output logic                          mem_valid_o,
  output logic                          mem_ready_o,
  input  logic                          mem_ready_i,      // BusW = 0, as the following inputs
  output pipegs_pkg::memory_request_t   mem_request_o,
  output logic [MemoryW-1:0]            mem_data_o,
  output logic                          tap_answer_valid_o, // an answer comes to the core
  output logic [pipegs_pkg::TagW-1:0]   tap_answer_tag_o,
  input  logic                          mem_rsp_valid_i,
  input  logic [pipegs_pkg::TagW-1:0]   mem_rsp_tag_i,
  input  logic [MemoryW-1:0]            mem_rsp_data_i,

  output logic                          tap_take_o,         // the core takes a frame
  output logic                          tap_busy_o,         // a frame is in the core
  output logic                          tap_left_o,         // pulse: its last pixel has left the core
  output logic                          tap_done_o,         // pulse: a frame is complete in memory
  output logic                          tap_reset_o,        // the core is kept apart, and in reset
  output logic [Units-1:0]              tap_splat_valid_o,
  output logic [Units*pipegs_pkg::SplatBits-1:0] tap_splat_o,
  output logic                          tap_sorted_valid_o,
  output pipegs_pkg::sorted_t           tap_sorted_o,
  output logic [Units*pipegs_pkg::WindowW-1:0] tap_window_x_o,
  output logic [Units*pipegs_pkg::WindowW-1:0] tap_window_y_o,
  output logic [TapsN-1:0]              tap_alphas_valid_o,
  output logic [TapsN*pipegs_pkg::ShownIndexW-1:0] tap_alphas_index_o,
  output logic [TapsN*pipegs_pkg::RegionW-1:0] tap_alphas_region_o,
  output logic [TapsN*2-1:0]            tap_alphas_quarter_o,
  output logic [TapsN*pipegs_pkg::TapLineW-1:0] tap_alphas_o,
  output logic [TapsN-1:0]              tap_pixels_valid_o,
  output logic [TapsN*pipegs_pkg::RegionW-1:0] tap_pixels_region_o,
  output logic [TapsN*2-1:0]            tap_pixels_quarter_o,
  output logic [TapsN*pipegs_pkg::TapWordW-1:0] tap_pixels_o,
  output logic [Units-1:0]              tap_chunk_valid_o,  // DOPU -> PU
  output logic [pipegs_pkg::ChunkBits-1:0] tap_chunk_o,
  output logic [PerfUnits*2-1:0]        tap_state_o,        // of each unit in the order of perf_o, see pipegs_perf
  output logic [Borders*Units-1:0]      tap_border_o,       // what stands at the borders of the units, see RtlBorder
  output logic [Units-1:0]              tap_line_free_o,    // pulse: a line has left the alpha store
  output logic [Units-1:0]              tap_layer_done_o,   // pulse: the RU has blended a layer
  output logic [Units-1:0]              tap_window_done_o   // pulse: with it, the window is complete
);

  localparam int unsigned SplatBits = pipegs_pkg::SplatBits;

  logic                             core_busy, core_take, sorted_taken, left, done, apart;
  pipegs_pkg::sorted_t              sorted;
  pipegs_pkg::raster_taps_t         taps;
  logic [Units*pipegs_pkg::WindowW-1:0] window_x, window_y;
  logic [Units-1:0]                 splat_valid, chunk_valid, line_free, layer_done, window_done;
  logic [Units*SplatBits-1:0]       splat;
  pipegs_pkg::chunk_t               chunk;
  logic [PerfUnits*2-1:0]           state;
  logic [Borders*Units-1:0]         border;

  if (Bus == 0) begin : gen_port
    // The port orders writes by itself; what a reset core has asked for is counted until it is answered.
    logic [31:0] asked, reads_q;  // lines
    assign asked = mem_valid_o && mem_ready_i && !mem_request_o.write ? 32'(mem_request_o.lines) + 32'd1 : '0;
    pipegs_host u_host (
      .clk_i(aclk), .rst_ni(aresetn), .test_mode_i(1'b0), .scan_en_i(1'b0), .s_axi_i, .s_axi_o,
      .irq_o(irq), .mem_valid_o, .mem_ready_i, .mem_request_o, .mem_data_o, .mem_rsp_valid_i, .mem_rsp_tag_i,
      .mem_rsp_data_i, .mem_epoch_o(), .mem_drained_i(reads_q == '0), .mem_writes_i('0),
      .mem_answered_i(1'b0), .mem_error_i('0), .mem_error_line_i('0), .mem_read_wait_i('0), .mem_write_wait_i('0)
    );
    always_ff @(posedge aclk or negedge aresetn) begin
      if (!aresetn) reads_q <= '0;
      else reads_q <= reads_q + asked - 32'(mem_rsp_valid_i);
    end
    assign mem_ready_o = mem_ready_i;
    assign left        = u_host.core_done;
    assign tap_answer_valid_o = mem_rsp_valid_i;
    assign tap_answer_tag_o   = mem_rsp_tag_i;
    assign done        = u_host.done;
    assign apart       = u_host.apart;
    `PIPEGS_LOOK(u_host.u_core)
    assign m_axi_o = '0;
    logic unused_bus;
    assign unused_bus = &{1'b0, m_axi_i};
  end else begin : gen_bus
    pipegs_axi #(.AddrW(pipegs_pkg::AxiAddrW)) u_axi (
      .aclk, .aresetn, .test_mode(1'b0), .scan_enable(1'b0), .irq, .s_axi_awprot('0), .s_axi_arprot('0),
      .s_axi_awaddr(s_axi_i.aw_addr), .s_axi_awvalid(s_axi_i.aw_valid), .s_axi_wdata(s_axi_i.w_data),
      .s_axi_wstrb(s_axi_i.w_strb), .s_axi_wvalid(s_axi_i.w_valid), .s_axi_bready(s_axi_i.b_ready),
      .s_axi_araddr(s_axi_i.ar_addr), .s_axi_arvalid(s_axi_i.ar_valid), .s_axi_rready(s_axi_i.r_ready),
      .s_axi_awready(s_axi_o.aw_ready), .s_axi_wready(s_axi_o.w_ready), .s_axi_arready(s_axi_o.ar_ready),
      .s_axi_bresp(s_axi_o.b_resp), .s_axi_bvalid(s_axi_o.b_valid), .s_axi_rdata(s_axi_o.r_data),
      .s_axi_rresp(s_axi_o.r_resp), .s_axi_rvalid(s_axi_o.r_valid), .m_axi_awid(m_axi_o.write.aw.id),
      .m_axi_awaddr(m_axi_o.write.aw.addr), .m_axi_awlen(m_axi_o.write.aw.len),
      .m_axi_awsize(m_axi_o.write.aw.size), .m_axi_awburst(m_axi_o.write.aw.burst),
      .m_axi_awcache(m_axi_o.write.aw.cache), .m_axi_awprot(m_axi_o.write.aw.prot),
      .m_axi_awvalid(m_axi_o.write.aw_valid), .m_axi_wdata(m_axi_o.write.w.data), .m_axi_wstrb(m_axi_o.write.w.strb),
      .m_axi_wlast(m_axi_o.write.w.last), .m_axi_wvalid(m_axi_o.write.w_valid), .m_axi_bready(m_axi_o.write.b_ready),
      .m_axi_arid(m_axi_o.read.ar.id), .m_axi_araddr(m_axi_o.read.ar.addr),
      .m_axi_arlen(m_axi_o.read.ar.len), .m_axi_arsize(m_axi_o.read.ar.size), .m_axi_arburst(m_axi_o.read.ar.burst),
      .m_axi_arcache(m_axi_o.read.ar.cache), .m_axi_arprot(m_axi_o.read.ar.prot),
      .m_axi_arvalid(m_axi_o.read.ar_valid), .m_axi_rready(m_axi_o.read.r_ready),
      .m_axi_awready(m_axi_i.write.aw_ready), .m_axi_wready(m_axi_i.write.w_ready), .m_axi_bid(m_axi_i.write.b.id),
      .m_axi_bresp(m_axi_i.write.b.resp), .m_axi_bvalid(m_axi_i.write.b_valid), .m_axi_arready(m_axi_i.read.ar_ready),
      .m_axi_rid(m_axi_i.read.r.id), .m_axi_rdata(m_axi_i.read.r.data), .m_axi_rresp(m_axi_i.read.r.resp),
      .m_axi_rlast(m_axi_i.read.r.last), .m_axi_rvalid(m_axi_i.read.r_valid)
    );
    assign mem_valid_o   = u_axi.valid;
    assign mem_ready_o   = u_axi.ready;
    assign mem_request_o = u_axi.request;
    assign mem_data_o    = u_axi.data;
    assign left          = u_axi.u_host.core_done;
    assign tap_answer_valid_o = u_axi.rsp_valid;
    assign tap_answer_tag_o   = u_axi.rsp_tag;
    assign done          = u_axi.u_host.done;
    assign apart         = u_axi.u_host.apart;
    `PIPEGS_LOOK(u_axi.u_host.u_core)
    logic unused_port;
    assign unused_port = &{1'b0, mem_ready_i, mem_rsp_valid_i, mem_rsp_tag_i, mem_rsp_data_i};
  end

  localparam bit Shown = pipegs_pkg::Taps != 0;
  assign tap_take_o           = core_take;
  assign tap_busy_o           = core_busy;
  assign tap_left_o           = left;
  assign tap_done_o           = done;
  assign tap_reset_o          = apart;
  assign tap_splat_valid_o    = Shown ? splat_valid : '0;
  assign tap_splat_o          = Shown ? splat : '0;
  assign tap_sorted_valid_o   = Shown ? sorted_taken : '0;
  assign tap_sorted_o         = Shown ? sorted : '0;
  assign tap_window_x_o       = Shown ? window_x : '0;
  assign tap_window_y_o       = Shown ? window_y : '0;
  assign tap_alphas_valid_o   = Shown ? taps.alphas_valid : '0;
  assign tap_alphas_index_o   = Shown ? taps.alphas_index : '0;
  assign tap_alphas_region_o  = Shown ? taps.alphas_region : '0;
  assign tap_alphas_quarter_o = Shown ? taps.alphas_quarter : '0;
  assign tap_alphas_o         = Shown ? taps.alphas : '0;
  assign tap_pixels_valid_o   = Shown ? taps.pixels_valid : '0;
  assign tap_pixels_region_o  = Shown ? taps.pixels_region : '0;
  assign tap_pixels_quarter_o = Shown ? taps.pixels_quarter : '0;
  for (genvar k = 0; k < Units; k += 1) begin : gen_pixels  // one zero of all would be wider than Verilator allows
    localparam int unsigned PixelsW = TapsN / Units * pipegs_pkg::TapWordW;
    assign tap_pixels_o[k*PixelsW+:PixelsW] = Shown ? taps.pixels[k] : '0;
  end
  assign tap_chunk_valid_o    = Shown ? chunk_valid : '0;
  assign tap_chunk_o          = Shown ? chunk : '0;
  assign tap_state_o          = Shown ? state : '0;
  assign tap_border_o         = Shown ? border : '0;
  assign tap_line_free_o      = Shown ? line_free : '0;
  assign tap_layer_done_o     = Shown ? layer_done : '0;
  assign tap_window_done_o    = Shown ? window_done : '0;

endmodule
