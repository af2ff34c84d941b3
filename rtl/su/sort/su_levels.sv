// SPDX-License-Identifier: Apache-2.0
// su_levels: the levels of a merge sort in external memory: which runs are merged, and when all are one.
//
// Idea    All runs of a level but the last have the same number of keys and so of lines, and lie one behind the other:
//         a start and a pitch say where each one is. A level merges SuWays runs at a time into runs of the next level,
//         in the other one of two areas. When no more than SuWays are left their merge is the last one: its keys leave,
//         on a tree of just the levels that it needs. Every key moves ceil(log(keys / pool) / log(SuWays)) times, in
//         whatever order they came.
// Stream  formed_i: all keys of the set are in runs. setup: a way's first line and number of keys; merge_o: begin. A
//         run that is written: begin_o with its keys. keep_o: sorted keys go to su_lines; else to su_emit. sent_o: no
//         more keys come; done_i ends the set.
// Pace    One cycle per way, level of the tree and merge.
// Model   The whole SU is tested against cpp_model/su/su.hpp.

module su_levels #(
  localparam int unsigned SlotW = pipegs_pkg::SlotW,
  localparam int unsigned WayW = $clog2(pipegs_pkg::SuWays),
  localparam int unsigned LevelW = $clog2(WayW + 1)
) (
  input  logic              clk_i,
  input  logic              rst_ni,
  input  logic              start_i,   // a set begins to spill
  input  logic              formed_i,
  input  logic [SlotW-1:0]  count_i,   // keys of the set
  input  logic              done_i,

  output logic              setup_o,
  output logic [WayW-1:0]   setup_way_o,
  output logic [SlotW-1:0]  setup_line_o,
  output logic [SlotW-1:0]  setup_keys_o,
  output logic              merge_o,   // one cycle
  output logic [LevelW-1:0] tree_o,    // levels of the tree
  input  logic              merged_i,  // all keys have left the tree

  output logic              restart_o,
  output logic              begin_o,
  output logic [SlotW-1:0]  begin_keys_o,
  input  logic              written_i,
  input  logic [SlotW-1:0]  written_lines_i,  // of this level so far

  output logic              area_o,    // that is read: 1 the runs that su_runs forms; the other one is written
  output logic              forms_o,   // su_runs forms runs
  output logic              keep_o,
  output logic              sent_o,
  output logic              active_o
);

  localparam int unsigned Ways = pipegs_pkg::SuWays;
  localparam int unsigned FirstKeys = pipegs_pkg::Records / 8 * 8;  // of a run that su_runs forms
  localparam int unsigned FirstLines = (FirstKeys + pipegs_pkg::SuRunKeys - 1) / pipegs_pkg::SuRunKeys;

  typedef enum logic [2:0] {
    Form,   // until all keys are in runs
    Size,   // how many levels the tree needs
    Setup,  // way by way
    Start,
    Merge,  // until the merged run is written, or sent
    Sent    // until the last end has left
  } state_e;
  state_e state_q;

  logic [SlotW-1:0]  keys_q, lines_q;      // of a run of this level
  logic [SlotW-1:0]  next_line_q, left_q;  // where the next run begins; keys from there on
  logic [SlotW-1:0]  sum_q, next_lines_q;  // keys of the merge; lines of the first run that was merged
  logic [WayW-1:0]   way_q;
  logic [LevelW-1:0] tree_q;
  logic              area_q, last_q, first_q, fits, set_up, merged;
  logic [SlotW+WayW-1:0] reach;  // keys that a tree of tree_q levels merges

  assign reach  = (SlotW+WayW)'(keys_q) << tree_q;
  assign fits   = (SlotW+WayW)'(count_i) <= reach;
  assign set_up = way_q == WayW'((Ways - 1) >> (LevelW'(WayW) - tree_q));
  assign merged = state_q == Merge && merged_i && (last_q || written_i);

  assign setup_o      = state_q == Setup;
  assign setup_way_o  = way_q;
  assign setup_line_o = next_line_q;
  assign setup_keys_o = left_q < keys_q ? left_q : keys_q;
  assign merge_o      = state_q == Start;
  assign tree_o       = tree_q;
  assign restart_o    = start_i || (state_q == Size && (fits || tree_q == LevelW'(WayW)));
  assign begin_o      = state_q == Start && !last_q;
  assign begin_keys_o = sum_q;
  assign area_o       = area_q;
  assign forms_o      = state_q == Form;
  assign keep_o       = !last_q;
  assign sent_o       = state_q == Sent;
  assign active_o     = start_i || (state_q == Form && formed_i) || state_q == Size || state_q == Setup ||
                        state_q == Start || merged || done_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q <= Form;
    end else begin
      unique case (state_q)
        Form:    if (formed_i) state_q <= count_i == '0 ? Sent : Size;
        Size:    if (restart_o) state_q <= Setup;
        Setup:   if (set_up) state_q <= Start;
        Start:   state_q <= Merge;
        Merge:   if (merged) state_q <= last_q ? Sent : left_q == '0 ? Size : Setup;
        default: if (done_i) state_q <= Form;
      endcase
    end
  end

  always_ff @(posedge clk_i) begin
    if (start_i) begin
      keys_q  <= SlotW'(FirstKeys);
      lines_q <= SlotW'(FirstLines);
      area_q  <= 1'b1;
      last_q  <= 1'b0;
    end
    if (state_q == Form) begin
      if (formed_i && count_i == '0) last_q <= 1'b1;
      tree_q <= LevelW'(1);
    end
    if (state_q == Size) begin
      next_line_q <= '0;
      left_q      <= count_i;
      first_q     <= 1'b1;
      if (restart_o) last_q <= fits;
      else tree_q <= tree_q + 1'b1;
    end
    if (state_q == Size || state_q == Merge) begin
      way_q <= '0;
      sum_q <= '0;
    end
    if (state_q == Setup) begin
      way_q       <= way_q + 1'b1;
      sum_q       <= sum_q + setup_keys_o;
      left_q      <= left_q - setup_keys_o;
      next_line_q <= next_line_q + lines_q;
    end
    if (merged) begin
      first_q <= 1'b0;
      if (first_q) next_lines_q <= written_lines_i;
      if (left_q == '0) begin
        keys_q  <= keys_q << WayW;
        lines_q <= first_q ? written_lines_i : next_lines_q;
        area_q  <= !area_q;
        tree_q  <= LevelW'(1);
      end
    end
  end

endmodule
