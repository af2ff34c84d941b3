// su_collect: takes the splats of a layer in and hands the complete layer to the sorter.
//
// Paper   Sec. 4.1 (double buffer: layer i + 1 is collected while layer i is sorted).
// Idea    The stores are a ring in which several layers live: record n of a layer goes to slot n from the layer's base on
//         and waits while older layers fill the ring; the MinMax Finder looks at its key. When a layer alone has filled
//         the ring, its next records go to external memory (one line each, from record Records on), and their keys are
//         packed, eight into a line. Such a layer is sorted from the list of keys in external memory, so at its end the
//         keys that lie in the store are appended to that list too: key n stands in part n % 8 of line n / 8.
// Stream  in: splats, then an end beat. layer: how many, their range, the kind of the end. record and keys: lines to
//         write.
// Pace    One splat per cycle while the ring has room; two cycles to hand over.
// Model   Plumbing; the whole SU is tested against cpp_model/su/su.hpp.

module su_collect (
  input  logic                            clk_i,
  input  logic                            rst_ni,

  input  logic                            in_valid_i,
  output logic                            in_ready_o,
  input  pipegs_pkg::splat_t              in_i,

  output logic                            layer_valid_o,
  input  logic                            layer_ready_i,
  output logic [pipegs_pkg::SlotW-1:0]    layer_count_o,
  output logic [pipegs_pkg::KeyW-1:0]     layer_min_o,
  output logic [pipegs_pkg::KeyW-1:0]     layer_max_o,
  output logic [pipegs_pkg::KindW-1:0]    layer_kind_o,

  output logic [pipegs_pkg::RecordW-1:0]  layer_base_o,   // slot of its first record

  input  logic                            room_i,         // the ring has a free slot
  input  logic                            sorter_idle_i,  // no older layer is inside: the key store's read port is free
  output logic                            write_o,        // to the key store and the record store, at slot_o
  output logic [pipegs_pkg::RecordW-1:0]  slot_o,
  output logic                            key_read_o,
  output logic [pipegs_pkg::RecordW-1:0]  key_slot_o,
  input  logic [pipegs_pkg::KeyW-1:0]     key_i,

  output logic                            record_valid_o,
  input  logic                            record_ready_i,
  output logic [pipegs_pkg::SlotW-1:0]    record_line_o,
  output logic [pipegs_pkg::SplatBits-1:0] record_o,
  output logic                            keys_valid_o,
  input  logic                            keys_ready_i,
  output logic [pipegs_pkg::SlotW-1:0]    keys_line_o,
  output logic [pipegs_pkg::MemoryW-1:0]  keys_o,

  output logic                            moved_o,   // took a beat
  output logic                            active_o
);

  localparam int unsigned SlotW = pipegs_pkg::SlotW;
  localparam int unsigned KeyPartW = 64;  // of a line of keys
  localparam int unsigned KeysPerLine = pipegs_pkg::MemoryW / KeyPartW;
  localparam int unsigned PartW = $clog2(KeysPerLine);

  typedef enum logic [1:0] {
    Collect,  // waits for splats and the layer's end
    Close,    // an overflowed layer: waits for the lines in hand, writes the last line of keys
    Append,   // ... waits for the sorter to rest, appends the stored keys
    Hand      // waits for the sorter to take the layer
  } state_e;
  state_e state_q;

  logic [pipegs_pkg::RecordW-1:0] base_q;  // slot of the layer's first record
  logic [SlotW-1:0] number_q;  // records so far
  logic [pipegs_pkg::KindW-1:0] kind_q;
  logic             record_valid_q, keys_valid_q;
  logic [SlotW-1:0] record_line_q, keys_line_q;
  logic [pipegs_pkg::SplatBits-1:0] record_q;
  logic [pipegs_pkg::MemoryW-1:0]   keys_q;
  logic [pipegs_pkg::RecordW:0]     append_q;    // stored keys read so far
  logic             arrives_q;                   // the key store shows stored key append_q - 1
  logic             take, data, fits, lines_free, appended;
  logic [pipegs_pkg::KeyW-1:0] key;
  logic [pipegs_pkg::KeyW-1:0] put_key;
  logic             put;        // a key goes into the line of keys
  logic [SlotW-1:0] put_number;

  assign key        = {in_i.depth, in_i.index};
  assign fits       = number_q < SlotW'(pipegs_pkg::Records);
  assign lines_free = !record_valid_q && !keys_valid_q;
  assign in_ready_o = state_q == Collect && lines_free && (room_i || !fits || in_i.kind != pipegs_pkg::KindData);
  assign take       = in_valid_i && in_ready_o;
  assign data       = take && in_i.kind == pipegs_pkg::KindData;
  assign write_o    = data && fits;
  assign slot_o     = base_q + number_q[pipegs_pkg::RecordW-1:0];

  assign key_read_o = state_q == Append && sorter_idle_i && !keys_valid_q && !arrives_q && !appended;
  assign appended   = append_q == (pipegs_pkg::RecordW+1)'(pipegs_pkg::Records);
  assign key_slot_o = base_q + append_q[pipegs_pkg::RecordW-1:0];
  assign put        = (data && !fits) || arrives_q;
  assign put_key    = arrives_q ? key_i : key;
  assign put_number = arrives_q ? SlotW'(append_q) - 1'b1 : number_q;

  su_minmax u_minmax (
    .clk_i, .rst_ni, .clear_i(layer_valid_o && layer_ready_i), .valid_i(data), .key_i(key),
    .min_o(layer_min_o), .max_o(layer_max_o)
  );

  assign layer_valid_o = state_q == Hand && lines_free;
  assign layer_count_o = number_q;
  assign layer_base_o  = base_q;
  assign layer_kind_o  = kind_q;
  assign record_valid_o = record_valid_q;
  assign record_line_o  = record_line_q;
  assign record_o       = record_q;
  assign keys_valid_o   = keys_valid_q;
  assign keys_line_o    = keys_line_q;
  assign keys_o         = keys_q;
  assign moved_o        = take;
  assign active_o       = take || record_valid_q || keys_valid_q || arrives_q || key_read_o ||
                          state_q == Close || (state_q == Append && sorter_idle_i) || (layer_valid_o && layer_ready_i);

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q        <= Collect;
      base_q         <= '0;
      number_q       <= '0;
      record_valid_q <= 1'b0;
      keys_valid_q   <= 1'b0;
      append_q       <= '0;
      arrives_q      <= 1'b0;
    end else begin
      unique case (state_q)
        Collect: if (take && !data) state_q <= number_q > SlotW'(pipegs_pkg::Records) ? Close : Hand;
        Close:   if (lines_free) state_q <= Append;
        Append:  if (appended && !arrives_q && lines_free) state_q <= Hand;
        default: if (layer_valid_o && layer_ready_i) state_q <= Collect;
      endcase
      if (data) number_q <= number_q + 1'b1;
      if (record_ready_i) record_valid_q <= 1'b0;
      if (data && !fits) record_valid_q <= 1'b1;
      if (keys_ready_i) keys_valid_q <= 1'b0;
      if (put && put_number[PartW-1:0] == PartW'(KeysPerLine - 1)) keys_valid_q <= 1'b1;
      if (state_q == Close && lines_free && number_q[PartW-1:0] != '0) keys_valid_q <= 1'b1;
      arrives_q <= key_read_o;
      if (key_read_o) append_q <= append_q + 1'b1;
      if (layer_valid_o && layer_ready_i) begin
        base_q   <= base_q + number_q[pipegs_pkg::RecordW-1:0];
        number_q <= '0;
        append_q <= '0;
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (take) kind_q <= in_i.kind;
    if (data && !fits) begin
      record_q      <= in_i;
      record_line_q <= number_q - SlotW'(pipegs_pkg::Records);
    end
    if (put) begin
      keys_q[put_number[PartW-1:0]*KeyPartW +: KeyPartW] <= KeyPartW'(put_key);
      keys_line_q <= put_number >> PartW;
    end
  end

`ifndef SYNTHESIS
  assert property (@(posedge clk_i) disable iff (!rst_ni) record_ready_i |-> record_valid_q);
  assert property (@(posedge clk_i) disable iff (!rst_ni) keys_ready_i |-> keys_valid_q);
`endif

endmodule
