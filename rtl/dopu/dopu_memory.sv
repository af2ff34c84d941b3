// SPDX-License-Identifier: Apache-2.0
// dopu_memory: the DOPU's port of external memory: lines of chunks, of groups and of cells.
//
// Idea    Answers come back in the order of the requests, so a queue of who asked tells whose an answer is. The table
//         of cells is loaded before anything else is asked: until then every answer is its.
// Stream  request_i of chunks (0), groups (1), cells (2), each with an address; answer_o: whose line came.
// Pace    One request per cycle.
// Model   Plumbing; tested with the whole DOPU.

module dopu_memory #(
  localparam int unsigned AddressW = pipegs_pkg::AddressW
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  input  logic                  loading_i,  // the cells

  input  logic [2:0]            request_i,
  output logic [2:0]            ready_o,
  input  logic [3*AddressW-1:0] address_i,
  output logic [2:0]            answer_o,

  output logic                  mem_valid_o,
  input  logic                  mem_ready_i,
  output logic [AddressW-1:0]   mem_address_o,
  input  logic                  rsp_valid_i
);

  localparam int unsigned Asked = 2 * pipegs_pkg::NodeLines;  // answers of chunks and groups to come

  logic [2:0] grant;
  logic [1:0] granted;
  logic       group, asked_valid, asked_ready;

  arbiter #(.Ports(3)) u_arbiter (
    .clk_i, .rst_ni, .request_i, .advance_i(mem_ready_i), .grant_o(grant), .port_o(granted)
  );
  assign mem_valid_o   = grant != '0;
  assign mem_address_o = granted == 2'd2 ? address_i[2*AddressW +: AddressW]
                       : granted == 2'd1 ? address_i[AddressW +: AddressW] : address_i[0 +: AddressW];
  assign ready_o       = grant & {3{mem_ready_i}};

  fifo #(.DataW(1), .Depth(Asked)) u_asked (
    .clk_i, .rst_ni, .in_valid_i(ready_o[1:0] != '0), .in_ready_o(asked_ready), .in_i(granted[0]),
    .out_valid_o(asked_valid), .out_ready_i(rsp_valid_i && !loading_i), .out_o(group), .count_o()
  );
  assign answer_o = !rsp_valid_i ? '0 : loading_i ? 3'b100 : group ? 3'b010 : 3'b001;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!(rsp_valid_i && !loading_i) || asked_valid);
  always_ff @(posedge clk_i) if (rst_ni) assert (ready_o[1:0] == '0 || asked_ready);
  stream_check #(.DataW($bits(mem_address_o))) u_check_mem (
    .clk_i, .rst_ni, .valid_i(mem_valid_o), .ready_i(mem_ready_i), .beat_i(mem_address_o)
  );
`else
  logic unused_asked;
  assign unused_asked = asked_valid ^ asked_ready;
`endif

endmodule
