// SPDX-License-Identifier: Apache-2.0
// pipegs_sqrt: the square root of a number from 15/64 to 1 by one table look-up and one multiplication.
//
// Idea    v = (i + r / 2048) / 64: sqrt(v) ~ value[i] + delta[i] r / 2048: 49 chords, i from 15 on, raised by half of
//         their largest error, so that the error swings evenly between + and -. One gives one; below 15/64, where no
//         input should be, entry 15 stands for all.
// Stream  v_i, u1.17 -> root_o, u1.17, rounded to nearest; error at most 3.8e-5.
// Pace    One per cycle, latency two cycles while enable_i, no handshake.
// Model   cpp_model/lib/math/sqrt.hpp
// Table   {delta, value}, both with 18 fraction bits; printed values of sqrt_table().

module pipegs_sqrt #(
  localparam int unsigned DataW = 18  // u1.17
) (
  input  logic             clk_i,
  input  logic             enable_i,

  input  logic [DataW-1:0] v_i,
  output logic [DataW-1:0] root_o
);

  localparam int unsigned TableF = 18;
  localparam int unsigned DeltaW = 13;               // delta < 2^-5
  localparam int unsigned IndexW = 6;
  localparam int unsigned PlaceW = DataW - 1 - IndexW;
  localparam int unsigned ExactW = TableF + 1 + PlaceW;
  localparam int unsigned DropF  = TableF + PlaceW - (DataW - 1);  // bits rounded away

  logic [PlaceW-1:0]        place_q;
  logic [DeltaW+TableF-1:0] line, line_q;
  logic [ExactW-1:0]        exact;
  logic                     one_q;
  logic [DataW-1:0]         root_q;

  always_comb begin
    unique case (v_i[DataW-2 -: IndexW])
      15: line = 31'h4109efc6;
      16: line = 31'h3f0a0008; 17: line = 31'h3d360fc9; 18: line = 31'h3b8a1f15; 19: line = 31'h39fe2df6;
      20: line = 31'h388e3c74; 21: line = 31'h373a4a97; 22: line = 31'h35fa5864; 23: line = 31'h34d265e2;
      24: line = 31'h33ba7316; 25: line = 31'h32b68004; 26: line = 31'h31be8cb0; 27: line = 31'h30d2991f;
      28: line = 31'h2ff6a553; 29: line = 31'h2f26b150; 30: line = 31'h2e5ebd19; 31: line = 31'h2d9ec8af;
      32: line = 31'h2cead417; 33: line = 31'h2c3edf50; 34: line = 31'h2b96ea5f; 35: line = 31'h2afaf545;
      36: line = 31'h2a630002; 37: line = 31'h29d30a9a; 38: line = 31'h2947150e; 39: line = 31'h28bf1f5e;
      40: line = 31'h283f298d; 41: line = 31'h27bf339b; 42: line = 31'h27473d8b; 43: line = 31'h26d3475c;
      44: line = 31'h26635110; 45: line = 31'h25f75aa8; 46: line = 31'h258f6425; 47: line = 31'h25276d88;
      48: line = 31'h24c776d1; 49: line = 31'h24678001; 50: line = 31'h240b891a; 51: line = 31'h23af921c;
      52: line = 31'h23579b07; 53: line = 31'h2303a3dc; 54: line = 31'h22afac9c; 55: line = 31'h225fb547;
      56: line = 31'h2213bdde; 57: line = 31'h21c7c662; 58: line = 31'h217bced3; 59: line = 31'h2133d731;
      60: line = 31'h20ebdf7d; 61: line = 31'h20a7e7b7; 62: line = 31'h2063efe1; 63: line = 31'h2023f7f9;
      default: line = 31'h4109efc6;
    endcase
  end

  assign exact = {1'b0, line_q[TableF-1:0], PlaceW'(0)} + ExactW'(line_q[TableF +: DeltaW]) * ExactW'(place_q) +
                 (ExactW'(1) << (DropF - 1));

  always_ff @(posedge clk_i) begin
    if (enable_i) begin
      line_q  <= line;
      place_q <= v_i[PlaceW-1:0];
      one_q   <= v_i[DataW-1];
      root_q  <= one_q ? {1'b1, (DataW-1)'(0)} : exact[DropF +: DataW];
    end
  end
  assign root_o = root_q;

  wire unused_bits = &{1'b0, exact[DropF-1:0]};

endmodule
