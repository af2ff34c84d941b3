// SPDX-License-Identifier: Apache-2.0
// su_stores: the pool of slots: of each record its key, the link to the next of its chain, and the rest.
//
// Paper   Sec. 4.2.2 (the sorter's buffers).
// Idea    Three memories of Records words. The splitter never waits for a link: buckets link when it does not claim the
//         port. Keys of a set that spilled are a chain from the last slot to the first, with the numbers of their
//         records in place of these; nobody else is there then. The largest memory, what is not key, has one port: a
//         write waits for a cycle in a register, and in that cycle nothing is read (busy_o).
// Stream  writes of a collected record, of a key that comes back, of a link; reads of key and link, and of the
//         rest.
// Pace    One access of each kind per cycle, data one cycle later; behind a write no read of the rest.
// Model   cpp_model/su/su.hpp

module su_stores #(
  localparam int unsigned KeyW     = pipegs_pkg::KeyW,
  localparam int unsigned RecordW  = pipegs_pkg::RecordW,
  localparam int unsigned NumberW  = pipegs_pkg::SlotW,
  localparam int unsigned PayloadW = pipegs_pkg::SplatBits - pipegs_pkg::KindW - KeyW  // without IndexTies with index
) (
  input  logic                clk_i,
  input  logic                rst_ni,

  input  logic                write_i,  // a record that comes in
  input  logic [RecordW-1:0]  slot_i,
  input  pipegs_pkg::splat_t  record_i,

  input  pipegs_pkg::su_external_t external_i,  // su_external fills the pool, and merges in it

  input  logic                link_i,  // su_buckets chains a slot
  output logic                link_ready_o,
  input  logic [RecordW-1:0]  link_slot_i,
  input  logic [RecordW-1:0]  link_to_i,

  input  logic                split_claim_i,  // su_split walks chains and makes new ones
  input  logic                split_link_i,
  input  logic [RecordW-1:0]  split_link_slot_i,
  input  logic [RecordW-1:0]  split_link_to_i,
  input  logic                split_read_i,
  input  logic [RecordW-1:0]  split_slot_i,
  output logic [KeyW-1:0]     split_key_o,
  output logic [RecordW-1:0]  split_link_o,

  output logic                busy_o,          // the rest is written
  input  logic                payload_read_i,  // su_emit, while it is not
  input  logic [RecordW-1:0]  payload_slot_i,
  output logic [PayloadW-1:0] payload_o
);

  logic [KeyW-1:0]     key;
  logic [PayloadW-1:0] payload;
  assign payload      = PayloadW'({record_i} >> (pipegs_pkg::KindW + KeyW));
  su_key u_key (
    .splat_i(record_i),
    .key_o(key)
  );
  assign link_ready_o = !split_claim_i;

  pipegs_sram #(.DataW(KeyW), .Depth(pipegs_pkg::Records)) u_keys (
    .clk_i,
    .write_i(external_i.write || write_i),
    .waddr_i(external_i.write ? external_i.slot : slot_i),
    .wdata_i(external_i.write ? external_i.key : key),
    .read_i(split_read_i || external_i.read),
    .raddr_i(external_i.read ? external_i.read_slot : split_slot_i),
    .rdata_o(split_key_o)
  );
  pipegs_sram #(.DataW(RecordW), .Depth(pipegs_pkg::Records)) u_links (
    .clk_i,
    .write_i(split_link_i || external_i.write || (link_i && link_ready_o)),
    .waddr_i(split_link_i ? split_link_slot_i : external_i.write ? external_i.slot : link_slot_i),
    .wdata_i(split_link_i ? split_link_to_i : external_i.write ? external_i.slot - 1'b1 : link_to_i),
    .read_i(split_read_i),
    .raddr_i(split_slot_i),
    .rdata_o(split_link_o)
  );

  logic                write_q;
  logic [RecordW-1:0]  slot_q;
  logic [PayloadW-1:0] payload_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) write_q <= 1'b0;
    else write_q <= external_i.write || write_i;
  end
  always_ff @(posedge clk_i) begin
    if (external_i.write || write_i) begin
      slot_q    <= external_i.write ? external_i.slot : slot_i;
      payload_q <= {payload[PayloadW-1:NumberW], external_i.write ? external_i.number : payload[NumberW-1:0]};
    end
  end
  assign busy_o = write_q;

  pipegs_sram #(.DataW(PayloadW), .Depth(pipegs_pkg::Records), .Ports(1)) u_records (
    .clk_i,
    .write_i(write_q),
    .waddr_i(slot_q),
    .wdata_i(payload_q),
    .read_i(payload_read_i),
    .raddr_i(payload_slot_i),
    .rdata_o(payload_o)
  );

  logic unused;  // the kind
  assign unused = &{1'b0, record_i, external_i};

endmodule
