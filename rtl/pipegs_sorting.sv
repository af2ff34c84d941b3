// SPDX-License-Identifier: Apache-2.0
// pipegs_sorting: from splats to one stream of them, nearest first: SUs and merge; with lists, the lists before them.
//
// Paper   Fig. 7 (middle), Sec. 4.2.2, Table 2.
// Idea    splats -> SU[k] -> su_merge. With lists the splats of the whole frame wait in memory between the PUs and the
//         SUs: they lie, in time, between the two halves of the machine. A clock gate per unit. Only wiring here.
// Stream  splats in, one stream per PU, each with its window's number; sorted out. What an SU has no room for and the
//         lists go to external memory.
// Model   cpp_model/su/su.hpp, cpp_model/list/list_write.hpp

module pipegs_sorting #(
  localparam int unsigned Units     = pipegs_pkg::Units,
  localparam int unsigned AddressW  = pipegs_pkg::AddressW,
  localparam int unsigned MemoryW   = pipegs_pkg::MemoryW,
  localparam int unsigned SplatBits = pipegs_pkg::SplatBits,
  localparam int unsigned NumberW   = pipegs_pkg::ListWindowW
) (
  input  logic                             clk_i,
  input  logic                             rst_ni,
  input  logic                             scan_en_i,
  input  pipegs_pkg::windows_t             windows_i,
  input  pipegs_pkg::span_t                overflow_i,  // the overflow area
  input  logic [pipegs_pkg::WorldW-1:0]    near_plane_i,
  input  logic                             restart_i,

  input  logic [Units-1:0]                 made_valid_i,  // splats as the PUs make them
  output logic [Units-1:0]                 made_ready_o,
  input  logic [Units*SplatBits-1:0]       made_i,
  input  logic [Units*NumberW-1:0]         number_i,

  output logic                             sorted_valid_o,
  input  logic                             sorted_ready_i,
  output pipegs_pkg::sorted_t              sorted_o,

  output pipegs_pkg::memory_lanes_t        sort_o,
  input  pipegs_pkg::memory_lanes_answer_t sort_i,
  output pipegs_pkg::memory_lists_t        lists_o,
  input  pipegs_pkg::memory_lists_answer_t lists_i,
  input  logic [MemoryW-1:0]               line_i,      // of the memory's answers

  output logic                             written_o,   // pulse: the lists are written
  output logic [Units-1:0]                 overflow_o,  // a line was written to external memory
  output logic                             full_o,      // no room in an area of the overflow; stays
  output logic [AddressW-1:0]              full_line_o,
  output logic                             busy_o,
  output logic [Units*2-1:0]               perf_o,
  output logic [Units-1:0]                 tap_splat_valid_o,
  output logic [Units*SplatBits-1:0]       tap_splat_o
);

  typedef struct packed {logic [Units-1:0][SplatBits-1:0] of;} splats_t;  // of each SU
  typedef struct packed {
    logic [Units:0]               is;
    logic [Units:0][AddressW-1:0] line;
  } full_t;
  logic [Units-1:0]           su_active, spilling, splat_valid, splat_ready, in_order_valid, in_order_ready;
  splats_t                    splat, in_order;
  logic                       merge_active, lists_busy;
  full_t                      full;  // of each SU, of the lists

  if (pipegs_pkg::HasLists) begin : gen_lists
    logic                lists_clk, lists_active, list_valid, list_ready, list_write, list_line;
    logic [AddressW-1:0] list_address;
    logic [pipegs_pkg::BurstW-1:0] list_lines;
    logic [MemoryW-1:0]  list_data;
    pipegs_pkg::splat_t  listed;
    assign lists_o = {list_data, list_lines, list_address, list_write, list_valid};
    assign {list_line, list_ready} = lists_i;
    pipegs_clock_gate u_lists_gate (
      .clk_i,
      .rst_ni,
      .scan_en_i,
      .enable_i(lists_active),
      .clk_o(lists_clk)
    );
    pipegs_lists u_lists (
      .clk_i(lists_clk),
      .rst_ni,
      .windows_i,
      .overflow_i,
      .restart_i,
      .made_valid_i,
      .made_ready_o,
      .made_i,
      .number_i,
      .mem_valid_o(list_valid),
      .mem_ready_i(list_ready),
      .mem_write_o(list_write),
      .mem_address_o(list_address),
      .mem_lines_o(list_lines),
      .mem_data_o(list_data),
      .rsp_valid_i(list_line),
      .rsp_data_i(line_i),
      .splat_valid_o(splat_valid),
      .splat_ready_i(splat_ready),
      .splat_room_i(splat_ready),  // an SU's ready is a register: it waits for no valid
      .splat_o(listed),
      .full_o(full.is[Units]),
      .full_line_o(full.line[Units]),
      .written_o,
      .busy_o(lists_busy),
      .active_o(lists_active)
    );
    assign splat = {Units{listed}};
  end else begin : gen_direct
    assign splat_valid     = made_valid_i;
    assign made_ready_o    = splat_ready;
    assign splat           = made_i;
    assign written_o       = 1'b0;
    assign lists_busy      = 1'b0;
    assign full.is[Units]  = 1'b0;
    assign full.line[Units]= '0;
    assign lists_o         = '0;
    logic unused_lists;
    assign unused_lists = &{1'b0, windows_i, restart_i, number_i, lists_i};
  end

  logic [pipegs_pkg::ExpW-1:0] octave;  // of the near plane: depths begin there
  if (pipegs_pkg::HasWatermarks) begin : gen_near
    logic [pipegs_pkg::ExpW-1:0]               octave_q;
    logic [$clog2(pipegs_pkg::WorldW + 1)-1:0] length;
    pipegs_bit_length #(.DataW(pipegs_pkg::WorldW)) u_near (
      .in_i(near_plane_i),
      .length_o(length)
    );
    always_ff @(posedge clk_i) octave_q <= length == '0 ? '0 : pipegs_pkg::ExpW'(length - 1'b1);
    assign octave = octave_q;
  end else begin : gen_no_near
    assign octave = '0;
    logic unused_near;
    assign unused_near = &{1'b0, near_plane_i};
  end

  for (genvar k = 0; k < Units; k += 1) begin : gen_unit
    logic su_clk;
    pipegs_clock_gate u_su_gate (
      .clk_i,
      .rst_ni,
      .scan_en_i,
      .enable_i(su_active[k]),
      .clk_o(su_clk)
    );
    pipegs_su u_su (
      .clk_i(su_clk),
      .rst_ni,
      .overflow_i,
      .unit_i(pipegs_pkg::UnitW'(k)),
      .octave_i(octave),
      .in_valid_i(splat_valid[k]),
      .in_ready_o(splat_ready[k]),
      .in_i(splat.of[k]),
      .out_valid_o(in_order_valid[k]),
      .out_ready_i(in_order_ready[k]),
      .out_o(in_order.of[k]),
      .spilling_o(spilling[k]),
      .mem_valid_o(sort_o.valid[k]),
      .mem_ready_i(sort_i.ready[k]),
      .mem_write_o(sort_o.write[k]),
      .mem_address_o(sort_o.address[k]),
      .mem_data_o(sort_o.data[k]),
      .rsp_valid_i(sort_i.line[k]),
      .rsp_data_i(line_i),
      .full_o(full.is[k]),
      .full_line_o(full.line[k]),
      .overflow_o(overflow_o[k]),
      .active_o(su_active[k]),
      .perf_o(perf_o[2*k +: 2])
    );
  end

  su_merge u_merge (
    .clk_i,
    .rst_ni,
    .in_valid_i(in_order_valid),
    .in_ready_o(in_order_ready),
    .in_i(in_order),
    .out_valid_o(sorted_valid_o),
    .out_ready_i(sorted_ready_i),
    .out_o(sorted_o),
    .active_o(merge_active)
  );

  pipegs_first_line #(.Ports(Units + 1)) u_full (
    .valid_i(full.is),
    .line_i(full.line),
    .valid_o(full_o),
    .line_o(full_line_o)
  );

  assign busy_o            = su_active != '0 || merge_active || lists_busy;
  assign tap_splat_valid_o = splat_valid & splat_ready;
  assign tap_splat_o       = splat;

  logic unused_spilling;  // simulations show it
  assign unused_spilling   = &{1'b0, spilling};

endmodule
