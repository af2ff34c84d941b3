// SPDX-License-Identifier: Apache-2.0
// pipegs_axi_gather: beats of AXI4 read answers become lines of the core.
//
// Idea    The subordinate may send beats of one ID between those of another, so each tag has a counter and a place for
//         the beats of its unfinished line: one SRAM for each beat of a line but the last, with a word per tag. The
//         last beat goes to a register, and the SRAMs, read in that cycle, stand beside it in the next one. A cycle
//         either writes one SRAM or reads them all. With beats of a whole line there is no SRAM and no counter.
//         Beats of an epoch that is over are dropped; when the epoch changes all counters begin again. If Coded, a read
//         of half a line ends after half as many beats, which stand in both halves of the line; of a beat as wide as a
//         line one half is what was asked for.
// Stream  in: beats of R, never refused. out: a line and its tag, never refused by the core.
// Pace    One beat per cycle; a line shows one cycle after its last beat.
// Model   sim/memory/axi/axi_memory.hpp has the other side.

module pipegs_axi_gather #(
  parameter int unsigned DataW = 512,
  localparam int unsigned TagW = pipegs_pkg::TagW
) (
  input  logic                           clk_i,
  input  logic                           rst_ni,

  input  logic                           turn_i,  // the epoch is another one than in the cycle before
  input  logic                           beat_valid_i,  // a beat of this epoch
  input  logic                           beat_last_i,   // of its burst
  input  logic [TagW-1:0]                beat_tag_i,
  input  logic [DataW-1:0]               beat_i,

  output logic                           line_valid_o,
  output logic [TagW-1:0]                line_tag_o,
  output logic [pipegs_pkg::MemoryW-1:0] line_o,
  output logic                           active_o  // a line waits to show
);

  localparam int unsigned Tags  = pipegs_pkg::MemoryPorts;
  localparam int unsigned PortW = $clog2(Tags);
  localparam int unsigned Beats = pipegs_pkg::MemoryW / DataW;

  logic             last, line_valid_q;
  logic [TagW-1:0]  tag_q;
  logic [DataW-1:0] last_q;

  if (Beats == 1) begin : gen_whole
    assign last   = 1'b1;
    assign line_o = last_q;
  end else begin : gen_parts
    localparam int unsigned BeatW = $clog2(Beats);
    logic                        half;  // of a line, is what was read
    logic [Tags*BeatW-1:0]       beats_q;  // of each tag: beats here of its unfinished line
    logic [BeatW-1:0]            beat;
    logic [PortW-1:0]            port;
    logic [(Beats-1)*DataW-1:0]  parts;

    assign port = beat_tag_i[PortW-1:0];
    assign beat = beats_q[port*BeatW +: BeatW];
    assign half = pipegs_pkg::Coded && beat_last_i && beat == BeatW'(Beats / 2 - 1);
    assign last = half || beat == BeatW'(Beats - 1);

    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) beats_q <= '0;
      else if (turn_i) beats_q <= '0;
      else if (beat_valid_i) beats_q[port*BeatW +: BeatW] <= last ? '0 : beat + 1'b1;
    end

    for (genvar i = 0; i < Beats - 1; i += 1) begin : gen_part
      pipegs_sram #(.DataW(DataW), .Depth(Tags)) u_part (
        .clk_i,
        .write_i(beat_valid_i && !last && beat == BeatW'(i)),
        .waddr_i(port),
        .wdata_i(beat_i),
        .read_i(beat_valid_i && last),
        .raddr_i(port),
        .rdata_o(parts[i*DataW +: DataW])
      );
    end
    if (pipegs_pkg::Coded) begin : gen_halves
      logic half_q;
      always_ff @(posedge clk_i) if (beat_valid_i && last) half_q <= half;
      if (Beats == 2) begin : gen_two
        assign line_o = {last_q, half_q ? last_q : parts};
      end else begin : gen_four
        assign line_o = {last_q, half_q ? {parts[DataW-1:0], last_q} : parts[DataW +: 2*DataW], parts[DataW-1:0]};
      end
    end else begin : gen_whole_lines
      assign line_o = {last_q, parts};
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) line_valid_q <= 1'b0;
    else line_valid_q <= beat_valid_i && last;
  end
  always_ff @(posedge clk_i) begin
    if (beat_valid_i) tag_q <= beat_tag_i;
    if (beat_valid_i && last) last_q <= beat_i;
  end

  assign line_valid_o = line_valid_q && !turn_i;
  assign line_tag_o   = tag_q;
  assign active_o     = line_valid_q;

  logic unused_last;  // lines are whole, or beats are
  assign unused_last = beat_last_i;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!beat_valid_i || (TagW+1)'(beat_tag_i) < (TagW+1)'(Tags))
    else $error("pipegs_axi_gather: an answer with a tag that nobody has");
`endif

endmodule
