// SPDX-License-Identifier: Apache-2.0
// dopu_chunks: from cells to those of their chunks that can touch the window, in the order of the machine.
//
// Paper   Sec. 4.1 (layer by layer). None for the nearest chunk first.
// Idea    Cell by cell (dopu_descend), or, where ends are watermarks, the nearest chunk of the window first
//         (dopu_nearest), with the depth that no later one comes below.
// Stream  cells and ends in, of either set of planes; chunks and ends out. Memory: chunks (0), groups (1).
// Pace    One node test in three cycles.
// Model   cpp_model/dopu/dopu.hpp, cpp_model/dopu/nearest/dopu_nearest.hpp

module dopu_chunks #(
  localparam int unsigned AddressW = pipegs_pkg::AddressW,
  localparam int unsigned KindW    = pipegs_pkg::KindW
) (
  input  logic                                 clk_i,
  input  logic                                 rst_ni,
  input  logic                                 awake_i,    // the DOPU's clock does not stand, or would not
  input  pipegs_pkg::position_t                position_i,
  input  logic [pipegs_pkg::TestEyesW-1:0]       test_eyes_i,  // of dopu_test; one eye: 0
  input  logic [pipegs_pkg::WorldW-1:0]        near_plane_i,
  input  logic [pipegs_pkg::StepW-1:0]         lod_i,     // of the frame; 0: no proxies
  input  pipegs_pkg::span_t                    groups_i,  // the tables
  input  pipegs_pkg::span_t                    chunks_i,
  input  logic [2*5*pipegs_pkg::PlaneBits-1:0] planes_i,
  input  logic [1:0]                           set_done_i,
  input  logic [1:0]                           set_judges_i,

  input  logic                                 cell_valid_i,
  output logic                                 cell_ready_o,
  input  logic [KindW-1:0]                     cell_kind_i,
  input  logic                                 cell_set_i,
  input  pipegs_pkg::node_t                    cell_i,

  output logic [1:0]                           mem_valid_o,
  input  logic [1:0]                           mem_ready_i,
  output logic [2*AddressW-1:0]                mem_address_o,
  output logic [2*pipegs_pkg::BurstW-1:0]      mem_lines_o,  // less one
  input  logic [1:0]                           rsp_valid_i,
  input  logic [pipegs_pkg::MemoryW-1:0]       rsp_data_i,

  output logic                                 chunk_valid_o,
  input  logic                                 chunk_ready_i,
  output logic [KindW-1:0]                     chunk_kind_o,
  output logic                                 chunk_set_o,
  output pipegs_pkg::node_t                    chunk_o,
  output logic [pipegs_pkg::DepthW-1:0]        mark_o,     // of a layer's end, with watermarks

  output logic                                 group_valid_o,  // of a set on trial: a group passes, ...
  output logic [pipegs_pkg::CountW-1:0]        group_chunks_o,
  output logic [pipegs_pkg::LoadW-1:0]         group_near_o,
  output logic [pipegs_pkg::LoadW-1:0]         group_far_o,
  output logic                                 counted_o,      // ... all of them have

  output logic [1:0]                           bad_o,      // a cell, a group: see pipegs_line_reader
  output logic [2*AddressW-1:0]                bad_line_o,
  output logic                                 testing_o,
  output logic                                 waiting_o   // for memory
);

  if (pipegs_pkg::HasWatermarks) begin : gen_nearest
    dopu_nearest #(.Lines(pipegs_pkg::NodeLines)) u_nearest (
      .clk_i,
      .rst_ni,
      .awake_i,
      .position_i,
      .test_eyes_i,
      .near_plane_i,
      .lod_i,
      .groups_i,
      .chunks_i,
      .planes_i,
      .set_done_i,
      .set_judges_i,
      .cell_valid_i,
      .cell_ready_o,
      .cell_kind_i,
      .cell_set_i,
      .cell_i,
      .mem_valid_o,
      .mem_ready_i,
      .mem_address_o,
      .mem_lines_o,
      .rsp_valid_i,
      .rsp_data_i,
      .chunk_valid_o,
      .chunk_ready_i,
      .chunk_kind_o,
      .chunk_set_o,
      .chunk_o,
      .mark_o,
      .group_valid_o,
      .group_chunks_o,
      .group_near_o,
      .group_far_o,
      .counted_o,
      .bad_o,
      .bad_line_o,
      .testing_o,
      .waiting_o
    );
  end else begin : gen_layers
    dopu_descend #(.Lines(pipegs_pkg::NodeLines)) u_descend (
      .clk_i,
      .rst_ni,
      .awake_i,
      .position_i,
      .test_eyes_i,
      .near_plane_i,
      .groups_i,
      .chunks_i,
      .planes_i,
      .set_done_i,
      .cell_valid_i,
      .cell_ready_o,
      .cell_kind_i,
      .cell_set_i,
      .cell_i,
      .mem_valid_o,
      .mem_ready_i,
      .mem_address_o,
      .mem_lines_o,
      .rsp_valid_i,
      .rsp_data_i,
      .chunk_valid_o,
      .chunk_ready_i,
      .chunk_kind_o,
      .chunk_set_o,
      .chunk_o,
      .bad_o,
      .bad_line_o,
      .testing_o,
      .waiting_o
    );
    assign mark_o         = '0;
    assign group_valid_o  = 1'b0;
    assign group_chunks_o = '0;
    assign group_near_o   = '0;
    assign group_far_o    = '0;
    assign counted_o      = 1'b0;
    logic unused_fields;
    assign unused_fields  = ^set_judges_i ^ ^lod_i;
  end

endmodule
