// SPDX-License-Identifier: Apache-2.0
// pu_fetch: reads the Gaussians of each chunk from external memory and lays the chunk's header beside each of them.
//
// Paper   Sec. 4.2, Fig. 7: the double buffer for Gaussian parameters before the PU.
// Idea    A chunk's geometry is a run of lines. pipegs_line_reader asks for the lines of the next chunks while the
//         present one is sent, so the latency of the memory is hidden behind Lines lines of prefetch.
// Stream  chunk: one beat per chunk, or an end beat. fetched: one beat per Gaussian, or the end beat in its turn; a
//         coded_t, for pu_decode, if Coded.
// Pace    One Gaussian per cycle while the memory delivers.
// Model   None: a queue in verif/pu/pu_fetch_test.cpp.

module pu_fetch #(
  parameter int unsigned Lines = pipegs_pkg::GeometryLines,
  localparam int unsigned OutW = pipegs_pkg::Coded ? pipegs_pkg::CodedBits : pipegs_pkg::FetchedBits
) (
  input  logic                            clk_i,
  input  logic                            rst_ni,

  input  pipegs_pkg::span_t               gaussians_i,  // the geometry

  input  logic                            chunk_valid_i,
  output logic                            chunk_ready_o,
  input  pipegs_pkg::chunk_t              chunk_i,

  output logic                            mem_valid_o,
  input  logic                            mem_ready_i,
  output logic [pipegs_pkg::AddressW-1:0] mem_address_o,
  output logic [pipegs_pkg::BurstW-1:0]   mem_lines_o,  // less one
  input  logic                            rsp_valid_i,
  input  logic [pipegs_pkg::MemoryW-1:0]  rsp_data_i,

  output logic                            fetched_valid_o,
  input  logic                            fetched_ready_i,
  output logic [OutW-1:0]                 fetched_o,

  output logic                            bad_o,             // a chunk of Gaussians that are not there
  output logic [pipegs_pkg::AddressW-1:0] bad_line_o,
  output logic                            waiting_memory_o,  // the next Gaussian waits for the memory
  output logic                            idle_o             // holds no chunk
);

  // The header travels beside the job; slot and count are the job itself; pipegs_pu keeps the watermark.
  localparam int unsigned HeaderW = pipegs_pkg::ChunkBits - pipegs_pkg::SlotW - pipegs_pkg::CountW - pipegs_pkg::MarkW;

  logic [HeaderW-1:0]                  header;
  logic [pipegs_pkg::ChunkBits-1:0]    chunk;
  localparam int unsigned ItemW = pipegs_pkg::Coded ? pipegs_pkg::GaussianCodeBits : pipegs_pkg::GaussianRecordBits;
  logic [ItemW-1:0]                    item;
  logic [pipegs_pkg::SlotW-1:0]        slot;
  logic                                is_data, last;

  assign chunk = chunk_i;  // the header lies lowest, as in what was fetched

  pipegs_line_reader #(
    .TagW(HeaderW),
    .ItemW(ItemW),
    .ItemsPerLine(pipegs_pkg::GaussiansPerLine),
    .Lines(Lines),
    .Jobs(pipegs_pkg::GeometryJobs)
  ) u_reader (
    .clk_i,
    .rst_ni,
    .table_i(gaussians_i),
    .job_valid_i(chunk_valid_i),
    .job_ready_o(chunk_ready_o),
    .job_read_i(chunk_i.kind == pipegs_pkg::KindData),
    .job_first_i(chunk_i.slot),
    .job_count_i(chunk_i.count),
    .job_tag_i(chunk[HeaderW-1:0]),
    .mem_valid_o,
    .mem_ready_i,
    .mem_address_o,
    .mem_lines_o,
    .rsp_valid_i,
    .rsp_data_i,
    .out_valid_o(fetched_valid_o),
    .out_ready_i(fetched_ready_i),
    .out_read_o(is_data),
    .out_index_o(slot),
    .out_last_o(last),
    .out_tag_o(header),
    .out_item_o(item),
    .bad_o,
    .bad_line_o,
    .waiting_o(waiting_memory_o),
    .idle_o
  );

  logic unused;
  assign unused = ^{chunk, last};

  // Fields of a Gaussian stand in the order of the beat; an end beat carries zeros.
  assign fetched_o = {{pipegs_pkg::SlotW{is_data}} & slot, {ItemW{is_data}} & item, header};

endmodule
