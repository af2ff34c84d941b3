// SPDX-License-Identifier: Apache-2.0
// ru_fetch: fetches the line of alphas of each region, from an alpha store or from the overflow area in memory.
//
// Paper   Sec. 4, "precompute and cache the alphas"; the overflow area is what makes a full cache cost time, not
//         pixels.
// Idea    Lines are asked for in order as long as there is room for the answers: local lines come two cycles after the
//         store took the request, external ones after any time, up to FetchLines in flight (Overflow 0: there are
//         none). A queue of records remembers where each next line comes from, so lines leave in the order of the
//         records. A line that is skipped is only reported to its store.
// Stream  fetch_t in; blend_t with its line beside it out, none for a skipped line. End beats pass in order.
// Pace    One region per cycle while lines come as fast.
// Model   ru_overflow_line in cpp_model/ru/ru_walk.hpp, and a queue in the test.

module ru_fetch (
  input  logic                                                          clk_i,
  input  logic                                                          rst_ni,
  input  pipegs_pkg::span_t                                             overflow_i,  // constant while a frame is inside

  input  logic                                                          in_valid_i,
  output logic                                                          in_ready_o,
  input  pipegs_pkg::fetch_t                                            in_i,

  output logic [pipegs_pkg::Units-1:0]                                  read_valid_o,
  input  logic [pipegs_pkg::Units-1:0]                                  read_ready_i,
  output logic [pipegs_pkg::AlphaAddressW-1:0]                          read_address_o,
  output logic                                                          read_skip_o,  // the line is freed, not read
  input  logic [pipegs_pkg::Units-1:0]                                  answer_valid_i,
  input  logic [pipegs_pkg::Units*pipegs_pkg::LineW-1:0]                answer_i,

  output logic                                                          mem_valid_o,
  input  logic                                                          mem_ready_i,
  output logic [pipegs_pkg::AddressW-1:0]                               mem_address_o,
  input  logic                                                          rsp_valid_i,
  input  logic [pipegs_pkg::MemoryW-1:0]                                rsp_data_i,

  output logic                                                          out_valid_o,
  input  logic                                                          out_ready_i,
  output pipegs_pkg::blend_t                                            out_o,
  output logic [pipegs_pkg::LineW-1:0]                                  out_line_o,

  output logic                                                          memory_o,  // the next line is still in memory
  output logic                                                          idle_o
);

  localparam int unsigned Units = pipegs_pkg::Units;
  localparam int unsigned LineW = pipegs_pkg::LineW;
  localparam int unsigned MemoryW = pipegs_pkg::MemoryW;
  localparam int unsigned AddressW = pipegs_pkg::AddressW;
  localparam int unsigned UnitIndexW = Units > 1 ? $clog2(Units) : 1;
  localparam int unsigned Parts = pipegs_pkg::AlphaMemoryLines;  // memory lines of a line of alphas, 1 or 2
  localparam int unsigned LocalLines = pipegs_pkg::RuLocalLines;
  localparam int unsigned LocalW = $clog2(LocalLines + 1);
  localparam int unsigned FetchLines = pipegs_pkg::FetchLines;
  localparam int unsigned FetchW = $clog2(FetchLines + 1);
  localparam int unsigned Records = pipegs_pkg::RuRecords;
  // Above the number of a line in its area stands which of the unit's two areas; with lists the unit.
  localparam int unsigned NumberW = pipegs_pkg::AlphaAddressW - (pipegs_pkg::HasLists ? pipegs_pkg::UnitW : 1);
  localparam int unsigned RecordsW = $clog2(Records + 1);

  // With lists all alphas come from memory.
  localparam bit Outside = pipegs_pkg::SpillsAlphas;

  logic [1:0]           asked_q;          // a local line was asked for in the cycle before, in the one before that
  logic                 is_data, ext, skip, local_room, local_want, external_want, external_last, fire;
  logic                 record_ready, record_valid, pop;
  logic [LocalW-1:0]    local_count;
  logic                 local_valid, external_valid, line_valid, head_ext;
  logic [LineW-1:0]     local_in, local_line, external_line;
  logic [RecordsW-1:0]  record_count;
  logic                 local_ready;
  pipegs_pkg::blend_t   record, head;

  assign is_data       = in_i.kind == pipegs_pkg::KindData;
  assign ext           = Outside && in_i.ext;
  assign head_ext      = Outside && head.ext;
  assign skip          = pipegs_pkg::HasStores && is_data && in_i.skip;
  assign local_room    = local_count + LocalW'(asked_q[0]) + LocalW'(asked_q[1]) < LocalW'(LocalLines);
  assign local_want    = in_valid_i && is_data && !ext && (skip || (record_ready && local_room));
  assign fire          = (local_want && read_ready_i[in_i.unit[UnitIndexW-1:0]]) ||
                         (external_want && mem_ready_i && external_last) || (in_valid_i && !is_data && record_ready);
  assign in_ready_o    = fire;

  always_comb begin
    read_valid_o = '0;
    read_valid_o[in_i.unit[UnitIndexW-1:0]] = local_want;
  end
  assign read_address_o = in_i.address;
  assign read_skip_o    = skip;

  // Lines and records wait for each other.
  always_comb begin
    local_in = answer_i[LineW-1:0];
    for (int unsigned i = 1; i < Units; i += 1) if (answer_valid_i[i]) local_in = answer_i[i*LineW +: LineW];
    record.kind   = in_i.kind;
    record.region = in_i.region;
    record.ext    = in_i.ext;
    record.red    = in_i.red;
    record.green  = in_i.green;
    record.blue   = in_i.blue;
    record.index  = in_i.index;
  end

  assign line_valid  = head_ext ? external_valid : local_valid;
  assign out_o       = head;
  assign out_line_o  = head_ext ? external_line : local_line;
  assign out_valid_o = record_valid && (head.kind != pipegs_pkg::KindData || line_valid);
  assign pop         = out_valid_o && out_ready_i && head.kind == pipegs_pkg::KindData;
  assign memory_o    = record_valid && head.kind == pipegs_pkg::KindData && head_ext && !external_valid;
  assign idle_o      = record_count == '0;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      asked_q <= '0;
    end else begin
      asked_q <= {asked_q[0], fire && is_data && !ext && !skip};
    end
  end

  pipegs_sram_fifo #(.DataW(pipegs_pkg::BlendBits), .Depth(Records)) u_records (
    .clk_i,
    .rst_ni,
    .in_valid_i(fire && !skip),
    .in_ready_o(record_ready),
    .in_i(record),
    .out_valid_o(record_valid),
    .out_ready_i(out_valid_o && out_ready_i),
    .out_o(head),
    .count_o(record_count)
  );

  pipegs_fifo #(.DataW(LineW), .Depth(LocalLines)) u_local (
    .clk_i,
    .rst_ni,
    .in_valid_i(answer_valid_i != '0),
    .in_ready_o(local_ready),
    .in_i(local_in),
    .out_valid_o(local_valid),
    .out_ready_i(pop && !head_ext),
    .out_o(local_line),
    .count_o(local_count)
  );

  // --- lines from memory --------------------------------------------------------------------------------------------
  if (Outside) begin : gen_outside
    logic [FetchW-1:0]   external_q;  // external lines asked for and not yet blended
    logic                external_push, external_ready;
    logic [AddressW-1:0] base_q [Units];  // first lines of the even areas of each unit's alphas
    logic [AddressW-1:0] area;
    logic [NumberW-1:0]  number;
    logic [UnitIndexW-1:0] unit;
    logic [LineW-1:0]    external_in;
    logic [FetchW-1:0]   external_count;

    assign number = in_i.address[NumberW-1:0];
    if (pipegs_pkg::HasLists) begin : gen_listed
      assign unit = in_i.address[NumberW +: UnitIndexW];
      assign area = base_q[unit];
      logic unused_unit;
      assign unused_unit = &{1'b0, in_i.unit, in_i.address};
    end else begin : gen_layers
      assign unit = in_i.unit[UnitIndexW-1:0];
      assign area = base_q[unit] +
                    (in_i.address[NumberW] ? pipegs_pkg::area_lines(overflow_i.lines, pipegs_pkg::AreaOdd) : '0);
    end
    for (genvar i = 0; i < Units; i += 1) begin : gen_first
      always_ff @(posedge clk_i) begin
        base_q[i] <= overflow_i.first +
                     pipegs_pkg::area_first(overflow_i.lines, pipegs_pkg::UnitW'(i), pipegs_pkg::AreaEven);
      end
    end
    assign external_want = in_valid_i && is_data && ext && record_ready && external_q != FetchW'(FetchLines);
    assign mem_valid_o   = external_want;
    if (Parts == 1) begin : gen_one_part
      assign external_last = 1'b1;
      assign mem_address_o = area + AddressW'(number);
      assign external_push = rsp_valid_i;
      assign external_in   = rsp_data_i[LineW-1:0];
      if (LineW < MemoryW) begin : gen_unused
        logic unused_rsp;
        assign unused_rsp = &{1'b0, rsp_data_i[MemoryW-1:LineW]};
      end
    end else begin : gen_two_parts
      logic               ask_part_q, rsp_part_q;
      logic [MemoryW-1:0] first_q;  // the part that came first
      assign external_last = ask_part_q;
      assign mem_address_o = area + AddressW'({number, ask_part_q});
      assign external_push = rsp_valid_i && rsp_part_q;
      assign external_in   = {rsp_data_i[LineW-MemoryW-1:0], first_q};
      always_ff @(posedge clk_i or negedge rst_ni) begin
        if (!rst_ni) begin
          ask_part_q <= 1'b0;
          rsp_part_q <= 1'b0;
        end else begin
          if (mem_valid_o && mem_ready_i) ask_part_q <= !ask_part_q;
          if (rsp_valid_i) rsp_part_q <= !rsp_part_q;
        end
      end
      always_ff @(posedge clk_i) if (rsp_valid_i && !rsp_part_q) first_q <= rsp_data_i;
      logic unused_rsp;
      assign unused_rsp = &{1'b0, rsp_data_i[MemoryW-1:LineW-MemoryW]};
    end

    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) begin
        external_q <= '0;
      end else begin
        if (fire && is_data && ext && !(pop && head_ext)) external_q <= external_q + 1'b1;
        if (pop && head_ext && !(fire && is_data && ext)) external_q <= external_q - 1'b1;
      end
    end

    pipegs_sram_fifo #(.DataW(LineW), .Depth(FetchLines)) u_external (
      .clk_i,
      .rst_ni,
      .in_valid_i(external_push),
      .in_ready_o(external_ready),
      .in_i(external_in),
      .out_valid_o(external_valid),
      .out_ready_i(pop && head_ext),
      .out_o(external_line),
      .count_o(external_count)
    );

    logic unused_count;
    assign unused_count = &{1'b0, external_ready, external_count};
`ifndef SYNTHESIS
    always_ff @(posedge clk_i) if (rst_ni) assert (!external_push || external_ready)
      else $error("ru_fetch: no room for a line from memory");
`endif
  end else begin : gen_inside
    assign {external_want, external_valid, mem_valid_o} = '0;
    assign external_last = 1'b1;
    assign external_line = '0;
    assign mem_address_o = '0;
    logic unused_memory;
    assign unused_memory = &{1'b0, overflow_i, rsp_valid_i, rsp_data_i};
`ifndef SYNTHESIS
    always_ff @(posedge clk_i) if (rst_ni) assert (!(in_valid_i && is_data) || !in_i.ext)
      else $error("ru_fetch: a line in memory, and Overflow is 0");
`endif
  end

  logic unused_ready;
  assign unused_ready = local_ready;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (answer_valid_i == '0 || (local_ready && asked_q[1]))
    else $error("ru_fetch: a line that was not asked for");
  always_ff @(posedge clk_i) if (rst_ni) assert (!asked_q[1] || answer_valid_i != '0)
    else $error("ru_fetch: an alpha store did not answer in the second cycle");
  pipegs_stream_check #(.DataW($bits(mem_address_o)), .Proven(1)) u_check_mem (
    .clk_i,
    .rst_ni,
    .valid_i(mem_valid_o),
    .ready_i(mem_ready_i),
    .beat_i(mem_address_o)
  );
  pipegs_stream_check #(.DataW($bits({out_o, out_line_o})), .Proven(1)) u_check_out (
    .clk_i,
    .rst_ni,
    .valid_i(out_valid_o),
    .ready_i(out_ready_i),
    .beat_i({out_o, out_o.kind == pipegs_pkg::KindData ? out_line_o : '0})  // an end has no line
  );
  pipegs_stream_check #(
    .Ports(pipegs_pkg::Units),
    .Shared(1),
    .DataW($bits({read_skip_o, read_address_o}))
  ) u_check_read (
    .clk_i,
    .rst_ni,
    .valid_i(read_valid_o),
    .ready_i(read_ready_i),
    .beat_i({read_skip_o, read_address_o})
  );
`endif

endmodule
