// SPDX-License-Identifier: Apache-2.0
// dopu_layer: finds the slab of the grid that holds the camera, and names the cells of a slab.
//
// Paper   Sec. 4.1: normalization unit and three-way multiplexer.
// Idea    camera slab c = clamp(floor((camera - low) * scale / 2^WorldW), 0, Grid - 1), one bit of scale per cycle,
//         once a frame. Step s of the walk is slab c + (s+1)/2 or c - s/2: c, c+1, c-1, c+2 ... front to back for every
//         ray. Cell = slab and two other coordinates, put in order by the axis. Without slabs: the cells in the order
//         of their table; nothing is known of the camera.
// Stream  start_i for one cycle; ready_o when the camera's slab is known. Then step_i, number_i -> slab, cell at once.
// Pace    FocalW + 2 cycles a frame.
// Model   cpp_model/dopu/dopu_layer.hpp

module dopu_layer #(
  localparam int unsigned GridW = pipegs_pkg::Grid > 1 ? $clog2(pipegs_pkg::Grid) : 1,
  localparam int unsigned NumberW = pipegs_pkg::SlabCells > 1 ? $clog2(pipegs_pkg::SlabCells) : 1,
  localparam int unsigned CellW = pipegs_pkg::TableCells > 1 ? $clog2(pipegs_pkg::TableCells) : 1
) (
  input  logic                                clk_i,
  input  logic                                rst_ni,

  input  logic                                start_i,
  input  logic [1:0]                          axis_i,
  input  pipegs_pkg::position_t               position_i,
  input  pipegs_pkg::grid_t                   grid_i,
  output logic                                ready_o,

  input  logic [GridW:0]                      step_i,
  output logic                                inside_o,  // the step's slab lies in the grid
  input  logic [NumberW-1:0]                  number_i,  // cell in the slab, lower axis fastest
  output logic [CellW-1:0]                    cell_o
);

  if (pipegs_pkg::HasSlabs) begin : gen_slabs
    localparam int unsigned WorldW = pipegs_pkg::WorldW;
    localparam int unsigned FocalW = pipegs_pkg::FocalW;
    localparam int unsigned SumW = WorldW + FocalW;
    localparam int unsigned BitsW = $clog2(FocalW + 1);

    // --- normalisation -------------------------------------------------------------------------------------------
    logic signed [WorldW-1:0] camera, low;
    logic signed [WorldW:0]   delta;
    logic [FocalW-1:0]        scale, scale_q;   // scale_q: bits still to come, highest first
    logic [WorldW-1:0]        delta_q;
    logic [SumW-1:0]          sum_q;            // u28.40
    logic [BitsW-1:0]         bits_left_q;
    logic [GridW-1:0]         slab_q;
    logic                     ready_q;

    always_comb begin
      case (axis_i)
        2'd0: begin camera = position_i.x; low = grid_i.low.x; scale = grid_i.scale_x; end
        2'd1: begin camera = position_i.y; low = grid_i.low.y; scale = grid_i.scale_y; end
        default: begin camera = position_i.z; low = grid_i.low.z; scale = grid_i.scale_z; end
      endcase
    end
    assign delta = (WorldW+1)'(camera) - (WorldW+1)'(low);

    always_ff @(posedge clk_i) begin
      if (start_i) begin
        delta_q <= delta[WorldW] ? '0 : delta[WorldW-1:0];  // below the grid: slab 0
        scale_q <= scale;
        sum_q   <= '0;
      end else begin
        scale_q <= scale_q << 1;
        if (bits_left_q != '0) sum_q <= (sum_q << 1) + (scale_q[FocalW-1] ? SumW'(delta_q) : '0);
      end
      if (bits_left_q == '0 && !ready_q) begin
        slab_q <= (sum_q >> WorldW) >= SumW'(pipegs_pkg::Grid) ? GridW'(pipegs_pkg::Grid - 1) : sum_q[WorldW +: GridW];
      end
    end

    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) begin
        bits_left_q <= '0;
        ready_q     <= 1'b1;
      end else begin
        if (start_i) bits_left_q <= BitsW'(FocalW);
        else if (bits_left_q != '0) bits_left_q <= bits_left_q - 1'b1;
        if (start_i) ready_q <= 1'b0;
        else if (bits_left_q == '0) ready_q <= 1'b1;
      end
    end
    assign ready_o = ready_q;

    // --- walk and three-way multiplexer ----------------------------------------------------------------------------
    logic signed [GridW+1:0] camera_slab, distance, slab;
    logic [GridW-1:0]        first, second;

    assign camera_slab = (GridW+2)'(slab_q);
    assign distance    = (GridW+2)'((step_i + 1'b1) >> 1);  // (s+1)/2; for an even step the same as s/2
    assign slab        = step_i[0] ? camera_slab + distance : camera_slab - distance;
    assign inside_o    = slab >= 0 && slab < (GridW+2)'(pipegs_pkg::Grid);
    assign {second, first} = (2*GridW)'(number_i);

    always_comb begin
      case (axis_i)
        2'd0: cell_o = CellW'({second, first, slab[GridW-1:0]});
        2'd1: cell_o = CellW'({second, slab[GridW-1:0], first});
        default: cell_o = CellW'({slab[GridW-1:0], second, first});
      endcase
    end
  end else begin : gen_table
    assign ready_o  = 1'b1;
    assign inside_o = 1'b1;
    assign cell_o   = number_i;
    logic unused_inputs;
    assign unused_inputs = &{1'b0, clk_i, rst_ni, start_i, axis_i, position_i, grid_i, step_i};
  end

endmodule
