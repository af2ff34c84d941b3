// pu_join: holds back a layer's end towards the SU until all its lines of alphas are written.
//
// Paper   Sec. 4.1: a layer goes to sorting and rasterization as a whole.
// Idea    Two paths leave pu_allocate: colours (then splats) and rows (then lines). A splat passes at once; an end beat
//         passes only together with the same end of the rows' path, so nobody can ask for a line that is not there yet.
// Stream  splat in, rows_end in; splat out.
// Pace    One splat per cycle, no latency.
// Model   The identity.

module pu_join (
  input  logic                         splat_valid_i,
  output logic                         splat_ready_o,
  input  pipegs_pkg::splat_t           splat_i,

  input  logic                         rows_end_valid_i,
  output logic                         rows_end_ready_o,

  output logic                         splat_valid_o,
  input  logic                         splat_ready_i,
  output pipegs_pkg::splat_t           splat_o
);

  logic is_end;

  assign is_end           = splat_i.kind != pipegs_pkg::KindData;
  assign splat_o          = splat_i;
  assign splat_valid_o    = splat_valid_i && (!is_end || rows_end_valid_i);
  assign splat_ready_o    = splat_ready_i && (!is_end || rows_end_valid_i);
  assign rows_end_ready_o = splat_valid_i && is_end && splat_ready_i;

endmodule
