// SPDX-License-Identifier: Apache-2.0
// pipegs_control_registers: the control side: registers behind AXI4-Lite that start frames and tell what happens.
//
// Idea    pipegs_control_bus makes one write and one read strobe of the bus. Four parts look at the word: what the
//         configuration fixes, the registers below, the parameters of the next frame (pipegs_control_shadow) and the
//         performance counters (pipegs_control_counters). What none of them has, and a write to what cannot be written,
//         is an error. Events are kept in pipegs_control_events.
// Stream  s_axi: see pipegs_control_bus. frame_o with areas_o and picture_o: the queued frame, valid until it is
//         taken or dropped by an abort. abort_o: pulse, a cycle in which no frame is shown.
// Pace    A start is shown three cycles after the bus has taken its address and data.
// Model   cpp_model/control/control_registers.hpp; the table of registers: cpp_model/control/registers.def

module pipegs_control_registers #(
  localparam int unsigned AddressW = pipegs_pkg::ControlAddressW,
  localparam int unsigned LineW    = pipegs_pkg::AddressW,
  localparam int unsigned Counters = pipegs_pkg::ControlCounters,
  localparam int unsigned PerfW    = pipegs_pkg::PerfW,
  localparam int unsigned Causes   = 8
) (
  input  logic                      clk_i,
  input  logic                      rst_ni,

  input  pipegs_pkg::axi_lite_manager_t     s_axi_i,
  output pipegs_pkg::axi_lite_subordinate_t s_axi_o,
  output logic                      irq_o,            // high while an enabled event is not cleared

  output logic                      frame_valid_o,
  input  logic                      frame_ready_i,
  output pipegs_pkg::frame_t        frame_o,
  output pipegs_pkg::areas_t        areas_o,
  output pipegs_pkg::picture_t      picture_o,
  output logic                      abort_o,
  output logic [31:0]               timeout_o,        // cycles for which memory may be silent; 0: for ever

  input  logic                      apart_i,          // the core is about to be reset: counters read 0
  input  logic                      busy_i,           // a frame is in the core: up from the cycle after it was taken
  input  logic                      silent_i,         // memory is
  input  logic                      frame_done_i,     // pulse: the last pixel of a frame is in memory
  input  logic [Causes-1:0]         error_i,          // pulses, in the order of ERROR: read SLVERR, DECERR, write
                                                      // SLVERR, DECERR, area full, bad scene, read and write timeout
  input  logic [Causes-1:0]         located_i,        // of each cause: its line is known
  input  logic [Causes*LineW-1:0]   error_address_i,  // line of memory, one for each cause
  input  logic [Counters*PerfW-1:0] counters_i        // cycles, preprocess_cycles, overflow_lines, then perf_o
);

  localparam int unsigned WordW     = AddressW - 2;
  localparam int unsigned Constants = pipegs_pkg::ControlConstants;

  logic             write, write_error, read, read_error;
  logic [WordW-1:0] write_word, read_word;
  logic [31:0]      write_data, write_mask, written, read_data;

  logic             shadow_write_hit, shadow_read_hit, counters_hit, constant_hit, live_hit, live_writable;
  logic [31:0]      shadow_data, counters_data, constant_data, live_data;
  logic             to_control, to_error, to_irq_status, to_irq_enable, to_timeout, taken, queued;
  logic             abort_q, unused_control;
  logic [31:0]      timeout_q;

  pipegs_pkg::control_control_t     control;
  pipegs_pkg::control_status_t      status;
  pipegs_pkg::control_error_t       error, clear_error;
  pipegs_pkg::control_error_first_t error_first;
  pipegs_pkg::control_irq_status_t  irq_status, clear_irq;
  pipegs_pkg::control_irq_enable_t  irq_enable, irq_enable_q;
  logic [LineW-1:0]                 error_line;
  logic [63:0]                      error_address;
  logic [31:0]                      started, done;

  pipegs_control_bus u_bus (
    .clk_i,
    .rst_ni,
    .s_axi_i,
    .s_axi_o,
    .write_o(write),
    .write_word_o(write_word),
    .write_data_o(write_data),
    .write_mask_o(write_mask),
    .write_error_i(write_error),
    .read_o(read),
    .read_word_o(read_word),
    .read_data_i(read_data),
    .read_error_i(read_error)
  );

  pipegs_control_shadow u_shadow (
    .clk_i,
    .rst_ni,
    .write_i(write),
    .write_word_i(write_word),
    .write_data_i(write_data),
    .write_mask_i(write_mask),
    .write_hit_o(shadow_write_hit),
    .read_word_i(read_word),
    .read_hit_o(shadow_read_hit),
    .read_data_o(shadow_data),
    .start_i(control.start),
    .drop_i(control.abort_all),
    .frame_valid_o,
    .frame_ready_i,
    .frame_o,
    .areas_o,
    .picture_o
  );

  pipegs_control_counters u_counters (
    .clk_i,
    .rst_ni,
    .apart_i,
    .counters_i,
    .read_i(read),
    .read_word_i(read_word),
    .read_hit_o(counters_hit),
    .read_data_o(counters_data)
  );

  pipegs_control_events u_events (
    .clk_i,
    .rst_ni,
    .taken_i(taken),
    .freed_i(queued && (frame_ready_i || control.abort_all)),
    .frame_done_i,
    .error_i,
    .located_i,
    .error_address_i,
    .start_full_i(control.start && !control.abort_all && queued),
    .clear_error_i(clear_error),
    .clear_irq_i(clear_irq),
    .enable_i(irq_enable_q),
    .error_o(error),
    .error_first_o(error_first),
    .error_line_o(error_line),
    .irq_status_o(irq_status),
    .started_o(started),
    .done_o(done),
    .irq_o
  );

  // --- writes --------------------------------------------------------------------------------------------------------
  assign queued        = frame_valid_o;
  assign taken         = frame_valid_o && frame_ready_i;
  assign to_control    = write_word == pipegs_pkg::ControlControlAt[AddressW-1:2];
  assign to_error      = write_word == pipegs_pkg::ControlErrorAt[AddressW-1:2];
  assign to_irq_status = write_word == pipegs_pkg::ControlIrqStatusAt[AddressW-1:2];
  assign to_irq_enable = write_word == pipegs_pkg::ControlIrqEnableAt[AddressW-1:2];
  assign to_timeout    = write_word == pipegs_pkg::ControlBusTimeoutAt[AddressW-1:2];
  assign live_writable = to_control || to_error || to_irq_status || to_irq_enable || to_timeout;
  assign write_error   = !live_writable && (!shadow_write_hit || queued);

  assign written     = write_data & write_mask & {32{write}};
  assign control     = written & {32{to_control}};
  assign unused_control = &{1'b0, control};
  assign clear_error = written & {32{to_error}};
  assign clear_irq   = written & {32{to_irq_status}};

  always_comb begin  // of the register's bits only those that have a name are kept
    irq_enable            = '0;
    irq_enable[2:0]       = (irq_enable_q[2:0] & ~write_mask[2:0]) | written[2:0];
  end
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      irq_enable_q <= '0;
      abort_q      <= 1'b0;
      timeout_q    <= pipegs_pkg::ControlBusTimeoutReset;
    end else begin
      if (write && to_irq_enable) irq_enable_q <= irq_enable;
      if (write && to_timeout) timeout_q <= (timeout_q & ~write_mask) | written;
      abort_q <= control.abort_all;
    end
  end
  assign abort_o   = abort_q;
  assign timeout_o = timeout_q;

  // --- reads ---------------------------------------------------------------------------------------------------------
  assign error_address = {30'd0, error_line} << 6;
  always_comb begin
    status        = '0;
    status.busy   = busy_i;
    status.queued = queued;
    status.failed = error != '0;
    status.silent = silent_i;
  end

  always_comb begin
    live_hit  = 1'b1;
    live_data = '0;
    unique case ({read_word, 2'b00})
      pipegs_pkg::ControlControlAt:          live_data = '0;
      pipegs_pkg::ControlStatusAt:           live_data = status;
      pipegs_pkg::ControlErrorAt:            live_data = error;
      pipegs_pkg::ControlErrorFirstAt:       live_data = error_first;
      pipegs_pkg::ControlErrorAddressLowAt:  live_data = error_address[31:0];
      pipegs_pkg::ControlErrorAddressHighAt: live_data = error_address[63:32];
      pipegs_pkg::ControlIrqStatusAt:        live_data = irq_status;
      pipegs_pkg::ControlIrqEnableAt:        live_data = irq_enable_q;
      pipegs_pkg::ControlBusTimeoutAt:       live_data = timeout_q;
      pipegs_pkg::ControlFramesStartedAt:    live_data = started;
      pipegs_pkg::ControlFramesDoneAt:       live_data = done;
      default:                               live_hit = 1'b0;
    endcase
  end

  always_comb begin
    constant_hit  = 1'b0;
    constant_data = '0;
    for (int unsigned i = 0; i < Constants; i += 1) begin
      if (read_word == pipegs_pkg::ControlConstantTable[48*i+34 +: WordW]) begin
        constant_hit  = 1'b1;
        constant_data = constant_data | pipegs_pkg::ControlConstantTable[48*i +: 32];
      end
    end
  end

  assign read_data  = live_data | constant_data | shadow_data | counters_data;
  assign read_error = !live_hit && !constant_hit && !shadow_read_hit && !counters_hit;

endmodule
