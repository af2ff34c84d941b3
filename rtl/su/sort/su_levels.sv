// SPDX-License-Identifier: Apache-2.0
// su_levels: the levels of a merge sort in external memory: which runs are merged, and when all are one.
//
// Idea    The runs of a level have the same number of keys and so of lines, the last one may have fewer, and lie one
//         behind the other: a start and a pitch say where each one is. Up to SuWays of them at a time are merged into a
//         run of the next level, in the other one of two areas (AreaRuns has those that su_runs forms), but no more
//         than it takes: as soon as SuWays runs are left, on both levels, their merge is the last one, and its keys
//         leave. A tree has just the levels that its ways need. So a key moves at most ceil(log(keys / pool) /
//         log(SuWays)) times, in whatever order they came.
// Stream  run_i: a run of the first level begins; formed_i: all keys of the set are in runs. setup: a way's first line
//         and number of keys; merge_o: begin. A run that is written: begin_o with its keys. keep_o: sorted keys go to
//         su_lines; else to su_emit. sent_o: no more keys come; done_i ends the set.
// Pace    One cycle per way and merge.
// Model   The whole SU is tested against cpp_model/su/su.hpp.

module su_levels #(
  localparam int unsigned SlotW = pipegs_pkg::SlotW,
  localparam int unsigned WayW = $clog2(pipegs_pkg::SuWays),
  localparam int unsigned LevelW = $clog2(WayW + 1)
) (
  input  logic              clk_i,
  input  logic              rst_ni,
  input  logic              start_i,   // a set begins to spill, or goes on
  input  logic              run_i,
  input  logic              formed_i,
  input  logic [SlotW-1:0]  count_i,   // of the keys that leave
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
  input  logic [SlotW-1:0]  written_lines_i,  // of the next level so far

  input  logic [WayW-1:0]   way_i,
  output logic              way_area_o,    // where its run lies: 1 the area of the runs that su_runs forms
  output logic              write_area_o,  // where runs are written
  output logic              forms_o,       // su_runs forms runs
  output logic              keep_o,
  output logic              sent_o,
  output logic              active_o
);

  localparam int unsigned Ways = pipegs_pkg::SuWays;
  localparam int unsigned FirstKeys = pipegs_pkg::Records / 8 * 8;  // of a run that su_runs forms
  localparam int unsigned FirstLines = (FirstKeys + pipegs_pkg::SuRunKeys - 1) / pipegs_pkg::SuRunKeys;

  typedef enum logic [2:0] {
    Form,   // until all keys are in runs
    Size,   // which runs are merged
    Setup,  // way by way
    Start,
    Merge,  // until the merged run is written, or sent
    Sent    // until the last end has left
  } state_e;
  state_e state_q;

  // This level: runs that are not merged yet, their keys, the first one's line; keys and lines of each.
  logic [SlotW-1:0]  runs_q, left_q, next_line_q, keys_q, lines_q;
  // The next one: merged runs, their keys, lines of each.
  logic [SlotW-1:0]  merges_q, merged_q, merged_lines_q;
  // The merge: its keys; of the next way of a merged run the line.
  logic [SlotW-1:0]  sum_q, merged_line_q;
  logic [WayW-1:0]   way_q;
  logic [LevelW-1:0] tree_q;
  logic              area_q, last_q;

  // --- which runs ---------------------------------------------------------------------------------------------------
  logic [SlotW-1:0]  all, spare;   // runs of both levels; those that are too many, with the merged one that they become
  logic [WayW:0]     most, ways;   // runs of this level that a merge takes at most; runs that it takes
  logic [LevelW-1:0] tree;
  logic              last, ended;  // all runs can be merged; this level's have all been

  assign all   = runs_q + merges_q;
  assign spare = all - SlotW'(Ways - 1);
  assign last  = all <= SlotW'(Ways);
  assign ended = runs_q == '0;
  assign most  = runs_q < SlotW'(Ways) ? runs_q[WayW:0] : (WayW+1)'(Ways);
  assign ways  = last ? all[WayW:0] : spare < SlotW'(most) ? spare[WayW:0] : most;
  always_comb begin
    tree = LevelW'(1);
    for (int unsigned i = 1; i < WayW; i += 1) if (ways > (WayW+1)'(1 << i)) tree = LevelW'(i + 1);
  end

  // --- one way after the other --------------------------------------------------------------------------------------
  logic [WayW:0]    ways_q;
  logic [SlotW-1:0] rest, size;  // keys from the way's run on, of each such run
  logic             of_merged, set_up, merged;

  assign of_merged = last_q && SlotW'(way_q) < merges_q;
  assign rest      = of_merged ? merged_q : left_q;
  assign size      = of_merged ? keys_q << WayW : keys_q;
  assign set_up    = way_q == WayW'((Ways - 1) >> (LevelW'(WayW) - tree_q));
  assign merged    = state_q == Merge && merged_i && (last_q || written_i);

  assign setup_o      = state_q == Setup;
  assign setup_way_o  = way_q;
  assign setup_line_o = of_merged ? merged_line_q : next_line_q;
  assign setup_keys_o = (WayW+1)'(way_q) >= ways_q ? '0 : rest < size ? rest : size;
  assign merge_o      = state_q == Start;
  assign tree_o       = tree_q;
  assign restart_o    = start_i || (state_q == Size && merges_q == '0);
  assign begin_o      = state_q == Start && !last_q;
  assign begin_keys_o = sum_q;
  assign way_area_o   = area_q != (last_q && SlotW'(way_i) < merges_q);
  assign write_area_o = state_q == Form || !area_q;
  assign forms_o      = state_q == Form;
  assign keep_o       = !last_q;
  assign sent_o       = state_q == Sent;
  assign active_o     = start_i || run_i || (state_q == Form && formed_i) || state_q == Size || state_q == Setup ||
                        state_q == Start || merged || done_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q <= Form;
    end else begin
      unique case (state_q)
        Form:    if (formed_i) state_q <= count_i == '0 ? Sent : Size;
        Size:    if (last || !ended) state_q <= Setup;
        Setup:   if (set_up) state_q <= Start;
        Start:   state_q <= Merge;
        Merge:   if (merged) state_q <= last_q ? Sent : Size;
        default: if (done_i || start_i) state_q <= Form;
      endcase
    end
  end

  always_ff @(posedge clk_i) begin
    if (start_i) begin
      runs_q   <= '0;
      merges_q <= '0;
      merged_q <= '0;
      keys_q   <= SlotW'(FirstKeys);
      lines_q  <= SlotW'(FirstLines);
      area_q   <= 1'b1;
      last_q   <= 1'b0;
    end
    if (run_i) runs_q <= runs_q + 1'b1;
    if (state_q == Form) begin
      left_q      <= count_i;
      next_line_q <= '0;
      if (formed_i && count_i == '0) last_q <= 1'b1;
    end
    if (state_q == Size) begin
      way_q         <= '0;
      sum_q         <= '0;
      merged_line_q <= '0;
      last_q        <= last;
      ways_q        <= ways;
      tree_q        <= tree;
      if (!last && ended) begin  // the next level
        runs_q      <= merges_q;
        left_q      <= count_i;
        next_line_q <= '0;
        merges_q    <= '0;
        merged_q    <= '0;
        keys_q      <= keys_q << WayW;
        lines_q     <= merged_lines_q;
        area_q      <= !area_q;
      end
    end
    if (state_q == Setup) begin
      way_q <= way_q + 1'b1;
      sum_q <= sum_q + setup_keys_o;
      if (of_merged) begin
        merged_q      <= merged_q - setup_keys_o;
        merged_line_q <= merged_line_q + merged_lines_q;
      end else if ((WayW+1)'(way_q) < ways_q) begin
        left_q      <= left_q - setup_keys_o;
        next_line_q <= next_line_q + lines_q;
        runs_q      <= runs_q - 1'b1;
      end
    end
    if (merged && !last_q) begin
      merges_q <= merges_q + 1'b1;
      merged_q <= merged_q + sum_q;
      if (merges_q == '0) merged_lines_q <= written_lines_i;
    end
  end

endmodule
