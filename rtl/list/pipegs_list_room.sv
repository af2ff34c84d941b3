// SPDX-License-Identifier: Apache-2.0
// pipegs_list_room: how many lines each window's list may have: the largest power of two for which the area has room.
//
// Idea    Doubled, one step a cycle, while a list of twice the lines for every window still fits, each with ListGap
//         empty lines behind it (pipegs_pkg::list_first). That is done long
//         before the first record comes, which pipegs_list_write waits for anyway while it clears its counts.
// Stream  restart_i with the windows of a frame and the lines of all lists; done_o with log2 of the room, until the
//         next restart_i. none_o: there is not even a line for each window.
// Pace    At most ListEntryW + 1 cycles.
// Model   list_log in cpp_model/areas/areas.hpp

module pipegs_list_room #(
  localparam int unsigned AddressW = pipegs_pkg::AddressW,
  localparam int unsigned EntryW   = pipegs_pkg::ListEntryW,
  localparam int unsigned NumberW  = pipegs_pkg::ListWindowW,
  localparam int unsigned LogW     = $clog2(EntryW + 1)
) (
  input  logic                clk_i,
  input  logic                rst_ni,
  input  logic                restart_i,
  input  logic [NumberW:0]    windows_i,
  input  logic [AddressW-1:0] lines_i,

  output logic                done_o,
  output logic                none_o,
  output logic [LogW-1:0]     log_o
);

  localparam int unsigned SpanW = NumberW + 1 + EntryW + 1;
  localparam int unsigned MostW = (SpanW > AddressW ? SpanW : AddressW) + 1;

  localparam int unsigned Least = pipegs_pkg::ListGap + 1;  // lines of a list of one line

  logic [SpanW-1:0] twice_q;  // lines of all lists with twice the room
  logic [MostW-1:0] gaps_q;   // lines between them
  logic [LogW-1:0]  log_q;
  logic             more_q, none_q, grows;

  assign grows  = MostW'(twice_q) + gaps_q <= MostW'(lines_i) && log_q != LogW'(EntryW);
  assign done_o = !more_q;
  assign none_o = none_q;
  assign log_o  = log_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) more_q <= 1'b0;
    else more_q <= restart_i || (more_q && grows);
  end
  always_ff @(posedge clk_i) begin
    if (restart_i) begin
      log_q   <= '0;
      none_q  <= MostW'(windows_i) * MostW'(Least) > MostW'(lines_i);
      gaps_q  <= MostW'(windows_i) * MostW'(pipegs_pkg::ListGap);
      twice_q <= SpanW'(windows_i) << 1;
    end else if (more_q && grows) begin
      log_q   <= log_q + 1'b1;
      twice_q <= twice_q << 1;
    end
  end

endmodule
