// SPDX-License-Identifier: Apache-2.0
// pipegs_memory_arbiter: all requesters of the chip share the one port to external memory.
//
// Idea    The ports that may write stand nearer to the image and go first, with the DOPU's, which asks for little and
//         waits for each answer: what these wait for holds up all others. Then come the colours, one line each, and
//         last the geometry, in bursts: after one of n lines no geometry is asked for in n - 1 cycles, so that others
//         find no more lines before theirs than without bursts. Round robin within each class; one request per cycle;
//         the port number travels as the tag, and an answer goes back to the port that its tag names. Writes carry a
//         line of data and get no answer. Port order: WritePorts that may write, then those that only read. The choice
//         is registered: a grant is for the next cycle, so no requester's valid reaches a ready in the same one. It
//         falls on a port other than the one that is served now if there is one, else it stays: one port alone moves a
//         request each cycle.
// Stream  ports: valid, ready, write, address, halves, lines, data. out: memory_request_t and the data. answers: tag
//         and data in, one valid per port out; a requester asks only for what it has room for, so answers are never
//         refused.
// Pace    One request and one answer per cycle; three cycles of latency out (two for the port served last), one back.
// Model   sim/memory/external_memory.hpp applies requests in the order in which this port shows them.

module pipegs_memory_arbiter #(
  localparam int unsigned Ports      = pipegs_pkg::MemoryPorts,
  localparam int unsigned WritePorts = pipegs_pkg::WritePorts,
  localparam int unsigned PortW      = $clog2(Ports)
) (
  input  logic clk_i,
  input  logic rst_ni,

  input  logic [Ports-1:0]                               valid_i,
  output logic [Ports-1:0]                               ready_o,
  input  logic [WritePorts-1:0]                          write_i,
  input  logic [Ports*pipegs_pkg::AddressW-1:0]          address_i,
  input  logic [Ports*pipegs_pkg::HalvesW-1:0]           halves_i,  // of the line: what a write changes, or a read of
                                                                    // one line needs
  input  logic [Ports*pipegs_pkg::BurstW-1:0]            lines_i,      // of a read, less one
  input  logic [WritePorts*pipegs_pkg::MemoryW-1:0]      data_i,
  input  logic                                           stop_i,  // nothing is taken any more
  output logic [Ports-1:0]                               rsp_valid_o,
  output logic [pipegs_pkg::MemoryW-1:0]                 rsp_data_o,

  output logic                                           mem_valid_o,
  input  logic                                           mem_ready_i,
  output pipegs_pkg::memory_request_t                    mem_request_o,
  output logic [pipegs_pkg::MemoryW-1:0]                 mem_data_o,
  input  logic                                           mem_rsp_valid_i,
  input  logic [pipegs_pkg::TagW-1:0]                    mem_rsp_tag_i,
  input  logic [pipegs_pkg::MemoryW-1:0]                 mem_rsp_data_i
);

  localparam int unsigned      Units    = pipegs_pkg::Units;
  localparam int unsigned      BurstW   = pipegs_pkg::BurstW;
  localparam logic [Ports-1:0] Geometry = ((Ports'(1) << Units) - Ports'(1)) << WritePorts;

  logic [Ports-1:0]                  able, others, first, second, request, grant, grant_q;
  logic [BurstW-1:0]                 pause_q;              // cycles in which no geometry is asked for
  logic [PortW-1:0]                  port, port_q;
  // the port of the grant asks; the register on the way out takes
  logic                              served, free, take;
  logic                              moves;               // the grant may fall on another port
  logic                              out_valid_q;
  pipegs_pkg::memory_request_t       out, request_q;
  logic [pipegs_pkg::MemoryW-1:0]    data, data_q;

  assign able    = pause_q != '0 ? ~Geometry : '1;
  assign others  = valid_i & able & ~grant_q;
  assign first   = {others[Ports-1], (Ports - 1)'(others[WritePorts-1:0])};
  assign second  = others & ~Geometry;
  assign request = first != '0 ? first : second != '0 ? second : others;

  pipegs_arbiter #(.Ports(Ports)) u_arbiter (
    .clk_i,
    .rst_ni,
    .request_i(request),
    .advance_i(moves),
    .grant_o(grant),
    .port_o(port)
  );

  assign served  = (grant_q & valid_i & able) != '0;
  assign free    = (!out_valid_q || mem_ready_i) && !stop_i;
  assign take    = served && free;
  assign moves   = !served || free;
  assign ready_o = free ? grant_q & able : '0;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) grant_q <= '0;
    else if (request != '0 && moves) grant_q <= grant;
  end
  always_ff @(posedge clk_i) if (request != '0 && moves) port_q <= port;

  typedef struct packed {logic [Ports-1:0][pipegs_pkg::AddressW-1:0] of;} addresses_t;
  typedef struct packed {logic [WritePorts-1:0][pipegs_pkg::MemoryW-1:0] of;} lines_data_t;
  addresses_t  address;
  lines_data_t lines_data;
  assign address    = address_i;
  assign lines_data = data_i;
  always_comb begin
    out        = '0;
    out.tag    = pipegs_pkg::TagW'(port_q);
    out.halves = '1;
    data       = '0;
    for (int unsigned i = 0; i < Ports; i += 1) begin
      out.lines   |= lines_i[i*BurstW +: BurstW] & {BurstW{grant_q[i]}};
      out.address |= address.of[i] & {pipegs_pkg::AddressW{grant_q[i]}};
      out.halves  &= halves_i[i*pipegs_pkg::HalvesW +: pipegs_pkg::HalvesW] | {pipegs_pkg::HalvesW{!grant_q[i]}};
    end
    for (int unsigned i = 0; i < WritePorts; i += 1) begin
      out.write |= write_i[i] && grant_q[i];
      data      |= lines_data.of[i] & {pipegs_pkg::MemoryW{grant_q[i]}};
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) pause_q <= '0;
    else if (take && (grant_q & Geometry) != '0) pause_q <= out.lines;
    else if (pause_q != '0) pause_q <= pause_q - 1'b1;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) out_valid_q <= 1'b0;
    else if (take) out_valid_q <= 1'b1;
    else if (mem_ready_i) out_valid_q <= 1'b0;
  end

  always_ff @(posedge clk_i) begin
    if (take) request_q <= out;
    if (take && out.write) data_q <= data;
  end

  assign mem_valid_o   = out_valid_q;
  assign mem_request_o = request_q;
  assign mem_data_o    = data_q;

  // Answers: registered once, then to the port of their tag.
  logic [Ports-1:0]               rsp_valid_q;
  logic [pipegs_pkg::MemoryW-1:0] rsp_data_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      rsp_valid_q <= '0;
    end else begin
      for (int unsigned i = 0; i < Ports; i += 1) begin
        rsp_valid_q[i] <= mem_rsp_valid_i && mem_rsp_tag_i == pipegs_pkg::TagW'(i);
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (mem_rsp_valid_i) rsp_data_q <= mem_rsp_data_i;
  end

  assign rsp_valid_o = rsp_valid_q;
  assign rsp_data_o  = rsp_data_q;

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits({mem_request_o, mem_data_o})), .Proven(1)) u_check_mem (
    .clk_i,
    .rst_ni,
    .valid_i(mem_valid_o),
    .ready_i(mem_ready_i),
    .beat_i({mem_request_o, mem_data_o})
  );
`endif

endmodule
