// SPDX-License-Identifier: Apache-2.0
// The end of rtl/control/pipegs_control_shadow.sv in its proof: the queued frame stays until it is taken or dropped.
//
// Rule    What is shown as a frame is constant until it is taken or dropped, and it is shown exactly from a start until
//         then. What is not hit reads 0. What a slot does with a write is the proof of pipegs_control_slot.

logic [Bits-1:0] was_q;
logic            was_queued_q, was_taken_q, was_start_q, was_drop_q, was_write_q, past_q;

proof_reset u_proof_reset (.clk_i, .rst_ni);
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) past_q <= 1'b0;
  else past_q <= 1'b1;
end
always_ff @(posedge clk_i) begin
  was_q        <= {picture_o, areas_o, frame_o};
  was_queued_q <= frame_valid_o;
  was_taken_q  <= frame_ready_i;
  was_start_q  <= start_i;
  was_drop_q   <= drop_i;
  was_write_q  <= write_i && write_hit_o;
end

always_comb begin
  if (rst_ni) begin
    assert (read_hit_o || read_data_o == '0);
    if (past_q) begin
      assert ((!was_queued_q && was_write_q) || {picture_o, areas_o, frame_o} == was_q);
      assert (frame_valid_o == (!was_drop_q && (was_queued_q ? !was_taken_q : was_start_q)));
    end
  end
end
