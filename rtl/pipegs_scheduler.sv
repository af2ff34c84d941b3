// SPDX-License-Identifier: Apache-2.0
// pipegs_scheduler: takes frames, hands each from front to back of the machine, knows when it is over, counts cycles.
//
// Paper   Sec. 4.1 (inter-layer pipeline): the overlap of layers needs no control, it follows from the streams; only
//         where a frame begins and ends is decided here.
// Idea    The front (DOPU, PUs) works on one frame, the back (RUs) on the same one or on the one before: when the front
//         has nothing left it takes the next frame, and the back lets no splat of it in (hold_o) before all pixels of
//         its own are in memory. Machines with lists or alpha stores, and a frame that sorts otherwise (same_i 0), wait
//         until all is idle. The RUs' feedback counts only while both work on one frame (listen_o).
// Stream  frame_valid_i with the next frame, taken with frame_ready_o. front_restart_o, back_restart_o: pulses, their
//         frame lies in the registers of pipegs_top. done_o: pulse, a frame's last pixel was accepted. busy_o: a frame
//         is inside. Counters: since the machine was last empty.
// Pace    Registered. The back begins one cycle after the front.
// Model   None: the harness checks that all pixels have come.

module pipegs_scheduler #(
  localparam int unsigned Units   = pipegs_pkg::Units,
  localparam int unsigned WindowW = pipegs_pkg::WindowW,
  localparam int unsigned PerfW   = pipegs_pkg::PerfW,
  localparam int unsigned LinesW  = pipegs_pkg::RegionW + 1
) (
  input  logic                    clk_i,
  input  logic                    rst_ni,

  input  logic                    frame_valid_i,
  output logic                    frame_ready_o,
  input  logic                    same_i,            // the frame offered sorts as the one in the front does
  input  pipegs_pkg::windows_t    windows_i,         // of the frame in the front

  input  logic                    front_busy_i,
  input  logic                    back_busy_i,
  input  logic                    storing_i,         // a line of pixels waits for external memory
  input  logic                    idle_i,            // all units and queues are empty, all requests accepted
  input  logic                    end_i,             // pulse: the end of a window goes into the back
  input  logic [Units-1:0]        window_done_i,     // pulse: an RU has completed a window
  input  logic                    written_i,         // with lists: the last one is written (else never)
  input  logic [Units-1:0]        overflow_sort_i,   // a line went to external memory
  input  logic [Units*LinesW-1:0] overflow_alpha_i,  // so many lines did

  output logic                    front_take_o,      // the frame offered becomes the front's with this cycle's end
  output logic                    front_restart_o,
  output logic                    back_take_o,       // the front's frame becomes the back's, too
  output logic                    back_restart_o,
  output logic                    hold_o,            // no splat may go into the back
  output logic                    listen_o,
  output logic                    begin_o,           // pulse: counters restart
  output logic                    done_o,
  output logic                    busy_o,
  output logic [PerfW-1:0]        cycles_o,
  output logic [PerfW-1:0]        preprocess_cycles_o,  // of cycles_o, those before written_i
  output logic [PerfW-1:0]        overflow_lines_o
);

  localparam int unsigned CountW = 2 * WindowW + 2;
  localparam int unsigned NowW   = LinesW + $clog2(Units + 1);  // lines of one cycle
  localparam bit Overlaps = !pipegs_pkg::HasLists && !pipegs_pkg::HasStores;

  // --- where frames are ---------------------------------------------------------------------------------------------
  logic       front_q, ahead_q, back_q;  // the front works; its frame is not the back's yet; the back works
  logic       front_restart_q, back_restart_q, begin_q, done_q;
  logic       idle_q;                    // of the cycle before: nothing comes in while no frame is taken
  logic [1:0] settled_q;                 // what the RUs tell is of their new frame
  logic       finish;

  assign frame_ready_o = !front_q && !ahead_q && ((!back_q && idle_q) || (Overlaps && same_i));
  assign front_take_o  = frame_valid_i && frame_ready_o;
  assign back_take_o   = ahead_q && !back_q;
  assign busy_o        = front_q || ahead_q || back_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      {front_q, ahead_q, back_q}                         <= '0;
      {front_restart_q, back_restart_q, begin_q, done_q} <= '0;
      settled_q                                          <= '1;
      idle_q                                             <= 1'b1;  // what the reset leaves is empty
    end else begin
      idle_q          <= idle_i;
      front_restart_q <= front_take_o;
      back_restart_q  <= back_take_o;
      begin_q         <= front_take_o && !busy_o;
      done_q          <= finish;
      settled_q       <= back_restart_q ? '0 : {settled_q[0], 1'b1};
      if (front_take_o) front_q <= 1'b1;
      else if (!front_restart_q && !front_busy_i) front_q <= 1'b0;
      if (front_take_o) ahead_q <= 1'b1;
      else if (back_take_o) ahead_q <= 1'b0;
      if (back_take_o) back_q <= 1'b1;
      else if (finish) back_q <= 1'b0;
    end
  end

  assign front_restart_o = front_restart_q;
  assign back_restart_o  = back_restart_q;
  assign begin_o         = begin_q;
  assign done_o          = done_q;
  assign listen_o        = !ahead_q && !back_restart_q && settled_q == '1;

  // --- windows of the back's frame ----------------------------------------------------------------------------------
  logic [WindowW:0]  columns, rows;  // up to 2^WindowW
  logic [CountW-1:0] windows, enter_q;
  logic [CountW-1:0] left_q [Units];  // that each RU has still to complete
  logic [Units-1:0]  complete;

  assign columns = (WindowW+1)'(windows_i.last_x - windows_i.first_x) + 1'b1;
  assign rows    = (WindowW+1)'(windows_i.last_y - windows_i.first_y) + 1'b1;
  assign windows = CountW'(columns) * CountW'(rows);
  assign hold_o  = enter_q == '0;
  assign finish  = back_q && !back_restart_q && complete == '1 && !back_busy_i && !storing_i;
  always_comb for (int unsigned i = 0; i < Units; i += 1) complete[i] = left_q[i] == '0;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      enter_q <= '0;
      for (int unsigned i = 0; i < Units; i += 1) left_q[i] <= '0;
    end else if (back_take_o) begin
      enter_q <= windows;
      for (int unsigned i = 0; i < Units; i += 1) left_q[i] <= windows;
    end else begin
      if (end_i) enter_q <= enter_q - 1'b1;
      for (int unsigned i = 0; i < Units; i += 1) if (window_done_i[i]) left_q[i] <= left_q[i] - 1'b1;
    end
  end

  // --- counters -----------------------------------------------------------------------------------------------------
  logic [PerfW-1:0] cycles_q, preprocess_q, overflow_q;
  logic [NowW-1:0]  overflow_now, overflow_now_q;

  always_comb begin
    overflow_now = '0;
    for (int unsigned i = 0; i < Units; i += 1) begin
      overflow_now = overflow_now + NowW'(overflow_sort_i[i]) + NowW'(overflow_alpha_i[i*LinesW +: LinesW]);
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      {cycles_q, preprocess_q, overflow_q} <= '0;
      overflow_now_q                       <= '0;
    end else begin
      overflow_now_q <= busy_o ? overflow_now : '0;
      if (front_take_o && !busy_o) begin
        {cycles_q, preprocess_q, overflow_q} <= '0;
      end else begin
        overflow_q <= overflow_q + PerfW'(overflow_now_q);
        // The first cycle belongs to no unit: counting starts behind it, as in pipegs_perf.
        if (busy_o && !begin_q) cycles_q <= cycles_q + 1'b1;
        if (busy_o && written_i) preprocess_q <= cycles_q;
      end
    end
  end

  assign cycles_o            = cycles_q;
  assign preprocess_cycles_o = preprocess_q;
  assign overflow_lines_o    = overflow_q;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!end_i || !hold_o)
    else $error("pipegs_scheduler: a window's end went into the back although it was held");
`endif

endmodule
