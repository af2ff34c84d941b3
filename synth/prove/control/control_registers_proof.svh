// SPDX-License-Identifier: Apache-2.0
// The end of rtl/control/pipegs_control_registers.sv in its proof: what the bus may do to the core, and what it is
// told.
//
// Rule    A frame is shown only after a start was written, stays until it is taken or an abort comes, and is not shown
//         with an abort. A write to a slot while a frame is shown is refused; a refused write changes nothing; what is
//         not refused is in the table. A read outside the table reads 0 and is refused.

logic        past_q, refused_q, start_q, abort_written_q, was_valid_q, was_ready_q, was_full_q;
logic [31:0] was_enable_q, was_error_q, was_timeout_q;
logic [pipegs_pkg::ControlShadowBits-1:0] was_q;

proof_reset u_proof_reset (.clk_i, .rst_ni);
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) past_q <= 1'b0;
  else past_q <= 1'b1;
end
always_ff @(posedge clk_i) begin
  refused_q       <= !write || write_error;
  start_q         <= write && write_word == 10'h4 && write_mask[0] && write_data[0];
  abort_written_q <= write && write_word == 10'h4 && write_mask[1] && write_data[1];
  was_valid_q     <= frame_valid_o;
  was_ready_q     <= frame_ready_i;
  was_enable_q    <= irq_enable_q;
  was_timeout_q   <= timeout_o;
  was_error_q     <= error;
  was_full_q      <= error.start_full;
  was_q           <= {picture_o, areas_o, frame_o};
end

always_comb begin
  if (rst_ni) begin
    assert (!(abort_o && frame_valid_o));
    assert (!write || write_error || live_writable || shadow_write_hit);
    assert (!(write && frame_valid_o && shadow_write_hit) || write_error);
    assert (!read_error || read_data == '0);
    assert (irq_enable_q[31:3] == '0);
    if (past_q) begin
      assert (abort_o == abort_written_q);
      assert (frame_valid_o == (!abort_o && (was_valid_q ? !was_ready_q : start_q)));
      assert (!was_valid_q || {picture_o, areas_o, frame_o} == was_q);
      assert (!refused_q || (irq_enable_q == was_enable_q && (was_error_q & ~error) == '0));
      assert (!refused_q || timeout_o == was_timeout_q);
      assert (!refused_q || {picture_o, areas_o, frame_o} == was_q);
      assert (!(was_valid_q && start_q && !abort_written_q) || error.start_full);
      assert (!error.start_full || was_full_q || (was_valid_q && start_q && !abort_written_q));
    end
  end
end
