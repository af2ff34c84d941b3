// SPDX-License-Identifier: Apache-2.0
// soc_crossbar: two managers at one subordinate, by AXI4.
//
// Idea    AR and AW go by turns, each as it is, with the number of its manager above its ID. The subordinate gives that
//         back with R and B, which go to whom they belong. W has no ID: its bursts come in the order in which AW was
//         taken, so the numbers wait in a queue, and data of a manager waits until it is first there.
// Rule    What is shown and not taken stays: a turn ends when its address is taken.
// Pace    One address of each kind and one beat each way in a cycle; nothing is registered.

module soc_crossbar #(
  parameter int unsigned AskW   = 57,
  parameter int unsigned BeatW  = 144,
  parameter int unsigned Writes = 16  // bursts whose data is still to come
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,

  input  logic [1:0]            ar_valid_i,
  output logic [1:0]            ar_ready_o,
  input  logic [1:0][AskW-1:0]  ar_i,
  input  logic [1:0]            aw_valid_i,
  output logic [1:0]            aw_ready_o,
  input  logic [1:0][AskW-1:0]  aw_i,
  input  logic [1:0]            w_valid_i,
  output logic [1:0]            w_ready_o,
  input  logic [1:0][BeatW-1:0] w_i,
  input  logic [1:0]            w_last_i,
  output logic [1:0]            r_valid_o,
  input  logic [1:0]            r_ready_i,
  output logic [1:0]            b_valid_o,
  input  logic [1:0]            b_ready_i,

  output logic                  ar_valid_o,
  input  logic                  ar_ready_i,
  output logic [AskW:0]         ar_o,
  output logic                  aw_valid_o,
  input  logic                  aw_ready_i,
  output logic [AskW:0]         aw_o,
  output logic                  w_valid_o,
  input  logic                  w_ready_i,
  output logic [BeatW-1:0]      w_o,
  output logic                  w_last_o,
  input  logic                  r_valid_i,
  output logic                  r_ready_o,
  input  logic                  r_to_i,  // the manager that a beat of R belongs to
  input  logic                  b_valid_i,
  output logic                  b_ready_o,
  input  logic                  b_to_i
);

  // --- whose turn it is ----------------------------------------------------------------------------------------------
  logic read_turn, write_turn;        // the manager
  logic read_q, write_q;              // who showed the last one
  logic read_waits_q, write_waits_q;  // which was not taken
  logic room, owner, owned;

  assign read_turn  = read_waits_q || !ar_valid_i[!read_q] ? read_q : !read_q;
  assign write_turn = write_waits_q || !aw_valid_i[!write_q] ? write_q : !write_q;
  assign ar_valid_o = ar_valid_i[read_turn];
  assign ar_o       = {read_turn, ar_i[read_turn]};
  assign ar_ready_o = ar_ready_i ? 2'b01 << read_turn : 2'b00;
  assign aw_valid_o = aw_valid_i[write_turn] && room;
  assign aw_o       = {write_turn, aw_i[write_turn]};
  assign aw_ready_o = aw_ready_i && room ? 2'b01 << write_turn : 2'b00;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      {read_q, write_q}             <= '0;
      {read_waits_q, write_waits_q} <= '0;
    end else begin
      if (ar_valid_o) read_q <= read_turn;
      if (aw_valid_o) write_q <= write_turn;
      read_waits_q  <= ar_valid_o && !ar_ready_i;
      write_waits_q <= aw_valid_o && !aw_ready_i;
    end
  end

  // --- data goes in the order of the addresses -----------------------------------------------------------------------
  pipegs_fifo #(.DataW(1), .Depth(Writes)) u_owners (
    .clk_i, .rst_ni, .in_valid_i(aw_valid_o && aw_ready_i), .in_ready_o(room), .in_i(write_turn),
    .out_valid_o(owned), .out_ready_i(w_valid_o && w_ready_i && w_last_o), .out_o(owner), .count_o()
  );
  assign w_valid_o = owned && w_valid_i[owner];
  assign w_o       = w_i[owner];
  assign w_last_o  = w_last_i[owner];
  assign w_ready_o = owned && w_ready_i ? 2'b01 << owner : 2'b00;

  // --- answers go home -----------------------------------------------------------------------------------------------
  assign r_valid_o = r_valid_i ? 2'b01 << r_to_i : 2'b00;
  assign r_ready_o = r_ready_i[r_to_i];
  assign b_valid_o = b_valid_i ? 2'b01 << b_to_i : 2'b00;
  assign b_ready_o = b_ready_i[b_to_i];

endmodule
