// SPDX-License-Identifier: Apache-2.0
// su_lines: packs sorted keys into the lines of a run in external memory.
//
// Idea    SuRunKeys keys to a line, each with the number of its record. A run begins on a line of its own and directly
//         behind the one before it; the rest of its last line means nothing.
// Stream  begin_i with the number of keys of a run (not 0), then these keys, nearest first; line: lines to write.
//         restart_i: the next run begins at line 0.
// Pace    One key per cycle while the lines are taken as they fill.
// Model   std::sort in the test of su_external.

module su_lines (
  input  logic                           clk_i,
  input  logic                           rst_ni,
  input  logic                           restart_i,
  input  logic                           begin_i,
  input  logic [pipegs_pkg::SlotW-1:0]   count_i,

  input  logic                           key_valid_i,
  output logic                           key_ready_o,
  input  logic [pipegs_pkg::KeyW-1:0]    key_i,
  input  logic [pipegs_pkg::SlotW-1:0]   number_i,

  output logic                           line_valid_o,
  input  logic                           line_ready_i,
  output logic [pipegs_pkg::SlotW-1:0]   line_number_o,  // also of the line that comes next
  output logic [pipegs_pkg::MemoryW-1:0] line_o,

  output logic                           idle_o,    // the run is in memory
  output logic                           active_o
);

  localparam int unsigned SlotW = pipegs_pkg::SlotW;
  localparam int unsigned EntryW = pipegs_pkg::KeyW + SlotW;
  localparam int unsigned RunKeys = pipegs_pkg::SuRunKeys;
  localparam int unsigned PlaceW = 3;

  logic [SlotW-1:0]          left_q, number_q;  // keys of the run that are still to come; the line's number
  logic [PlaceW-1:0]         place_q;
  typedef struct packed {logic [RunKeys-1:0][EntryW-1:0] of;} entries_t;
  entries_t line_q;
  logic                      full_q, take;

  assign key_ready_o   = !full_q;
  assign take          = key_valid_i && !full_q;
  assign line_valid_o  = full_q;
  assign line_number_o = number_q;
  assign line_o        = pipegs_pkg::MemoryW'(line_q);
  assign idle_o        = left_q == '0 && !full_q;
  assign active_o      = restart_i || begin_i || take || line_ready_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      left_q  <= '0;
      full_q  <= 1'b0;
      place_q <= '0;
    end else begin
      if (line_ready_i) full_q <= 1'b0;
      if (take) begin
        left_q  <= left_q - 1'b1;
        place_q <= place_q + 1'b1;
        if (place_q == PlaceW'(RunKeys - 1) || left_q == SlotW'(1)) begin
          full_q  <= 1'b1;
          place_q <= '0;
        end
      end
      if (begin_i) left_q <= count_i;
    end
  end

  always_ff @(posedge clk_i) begin
    if (restart_i) number_q <= '0;
    else if (line_ready_i) number_q <= number_q + 1'b1;
    if (take) line_q.of[place_q] <= {number_i, key_i};
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!begin_i || (idle_o && count_i != '0));
  always_ff @(posedge clk_i) if (rst_ni) assert (!restart_i || idle_o);
  always_ff @(posedge clk_i) if (rst_ni) assert (!take || left_q != '0);
  always_ff @(posedge clk_i) if (rst_ni) assert (!line_ready_i || full_q);
  pipegs_stream_check #(.DataW($bits({line_number_o, line_o}))) u_check_line (
    .clk_i,
    .rst_ni,
    .valid_i(line_valid_o),
    .ready_i(line_ready_i),
    .beat_i({line_number_o, line_o})
  );
`endif

endmodule
