// SPDX-License-Identifier: Apache-2.0
// pipegs_alpha_store: the lines of alphas of one lane, from a layer's rows until the RUs have blended them.
//
// Paper   The alpha buffer of Fig. 7.
// Idea    One SRAM with a line of 64 alphas per word. Writes come from the lane's PU; what may be overwritten is the
//         business of pu_allocate, which runs it as a ring. All RUs read; a round-robin arbiter picks one per cycle.
//         An address counts on beyond the ring's end: it is taken modulo AlphaLines. No line is asked for before the
//         cycle behind its write.
// Stream  write: never refused. read: one port per RU, valid, ready, address; the asker has room for the answer.
// Pace    One write and one read per cycle; answer_valid_o (one bit per RU) and the line come one cycle after the read.
// Model   An array.

module pipegs_alpha_store #(
  localparam int unsigned Units    = pipegs_pkg::Units,
  localparam int unsigned AddressW = pipegs_pkg::AlphaAddressW,
  localparam int unsigned LineW    = pipegs_pkg::LineW
) (
  input  logic                      clk_i,
  input  logic                      rst_ni,

  input  logic                      write_i,
  input  logic [AddressW-1:0]       address_i,
  input  logic [LineW-1:0]          line_i,

  input  logic [Units-1:0]          read_valid_i,
  output logic [Units-1:0]          read_ready_o,
  input  logic [Units*AddressW-1:0] read_address_i,
  output logic [Units-1:0]          answer_valid_o,
  output logic [LineW-1:0]          answer_o,

  output logic                      active_o  // needs a clock
);

  localparam int unsigned RingW = $clog2(pipegs_pkg::AlphaLines);
  localparam int unsigned PortW = Units > 1 ? $clog2(Units) : 1;

  logic [Units-1:0]    grant, answer_valid_q;
  logic [PortW-1:0]    port;
  logic [AddressW-1:0] read_address;
  logic                read;

  assign read           = read_valid_i != '0;
  assign read_ready_o   = grant;
  assign read_address   = read_address_i[port*AddressW +: AddressW];
  assign answer_valid_o = answer_valid_q;
  assign active_o       = write_i || read || answer_valid_q != '0;

  pipegs_arbiter #(.Ports(Units)) u_arbiter (
    .clk_i, .rst_ni, .request_i(read_valid_i), .advance_i(1'b1), .grant_o(grant), .port_o(port)
  );

  pipegs_sram #(.DataW(LineW), .Depth(pipegs_pkg::AlphaLines)) u_lines (
    .clk_i, .write_i, .waddr_i(address_i[RingW-1:0]), .wdata_i(line_i),
    .read_i(read), .raddr_i(read_address[RingW-1:0]), .rdata_o(answer_o)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) answer_valid_q <= '0;
    else answer_valid_q <= grant;
  end

  logic unused_address;
  assign unused_address = &{1'b0, address_i, read_address};

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!(read && write_i) || read_address[RingW-1:0] != address_i[RingW-1:0])
    else $error("pipegs_alpha_store: a line is read while it is written");
`endif

endmodule
