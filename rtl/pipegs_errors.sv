// SPDX-License-Identifier: Apache-2.0
// pipegs_errors: what is found wrong in the memory of a frame: reported once, then the machine stops.
//
// Idea    A part that finds something wrong stops and says so until it is reset. What is said first of either cause is
//         reported with its line, and from then on no request goes to memory: the frame is given up, and all others
//         inside with it. Whether the pixels of a frame have room is known when it begins, and is looked at here,
//         before one of them can be written: so nothing is written behind the area of either format, nor over the
//         next one of its AOVs.
// Stream  restart_i: a frame begins, with its parameters. error_o: pulses, {bad_scene, area_full}; error_line_o: of
//         each the line of memory that it concerns, area_full's lowest. Lines and stop_o stay until the reset.
// Pace    Registered: two cycles behind what was found, pixels without room four behind restart_i.
// Model   A register for each cause in the test.

module pipegs_errors #(
  localparam int unsigned AddressW = pipegs_pkg::AddressW
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  input  logic                  restart_i,
  input  pipegs_pkg::raster_t   raster_i,
  input  logic                  by_windows_i,  // else in raster order
  input  logic [pipegs_pkg::StrideW-1:0] stride_i,  // then: lines from row to row
  input  pipegs_pkg::span_t     pixels_i,      // where they may lie

  input  logic [1:0]            full_i,  // levels
  input  logic [2*AddressW-1:0] full_line_i,
  input  logic                  bad_i,
  input  logic [AddressW-1:0]   bad_line_i,

  output logic [1:0]            error_o,
  output logic [2*AddressW-1:0] error_line_o,
  output logic                  stop_o
);

  logic unused_raster;  // where the frame begins
  assign unused_raster = &{1'b0, raster_i};

  localparam int unsigned WindowW = pipegs_pkg::WindowW;
  localparam int unsigned SizeW   = pipegs_pkg::SizeW;
  localparam int unsigned StrideW = pipegs_pkg::StrideW;
  localparam int unsigned Shift   = $clog2(pipegs_pkg::Window);
  localparam int unsigned SideW   = WindowW + Shift + 1;  // pixels
  localparam int unsigned NumberW = 2 * WindowW + 1;
  localparam int unsigned LinesW  = $clog2(pipegs_pkg::RegionLines * pipegs_pkg::Squares * pipegs_pkg::MaskW);
  localparam int unsigned TilesW  = NumberW + LinesW;
  localparam int unsigned RowsW   = SizeW + StrideW + 1;
  localparam int unsigned NeedW   = TilesW > RowsW ? TilesW : RowsW;
  localparam int unsigned MostW   = (NeedW > AddressW ? NeedW : AddressW) + (pipegs_pkg::Eyes > 1 ? 1 : 0);
  localparam int unsigned InLine  = $clog2(pipegs_pkg::MemoryW / 32);  // pixels of raster order in a line, log2

  // --- pixels: by windows all up to the last one of the frame; else to the last row and column of the frame ---------
  logic [WindowW:0]   columns;  // windows in a row of the picture
  logic [NumberW-1:0] windows_q;
  logic [SideW-1:0]   right, below;     // of the frame: the first column and row behind its last window
  logic [SizeW-1:0]   rows_q, width_q;  // of the picture that may be written
  logic [NeedW-1:0]   raster, need_q;   // lines
  logic [MostW-1:0]   need;
  logic [1:0]         begun_q;
  logic               no_room;

  assign columns = (WindowW+1)'(((SizeW+1)'(raster_i.width) + (SizeW+1)'(pipegs_pkg::Window - 1)) >> Shift);
  assign right   = (SideW'(raster_i.windows.last_x) + 1'b1) << Shift;
  assign below   = (SideW'(raster_i.windows.last_y) + 1'b1) << Shift;
  assign raster  = NeedW'(SizeW'(rows_q - 1'b1)) * NeedW'(stride_i) +
                   (NeedW'(SizeW'(width_q - 1'b1)) >> InLine) + NeedW'(1);
  if (pipegs_pkg::Eyes > 1) begin : gen_eyes  // up to the end of the second one's picture
    assign need = MostW'(need_q) + (raster_i.eyes[1] ? MostW'(raster_i.eye_lines) : '0);
  end else begin : gen_one_eye
    assign need = MostW'(need_q);
  end
  assign no_room = begun_q[1] && need > MostW'(pixels_i.lines);

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begun_q <= '0;
    else begun_q <= {begun_q[0], restart_i};
  end
  always_ff @(posedge clk_i) begin
    if (restart_i) begin
      windows_q <= NumberW'(raster_i.windows.last_y) * NumberW'(columns) + NumberW'(raster_i.windows.last_x) +
                   NumberW'(1);
      rows_q    <= below < SideW'(raster_i.height) ? SizeW'(below) : raster_i.height;
      width_q   <= right < SideW'(raster_i.width) ? SizeW'(right) : raster_i.width;
    end
    if (begun_q[0]) begin
      need_q <= by_windows_i ? NeedW'(windows_q) << LinesW : raster;
    end
  end

  // --- causes -------------------------------------------------------------------------------------------------------
  logic                  full;
  logic [AddressW-1:0]   full_line;
  logic [1:0]            found, known_q, error_q;
  logic [2*AddressW-1:0] line_q;

  localparam int unsigned Places = pipegs_pkg::HasAovs ? 2 : 1;
  logic [Places-1:0]          outgrown;
  logic [Places*AddressW-1:0] ends;
  assign outgrown[0]         = no_room;
  assign ends[AddressW-1:0]  = pixels_i.first + pixels_i.lines;
  if (pipegs_pkg::HasAovs) begin : gen_aovs
    assign outgrown[1] = begun_q[1] && raster_i.aovs.wanted != '0 && need > MostW'(raster_i.aovs.lines);
    assign ends[AddressW +: AddressW] = raster_i.aovs.base + raster_i.aovs.lines;
  end
  pipegs_first_line #(.Ports(2 + Places)) u_full (
    .valid_i({full_i, outgrown}),
    .line_i({full_line_i, ends}),
    .valid_o(full),
    .line_o(full_line)
  );
  assign found = {bad_i, full};

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      known_q <= '0;
      error_q <= '0;
    end else begin
      known_q <= known_q | found;
      error_q <= found & ~known_q;
    end
  end
  always_ff @(posedge clk_i) begin
    if (found[0] && !known_q[0]) line_q[0 +: AddressW] <= full_line;
    if (found[1] && !known_q[1]) line_q[AddressW +: AddressW] <= bad_line_i;
  end

  assign error_o      = error_q;
  assign error_line_o = line_q;
  assign stop_o       = known_q != '0;

endmodule
