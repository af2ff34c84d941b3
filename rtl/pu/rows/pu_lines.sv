// SPDX-License-Identifier: Apache-2.0
// pu_lines: gives each record of a list the lines of its alphas in external memory, and forks it to the Row Units.
//
// Paper   TSPP (Sec. 3.1) without layers: all alphas of the frame are cached, so they lie in external memory.
// Idea    Lines are counted through the frame, and never freed. A splat says where its first one lies:
//           address = {unit, lines given before}        in the area of all alphas
//         pu_spill sees when that area is full. The frame's end waits until the lines before it are written, so nobody
//         asks for a line that is not there.
// Stream  tiles in; row_job and splat out, each taken by itself; rows_end: the rows' end has come. Only the frame's end
//         comes.
// Pace    One record per three cycles (take, count, offer).
// Model   cpp_model/pu/rows/pu_lines.hpp

module pu_lines #(
  localparam int unsigned CountW  = pipegs_pkg::RegionW + 1,
  localparam int unsigned NumberW = pipegs_pkg::ListWindowW
) (
  input  logic                          clk_i,
  input  logic                          rst_ni,
  input  logic [pipegs_pkg::UnitW-1:0]  unit_i,
  input  logic                          restart_i,  // a frame begins; nothing is inside

  input  logic                          tiles_valid_i,
  output logic                          tiles_ready_o,
  input  pipegs_pkg::tiles_t            tiles_i,
  input  pipegs_pkg::listed_t           listed_i,   // of the Gaussian in tiles_i

  output logic                          row_job_valid_o,
  input  logic                          row_job_ready_i,
  output pipegs_pkg::row_job_t          row_job_o,

  input  logic                          rows_end_i,  // all lines before the end are written

  output logic                          splat_valid_o,
  input  logic                          splat_ready_i,
  output pipegs_pkg::splat_t            splat_o,
  output logic [NumberW-1:0]            window_o,    // number of the splat's window

  output logic                          busy_o
);

  localparam int unsigned AddressW = pipegs_pkg::AlphaAddressW;
  localparam int unsigned LinesW   = AddressW - pipegs_pkg::UnitW;

  typedef enum logic [1:0] {
    StateTake,   // waits for a record
    StateCount,  // its regions
    StateOffer   // waits until both outputs have it
  } state_e;

  state_e             state_q;
  pipegs_pkg::tiles_t tiles_q;
  pipegs_pkg::listed_t listed_q;
  logic [LinesW-1:0]  lines_q;    // given to the records before
  logic [CountW-1:0]  count_q;
  logic               row_job_valid_q, splat_valid_q, ended_q, is_end, take, taken;

  assign is_end          = tiles_q.kind != pipegs_pkg::KindData;
  assign tiles_ready_o   = state_q == StateTake;
  assign take            = tiles_valid_i && tiles_ready_o;
  assign row_job_valid_o = row_job_valid_q;
  assign splat_valid_o   = splat_valid_q && (!is_end || ended_q);
  assign taken           = (!row_job_valid_q || row_job_ready_i) &&
                           (!splat_valid_q || (splat_valid_o && splat_ready_i));
  assign busy_o          = state_q != StateTake;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q         <= StateTake;
      row_job_valid_q <= 1'b0;
      splat_valid_q   <= 1'b0;
      ended_q         <= 1'b0;
      lines_q         <= '0;
    end else begin
      if (row_job_ready_i) row_job_valid_q <= 1'b0;
      if (splat_valid_o && splat_ready_i) splat_valid_q <= 1'b0;
      unique case (state_q)
        StateTake: if (take) state_q <= StateCount;
        StateCount: begin
          state_q         <= StateOffer;
          row_job_valid_q <= 1'b1;
          splat_valid_q   <= 1'b1;
        end
        default: if (taken) begin
          state_q <= StateTake;
          lines_q <= lines_q + LinesW'(count_q);
        end
      endcase
      if (rows_end_i) ended_q <= 1'b1;
      if (restart_i) begin
        ended_q <= 1'b0;
        lines_q <= '0;
      end
    end
  end
  always_ff @(posedge clk_i) begin
    if (take) begin
      tiles_q  <= tiles_i;
      listed_q <= listed_i;
    end
    if (state_q == StateCount) count_q <= is_end ? '0 : CountW'($countones(tiles_q.mask));
  end

  always_comb begin
    row_job_o.kind    = tiles_q.kind;
    row_job_o.a       = tiles_q.a;
    row_job_o.b       = tiles_q.b;
    row_job_o.c       = tiles_q.c;
    row_job_o.d       = tiles_q.d;
    row_job_o.e       = tiles_q.e;
    row_job_o.f       = tiles_q.f;
    row_job_o.mask    = tiles_q.mask;
    row_job_o.address = {unit_i, lines_q};
    row_job_o.ext     = 1'b1;
    row_job_o.index   = pipegs_pkg::ShownIndexW'(listed_q.index);
    splat_o.kind      = tiles_q.kind;
    splat_o.depth     = listed_q.depth;
    splat_o.index     = listed_q.index;
    splat_o.mask      = tiles_q.mask;
    splat_o.address   = {unit_i, lines_q};
    splat_o.ext       = 1'b1;
    splat_o.red       = listed_q.red;
    splat_o.green     = listed_q.green;
    splat_o.blue      = listed_q.blue;
  end
  assign window_o = listed_q.window;

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits(row_job_o))) u_check_row_job (
    .clk_i,
    .rst_ni,
    .valid_i(row_job_valid_o),
    .ready_i(row_job_ready_i),
    .beat_i(row_job_o)
  );
  pipegs_stream_check #(.DataW($bits({splat_o, window_o}))) u_check_splat (
    .clk_i,
    .rst_ni,
    .valid_i(splat_valid_o),
    .ready_i(splat_ready_i),
    .beat_i({splat_o, window_o})
  );
`endif

endmodule
