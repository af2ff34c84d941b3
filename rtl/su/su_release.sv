// SPDX-License-Identifier: Apache-2.0
// su_release: ends in order, each of which releases the buckets before it as chains that wait for the splitter.
//
// Paper   Sec. 4.1 (overlap of layers), Sec. 4.2.2.
// Idea    A mark is an end that waits until su_buckets has released what lies before it; of a set that spilled nothing
//         is released here, its marks go out with the keys that come back (head_*). Wiring and two queues.
// Stream  slots of collected records and marks in; chains {kind, bucket, first slot, count} out, the end behind them.
// Pace    su_buckets'.
// Model   cpp_model/su/su.hpp

module su_release #(
  localparam int unsigned KindW   = pipegs_pkg::KindW,
  localparam int unsigned BucketW = pipegs_pkg::BucketW,
  localparam int unsigned RecordW = pipegs_pkg::RecordW
) (
  input  logic               clk_i,
  input  logic               rst_ni,

  input  logic               insert_valid_i,  // a record has its slot
  output logic               insert_ready_o,
  input  logic               set_i,
  input  logic [BucketW-1:0] bucket_i,         // of what comes in
  input  logic [BucketW-1:0] insert_bucket_i,  // of the record
  input  logic [RecordW-1:0] slot_i,

  input  logic               mark_valid_i,  // an end, of this set and before this bucket
  output logic               mark_ready_o,
  input  logic               mark_all_i,
  input  logic               mark_spills_i,
  input  logic [KindW-1:0]   mark_kind_i,

  input  logic               spill_job_i,  // su_spill takes all of the present set
  output logic               job_done_o,
  output logic               released_o,  // the set of the mark in front is released
  output logic               released_set_o,

  output logic               head_valid_o,  // the mark in front
  output pipegs_pkg::su_mark_t head_o,
  input  logic               head_first_i,  // of a set that spilled: it goes before the next key
  input  logic               head_ready_i,

  output logic               chain_valid_o,
  input  logic               chain_ready_i,
  output pipegs_pkg::su_chain_t chain_o,
  input  logic               split_idle_i,

  output logic               link_o,  // to the store of links
  input  logic               link_ready_i,
  output logic [RecordW-1:0] link_slot_o,
  output logic [RecordW-1:0] link_to_o,

  output logic               settled_o,  // nothing here waits to be released or split
  output logic               moves_o
);

  localparam int unsigned Marks  = pipegs_pkg::SuMarks;
  localparam int unsigned Chains = pipegs_pkg::SuChains;

  logic                        head_set, head_all, head_spills, waits, released, released_room, buckets_active;
  logic [KindW-1:0]            head_kind, released_kind;
  logic [RecordW-1:0]          released_head;
  logic [RecordW:0]            released_count;
  logic [BucketW-1:0]          head_bucket, released_bucket;
  logic [$clog2(Marks+1)-1:0]  marks;
  logic [$clog2(Chains+1)-1:0] chains;

  // The bucket of the mark in front decides late in a cycle what comes in: it stands in registers.
  logic                     next_valid, next_ready, head_valid_q;
  logic [3+KindW+BucketW-1:0] next, head_q;
  pipegs_sram_fifo #(.DataW(3 + KindW + BucketW), .Depth(Marks)) u_marks (
    .clk_i,
    .rst_ni,
    .in_valid_i(mark_valid_i),
    .in_ready_o(mark_ready_o),
    .in_i({set_i, mark_all_i, mark_spills_i, mark_kind_i, bucket_i}),
    .out_valid_o(next_valid),
    .out_ready_i(next_ready),
    .out_o(next),
    .count_o(marks)
  );
  assign next_ready   = !head_valid_q || (head_first_i ? head_ready_i : job_done_o && !spill_job_i);
  assign head_valid_o = head_valid_q;
  assign {head_set, head_all, head_spills, head_kind, head_bucket} = head_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) head_valid_q <= 1'b0;
    else if (next_ready) head_valid_q <= next_valid;
  end
  always_ff @(posedge clk_i) if (next_ready) head_q <= next;

  assign head_o = {head_all, head_kind, head_bucket};
  assign waits  = head_valid_o && !head_spills;

  su_buckets u_buckets (
    .clk_i,
    .rst_ni,
    .insert_valid_i,
    .insert_ready_o,
    .insert_set_i(set_i),
    .insert_bucket_i,
    .arrives_bucket_i(bucket_i),
    .insert_slot_i(slot_i),
    .job_valid_i(spill_job_i || waits),
    .job_done_o,
    .job_set_i(spill_job_i ? set_i : head_set),
    .job_all_i(spill_job_i || head_all),
    .job_bucket_i(head_bucket),
    .job_kind_i(spill_job_i ? pipegs_pkg::KindData : head_kind),
    .chain_push_o(released),
    .chain_room_i(released_room),
    .chain_kind_o(released_kind),
    .chain_head_o(released_head),
    .chain_count_o(released_count),
    .chain_bucket_o(released_bucket),
    .hungry_i(chains == '0 && split_idle_i),
    .link_write_o(link_o),
    .link_ready_i,
    .link_slot_o,
    .link_o(link_to_o),
    .active_o(buckets_active)
  );

  pipegs_sram_fifo #(.DataW(KindW + BucketW + RecordW + RecordW + 1), .Depth(Chains)) u_chains (
    .clk_i,
    .rst_ni,
    .in_valid_i(released),
    .in_ready_o(released_room),
    .in_i({released_kind, released_bucket, released_head, released_count}),
    .out_valid_o(chain_valid_o),
    .out_ready_i(chain_ready_i),
    .out_o(chain_o),
    .count_o(chains)
  );

  assign released_o     = job_done_o && !spill_job_i && head_all;
  assign released_set_o = head_set;
  assign settled_o      = !waits && (marks == '0 || head_valid_o) && chains == '0;
  assign moves_o        = buckets_active || (chains != '0 && !chain_valid_o) || (marks != '0 && !head_valid_o);

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits(head_o))) u_check_head (
    .clk_i,
    .rst_ni,
    .valid_i(head_valid_o),
    .ready_i(next_ready),
    .beat_i(head_o)
  );
`endif

endmodule
