// SPDX-License-Identifier: Apache-2.0
// dopu_open: opens nodes: reads their children, and knows the nearest bucket of what is being opened.
//
// Paper   None.
// Idea    A node opened is a job of pipegs_line_reader; its bucket goes along with each child. It counts as being
//         opened until its last child is settled (waits in its own turn, was sent, or dropped). Children are settled in
//         the order in which nodes were opened, so a short queue of buckets knows all that are open. The nearest of
//         them is found a cycle ahead, with and without the oldest, by a tree of comparisons, and stands in a register.
// Stream  open: a node's range and bucket. child: its children, the last one marked; settled_i: a last child is
//         settled.
// Pace    One child per cycle while the memory delivers; Most nodes at a time.
// Model   None: verif/dopu/nearest/dopu_nearest_test.cpp checks the watermarks that follow.

module dopu_open #(
  parameter int unsigned Most = 4,     // nodes open at a time
  parameter int unsigned Lines = 32,
  localparam int unsigned BucketW = pipegs_pkg::BucketW,
  localparam int unsigned SlotW = pipegs_pkg::SlotW,
  localparam int unsigned CountW = pipegs_pkg::ChildrenW,
  localparam int unsigned NodeBits = pipegs_pkg::NodeBits
) (
  input  logic                             clk_i,
  input  logic                             rst_ni,
  input  pipegs_pkg::span_t                table_i,         // of the children

  input  logic                             open_valid_i,
  output logic                             open_ready_o,  // stays up until a node is opened
  input  logic [BucketW-1:0]               open_bucket_i,
  input  logic [SlotW-1:0]                 open_first_i,
  input  logic [CountW-1:0]                open_count_i,

  output logic                             mem_valid_o,
  input  logic                             mem_ready_i,
  output logic [pipegs_pkg::AddressW-1:0]  mem_address_o,
  output logic [pipegs_pkg::BurstW-1:0]    mem_lines_o,  // less one
  input  logic                             rsp_valid_i,
  input  logic [pipegs_pkg::MemoryW-1:0]   rsp_data_i,

  output logic                             child_valid_o,
  input  logic                             child_ready_i,
  output logic [NodeBits-1:0]              child_o,
  output logic [BucketW-1:0]               child_parent_o,  // its parent's bucket
  output logic                             child_last_o,

  input  logic                             settled_i,
  output logic                             any_o,
  output logic [BucketW-1:0]               nearest_o,       // smallest bucket open; the largest number when none is
  output logic                             bad_o,           // names no children of the table: see pipegs_line_reader
  output logic [pipegs_pkg::AddressW-1:0]  bad_line_o,
  output logic                             waiting_o
);

  // --- buckets open, the oldest at 0 --------------------------------------------------------------------------------
  logic [BucketW-1:0] bucket_q [Most], kept [Most], moved [Most];
  logic [Most-1:0]    open_q;       // which of them are open
  logic [Most-1:0]    fewer, more;  // the same without the oldest, and of one more
  logic [BucketW-1:0] nearest_q, stays, goes;  // the nearest next if the oldest stays, if it is settled
  // a tree over all but the oldest: the smaller of 2i and 2i+1 at i, leaves from Most on
  logic [BucketW-1:0] least [2*Most];
  logic               take;

  assign take  = open_valid_i && open_ready_o;
  assign fewer = open_q >> 1;
  assign more  = (open_q << 1) | Most'(1);
  assign any_o = open_q[0];

  always_comb begin
    least[0] = '1;
    for (int unsigned i = 0; i < Most; i += 1) least[Most+i] = i != 0 && open_q[i] ? bucket_q[i] : '1;
    for (int unsigned i = Most - 1; i > 0; i -= 1) least[i] = least[2*i] < least[2*i+1] ? least[2*i] : least[2*i+1];
  end
  // With and without the oldest, and behind those left what is being opened, taken or not: `settled_i` comes late, and
  // what lies behind them does not count.
  always_comb begin
    for (int unsigned i = 0; i < Most; i += 1) begin
      kept[i]  = open_q[i] ? bucket_q[i] : open_bucket_i;
      moved[i] = i + 1 != Most && fewer[i] ? bucket_q[i+1] : open_bucket_i;
    end
  end
  assign stays     = take && open_bucket_i < nearest_q ? open_bucket_i : nearest_q;
  assign goes      = take && open_bucket_i < least[1] ? open_bucket_i : least[1];
  assign nearest_o = nearest_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      open_q    <= '0;
      nearest_q <= '1;
    end else begin
      open_q    <= settled_i ? (take ? open_q : fewer) : (take ? more : open_q);
      nearest_q <= settled_i ? goes : stays;
    end
  end
  always_ff @(posedge clk_i) begin
    for (int unsigned i = 0; i < Most; i += 1) bucket_q[i] <= settled_i ? moved[i] : kept[i];
  end

  // --- the job waits here until the reader takes it -----------------------------------------------------------------
  logic               job_valid_q, job_ready;
  logic [BucketW-1:0] job_bucket_q;
  logic [SlotW-1:0]   job_first_q, index;
  logic [CountW-1:0]  job_count_q;
  logic               is_read, idle;

  assign open_ready_o = !job_valid_q && !open_q[Most-1];

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) job_valid_q <= 1'b0;
    else if (take) job_valid_q <= 1'b1;
    else if (job_ready) job_valid_q <= 1'b0;
  end
  always_ff @(posedge clk_i) begin
    if (take) begin
      job_bucket_q <= open_bucket_i;
      job_first_q  <= open_first_i;
      job_count_q  <= open_count_i;
    end
  end

  pipegs_line_reader #(.TagW(BucketW), .ItemW(NodeBits), .ItemsPerLine(2), .Lines(Lines), .Jobs(Most),
    .CountW(CountW)) u_reader (
    .clk_i,
    .rst_ni,
    .table_i,
    .job_valid_i(job_valid_q),
    .job_ready_o(job_ready),
    .job_read_i(1'b1),
    .job_first_i(job_first_q),
    .job_count_i(job_count_q),
    .job_tag_i(job_bucket_q),
    .mem_valid_o,
    .mem_ready_i,
    .mem_address_o,
    .mem_lines_o,
    .rsp_valid_i,
    .rsp_data_i,
    .out_valid_o(child_valid_o),
    .out_ready_i(child_ready_i),
    .out_read_o(is_read),
    .out_index_o(index),
    .out_last_o(child_last_o),
    .out_tag_o(child_parent_o),
    .out_item_o(child_o),
    .bad_o,
    .bad_line_o,
    .waiting_o,
    .idle_o(idle)
  );

  logic unused;
  assign unused = &{1'b0, is_read, idle, index, least[0]};

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!settled_i || any_o);
  pipegs_stream_check #(.DataW($bits({job_bucket_q, job_first_q, job_count_q}))) u_check_job (
    .clk_i,
    .rst_ni,
    .valid_i(job_valid_q),
    .ready_i(job_ready),
    .beat_i({job_bucket_q, job_first_q, job_count_q})
  );
`endif

endmodule
