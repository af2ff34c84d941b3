// SPDX-License-Identifier: Apache-2.0
// pipegs_control_restart: resets the core and lets it alone, while the bus goes on by its rules.
//
// Idea    Of a frame that was aborted or has met an error the core holds nothing of use, so the core is reset. Its
//         reset falls without a clock, so first, a cycle before, the core is kept apart: nothing that it shows counts.
//         Apart it stays until some cycles behind the reset, which may then reach the core's flip-flops in any of them.
//         What it asked for is still answered: the memory side tells answers apart by the epoch of their request, one
//         bit, and so the epoch may turn only when nothing of the epoch before is out, well within the reset. In the
//         scan test (test_mode_i) the tester drives the core's reset, since the flip-flops hold its patterns.
// Stream  give_up_i: pulse. apart_o, core_rst_no: a flip-flop each. ready_o: the core may take a frame.
// Pace    Apart from the next cycle on, in reset one later. When drained_i is up it is in reset for Cycles + 1 cycles
//         and apart for twice as many. Behind a reset of the machine the same, but no epoch is there to turn from.
// Model   cpp_model/control/control_restart.hpp

module pipegs_control_restart #(
  parameter int unsigned Cycles = pipegs_pkg::ResetCycles  // at least 4
) (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic test_mode_i,  // scan test of the silicon, else 0

  input  logic give_up_i,    // an abort or an error; counts for nothing while the core is kept apart
  input  logic drained_i,    // no read of an older epoch is unanswered
  output logic epoch_o,
  output logic apart_o,
  output logic core_rst_no,
  output logic ready_o
);

  if (Cycles < 4) begin : gen_short
    $error("pipegs_control_restart: Cycles is below 4");
  end

  localparam int unsigned LeftW = $clog2(Cycles);

  typedef enum logic [2:0] {StateRun, StateApart, StateStop, StateTurned, StateFree} state_e;
  state_e           state_q;
  logic             epoch_q, apart_q, core_rst_nq, counts;
  logic [LeftW-1:0] left_q;

  assign counts = state_q == StateTurned || state_q == StateFree;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q     <= StateTurned;
      left_q      <= LeftW'(Cycles - 1);
      epoch_q     <= 1'b0;
      apart_q     <= 1'b1;
      core_rst_nq <= 1'b0;
    end else begin
      left_q <= counts && left_q != '0 ? left_q - 1'b1 : LeftW'(Cycles - 1);
      unique case (state_q)
        StateRun: if (give_up_i) begin
          state_q <= StateApart;
          apart_q <= 1'b1;
        end
        StateApart: begin
          state_q     <= StateStop;
          core_rst_nq <= 1'b0;
        end
        StateStop: if (drained_i) begin
          state_q <= StateTurned;
          epoch_q <= !epoch_q;
        end
        StateTurned: if (left_q == '0) begin
          state_q     <= StateFree;
          core_rst_nq <= 1'b1;
        end
        default: if (left_q == '0) begin
          state_q <= StateRun;
          apart_q <= 1'b0;
        end
      endcase
    end
  end

  assign epoch_o     = epoch_q;
  assign apart_o     = apart_q;
  assign core_rst_no = test_mode_i ? rst_ni : core_rst_nq;
  assign ready_o     = !apart_q && !give_up_i;

endmodule
