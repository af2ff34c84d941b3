// SPDX-License-Identifier: Apache-2.0
// dopu_planes: the five planes that bound what a window, or a part of it, can see.
//
// Paper   Sec. 4.1; windows are ours (docs/units/dopu.md).
// Idea    A side's world-space normal is n = focal * side row - edge * forward row, edge = pixel - centre -+ 2. One
//         multiplier makes the six products of a side one after another, then n and reach are floored to TestW bits
//         with one unit.
// Stream  window: column, row and walk in, and what of it is closed. planes: near, left, right, top, bottom out, near
//         in the low bits.
// Pace    One window per 4 * 13 cycles, hidden behind the walk of the window before.
// Model   cpp_model/dopu/dopu_planes.hpp

module dopu_planes (
  input  logic                                clk_i,
  input  logic                                rst_ni,

  input  pipegs_pkg::rotation_t               rotation_i,
  input  pipegs_pkg::lens_t                   lens_i,
  input  pipegs_pkg::raster_t                 raster_i,

  input  logic                                window_valid_i,
  output logic                                window_ready_o,
  input  logic [pipegs_pkg::PlaceW-1:0]       window_i,
  input  pipegs_pkg::closed_t                 closed_i,  // what of it is closed: the planes are those of the rest

  output logic                                planes_valid_o,
  input  logic                                planes_ready_i,
  output logic [5*pipegs_pkg::PlaneBits-1:0]  planes_o
);

  localparam int unsigned RotW = pipegs_pkg::RotW;
  localparam int unsigned TestW = pipegs_pkg::TestW;
  localparam int unsigned PlaneBits = pipegs_pkg::PlaneBits;
  localparam int unsigned WindowW = pipegs_pkg::WindowW;
  localparam int unsigned WindowPixelW = WindowW + $clog2(pipegs_pkg::Window) + 1;
  localparam int unsigned HalfF = $clog2(pipegs_pkg::Window) - 1;                  // half a window's side
  localparam int unsigned EdgeW = WindowPixelW + pipegs_pkg::CenterF + 2;          // s17.12
  localparam int unsigned ProductW = EdgeW + RotW;
  localparam int unsigned Align = pipegs_pkg::FocalF - pipegs_pkg::CenterF;        // edges to focal lengths
  localparam int unsigned NormalW = pipegs_pkg::ReachW + pipegs_pkg::RotF + 4;     // s21.38
  localparam int unsigned ShiftW = $clog2(NormalW + 1);
  localparam int unsigned Drop = RotW - TestW;                                     // rotation entries to TestW bits
  localparam logic [3:0] LastStep = 4'd12;

  // Steps of one side. Operands of product k are loaded in step k, multiplied in k + 1, added in k + 2;
  // 8: the common shift; 9 to 12: three normals and the reach through one shifter.
  logic       busy_q, done_q;
  logic [1:0] side_q;  // left, right, top, bottom
  logic [3:0] step_q;
  logic [pipegs_pkg::PlaceW-1:0] window_q;
  pipegs_pkg::closed_t           closed_q;

  assign window_ready_o = !busy_q && !done_q;
  assign planes_valid_o = done_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      busy_q <= 1'b0;
      done_q <= 1'b0;
      side_q <= '0;
      step_q <= '0;
    end else begin
      if (window_valid_i && window_ready_o) busy_q <= 1'b1;
      if (busy_q) begin
        step_q <= step_q == LastStep ? '0 : step_q + 1'b1;
        if (step_q == LastStep) side_q <= side_q + 1'b1;
        if (step_q == LastStep && side_q == 2'd3) begin
          busy_q <= 1'b0;
          done_q <= 1'b1;
        end
      end
      if (done_q && planes_ready_i) done_q <= 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (window_valid_i && window_ready_o) {closed_q, window_q} <= {closed_i, window_i};
  end

  // --- the edge of this side, s17.12 -------------------------------------------------------------------------------
  logic                                  vertical, far;  // top or bottom; right or bottom
  logic                                  half, behind;   // one part is walked: half a side; the second one along it
  logic [WindowW-1:0]                    window;         // column or row
  logic [WindowPixelW-1:0]               walk_pixel, first_pixel, end_pixel, size, pixel;
  logic [pipegs_pkg::ClosedW-1:0]        closed_low, closed_high;
  logic signed [EdgeW-1:0]               center, margin, edge_d;
  logic [pipegs_pkg::ReachW-1:0]         reach;

  assign vertical    = side_q[1];
  assign far         = side_q[0];
  assign size        = vertical ? WindowPixelW'(raster_i.height) : WindowPixelW'(raster_i.width);
  assign window      = vertical ? window_q[WindowW +: WindowW] : window_q[0 +: WindowW];
  assign closed_low  = vertical ? closed_q.top : closed_q.left;
  assign closed_high = vertical ? closed_q.bottom : closed_q.right;
  assign walk_pixel  = WindowPixelW'({window, behind}) << HalfF;
  assign first_pixel = walk_pixel + (WindowPixelW'(closed_low) << 3);
  // With lists the rectangle of this window to the frame's last one.
  if (pipegs_pkg::HasLists) begin : gen_frame
    logic [pipegs_pkg::WindowW-1:0] last_window;
    assign last_window = vertical ? raster_i.windows.last_y : raster_i.windows.last_x;
    assign end_pixel   = (WindowPixelW'(last_window) + 1'b1) << $clog2(pipegs_pkg::Window);
  end else begin : gen_window
    assign end_pixel = walk_pixel + (half ? WindowPixelW'(pipegs_pkg::Window / 2) : WindowPixelW'(pipegs_pkg::Window))
                       - (WindowPixelW'(closed_high) << 3);
  end
  if (pipegs_pkg::HasWalks) begin : gen_walk
    assign half   = window_q[pipegs_pkg::PlaceW-1];
    assign behind = vertical ? window_q[pipegs_pkg::PlaceW-2] : window_q[pipegs_pkg::PlaceW-3];
  end else begin : gen_whole
    assign half   = 1'b0;
    assign behind = 1'b0;
  end
  assign pixel       = far ? (end_pixel < size ? end_pixel : size) - 1'b1 : first_pixel;
  assign center      = vertical ? EdgeW'(lens_i.center_y) : EdgeW'(lens_i.center_x);
  assign margin      = EdgeW'(pipegs_pkg::ReachMargin) <<< pipegs_pkg::CenterF;
  assign edge_d      = (EdgeW'(pixel) <<< pipegs_pkg::CenterF) - center + (far ? margin : -margin);
  assign reach       = vertical ? lens_i.reach_y : lens_i.reach_x;

  // --- products -----------------------------------------------------------------------------------------------------
  logic signed [EdgeW-1:0]    edge_q, left_q;
  logic signed [RotW-1:0]     right_d, right_q;
  logic signed [ProductW-1:0] product_q;
  logic signed [NormalW-1:0]  focal_part_q, exact, normal;
  logic signed [NormalW-1:0]  normal_q [3];
  logic [NormalW-1:0]         magnitudes_q;
  logic [3:0]                 added;  // the product that is added in this step

  always_comb begin
    case ({step_q[2:0], vertical})
      {3'd0, 1'b0}: right_d = rotation_i.w00;
      {3'd2, 1'b0}: right_d = rotation_i.w01;
      {3'd4, 1'b0}: right_d = rotation_i.w02;
      {3'd0, 1'b1}: right_d = rotation_i.w10;
      {3'd2, 1'b1}: right_d = rotation_i.w11;
      {3'd4, 1'b1}: right_d = rotation_i.w12;
      {3'd1, 1'b0}, {3'd1, 1'b1}: right_d = rotation_i.w20;
      {3'd3, 1'b0}, {3'd3, 1'b1}: right_d = rotation_i.w21;
      default: right_d = rotation_i.w22;
    endcase
  end
  assign added  = step_q - 4'd2;
  assign exact  = focal_part_q - (NormalW'(product_q) <<< Align);
  assign normal = far ? -exact : exact;

  always_ff @(posedge clk_i) begin
    edge_q    <= edge_d;
    left_q    <= step_q[0] ? edge_q : EdgeW'({1'b0, vertical ? lens_i.focal_y : lens_i.focal_x});
    right_q   <= right_d;
    product_q <= ProductW'(left_q) * ProductW'(right_q);
    if (!added[0]) focal_part_q <= NormalW'(product_q);
    if (step_q == '0) magnitudes_q <= NormalW'(reach) << pipegs_pkg::RotF;
    for (int unsigned i = 0; i < 3; i += 1) begin
      if (added == 4'(2 * i + 1)) begin
        normal_q[i]  <= normal;
        magnitudes_q <= magnitudes_q | (normal[NormalW-1] ? ~normal : normal);
      end
    end
  end

  // --- block normalisation -----------------------------------------------------------------------------------------
  logic [$clog2(NormalW+1)-1:0] length;
  logic [ShiftW-1:0]         shift_q;
  logic signed [NormalW-1:0] chosen;
  logic [NormalW-1:0]        shifted;
  logic [4*PlaneBits-1:0]    planes_q;

  pipegs_bit_length #(.DataW(NormalW)) u_length (
    .in_i(magnitudes_q),
    .length_o(length)
  );
  always_comb begin
    case (step_q)
      4'd9: chosen = normal_q[0];
      4'd10: chosen = normal_q[1];
      4'd11: chosen = normal_q[2];
      default: chosen = NormalW'({1'b0, reach}) <<< pipegs_pkg::RotF;
    endcase
  end
  assign shifted = chosen >>> shift_q;
  logic unused_shifted;  // sign bits beyond TestW
  assign unused_shifted = ^shifted[NormalW-1:TestW];

  always_ff @(posedge clk_i) begin
    shift_q <= length > ShiftW'(TestW - 1) ? length - ShiftW'(TestW - 1) : '0;
    // Each side's four numbers enter at the top, first one first: after 16 of them left lies lowest.
    if (busy_q && step_q >= 4'd9) planes_q <= {shifted[TestW-1:0], planes_q[4*PlaneBits-1:TestW]};
  end

  pipegs_pkg::plane_t near_plane;
  always_comb begin
    near_plane.nx    = rotation_i.w20[RotW-1:Drop];
    near_plane.ny    = rotation_i.w21[RotW-1:Drop];
    near_plane.nz    = rotation_i.w22[RotW-1:Drop];
    near_plane.reach = -(TestW'(1) << (pipegs_pkg::RotF - Drop));
  end
  assign planes_o = {planes_q, near_plane};

  logic unused_frame;  // what does not matter here
  assign unused_frame = &{1'b0, half, closed_high, lens_i, raster_i};

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits(planes_o)), .Proven(1)) u_check_planes (
    .clk_i,
    .rst_ni,
    .valid_i(planes_valid_o),
    .ready_i(planes_ready_i),
    .beat_i(planes_o)
  );
`endif

endmodule
