// SPDX-License-Identifier: Apache-2.0
// The end of rtl/control/pipegs_control_events.sv in its proof: no event is lost, and the first address stays.
//
// Rule    A bit is set by its event, whatever is cleared with it, and falls only where a 1 was written. While an error
//         that gives frames up is held, the address and cause shown are those of the first, of several in one cycle of
//         the lowest; without an address 0 is shown, and not as one. The interrupt is what was set and enabled in the
//         cycle before.

(* anyconst *) logic [3:0] bit_number;  // any cause of ERROR
(* anyconst *) logic [1:0] irq_number;
logic                past_q, event_q, irq_event_q, was_q, irq_was_q, cleared_q, irq_cleared_q, raise_q, held_q;
logic                first_located_q;
logic [AddressW-1:0] first_line_q;
logic [2:0]          first_cause_q;
logic [Causes:0]     causes;
logic [2:0]          irq_events;

assign causes     = {start_full_i, error_i};
assign irq_events = {causes != '0, freed_i, frame_done_i};
proof_reset u_proof_reset (.clk_i, .rst_ni);
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) begin
    past_q <= 1'b0;
    held_q <= 1'b0;
  end else begin
    past_q <= 1'b1;
    held_q <= error_i != '0 || (error_q[Causes-1:0] & ~clear_error_i[Causes-1:0]) != '0;
  end
end
always_ff @(posedge clk_i) begin
  event_q       <= causes[bit_number];
  was_q         <= error_o[bit_number];
  cleared_q     <= clear_error_i[bit_number];
  irq_event_q   <= irq_events[irq_number];
  irq_was_q     <= irq_status_o[irq_number];
  irq_cleared_q <= clear_irq_i[irq_number];
  raise_q       <= (irq_status_o & enable_i) != '0;
  // Nothing of its kind is kept over this cycle: what comes in it is the first.
  if ((error_q[Causes-1:0] & ~clear_error_i[Causes-1:0]) == '0) begin
    for (int unsigned i = Causes; i > 0; i -= 1) begin
      if (error_i[i-1]) begin
        first_line_q    <= located_i[i-1] ? error_address_i[(i-1)*AddressW +: AddressW] : '0;
        first_cause_q   <= 3'(i - 1);
        first_located_q <= located_i[i-1];
      end
    end
  end
end

always_comb begin
  assume (bit_number <= 4'(Causes) && irq_number != 2'd3);
  if (rst_ni) begin
    assert (error_first_o.valid == (error_o[Causes-1:0] != '0));
    assert (error_o[31:Causes+1] == '0 && irq_status_o[31:3] == '0);
    if (past_q) begin
      assert (error_o[bit_number] == (event_q || (was_q && !cleared_q)));
      assert (irq_status_o[irq_number] == (irq_event_q || (irq_was_q && !irq_cleared_q)));
      assert (irq_o == raise_q);
      assert (held_q == error_first_o.valid);
      assert (!held_q || (error_line_o == first_line_q && error_first_o.cause == first_cause_q));
      assert (error_first_o.located == (held_q && first_located_q));
    end else begin
      assert (error_o == '0 && irq_status_o == '0 && !irq_o && !held_q);
    end
  end
end
