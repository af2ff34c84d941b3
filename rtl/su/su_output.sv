// SPDX-License-Identifier: Apache-2.0
// su_output: sorted keys become splats again, with the ends of a set that spilled among them.
//
// Idea    Of a set that spilled nothing was released (su_release), so the mark that ends the spill goes here, behind
//         all keys that it releases. Then su_emit.
// Stream  item: keys and ends in order. mark: the end in front. out: splats; while divert_i, to su_spill, or back into
//         the pool.
// Pace    su_emit's.
// Model   cpp_model/su/su.hpp

module su_output #(
  localparam int unsigned KeyW      = pipegs_pkg::KeyW,
  localparam int unsigned RecordW   = pipegs_pkg::RecordW,
  localparam int unsigned NumberW   = pipegs_pkg::SlotW,
  localparam int unsigned SplatBits = pipegs_pkg::SplatBits,
  localparam int unsigned PayloadW  = SplatBits - pipegs_pkg::KindW - KeyW
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic                     item_valid_i,
  output logic                     item_ready_o,
  input  pipegs_pkg::su_item_t     item_i,

  input  logic                     spilled_i,       // the keys are of a set that spilled
  input  logic                     keep_i,          // it is still being sorted: they go to kept
  input  logic                     all_sent_i,      // no more of them come
  input  logic                     mark_valid_i,
  input  pipegs_pkg::su_mark_t     mark_i,
  output logic                     mark_first_o,
  output logic                     mark_ready_o,
  output logic                     done_o,          // the mark leaves

  output logic                     kept_valid_o,
  input  logic                     kept_ready_i,
  output logic [NumberW-1:0]       kept_number_o,
  output logic                     read_valid_o,    // of external memory
  input  logic                     read_ready_i,
  output logic [NumberW-1:0]       read_line_o,
  input  logic                     line_valid_i,
  output logic                     line_ready_o,
  input  logic [SplatBits-1:0]     line_i,

  input  logic                     record_busy_i,   // of the stores
  output logic                     record_read_o,
  output logic [RecordW-1:0]       record_slot_o,
  input  logic [PayloadW-1:0]      record_i,
  output logic                     free_o,
  output logic [RecordW-1:0]       free_slot_o,

  input  logic                     divert_i,
  output logic                     back_valid_o,
  input  logic                     back_ready_i,
  output logic                     out_valid_o,
  input  logic                     out_ready_i,
  output pipegs_pkg::splat_t       out_o,

  output logic                     empty_o,
  output logic                     moves_o
);

  logic valid, emit_ready, emit_valid;

  assign mark_first_o = spilled_i && !keep_i && mark_valid_i && all_sent_i && !item_valid_i;
  assign mark_ready_o = emit_ready;
  assign done_o       = mark_first_o && emit_ready;
  assign emit_valid   = mark_first_o || item_valid_i;
  assign item_ready_o = emit_ready && !mark_first_o;

  su_emit u_emit (
    .clk_i,
    .rst_ni,
    .item_valid_i(emit_valid),
    .item_ready_o(emit_ready),
    .item_end_i(mark_first_o || item_i.is_end),
    .item_key_i(item_i.key),
    .item_slot_i(mark_first_o ? RecordW'(mark_i.kind) : item_i.slot),
    .spilled_i,
    .keep_i,
    .kept_valid_o,
    .kept_ready_i,
    .kept_number_o,
    .read_valid_o,
    .read_ready_i,
    .read_line_o,
    .line_valid_i,
    .line_ready_o,
    .line_i,
    .record_busy_i,
    .record_read_o,
    .record_slot_o,
    .record_i,
    .out_valid_o(valid),
    .out_ready_i(divert_i ? back_ready_i : out_ready_i),
    .out_o,
    .free_o,
    .free_slot_o,
    .empty_o,
    .active_o(moves_o)
  );
  assign back_valid_o = valid && divert_i;
  assign out_valid_o  = valid && !divert_i;

  logic unused;  // its bucket
  assign unused = &{1'b0, mark_i};

`ifndef SYNTHESIS
  pipegs_stream_check u_check_back (
    .clk_i,
    .rst_ni,
    .valid_i(back_valid_o),
    .ready_i(back_ready_i),
    .beat_i(1'b0)
  );
  pipegs_stream_check #(.DataW($bits(out_o))) u_check_out (
    .clk_i,
    .rst_ni,
    .valid_i(out_valid_o),
    .ready_i(out_ready_i),
    .beat_i(out_o)
  );
  pipegs_stream_check u_check_item (
    .clk_i,
    .rst_ni,
    .valid_i(emit_valid),
    .ready_i(emit_ready),
    .beat_i(1'b0)
  );
`endif

endmodule
