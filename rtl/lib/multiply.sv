// multiply: the product of two signed numbers, for the multiplier that a path waits for.
//
// Idea    Baugh and Wooley. With A = A' - a 2^m and B = B' - b 2^n (a, b the sign bits, A', B' without sign)
//           A B = A' B' + a b 2^(m+n) - a B' 2^m - b A' 2^n,    -X 2^k = ~X 2^k + 2^k - 2^(k + width of X)
//         so every row that is added is unsigned and short. Yosys extends the rows of a signed `*` by their sign to the full
//         width, which costs a twentieth of area and time.
// Stream  Combinational. left_i, right_i: signed, at least three bits; out_o: exact.
// Model   The operator * in the test.

module multiply #(
  parameter int unsigned LeftW = 8,
  parameter int unsigned RightW = 8,
  localparam int unsigned OutW = LeftW + RightW
) (
  input  logic signed [LeftW-1:0]  left_i,
  input  logic signed [RightW-1:0] right_i,
  output logic signed [OutW-1:0]   out_o
);

  localparam int unsigned M = LeftW - 1;
  localparam int unsigned N = RightW - 1;
  localparam logic [OutW-1:0] One = 1;
  localparam logic [OutW-1:0] Constant = (One << M) + (One << N) - (One << (M + N + 1));  // bit M + N is 0

  logic [OutW-1:0] magnitudes, right_row, left_row, signs;
  assign magnitudes = OutW'(left_i[M-1:0]) * OutW'(right_i[N-1:0]);
  assign right_row  = {2'b0, ~(right_i[N-1:0] & {N{left_i[M]}}), {M{1'b0}}};
  assign left_row   = {2'b0, ~(left_i[M-1:0] & {M{right_i[N]}}), {N{1'b0}}};
  assign signs      = Constant | OutW'({left_i[M] && right_i[N], {(M + N){1'b0}}});
  assign out_o      = $signed(magnitudes + right_row + left_row + signs);

endmodule
