// SPDX-License-Identifier: Apache-2.0
// pipegs_log2: the logarithm of a normalised mantissa by one table look-up and one multiplication.
//
// Idea    f = (i + r / 512) / 64:  log2(1 + f) ~ value[i] + delta[i] r / 512: 64 chords, raised by half of their
//         largest error, so that the error swings evenly between + and -.
// Stream  m_i, u1.15 with its leading one -> log2_o, u0.16, rounded to nearest; error at most 3.1e-5.
// Pace    One per cycle, latency two cycles while enable_i, no handshake.
// Model   cpp_model/lib/math/log2.hpp
// Table   {delta, value}, both with 18 fraction bits; printed values of log2_table().

module pipegs_log2 #(
  localparam int unsigned InW  = 16,  // u1.15
  localparam int unsigned OutW = 16   // u0.16
) (
  input  logic            clk_i,
  input  logic            enable_i,

  input  logic [InW-1:0]  m_i,
  output logic [OutW-1:0] log2_o
);

  localparam int unsigned TableF = 18;
  localparam int unsigned DeltaW = 13;               // delta < 2^-5
  localparam int unsigned IndexW = 6;
  localparam int unsigned PlaceW = InW - 1 - IndexW;
  localparam int unsigned ExactW = TableF + PlaceW;
  localparam int unsigned DropF  = ExactW - OutW;    // bits rounded away

  logic [PlaceW-1:0]        place_q;
  logic [DeltaW+TableF-1:0] line, line_q;
  logic [ExactW-1:0]        exact;
  logic [OutW-1:0]          log2_q;

  always_comb begin
    line = '0;
    unique case (m_i[InW-2:InW-1-IndexW])
       0: line = 31'h5ba00006;  1: line = 31'h5a3816ed;  2: line = 31'h58dc2d7b;  3: line = 31'h578c43b2;
       4: line = 31'h56445995;  5: line = 31'h55086f26;  6: line = 31'h53d48468;  7: line = 31'h52a8995c;
       8: line = 31'h5184ae05;  9: line = 31'h5068c266; 10: line = 31'h4f54d67f; 11: line = 31'h4e44ea54;
      12: line = 31'h4d40fde5; 13: line = 31'h4c411134; 14: line = 31'h4b492444; 15: line = 31'h4a553716;
      16: line = 31'h496949ab; 17: line = 31'h48815c05; 18: line = 31'h47a16e26; 19: line = 31'h46c5800e;
      20: line = 31'h45f191bf; 21: line = 31'h451da33b; 22: line = 31'h4451b482; 23: line = 31'h4389c596;
      24: line = 31'h42c5d678; 25: line = 31'h4209e72a; 26: line = 31'h414df7ab; 27: line = 31'h409607fe;
      28: line = 31'h3fe61823; 29: line = 31'h3f36281c; 30: line = 31'h3e8a37e9; 31: line = 31'h3de2478b;
      32: line = 31'h3d3e5703; 33: line = 31'h3c9e6652; 34: line = 31'h3c027579; 35: line = 31'h3b668478;
      36: line = 31'h3ace9351; 37: line = 31'h3a3aa204; 38: line = 31'h39aab093; 39: line = 31'h391abefc;
      40: line = 31'h388ecd42; 41: line = 31'h3806db65; 42: line = 31'h377ee966; 43: line = 31'h36faf745;
      44: line = 31'h367b0503; 45: line = 31'h35fb12a1; 46: line = 31'h357f201f; 47: line = 31'h35032d7d;
      48: line = 31'h348b3abd; 49: line = 31'h341347df; 50: line = 31'h339f54e3; 51: line = 31'h332b61ca;
      52: line = 31'h32bb6e94; 53: line = 31'h324f7b43; 54: line = 31'h31e387d5; 55: line = 31'h3177944d;
      56: line = 31'h310fa0aa; 57: line = 31'h30a7acec; 58: line = 31'h303fb915; 59: line = 31'h2fdbc524;
      60: line = 31'h2f7bd11a; 61: line = 31'h2f1bdcf8; 62: line = 31'h2ebbe8be; 63: line = 31'h2e5bf46b;
    endcase
  end

  assign exact = {line_q[TableF-1:0], PlaceW'(0)} + ExactW'(line_q[TableF +: DeltaW]) * ExactW'(place_q) +
                 (ExactW'(1) << (DropF - 1));

  always_ff @(posedge clk_i) begin
    if (enable_i) begin
      line_q  <= line;
      place_q <= m_i[PlaceW-1:0];
      log2_q  <= exact[DropF +: OutW];
    end
  end
  assign log2_o = log2_q;

  wire unused_bits = &{1'b0, m_i[InW-1], exact[DropF-1:0]};

endmodule
