// SPDX-License-Identifier: Apache-2.0
// pu_phases: the clockwork of a stage that works on one record for a few cycles, sharing its multipliers over them.
//
// Idea    A record is held for its phases, 0 to Phases - 1 (phase_o). What a phase issues travels down the stage's
//         registers: slots_o tells, for each of these Depth register levels, which phase's values it holds. So the last
//         phase's place in the levels tells how old a record is that is no longer held. The output register is the
//         stage's last place: Claim cycles after phase 0 it must be free and takes the fields that pass, later the
//         results are written into it one by one, and it becomes valid when level Depth has handled the last phase.
//         By then younger records are in their phases, or in the levels behind these.
// Stream  in, out: valid and ready of the stage. take_o: the held record loads at this edge. claim_o: the output
//         register loads. step_o low: everything in the stage stands still (only when a record is to claim, and then
//         the one before has left the levels, as Claim is at least Depth).
// Pace    One record in Phases cycles, latency 1 + Phases + Depth.
// Model   The record's bit-accurate model; plumbing.

module pu_phases #(
  parameter int unsigned Phases = 8,  // 4 or 8
  parameter int unsigned Depth  = 1,  // 1 to Claim
  parameter int unsigned Claim  = 4,  // cycle, from phase 0 on; less than Phases + Depth
  localparam int unsigned SlotW = 4  // {valid, phase}
) (
  input  logic                         clk_i,
  input  logic                         rst_ni,

  input  logic                         in_valid_i,
  output logic                         in_ready_o,

  output logic                         out_valid_o,
  input  logic                         out_ready_i,

  output logic                         take_o,
  output logic                         claim_o,
  output logic                         step_o,
  output logic                         held_o,   // a record is held
  output logic [Phases-1:0]            phase_o,  // of the phase issued now; one bit each, for early choices
  output logic [Depth*SlotW-1:0]       slots_o,  // level 1, what was issued one step ago, in the low bits
  output logic                         busy_o
);

  localparam int unsigned PhaseW = SlotW - 1;
  localparam logic [PhaseW-1:0] LastPhase = PhaseW'(Phases - 1);

  logic                   valid_q;   // a record is held
  logic [PhaseW-1:0]      phase_q;
  logic [Depth*SlotW-1:0] levels_q;
  logic                   out_valid_q;
  logic                   out_free, claims, finish, work;

  if (Claim < Phases) begin : gen_held
    assign claims = valid_q && phase_q == PhaseW'(Claim);
  end else begin : gen_behind
    assign claims = levels_q[(Claim-Phases)*SlotW+:SlotW] == {1'b1, LastPhase};
  end
  assign out_free    = !out_valid_q || out_ready_i;
  assign step_o      = !(claims && !out_free);
  assign claim_o     = claims && out_free;
  assign in_ready_o  = !valid_q || (phase_q == LastPhase && step_o);
  assign take_o      = in_valid_i && in_ready_o;
  assign held_o      = valid_q;
  assign slots_o     = levels_q;
  assign finish      = levels_q[(Depth-1)*SlotW+:SlotW] == {1'b1, LastPhase};
  assign out_valid_o = out_valid_q;
  assign busy_o      = valid_q || out_valid_q || work;

  // A level is in use.
  always_comb begin
    work = 1'b0;
    for (int unsigned i = 0; i < Depth; i += 1) work |= levels_q[i*SlotW+SlotW-1];
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      valid_q     <= 1'b0;
      phase_q     <= '0;
      phase_o     <= Phases'(1);
      levels_q    <= '0;
      out_valid_q <= 1'b0;
    end else begin
      if (in_ready_o) valid_q <= in_valid_i;
      if (in_ready_o) phase_q <= '0;
      else if (step_o) phase_q <= phase_q + 1'b1;
      if (in_ready_o) phase_o <= Phases'(1);
      else if (step_o) phase_o <= phase_o << 1;
      if (step_o) levels_q <= (Depth*SlotW)'({levels_q, valid_q, phase_q});
      if (finish && step_o) out_valid_q <= 1'b1;
      else if (out_ready_i) out_valid_q <= 1'b0;
    end
  end

`ifndef SYNTHESIS
  initial assert (Depth >= 1 && Depth <= Claim && Claim < Phases + Depth);
  always_ff @(posedge clk_i) if (rst_ni) assert (!(finish && step_o) || out_free);
  always_ff @(posedge clk_i) if (rst_ni) assert (phase_o == Phases'(1) << phase_q);  // so a parallel_case is safe
  pipegs_stream_check #(.Proven(1)) u_check_out (
    .clk_i,
    .rst_ni,
    .valid_i(out_valid_o),
    .ready_i(out_ready_i),
    .beat_i(1'b0)
  );
`endif

endmodule
