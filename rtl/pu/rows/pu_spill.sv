// SPDX-License-Identifier: Apache-2.0
// pu_spill: sends each line of alphas where pu_allocate gave it room: the alpha store, or the overflow area in memory.
//
// Paper   The paper's cache has no bound; docs/units/pu.md says what happens when ours is full.
// Idea    A line for the store passes at once. A line for memory goes through a register, in AlphaMemoryLines pieces,
//         to
//           first line of the area of this unit (area_first) + number * AlphaMemoryLines + piece
//         The address holds the number, and above it which of the unit's two areas; with lists the unit.
//         Overflow 0: every line is for the store. A line that the area does not hold is not written, nor is any
//         behind it (full_o); the last numbers of all have no place, so that a count that wraps is seen.
//         An end comes out as rows_end only when no line waits for the memory any more: writes are in order behind it.
// Stream  alphas + line in; store write (never refused), memory write, rows_end out.
// Pace    One line per cycle to the store; one per AlphaMemoryLines + 1 cycles to memory.
// Model   overflow_line in cpp_model/pu/rows/pu_allocate.hpp

module pu_spill #(
  localparam int unsigned AlphaAddressW = pipegs_pkg::AlphaAddressW,
  localparam int unsigned AddressW      = pipegs_pkg::AddressW,
  localparam int unsigned MemoryW       = pipegs_pkg::MemoryW,
  localparam int unsigned LineW         = pipegs_pkg::LineW,
  localparam int unsigned KindW         = pipegs_pkg::KindW
) (
  input  logic                          clk_i,
  input  logic                          rst_ni,
  input  pipegs_pkg::span_t             overflow_i,  // constant while a line is inside
  input  logic [pipegs_pkg::UnitW-1:0]  unit_i,

  input  logic                          alphas_valid_i,
  output logic                          alphas_ready_o,
  input  pipegs_pkg::alphas_t           alphas_i,
  input  logic [LineW-1:0]              line_i,

  output logic                          store_write_o,
  output logic [AlphaAddressW-1:0]      store_address_o,
  output logic [LineW-1:0]              store_line_o,

  output logic                          mem_valid_o,
  input  logic                          mem_ready_i,
  output logic [AddressW-1:0]           mem_address_o,
  output logic [MemoryW-1:0]            mem_data_o,

  output logic                          rows_end_valid_o,  // all lines of a layer are written
  input  logic                          rows_end_ready_i,
  output logic [KindW-1:0]              rows_end_kind_o,

  output logic                          full_o,       // stays
  output logic [AddressW-1:0]           full_line_o,  // that would have been written
  output logic                          active_o  // needs a clock
);

  localparam int unsigned Pieces  = pipegs_pkg::AlphaMemoryLines;
  localparam int unsigned HeldW   = Pieces * MemoryW;
  localparam int unsigned LeftW   = $clog2(Pieces + 1);
  localparam int unsigned NumberW = AlphaAddressW - (pipegs_pkg::HasLists ? pipegs_pkg::UnitW : 1);
  localparam int unsigned SumW    = NumberW + 2;
  localparam int unsigned MostW   = SumW > AddressW ? SumW : AddressW;

  // With lists all alphas go through memory.
  localparam bit Outside = pipegs_pkg::SpillsAlphas;

  logic is_data, ext, free;  // free: no line waits for the memory

  assign is_data = alphas_i.kind == pipegs_pkg::KindData;
  assign ext     = Outside && alphas_i.ext;

  always_comb begin
    if (!is_data) alphas_ready_o = free && rows_end_ready_i;
    else alphas_ready_o = !ext || free;
  end

  assign store_write_o   = alphas_valid_i && is_data && !ext;
  assign store_address_o = alphas_i.address;
  assign store_line_o    = line_i;

  assign rows_end_valid_o = alphas_valid_i && !is_data && free;
  assign rows_end_kind_o  = alphas_i.kind;

  assign active_o         = (alphas_valid_i && alphas_ready_o) || (mem_valid_o && mem_ready_i);

  if (Outside) begin : gen_outside
    logic                load, next;
    logic [LeftW-1:0]    left_q;     // pieces that the memory has not accepted
    logic [AddressW-1:0] address_q, first_q, odd;  // first_q: of the unit's even area; odd: how far behind it the other
    logic [HeldW-1:0]    held_q;
    logic [NumberW-1:0]  number;
    logic [SumW-1:0]     lines_end;  // of the line, in its area
    logic                outside, full_q;
    assign free = left_q == '0;
    assign load = alphas_valid_i && is_data && ext && free;
    assign next = mem_valid_o && mem_ready_i;
    assign number  = alphas_i.address[NumberW-1:0];
    assign odd     = !pipegs_pkg::HasLists && alphas_i.address[AlphaAddressW-1]
                   ? pipegs_pkg::area_lines(overflow_i.lines, pipegs_pkg::AreaOdd) : '0;
    assign lines_end = (SumW'(number) + SumW'(1)) * SumW'(Pieces);
    assign outside   = number[NumberW-1:pipegs_pkg::RegionW] == '1 ||
                       MostW'(lines_end) > MostW'(pipegs_pkg::area_lines(overflow_i.lines, pipegs_pkg::AreaEven));
    assign mem_valid_o   = !free && !full_q;
    assign mem_address_o = address_q;
    assign mem_data_o    = held_q[MemoryW-1:0];
    assign full_o        = full_q;
    assign full_line_o   = address_q;

    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) begin
        left_q <= '0;
        full_q <= 1'b0;
      end else begin
        if (load) left_q <= LeftW'(Pieces);
        else if (next) left_q <= left_q - LeftW'(1);
        if (load && outside) full_q <= 1'b1;
      end
    end
    always_ff @(posedge clk_i) begin
      first_q <= overflow_i.first + pipegs_pkg::area_first(overflow_i.lines, unit_i, pipegs_pkg::AreaEven);
      if (load) begin
        address_q <= first_q + odd + AddressW'(number) * AddressW'(Pieces);
        held_q    <= HeldW'(line_i);
      end else if (next && Pieces > 1) begin
        address_q <= address_q + AddressW'(1);
        held_q    <= held_q >> MemoryW;
      end
    end
  end else begin : gen_inside
    assign free          = 1'b1;
    assign mem_valid_o   = 1'b0;
    assign mem_address_o = '0;
    assign mem_data_o    = '0;
    assign full_o        = 1'b0;
    assign full_line_o   = '0;
    logic unused_memory;
    assign unused_memory = &{1'b0, clk_i, rst_ni, overflow_i, unit_i, mem_ready_i};
`ifndef SYNTHESIS
    always_ff @(posedge clk_i) if (rst_ni) assert (!(alphas_valid_i && is_data) || !alphas_i.ext)
      else $error("pu_spill: a line for memory, and Overflow is 0");
`endif
  end

  logic unused_fields;
  assign unused_fields = &{1'b0, alphas_i};

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits({mem_address_o, mem_data_o})), .Proven(1)) u_check_mem (
    .clk_i,
    .rst_ni,
    .valid_i(mem_valid_o),
    .ready_i(mem_ready_i),
    .beat_i({mem_address_o, mem_data_o})
  );
  pipegs_stream_check #(.DataW($bits(rows_end_kind_o))) u_check_rows_end (
    .clk_i,
    .rst_ni,
    .valid_i(rows_end_valid_o),
    .ready_i(rows_end_ready_i),
    .beat_i(rows_end_kind_o)
  );
`endif

endmodule
