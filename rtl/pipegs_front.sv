// SPDX-License-Identifier: Apache-2.0
// pipegs_front: from the scene to splats: the DOPU, the PUs, and the deal between the two halves of a PU.
//
// Paper   Fig. 7 (left), Sec. 4.1, 4.2.1, Table 2.
// Idea    DOPU -> PU[k] (with pu_deal between cull and projection) -> splats. With Occlusion pipegs_open tells the DOPU
//         and the culls which regions are still open. A clock gate per unit. Only wiring here.
// Stream  restart_i with a frame_i that is constant until busy_o falls; reads and lines of alphas that found no room go
//         to external memory; splats out, one stream per PU; lines of alphas to the stores.
// Model   preprocess() in cpp_model/golden.cpp

module pipegs_front #(
  localparam int unsigned Units     = pipegs_pkg::Units,
  localparam int unsigned AddressW  = pipegs_pkg::AddressW,
  localparam int unsigned MemoryW   = pipegs_pkg::MemoryW,
  localparam int unsigned SplatBits = pipegs_pkg::SplatBits,
  localparam int unsigned NumberW   = pipegs_pkg::ListWindowW,
  localparam int unsigned LinesW    = pipegs_pkg::RegionW + 1
) (
  input  logic                             clk_i,
  input  logic                             rst_ni,
  input  logic                             scan_en_i,
  input  pipegs_pkg::frame_t               frame_i,
  input  pipegs_pkg::areas_t               areas_i,
  input  logic                             restart_i,

  output pipegs_pkg::memory_reads_t        reads_o,
  input  pipegs_pkg::memory_reads_answer_t reads_i,
  output pipegs_pkg::memory_lanes_t        spill_o,
  input  pipegs_pkg::memory_lanes_answer_t spill_i,
  input  logic [MemoryW-1:0]               line_i,     // of the memory's answers

  input  pipegs_pkg::progress_t            progress_i,
  input  logic [Units-1:0]                 line_free_i,
  input  logic                             layer_free_i,
  output pipegs_pkg::store_writes_t        store_o,

  output logic [Units-1:0]                 splat_valid_o,
  input  logic [Units-1:0]                 splat_ready_i,
  output logic [Units*SplatBits-1:0]       splat_o,
  output logic [Units*NumberW-1:0]         number_o,   // of each splat's window, with lists

  output logic [Units*LinesW-1:0]          overflow_o, // lines of alphas that go to memory from this cycle on
  output logic                             full_o,     // no room for a line of alphas; this and bad_o stay
  output logic [AddressW-1:0]              full_line_o,
  output logic                             bad_o,      // the scene names what its tables do not hold
  output logic [AddressW-1:0]              bad_line_o,
  output logic                             busy_o,
  output logic [(1+Units)*2-1:0]           perf_o,     // DOPU, PUs
  output logic [Units-1:0]                 tap_chunk_valid_o,
  output pipegs_pkg::chunk_t               tap_chunk_o
);

  localparam int unsigned VisibleBits   = pipegs_pkg::VisibleBits;
  localparam int unsigned PuFronts      = pipegs_pkg::PuFronts;

  logic                             dopu_clk, dopu_active, dopu_busy, deal_active;
  logic [Units-1:0]                 pu_active, pu_busy, chunk_valid, chunk_ready, chunk_room;
  pipegs_pkg::chunk_t               chunk;
  logic [Units-1:0]                 culled_valid, culled_ready, dealt_valid, dealt_ready, dealt_room;
  typedef struct packed {logic [Units-1:0][VisibleBits-1:0] of;} visibles_t;  // of each PU
  visibles_t                        culled;
  logic [PuFronts-1:0]              dealt_from;
  pipegs_pkg::visible_t             dealt;

  localparam int unsigned Colors = Units;      // the first port that reads colours, behind those of geometry
  localparam int unsigned Nodes  = 2 * Units;  // the DOPU's
  logic                             dopu_bad;
  logic [Units-1:0]                 pu_full, pu_bad;
  logic [AddressW-1:0]              dopu_bad_line;
  typedef struct packed {logic [Units-1:0][AddressW-1:0] full, bad;} pu_lines_t;
  pu_lines_t                        pu_lines;

  typedef struct packed {
    logic [Units-1:0][SplatBits-1:0] splat;
    logic [Units-1:0][NumberW-1:0]   number;
    logic [Units-1:0][LinesW-1:0]    overflow;
    logic [Units:0][1:0]             perf;  // DOPU, PUs
  } outs_t;
  outs_t outs;
  assign {splat_o, number_o, overflow_o, perf_o} = outs;

  assign spill_o.write = '1;

  pipegs_pkg::open_t open;
  if (pipegs_pkg::Occlusion != 0) begin : gen_open
    pipegs_open u_open (
      .clk_i,
      .rst_ni,
      .progress_i,
      .open_o(open)
    );
  end else begin : gen_no_open
    assign open = '0;
  end

  pipegs_clock_gate u_dopu_gate (
    .clk_i,
    .rst_ni,
    .scan_en_i,
    .enable_i(dopu_active),
    .clk_o(dopu_clk)
  );
  pipegs_dopu u_dopu (
    .clk_i(dopu_clk),
    .rst_ni,
    .start_i(restart_i),
    .frame_i,
    .areas_i,
    .busy_o(dopu_busy),
    .mem_valid_o(reads_o.valid[Nodes]),
    .mem_ready_i(reads_i.ready[Nodes]),
    .mem_address_o(reads_o.address[Nodes]),
    .mem_lines_o(reads_o.lines[Nodes]),
    .rsp_valid_i(reads_i.line[Nodes]),
    .rsp_data_i(line_i),
    .done_i(progress_i.done),
    .done_x_i(progress_i.x),
    .done_y_i(progress_i.y),
    .open_i(open),
    .chunk_valid_o(chunk_valid),
    .chunk_ready_i(chunk_ready),
    .chunk_room_i(chunk_room),
    .chunk_o(chunk),
    .active_o(dopu_active),
    .perf_o(outs.perf[0]),
    .bad_o(dopu_bad),
    .bad_line_o(dopu_bad_line)
  );

  for (genvar k = 0; k < Units; k += 1) begin : gen_unit
    logic pu_clk;
    assign reads_o.lines[Colors+k] = '0;  // colours come a line at a time
    pipegs_clock_gate u_pu_gate (
      .clk_i,
      .rst_ni,
      .scan_en_i,
      .enable_i(pu_active[k]),
      .clk_o(pu_clk)
    );
    pipegs_pu #(.Front(k < PuFronts)) u_pu (
      .clk_i(pu_clk),
      .rst_ni,
      .rotation_i(frame_i.camera.rotation),
      .quaternion_i(frame_i.camera.quaternion),
      .lens_i(frame_i.lens),
      .tables_i(frame_i.tables),
      .areas_i,
      .windows_i(frame_i.raster.windows),
      .open_i(open),
      .unit_i(pipegs_pkg::UnitW'(k)),
      .restart_i,
      .chunk_valid_i(chunk_valid[k]),
      .chunk_ready_o(chunk_ready[k]),
      .chunk_room_o(chunk_room[k]),
      .chunk_i(chunk),
      .culled_valid_o(culled_valid[k]),
      .culled_ready_i(culled_ready[k]),
      .culled_o(culled.of[k]),
      .visible_valid_i(dealt_valid[k]),
      .visible_ready_o(dealt_ready[k]),
      .visible_room_o(dealt_room[k]),
      .visible_i(dealt),
      .done_i(progress_i.done),
      .done_x_i(progress_i.x),
      .done_y_i(progress_i.y),
      .line_free_i(line_free_i[k]),
      .layer_free_i,
      .geometry_valid_o(reads_o.valid[k]),
      .geometry_ready_i(reads_i.ready[k]),
      .geometry_address_o(reads_o.address[k]),
      .geometry_lines_o(reads_o.lines[k]),
      .geometry_rsp_valid_i(reads_i.line[k]),
      .color_valid_o(reads_o.valid[Colors+k]),
      .color_ready_i(reads_i.ready[Colors+k]),
      .color_address_o(reads_o.address[Colors+k]),
      .color_halves_o(reads_o.halves[k]),
      .color_rsp_valid_i(reads_i.line[Colors+k]),
      .rsp_data_i(line_i),
      .spill_valid_o(spill_o.valid[k]),
      .spill_ready_i(spill_i.ready[k]),
      .spill_address_o(spill_o.address[k]),
      .spill_data_o(spill_o.data[k]),
      .store_write_o(store_o.write[k]),
      .store_address_o(store_o.address[k]),
      .store_line_o(store_o.line[k]),
      .splat_valid_o(splat_valid_o[k]),
      .splat_ready_i(splat_ready_i[k]),
      .splat_o(outs.splat[k]),
      .number_o(outs.number[k]),
      .overflowed_o(outs.overflow[k]),
      .full_o(pu_full[k]),
      .full_line_o(pu_lines.full[k]),
      .bad_o(pu_bad[k]),
      .bad_line_o(pu_lines.bad[k]),
      .busy_o(pu_busy[k]),
      .active_o(pu_active[k]),
      .perf_o(outs.perf[1+k])
    );
  end

  pu_deal u_deal (
    .clk_i,
    .rst_ni,
    .in_valid_i(culled_valid[PuFronts-1:0]),
    .in_ready_o(dealt_from),
    .in_i((PuFronts*VisibleBits)'(culled)),
    .out_valid_o(dealt_valid),
    .out_ready_i(dealt_ready),
    .out_room_i(dealt_room),
    .out_o(dealt),
    .active_o(deal_active)
  );

  pipegs_first_line #(.Ports(Units)) u_full (
    .valid_i(pu_full),
    .line_i(pu_lines.full),
    .valid_o(full_o),
    .line_o(full_line_o)
  );
  pipegs_first_line #(.Ports(1 + Units)) u_bad (
    .valid_i({pu_bad, dopu_bad}),
    .line_i({pu_lines.bad, dopu_bad_line}),
    .valid_o(bad_o),
    .line_o(bad_line_o)
  );

  assign busy_o            = dopu_busy || pu_busy != '0 || deal_active;
  assign tap_chunk_valid_o = chunk_valid & chunk_ready;
  assign tap_chunk_o       = chunk;

  assign culled_ready = Units'(dealt_from);

  logic unused;  // writes get no answer; PUs without a front give nothing
  assign unused = &{1'b0, spill_i.line, culled_valid, culled};

endmodule
