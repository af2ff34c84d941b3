// SPDX-License-Identifier: Apache-2.0
// pu_done: the regions of the beats' window that are opaque already.
//
// Paper   Sec. 4.2.3 (early termination); here it also stops the work before the RU.
// Idea    Each RU tells which of its regions are done, and of which window. The PU works on that window or on a later
//         one, so it counts its own windows, row by row from the frame's first to its last, and listens to RUs that are
//         there.
// Stream  advance_i: a window's end passes. done_o: one bit per region of the present window.
// Pace    Combinational from the RUs' bits.
// Model   None: skipping done regions never changes a pixel; the tests of pu_allocate and pu_late drive it.

module pu_done #(
  localparam int unsigned Units   = pipegs_pkg::Units,
  localparam int unsigned Regions = pipegs_pkg::Regions,
  localparam int unsigned WindowW = pipegs_pkg::WindowW
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  pipegs_pkg::windows_t     windows_i,
  input  logic                     restart_i,  // a frame begins
  input  logic                     advance_i,  // the next window begins

  input  logic [Units*Regions-1:0] done_i,     // RU j: its opaque regions of window done_x, done_y
  input  logic [Units*WindowW-1:0] done_x_i,
  input  logic [Units*WindowW-1:0] done_y_i,

  output logic [Regions-1:0]       done_o
);

  logic [WindowW-1:0] window_x, window_y;
  pipegs_window_walk u_walk (
    .clk_i,
    .rst_ni,
    .first_x_i(windows_i.first_x),
    .first_y_i(windows_i.first_y),
    .last_x_i(windows_i.last_x),
    .start_i(restart_i),
    .advance_i,
    .x_o(window_x),
    .y_o(window_y),
    .next_x_o(),
    .next_y_o(),
    .row_ends_o()
  );

  pipegs_pkg::progress_t progress;
  logic [Regions-1:0]    done_unit [Units];
  assign progress = {done_y_i, done_x_i, done_i};
  for (genvar j = 0; j < Units; j += 1) begin : gen_done
    logic [pipegs_pkg::MaskW-1:0] own;  // of each part
    logic                         here;
    ru_own u_own (
      .unit_i(pipegs_pkg::UnitW'(j)),
      .own_o(own)
    );
    assign here = progress.x[j] == window_x && progress.y[j] == window_y;
    assign done_unit[j] = here ? progress.done[j] & {pipegs_pkg::Parts{own}} : '0;
  end
  always_comb begin
    done_o = '0;
    for (int unsigned j = 0; j < Units; j += 1) done_o |= done_unit[j];
  end

  logic unused_windows;
  assign unused_windows = ^windows_i;

endmodule
