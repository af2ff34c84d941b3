// SPDX-License-Identifier: Apache-2.0
// pu_turns: the clockwork of a stage whose record stays at its source for the first phases of its turn.
//
// Idea    A turn is eight phases. In phases 0 to Out it is shared: the record that came is worked on at the input, and
//         the one of the turn before is finished inside. In phase Out that one leaves and the other moves inside.
//         Unlike a stage of pu_phases such a stage may use its multiplier for both records, so turns never begin in
//         between: a record that comes later than phase 0 waits for the next turn. A turn without a Gaussian ends with
//         phase Out.
// Stream  in, out: valid and ready of the stage. move_o: the record at the input moves inside at this edge. leave_o:
//         the output register takes the one inside. advance_o low: the stage stands still, in phase Out, until the
//         output is free.
// Pace    One record in eight cycles, latency 9 + Out; an end beat takes Out + 1 cycles.
// Model   The record's own; plumbing. Its tests are those of pu_conic and pu_coeff.

module pu_turns #(
  parameter int unsigned Out = 5  // 1 to 6
) (
  input  logic       clk_i,
  input  logic       rst_ni,

  input  logic       in_valid_i,
  output logic       in_ready_o,
  input  logic       in_data_i,  // of the record at the input: a Gaussian, which takes a whole turn

  output logic       out_valid_o,
  input  logic       out_ready_i,

  output logic [7:0] phase_o,    // one bit each, for early choices
  output logic       fresh_o,    // the record at the input has this turn, phases 0 to Out
  output logic       advance_o,
  output logic       move_o,
  output logic       leave_o,
  output logic       busy_o
);

  logic [7:0] phase_q;
  logic       fresh_q, inside_q, out_valid_q;

  assign phase_o     = phase_q;
  assign fresh_o     = phase_q[0] ? in_valid_i : fresh_q;
  assign advance_o   = !(phase_q[Out] && inside_q && out_valid_q && !out_ready_i);
  assign move_o      = phase_q[Out] && advance_o;
  assign leave_o     = move_o && inside_q;
  assign in_ready_o  = move_o && fresh_q;
  assign out_valid_o = out_valid_q;
  assign busy_o      = !phase_q[0] || inside_q || out_valid_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      phase_q     <= 8'b1;
      fresh_q     <= 1'b0;
      inside_q    <= 1'b0;
      out_valid_q <= 1'b0;
    end else begin
      if (leave_o) out_valid_q <= 1'b1;
      else if (out_ready_i) out_valid_q <= 1'b0;
      if (move_o) inside_q <= fresh_q;
      if (phase_q[0]) begin
        fresh_q <= in_valid_i;
        if (in_valid_i || inside_q) phase_q <= 8'b10;
      end else if (move_o && !(fresh_q && in_data_i)) begin
        phase_q <= 8'b1;
      end else if (advance_o) begin
        phase_q <= {phase_q[6:0], phase_q[7]};
      end
    end
  end

`ifndef SYNTHESIS
  initial assert (Out >= 1 && Out <= 6);
  always_ff @(posedge clk_i) if (rst_ni) assert (!(phase_q[Out:1] != '0 && fresh_q) || in_valid_i)
    else $error("the record went away from the input");
  always_ff @(posedge clk_i) if (rst_ni) assert ($onehot(phase_q));  // so a parallel_case is safe
  pipegs_stream_check #(.Proven(1)) u_check_out (
    .clk_i,
    .rst_ni,
    .valid_i(out_valid_o),
    .ready_i(out_ready_i),
    .beat_i(1'b0)
  );
`endif

endmodule
