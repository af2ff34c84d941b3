// SPDX-License-Identifier: Apache-2.0
// ru_memory: an RU's port to external memory: reads of alpha lines and writes of pixels share it.
//
// Idea    One register holds the request, so it never changes while it waits. Reads go first: the lanes wait for them,
//         while writes only have to be done before the next window ends.
// Stream  read: an address. write: an address, a line and which halves of it count. mem: one request; nothing comes
//         back here.
// Pace    One request per cycle.
// Model   None: the test of the whole RU.

module ru_memory (
  input  logic                            clk_i,
  input  logic                            rst_ni,

  input  logic                            read_valid_i,
  output logic                            read_ready_o,
  input  logic [pipegs_pkg::AddressW-1:0] read_address_i,

  input  logic                            write_valid_i,
  output logic                            write_ready_o,
  input  logic [pipegs_pkg::AddressW-1:0] write_address_i,
  input  logic [pipegs_pkg::HalvesW-1:0]  write_halves_i,
  input  logic [pipegs_pkg::MemoryW-1:0]  write_data_i,

  output logic                            mem_valid_o,
  input  logic                            mem_ready_i,
  output logic                            mem_write_o,
  output logic [pipegs_pkg::AddressW-1:0] mem_address_o,
  output logic [pipegs_pkg::HalvesW-1:0]  mem_halves_o,   // all of a read
  output logic [pipegs_pkg::MemoryW-1:0]  mem_data_o
);

  logic                            valid_q, write_q, free;
  logic [pipegs_pkg::AddressW-1:0] address_q;
  logic [pipegs_pkg::HalvesW-1:0]  halves_q;
  logic [pipegs_pkg::MemoryW-1:0]  data_q;

  assign free          = !valid_q || mem_ready_i;
  assign read_ready_o  = free;
  assign write_ready_o = free && !read_valid_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= 1'b0;
    else if (free) valid_q <= read_valid_i || write_valid_i;
  end

  always_ff @(posedge clk_i) begin
    if (free && (read_valid_i || write_valid_i)) begin
      write_q   <= !read_valid_i;
      address_q <= read_valid_i ? read_address_i : write_address_i;
      halves_q  <= read_valid_i ? '1 : write_halves_i;
    end
    if (write_valid_i && write_ready_o) data_q <= write_data_i;
  end

  assign mem_valid_o   = valid_q;
  assign mem_write_o   = write_q;
  assign mem_address_o = address_q;
  assign mem_halves_o  = halves_q;
  assign mem_data_o    = data_q;

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits({mem_write_o, mem_address_o, mem_data_o}))) u_check_mem (
    .clk_i,
    .rst_ni,
    .valid_i(mem_valid_o),
    .ready_i(mem_ready_i),
    .beat_i({mem_write_o, mem_address_o, mem_data_o})
  );
`endif

endmodule
