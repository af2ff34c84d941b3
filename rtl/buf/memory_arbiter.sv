// memory_arbiter: all requesters of the chip share the one port to external memory.
//
// Idea    The ports that may write stand nearer to the image and go first, with the DOPU's, which asks for little and waits
//         for each answer: what these wait for holds up all others. Round robin among them, and among the others; one
//         request per cycle, registered on its way out; the port number travels as the tag, and an answer goes back to
//         the port that its tag names. Writes carry a line of data and get no answer.
//         Port order: WritePorts that may write, then those that only read.
// Stream  ports: valid, ready, write, address, data. out: memory_request_t and the data. answers: tag and data in, one
//         valid per port out; a requester asks only for what it has room for, so answers are never refused.
// Pace    One request and one answer per cycle; two cycles of latency out, one back.
// Model   sim/external_memory.hpp applies requests in the order in which this port shows them.

module memory_arbiter #(
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
  input  logic [WritePorts*pipegs_pkg::MemoryW-1:0]      data_i,
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

  logic [Ports-1:0]                  first, request, grant;
  logic [PortW-1:0]                  port;
  logic                              take;
  logic                              out_valid_q;
  pipegs_pkg::memory_request_t       out, request_q;
  logic [pipegs_pkg::MemoryW-1:0]    data_q;

  assign first   = {valid_i[Ports-1], (Ports - 1)'(valid_i[WritePorts-1:0])};
  assign request = first != '0 ? first : valid_i;

  arbiter #(.Ports(Ports)) u_arbiter (
    .clk_i, .rst_ni, .request_i(request), .advance_i(take), .grant_o(grant), .port_o(port)
  );

  assign take    = (valid_i != '0) && (!out_valid_q || mem_ready_i);
  assign ready_o = take ? grant : '0;

  always_comb begin
    out.write   = 1'b0;
    for (int unsigned i = 0; i < WritePorts; i += 1) if (grant[i]) out.write = write_i[i];
    out.address = address_i[port*pipegs_pkg::AddressW +: pipegs_pkg::AddressW];
    out.tag     = pipegs_pkg::TagW'(port);
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) out_valid_q <= 1'b0;
    else if (take) out_valid_q <= 1'b1;
    else if (mem_ready_i) out_valid_q <= 1'b0;
  end

  always_ff @(posedge clk_i) begin
    if (take) request_q <= out;
    for (int unsigned i = 0; i < WritePorts; i += 1) begin
      if (take && grant[i] && write_i[i]) data_q <= data_i[i*pipegs_pkg::MemoryW +: pipegs_pkg::MemoryW];
    end
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

endmodule
