// SPDX-License-Identifier: Apache-2.0
// pipegs_control_bus: the AXI4-Lite subordinate of the registers: what the bus asks becomes one write and one read
// strobe.
//
// Idea    One register in front for each of the channels AW, W and AR, one behind for B and R. A write is done when its
//         address and its data are there and B is free; a read when its address is there and R is free. Both may be
//         done in the same cycle: the read then sees what was before the write.
// Stream  s_axi: AXI4-Lite of 32 bits; every output is a register. write_o, read_o: pulses. write_error_i,
//         read_error_i, read_data_i belong to the address that is shown in the cycle of the pulse; an error is answered
//         with SLVERR.
// Pace    One write and one read per two cycles; the answer comes two cycles after the request.
// Model   cpp_model/control/control_registers.hpp

module pipegs_control_bus #(
  localparam int unsigned AddressW = pipegs_pkg::ControlAddressW,
  localparam int unsigned WordW    = AddressW - 2
) (
  input  logic                clk_i,
  input  logic                rst_ni,

  input  pipegs_pkg::axi_lite_manager_t     s_axi_i,
  output pipegs_pkg::axi_lite_subordinate_t s_axi_o,

  output logic                write_o,
  output logic [WordW-1:0]    write_word_o,   // number of the register
  output logic [31:0]         write_data_o,
  output logic [31:0]         write_mask_o,   // ones in the bytes that are written
  input  logic                write_error_i,
  output logic                read_o,
  output logic [WordW-1:0]    read_word_o,
  input  logic [31:0]         read_data_i,
  input  logic                read_error_i
);

  // AXI's OKAY is 0, SLVERR 2: the upper bit of an answer is the error, the lower one 0.
  logic             aw_ready_q, w_ready_q, ar_ready_q;  // the channel's register is empty
  logic             b_valid_q, b_error_q, r_valid_q, r_error_q;
  logic [WordW-1:0] aw_word_q, ar_word_q;
  logic [31:0]      w_data_q, r_data_q;
  logic [3:0]       w_strobe_q;
  logic             unused_low;

  assign unused_low = &{1'b0, s_axi_i.aw_addr[1:0], s_axi_i.ar_addr[1:0]};

  assign write_o      = !aw_ready_q && !w_ready_q && (!b_valid_q || s_axi_i.b_ready);
  assign write_word_o = aw_word_q;
  assign write_data_o = w_data_q;
  assign write_mask_o = {{8{w_strobe_q[3]}}, {8{w_strobe_q[2]}}, {8{w_strobe_q[1]}}, {8{w_strobe_q[0]}}};
  assign read_o       = !ar_ready_q && (!r_valid_q || s_axi_i.r_ready);
  assign read_word_o  = ar_word_q;

  assign s_axi_o.aw_ready = aw_ready_q;
  assign s_axi_o.w_ready  = w_ready_q;
  assign s_axi_o.b_valid  = b_valid_q;
  assign s_axi_o.b_resp   = {b_error_q, 1'b0};
  assign s_axi_o.ar_ready = ar_ready_q;
  assign s_axi_o.r_valid  = r_valid_q;
  assign s_axi_o.r_data   = r_data_q;
  assign s_axi_o.r_resp   = {r_error_q, 1'b0};

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      aw_ready_q <= 1'b1;
      w_ready_q  <= 1'b1;
      ar_ready_q <= 1'b1;
      b_valid_q  <= 1'b0;
      r_valid_q  <= 1'b0;
    end else begin
      if (aw_ready_q) aw_ready_q <= !s_axi_i.aw_valid;
      else if (write_o) aw_ready_q <= 1'b1;
      if (w_ready_q) w_ready_q <= !s_axi_i.w_valid;
      else if (write_o) w_ready_q <= 1'b1;
      if (ar_ready_q) ar_ready_q <= !s_axi_i.ar_valid;
      else if (read_o) ar_ready_q <= 1'b1;
      if (write_o) b_valid_q <= 1'b1;
      else if (s_axi_i.b_ready) b_valid_q <= 1'b0;
      if (read_o) r_valid_q <= 1'b1;
      else if (s_axi_i.r_ready) r_valid_q <= 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (aw_ready_q && s_axi_i.aw_valid) aw_word_q <= s_axi_i.aw_addr[AddressW-1:2];
    if (w_ready_q && s_axi_i.w_valid) begin
      w_data_q   <= s_axi_i.w_data;
      w_strobe_q <= s_axi_i.w_strb;
    end
    if (ar_ready_q && s_axi_i.ar_valid) ar_word_q <= s_axi_i.ar_addr[AddressW-1:2];
    if (write_o) b_error_q <= write_error_i;
    if (read_o) begin
      r_error_q <= read_error_i;
      r_data_q  <= read_data_i;
    end
  end

endmodule
