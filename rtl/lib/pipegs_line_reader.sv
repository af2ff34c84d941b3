// SPDX-License-Identifier: Apache-2.0
// pipegs_line_reader: turns ranges of items that lie packed in external memory into a stream of items.
//
// Idea    A job names consecutive items. Its lines are requested at once, as far as the line buffer has room (a credit
//         is a line's place in the buffer), so the requests of later jobs overlap the answers of earlier ones. A
//         request goes on to the end of the job or of the aligned group of eight lines; it waits until eight places are
//         free, so that a full buffer asks for groups, not for single lines, and a request that shows never changes.
//         A job without read is a marker: it passes in its turn and needs no memory. Item i lies in line i /
//         ItemsPerLine of the table. A job that names nothing, or what lies behind the table's end, is bad: the lines
//         of those before it still come, its own are never asked for, and no job is taken any more.
// Stream  job: first item, count, tag. mem: first line and number of lines of a request; rsp: the lines in the same
//         order, always accepted. out: one beat per item, or per marker, with the job's tag, the last one marked.
//         bad_o stays, bad_line_o is the line that the job named first.
// Pace    One item per cycle while the memory delivers; one request per cycle, one cycle between jobs.
// Model   A queue of chunks in verif/pu/front/pu_fetch_test.cpp.

