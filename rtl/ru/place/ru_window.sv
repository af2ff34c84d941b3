// SPDX-License-Identifier: Apache-2.0
// ru_window: which window of the frame the RU is in, and how much of that window lies inside the image.
//
// Paper   Sec. 4 (the frame is rendered tile group by tile group).
// Idea    Windows follow row by row from first to last. All that depends on the window is computed in the cycle in
//         which it changes and kept: pixels inside, regions outside, and where the row's pixels begin in memory (by
//         addition): after so many windows, or in raster order after so many strides of a whole window's rows.
// Stream  restart_i: the first window of the frame. advance_i: the next one.
// Pace    New values in the cycle after the pulse.
// Model   ru_take, ru_inside, ru_pixel_line and ru_raster_line in cpp_model/ru/

module ru_window (
  input  logic                             clk_i,
  input  logic                             rst_ni,
  input  logic [pipegs_pkg::SizeW-1:0]     width_i,
  input  logic [pipegs_pkg::SizeW-1:0]     height_i,
  input  logic [pipegs_pkg::WindowW-1:0]   first_x_i,
  input  logic [pipegs_pkg::WindowW-1:0]   first_y_i,
  input  logic [pipegs_pkg::WindowW-1:0]   last_x_i,
  input  pipegs_pkg::picture_t             picture_i,  // its base is that of the pixels in either format

  input  logic                             restart_i,
  input  logic                             advance_i,

  output logic [pipegs_pkg::WindowW-1:0]   x_o,
  output logic [pipegs_pkg::WindowW-1:0]   y_o,
  output logic [$clog2(pipegs_pkg::Window):0] columns_o,  // pixel columns of the window inside the image
  output logic [$clog2(pipegs_pkg::Window):0] rows_o,
  output logic [pipegs_pkg::Regions-1:0]   outside_o,     // regions without a pixel inside the image
  output logic [pipegs_pkg::AddressW-1:0]  line_o         // of external memory: the first one of the window's pixels
);

  localparam int unsigned WindowW = pipegs_pkg::WindowW;
  localparam int unsigned PlaceW = pipegs_pkg::PlacesW;
  localparam int unsigned Shift = $clog2(pipegs_pkg::Window);
  localparam int unsigned SideW = WindowW + Shift + 1;  // pixels, signed after a subtraction
  localparam int unsigned AddressW = pipegs_pkg::AddressW;
  localparam int unsigned StrideW = pipegs_pkg::StrideW;
  localparam int unsigned BeforeW = WindowW + StrideW;
  localparam int unsigned Tiles = $clog2(pipegs_pkg::Squares * pipegs_pkg::MaskW * pipegs_pkg::RegionLines);

  // Pixels of a window that starts at window `at` in an image of `size` pixels: 0 .. Window.
  function automatic logic [Shift:0] span(input logic [pipegs_pkg::SizeW-1:0] size, input logic [WindowW-1:0] at);
    logic [SideW-1:0] start;
    start = SideW'(at) << Shift;
    if (SideW'(size) <= start) span = '0;
    else if (SideW'(size) - start >= SideW'(pipegs_pkg::Window)) span = (Shift + 1)'(pipegs_pkg::Window);
    else span = (Shift + 1)'(SideW'(size) - start);
  endfunction

  logic [WindowW-1:0]             x_d, y_d, windows_x;
  logic [Shift:0]                 columns_q, rows_q, columns_d, rows_d;
  logic [pipegs_pkg::Regions-1:0] outside_q, outside_d;
  logic [BeforeW-1:0]             before_q, before_d;  // windows, or strides of a window's rows, before the row
  logic [StrideW-1:0]             step;                // in a row
  logic                           row_ends;

  assign windows_x = WindowW'((SideW'(width_i) + SideW'(pipegs_pkg::Window - 1)) >> Shift);

  pipegs_window_walk u_walk (
    .clk_i,
    .rst_ni,
    .first_x_i,
    .first_y_i,
    .last_x_i,
    .start_i(restart_i),
    .advance_i,
    .x_o,
    .y_o,
    .next_x_o(x_d),
    .next_y_o(y_d),
    .row_ends_o(row_ends)
  );

  always_comb begin
    step     = picture_i.format ? picture_i.stride : StrideW'(windows_x);
    before_d = row_ends ? before_q + BeforeW'(step) : before_q;
    if (restart_i) before_d = BeforeW'(first_y_i) * BeforeW'(step);
    columns_d = span(width_i, x_d);
    rows_d    = span(height_i, y_d);
  end
  logic [(1 << PlaceW)-1:0] columns_out, rows_out;  // columns and rows of regions outside the image
  for (genvar i = 0; i < 1 << PlaceW; i += 1) begin : gen_side
    assign columns_out[i] = columns_d <= (Shift + 1)'(8 * i);
    assign rows_out[i]    = rows_d <= (Shift + 1)'(8 * i);
  end
  for (genvar i = 0; i < pipegs_pkg::Regions; i += 1) begin : gen_region
    logic [PlaceW-1:0] column, row;
    ru_place u_place (
      .region_i(pipegs_pkg::RegionW'(i)),
      .column_o(column),
      .row_o(row)
    );
    assign outside_d[i] = rows_out[row] || columns_out[column];
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      columns_q <= '0;
      rows_q    <= '0;
      outside_q <= '0;
      before_q  <= '0;
    end else if (restart_i || advance_i) begin
      columns_q <= columns_d;
      rows_q    <= rows_d;
      outside_q <= outside_d;
      before_q  <= before_d;
    end
  end

  assign columns_o = columns_q;
  assign rows_o    = rows_q;
  assign outside_o = outside_q;
  assign line_o    = picture_i.base + (picture_i.format
                     ? (AddressW'(before_q) << Shift) + (AddressW'(x_o) << (Shift - 4))
                     : (AddressW'(before_q) + AddressW'(x_o)) << Tiles);

endmodule
