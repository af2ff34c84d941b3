// SPDX-License-Identifier: Apache-2.0
// pipegs_stream_check: the stream contract at a giver's ports: valid, once up, stays up with the same beat until taken.
//
// Paper   None.
// Idea    Remembers what was shown and not taken in the cycle before. Every module that makes a stream has one of these
//         for it where no synthesis sees it, and so has every place where logic feeds a stream into an instance
//         (docs/architecture.md; verif/self/streams finds what lacks one). It drives nothing. Beats are compared where
//         PIPEGS_BEATS is defined, as in all unit tests; a machine leaves that out, and what is proved, for its speed.
// Stream  Ports streams side by side, each with a beat of its own or, with Shared, all with one. Proven: a proof of the
//         module says the same for every trace.
// Model   verif/lib/stream_check_test.cpp

module pipegs_stream_check #(
  parameter int unsigned Ports = 1,
  parameter int unsigned DataW = 1,
  parameter bit          Shared = 1'b0,
  parameter bit          Proven = 1'b0,
  localparam int unsigned Beats = Shared ? 1 : Ports
) (
  input logic                   clk_i,
  input logic                   rst_ni,
  input logic [Ports-1:0]       valid_i,
  input logic [Ports-1:0]       ready_i,
  input logic [Beats*DataW-1:0] beat_i
);

`ifdef PIPEGS_BEATS
  localparam bit Whole = 1'b1;
`else
  localparam bit Whole = 1'b0;
`endif

  logic [Ports-1:0] waits_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) waits_q <= '0;
    else waits_q <= valid_i & ~ready_i;
  end

  // The condition stands before the assertion too: a simulation then looks for nothing else while all is well.
  if (Whole || !Proven) begin : gen_valid
    logic gone;
    assign gone = (waits_q & ~valid_i) != '0;
    always_ff @(posedge clk_i) if (rst_ni && gone) assert (!gone);
  end

  if (Whole) begin : gen_beats
    logic [Beats*DataW-1:0] beat_q;
    logic [Beats-1:0]       waits;  // of each beat: somebody has still to take it
    assign waits = Shared ? Beats'(waits_q != '0) : Beats'(waits_q);
    always_ff @(posedge clk_i) beat_q <= beat_i;
    for (genvar i = 0; i < Beats; i += 1) begin : gen_beat
      always_ff @(posedge clk_i) begin
        if (rst_ni && waits[i]) assert (beat_i[i*DataW +: DataW] == beat_q[i*DataW +: DataW]);
      end
    end
  end else begin : gen_no_beats
    logic unused_beat;
    assign unused_beat = &{1'b0, beat_i, waits_q};
  end

endmodule
