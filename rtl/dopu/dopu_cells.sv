// SPDX-License-Identifier: Apache-2.0
// dopu_cells: keeps the cell table on chip and walks it for each window, slab by slab outward from the camera.
//
// Paper   Sec. 3.2 (orthogonal grid), Sec. 4.1.
// Idea    The table is read once per frame, two cells per line, up to eight lines at a time; every window walks it
//         again from the SRAM. Empty cells cost one cycle. After a slab comes a layer end, after the last slab (without
//         slabs, after the table) a window end. A window that is done has only that. A table that has too few lines is
//         not read (bad_o).
// Stream  cell out: a cell to test, or an end; with the set of planes that it belongs to.
// Pace    One cell per cycle.
// Model   cpp_model/dopu/dopu.hpp (the outer loops)

module dopu_cells #(
  localparam int unsigned GridW = pipegs_pkg::Grid > 1 ? $clog2(pipegs_pkg::Grid) : 1,
  localparam int unsigned NumberW = pipegs_pkg::SlabCells > 1 ? $clog2(pipegs_pkg::SlabCells) : 1,
  localparam int unsigned CellW = pipegs_pkg::TableCells > 1 ? $clog2(pipegs_pkg::TableCells) : 1
) (
  input  logic                            clk_i,
  input  logic                            rst_ni,

  input  logic                            start_i,
  input  pipegs_pkg::span_t               cells_i,   // the table
  output logic                            bad_o,
  output logic                            loading_o, // the answers of the memory belong here

  output logic                            mem_valid_o,
  input  logic                            mem_ready_i,
  output logic [pipegs_pkg::AddressW-1:0] mem_address_o,
  output logic [pipegs_pkg::BurstW-1:0]   mem_lines_o,  // less one
  input  logic                            rsp_valid_i,
  input  logic [pipegs_pkg::MemoryW-1:0]  rsp_data_i,

  input  logic                            layer_ready_i,  // to and from dopu_layer
  output logic [GridW:0]                  step_o,
  input  logic                            inside_i,
  output logic [NumberW-1:0]              number_o,
  input  logic [CellW-1:0]                cell_i,

  input  logic [1:0]                      set_valid_i,    // from dopu_windows
  input  logic [1:0]                      set_last_i,
  input  logic [1:0]                      set_done_i,
  output logic                            walked_o,       // the set's last item is on its way

  output logic                            cell_valid_o,
  input  logic                            cell_ready_i,
  output logic [pipegs_pkg::KindW-1:0]    kind_o,
  output logic                            set_o,
  output pipegs_pkg::node_t               cell_o,

  output logic                            walking_o  // the walk goes on in this cycle
);

  localparam int unsigned NodeBits = pipegs_pkg::NodeBits;
  localparam int unsigned BurstW = pipegs_pkg::BurstW;
  localparam int unsigned TableLines = (pipegs_pkg::TableCells + 1) / 2;
  localparam int unsigned TableW = CellW > 1 ? CellW - 1 : 1;
  localparam int unsigned LinesW = $clog2(TableLines + 1);
  localparam logic [NumberW-1:0] LastNumber = NumberW'(pipegs_pkg::SlabCells - 1);
  localparam logic [GridW-1:0] LastLayer = GridW'(pipegs_pkg::Slabs - 1);

  // --- load, once per frame -----------------------------------------------------------------------------------------
  logic [LinesW-1:0]               to_ask_q, to_come_q;
  logic [BurstW-1:0]               rest;  // lines of the aligned group of eight behind the present one
  logic [pipegs_pkg::AddressW-1:0] address_q;
  logic [TableW-1:0]                write_line_q;
  logic                            asks_q;  // of to_ask_q: whether the memory is asked leads into its arbiter
  logic                            answer, whole, asked;

  assign loading_o     = to_come_q != '0;
  assign answer        = rsp_valid_i && loading_o;
  assign whole         = cells_i.lines >= pipegs_pkg::AddressW'(TableLines);
  assign mem_valid_o   = asks_q;
  assign asked         = mem_valid_o && mem_ready_i;
  assign bad_o         = to_ask_q != '0 && !whole;
  assign mem_address_o = address_q;
  assign rest          = ~address_q[BurstW-1:0];
  assign mem_lines_o   = 32'(to_ask_q) > 32'(rest) ? rest : BurstW'(32'(to_ask_q) - 32'd1);

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      asks_q    <= 1'b0;
      to_ask_q  <= '0;
      to_come_q <= '0;
    end else if (start_i) begin
      asks_q    <= whole;
      to_ask_q  <= LinesW'(TableLines);
      to_come_q <= LinesW'(TableLines);
    end else begin
      if (asked) begin
        asks_q   <= 32'(to_ask_q) > 32'(rest) + 32'd1;
        to_ask_q <= to_ask_q - LinesW'(mem_lines_o) - 1'b1;
      end
      if (answer) to_come_q <= to_come_q - 1'b1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (start_i) begin
      address_q    <= cells_i.first;
      write_line_q <= '0;
    end else begin
      if (asked) address_q <= address_q + pipegs_pkg::AddressW'(mem_lines_o) + 1'b1;
      if (answer) write_line_q <= write_line_q + 1'b1;
    end
  end

  // --- walk ---------------------------------------------------------------------------------------------------------
  // One item per cycle: a cell of the slab, or the end behind its last cell. The item read stands at the output.
  logic                 walking_q;            // windows are left to walk
  logic                 set_q;                // the set of planes of the window walked
  logic [GridW:0]       step_q;
  logic [GridW-1:0]     layer_q;              // slabs of this window walked
  logic [NumberW-1:0]   number_q;
  logic                 end_next_q;           // the next item is the slab's end
  logic                 item_valid_q, item_half_q, item_set_q;
  logic [pipegs_pkg::KindW-1:0] item_kind_q, kind_next;
  logic                 run, advance, read, window_end, is_end, is_shown, finished;
  logic [2*NodeBits-1:0] line;
  pipegs_pkg::node_t    item;

  assign run        = walking_q && !loading_o && layer_ready_i && set_valid_i[set_q];
  assign is_end     = end_next_q || set_done_i[set_q];
  assign window_end = layer_q == LastLayer || set_done_i[set_q];
  assign kind_next  = !is_end ? pipegs_pkg::KindData
                    : window_end ? pipegs_pkg::KindWindowEnd : pipegs_pkg::KindLayerEnd;
  // An item moves on when it is taken, and at once when it is an empty cell.
  assign advance    = !item_valid_q || (cell_valid_o ? cell_ready_i : 1'b1);
  assign read       = run && advance && (inside_i || set_done_i[set_q]);
  assign finished   = read && is_end && window_end;
  assign walking_o  = run && (advance || !inside_i);
  assign walked_o   = finished;
  assign step_o     = step_q;
  assign number_o   = number_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      walking_q    <= 1'b0;
      set_q        <= 1'b0;
      item_valid_q <= 1'b0;
      step_q       <= '0;
      layer_q      <= '0;
      number_q     <= '0;
      end_next_q   <= 1'b0;
    end else begin
      if (start_i) walking_q <= 1'b1;
      else if (finished && set_last_i[set_q]) walking_q <= 1'b0;
      if (advance) item_valid_q <= read;
      if (finished) begin
        set_q      <= !set_q;
        step_q     <= '0;
        layer_q    <= '0;
        number_q   <= '0;
        end_next_q <= 1'b0;
      end else if (run && !inside_i) begin
        step_q     <= step_q + 1'b1;
      end else if (read && end_next_q) begin
        step_q     <= step_q + 1'b1;
        layer_q    <= layer_q + 1'b1;
        end_next_q <= 1'b0;
      end else if (read) begin
        number_q   <= number_q == LastNumber ? '0 : number_q + 1'b1;
        end_next_q <= number_q == LastNumber;
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (read) begin
      item_kind_q <= kind_next;
      item_half_q <= cell_i[0];
      item_set_q  <= set_q;
    end
  end

  pipegs_sram #(.DataW(2 * NodeBits), .Depth(2 ** TableW), .Ports(1)) u_table (
    .clk_i,
    .write_i(answer),
    .waddr_i(write_line_q),
    .wdata_i({rsp_data_i[pipegs_pkg::MemoryW/2 +: NodeBits], rsp_data_i[NodeBits-1:0]}),
    .read_i(read),
    .raddr_i(cell_i[CellW-1:CellW-TableW]),
    .rdata_o(line)
  );

  assign item         = item_half_q ? line[2*NodeBits-1:NodeBits] : line[NodeBits-1:0];
  assign is_shown     = item_kind_q != pipegs_pkg::KindData ||
                        item[pipegs_pkg::NodeBits-1 -: pipegs_pkg::ChildrenW] != '0;
  assign cell_valid_o = item_valid_q && is_shown;
  assign kind_o       = item_kind_q;
  assign set_o        = item_set_q;
  assign cell_o       = item;

  logic unused_data;  // the bits of a line beside the nodes
  assign unused_data = ^rsp_data_i;

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits({kind_o, set_o, cell_o}))) u_check_cell (
    .clk_i,
    .rst_ni,
    .valid_i(cell_valid_o),
    .ready_i(cell_ready_i),
    .beat_i({kind_o, set_o, cell_o})
  );
  pipegs_stream_check #(.DataW($bits(mem_address_o))) u_check_mem (
    .clk_i,
    .rst_ni,
    .valid_i(mem_valid_o),
    .ready_i(mem_ready_i),
    .beat_i(mem_address_o)
  );
`endif

endmodule
