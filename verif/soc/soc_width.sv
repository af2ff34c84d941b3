// SPDX-License-Identifier: Apache-2.0
// soc_width: the bus of a manager on one that is narrower by a power of two, for bursts of whole beats.
//
// Idea    A wide beat is Parts narrow ones in a row: a burst of n beats becomes one of n * Parts of the same bytes, and
//         that must be 256 beats at most (a burst of the core is 512 bytes). Addresses pass as they are. W is cut up, R
//         put together again with the worst of the responses; B passes by.
// Rule    R of one burst comes in one piece: nothing of another burst stands between its beats.
// Pace    A narrow beat a cycle each way; a wide beat of R shows one cycle behind its last part.

module soc_width #(
  parameter int unsigned IdW     = 9,
  parameter int unsigned WideW   = 512,
  parameter int unsigned NarrowW = 128,
  localparam int unsigned Parts  = WideW / NarrowW,
  localparam int unsigned PartW  = $clog2(Parts)
) (
  input  logic                 clk_i,
  input  logic                 rst_ni,

  input  logic [7:0]           arlen_i,
  output logic [7:0]           arlen_o,
  input  logic [7:0]           awlen_i,
  output logic [7:0]           awlen_o,

  input  logic                 w_valid_i,
  output logic                 w_ready_o,
  input  logic [WideW-1:0]     w_data_i,
  input  logic [WideW/8-1:0]   w_strb_i,
  input  logic                 w_last_i,
  output logic                 w_valid_o,
  input  logic                 w_ready_i,
  output logic [NarrowW-1:0]   w_data_o,
  output logic [NarrowW/8-1:0] w_strb_o,
  output logic                 w_last_o,

  input  logic                 r_valid_i,
  output logic                 r_ready_o,
  input  logic [IdW-1:0]       r_id_i,
  input  logic [NarrowW-1:0]   r_data_i,
  input  logic [1:0]           r_resp_i,
  input  logic                 r_last_i,
  output logic                 r_valid_o,
  input  logic                 r_ready_i,
  output logic [IdW-1:0]       r_id_o,
  output logic [WideW-1:0]     r_data_o,
  output logic [1:0]           r_resp_o,
  output logic                 r_last_o
);

  assign arlen_o = {arlen_i[7-PartW:0], {PartW{1'b1}}};  // (n + 1) * Parts - 1
  assign awlen_o = {awlen_i[7-PartW:0], {PartW{1'b1}}};

  // --- W: the part that is shown -------------------------------------------------------------------------------------
  logic [PartW-1:0] w_part_q;
  assign w_valid_o = w_valid_i;
  assign w_data_o  = w_data_i[w_part_q*NarrowW +: NarrowW];
  assign w_strb_o  = w_strb_i[w_part_q*(NarrowW/8) +: NarrowW/8];
  assign w_last_o  = w_last_i && w_part_q == '1;
  assign w_ready_o = w_ready_i && w_part_q == '1;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) w_part_q <= '0;
    else if (w_valid_i && w_ready_i) w_part_q <= w_part_q + 1'b1;
  end

  // --- R: parts are gathered until the wide beat is whole ------------------------------------------------------------
  logic [PartW-1:0] r_part_q;
  logic             whole_q, take;
  assign r_ready_o = !whole_q || r_ready_i;
  assign take      = r_valid_i && r_ready_o;
  assign r_valid_o = whole_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      r_part_q <= '0;
      whole_q  <= 1'b0;
    end else begin
      if (take) r_part_q <= r_part_q + 1'b1;
      if (r_ready_o) whole_q <= take && r_part_q == '1;
    end
  end
  logic unused_len;  // above 256 narrow beats
  assign unused_len = &{1'b0, arlen_i, awlen_i};

  always_ff @(posedge clk_i) begin
    if (take) begin
      r_data_o[r_part_q*NarrowW +: NarrowW] <= r_data_i;
      r_resp_o <= r_part_q == '0 || r_resp_i > r_resp_o ? r_resp_i : r_resp_o;
      r_id_o   <= r_id_i;
      r_last_o <= r_last_i;
    end
  end

endmodule
