// SPDX-License-Identifier: Apache-2.0
// dopu_memory: the DOPU's port of external memory: lines of chunks, of groups and of cells.
//
// Idea    Answers come back in the order of the requests, so a queue of who asked for how many lines tells whose an
//         answer is; while it is full nothing is asked. The table of cells is loaded before anything else is asked:
//         until then every answer is its.
// Stream  request_i of chunks (0), groups (1), cells (2), each with an address and lines; answer_o: whose line came.
// Pace    One request per cycle.
// Model   Plumbing; tested with the whole DOPU.

module dopu_memory #(
  localparam int unsigned AddressW = pipegs_pkg::AddressW,
  localparam int unsigned BurstW   = pipegs_pkg::BurstW
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  input  logic                  loading_i,  // the cells

  input  logic [2:0]            request_i,
  output logic [2:0]            ready_o,
  input  logic [3*AddressW-1:0] address_i,
  input  logic [3*BurstW-1:0]   lines_i,    // less one
  output logic [2:0]            answer_o,

  output logic                  mem_valid_o,
  input  logic                  mem_ready_i,
  output logic [AddressW-1:0]   mem_address_o,
  output logic [BurstW-1:0]     mem_lines_o,  // less one
  input  logic                  rsp_valid_i
);

  localparam int unsigned Asked = pipegs_pkg::NodeLines / 2;  // requests of chunks and groups to be answered

  typedef struct packed {logic [2:0][AddressW-1:0] of;} addresses_t;
  typedef struct packed {logic [2:0][BurstW-1:0] of;} lines_t;
  addresses_t address;
  lines_t     wanted;
  logic [2:0] grant;
  logic [1:0] granted;
  logic [BurstW-1:0] lines, come_q;  // of the oldest request: its lines, less one, and how many have come
  logic       group, asked_valid, asked_ready, answer;

  pipegs_arbiter #(.Ports(3)) u_arbiter (
    .clk_i,
    .rst_ni,
    .request_i,
    .advance_i(mem_ready_i && asked_ready),
    .grant_o(grant),
    .port_o(granted)
  );
  assign mem_valid_o   = grant != '0 && asked_ready;
  assign {address, wanted} = {address_i, lines_i};
  assign mem_address_o = granted == 2'd2 ? address.of[2] : granted == 2'd1 ? address.of[1] : address.of[0];
  assign mem_lines_o   = granted == 2'd2 ? wanted.of[2] : granted == 2'd1 ? wanted.of[1] : wanted.of[0];
  assign ready_o       = grant & {3{mem_ready_i && asked_ready}};

  assign answer        = rsp_valid_i && !loading_i;

  pipegs_fifo #(.DataW(1 + BurstW), .Depth(Asked)) u_asked (
    .clk_i,
    .rst_ni,
    .in_valid_i(ready_o[1:0] != '0),
    .in_ready_o(asked_ready),
    .in_i({granted[0], mem_lines_o}),
    .out_valid_o(asked_valid),
    .out_ready_i(answer && come_q == lines),
    .out_o({group, lines}),
    .count_o()
  );
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) come_q <= '0;
    else if (answer) come_q <= come_q == lines ? '0 : come_q + 1'b1;
  end
  assign answer_o = !rsp_valid_i ? '0 : loading_i ? 3'b100 : group ? 3'b010 : 3'b001;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!answer || asked_valid);
  pipegs_stream_check #(.DataW($bits({mem_address_o, mem_lines_o}))) u_check_mem (
    .clk_i,
    .rst_ni,
    .valid_i(mem_valid_o),
    .ready_i(mem_ready_i),
    .beat_i({mem_address_o, mem_lines_o})
  );
`else
  logic unused_asked;
  assign unused_asked = asked_valid;
`endif

endmodule
