// SPDX-License-Identifier: Apache-2.0
// su_gather: a splat gets a slot and goes into its bucket of depth; an end turns the buckets before it into chains.
//
// Paper   Sec. 4.1 (layer i + 1 is collected while layer i is sorted), Sec. 4.2.2.
// Idea    pipegs_skid -> su_collect (slots from pipegs_slot_pool) -> su_release. Whether there is room hangs on most of
//         the unit: the register in front keeps the PU from waiting for that within the cycle. Only wiring here.
// Stream  in: splats and ends. write: the record to store. chain: to the splitter. mark: the end in front of the queue,
//         which su_output takes out where it is of a set that spilled.
// Pace    One splat per two cycles.
// Model   cpp_model/su/su.hpp

module su_gather #(
  localparam int unsigned BucketW = pipegs_pkg::BucketW,
  localparam int unsigned RecordW = pipegs_pkg::RecordW
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  input  logic [pipegs_pkg::ExpW-1:0] octave_i,  // in which the buckets of depth begin

  input  logic                  in_valid_i,
  output logic                  in_ready_o,
  input  pipegs_pkg::splat_t    in_i,

  output logic                  write_o,    // the record gets this slot
  output logic [RecordW-1:0]    slot_o,
  output pipegs_pkg::splat_t    record_o,
  input  logic                  free_i,     // a slot comes back
  input  logic [RecordW-1:0]    free_slot_i,
  output logic                  empty_o,    // none is taken

  output logic                  chain_valid_o,
  input  logic                  chain_ready_i,
  output pipegs_pkg::su_chain_t chain_o,
  input  logic                  split_idle_i,
  output logic                  link_o,     // to the store of links
  input  logic                  link_ready_i,
  output logic [RecordW-1:0]    link_slot_o,
  output logic [RecordW-1:0]    link_to_o,

  output logic                  mark_valid_o,
  output pipegs_pkg::su_mark_t  mark_o,
  input  logic                  mark_first_i,  // of a set that spilled: it goes before the next key
  input  logic                  mark_ready_i,

  output logic                  spilling_o,
  output logic                  spill_start_o,  // the present set spills
  output logic                  spill_valid_o,  // record_o goes to memory
  input  logic                  spill_ready_i,
  output logic                  spill_ended_o,
  input  logic                  spill_stay_i,   // its mark has left; the set goes on spilling ...
  input  logic                  renew_i,        // ... or what is left of it will take slots from 0 on ...
  input  logic                  returns_i,      // ... and comes back instead of what comes in ...
  input  logic                  back_valid_i,
  output logic                  back_ready_o,
  input  pipegs_pkg::splat_t    back_i,
  input  logic                  spill_done_i,   // ... or nothing of it is in memory
  input  logic                  job_valid_i,    // all that was collected of it is to be released
  output logic                  job_done_o,
  input  logic                  drained_i,      // nothing that was released is left inside

  output logic                  settled_o,      // nothing here waits to be released or split
  output logic                  moves_o
);

  logic               in_valid, valid, ready, slot_valid, pool_active, collect_active, release_moves;
  pipegs_pkg::splat_t in;
  logic [RecordW:0]   used;
  logic [BucketW-1:0] bucket, back_bucket, insert_bucket;  // of what comes in, of what returns, of the record
  logic [pipegs_pkg::KindW-1:0] kind;
  logic               insert_valid, insert_ready, set, mark_push, mark_room, mark_all, mark_spills;
  logic               released, released_set;

  pipegs_skid #(.DataW(pipegs_pkg::SplatBits)) u_in (
    .clk_i,
    .rst_ni,
    .in_valid_i,
    .in_ready_o,
    .in_i,
    .out_valid_o(in_valid),
    .out_ready_i(ready && !returns_i),
    .out_o(in)
  );
  assign valid        = returns_i ? back_valid_i : in_valid;
  assign record_o     = returns_i ? back_i : in;
  assign back_ready_o = returns_i && ready;
  // What returns has come a long way in its cycle. It is never an end and meets no job of the buckets, so neither its
  // kind nor its bucket has a say in whether it is taken.
  assign kind = returns_i ? pipegs_pkg::KindData : in.kind;
  su_bucket u_bucket (
    .octave_i,
    .depth_i(in.depth),
    .bucket_o(bucket)
  );
  su_bucket u_back_bucket (
    .octave_i,
    .depth_i(back_i.depth),
    .bucket_o(back_bucket)
  );
  assign insert_bucket = returns_i ? back_bucket : bucket;

  // A slot comes back when its record is taken from all SUs' nearest: a register ends that path.
  logic               free_q;
  logic [RecordW-1:0] free_slot_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) free_q <= 1'b0;
    else free_q <= free_i;
  end
  always_ff @(posedge clk_i) free_slot_q <= free_slot_i;

  pipegs_slot_pool #(.Slots(pipegs_pkg::Records)) u_slots (
    .clk_i,
    .rst_ni,
    .renew_i,
    .slot_valid_o(slot_valid),
    .slot_ready_i(write_o),
    .slot_o,
    .free_i(free_q),
    .free_slot_i(free_slot_q),
    .used_o(used),
    .active_o(pool_active)
  );
  assign empty_o = used == '0;

  su_collect u_collect (
    .clk_i,
    .rst_ni,
    .in_valid_i(valid),
    .in_ready_o(ready),
    .in_kind_i(kind),
    .in_bucket_i(insert_bucket),
    .slot_valid_i(slot_valid),
    .insert_valid_o(insert_valid),
    .insert_ready_i(insert_ready),
    .set_o(set),
    .write_o,
    .record_valid_o(spill_valid_o),
    .record_ready_i(spill_ready_i),
    .mark_valid_o(mark_push),
    .mark_ready_i(mark_room),
    .mark_all_o(mark_all),
    .spilled_o(mark_spills),
    .released_i(released),
    .released_set_i(released_set),
    .full_i(used == (RecordW+1)'(pipegs_pkg::Records)),
    .drained_i,
    .spill_start_o,
    .spilling_o,
    .ended_o(spill_ended_o),
    .stay_i(spill_stay_i),
    .returns_i,
    .spill_done_i,
    .active_o(collect_active)
  );

  su_release u_release (
    .clk_i,
    .rst_ni,
    .insert_valid_i(insert_valid),
    .insert_ready_o(insert_ready),
    .set_i(set),
    .bucket_i(bucket),
    .insert_bucket_i(insert_bucket),
    .slot_i(slot_o),
    .mark_valid_i(mark_push),
    .mark_ready_o(mark_room),
    .mark_all_i(mark_all),
    .mark_spills_i(mark_spills),
    .mark_kind_i(in.kind),
    .spill_job_i(job_valid_i),
    .job_done_o,
    .released_o(released),
    .released_set_o(released_set),
    .head_valid_o(mark_valid_o),
    .head_o(mark_o),
    .head_first_i(mark_first_i),
    .head_ready_i(mark_ready_i),
    .chain_valid_o,
    .chain_ready_i,
    .chain_o,
    .split_idle_i,
    .link_o,
    .link_ready_i,
    .link_slot_o,
    .link_to_o,
    .settled_o,
    .moves_o(release_moves)
  );

  assign moves_o = collect_active || pool_active || release_moves;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!(returns_i && back_valid_i) || back_i.kind == pipegs_pkg::KindData);
  always_ff @(posedge clk_i) if (rst_ni) assert (!mark_push || mark_room || !pipegs_pkg::HasWatermarks);
`endif

endmodule
