// SPDX-License-Identifier: Apache-2.0
// pu_eyes: each Gaussian once for each eye whose picture the frame makes (eyes = 2).
//
// Paper   None: it renders for headsets, but one picture at a time.
// Idea    A Gaussian is fetched once and shown to pu_cull twice: the eyes differ in where view space begins, no more.
//         In a walk of one eye it is shown once.
// Stream  fetched in; the same out, with an eye beside it; what is no Gaussian passes once, as the first eye's.
// Pace    One in a cycle, combinational: a Gaussian that both eyes see takes two.
// Model   golden_window in cpp_model/golden.cpp

module pu_eyes (
  input  logic                 clk_i,
  input  logic                 rst_ni,
  input  logic [1:0]           wanted_i,  // of the frame: eyes, at least one

  input  logic                 fetched_valid_i,
  output logic                 fetched_ready_o,
  input  pipegs_pkg::fetched_t fetched_i,

  output logic                 seen_valid_o,
  input  logic                 seen_ready_i,
  output pipegs_pkg::fetched_t seen_o,
  output logic                 eye_o
);

  logic       second_q, data, last;
  logic [1:0] wanted;  // of those, whom the walk is for

  if (pipegs_pkg::WalkEyeW != 0) begin : gen_walks
    logic one, eye;
    assign {one, eye} = fetched_i.walk[1:0];
    assign wanted     = one ? {eye, !eye} : wanted_i;
  end else begin : gen_whole
    assign wanted = wanted_i;
  end
  assign data            = fetched_i.kind == pipegs_pkg::KindData;
  assign last            = !data || second_q || wanted != 2'b11;
  assign eye_o           = data && (second_q || wanted == 2'b10);
  assign seen_valid_o    = fetched_valid_i;
  assign seen_o          = fetched_i;
  assign fetched_ready_o = seen_ready_i && last;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) second_q <= 1'b0;
    else if (seen_valid_o && seen_ready_i) second_q <= !last;
  end

endmodule
