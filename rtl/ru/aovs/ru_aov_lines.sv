// SPDX-License-Identifier: Apache-2.0
// ru_aov_lines: the AOVs of two rows of eight pixels as they lie in external memory, one of them at a time.
//
// Paper   None: its RUs give colours.
// Idea    Each is 32 bits a pixel, as a colour is with PixelW 32, so what places those places these. Of a word only
//         what is written is kept while it waits (kept_o); from that comes a line.
//           coverage  T u1.15, above it how many Gaussians
//           depth, median  u0.32 of the frame's range
//           index     of the Gaussian that weighs most; all ones: none
// Stream  word_i: T of the pixels, pixel 0 lowest; aovs_i: pixel_aovs_t of each. kept_i: of a word, which_i: one AOV.
//         Combinational.
// Model   ru_aov_word in cpp_model/ru/ru_aovs.hpp

module ru_aov_lines #(
  localparam int unsigned Lanes = 16,
  localparam int unsigned TW    = pipegs_pkg::TW,
  localparam int unsigned Kinds = pipegs_pkg::AovKinds,
  localparam int unsigned AovW  = pipegs_pkg::AovBits,
  localparam int unsigned KeptW = AovW - pipegs_pkg::BestW + (pipegs_pkg::AovCoverage != 0 ? 16 : 0)  // of a pixel
) (
  input  logic [Lanes*TW-1:0]    t_i,
  input  logic [Lanes*AovW-1:0]  aovs_i,
  output logic [Lanes*KeptW-1:0] kept_o,

  input  logic [Lanes*KeptW-1:0] kept_i,
  input  logic [Kinds-1:0]       which_i,  // one hot
  output logic [Lanes*32-1:0]    lines_o   // the first row lowest
);

  localparam int unsigned BlendedW  = pipegs_pkg::BlendedW;
  localparam int unsigned ExpectedW = pipegs_pkg::ExpectedW;
  localparam int unsigned MedianW   = pipegs_pkg::MedianW;
  localparam int unsigned IndexW    = pipegs_pkg::BestIndexW;
  localparam int unsigned ValuesW   = BlendedW + ExpectedW + MedianW;  // below best

  for (genvar i = 0; i < Lanes; i += 1) begin : gen_pixel
    logic [TW-1:0]    t;
    logic [AovW-1:0]  aovs;
    logic [KeptW-1:0] kept;
    logic [31:0]      coverage, depth, median, index;
    assign t    = t_i[i*TW +: TW];
    assign aovs = aovs_i[i*AovW +: AovW];
    assign kept = kept_i[i*KeptW +: KeptW];

    if (ValuesW > 0) begin : gen_values
      assign kept_o[i*KeptW +: ValuesW] = aovs[ValuesW-1:0];
    end
    if (pipegs_pkg::AovCoverage != 0) begin : gen_coverage
      if (TW >= 16) begin : gen_cut
        assign kept_o[(i+1)*KeptW-16 +: 16] = t[TW-1:TW-16];
      end else begin : gen_extend
        assign kept_o[(i+1)*KeptW-16 +: 16] = {t, (16-TW)'(0)};
      end
      assign coverage = {kept[BlendedW-1:0], kept[KeptW-1 -: 16]};
    end else begin : gen_no_coverage
      assign coverage = '0;
    end
    if (pipegs_pkg::AovDepth != 0) begin : gen_depth
      assign depth = {kept[BlendedW +: ExpectedW], (32-ExpectedW)'(0)};
    end else begin : gen_no_depth
      assign depth = '0;
    end
    if (pipegs_pkg::AovMedian != 0) begin : gen_median
      assign median = {kept[BlendedW+ExpectedW +: MedianW], (32-MedianW)'(0)};
    end else begin : gen_no_median
      assign median = '0;
    end
    if (pipegs_pkg::AovIndex != 0) begin : gen_index
      logic [IndexW-1:0] best;
      assign kept_o[i*KeptW+ValuesW +: IndexW] = aovs[AovW-1 -: IndexW];
      assign best  = kept[ValuesW +: IndexW];
      assign index = {{(32-IndexW){best == '1}}, best};
    end else begin : gen_no_index
      assign index = '0;
    end
    assign lines_o[32*i +: 32] = ({32{which_i[0]}} & coverage) | ({32{which_i[1]}} & depth) |
                                 ({32{which_i[2]}} & median) | ({32{which_i[3]}} & index);
    logic unused_pixel;  // weights, and what no AOV has
    assign unused_pixel = &{1'b0, t, aovs, kept};
  end

endmodule
