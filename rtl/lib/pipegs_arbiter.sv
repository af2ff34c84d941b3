// SPDX-License-Identifier: Apache-2.0
// pipegs_arbiter: grants one of N requests, fairly.
//
// Idea    Round robin: the search starts after the port that was granted last, so no request waits for more than N - 1
//         grants. A grant that is not taken (advance_i low) is kept, so a stream behind it stays stable.
// Stream  request_i, one bit per port; grant_o one-hot (zero without a request) and its number.
// Pace    Combinational; one grant per cycle.
// Model   The way round, in its proof.

module pipegs_arbiter #(
  parameter int unsigned Ports = 4,
  localparam int unsigned PortW = Ports > 1 ? $clog2(Ports) : 1
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic [Ports-1:0] request_i,
  input  logic             advance_i,  // the grant is used in this cycle
  output logic [Ports-1:0] grant_o,
  output logic [PortW-1:0] port_o
);

  logic [PortW-1:0] last_q;    // granted and used last
  logic             locked_q;  // a grant was shown and not used: it must not move
  logic [PortW-1:0] shown_q;
  logic [PortW-1:0] turn, port;

  pipegs_round_robin #(.Ports(Ports)) u_turn (
    .mask_i(request_i),
    .last_i(last_q),
    .choice_o(turn)
  );
  assign port = locked_q && request_i[shown_q] ? shown_q : turn;
  always_comb begin
    grant_o = '0;
    grant_o[port] = request_i[port];
  end
  assign port_o = port;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      last_q   <= '0;
      locked_q <= 1'b0;
      shown_q  <= '0;
    end else begin
      if (advance_i && request_i != '0) last_q <= port;
      locked_q <= request_i != '0 && !advance_i;
      shown_q  <= port;
    end
  end

endmodule
