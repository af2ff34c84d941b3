// SPDX-License-Identifier: Apache-2.0
// dopu_send: decides what goes to the PUs next: the nearest chunk, a watermark, or the window's end.
//
// Paper   None.
// Idea    The watermark is the nearest bucket of all that can still come: chunks that wait, and what is not opened yet.
//         A chunk is due when it lies in that bucket. A watermark is sent when it has risen and MarkChunks chunks have
//         gone since the last one, twice as many after every eighth of those that a window may have. With everything
//         opened and no chunk left, the window ends, and the other set's turn begins. When the queue is full a chunk
//         that finds no place goes ahead of its turn, or a nearer one that waits does.
// Stream  first: the nearest waiting chunks of both sets; pop asks for one of the set sent, popped brings it. direct: a
//         chunk that found no place. out: chunk, LayerEnd with its watermark, WindowEnd.
// Pace    One chunk in five cycles.
// Model   cpp_model/dopu/nearest/dopu_nearest.hpp

module dopu_send #(
  localparam int unsigned BucketW = pipegs_pkg::BucketW,
  localparam int unsigned StepW = pipegs_pkg::StepW,
  localparam int unsigned DepthW = pipegs_pkg::DepthW,
  localparam int unsigned DataW = pipegs_pkg::NodePlaceW + pipegs_pkg::CountW + pipegs_pkg::SlotW
) (
  input  logic                          clk_i,
  input  logic                          rst_ni,

  input  logic [StepW-1:0]              near_step_i,
  input  logic [1:0]                    set_done_i,
  output logic                          set_o,           // the set sent
  input  logic                          opened_i,        // all of it is opened: only chunks wait
  input  logic [4*BucketW-1:0]          unopened_i,      // else: buckets of what is not, the nearest one among them
  output logic                          window_end_o,    // its end is on its way: the other set's turn

  input  logic [1:0]                    first_valid_i,
  input  logic [2*BucketW-1:0]          first_bucket_i,
  output logic                          pop_o,
  input  logic                          pop_ready_i,
  input  logic                          popped_i,
  input  logic [DataW-1:0]              popped_data_i,   // count, first, scale_exp, offset_exp, centre z, y, x

  input  logic                          direct_valid_i,  // of the set sent
  output logic                          direct_ready_o,
  input  logic [BucketW-1:0]            direct_bucket_i,
  input  logic [DataW-1:0]              direct_data_i,

  output logic                          chunk_valid_o,
  input  logic                          chunk_ready_i,
  output logic [pipegs_pkg::KindW-1:0]  chunk_kind_o,
  output logic                          chunk_set_o,
  output pipegs_pkg::node_t             chunk_o,
  // of a LayerEnd: every later chunk's depth keys are not smaller; else 0
  output logic [DepthW-1:0]             mark_o
);

  localparam int unsigned MarkChunks = pipegs_pkg::MarkChunks;
  localparam int unsigned MarksW = $clog2(pipegs_pkg::WindowMarks + 1);
  localparam int unsigned SinceW = $clog2(MarkChunks + 1) + 7;

  logic                         set_q, popping_q, valid_q, chunk_set_q;
  logic                         shown_q;  // the output was shown and not taken: it stays, even if its window is done
  logic [pipegs_pkg::KindW-1:0] kind_q;
  localparam int unsigned CenterW = pipegs_pkg::NodePlaceW - pipegs_pkg::ScaleExpW;  // of a node, and offset_exp
  logic [DataW-1:0]             data_q;
  logic [SinceW-1:0]            since_q;  // chunks since the last watermark
  logic [BucketW-1:0]           mark_q;   // the last watermark of the window
  logic [MarksW-1:0]            marks_q;  // watermarks of the window so far

  logic               done, has_first, idle, end_due, mark_due, chunk_due, dropped, load_popped, load_direct;
  logic               is_lowest;  // nothing unopened is nearer than the nearest chunk
  logic               risen;      // all that can still come lies behind the last watermark
  logic [BucketW-1:0] first, lowest;
  logic [StepW-1:0]   step;
  logic [SinceW-1:0]  apart;  // chunks between watermarks: doubled up to seven times

  assign done      = set_done_i[set_q];
  assign has_first = first_valid_i[set_q];
  assign first     = first_bucket_i[32'(set_q)*BucketW +: BucketW];
  assign idle      = !valid_q && !popping_q;

  // What is due is decided by comparing each bucket alone; their minimum, a tree, is the watermark's alone.
  function automatic logic [BucketW-1:0] nearer(input logic [BucketW-1:0] a, input logic [BucketW-1:0] b);
    nearer = a < b ? a : b;
  endfunction
  typedef struct packed {logic [3:0][BucketW-1:0] of;} buckets_t;
  buckets_t closed;  // of what is not opened yet
  assign closed = unopened_i | {4 * BucketW{opened_i}};
  always_comb begin
    is_lowest = 1'b1;
    risen     = !has_first || first > mark_q;
    for (int unsigned i = 0; i < 4; i += 1) begin
      if (!opened_i && closed.of[i] < first) is_lowest = 1'b0;
      if (!opened_i && closed.of[i] <= mark_q) risen = 1'b0;
    end
    lowest = nearer(nearer(closed.of[0], closed.of[1]), nearer(closed.of[2], closed.of[3]));
    lowest = nearer(lowest, first | {BucketW{!has_first}});
  end
  assign end_due   = idle && opened_i && !has_first;
  assign apart     = SinceW'(MarkChunks) << marks_q[MarksW-1:MarksW-3];
  assign mark_due  = idle && !done && !end_due && since_q >= apart && risen &&
                     marks_q != MarksW'(pipegs_pkg::WindowMarks);
  // What waits behind a full queue lets the nearest chunk go early when that one is nearer.
  assign chunk_due = is_lowest || (direct_valid_i && first <= direct_bucket_i);
  assign pop_o     = has_first && (done ? !popping_q : idle && !mark_due && chunk_due);
  assign direct_ready_o = idle && !done && !mark_due && !pop_o;
  assign load_popped    = popped_i && !done;
  assign load_direct    = direct_valid_i && direct_ready_o;
  assign dropped        = kind_q != pipegs_pkg::KindWindowEnd && set_done_i[chunk_set_q] && !shown_q;
  assign window_end_o   = end_due;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      set_q     <= 1'b0;
      popping_q <= 1'b0;
      valid_q   <= 1'b0;
      shown_q   <= 1'b0;
      since_q   <= '0;
      mark_q    <= '0;
      marks_q   <= '0;
    end else begin
      if (popped_i) popping_q <= 1'b0;
      else if (pop_o && pop_ready_i) popping_q <= 1'b1;
      if (load_popped || load_direct || mark_due || end_due) valid_q <= 1'b1;
      else if (chunk_ready_i || dropped) valid_q <= 1'b0;
      shown_q <= chunk_valid_o && !chunk_ready_i;
      if (end_due || mark_due) since_q <= '0;
      else if ((load_popped || load_direct) && since_q != '1) since_q <= since_q + 1'b1;
      if (end_due) mark_q <= '0;
      else if (mark_due) mark_q <= lowest;
      if (end_due) marks_q <= '0;
      else if (mark_due) marks_q <= marks_q + 1'b1;
      if (end_due) set_q <= !set_q;
    end
  end

  always_ff @(posedge clk_i) begin
    if (idle || load_popped) begin
      kind_q      <= end_due ? pipegs_pkg::KindWindowEnd : mark_due ? pipegs_pkg::KindLayerEnd : pipegs_pkg::KindData;
      chunk_set_q <= set_q;
      data_q      <= popped_i ? popped_data_i : direct_data_i;
    end
  end

  assign set_o         = set_q;
  assign chunk_valid_o = valid_q && !dropped;
  assign chunk_kind_o  = kind_q;
  assign chunk_set_o   = chunk_set_q;
  assign step          = near_step_i + StepW'(mark_q);
  assign mark_o        = kind_q == pipegs_pkg::KindLayerEnd ? {step, {(DepthW - StepW){1'b0}}} : '0;
  always_comb begin
    chunk_o = '0;
    {chunk_o.count, chunk_o.first} = data_q[DataW-1:pipegs_pkg::NodePlaceW];
    {chunk_o.offset_exp, chunk_o.center_z, chunk_o.center_y, chunk_o.center_x} = data_q[0 +: CenterW];
    if (pipegs_pkg::Coded) begin
      chunk_o.scale_max[pipegs_pkg::ScaleW-1 -: pipegs_pkg::ScaleEW] = data_q[CenterW +: pipegs_pkg::ScaleEW];
    end
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!load_popped || !valid_q);
  pipegs_stream_check #(.DataW($bits({chunk_kind_o, chunk_set_o, chunk_o, mark_o}))) u_check_chunk (
    .clk_i,
    .rst_ni,
    .valid_i(chunk_valid_o),
    .ready_i(chunk_ready_i),
    .beat_i({chunk_kind_o, chunk_set_o, chunk_o, mark_o})
  );
`endif

endmodule
