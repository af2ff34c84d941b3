// SPDX-License-Identifier: Apache-2.0
// pu_touch: does the oriented box of a Gaussian touch a square of pixel centres? Stepped from square to square.
//
// Paper   GSCore's test of a tile and of its four subtiles, from which the paper's baseline is reproduced (Sec. 5.2).
// Idea    With (dx, dy) from the square's middle to the mean, u = dx + tilt dy and v = dy - tilt dx:
//           |u| <= side_u + h (1 + |tilt|)   and   |v| <= side_v + h (1 + |tilt|),   h = (Side - 1) / 2
//         A square to the right has u - Side and v + Side tilt, one below u - Side tilt and v - Side.
//         Apart along x or y is for the caller, who walks the columns and rows of the box's extents only.
// Stream  load_i: box and first square; step_i: Stride squares to the right, or with down_i the first one of the next
//         row. touches_o is of the square that was stepped to last.
// Pace    One square per cycle; the first one in the cycle after load_i.
// Model   cpp_model/pu/box/pu_touch.hpp

module pu_touch #(
  parameter int unsigned Side   = 8,  // pixels, a power of two, 8 or more
  parameter int unsigned Stride = 1,
  parameter int unsigned Ahead  = 0,  // squares to the right of the one that is loaded
  parameter int unsigned DataW  = pipegs_pkg::MeanW + 2,
  localparam int unsigned TiltW = pipegs_pkg::TiltW,
  localparam int unsigned SideW = pipegs_pkg::SideW
) (
  input  logic                    clk_i,

  input  logic                    load_i,
  input  logic signed [DataW-1:0] dx_i,      // twice the way from the first square's middle to the mean, MeanF fraction
  input  logic signed [DataW-1:0] dy_i,      // bits
  input  logic signed [TiltW-1:0] tilt_i,
  input  logic [SideW-1:0]        side_u_i,
  input  logic [SideW-1:0]        side_v_i,

  input  logic                    step_i,
  input  logic                    down_i,

  output logic                    touches_o
);

  localparam int unsigned TiltF   = TiltW - 2;
  localparam int unsigned SideF   = 8;
  localparam int unsigned TouchF  = 13;                                // so Side tilt is whole
  localparam int unsigned CutBy   = pipegs_pkg::MeanF + 1 + TiltF - TouchF;
  localparam int unsigned ExactW  = DataW + TiltF + 2;
  localparam int unsigned TouchW  = ExactW - CutBy + 1;
  localparam int unsigned LimitW  = SideW + TouchF - SideF + 1;
  localparam int unsigned StepLog = $clog2(Side) - 3;                  // of eight pixels
  localparam int unsigned HalfW   = TiltW + $clog2(Side);
  localparam logic signed [TouchW-1:0] Right = TouchW'(Side * Stride) <<< TouchF;
  localparam logic signed [TouchW-1:0] Down  = TouchW'(Side) <<< TouchF;
  localparam logic signed [TouchW-1:0] Begin = TouchW'(Side * Ahead) <<< TouchF;
  localparam logic [LimitW-1:0]        Half  = (LimitW'(Side) - LimitW'(1)) << (TouchF - 1);

  logic signed [ExactW-1:0] exact_u, exact_v;
  logic signed [TouchW-1:0] u_start, v_start, u_q, v_q, u_row_q, v_row_q, u_from, v_from, u_next, v_next, tilt_side,
                            tilt_right, tilt_begin;
  logic signed [TiltW-1:0]  tilt_q;
  logic [TiltW-1:0]         size;
  logic [HalfW-1:0]         half_tilt;
  logic [LimitW-1:0]        limit_u_q, limit_v_q, half;

  assign exact_u    = (ExactW'(dx_i) <<< TiltF) + ExactW'(tilt_i) * ExactW'(dy_i);
  assign exact_v    = (ExactW'(dy_i) <<< TiltF) - ExactW'(tilt_i) * ExactW'(dx_i);
  assign tilt_begin = (TouchW'(tilt_i) * TouchW'(Ahead)) <<< StepLog;
  assign u_start    = TouchW'(exact_u >>> CutBy) - Begin;
  assign v_start    = TouchW'(exact_v >>> CutBy) + tilt_begin;
  assign size       = tilt_i[TiltW-1] ? TiltW'(-tilt_i) : TiltW'(tilt_i);
  assign half_tilt  = HalfW'(size) * (HalfW'(Side) - HalfW'(1));
  assign half       = Half + (LimitW'(half_tilt) >> (TiltF + 1 - TouchF));

  assign tilt_side  = TouchW'(tilt_q) <<< StepLog;
  assign tilt_right = tilt_side * TouchW'(Stride);
  assign u_from     = down_i ? u_row_q : u_q;
  assign v_from     = down_i ? v_row_q : v_q;
  assign u_next     = down_i ? u_from - tilt_side : u_from - Right;
  assign v_next     = down_i ? v_from - Down : v_from + tilt_right;

  always_ff @(posedge clk_i) begin
    if (load_i) begin
      tilt_q    <= tilt_i;
      limit_u_q <= (LimitW'(side_u_i) << (TouchF - SideF)) + half;
      limit_v_q <= (LimitW'(side_v_i) << (TouchF - SideF)) + half;
      {u_q, u_row_q} <= {u_start, u_start};
      {v_q, v_row_q} <= {v_start, v_start};
    end else if (step_i) begin
      u_q <= u_next;
      v_q <= v_next;
      if (down_i) begin
        u_row_q <= u_next;
        v_row_q <= v_next;
      end
    end
  end

  logic [TouchW-1:0] u_size, v_size;
  assign u_size    = u_q[TouchW-1] ? TouchW'(-u_q) : TouchW'(u_q);
  assign v_size    = v_q[TouchW-1] ? TouchW'(-v_q) : TouchW'(v_q);
  localparam int unsigned CompareW = TouchW > LimitW ? TouchW : LimitW;
  assign touches_o = CompareW'(u_size) <= CompareW'(limit_u_q) && CompareW'(v_size) <= CompareW'(limit_v_q);

endmodule
