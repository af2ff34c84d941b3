// SPDX-License-Identifier: Apache-2.0
// su_split: cuts a set of keys into groups of at most sixteen, nearest group first.
//
// Paper   Sec. 4.2.2, "Pivot-based Splitter".
// Idea    The pivots divide min..max into sixteen equal parts: bucket = (key - min) >> shift, four bits. Keys stay
//         where they lie; a bucket is a chain of slots (head, links), so a pass costs one cycle per key. Neighbouring
//         buckets are chained together while they hold at most sixteen keys. The nearest group is gone on with, the
//         farther ones wait on a stack, the nearest on top; a group that is still too large is cut again by the next
//         four bits. When all keys fell into one bucket, the range is measured again, so a far outlier costs one pass.
//         LargeGroups 0: every chain is small enough; nothing is cut.
// Stream  start_i with a chain of keys (at least 1) and a range that holds them; keys and links are read from their
//         stores, rdata in the next cycle, held; links are changed. out: keys and slots, `last` on the last of each
//         group.
// Pace    One cycle per key and pass, up to 19 more per pass; one key per cycle out. A chain that is small enough
//         leaves as it is: two cycles and one per key.
// Model   cpp_model/su/sort/su_split.hpp

module su_split (
  input  logic                           clk_i,
  input  logic                           rst_ni,

  input  logic                           start_i,
  input  logic [pipegs_pkg::RecordW-1:0] head_i,
  input  logic [pipegs_pkg::RecordW:0]   count_i,
  input  logic [pipegs_pkg::KeyW-1:0]    min_i,
  input  logic [pipegs_pkg::KeyW-1:0]    max_i,
  output logic                           idle_o,
  output logic                           active_o,

  output logic                           key_read_o,    // of a key and of its link
  output logic [pipegs_pkg::RecordW-1:0] key_slot_o,
  input  logic [pipegs_pkg::KeyW-1:0]    key_i,
  input  logic [pipegs_pkg::RecordW-1:0] link_i,        // the slot behind it in its chain
  output logic                           link_claim_o,  // a link may be written in this cycle: others wait
  output logic                           link_write_o,  // with link_claim_o only
  output logic [pipegs_pkg::RecordW-1:0] link_slot_o,
  output logic [pipegs_pkg::RecordW-1:0] link_o,

  output logic                           out_valid_o,
  input  logic                           out_ready_i,
  output logic                           out_last_o,
  output logic [pipegs_pkg::KeyW-1:0]    out_key_o,
  output logic [pipegs_pkg::RecordW-1:0] out_slot_o
);

  localparam int unsigned KeyW = pipegs_pkg::KeyW;
  localparam int unsigned RecordW = pipegs_pkg::RecordW;
  localparam int unsigned ShiftW = $clog2(KeyW);
  localparam bit Cuts = pipegs_pkg::LargeGroups != 0;
  localparam int unsigned Group = 16;    // most keys of a group
  localparam int unsigned Buckets = 16;
  localparam int unsigned BucketW = $clog2(Buckets);
  localparam int unsigned EntryW = 2 * RecordW + RecordW + 1;  // {tail, head, count}
  localparam int unsigned FrameW = RecordW + RecordW + 1 + ShiftW;  // {head, count, shift}
  // Two neighbours on the stack hold more than Group keys together, except at the border of two levels.
  localparam int unsigned StackDepth = pipegs_pkg::Records / 8 + KeyW / BucketW + 2;
  localparam int unsigned StackW = $clog2(StackDepth + 1);

  typedef enum logic [2:0] {
    Idle,     // waits for start_i
    Measure,  // the range is known: picks the shift
    Walk,     // reads the group's keys and drops them into buckets
    Gather,   // joins small buckets from far to near and stacks the groups
    Load,     // sends a small group out
    Take      // takes the next group from the stack
  } state_e;
  state_e state_q;

  logic [RecordW-1:0]  head_q;
  logic [RecordW:0]    count_q;
  logic              go;         // a group stands in head_q, count_q: begin with it
  logic [RecordW:0]    go_count;
  logic              fits;

  // Walking along the keys of the group, for Walk and Load.
  logic              first_q, data_valid_q, step, read;
  logic [RecordW-1:0]  slot_q, slot;
  logic [RecordW:0]    left_q;  // keys still to read

  assign step = !data_valid_q || (state_q == Walk) || out_ready_i;
  assign read = (state_q == Walk || state_q == Load) && step && left_q != '0;
  assign slot = first_q ? head_q : link_i;
  assign key_read_o  = read;
  assign key_slot_o  = slot;
  assign out_valid_o = state_q == Load && data_valid_q;
  assign out_last_o  = left_q == '0;
  assign out_key_o   = key_i;
  assign out_slot_o  = slot_q;

  // What the cutting tells: the next group, from the buckets or from the stack.
  logic              dropping;    // a key is on its way into its bucket
  logic              gather;      // a bucket is joined or begins a group
  logic              gathered;    // no bucket is left
  logic              several;     // not all keys were in one
  logic              join_near;   // the bucket joins the group in head_q, count_q
  logic              stacked;     // farther groups wait
  logic [RecordW-1:0]  head, frame_head;
  logic [RecordW:0]    count, frame_count;

  if (Cuts) begin : gen_cut
    logic [KeyW-1:0]   min_q, range_q;  // range: max - min, or the bits in which the keys of the group differ
    logic [ShiftW-1:0] shift_q, wide_shift, next_shift;

    // Dropping a key into its bucket, one cycle after it was read.
    logic [KeyW-1:0]    offset_q, first_offset_q;  // key - min
    logic [RecordW-1:0]   drop_slot_q;
    logic               drop_q, dropped_q;  // dropped_q: not the first key of the group
    logic [EntryW-1:0]  table_q [Buckets];
    logic [Buckets-1:0] filled_q;
    logic [BucketW-1:0] bucket, far;
    logic [BucketW:0]   far_length;
    logic [EntryW-1:0]  entry;
    logic [RecordW-1:0]   tail;
    logic               filled, push, gathered_q, several_q;

    assign bucket = state_q == Gather ? far : BucketW'(offset_q >> shift_q);
    assign entry  = table_q[bucket];
    assign filled = filled_q[bucket];
    assign {tail, head, count} = entry;
    pipegs_bit_length #(.DataW(Buckets)) u_far (
      .in_i(filled_q),
      .length_o(far_length)
    );
    assign far       = BucketW'(far_length - 1'b1);  // read only while one is filled
    assign dropping  = drop_q;
    assign gather    = state_q == Gather && filled_q != '0;
    assign gathered  = filled_q == '0;
    assign several   = several_q;
    assign join_near = gathered_q && {1'b0, count} + {1'b0, count_q} <= (RecordW+2)'(Group);
    assign push      = gather && gathered_q && !join_near;

    assign link_claim_o = drop_q || gather;
    assign link_write_o = drop_q || (gather && join_near);
    assign link_slot_o  = drop_q ? drop_slot_q : tail;
    assign link_o       = drop_q ? head : head_q;

    // The stack of farther groups.
    logic [StackW-1:0] depth_q;
    logic [FrameW-1:0] frame;
    logic [ShiftW-1:0] frame_shift;
    logic              pop;
    assign pop     = out_valid_o && out_ready_i && out_last_o && stacked;
    assign stacked = depth_q != '0;
    assign {frame_head, frame_count, frame_shift} = frame;

    pipegs_sram #(.DataW(FrameW), .Depth(2 ** StackW), .Ports(1)) u_stack (
      .clk_i,
      .write_i(push),
      .waddr_i(depth_q),
      .wdata_i({head_q, count_q, next_shift}),
      .read_i(pop),
      .raddr_i(depth_q - 1'b1),
      .rdata_o(frame)
    );

    // The next four bits; after measuring, the four bits below the leading one.
    assign next_shift = shift_q > ShiftW'(BucketW) ? shift_q - ShiftW'(BucketW) : '0;
    logic [$clog2(KeyW-BucketW+1)-1:0] wide_length;
    pipegs_bit_length #(.DataW(KeyW - BucketW)) u_wide (
      .in_i(range_q[KeyW-1:BucketW]),
      .length_o(wide_length)
    );
    assign wide_shift = ShiftW'(wide_length);

    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) begin
        drop_q  <= 1'b0;
        depth_q <= '0;
      end else begin
        drop_q <= state_q == Walk && data_valid_q;
        if (push) depth_q <= depth_q + 1'b1;
        if (pop) depth_q <= depth_q - 1'b1;
      end
    end

    always_ff @(posedge clk_i) begin
      if (start_i && state_q == Idle) begin
        min_q   <= min_i;
        range_q <= max_i - min_i;
      end
      if (state_q == Measure) shift_q <= wide_shift;
      if (state_q == Take) shift_q <= frame_shift;
      if (state_q == Gather && gathered && several) shift_q <= next_shift;

      if (go) begin
        filled_q   <= '0;
        dropped_q  <= 1'b0;
        gathered_q <= 1'b0;
        several_q  <= 1'b0;
      end
      if (state_q == Walk && data_valid_q) begin
        offset_q    <= key_i - min_q;
        drop_slot_q <= slot_q;
      end
      if (drop_q) begin
        table_q[bucket]  <= {filled ? tail : drop_slot_q, drop_slot_q, filled ? count + 1'b1 : (RecordW+1)'(1)};
        filled_q[bucket] <= 1'b1;
        dropped_q        <= 1'b1;
        if (!dropped_q) first_offset_q <= offset_q;
        range_q <= dropped_q ? range_q | (offset_q ^ first_offset_q) : '0;
      end
      if (gather) begin
        filled_q[far] <= 1'b0;
        gathered_q    <= 1'b1;
        several_q     <= gathered_q;
      end
    end

