// SPDX-License-Identifier: Apache-2.0
// pipegs_rsqrt: 1/sqrt(u) of a normalised number by one table look-up and one multiplication.
//
// Idea    Newton's step y (3 - u y^2) / 2 from a fixed y is linear in u, so the table can hold the step itself: for
//         each of 64 intervals of [1, 2) and of [2, 4) the line c0 - c1 f, f in [0, 1) the place in the interval.
// Stream  u_i, u2.18 in [1, 4) -> r_o, u0.18 in (1/2, 1), rounded to nearest; |r sqrt(u) - 1| <= 2^-16.1.
// Pace    One per cycle, latency two cycles, no handshake: r_o always belongs to the u_i of two cycles ago.
// Model   cpp_model/lib/math/rsqrt.hpp
// Table   {c1, c0}, both with 20 fraction bits; line i < 64 covers 1 + [i, i+1)/64, the others 2 + [i-64, i-63)/32.

module pipegs_rsqrt #(
  localparam int unsigned InW = 20,   // u2.18
  localparam int unsigned OutW = 18   // u0.18
) (
  input  logic            clk_i,

  input  logic [InW-1:0]  u_i,
  output logic [OutW-1:0] r_o
);

  localparam int unsigned TableF = 20;                  // c0 < 1
  localparam int unsigned SlopeW = 13;                  // c1 < 2^-7
  localparam int unsigned PlaceW = 13;                  // f
  localparam int unsigned ExactW = TableF + PlaceW;     // c0 - c1 f
  localparam int unsigned DropF = ExactW - OutW;        // bits rounded away
  localparam int unsigned IndexW = 7;

  logic [IndexW-1:0]        index;
  logic [PlaceW-1:0]        place, place_q;
  logic [SlopeW+TableF-1:0] line, line_q;
  logic [ExactW-1:0]        exact;
  logic [OutW-1:0]          r_q;

  assign index = u_i[InW-1] ? {1'b1, u_i[InW-2 -: IndexW-1]} : {1'b0, u_i[InW-3 -: IndexW-1]};
  assign place = u_i[InW-1] ? u_i[PlaceW-1:0] : {u_i[PlaceW-2:0], 1'b0};

  always_comb begin
    line = '0;
    unique case (index)
        0: line = 33'h1fa1ffff4;   1: line = 33'h1ee9fe053;   2: line = 33'h1e37fc16b;
        3: line = 33'h1d8bfa335;   4: line = 33'h1ce6f85aa;   5: line = 33'h1c47f68c4;
        6: line = 33'h1baef4c7d;   7: line = 33'h1b1af30d0;   8: line = 33'h1a8bf15b6;
        9: line = 33'h1a00efb2c;  10: line = 33'h197bee12c;  11: line = 33'h18faec7b1;
       12: line = 33'h187deaeb8;  13: line = 33'h1804e963b;  14: line = 33'h178fe7e38;
       15: line = 33'h171de66a9;  16: line = 33'h16afe4f8c;  17: line = 33'h1645e38dd;
       18: line = 33'h15dde2298;  19: line = 33'h1579e0cbb;  20: line = 33'h1518df742;
       21: line = 33'h14b9de22a;  22: line = 33'h145edcd71;  23: line = 33'h1405db914;
       24: line = 33'h13aeda50f;  25: line = 33'h135ad9161;  26: line = 33'h1308d7e08;
       27: line = 33'h12b8d6b00;  28: line = 33'h126bd5848;  29: line = 33'h121fd45dd;
       30: line = 33'h11d6d33be;  31: line = 33'h118ed21e9;  32: line = 33'h1149d105a;
       33: line = 33'h1105cff12;  34: line = 33'h10c3cee0d;  35: line = 33'h1082cdd4b;
       36: line = 33'h1043cccc9;  37: line = 33'h1006cbc86;  38: line = 33'h0fcacac80;
       39: line = 33'h0f8fc9cb6;  40: line = 33'h0f56c8d27;  41: line = 33'h0f1fc7dd1;
       42: line = 33'h0ee8c6eb2;  43: line = 33'h0eb3c5fca;  44: line = 33'h0e7fc5117;
       45: line = 33'h0e4dc4298;  46: line = 33'h0e1bc344b;  47: line = 33'h0deac2630;
       48: line = 33'h0dbbc1846;  49: line = 33'h0d8dc0a8b;  50: line = 33'h0d5fbfcfe;
       51: line = 33'h0d33bef9f;  52: line = 33'h0d08be26c;  53: line = 33'h0cddbd564;
       54: line = 33'h0cb4bc887;  55: line = 33'h0c8bbbbd4;  56: line = 33'h0c63baf49;
       57: line = 33'h0c3cba2e6;  58: line = 33'h0c16b96ab;  59: line = 33'h0bf0b8a95;
       60: line = 33'h0bcbb7ea5;  61: line = 33'h0ba7b72da;  62: line = 33'h0b84b6732;
       63: line = 33'h0b61b5bae;  64: line = 33'h165eb5047;  65: line = 33'h15dbb39ea;
       66: line = 33'h155db240f;  67: line = 33'h14e4b0eb2;  68: line = 33'h146faf9ce;
       69: line = 33'h13ffae55f;  70: line = 33'h1392ad160;  71: line = 33'h132aabdce;
       72: line = 33'h12c5aaaa4;  73: line = 33'h1263a97e0;  74: line = 33'h1204a857e;
       75: line = 33'h11a9a7379;  76: line = 33'h1151a61d1;  77: line = 33'h10fba5080;
       78: line = 33'h10a8a3f85;  79: line = 33'h1058a2edd;  80: line = 33'h100aa1e85;
       81: line = 33'h0fbfa0e7b;  82: line = 33'h0f769febc;  83: line = 33'h0f2f9ef46;
       84: line = 33'h0eea9e017;  85: line = 33'h0ea89d12d;  86: line = 33'h0e679c285;
       87: line = 33'h0e289b41f;  88: line = 33'h0dea9a5f7;  89: line = 33'h0daf9980d;
       90: line = 33'h0d7598a5e;  91: line = 33'h0d3d97cea;  92: line = 33'h0d0696fad;
       93: line = 33'h0cd0962a7;  94: line = 33'h0c9d955d7;  95: line = 33'h0c6a9493a;
       96: line = 33'h0c3993cd1;  97: line = 33'h0c0993098;  98: line = 33'h0bda9248f;
       99: line = 33'h0bac918b6; 100: line = 33'h0b8090d09; 101: line = 33'h0b549018a;
      102: line = 33'h0b2a8f635; 103: line = 33'h0b018eb0b; 104: line = 33'h0ad88e00b;
      105: line = 33'h0ab18d533; 106: line = 33'h0a8b8ca82; 107: line = 33'h0a658bff7;
      108: line = 33'h0a408b592; 109: line = 33'h0a1c8ab52; 110: line = 33'h09f98a136;
      111: line = 33'h09d78973c; 112: line = 33'h09b688d65; 113: line = 33'h0995883b0;
      114: line = 33'h097587a1b; 115: line = 33'h0955870a6; 116: line = 33'h093786751;
      117: line = 33'h091985e1b; 118: line = 33'h08fb85502; 119: line = 33'h08de84c07;
      120: line = 33'h08c284329; 121: line = 33'h08a783a66; 122: line = 33'h088b831c0;
      123: line = 33'h087182934; 124: line = 33'h0857820c4; 125: line = 33'h083e8186d;
      126: line = 33'h08258102f; 127: line = 33'h080c8080b;
    endcase
  end

  // c0 lies at the top; the half of the last bit kept is added before the rest is dropped.
  assign exact = {line_q[TableF-1:0], PlaceW'(0)} - ExactW'(line_q[TableF +: SlopeW]) * ExactW'(place_q) +
                 (ExactW'(1) << (DropF - 1));

  always_ff @(posedge clk_i) begin
    line_q  <= line;
    place_q <= place;
    r_q     <= exact[DropF +: OutW];
  end
  assign r_o = r_q;

  wire unused_bits = &{1'b0, u_i[InW-2], exact[DropF-1:0]};

endmodule
