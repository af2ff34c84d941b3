// SPDX-License-Identifier: Apache-2.0
// ru_source: a splat's lines of alphas, region by region, in the order of blending.
//
// Paper   Fig. 7 (alpha buffers -> RU).
// Idea    Where PUs compute alphas: ru_walk -> ru_fetch, from the alpha stores or external memory. Where coefficients
//         are cached: Row Units here (ru_rows).
// Stream  in: sorted splats and ends. out: what the lanes blend, each with its line.
// Pace    One region in four cycles.
// Model   cpp_model/ru/ru_walk.hpp, cpp_model/pu/rows/pu_rows.hpp

module ru_source #(
  localparam int unsigned Units    = pipegs_pkg::Units,
  localparam int unsigned LineW    = pipegs_pkg::LineW,
  localparam int unsigned Regions  = pipegs_pkg::Regions,
  localparam int unsigned AddressW = pipegs_pkg::AddressW
) (
  input  logic                                 clk_i,
  input  logic                                 rst_ni,
  input  pipegs_pkg::span_t                  overflow_i,  // the overflow area
  input  logic [pipegs_pkg::UnitW-1:0]         unit_i,
  input  logic [Regions-1:0]                   done_i,         // of the window that the lanes are in
  input  logic                                 window_done_i,

  input  logic                                 in_valid_i,
  output logic                                 in_ready_o,
  input  pipegs_pkg::sorted_t                  in_i,

  output logic [Units-1:0]                     read_valid_o,   // to the alpha store of each unit
  input  logic [Units-1:0]                     read_ready_i,
  output logic [pipegs_pkg::AlphaAddressW-1:0] read_address_o,
  output logic                                 read_skip_o,    // the line is freed, not read
  input  logic [Units-1:0]                     answer_valid_i,
  input  logic [Units*LineW-1:0]               answer_i,

  output logic                                 mem_valid_o,    // lines that found no room there
  input  logic                                 mem_ready_i,
  output logic [AddressW-1:0]                  mem_address_o,
  input  logic                                 rsp_valid_i,
  input  logic [pipegs_pkg::MemoryW-1:0]       rsp_data_i,

  output logic                                 out_valid_o,
  input  logic                                 out_ready_i,
  output pipegs_pkg::blend_t                   out_o,
  output logic [LineW-1:0]                     out_line_o,

  output logic                                 memory_o,       // the next line comes from memory
  output logic                                 waits_o,        // for an alpha store
  output logic                                 idle_o
);

  if (pipegs_pkg::CachesAlphas) begin : gen_cached
    logic               fetch_valid, fetch_ready, walk_idle, fetch_idle;
    pipegs_pkg::fetch_t fetch;

    ru_walk #(.EndsMax(pipegs_pkg::FetchLines + 16)) u_walk (
      .clk_i,
      .rst_ni,
      .unit_i,
      .done_i,
      .window_done_i,
      .in_valid_i,
      .in_ready_o,
      .in_i,
      .out_valid_o(fetch_valid),
      .out_ready_i(fetch_ready),
      .out_o(fetch),
      .idle_o(walk_idle)
    );

    ru_fetch u_fetch (
      .clk_i,
      .rst_ni,
      .overflow_i,
      .in_valid_i(fetch_valid),
      .in_ready_o(fetch_ready),
      .in_i(fetch),
      .read_valid_o,
      .read_ready_i,
      .read_address_o,
      .read_skip_o,
      .answer_valid_i,
      .answer_i,
      .mem_valid_o,
      .mem_ready_i,
      .mem_address_o,
      .rsp_valid_i,
      .rsp_data_i,
      .out_valid_o,
      .out_ready_i,
      .out_o,
      .out_line_o,
      .memory_o,
      .idle_o(fetch_idle)
    );
    assign idle_o  = walk_idle && fetch_idle;
    assign waits_o = fetch_valid;
  end else begin : gen_late
    ru_rows u_rows (
      .clk_i,
      .rst_ni,
      .unit_i,
      .done_i,
      .window_done_i,
      .in_valid_i,
      .in_ready_o,
      .in_i,
      .out_valid_o,
      .out_ready_i,
      .out_o,
      .out_line_o,
      .idle_o
    );
    assign {read_valid_o, read_address_o, read_skip_o, mem_valid_o, mem_address_o, memory_o, waits_o} = '0;
    logic unused_memory;
    assign unused_memory = &{1'b0, overflow_i, read_ready_i, answer_valid_i, answer_i, mem_ready_i,
                             rsp_valid_i, rsp_data_i};
  end

endmodule
