// SPDX-License-Identifier: Apache-2.0
// pipegs_control_events: what happened: errors with the first address, the interrupt, and the counts of frames.
//
// Idea    A bit is set by its event and cleared by a written 1; an event in the same cycle wins, so none is lost. The
//         cause and the address of the first error stay until all errors of its kind are cleared. Where it happened is
//         not known of every error: then its address is 0 and not said to be one.
// Stream  Events: pulses. error_i: one bit for each cause of ERROR but the last, in its order, each with the line of
//         memory that it concerns if located_i is set. clear_*_i: ones where a 1 is written.
// Pace    An event shows in the next cycle; irq_o, a register, one cycle later.
// Model   cpp_model/control/control_registers.hpp

module pipegs_control_events #(
  localparam int unsigned AddressW = pipegs_pkg::AddressW,
  localparam int unsigned Causes   = 8
) (
  input  logic                       clk_i,
  input  logic                       rst_ni,

  input  logic                       taken_i,        // the machine took the queued frame
  input  logic                       freed_i,        // the queue is free again: taken or dropped
  input  logic                       frame_done_i,
  input  logic [Causes-1:0]          error_i,
  input  logic [Causes-1:0]          located_i,        // its line is known
  input  logic [Causes*AddressW-1:0] error_address_i,  // line
  input  logic                       start_full_i,

  input  pipegs_pkg::control_error_t      clear_error_i,
  input  pipegs_pkg::control_irq_status_t clear_irq_i,
  input  pipegs_pkg::control_irq_enable_t enable_i,

  output pipegs_pkg::control_error_t       error_o,
  output pipegs_pkg::control_error_first_t error_first_o,
  output logic [AddressW-1:0]              error_line_o,
  output pipegs_pkg::control_irq_status_t  irq_status_o,
  output logic [31:0]                      started_o,
  output logic [31:0]                      done_o,
  output logic                             irq_o
);

  logic [Causes:0]     error_q, error_next;
  logic [Causes-1:0]   kept;  // of those that give frames up
  logic [2:0]          irq_q;
  logic                irq_out_q;
  logic [2:0]          cause_q, cause;
  logic [AddressW-1:0] line_q, line;
  logic                located_q, located;
  logic [31:0]         started_q, done_q;
  logic                unused_gaps;

  assign unused_gaps = &{1'b0, clear_error_i, clear_irq_i, enable_i};
  assign kept        = error_q[Causes-1:0] & ~clear_error_i[Causes-1:0];
  assign error_next  = (error_q & ~clear_error_i[Causes:0]) | {start_full_i, error_i};

  always_comb begin  // of the lowest cause
    cause   = '0;
    line    = '0;
    located = 1'b0;
    for (int unsigned i = Causes; i > 0; i -= 1) begin
      if (error_i[i-1]) begin
        cause   = 3'(i - 1);
        line    = error_address_i[(i-1)*AddressW +: AddressW] & {AddressW{located_i[i-1]}};
        located = located_i[i-1];
      end
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      error_q   <= '0;
      irq_q     <= '0;
      cause_q   <= '0;
      line_q    <= '0;
      located_q <= 1'b0;
      started_q <= '0;
      done_q    <= '0;
      irq_out_q <= 1'b0;
    end else begin
      error_q   <= error_next;
      irq_q     <= (irq_q & ~clear_irq_i[2:0]) | {start_full_i || error_i != '0, freed_i, frame_done_i};
      if (error_i != '0 && kept == '0) begin
        cause_q   <= cause;
        line_q    <= line;
        located_q <= located;
      end
      started_q <= started_q + 32'(taken_i);
      done_q    <= done_q + 32'(frame_done_i);
      irq_out_q <= (irq_q & enable_i[2:0]) != '0;
    end
  end

  always_comb begin
    error_o               = '0;
    error_first_o         = '0;
    irq_status_o          = '0;
    error_o[Causes:0]     = error_q;
    error_first_o.valid   = error_q[Causes-1:0] != '0;
    error_first_o.located = error_q[Causes-1:0] != '0 && located_q;
    error_first_o.cause   = cause_q;
    irq_status_o[2:0]     = irq_q;
  end
  assign error_line_o = line_q;
  assign started_o    = started_q;
  assign done_o       = done_q;
  assign irq_o        = irq_out_q;

endmodule