module pipegs_line_reader #(
  parameter int unsigned TagW = 8,
  parameter int unsigned ItemW = 256,
  parameter int unsigned ItemsPerLine = 2,  // 1, 2 or 4, each at its part of the line
  parameter int unsigned Lines = 32,        // in flight or in the buffer; a power of two, at least 8
  parameter int unsigned Jobs = 4,
  parameter int unsigned IndexW = pipegs_pkg::SlotW,
  parameter int unsigned CountW = pipegs_pkg::CountW
) (
  input  logic                              clk_i,
  input  logic                              rst_ni,

  input  pipegs_pkg::span_t                 table_i,

  input  logic                              job_valid_i,
  output logic                              job_ready_o,
  input  logic                              job_read_i,
  input  logic [IndexW-1:0]                 job_first_i,
  input  logic [CountW-1:0]                 job_count_i,
  input  logic [TagW-1:0]                   job_tag_i,

  output logic                              mem_valid_o,
  input  logic                              mem_ready_i,
  output logic [pipegs_pkg::AddressW-1:0]   mem_address_o,
  output logic [pipegs_pkg::BurstW-1:0]     mem_lines_o,  // less one
  input  logic                              rsp_valid_i,
  input  logic [pipegs_pkg::MemoryW-1:0]    rsp_data_i,

  output logic                              out_valid_o,
  input  logic                              out_ready_i,
  output logic                              out_read_o,
  output logic [IndexW-1:0]                 out_index_o,
  output logic                              out_last_o,   // of its job
  output logic [TagW-1:0]                   out_tag_o,
  output logic [ItemW-1:0]                  out_item_o,

  output logic                              bad_o,
  output logic [pipegs_pkg::AddressW-1:0]   bad_line_o,
  output logic                              waiting_o,  // the next beat waits for the memory
  output logic                              idle_o      // no job is inside
);

  localparam int unsigned BurstW = pipegs_pkg::BurstW;
  if (Lines < 2 ** BurstW || (Lines & (Lines - 1)) != 0) begin : gen_odd
    $error("pipegs_line_reader: Lines is not a power of two, or below the lines of a burst");
  end
  if (ItemsPerLine != 1 && ItemsPerLine != 2 && ItemsPerLine != 4) begin : gen_many
    $error("pipegs_line_reader: ItemsPerLine is none of 1, 2, 4");
  end
  localparam int unsigned PtrW = $clog2(Lines);
  localparam int unsigned CreditW = $clog2(Lines + 1);
  localparam int unsigned PlaceW = $clog2(ItemsPerLine);  // bits of an item's place in its line
  localparam int unsigned Place = ItemsPerLine - 1;       // these bits
  localparam int unsigned JobW = 1 + IndexW + CountW + TagW;
  localparam int unsigned EndW = (IndexW > CountW ? IndexW : CountW) + 2;
  localparam int unsigned Group = 2 ** BurstW;  // lines
  localparam int unsigned MostW = EndW > pipegs_pkg::AddressW ? EndW : pipegs_pkg::AddressW;

  // --- requests: one group of lines after another of the job taken last ---------------------------------------------
  logic [pipegs_pkg::AddressW-1:0] line_q;
  logic [CountW:0]                 lines_left_q;
  logic [CreditW-1:0]              credits_q;
  logic [CountW:0]                 lines;  // of the job at the door
  logic [EndW-1:0]                 lines_end;  // of the job, counted from the table's first line on
  logic [BurstW-1:0]               rest;   // lines of the group behind the present one
  logic                            take, issue, load, jobs_ready, bad, bad_q;
  logic                            asks_q;  // lines are left, and eight places are free
  logic                            left, places, free_kept, free_load, free_issue, free_both;

  assign lines = ((CountW+1)'(job_count_i) + (CountW+1)'(Place) + (CountW+1)'(job_first_i & IndexW'(Place))) >> PlaceW;
  assign lines_end     = (EndW'(job_first_i) >> PlaceW) + EndW'(lines);
  assign bad           = job_read_i && (job_count_i == '0 || MostW'(lines_end) > MostW'(table_i.lines));
  assign job_ready_o   = jobs_ready && lines_left_q == '0 && !bad_q;
  assign take          = job_valid_i && job_ready_o;
  assign rest          = ~line_q[BurstW-1:0];
  assign mem_valid_o   = asks_q;
  assign mem_address_o = line_q;
  assign mem_lines_o   = lines_left_q > (CountW+1)'(rest) ? rest : lines_left_q[BurstW-1:0] - 1'b1;
  assign issue         = mem_valid_o && mem_ready_i;

  // What asks_q will be: chosen at last by what comes late, the readies of both sides.
  assign free_kept  = credits_q >= CreditW'(Group);
  assign free_load  = credits_q >= CreditW'(Group - 1);
  assign free_issue = (CreditW+1)'(credits_q) > (CreditW+1)'(Group) + (CreditW+1)'(mem_lines_o);
  assign free_both  = (CreditW+1)'(credits_q) >= (CreditW+1)'(Group) + (CreditW+1)'(mem_lines_o);
  always_comb begin
    if (take) left = job_read_i && !bad;
    else if (issue) left = lines_left_q > (CountW+1)'(rest) + 1'b1;
    else left = lines_left_q != '0;
    if (issue) places = load ? free_both : free_issue;
    else places = load ? free_load : free_kept;
  end

  always_ff @(posedge clk_i) begin
    if (take) line_q <= table_i.first + (pipegs_pkg::AddressW'(job_first_i) >> PlaceW);
    else if (issue) line_q <= {line_q[pipegs_pkg::AddressW-1:BurstW] + 1'b1, BurstW'(0)};  // if lines are left
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      lines_left_q <= '0;
      credits_q    <= CreditW'(Lines);
      asks_q       <= 1'b0;
      bad_q        <= 1'b0;
    end else begin
      asks_q <= left && places;
      if (take) lines_left_q <= job_read_i && !bad ? lines : '0;
      else if (issue) lines_left_q <= lines_left_q - (CountW+1)'(mem_lines_o) - 1'b1;
      if (take && bad) bad_q <= 1'b1;
      if (issue) credits_q <= credits_q - CreditW'(mem_lines_o) - CreditW'(!load);
      else if (load) credits_q <= credits_q + 1'b1;
    end
  end

  assign bad_o      = bad_q;
  assign bad_line_o = line_q;

  // --- answers: a ring of lines, its head read ahead into the memory's output register ------------------------------
  logic [PtrW-1:0]                head_q, tail_q;
  logic [CreditW-1:0]             stored_q;
  logic                           line_valid_q, line_pop;
  logic [pipegs_pkg::MemoryW-1:0] line;

  assign load = stored_q != '0 && (!line_valid_q || line_pop);

  pipegs_sram #(.DataW(pipegs_pkg::MemoryW), .Depth(Lines)) u_lines (
    .clk_i,
    .write_i(rsp_valid_i),
    .waddr_i(tail_q),
    .wdata_i(rsp_data_i),
    .read_i(load),
    .raddr_i(head_q),
    .rdata_o(line)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      head_q       <= '0;
      tail_q       <= '0;
      stored_q     <= '0;
      line_valid_q <= 1'b0;
    end else begin
      if (rsp_valid_i) tail_q <= tail_q + 1'b1;
      if (load) head_q <= head_q + 1'b1;
      if (rsp_valid_i && !load) stored_q <= stored_q + 1'b1;
      if (load && !rsp_valid_i) stored_q <= stored_q - 1'b1;
      if (load) line_valid_q <= 1'b1;
      else if (line_pop) line_valid_q <= 1'b0;
    end
  end

  // --- items --------------------------------------------------------------------------------------------------------
  logic              job_valid, job_read, job_pop, last, line_end;
  logic [IndexW-1:0] job_first;
  logic [CountW-1:0] job_count, item_q;  // item_q: items of the job sent so far
  logic [TagW-1:0]   job_tag;
  logic [$clog2(Jobs+1)-1:0] jobs_count;

  pipegs_fifo #(.DataW(JobW), .Depth(Jobs)) u_jobs (
    .clk_i,
    .rst_ni,
    .in_valid_i(take),
    .in_ready_o(jobs_ready),
    .in_i({job_read_i, job_first_i, job_count_i, job_tag_i}),
    .out_valid_o(job_valid),
    .out_ready_i(job_pop),
    .out_o({job_read, job_first, job_count, job_tag}),
    .count_o(jobs_count)
  );

  assign out_valid_o = job_valid && (!job_read || line_valid_q);
  assign out_read_o  = job_read;
  assign out_index_o = job_first + IndexW'(item_q);
  assign out_tag_o   = job_tag;
  assign out_last_o  = last;
  assign last        = !job_read || item_q + 1'b1 == job_count;
  assign job_pop     = out_valid_o && out_ready_i && last;
  assign line_pop    = out_valid_o && out_ready_i && job_read && (last || line_end);
  assign waiting_o   = job_valid && job_read && !line_valid_q;
  assign idle_o      = jobs_count == '0;

  assign line_end = (out_index_o & IndexW'(Place)) == IndexW'(Place);
  always_comb begin
    out_item_o = line[ItemW-1:0];
    for (int unsigned i = 1; i < ItemsPerLine; i += 1) begin
      if ((out_index_o & IndexW'(Place)) == IndexW'(i)) out_item_o = line[i*pipegs_pkg::MemoryW/ItemsPerLine +: ItemW];
    end
  end
  logic unused_line;  // the bits of a line that hold no item
  assign unused_line = ^line;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) item_q <= '0;
    else if (job_pop) item_q <= '0;
    else if (out_valid_o && out_ready_i) item_q <= item_q + 1'b1;
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!rsp_valid_i || stored_q != CreditW'(Lines));
  assert property (@(posedge clk_i) disable iff (!rst_ni)
                   mem_valid_o && !mem_ready_i |=> mem_valid_o && $stable({mem_address_o, mem_lines_o}));
  pipegs_stream_check #(.DataW($bits({mem_address_o, mem_lines_o})), .Proven(1)) u_check_mem (
    .clk_i,
    .rst_ni,
    .valid_i(mem_valid_o),
    .ready_i(mem_ready_i),
    .beat_i({mem_address_o, mem_lines_o})
  );
  pipegs_stream_check #(
    .DataW($bits({out_read_o, out_index_o, out_last_o, out_tag_o, out_item_o})),
    .Proven(1)
  ) u_check_out (
    .clk_i,
    .rst_ni,
    .valid_i(out_valid_o),
    .ready_i(out_ready_i),
    .beat_i({out_read_o, out_index_o, out_last_o, out_tag_o, out_read_o ? out_item_o : '0})  // a marker has no item
  );
`endif

endmodule
