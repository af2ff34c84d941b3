// SPDX-License-Identifier: Apache-2.0
// pipegs_alpha_store: the lines of alphas of one lane, from a layer's rows until the RUs have blended them.
//
// Paper   The alpha buffer of Fig. 7.
// Idea    One SRAM with a line of 64 alphas per word. A line takes any slot that is free, and a second SRAM says which
//         one belongs to its address; exactly one RU needs it, once, so its slot is free again when it was read, or
//         skipped. How many slots may be taken, and when an address may be used again, is the business of pu_allocate.
//         All RUs read; a round-robin arbiter picks one per cycle. An address is taken modulo AlphaAddresses. No line
//         is asked for before the cycle behind its write.
// Stream  write: never refused. read: one port per RU, valid, ready, address, skip; the asker has room for the answer.
//         free_o: a slot is free.
// Pace    One write and one read per cycle. free_o comes one cycle after the read, answer_valid_o (one bit per RU, none
//         for a line that is skipped) and the line two.
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
  input  logic [Units-1:0]          read_skip_i,     // the line is not read
  output logic [Units-1:0]          answer_valid_o,
  output logic [LineW-1:0]          answer_o,
  output logic                      free_o,

  output logic                      active_o  // needs a clock
);

  localparam int unsigned Lines = pipegs_pkg::AlphaLines;
  localparam int unsigned RingW = $clog2(pipegs_pkg::AlphaAddresses);
  localparam int unsigned SlotW = pipegs_pkg::AlphaSlotW;
  localparam int unsigned PortW = Units > 1 ? $clog2(Units) : 1;

  logic [Units-1:0]    grant, asked_q, answer_valid_q;
  logic [PortW-1:0]    port;
  logic [AddressW-1:0] read_address;
  logic                read, free_q, slot_valid, pool_active;
  logic [SlotW-1:0]    write_slot, read_slot;
  logic [SlotW:0]      used;

  assign read           = read_valid_i != '0;
  assign read_ready_o   = grant;
  assign read_address   = read_address_i[port*AddressW +: AddressW];
  assign answer_valid_o = answer_valid_q;
  assign free_o         = free_q;
  assign active_o       = write_i || read || free_q || asked_q != '0 || answer_valid_q != '0 || pool_active;

  pipegs_arbiter #(.Ports(Units)) u_arbiter (
    .clk_i,
    .rst_ni,
    .request_i(read_valid_i),
    .advance_i(1'b1),
    .grant_o(grant),
    .port_o(port)
  );

  pipegs_slot_pool #(.Slots(Lines)) u_pool (
    .clk_i,
    .rst_ni,
    .renew_i(1'b0),
    .slot_valid_o(slot_valid),
    .slot_ready_i(write_i),
    .slot_o(write_slot),
    .free_i(free_q),
    .free_slot_i(read_slot),
    .used_o(used),
    .active_o(pool_active)
  );
  pipegs_sram #(.DataW(SlotW), .Depth(pipegs_pkg::AlphaAddresses)) u_slots (
    .clk_i,
    .write_i,
    .waddr_i(address_i[RingW-1:0]),
    .wdata_i(write_slot),
    .read_i(read),
    .raddr_i(read_address[RingW-1:0]),
    .rdata_o(read_slot)
  );
  pipegs_sram #(.DataW(LineW), .Depth(Lines)) u_lines (
    .clk_i,
    .write_i,
    .waddr_i(write_slot),
    .wdata_i(line_i),
    .read_i(asked_q != '0),
    .raddr_i(read_slot),
    .rdata_o(answer_o)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      free_q         <= 1'b0;
      asked_q        <= '0;
      answer_valid_q <= '0;
    end else begin
      free_q         <= read;
      asked_q        <= grant & ~read_skip_i;
      answer_valid_q <= asked_q;
    end
  end

  logic unused;
  assign unused = &{1'b0, address_i, read_address, slot_valid, used};

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!(read && write_i) || read_address[RingW-1:0] != address_i[RingW-1:0])
    else $error("pipegs_alpha_store: a line is read while it is written");
  always_ff @(posedge clk_i) if (rst_ni) assert (!write_i || slot_valid)
    else $error("pipegs_alpha_store: no slot is free");
`endif

endmodule
