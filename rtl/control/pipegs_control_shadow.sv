// SPDX-License-Identifier: Apache-2.0
// pipegs_control_shadow: the parameters of the next frame, which software writes while the machine renders another one.
//
// Idea    A pipegs_control_slot for each value of the package's table, and a bit that says whether they are queued. A
//         start sets the bit; from then on the slots are shown as a frame and cannot be written, until the machine
//         takes it. A new field of frame_t has its slot without a change here. A value that this configuration does not
//         have keeps its place, which reads 0.
// Stream  write_i: pulse; a word that is not hit, or comes while a frame is queued, changes nothing. start_i, drop_i:
//         pulses; drop_i wins. Out: the queued frame with what lies beside it, valid until it is taken or dropped.
// Pace    A start is shown in the next cycle. read_data_o follows read_word_i in the same cycle.
// Model   cpp_model/control/control_registers.hpp

module pipegs_control_shadow #(
  localparam int unsigned WordW = pipegs_pkg::ControlAddressW - 2
) (
  input  logic                   clk_i,
  input  logic                   rst_ni,

  input  logic                   write_i,
  input  logic [WordW-1:0]       write_word_i,
  input  logic [31:0]            write_data_i,
  input  logic [31:0]            write_mask_i,
  output logic                   write_hit_o,   // the word is part of a slot
  input  logic [WordW-1:0]       read_word_i,
  output logic                   read_hit_o,
  output logic [31:0]            read_data_o,   // 0 where nothing is hit

  input  logic                   start_i,
  input  logic                   drop_i,
  output logic                   frame_valid_o,
  input  logic                   frame_ready_i,
  output pipegs_pkg::frame_t     frame_o,
  output pipegs_pkg::areas_t     areas_o,
  output pipegs_pkg::picture_t   picture_o
);

  localparam int unsigned Slots = pipegs_pkg::ControlSlots;
  localparam int unsigned Bits  = pipegs_pkg::ControlShadowBits;

  typedef struct packed {logic [Slots-1:0][31:0] of;} words_t;
  logic [Bits-1:0]  shadow;
  logic             queued_q, write;
  logic [Slots-1:0] write_hits, read_hits;
  words_t           shown;  // what each slot gives a read

  assign write         = write_i && !queued_q;
  assign write_hit_o   = write_hits != '0;
  assign read_hit_o    = read_hits != '0;
  assign frame_valid_o = queued_q;
  assign {picture_o, areas_o, frame_o} = shadow;

  for (genvar i = 0; i < Slots; i += 1) begin : gen_slot
    localparam logic [55:0] Slot   = pipegs_pkg::ControlSlotTable[56*i +: 56];
    localparam int unsigned Offset = 32'(Slot[55:40]);
    localparam int unsigned At     = 32'(Slot[39:24]);
    localparam int unsigned Width  = 32'(Slot[23:16]);
    localparam int unsigned Shift  = 32'(Slot[15:8]);
    localparam bit          Signed = Slot[0];

    assign write_hits[i] = write_word_i[WordW-1:1] == (WordW-1)'(Offset / 8);
    assign read_hits[i]  = read_word_i[WordW-1:1] == (WordW-1)'(Offset / 8);

    if (Width > 0) begin : gen_value
      pipegs_control_slot #(.WordW(WordW), .Word(Offset / 4), .Width(Width), .Shift(Shift), .Signed(Signed)) u_slot (
        .clk_i,
        .rst_ni,
        .write_i(write),
        .write_word_i,
        .write_data_i,
        .write_mask_i,
        .read_word_i,
        .read_data_o(shown.of[i]),
        .value_o(shadow[At +: Width])
      );
    end else begin : gen_absent
      assign shown.of[i] = '0;
    end
  end

  always_comb begin
    read_data_o = '0;
    for (int unsigned i = 0; i < Slots; i += 1) read_data_o |= shown.of[i];
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) queued_q <= 1'b0;
    else if (drop_i) queued_q <= 1'b0;
    else if (!queued_q) queued_q <= start_i;
    else if (frame_ready_i) queued_q <= 1'b0;
  end

`ifndef SYNTHESIS
  // A frame that is dropped is taken back.
  pipegs_stream_check #(.DataW($bits({frame_o, areas_o, picture_o}))) u_check_frame (
    .clk_i,
    .rst_ni(rst_ni && !drop_i),
    .valid_i(frame_valid_o),
    .ready_i(frame_ready_i),
    .beat_i({frame_o, areas_o, picture_o})
  );
`endif

endmodule
