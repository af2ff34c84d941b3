// SPDX-License-Identifier: Apache-2.0
// pipegs_pixel_buffer: T and colour of an RU's regions, twice: one half is blended while the other is written out.
//
// Paper   Fig. 7, the double-buffered T and RGB buffers.
// Idea    Two memories change roles at swap_i. Each word has a fresh flag instead of being cleared: swap_i makes all
//         words of the half that will be blended next fresh, a write makes its word valid.
// Stream  blend: read and write ports of the one half; resolve: read port of the other. Data and fresh flag come in the
//         cycle after the read and stay until the next one.
// Pace    One read and one write by the blender, of different words, and one read by the resolver in each cycle. No
//         read of either side may be outstanding at swap_i.
// Model   Two words, in its proof.

module pipegs_pixel_buffer #(
  parameter int unsigned DataW = 64,
  parameter int unsigned Words = 64,
  localparam int unsigned AddrW = $clog2(Words)
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic             swap_i,

  input  logic             blend_read_i,
  input  logic [AddrW-1:0] blend_raddr_i,
  output logic [DataW-1:0] blend_rdata_o,
  output logic             blend_fresh_o,
  input  logic             blend_write_i,
  input  logic [AddrW-1:0] blend_waddr_i,
  input  logic [DataW-1:0] blend_wdata_i,

  input  logic             resolve_read_i,
  input  logic [AddrW-1:0] resolve_raddr_i,
  output logic [DataW-1:0] resolve_rdata_o,
  output logic             resolve_fresh_o
);

  logic             half_q;              // the half that is blended
  logic [Words-1:0] fresh_0_q, fresh_1_q;
  logic             blend_fresh_q, resolve_fresh_q;
  logic [DataW-1:0] rdata_0, rdata_1;

  assign blend_rdata_o   = half_q ? rdata_1 : rdata_0;
  assign resolve_rdata_o = half_q ? rdata_0 : rdata_1;
  assign blend_fresh_o   = blend_fresh_q;
  assign resolve_fresh_o = resolve_fresh_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      half_q    <= 1'b0;
      fresh_0_q <= '1;
      fresh_1_q <= '1;
    end else begin
      if (blend_write_i && !half_q) fresh_0_q[blend_waddr_i] <= 1'b0;
      if (blend_write_i && half_q) fresh_1_q[blend_waddr_i] <= 1'b0;
      if (swap_i) begin
        half_q <= !half_q;
        if (half_q) fresh_0_q <= '1;
        else fresh_1_q <= '1;
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (blend_read_i) blend_fresh_q <= half_q ? fresh_1_q[blend_raddr_i] : fresh_0_q[blend_raddr_i];
    if (resolve_read_i) resolve_fresh_q <= half_q ? fresh_0_q[resolve_raddr_i] : fresh_1_q[resolve_raddr_i];
  end

  pipegs_sram #(.DataW(DataW), .Depth(Words)) u_half_0 (
    .clk_i,
    .write_i(blend_write_i && !half_q),
    .waddr_i(blend_waddr_i),
    .wdata_i(blend_wdata_i),
    .read_i (half_q ? resolve_read_i : blend_read_i),
    .raddr_i(half_q ? resolve_raddr_i : blend_raddr_i),
    .rdata_o(rdata_0)
  );

  pipegs_sram #(.DataW(DataW), .Depth(Words)) u_half_1 (
    .clk_i,
    .write_i(blend_write_i && half_q),
    .waddr_i(blend_waddr_i),
    .wdata_i(blend_wdata_i),
    .read_i (half_q ? blend_read_i : resolve_read_i),
    .raddr_i(half_q ? blend_raddr_i : resolve_raddr_i),
    .rdata_o(rdata_1)
  );

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!swap_i || (!blend_write_i && !blend_read_i && !resolve_read_i))
    else $error("pipegs_pixel_buffer: access during a swap");
  always_ff @(posedge clk_i) if (rst_ni)
    assert (!(blend_read_i && blend_write_i) || blend_raddr_i != blend_waddr_i)
    else $error("pipegs_pixel_buffer: a word is read while it is written");
`endif

endmodule
