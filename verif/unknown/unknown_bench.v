// SPDX-License-Identifier: Apache-2.0
// unknown_bench: the machine as plain Verilog from power-up, in four states: renders one window, shows no X.
//
// Idea    Every register and memory starts X, and every input but clock and reset is X until the reset has gone; then
//         what is taken with the frame, an answer's tag and its data are X whenever they are not valid. The reset comes
//         through pipegs_reset_sync as in pipegs_axi, released between two edges. The memory answers in order, line by
//         line, Latency cycles later, and is ready in three cycles of four; a half line that was never written is X.
// Rule    From the first cycle behind the reset on, in each cycle just before the edge: no X in what the core says that
//         it is valid, ready, done, busy, in its counters, in any signal of watched.vh (every valid, ready, enable of a
//         clock, enable or address of a memory in it), in a request, in the halves that a write changes. A request lies
//         in the memory; the lines of a read lie in one aligned group of eight. In the end each line of the pixels is
//         there, each half written once, bit for bit. Before the frame comes Alone cycles pass in which nothing does:
//         what has a reset keeps what the reset gave it, so it does not matter in which of them a flip-flop is let go.
// Fault   With +forgets the valids of the line readers forget whether there is a job (unknown.sh): an X must show.
// Files   Of unknown_stimulus: sizes.vh, inputs.vh (ports taken with the frame), memory.hex, places.hex, expected.hex.
//         Of unknown.sh: watched.vh.

