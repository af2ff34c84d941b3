// SPDX-License-Identifier: Apache-2.0
// pipegs_control_restart: gives up what the core is doing: resets it alone, while the bus goes on by its rules.
//
// Idea    Of a frame that was aborted or has met an error the core holds nothing of use, so the core is reset.
//         What it asked for is still answered: the memory side tells answers apart by the epoch of their request, one
//         bit, and so the epoch may turn only when nothing of the epoch before is out. Until then the core stays in
//         reset.
// Stream  give_up_i: pulse. core_rst_no: the core's reset, a flip-flop of its own. ready_o: the core may take a frame.
// Pace    The core is in reset from the next cycle on, for two cycles when drained_i is up.
// Model   cpp_model/control/control_restart.hpp

module pipegs_control_restart (
  input  logic clk_i,
  input  logic rst_ni,

  input  logic give_up_i,    // an abort or an error; counts for nothing while the core is in reset
  input  logic drained_i,    // no read of an older epoch is unanswered
  output logic epoch_o,
  output logic core_rst_no,
  output logic ready_o
);

  typedef enum logic [1:0] {StateRun, StateStop, StateTurned} state_e;
  state_e state_q;
  logic   epoch_q, core_rst_nq;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q     <= StateTurned;
      epoch_q     <= 1'b0;
      core_rst_nq <= 1'b0;
    end else begin
      unique case (state_q)
        StateRun: if (give_up_i) begin
          state_q     <= StateStop;
          core_rst_nq <= 1'b0;
        end
        StateStop: if (drained_i) begin
          state_q <= StateTurned;
          epoch_q <= !epoch_q;
        end
        default: begin
          state_q     <= StateRun;
          core_rst_nq <= 1'b1;
        end
      endcase
    end
  end

  assign epoch_o     = epoch_q;
  assign core_rst_no = core_rst_nq;
  assign ready_o     = state_q == StateRun && !give_up_i;

endmodule
