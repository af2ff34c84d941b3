// pipegs_top: the whole machine: DOPU, PUs, SUs, RUs and their buffers behind one port to external memory.
//
// Paper   Fig. 7, Table 2.
// Idea    DOPU -> PU[k] (with pu_deal between cull and projection) -> SU[k] -> su_merge -> ru_dispatch -> RU[j]; alpha store k lies between PU k and all RUs
//         (with cached coefficients there is none: Late). With lists (Order 1) they lie between the PUs and the SUs, and
//         in time between the two halves of the machine.
//         While the RUs blend layer i, the SUs sort behind them and the PUs already work on layer i + 1, across windows too.
//         Every unit has a clock of its own that stops while it has nothing to do. Only wiring here.
//         frame_i goes through a register, so that nothing inside depends on an input port combinationally.
// Stream  start_i with frame_i, which is stable from one cycle before start_i; the scene and the frame lie in external memory; busy_o falls when the last pixel is written.
//         tap_*: what moves on the streams and what each unit does, for the harness; all 0 if Taps is 0. perf_o: cycles busy, starved, blocked, memory of each unit,
//         in the order DOPU, PUs, SUs, RUs.
// Model   cpp_model/golden.hpp

module pipegs_top #(
  localparam int unsigned Units      = pipegs_pkg::Units,
  localparam int unsigned PerfW      = pipegs_pkg::PerfW,
  localparam int unsigned PerfUnits  = 1 + 3 * Units,
  localparam int unsigned LineW      = pipegs_pkg::LineW,
  localparam int unsigned MemoryW    = pipegs_pkg::MemoryW,
  localparam int unsigned PixelWordW = pipegs_pkg::PixelWordW
) (
  input  logic                                 clk_i,
  input  logic                                 rst_ni,

  input  logic                                 start_i,
  input  pipegs_pkg::frame_t                   frame_i,
  output logic                                 busy_o,

  output logic                                 mem_valid_o,
  input  logic                                 mem_ready_i,
  output pipegs_pkg::memory_request_t          mem_request_o,
  output logic [MemoryW-1:0]                   mem_data_o,
  input  logic                                 mem_rsp_valid_i,
  input  logic [pipegs_pkg::TagW-1:0]          mem_rsp_tag_i,
  input  logic [MemoryW-1:0]                   mem_rsp_data_i,

  output logic [PerfW-1:0]                     cycles_o,
  output logic [PerfW-1:0]                     preprocess_cycles_o,  // with lists: of cycles_o, before the first list is read
  output logic [PerfW-1:0]                     overflow_lines_o,
  output logic [PerfUnits*4*PerfW-1:0]         perf_o,

  output logic [Units-1:0]                     tap_splat_valid_o,
  output logic [Units*pipegs_pkg::SplatBits-1:0] tap_splat_o,
  output logic                                 tap_sorted_valid_o,
  output pipegs_pkg::sorted_t                  tap_sorted_o,
  output logic [Units*pipegs_pkg::WindowW-1:0] tap_window_x_o,
  output logic [Units*pipegs_pkg::WindowW-1:0] tap_window_y_o,
  output logic [Units-1:0]                     tap_alphas_valid_o,
  output logic [Units*pipegs_pkg::TapIndexW-1:0] tap_alphas_index_o,
  output logic [Units*pipegs_pkg::RegionW-1:0] tap_alphas_region_o,
  output logic [Units*LineW-1:0]               tap_alphas_o,
  output logic [Units-1:0]                     tap_pixels_valid_o,
  output logic [Units*pipegs_pkg::RegionW-1:0] tap_pixels_region_o,
  output logic [Units*2-1:0]                   tap_pixels_quarter_o,
  output logic [Units*PixelWordW-1:0]          tap_pixels_o,
  output logic [Units-1:0]                     tap_chunk_valid_o,  // DOPU -> PU
  output logic [pipegs_pkg::KindW-1:0]         tap_chunk_kind_o,
  output logic [PerfUnits*2-1:0]               tap_state_o,        // of each unit in the order of perf_o, see perf
  output logic [Units-1:0]                     tap_layer_done_o,   // pulse: the RU has blended a layer
  output logic [Units-1:0]                     tap_window_done_o   // pulse: with it, the window is complete
);

  localparam int unsigned Ports         = pipegs_pkg::MemoryPorts;
  localparam int unsigned WritePorts    = pipegs_pkg::WritePorts;
  localparam int unsigned AddressW      = pipegs_pkg::AddressW;
  localparam int unsigned Regions       = pipegs_pkg::Regions;
  localparam int unsigned WindowW       = pipegs_pkg::WindowW;
  localparam int unsigned AlphaAddressW = pipegs_pkg::AlphaAddressW;
  localparam int unsigned LinesW        = pipegs_pkg::RegionW + 1;
  // Memory ports: those that write come first, see memory_arbiter.
  localparam int unsigned AlphaPort    = 0;
  localparam int unsigned SortPort     = Units;
  localparam int unsigned RasterPort   = 2 * Units;
  localparam int unsigned ListPort     = 3 * Units;   // there are lists only if Order is 1
  localparam int unsigned GeometryPort = WritePorts;
  localparam int unsigned ColorPort    = WritePorts + Units;
  localparam int unsigned NodePort     = WritePorts + 2 * Units;

  logic                          restart, running, idle, layer_free;
  logic [Units-1:0]              window_done, layer_done, overflow_sort, spilling;
  logic [Units*LinesW-1:0]       overflow_alpha;
  logic [Units*Regions-1:0]      done;
  logic [Units*WindowW-1:0]      done_x, done_y;
  logic                          dopu_active;
  logic [Units-1:0]              pu_active, su_active, ru_active;
  logic [PerfUnits*2-1:0]        perf_state;

  logic [Ports-1:0]              mem_valid, mem_ready, rsp_valid;
  logic [WritePorts-1:0]         mem_write;
  logic [Ports*AddressW-1:0]     mem_address;
  logic [WritePorts*MemoryW-1:0] mem_data;
  logic [MemoryW-1:0]            rsp_data;

  logic [Units-1:0]              chunk_valid, chunk_ready;
  pipegs_pkg::chunk_t            chunk;
  logic [Units-1:0]              splat_valid, splat_ready, in_order_valid, in_order_ready;
  logic [Units*pipegs_pkg::SplatBits-1:0] splat, in_order;
  logic [Units-1:0]              made_valid, made_ready;  // splats as the PUs make them
  logic [Units*pipegs_pkg::SplatBits-1:0] made;
  logic [Units*pipegs_pkg::ListWindowW-1:0] made_number;
  logic                          written, lists_busy;
  logic                          sorted_valid, sorted_ready;
  pipegs_pkg::sorted_t           sorted;
  logic [Units-1:0]              raster_valid, raster_ready;
  pipegs_pkg::sorted_t           raster;
  logic                          merge_active, dispatch_active, deal_active;
  logic [Units-1:0]              culled_valid, culled_ready, dealt_valid, dealt_ready;
  logic [Units*pipegs_pkg::VisibleBits-1:0] culled;
  pipegs_pkg::visible_t          dealt;

  logic [Units*Units-1:0]        read_valid, read_ready, answer_valid;  // [RU * Units + store]
  logic [Units*AlphaAddressW-1:0] read_address;                         // of each RU
  logic [Units*LineW-1:0]        answer;                                // of each store

  logic [Units-1:0]                       ru_alphas_valid, ru_pixels_valid;  // for the taps
  logic [Units*pipegs_pkg::TapIndexW-1:0] ru_alphas_index;
  logic [Units*pipegs_pkg::RegionW-1:0]   ru_alphas_region, ru_pixels_region;
  logic [Units*LineW-1:0]                 ru_alphas;
  logic [Units*2-1:0]                     ru_pixels_quarter;
  logic [Units*PixelWordW-1:0]            ru_pixels;

  pipegs_pkg::frame_t frame_q;
  always_ff @(posedge clk_i) frame_q <= frame_i;

  scheduler u_scheduler (
    .clk_i, .rst_ni, .start_i, .frame_i(frame_q), .window_done_i(window_done), .idle_i(idle),
    .overflow_sort_i(overflow_sort), .overflow_alpha_i(overflow_alpha), .written_i(written),
    .restart_o(restart), .busy_o, .cycles_o, .preprocess_cycles_o, .overflow_lines_o
  );
  assign running = busy_o && !restart;
  assign idle    = !dopu_active && pu_active == '0 && su_active == '0 && ru_active == '0 && !merge_active &&
                   !dispatch_active && !deal_active && !lists_busy && mem_valid == '0 && !mem_valid_o;

  layer_free u_layer_free (.clk_i, .rst_ni, .done_i(layer_done), .free_o(layer_free));

  memory_arbiter u_memory (
    .clk_i, .rst_ni, .valid_i(mem_valid), .ready_o(mem_ready), .write_i(mem_write), .address_i(mem_address), .data_i(mem_data),
    .rsp_valid_o(rsp_valid), .rsp_data_o(rsp_data),
    .mem_valid_o, .mem_ready_i, .mem_request_o, .mem_data_o, .mem_rsp_valid_i, .mem_rsp_tag_i, .mem_rsp_data_i
  );

  logic dopu_clk;
  clock_gate u_dopu_gate (.clk_i, .rst_ni, .enable_i(dopu_active), .clk_o(dopu_clk));
  dopu u_dopu (
    .clk_i(dopu_clk), .rst_ni, .start_i(restart), .frame_i(frame_q), .busy_o(),
    .mem_valid_o(mem_valid[NodePort]), .mem_ready_i(mem_ready[NodePort]),
    .mem_address_o(mem_address[NodePort*AddressW +: AddressW]), .rsp_valid_i(rsp_valid[NodePort]), .rsp_data_i(rsp_data),
    .done_i(done), .done_x_i(done_x), .done_y_i(done_y),
    .chunk_valid_o(chunk_valid), .chunk_ready_i(chunk_ready), .chunk_o(chunk),
    .active_o(dopu_active), .perf_o(perf_state[1:0])
  );

  for (genvar k = 0; k < Units; k += 1) begin : gen_unit
    logic                     pu_clk, su_clk, ru_clk;
    logic                     store_write;
    logic [AlphaAddressW-1:0] store_address;
    logic [LineW-1:0]         store_line;
    logic [Units-1:0]         ru_answer_valid;

    clock_gate u_pu_gate (.clk_i, .rst_ni, .enable_i(pu_active[k]), .clk_o(pu_clk));
    pu u_pu (
      .clk_i(pu_clk), .rst_ni, .frame_i(frame_q), .unit_i(pipegs_pkg::UnitW'(k)), .restart_i(restart),
      .chunk_valid_i(chunk_valid[k]), .chunk_ready_o(chunk_ready[k]), .chunk_i(chunk),
      .culled_valid_o(culled_valid[k]), .culled_ready_i(culled_ready[k]),
      .culled_o(culled[k*pipegs_pkg::VisibleBits +: pipegs_pkg::VisibleBits]),
      .visible_valid_i(dealt_valid[k]), .visible_ready_o(dealt_ready[k]), .visible_i(dealt),
      .done_i(done), .done_x_i(done_x), .done_y_i(done_y), .layer_free_i(layer_free),
      .geometry_valid_o(mem_valid[GeometryPort+k]), .geometry_ready_i(mem_ready[GeometryPort+k]),
      .geometry_address_o(mem_address[(GeometryPort+k)*AddressW +: AddressW]), .geometry_rsp_valid_i(rsp_valid[GeometryPort+k]),
      .color_valid_o(mem_valid[ColorPort+k]), .color_ready_i(mem_ready[ColorPort+k]),
      .color_address_o(mem_address[(ColorPort+k)*AddressW +: AddressW]), .color_rsp_valid_i(rsp_valid[ColorPort+k]),
      .rsp_data_i(rsp_data),
      .spill_valid_o(mem_valid[AlphaPort+k]), .spill_ready_i(mem_ready[AlphaPort+k]),
      .spill_address_o(mem_address[(AlphaPort+k)*AddressW +: AddressW]), .spill_data_o(mem_data[(AlphaPort+k)*MemoryW +: MemoryW]),
      .store_write_o(store_write), .store_address_o(store_address), .store_line_o(store_line),
      .splat_valid_o(made_valid[k]), .splat_ready_i(made_ready[k]),
      .splat_o(made[k*pipegs_pkg::SplatBits +: pipegs_pkg::SplatBits]),
      .number_o(made_number[k*pipegs_pkg::ListWindowW +: pipegs_pkg::ListWindowW]),
      .overflowed_o(overflow_alpha[k*LinesW +: LinesW]), .active_o(pu_active[k]), .perf_o(perf_state[2*(1+k) +: 2])
    );
    assign mem_write[AlphaPort+k] = 1'b1;

    if (pipegs_pkg::Late == 0 && pipegs_pkg::Order != 1) begin : gen_store
      logic             store_clk, store_active;
      logic [Units-1:0] store_read_valid, store_read_ready, store_answer_valid;
      for (genvar j = 0; j < Units; j += 1) begin : gen_reader
        assign store_read_valid[j]     = read_valid[j*Units+k];
        assign read_ready[j*Units+k]   = store_read_ready[j];
        assign answer_valid[j*Units+k] = store_answer_valid[j];
      end
      clock_gate u_store_gate (.clk_i, .rst_ni, .enable_i(store_active), .clk_o(store_clk));
      alpha_store u_store (
        .clk_i(store_clk), .rst_ni, .write_i(store_write), .address_i(store_address), .line_i(store_line),
        .read_valid_i(store_read_valid), .read_ready_o(store_read_ready), .read_address_i(read_address),
        .answer_valid_o(store_answer_valid), .answer_o(answer[k*LineW +: LineW]), .active_o(store_active)
      );
    end else begin : gen_no_store
      assign read_ready[k*Units +: Units]   = '0;
      assign answer_valid[k*Units +: Units] = '0;
      assign answer[k*LineW +: LineW]       = '0;
      logic unused_store;
      assign unused_store = &{1'b0, store_write, store_address, store_line, read_valid[k*Units +: Units],
                              read_address[k*AlphaAddressW +: AlphaAddressW]};
    end

    clock_gate u_su_gate (.clk_i, .rst_ni, .enable_i(su_active[k]), .clk_o(su_clk));
    su u_su (
      .clk_i(su_clk), .rst_ni, .frame_i(frame_q), .unit_i(pipegs_pkg::UnitW'(k)),
      .in_valid_i(splat_valid[k]), .in_ready_o(splat_ready[k]),
      .in_i(splat[k*pipegs_pkg::SplatBits +: pipegs_pkg::SplatBits]),
      .out_valid_o(in_order_valid[k]), .out_ready_i(in_order_ready[k]),
      .out_o(in_order[k*pipegs_pkg::SplatBits +: pipegs_pkg::SplatBits]),
      .spill_i((spilling & ~(Units'(1) << k)) != '0), .spilling_o(spilling[k]),
      .mem_valid_o(mem_valid[SortPort+k]), .mem_ready_i(mem_ready[SortPort+k]), .mem_write_o(mem_write[SortPort+k]),
      .mem_address_o(mem_address[(SortPort+k)*AddressW +: AddressW]), .mem_data_o(mem_data[(SortPort+k)*MemoryW +: MemoryW]),
      .rsp_valid_i(rsp_valid[SortPort+k]), .rsp_data_i(rsp_data),
      .overflow_o(overflow_sort[k]), .active_o(su_active[k]), .perf_o(perf_state[2*(1+Units+k) +: 2])
    );

    assign ru_answer_valid = answer_valid[k*Units +: Units];
    clock_gate u_ru_gate (.clk_i, .rst_ni, .enable_i(ru_active[k]), .clk_o(ru_clk));
    ru u_ru (
      .clk_i(ru_clk), .rst_ni, .frame_i(frame_q), .unit_i(pipegs_pkg::UnitW'(k)), .restart_i(restart),
      .in_valid_i(raster_valid[k]), .in_ready_o(raster_ready[k]), .in_i(raster),
      .read_valid_o(read_valid[k*Units +: Units]), .read_ready_i(read_ready[k*Units +: Units]),
      .read_address_o(read_address[k*AlphaAddressW +: AlphaAddressW]),
      .answer_valid_i(ru_answer_valid), .answer_i(answer),
      .mem_valid_o(mem_valid[RasterPort+k]), .mem_ready_i(mem_ready[RasterPort+k]), .mem_write_o(mem_write[RasterPort+k]),
      .mem_address_o(mem_address[(RasterPort+k)*AddressW +: AddressW]),
      .mem_data_o(mem_data[(RasterPort+k)*MemoryW +: MemoryW]), .rsp_valid_i(rsp_valid[RasterPort+k]), .rsp_data_i(rsp_data),
      .done_o(done[k*Regions +: Regions]), .done_x_o(done_x[k*WindowW +: WindowW]), .done_y_o(done_y[k*WindowW +: WindowW]),
      .layer_done_o(layer_done[k]), .window_done_o(window_done[k]), .idle_o(),
      .active_o(ru_active[k]), .perf_o(perf_state[2*(1+2*Units+k) +: 2]),
      .tap_line_valid_o(ru_alphas_valid[k]), .tap_line_index_o(ru_alphas_index[k*pipegs_pkg::TapIndexW +: pipegs_pkg::TapIndexW]),
      .tap_line_region_o(ru_alphas_region[k*pipegs_pkg::RegionW +: pipegs_pkg::RegionW]),
      .tap_line_o(ru_alphas[k*LineW +: LineW]), .tap_word_valid_o(ru_pixels_valid[k]),
      .tap_word_region_o(ru_pixels_region[k*pipegs_pkg::RegionW +: pipegs_pkg::RegionW]),
      .tap_word_quarter_o(ru_pixels_quarter[k*2 +: 2]), .tap_word_o(ru_pixels[k*PixelWordW +: PixelWordW])
    );
  end

  if (pipegs_pkg::Order == 1) begin : gen_lists
    logic               lists_clk, lists_active;
    pipegs_pkg::splat_t listed;
    clock_gate u_lists_gate (.clk_i, .rst_ni, .enable_i(lists_active), .clk_o(lists_clk));
    lists u_lists (
      .clk_i(lists_clk), .rst_ni, .frame_i(frame_q), .restart_i(restart),
      .made_valid_i(made_valid), .made_ready_o(made_ready), .made_i(made), .number_i(made_number),
      .mem_valid_o(mem_valid[ListPort]), .mem_ready_i(mem_ready[ListPort]), .mem_write_o(mem_write[ListPort]),
      .mem_address_o(mem_address[ListPort*AddressW +: AddressW]), .mem_data_o(mem_data[ListPort*MemoryW +: MemoryW]),
      .rsp_valid_i(rsp_valid[ListPort]), .rsp_data_i(rsp_data),
      .splat_valid_o(splat_valid), .splat_ready_i(splat_ready), .splat_o(listed),
      .written_o(written), .busy_o(lists_busy), .active_o(lists_active)
    );
    assign splat = {Units{listed}};
  end else begin : gen_direct
    assign splat_valid = made_valid;
    assign made_ready  = splat_ready;
    assign splat       = made;
    assign written     = 1'b0;
    assign lists_busy  = 1'b0;
    logic unused_number;
    assign unused_number = &{1'b0, made_number};
  end

  pu_deal u_deal (
    .clk_i, .rst_ni, .in_valid_i(culled_valid), .in_ready_o(culled_ready), .in_i(culled),
    .out_valid_o(dealt_valid), .out_ready_i(dealt_ready), .out_o(dealt), .active_o(deal_active)
  );

  su_merge u_merge (
    .clk_i, .rst_ni, .in_valid_i(in_order_valid), .in_ready_o(in_order_ready), .in_i(in_order),
    .out_valid_o(sorted_valid), .out_ready_i(sorted_ready), .out_o(sorted), .active_o(merge_active)
  );

  ru_dispatch u_dispatch (
    .clk_i, .rst_ni, .in_valid_i(sorted_valid), .in_ready_o(sorted_ready), .in_i(sorted),
    .out_valid_o(raster_valid), .out_ready_i(raster_ready), .out_o(raster), .active_o(dispatch_active)
  );

  for (genvar i = 0; i < PerfUnits; i += 1) begin : gen_perf
    perf u_perf (
      .clk_i, .rst_ni, .restart_i(restart), .running_i(running), .state_i(perf_state[2*i +: 2]),
      .counts_o(perf_o[i*4*PerfW +: 4*PerfW])
    );
  end

  if (pipegs_pkg::Taps != 0) begin : gen_taps
    assign tap_splat_valid_o    = splat_valid & splat_ready;
    assign tap_splat_o          = splat;
    assign tap_sorted_valid_o   = sorted_valid && sorted_ready;
    assign tap_sorted_o         = sorted;
    assign tap_window_x_o       = done_x;
    assign tap_window_y_o       = done_y;
    assign tap_alphas_valid_o   = ru_alphas_valid;
    assign tap_alphas_index_o   = ru_alphas_index;
    assign tap_alphas_region_o  = ru_alphas_region;
    assign tap_alphas_o         = ru_alphas;
    assign tap_pixels_valid_o   = ru_pixels_valid;
    assign tap_pixels_region_o  = ru_pixels_region;
    assign tap_pixels_quarter_o = ru_pixels_quarter;
    assign tap_pixels_o         = ru_pixels;
    assign tap_chunk_valid_o    = chunk_valid & chunk_ready;
    assign tap_chunk_kind_o     = chunk.kind;
    assign tap_state_o          = perf_state;
    assign tap_layer_done_o     = layer_done;
    assign tap_window_done_o    = window_done;
  end else begin : gen_no_taps
    assign {tap_splat_valid_o, tap_splat_o, tap_sorted_valid_o, tap_sorted_o, tap_window_x_o, tap_window_y_o} = '0;
    assign {tap_alphas_valid_o, tap_alphas_index_o, tap_alphas_region_o, tap_alphas_o} = '0;
    assign {tap_pixels_valid_o, tap_pixels_region_o, tap_pixels_quarter_o, tap_pixels_o} = '0;
    assign {tap_chunk_valid_o, tap_chunk_kind_o, tap_state_o, tap_layer_done_o, tap_window_done_o} = '0;
    logic unused_taps;
    assign unused_taps = &{1'b0, ru_alphas_valid, ru_alphas_index, ru_alphas_region, ru_alphas, ru_pixels_valid,
                           ru_pixels_region, ru_pixels_quarter, ru_pixels};
  end

endmodule
