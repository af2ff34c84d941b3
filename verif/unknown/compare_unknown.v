// SPDX-License-Identifier: Apache-2.0
// compare_unknown: comparisons for a simulator of four states, put in by Yosys' techmap: the highest bits decide.
//
// Idea    Verilog's `<` is X as soon as any bit is; a comparator of gates does not care about bits below the first
//         ones that differ, and the sorter of empty places behind full ones relies on that.

(* techmap_celltype = "$lt $le $gt $ge" *)
module compare_unknown (A, B, Y);
  parameter A_SIGNED = 0;
  parameter B_SIGNED = 0;
  parameter A_WIDTH = 1;
  parameter B_WIDTH = 1;
  parameter Y_WIDTH = 1;
  parameter _TECHMAP_CELLTYPE_ = "";

  localparam Width = A_WIDTH > B_WIDTH ? A_WIDTH : B_WIDTH;
  localparam Signed = A_SIGNED && B_SIGNED;
  localparam Swapped = _TECHMAP_CELLTYPE_ == "$gt" || _TECHMAP_CELLTYPE_ == "$le";
  localparam Inverted = _TECHMAP_CELLTYPE_ == "$ge" || _TECHMAP_CELLTYPE_ == "$le";

  input  [A_WIDTH-1:0] A;
  input  [B_WIDTH-1:0] B;
  output [Y_WIDTH-1:0] Y;

  wire [Width-1:0] a, b, x, y;
  wire [Width:0]   less;  // in the bits below: x < y

  \$pos #(.A_SIGNED(Signed), .A_WIDTH(A_WIDTH), .Y_WIDTH(Width)) u_a (.A(A), .Y(a));
  \$pos #(.A_SIGNED(Signed), .A_WIDTH(B_WIDTH), .Y_WIDTH(Width)) u_b (.A(B), .Y(b));
  assign x = Swapped ? b : a;
  assign y = Swapped ? a : b;
  assign less[0] = 1'b0;
  genvar i;
  generate
    for (i = 0; i < Width; i = i + 1) begin : gen_bit
      assign less[i+1] = (x[i] ^ y[i]) ? (Signed && i == Width - 1 ? x[i] : y[i]) : less[i];
    end
  endgenerate
  assign Y = Inverted ? !less[Width] : less[Width];
endmodule
