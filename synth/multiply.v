// multiply.v: how synth.py maps a product of two signed numbers (techmap of Yosys' $mul): Baugh and Wooley.
//
// Idea    With A = A' - a 2^m, B = B' - b 2^n (a, b the sign bits, A', B' without sign):
//           A B = A' B' + a b 2^(m+n) - b A' 2^n - a B' 2^m,    -X 2^k = ~X 2^k + 2^k - 2^(k + width of X)
//         so the rows that are added are unsigned and short. Yosys by itself extends every row by its sign to the full width, which
//         costs up to a twentieth of a multiplier's area and time.

(* techmap_celltype = "$mul" *)
module signed_multiply (A, B, Y);

  parameter A_SIGNED = 0;
  parameter B_SIGNED = 0;
  parameter A_WIDTH = 1;
  parameter B_WIDTH = 1;
  parameter Y_WIDTH = 1;
  input [A_WIDTH-1:0] A;
  input [B_WIDTH-1:0] B;
  output [Y_WIDTH-1:0] Y;

  wire _TECHMAP_FAIL_ = !A_SIGNED || !B_SIGNED || A_WIDTH < 3 || B_WIDTH < 3;

  localparam M = A_WIDTH - 1;
  localparam N = B_WIDTH - 1;
  localparam ProductW = A_WIDTH + B_WIDTH;
  localparam W = ProductW < Y_WIDTH ? ProductW : Y_WIDTH;
  localparam [ProductW-1:0] One = 1;
  localparam [ProductW-1:0] Constant = (One << M) + (One << N) - (One << (M + N + 1));  // bit M + N is 0

  wire [W-1:0] magnitudes = A[M-1:0] * B[N-1:0];
  wire [ProductW-1:0] b_row = {~(B[N-1:0] & {N{A[M]}}), {M{1'b0}}};
  wire [ProductW-1:0] a_row = {~(A[M-1:0] & {M{B[N]}}), {N{1'b0}}};
  wire [ProductW-1:0] signs = Constant | ((One & {ProductW{A[M] & B[N]}}) << (M + N));
  wire [W-1:0] product = magnitudes + b_row + a_row + signs;

  generate
    if (Y_WIDTH > ProductW) assign Y = {{(Y_WIDTH - ProductW){product[W-1]}}, product};
    else assign Y = product;
  endgenerate

endmodule
