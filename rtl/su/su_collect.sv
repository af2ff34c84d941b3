// SPDX-License-Identifier: Apache-2.0
// su_collect: takes the splats of a layer in, to a free slot each, and passes the ends on as marks.
//
// Paper   Sec. 4.1 (layer i + 1 is collected while layer i is sorted).
// Idea    A set is what one end releases whole: a layer, or with watermarks a window or a part of it. Two sets of
//         buckets take turns. A mark waits in a queue until su_buckets has released what lies before it, and collecting
//         goes on. When the pool is full and nothing of it is on its way out, the present set goes to external memory,
//         with all that comes until the next mark, whatever it releases: then what lies before it is sorted and sent.
//         What is left returns to the pool as if it came in, or stays in memory with what comes until the mark after.
// Stream  in: splats, then an end beat. insert: slot and bucket; record: a splat for external memory; mark: an end.
// Pace    One splat per two cycles; spilling: as fast as su_spill takes them.
// Model   Plumbing; the whole SU is tested against cpp_model/su/su.hpp.

module su_collect (
  input  logic                           clk_i,
  input  logic                           rst_ni,

  input  logic                           in_valid_i,
  output logic                           in_ready_o,
  input  logic [pipegs_pkg::KindW-1:0]   in_kind_i,
  input  logic [pipegs_pkg::BucketW-1:0] in_bucket_i,

  input  logic                           slot_valid_i,
  output logic                           insert_valid_o,  // the splat goes to the slot and to its bucket
  input  logic                           insert_ready_i,
  output logic                           set_o,
  output logic                           write_o,         // insert_valid_o and taken

  output logic                           record_valid_o,
  input  logic                           record_ready_i,

  output logic                           mark_valid_o,
  input  logic                           mark_ready_i,
  output logic                           mark_all_o,      // releases everything before it
  output logic                           spilled_o,       // the mark is one of the set that spills

  input  logic                           released_i,      // a set was released whole
  input  logic                           released_set_i,
  input  logic                           full_i,          // no slot is free
  input  logic                           drained_i,       // nothing that was released is left inside
  output logic                           spill_start_o,
  output logic                           spilling_o,
  output logic                           ended_o,         // the mark that ends the spill was taken
  input  logic                           stay_i,          // it was sent, and the set goes on spilling
  input  logic                           returns_i,       // ... what is left comes in
  input  logic                           spill_done_i,    // ... nothing is left in memory

  output logic                           active_o
);


  typedef enum logic [1:0] {
    Collect,  // waits for splats and ends
    Spill,    // the same; they go to external memory
    Sort      // waits until what lies before the mark was sent, and what is left has come in
  } state_e;
  state_e state_q;

  logic       set_q, take, data, open, stuck, lost;
  logic [1:0] closed_q;  // the set has ended and is not yet released whole

  assign data  = in_kind_i == pipegs_pkg::KindData;
  assign open  = (state_q == Collect && !closed_q[set_q]) || returns_i;
  assign take  = in_valid_i && in_ready_o;
  assign stuck = in_valid_i && open && data && full_i && !returns_i;
  // only memory has room; without it an assertion needs the clock
  assign lost  = stuck && drained_i;
  assign spill_start_o = pipegs_pkg::Overflow != 0 && lost;

  assign insert_valid_o = in_valid_i && open && data && slot_valid_i;
  assign record_valid_o = in_valid_i && state_q == Spill && data;
  assign mark_valid_o   = in_valid_i && (open || state_q == Spill) && !data;
  assign write_o        = insert_valid_o && insert_ready_i;
  assign in_ready_o     = data ? (open && slot_valid_i && insert_ready_i) || (state_q == Spill && record_ready_i)
                               : (open || state_q == Spill) && mark_ready_i;
  assign mark_all_o     = !pipegs_pkg::HasWatermarks || in_kind_i != pipegs_pkg::KindLayerEnd;
  assign set_o          = set_q;
  assign spilled_o      = state_q == Spill;
  assign spilling_o     = state_q == Spill;
  assign ended_o        = state_q == Sort;
  assign active_o       = take || lost || released_i || stay_i || spill_done_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q  <= Collect;
      set_q    <= 1'b0;
      closed_q <= '0;
    end else begin
      unique case (state_q)
        Collect: if (spill_start_o) state_q <= Spill;
        Spill:   if (take && !data) state_q <= Sort;
        default: if (stay_i || spill_done_i) state_q <= stay_i ? Spill : Collect;
      endcase
      if (released_i) closed_q[released_set_i] <= 1'b0;
      if (take && !data && mark_all_o && state_q == Collect) begin
        closed_q[set_q] <= 1'b1;
        set_q           <= !set_q;
      end
    end
  end

`ifndef SYNTHESIS
  // Watermarks of the present window so far; the queue of marks holds those of two windows.
  logic [$clog2(pipegs_pkg::WindowMarks+1)-1:0] marks_q;
  logic [pipegs_pkg::BucketW-1:0] mark_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      marks_q <= '0;
      mark_q  <= '0;
    end else if (take && !data) begin
      marks_q <= mark_all_o ? '0 : marks_q + 1'b1;
      mark_q  <= mark_all_o ? '0 : in_bucket_i;
    end
  end
  always_ff @(posedge clk_i) if (rst_ni) assert (!(take && !data && !mark_all_o) || marks_q != '1);
  always_ff @(posedge clk_i) if (rst_ni) assert (!(take && data) || in_bucket_i >= mark_q);
  always_ff @(posedge clk_i) if (rst_ni) assert (pipegs_pkg::Overflow != 0 || !lost)
    else $error("su_collect: the records of a set do not fit, and Overflow is 0");
  pipegs_stream_check #(.DataW($bits(set_o))) u_check_insert (
    .clk_i,
    .rst_ni,
    .valid_i(insert_valid_o),
    .ready_i(insert_ready_i),
    .beat_i(set_o)
  );
  pipegs_stream_check #(.DataW($bits({mark_all_o, spilled_o}))) u_check_mark (
    .clk_i,
    .rst_ni,
    .valid_i(mark_valid_o),
    .ready_i(mark_ready_i),
    .beat_i({mark_all_o, spilled_o})
  );
  pipegs_stream_check u_check_record (
    .clk_i,
    .rst_ni,
    .valid_i(record_valid_o),
    .ready_i(record_ready_i),
    .beat_i(1'b0)
  );
`else
  logic unused_bucket;
  assign unused_bucket = &{1'b0, in_bucket_i};
`endif

endmodule
