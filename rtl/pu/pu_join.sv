// SPDX-License-Identifier: Apache-2.0
// pu_join: holds back a layer's end towards the SU until all its lines of alphas are written.
//
// Paper   Sec. 4.1: a layer goes to sorting and rasterization as a whole.
// Idea    Two paths leave pu_allocate: colours (then splats) and rows (then lines). A splat passes at once. The ends of
//         the rows' path are counted, so that the rows never wait for the colours; an end beat of the splats passes
//         when one has been counted. So nobody can ask for a line that is not there yet.
// Stream  colored in, rows_end in (never refused: at most AlphaLayers live); splat out.
// Pace    One splat per cycle, no latency.
// Model   The identity.

module pu_join (
  input  logic                         clk_i,
  input  logic                         rst_ni,

  input  logic                         colored_valid_i,
  output logic                         colored_ready_o,
  input  pipegs_pkg::colored_t         colored_i,

  input  logic                         rows_end_valid_i,
  output logic                         rows_end_ready_o,

  output logic                         splat_valid_o,
  input  logic                         splat_ready_i,
  output pipegs_pkg::splat_t           splat_o
);

  localparam int unsigned CountW = $clog2(pipegs_pkg::AlphaLayers + 1);

  logic [CountW-1:0] ends_q;  // layers whose lines are all written and whose end has not passed
  logic              is_end, pass;

  assign is_end           = colored_i.kind != pipegs_pkg::KindData;
  assign pass             = !is_end || ends_q != '0;
  assign splat_o          = colored_i;  // without coefficients the two records are the same
  assign splat_valid_o    = colored_valid_i && pass;
  assign colored_ready_o  = splat_ready_i && pass;
  assign rows_end_ready_o = 1'b1;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) ends_q <= '0;
    else ends_q <= ends_q + CountW'(rows_end_valid_i) - CountW'(is_end && splat_valid_o && splat_ready_i);
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!rows_end_valid_i || ends_q != CountW'(pipegs_pkg::AlphaLayers))
    else $error("pu_join: the rows end one layer more than may live");
  pipegs_stream_check #(.DataW($bits(splat_o)), .Proven(1)) u_check_splat (
    .clk_i,
    .rst_ni,
    .valid_i(splat_valid_o),
    .ready_i(splat_ready_i),
    .beat_i(splat_o)
  );
`endif

endmodule
