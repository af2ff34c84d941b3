// SPDX-License-Identifier: Apache-2.0
// pipegs_memory_ports: which part of the machine asks at which port of pipegs_memory_arbiter.
//
// Idea    Ports that may write come first: alphas of each PU, then the SUs, the RUs, the lists; behind them those that
//         only read. The number of a port is the tag of its requests. Geometry, the DOPU and the lists may ask
//         for several lines at once, the others ask for one. Only wiring here.
// Stream  one bundle of requests and one of answers per part; the line of an answer goes to all.
// Pace    pipegs_memory_arbiter's.
// Model   sim/memory/external_memory.hpp applies requests in the order in which this port shows them.

module pipegs_memory_ports #(
  localparam int unsigned MemoryW    = pipegs_pkg::MemoryW,
  localparam int unsigned AddressW   = pipegs_pkg::AddressW,
  localparam int unsigned BurstW     = pipegs_pkg::BurstW,
  localparam int unsigned Ports      = pipegs_pkg::MemoryPorts,
  localparam int unsigned WritePorts = pipegs_pkg::WritePorts,
  localparam int unsigned Units      = pipegs_pkg::Units,
  localparam int unsigned HalvesW    = pipegs_pkg::HalvesW
) (
  input  logic                             clk_i,
  input  logic                             rst_ni,

  input  pipegs_pkg::memory_lanes_t        spill_i,
  output pipegs_pkg::memory_lanes_answer_t spill_o,
  input  pipegs_pkg::memory_lanes_t        sort_i,
  output pipegs_pkg::memory_lanes_answer_t sort_o,
  input  pipegs_pkg::memory_lanes_t        raster_i,
  input  logic [Units*pipegs_pkg::HalvesW-1:0] halves_i,  // of these lines what a write changes; of others all, but of
                                                          // colours what reads_i says
  output pipegs_pkg::memory_lanes_answer_t raster_o,
  input  pipegs_pkg::memory_lists_t        lists_i,
  output pipegs_pkg::memory_lists_answer_t lists_o,
  input  pipegs_pkg::memory_reads_t        reads_i,
  output pipegs_pkg::memory_reads_answer_t reads_o,
  input  logic                             stop_i,     // no request is taken any more
  output logic [MemoryW-1:0]               line_o,
  output logic                             storing_o,  // a line of pixels waits
  output logic                             busy_o,     // any request waits

  output logic                             mem_valid_o,
  input  logic                             mem_ready_i,
  output pipegs_pkg::memory_request_t      mem_request_o,
  output logic [MemoryW-1:0]               mem_data_o,
  input  logic                             mem_rsp_valid_i,
  input  logic [pipegs_pkg::TagW-1:0]      mem_rsp_tag_i,
  input  logic [MemoryW-1:0]               mem_rsp_data_i
);

  logic [Ports-1:0]              valid, ready, line;
  logic [WritePorts-1:0]         write;
  logic [Ports*AddressW-1:0]     address;
  logic [Ports*BurstW-1:0]       lines;
  logic [WritePorts*MemoryW-1:0] data;
  logic [Ports*HalvesW-1:0]      halves;

  always_comb begin
    halves = '1;
    halves[2*Units*HalvesW +: Units*HalvesW] = halves_i;
    halves[(WritePorts+Units)*HalvesW +: Units*HalvesW] = reads_i.halves;
  end

  if (pipegs_pkg::HasLists) begin : gen_lists
    assign valid   = {reads_i.valid, lists_i.valid, raster_i.valid, sort_i.valid, spill_i.valid};
    assign write   = {lists_i.write, raster_i.write, sort_i.write, spill_i.write};
    assign address = {reads_i.address, lists_i.address, raster_i.address, sort_i.address, spill_i.address};
    assign lines   = {reads_i.lines, lists_i.lines, (3*Units*BurstW)'(0)};
    assign data    = {lists_i.data, raster_i.data, sort_i.data, spill_i.data};
    assign {reads_o.ready, lists_o.ready, raster_o.ready, sort_o.ready, spill_o.ready} = ready;
    assign {reads_o.line, lists_o.line, raster_o.line, sort_o.line, spill_o.line} = line;
  end else begin : gen_no_lists
    assign valid   = {reads_i.valid, raster_i.valid, sort_i.valid, spill_i.valid};
    assign write   = {raster_i.write, sort_i.write, spill_i.write};
    assign address = {reads_i.address, raster_i.address, sort_i.address, spill_i.address};
    assign lines   = {reads_i.lines, (3*Units*BurstW)'(0)};
    assign data    = {raster_i.data, sort_i.data, spill_i.data};
    assign {reads_o.ready, raster_o.ready, sort_o.ready, spill_o.ready} = ready;
    assign {reads_o.line, raster_o.line, sort_o.line, spill_o.line} = line;
    assign lists_o = '0;
    logic unused_lists;
    assign unused_lists = ^lists_i;
  end

  pipegs_memory_arbiter u_arbiter (
    .clk_i,
    .rst_ni,
    .valid_i(valid),
    .ready_o(ready),
    .write_i(write),
    .address_i(address),
    .halves_i(halves),
    .lines_i(lines),
    .data_i(data),
    .stop_i,
    .rsp_valid_o(line),
    .rsp_data_o(line_o),
    .mem_valid_o,
    .mem_ready_i,
    .mem_request_o,
    .mem_data_o,
    .mem_rsp_valid_i,
    .mem_rsp_tag_i,
    .mem_rsp_data_i
  );

  assign busy_o    = valid != '0 || mem_valid_o;
  assign storing_o = (raster_i.valid & raster_i.write) != '0 ||
                     (mem_valid_o && mem_request_o.write && mem_request_o.tag >= pipegs_pkg::TagW'(2 * Units) &&
                      mem_request_o.tag < pipegs_pkg::TagW'(3 * Units));

`ifndef SYNTHESIS
  pipegs_stream_check #(.Ports(Ports), .DataW(AddressW)) u_check_port (
    .clk_i,
    .rst_ni,
    .valid_i(valid),
    .ready_i(ready),
    .beat_i(address)
  );
`endif

endmodule
