// SPDX-License-Identifier: Apache-2.0
// pu_spill: sends each line of alphas where pu_allocate gave it room: the alpha store, or the overflow area in memory.
//
// Paper   The paper's cache has no bound; docs/units/rows.md says what happens when ours is full.
// Idea    A line for the store passes at once. A line for memory goes through a register, in AlphaMemoryLines pieces,
//         to
//           frame.overflow + ({unit, parity, area 0} << 24) + address * AlphaMemoryLines + piece
//         Overflow 0: every line is for the store.
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
  input  logic [pipegs_pkg::AddressW-1:0] overflow_i,  // first line of the overflow areas
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

  output logic                          active_o  // needs a clock
);

  localparam int unsigned Pieces  = pipegs_pkg::AlphaMemoryLines;
  localparam int unsigned HeldW   = Pieces * MemoryW;
  localparam int unsigned LeftW   = $clog2(Pieces + 1);
  localparam int unsigned AreaW   = 24;  // lines of an overflow area, log2
  localparam int unsigned AreasW  = 2;   // overflow areas of a unit and parity, log2

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
    logic [AddressW-1:0] address_q, area;
    logic [HeldW-1:0]    held_q;
    assign free = left_q == '0;
    assign load = alphas_valid_i && is_data && ext && free;
    assign next = mem_valid_o && mem_ready_i;
    // With lists all alphas lie in one area, and the address tells the unit.
    assign area = pipegs_pkg::HasLists ? AddressW'(1) << pipegs_pkg::AlphaAreaW
                                         : AddressW'({unit_i, alphas_i.parity, AreasW'(0)}) << AreaW;
    assign mem_valid_o   = !free;
    assign mem_address_o = address_q;
    assign mem_data_o    = held_q[MemoryW-1:0];

    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) left_q <= '0;
      else if (load) left_q <= LeftW'(Pieces);
      else if (next) left_q <= left_q - LeftW'(1);
    end
    always_ff @(posedge clk_i) begin
      if (load) begin
        address_q <= overflow_i + area + AddressW'(alphas_i.address) * AddressW'(Pieces);
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
  stream_check #(.DataW($bits({mem_address_o, mem_data_o})), .Proven(1)) u_check_mem (
    .clk_i, .rst_ni, .valid_i(mem_valid_o), .ready_i(mem_ready_i), .beat_i({mem_address_o, mem_data_o})
  );
  stream_check #(.DataW($bits(rows_end_kind_o))) u_check_rows_end (
    .clk_i, .rst_ni, .valid_i(rows_end_valid_o), .ready_i(rows_end_ready_i), .beat_i(rows_end_kind_o)
  );
`endif

endmodule