`include "sizes.vh"

module unknown_bench;

  localparam integer Latency = 24;
  localparam integer Places  = 1024;   // of lines that are asked for, a power of two
  localparam integer Patience = 20000; // cycles without a request
  localparam integer Shown = 20;       // faults
  localparam integer Alone = 8;        // cycles behind the reset, ResetCycles of the package

  reg                      clk, rst_n;
  wire                     core_rst_n;
  reg                      frame_valid, mem_ready, rsp_valid;
  reg  [`TAG_W-1:0]        rsp_tag;
  reg  [511:0]             rsp_data;
  wire                     frame_ready, done, busy, mem_valid;
  wire [1:0]               error;
  wire [`REQUEST_W-1:0]    request;
  wire [511:0]             data;
  wire [`COUNTER_W-1:0]    cycles, preprocess_cycles, overflow_lines;
  wire [`PERF_UNITS*4*`COUNTER_W-1:0] perf;

  pipegs_reset_sync u_reset (.clk_i(clk), .rst_ni(rst_n), .test_mode_i(1'b0), .rst_no(core_rst_n));
  pipegs_top dut (
    .clk_i(clk), .rst_ni(core_rst_n), .scan_en_i(1'b0),
    .frame_valid_i(frame_valid), .frame_ready_o(frame_ready), .done_o(done), .busy_o(busy),
    .error_o(error), .error_line_o(),
`include "inputs.vh"
    .mem_valid_o(mem_valid), .mem_ready_i(mem_ready), .mem_request_o(request), .mem_data_o(data),
    .mem_rsp_valid_i(rsp_valid), .mem_rsp_tag_i(rsp_tag), .mem_rsp_data_i(rsp_data),
    .cycles_o(cycles), .preprocess_cycles_o(preprocess_cycles), .overflow_lines_o(overflow_lines), .perf_o(perf)
  );

  // --- external memory ----------------------------------------------------------------------------------------------
  reg  [511:0] memory [0:`LINES-1];
  reg  [511:0] expected [0:`PIXEL_LINES-1];
  reg  [`ADDRESS_W-1:0] places [0:`PIXEL_LINES-1];
  integer      writes [0:2*`LINES-1];  // of each half line
  reg  [`ADDRESS_W-1:0] asked [0:Places-1];
  reg  [`TAG_W-1:0] tags [0:Places-1];
  integer      due [0:Places-1];
  integer      first, last;
  wire [`ADDRESS_W-1:0] address = request[`ADDRESS_AT +: `ADDRESS_W];
  wire [`LINES_W-1:0] more = request[`LINES_AT +: `LINES_W];  // lines of a read, less one
  wire [`HALVES_W-1:0] halves = request[`HALVES_AT +: `HALVES_W];
  wire         write = request[`WRITE_AT];
  reg  [15:0]  noise;

  // --- what goes wrong ----------------------------------------------------------------------------------------------
  integer cycle, faults, quiet, i;
  integer alone;  // cycles since the reset
  reg [262143:0] reset_state, reset_state_first;  // of all that has a reset, and zeros
  reg     taken, over;
  reg     forgets;
  initial forgets = $test$plusargs("forgets") != 0;

  task fault(input [8*200-1:0] what);
    begin
      faults = faults + 1;
      if (faults <= Shown) $display("cycle %0d: %0s", cycle, what);
    end
  endtask

  task known(input [8*200-1:0] name, input value);  // value: xor of the bits
    if (value === 1'bx) begin
      if (faults < Shown) $display("X in %0s", name);
      fault("X behind the reset");
    end
  endtask

`include "watched.vh"

  task drive;
    begin
      noise       = {noise[14:0], noise[15] ^ noise[13] ^ noise[12] ^ noise[10]};
      frame_valid = !taken && alone >= Alone;
      mem_ready   = noise[1:0] != 2'b00;
      rsp_valid   = first != last && due[first % Places] <= cycle;
      rsp_tag     = rsp_valid ? tags[first % Places] : {`TAG_W{1'bx}};
      rsp_data    = rsp_valid ? memory[asked[first % Places]] : 512'bx;
      if (rsp_valid) first = first + 1;
    end
  endtask

  task look;
    begin
      known("frame_ready_o", frame_ready);
      known("done_o", done);
      known("busy_o", busy);
      known("error_o", ^error);
      if (error != 0) fault("an error of the frame");
      known("mem_valid_o", mem_valid);
      known("a counter", ^{cycles, preprocess_cycles, overflow_lines, perf});
      watch;
      if (alone <= Alone) take_reset_state;
      if (alone == 0) reset_state_first = reset_state;
      if (alone <= Alone && reset_state !== reset_state_first) fault("a register leaves its reset value by itself");
      alone = alone + 1;
      quiet = quiet + 1;
      if (frame_valid && frame_ready === 1'b1) taken = 1'b1;
      if (mem_valid === 1'b1) begin
        quiet = 0;
        known("a request", ^request);
        if (address + more >= `LINES) fault("a request outside the memory");
        if (write === 1'b1 ? more != 0 : address[2:0] + more > 7) fault("a request with too many lines");
        if (write === 1'b0 && halves != 2'b11) fault("a read of half a line");
        for (i = 0; i < 2; i = i + 1) begin
          if (write === 1'b1 && halves[i] === 1'b1) begin
            known("a line that is written", ^data[256*i +: 256]);
            if (mem_ready) memory[address][256*i +: 256] = data[256*i +: 256];
            if (mem_ready) writes[2*address + i] = writes[2*address + i] + 1;
          end
        end
        for (i = 0; mem_ready && write !== 1'b1 && i <= more; i = i + 1) begin
          asked[last % Places] = address + i;
          tags[last % Places]  = request[`TAG_AT +: `TAG_W];
          due[last % Places]   = cycle + Latency;
          last = last + 1;
        end
        if (last - first > Places) fault("more lines asked for than the memory has places");
      end
      if (done === 1'b1) over = 1'b1;
      if (quiet > Patience) fault("no request any more: the machine hangs");
    end
  endtask

  task compare;
    for (i = 0; i < `PIXEL_LINES; i = i + 1) begin
      if (memory[places[i]] !== expected[i]) fault("a line of pixels is not the golden one");
      if (writes[2*places[i]] != 1 || writes[2*places[i] + 1] != 1) fault("a line of pixels was not written once");
    end
  endtask

  initial begin
    $readmemh("memory.hex", memory, 0, `SCENE_LINES - 1);
    $readmemh("expected.hex", expected);
    $readmemh("places.hex", places);
    for (i = 0; i < 2 * `LINES; i = i + 1) writes[i] = 0;
    first = 0; last = 0; cycle = 0; faults = 0; quiet = 0; alone = 0; taken = 1'b0; over = 1'b0; noise = 16'hace1;
    rst_n = 1'b0;
    while (faults < Shown && quiet <= Patience && !(over && busy === 1'b0)) begin
      clk = 1'b0;
      if (cycle == 5) #2 rst_n = 1'b1;
      else #2;
      if (core_rst_n === 1'b1) drive;
      #2;
      if (core_rst_n === 1'b1) look;
      #1 clk = 1'b1;
      #5 cycle = cycle + 1;
    end
    if (core_rst_n !== 1'b1) fault("the reset has not gone");
    if (faults == 0) compare;
    if (faults == 0)
      $display("%0d cycles, %0d signals watched, %0d lines of pixels: no X", cycle, Watched, `PIXEL_LINES);
    else $display("FAILED: %0d faults", faults);
    $finish;
  end

endmodule
