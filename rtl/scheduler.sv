// SPDX-License-Identifier: Apache-2.0
// scheduler: starts a frame, knows when it is over, and counts its cycles.
//
// Paper   Sec. 4.1 (inter-layer pipeline): the overlap itself needs no control, it follows from the streams; only the
//         frame's begin and end are decided here.
// Idea    start -> restart pulse -> running until the RUs have completed all windows and nothing is left anywhere.
// Stream  start_i: pulse. busy_o: from the cycle after start until the last pixel is in memory. window_done_i: one
//         pulse per RU and window.
// Pace    Registered; ends two cycles after the last write was accepted.
// Model   None: the harness checks that all pixels have come.

module scheduler (
  input  logic                         clk_i,
  input  logic                         rst_ni,

  input  logic                         start_i,
  input  pipegs_pkg::windows_t         windows_i,
  input  logic [pipegs_pkg::Units-1:0] window_done_i,
  input  logic                         idle_i,          // all units and queues are empty, all writes accepted
  input  logic [pipegs_pkg::Units-1:0] overflow_sort_i,
  input  logic [pipegs_pkg::Units*(pipegs_pkg::RegionW+1)-1:0] overflow_alpha_i,

  input  logic                         written_i,       // with lists: the last one is written (else never)

  output logic                         restart_o,
  output logic                         busy_o,
  output logic [pipegs_pkg::PerfW-1:0] cycles_o,
  output logic [pipegs_pkg::PerfW-1:0] preprocess_cycles_o,  // of cycles_o, those before written_i
  output logic [pipegs_pkg::PerfW-1:0] overflow_lines_o
);

  localparam int unsigned Units   = pipegs_pkg::Units;
  localparam int unsigned WindowW = pipegs_pkg::WindowW;
  localparam int unsigned CountW  = 2 * WindowW + 2;
  localparam int unsigned LinesW  = pipegs_pkg::RegionW + 1;
  localparam int unsigned PerfW   = pipegs_pkg::PerfW;
  localparam int unsigned NowW    = LinesW + $clog2(Units + 1);  // lines of one cycle

  logic [CountW-1:0] left_q [Units];  // windows that each RU has still to complete
  logic [Units-1:0]  complete;
  logic              restart_q, busy_q;
  logic [PerfW-1:0]  cycles_q, preprocess_q, overflow_q;
  logic [NowW-1:0]   overflow_now, overflow_now_q;
  logic [WindowW:0]   columns, rows;  // up to 2^WindowW

  assign columns = (WindowW+1)'(windows_i.last_x - windows_i.first_x) + 1'b1;
  assign rows    = (WindowW+1)'(windows_i.last_y - windows_i.first_y) + 1'b1;

  always_comb begin
    for (int unsigned i = 0; i < Units; i += 1) complete[i] = left_q[i] == '0;
    overflow_now = '0;
    for (int unsigned i = 0; i < Units; i += 1) begin
      overflow_now = overflow_now + NowW'(overflow_sort_i[i]) + NowW'(overflow_alpha_i[i*LinesW +: LinesW]);
    end
  end

  assign restart_o        = restart_q;
  assign busy_o           = busy_q;
  assign cycles_o         = cycles_q;
  assign preprocess_cycles_o = preprocess_q;
  assign overflow_lines_o = overflow_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      restart_q  <= 1'b0;
      busy_q     <= 1'b0;
      cycles_q     <= '0;
      preprocess_q <= '0;
      overflow_q   <= '0;
      overflow_now_q <= '0;
      for (int unsigned i = 0; i < Units; i += 1) left_q[i] <= '0;
    end else begin
      restart_q <= start_i && !busy_q;
      overflow_now_q <= busy_q ? overflow_now : '0;
      overflow_q     <= overflow_q + PerfW'(overflow_now_q);
      if (start_i && !busy_q) begin
        busy_q     <= 1'b1;
        cycles_q     <= '0;
        preprocess_q <= '0;
        overflow_q   <= '0;
        for (int unsigned i = 0; i < Units; i += 1) left_q[i] <= CountW'(columns) * CountW'(rows);
      end else begin
        // The restart cycle itself belongs to no unit: counting starts behind it, as in perf.
        if (busy_q && !restart_q) cycles_q <= cycles_q + 1'b1;
        if (busy_q && written_i) preprocess_q <= cycles_q;
        if (busy_q && !restart_q && complete == '1 && idle_i) busy_q <= 1'b0;
        for (int unsigned i = 0; i < Units; i += 1) if (window_done_i[i]) left_q[i] <= left_q[i] - 1'b1;
      end
    end
  end

endmodule
