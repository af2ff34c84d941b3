// SPDX-License-Identifier: Apache-2.0
// axi_errors: what went wrong on the bus since the host looked last.
//
// Idea    The flags stay until they are cleared; beside them stand the tag of the first read and the line of the first
//         write that failed. An error in the cycle of the clearing counts as new.
// Stream  in: a read, a write that failed, each with "nothing is there" (DECERR; else SLVERR). out: flags, first ones.
// Pace    One of each per cycle; flags show one cycle later.
// Model   The test has the same flags.

module axi_errors #(
  localparam int unsigned LineW = pipegs_pkg::AddressW,
  localparam int unsigned TagW  = pipegs_pkg::TagW
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic             clear_i,
  input  logic             read_i,          // a beat of a read failed
  input  logic             read_decode_i,
  input  logic [TagW-1:0]  read_tag_i,
  input  logic             write_i,         // a write failed
  input  logic             write_decode_i,
  input  logic [LineW-1:0] write_line_i,

  output logic             error_o,         // for one cycle: something has failed
  output logic             read_error_o,    // a read has failed
  output logic             write_error_o,   // a write has failed
  output logic             decode_o,        // for one of them nothing was at its address
  output logic [TagW-1:0]  error_tag_o,     // of the first read that failed
  output logic [LineW-1:0] error_line_o     // of the first write that failed: number of its line
);

  logic             error_q, read_q, write_q, decode_q;
  logic [TagW-1:0]  tag_q;
  logic [LineW-1:0] line_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      error_q  <= 1'b0;
      read_q   <= 1'b0;
      write_q  <= 1'b0;
      decode_q <= 1'b0;
      tag_q    <= '0;
      line_q   <= '0;
    end else begin
      error_q  <= read_i || write_i;
      read_q   <= read_i || (read_q && !clear_i);
      write_q  <= write_i || (write_q && !clear_i);
      decode_q <= (read_i && read_decode_i) || (write_i && write_decode_i) || (decode_q && !clear_i);
      if (read_i && (!read_q || clear_i)) tag_q <= read_tag_i;
      if (write_i && (!write_q || clear_i)) line_q <= write_line_i;
    end
  end

  assign error_o       = error_q;
  assign read_error_o  = read_q;
  assign write_error_o = write_q;
  assign decode_o      = decode_q;
  assign error_tag_o   = tag_q;
  assign error_line_o  = line_q;

endmodule