`ifndef SYNTHESIS
    always_ff @(posedge clk_i) if (rst_ni) assert (!push || depth_q < StackW'(StackDepth));
`endif
  end else begin : gen_whole
    assign {dropping, gather, several, join_near, stacked, link_claim_o, link_write_o} = '0;
    assign gathered = 1'b1;
    assign {head, frame_head, link_slot_o, link_o} = '0;
    assign {count, frame_count} = '0;
    logic unused_range;
    assign unused_range = &{1'b0, min_i, max_i};

`ifndef SYNTHESIS
    always_ff @(posedge clk_i) if (rst_ni) assert (!start_i || count_i <= (RecordW+1)'(Group))
      else $error("su_split: a chain of more than sixteen keys, and LargeGroups is 0");
`endif
  end

  always_comb begin
    go_count = state_q == Idle ? count_i : state_q == Take ? frame_count : count_q;
    fits = !Cuts || go_count <= (RecordW+1)'(Group);
    go = (state_q == Idle && start_i && fits) || (Cuts && (state_q == Measure || state_q == Take ||
         (state_q == Gather && gathered && several)));
  end
  assign idle_o   = state_q == Idle;
  assign active_o = start_i || (state_q != Idle && !(out_valid_o && !out_ready_i));

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q      <= Idle;
      data_valid_q <= 1'b0;
    end else begin
      unique case (state_q)
        Idle:    if (start_i) state_q <= Measure;
        Walk:    if (left_q == '0 && !data_valid_q && !dropping) state_q <= Gather;
        Gather:  if (gathered) state_q <= Measure;
        Load:    if (out_valid_o && out_ready_i && out_last_o) state_q <= stacked ? Take : Idle;
        default: ;
      endcase
      if (go) state_q <= fits ? Load : Walk;
      if (read) data_valid_q <= 1'b1;
      else if (step) data_valid_q <= 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (start_i && state_q == Idle) begin
      head_q  <= head_i;
      count_q <= count_i;
    end
    if (state_q == Take) begin
      head_q  <= frame_head;
      count_q <= frame_count;
    end
    // head_q and count_q collect the group that the gathering is at.
    if (gather) begin
      head_q  <= head;
      count_q <= join_near ? count_q + count : count;
    end

    if (go) begin
      left_q  <= go_count;
      first_q <= 1'b1;
    end
    if (read) begin
      slot_q  <= slot;
      left_q  <= left_q - 1'b1;
      first_q <= 1'b0;
    end
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!start_i || (state_q == Idle && count_i != '0));
  pipegs_stream_check #(.DataW($bits({out_last_o, out_key_o, out_slot_o}))) u_check_out (
    .clk_i,
    .rst_ni,
    .valid_i(out_valid_o),
    .ready_i(out_ready_i),
    .beat_i({out_last_o, out_key_o, out_slot_o})
  );
`endif

endmodule
