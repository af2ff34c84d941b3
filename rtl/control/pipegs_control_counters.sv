// SPDX-License-Identifier: Apache-2.0
// pipegs_control_counters: the performance counters as registers of 32 bits, two for each.
//
// Idea    A counter is wider than a register and goes on counting. Reading its low word keeps the high word of the same
//         moment, and the read of the high word gives what was kept: so both belong together when the low one is read
//         first. One high word is kept for all counters.
// Stream  read_i: pulse; hit and data belong to the word that is shown. Places of counters that this machine does not
//         have read 0.
// Pace    read_data_o follows read_word_i in the same cycle.
// Model   cpp_model/control/control_registers.hpp

module pipegs_control_counters #(
  localparam int unsigned WordW    = pipegs_pkg::ControlAddressW - 2,
  localparam int unsigned Counters = pipegs_pkg::ControlCounters,
  localparam int unsigned PerfW    = pipegs_pkg::PerfW
) (
  input  logic                      clk_i,
  input  logic                      rst_ni,

  input  logic                      apart_i,      // they are about to be reset: 0 is read
  input  logic [Counters*PerfW-1:0] counters_i,   // in the order of the package's table
  input  logic                      read_i,
  input  logic [WordW-1:0]          read_word_i,
  output logic                      read_hit_o,
  output logic [31:0]               read_data_o   // 0 where nothing is hit
);

  localparam logic [WordW-1:0] Begin = pipegs_pkg::ControlCountersBegin[WordW+1:2];
  localparam logic [WordW-1:0] End   = pipegs_pkg::ControlCountersEnd[WordW+1:2];
  localparam int unsigned      HighW = PerfW - 32;

  logic [PerfW-1:0]    count;  // the one whose low or high word is shown
  logic [HighW-1:0]    high_q;
  logic [Counters-1:0] hits;

  for (genvar i = 0; i < Counters; i += 1) begin : gen_hit
    assign hits[i] = read_word_i[WordW-1:1] == pipegs_pkg::ControlCounterTable[16*i+3 +: WordW-1];
  end

  always_comb begin
    count = '0;
    for (int unsigned i = 0; i < Counters; i += 1) count |= counters_i[i*PerfW +: PerfW] & {PerfW{hits[i] && !apart_i}};
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) high_q <= '0;
    else if (read_i && read_hit_o && !read_word_i[0]) high_q <= count[PerfW-1:32];
  end

  assign read_hit_o  = read_word_i >= Begin && read_word_i < End;
  assign read_data_o = !read_hit_o ? '0 : read_word_i[0] ? 32'(high_q) : count[31:0];

endmodule
