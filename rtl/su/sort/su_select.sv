// SPDX-License-Identifier: Apache-2.0
// su_select: sorts a set that does not fit the key store, store by store, from the list of keys in external memory.
//
// Idea    Sixteen pivots cut [low, max] into equal parts; one pass over the list counts the keys of each part. As
//         many parts as fit the store together are loaded in a second pass and sorted; then the next parts, until the
//         sixteen are done and the rest is cut anew. A part that alone is too large is cut by the next four bits;
//         keys are unique, so this ends. Nothing is ever estimated: any number of keys in any arrangement is sorted
//         exactly.
// Stream  start_i with the set; read: numbers of lines of keys; line: these lines; write: a key and its record's
//         number go to the next slot of the store; group: slots 0 .. count - 1 are to be sorted, group_done_i: were
//         sent.
// Pace    One key per cycle and pass.
// Model   Plumbing; the whole SU is tested against cpp_model/su/su.hpp.

module su_select (
  input  logic                           clk_i,
  input  logic                           rst_ni,

  input  logic                           start_i,
  input  logic [pipegs_pkg::SlotW-1:0]   count_i,
  input  logic [pipegs_pkg::KeyW-1:0]    min_i,
  input  logic [pipegs_pkg::KeyW-1:0]    max_i,
  output logic                           idle_o,
  output logic                           active_o,

  output logic                           read_valid_o,
  input  logic                           read_ready_i,
  output logic [pipegs_pkg::SlotW-1:0]   read_line_o,
  input  logic                           line_valid_i,
  output logic                           line_ready_o,
  input  logic [pipegs_pkg::MemoryW-1:0] line_i,

  output logic                           write_claim_o,  // a key may be written in this cycle: others wait
  output logic                           write_o,        // with write_claim_o only
  output logic [pipegs_pkg::RecordW-1:0] write_slot_o,
  output logic [pipegs_pkg::KeyW-1:0]    write_key_o,
  output logic [pipegs_pkg::SlotW-1:0]   write_number_o,

  output logic                           group_o,  // one cycle
  output logic [pipegs_pkg::RecordW:0]   group_count_o,
  output logic [pipegs_pkg::KeyW-1:0]    group_min_o,
  output logic [pipegs_pkg::KeyW-1:0]    group_max_o,
  input  logic                           group_done_i
);

  localparam int unsigned KeyW = pipegs_pkg::KeyW;
  localparam int unsigned SlotW = pipegs_pkg::SlotW;
  localparam int unsigned SumW = pipegs_pkg::RecordW + 1;
  localparam int unsigned Records = pipegs_pkg::Records;
  localparam int unsigned KeyPartW = 64;
  localparam int unsigned LinePartW = $clog2(pipegs_pkg::MemoryW / KeyPartW);
  localparam int unsigned Parts = 16;
  localparam int unsigned PartW = $clog2(Parts);
  localparam int unsigned ShiftW = $clog2(KeyW);

  typedef enum logic [2:0] {
    Idle,     // waits for start_i
    Measure,  // picks the shift for the range that is left
    Count,    // a pass over the list: counts the keys of each part
    Choose,   // adds up parts while they fit
    Load,     // a pass over the list: copies the keys of the chosen parts into the store
    Group,    // starts the splitter
    Sort      // waits until the group was sent
  } state_e;
  state_e state_q;

  logic [KeyW-1:0]   low_q, max_q;  // low: where the sixteen parts begin
  logic [ShiftW-1:0] shift_q, wide_shift;
  logic [SlotW-1:0]  count_q, last_q, sent_q;  // last: count - 1
  logic [PartW:0]    first_q, stop_q;  // parts chosen: first <= part < stop
  logic [SumW-1:0]   sum_q, part_count;
  logic [SumW-1:0]   counts_q [Parts];  // at most Records + 1: then "too many"
  logic [Parts-1:0]  counted_q;         // the others are zero
  logic              pass, pass_done, fits, filling;
  logic [SumW:0]     sum;

  // One pass: lines are asked for as fast as the port takes them; their keys are looked at one by one.
  logic [SlotW-1:0]  line_q, number_q;  // next line to ask for, next key to look at
  logic              seen_q, below_q;
  logic [KeyW-1:0]   key, key_q, offset_q, position;
  logic [SlotW-1:0]  seen_number_q;
  logic              look, hit;
  logic [PartW-1:0]  part;

  assign pass         = state_q == Count || state_q == Load;
  assign read_valid_o = pass && (SlotW+LinePartW)'({line_q, LinePartW'(0)}) < (SlotW+LinePartW)'(count_q);
  assign read_line_o  = line_q;
  assign look         = pass && line_valid_i && number_q != count_q;
  assign line_ready_o = look && (number_q[LinePartW-1:0] == '1 || number_q == last_q);
  assign key          = line_i[number_q[LinePartW-1:0]*KeyPartW +: KeyW];
  assign pass_done    = number_q == count_q && !seen_q;

  assign position = offset_q >> shift_q;
  assign hit   = seen_q && !below_q && position[KeyW-1:PartW] == '0;
  assign part     = state_q == Choose ? stop_q[PartW-1:0] : position[PartW-1:0];
  assign part_count = counted_q[part] ? counts_q[part] : '0;

  assign write_claim_o  = state_q == Load && seen_q;
  assign write_o        = state_q == Load && hit && {1'b0, part} >= first_q && {1'b0, part} < stop_q;
  assign write_slot_o   = sum_q[SumW-2:0];
  assign write_key_o    = key_q;
  assign write_number_o = seen_number_q;

  su_minmax u_minmax (
    .clk_i, .rst_ni, .clear_i(state_q == Choose), .valid_i(write_o), .key_i(key_q),
    .min_o(group_min_o), .max_o(group_max_o)
  );

  assign sum  = {1'b0, sum_q} + {1'b0, part_count};
  assign fits = !stop_q[PartW] && sum <= (SumW+1)'(Records);
  assign filling = state_q == Choose && fits;

  logic [KeyW-PartW-1:0]           range;
  logic [$clog2(KeyW-PartW+1)-1:0] wide_length;
  assign range = (KeyW-PartW)'((max_q - low_q) >> PartW);
  bit_length #(.DataW(KeyW - PartW)) u_wide (.in_i(range), .length_o(wide_length));
  assign wide_shift = ShiftW'(wide_length);

  assign group_o       = state_q == Group;
  assign group_count_o = sum_q;
  assign idle_o        = state_q == Idle;
  assign active_o      = start_i || !(state_q == Idle || (state_q == Sort && !group_done_i) ||
                                      (pass && !look && !seen_q && number_q != count_q && !read_ready_i));

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q <= Idle;
      seen_q  <= 1'b0;
    end else begin
      unique case (state_q)
        Idle:    if (start_i) state_q <= Measure;
        Measure: state_q <= Count;
        Count:   if (pass_done) state_q <= Choose;
        Choose:  if (!fits) state_q <= sum_q != '0 ? Load : stop_q[PartW] ? Measure : Count;
        Load:    if (pass_done) state_q <= Group;
        Group:   state_q <= Sort;
        default: if (group_done_i) state_q <= sent_q == count_q ? Idle : Choose;
      endcase
      seen_q <= look;
    end
  end

  always_ff @(posedge clk_i) begin
    if (start_i) begin
      low_q   <= min_i;
      max_q   <= max_i;
      count_q <= count_i;
      last_q  <= count_i - 1'b1;
      sent_q  <= '0;
    end

    if (state_q == Measure) shift_q <= wide_shift;
    if (state_q == Measure || (state_q == Choose && !fits)) begin  // before each pass
      line_q   <= '0;
      number_q <= '0;
    end else begin
      if (read_ready_i) line_q <= line_q + 1'b1;
      if (look) number_q <= number_q + 1'b1;
    end

    if (look) begin
      key_q         <= key;
      offset_q      <= key - low_q;
      below_q       <= key < low_q;
      seen_number_q <= number_q;
    end

    if (state_q == Count && hit) begin
      counts_q[part] <= part_count > SumW'(Records) ? part_count : part_count + 1'b1;
      counted_q[part] <= 1'b1;
    end

    if (state_q == Count && pass_done) begin
      first_q <= '0;
      stop_q  <= '0;
      sum_q   <= '0;
    end
    if (filling) begin
      sum_q  <= sum[SumW-1:0];
      stop_q <= stop_q + 1'b1;
    end
    if (state_q == Choose && !fits) begin
      if (sum_q == '0) begin  // all chosen parts are empty: go on behind them
        low_q <= low_q + (KeyW'(stop_q) << shift_q);
        if (!stop_q[PartW]) shift_q <= shift_q > ShiftW'(PartW) ? shift_q - ShiftW'(PartW) : '0;
      end else begin
        sent_q <= sent_q + SlotW'(sum_q);
        sum_q  <= '0;  // counts the keys as they are loaded
      end
    end
    if (write_o) sum_q <= sum_q + 1'b1;
    if (state_q == Measure || (state_q == Choose && !fits && sum_q == '0)) counted_q <= '0;
    if (state_q == Sort && group_done_i) begin
      first_q <= stop_q;
      sum_q   <= '0;
    end
  end

endmodule
