// SPDX-License-Identifier: Apache-2.0
// soc_ram: an AXI4 memory that is ready, and answers, when it likes.
//
// Idea    Addresses wait in queues; bursts are read one after the other, and written one after the other. Each ready
//         and each answer needs a bit of a register that shifts with feedback, so a manager meets every kind of pause.
// Stream  A burst is {ID, address, beats less one}; W {strobes, data}; R {ID, last, response, data}; B {ID, response}.
// Rule    What lies outside is answered DECERR and changes nothing. An answer stays until it is taken.
// Pace    At most a beat a cycle each way; three cycles of four with these pauses.

module soc_ram #(
  parameter int unsigned IdW   = 10,
  parameter int unsigned AddrW = 40,
  parameter int unsigned DataW = 128,
  parameter int unsigned Words = 1 << 19,  // of DataW bits: 8 MiB
  localparam int unsigned AskW   = IdW + AddrW + 8,
  localparam int unsigned ByteW  = $clog2(DataW / 8),
  localparam int unsigned PlaceW = $clog2(Words)
) (
  input  logic                       clk_i,
  input  logic                       rst_ni,

  input  logic                       ar_valid_i,
  output logic                       ar_ready_o,
  input  logic [AskW-1:0]            ar_i,
  output logic                       r_valid_o,
  input  logic                       r_ready_i,
  output logic [IdW+DataW+2:0]       r_o,

  input  logic                       aw_valid_i,
  output logic                       aw_ready_o,
  input  logic [AskW-1:0]            aw_i,
  input  logic                       w_valid_i,
  output logic                       w_ready_o,
  input  logic [DataW+DataW/8-1:0]   w_i,
  input  logic                       w_last_i,
  output logic                       b_valid_o,
  input  logic                       b_ready_i,
  output logic [IdW+1:0]             b_o
);

  logic [DataW-1:0] words_q [Words];
  logic [31:0]      chance_q;
  logic [4:0]       go;  // AR, R, AW, W, B: three of four
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) chance_q <= 32'h2545f491;
    else chance_q <= {chance_q[30:0], chance_q[31] ^ chance_q[21] ^ chance_q[1] ^ chance_q[0]};
  end
  for (genvar i = 0; i < 5; i += 1) begin : gen_go
    assign go[i] = chance_q[6*i] || chance_q[6*i+3];
  end

  // --- reads ---------------------------------------------------------------------------------------------------------
  logic             read_there, read_room, read_end, show, read_inside;
  logic [AskW-1:0]  read;
  logic [7:0]       read_beat_q;
  logic [AddrW-1:0] read_at;
  pipegs_fifo #(.DataW(AskW), .Depth(8)) u_reads (
    .clk_i, .rst_ni, .in_valid_i(ar_valid_i && go[0]), .in_ready_o(read_room), .in_i(ar_i),
    .out_valid_o(read_there), .out_ready_i(show && read_end), .out_o(read), .count_o()
  );
  assign ar_ready_o  = read_room && go[0];
  assign show        = read_there && go[1] && (!r_valid_o || r_ready_i);
  assign read_end    = read_beat_q == read[7:0];
  assign read_at     = (read[8 +: AddrW] >> ByteW) + AddrW'(read_beat_q);
  assign read_inside = read_at < AddrW'(Words);
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      r_valid_o   <= 1'b0;
      read_beat_q <= '0;
    end else begin
      if (!r_valid_o || r_ready_i) r_valid_o <= show;
      if (show) read_beat_q <= read_end ? '0 : read_beat_q + 1'b1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (show) r_o <= {read[8+AddrW +: IdW], read_end, {2{!read_inside}}, words_q[read_at[PlaceW-1:0]]};
  end

  // --- writes --------------------------------------------------------------------------------------------------------
  logic             write_there, write_room, take, write_inside, answered_room, answer_there, outside_q;
  logic [AskW-1:0]  write;
  logic [7:0]       write_beat_q;
  logic [AddrW-1:0] write_at;
  pipegs_fifo #(.DataW(AskW), .Depth(4)) u_writes (
    .clk_i, .rst_ni, .in_valid_i(aw_valid_i && go[2]), .in_ready_o(write_room), .in_i(aw_i),
    .out_valid_o(write_there), .out_ready_i(take && w_last_i), .out_o(write), .count_o()
  );
  assign aw_ready_o   = write_room && go[2];
  assign w_ready_o    = write_there && answered_room && go[3];
  assign take         = w_valid_i && w_ready_o;
  assign write_at     = (write[8 +: AddrW] >> ByteW) + AddrW'(write_beat_q);
  assign write_inside = write_at < AddrW'(Words);
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      write_beat_q <= '0;
      outside_q    <= 1'b0;
    end else if (take) begin
      write_beat_q <= w_last_i ? '0 : write_beat_q + 1'b1;
      outside_q    <= !w_last_i && (outside_q || !write_inside);
    end
  end
  always_ff @(posedge clk_i) begin
    for (int i = 0; i < DataW / 8; i += 1) begin
      if (take && write_inside && w_i[DataW+i]) words_q[write_at[PlaceW-1:0]][8*i +: 8] <= w_i[8*i +: 8];
    end
  end

  // An answer, once shown, waits for its manager, not for chance.
  logic [IdW+1:0] answer;
  pipegs_fifo #(.DataW(IdW + 2), .Depth(4)) u_answers (
    .clk_i, .rst_ni, .in_valid_i(take && w_last_i), .in_ready_o(answered_room),
    .in_i({write[8+AddrW +: IdW], {2{outside_q || !write_inside}}}),
    .out_valid_o(answer_there), .out_ready_i(go[4] && (!b_valid_o || b_ready_i)), .out_o(answer), .count_o()
  );
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) b_valid_o <= 1'b0;
    else if (!b_valid_o || b_ready_i) b_valid_o <= answer_there && go[4];
  end
  always_ff @(posedge clk_i) if (!b_valid_o || b_ready_i) b_o <= answer;

  always_ff @(posedge clk_i) if (rst_ni && take) assert (w_last_i == (write_beat_q == write[7:0]));

endmodule
