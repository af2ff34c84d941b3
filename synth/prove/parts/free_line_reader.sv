// SPDX-License-Identifier: Apache-2.0
// free_line_reader: stands for rtl/lib/pipegs_line_reader.sv in proofs of its users: any item at any time.
//
// Idea    Of the real one the proof `line_reader` says: what is shown stays until taken, at both ports; idle says
//         whether a job is inside. Nothing else is known here, so jobs are taken and items shown as the solver likes.

module pipegs_line_reader #(
  parameter int unsigned TagW = 8,
  parameter int unsigned ItemW = 256,
  parameter int unsigned ItemsPerLine = 2,
  parameter int unsigned Lines = 32,
  parameter int unsigned Jobs = 4,
  parameter int unsigned IndexW = pipegs_pkg::SlotW,
  parameter int unsigned CountW = pipegs_pkg::CountW
) (
  input  logic                              clk_i,
  input  logic                              rst_ni,

  input  pipegs_pkg::span_t                 table_i,

  input  logic                              job_valid_i,
  output logic                              job_ready_o,
  input  logic                              job_read_i,
  input  logic [IndexW-1:0]                 job_first_i,
  input  logic [CountW-1:0]                 job_count_i,
  input  logic [TagW-1:0]                   job_tag_i,

  output logic                              mem_valid_o,
  input  logic                              mem_ready_i,
  output logic [pipegs_pkg::AddressW-1:0]   mem_address_o,
  output logic [pipegs_pkg::BurstW-1:0]     mem_lines_o,
  input  logic                              rsp_valid_i,
  input  logic [pipegs_pkg::MemoryW-1:0]    rsp_data_i,

  output logic                              out_valid_o,
  input  logic                              out_ready_i,
  output logic                              out_read_o,
  output logic [IndexW-1:0]                 out_index_o,
  output logic                              out_last_o,
  output logic [TagW-1:0]                   out_tag_o,
  output logic [ItemW-1:0]                  out_item_o,

  output logic                              bad_o,
  output logic [pipegs_pkg::AddressW-1:0]   bad_line_o,
  output logic                              waiting_o,
  output logic                              idle_o
);

  (* anyseq *) logic [pipegs_pkg::AddressW-1:0] address, bad_line;
  (* anyseq *) logic [pipegs_pkg::BurstW-1:0] lines;
  (* anyseq *) logic [IndexW-1:0] index;
  (* anyseq *) logic [TagW-1:0]   tag;
  (* anyseq *) logic [ItemW-1:0]  item;
  (* anyseq *) logic ready, asks, valid, read, last, waiting, idle, bad;

  assign job_ready_o   = ready;
  assign mem_valid_o   = asks;
  assign mem_address_o = address;
  assign mem_lines_o   = lines;
  assign out_valid_o   = valid;
  assign out_read_o    = read;
  assign out_index_o   = index;
  assign out_last_o    = last;
  assign out_tag_o     = tag;
  assign out_item_o    = item;
  assign bad_o         = bad;
  assign bad_line_o    = bad_line;
  assign waiting_o     = waiting;
  assign idle_o        = idle;

  always_comb assume (!rst_ni || !valid || !idle);
  proof_hold #(.DataW(pipegs_pkg::AddressW + pipegs_pkg::BurstW), .Assumed(1'b1)) u_hold_mem (
    .clk_i, .rst_ni, .valid_i(mem_valid_o), .ready_i(mem_ready_i), .beat_i({mem_address_o, mem_lines_o})
  );
  proof_hold #(.DataW(2 + IndexW + TagW + ItemW), .Assumed(1'b1)) u_hold_out (
    .clk_i, .rst_ni, .valid_i(out_valid_o), .ready_i(out_ready_i),
    .beat_i({out_read_o, out_index_o, out_last_o, out_tag_o, out_item_o})
  );

  logic unused;
  assign unused =
      &{1'b0, table_i, job_valid_i, job_read_i, job_first_i, job_count_i, job_tag_i, rsp_valid_i, rsp_data_i};

endmodule
