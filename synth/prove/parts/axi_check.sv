// SPDX-License-Identifier: Apache-2.0
// axi_check: the rules of AXI4 between pipegs_axi_manager and a subordinate, in immediate assertions, for tests and
// proofs.
//
// Rule    Manager: nothing valid in reset; what is shown stays until taken; bursts of INCR in beats of the bus,
//         aligned, of one to eight whole lines within 4 KB, or if Coded of half a line, in beats of half the bus where
//         that is as wide as a line; writes of one line with ID 0, strobes of whole halves of
//         it, WLAST at the last beat, data never before its address shows; at most Reads and Writes bursts unanswered.
//         Subordinate: the same of valid and stay; R only with an ID that waits, RLAST exactly at the last beat of its
//         burst, in order within an ID; B with ID 0 only after address and last beat of a write; no EXOKAY.
// Idea    Counters know what is out, by ID for reads. RLAST is checked for one burst at a time, chosen by pick_i when
//         its address is taken, with the bursts of its ID ahead of it: what holds for any choice holds for all.
// Use     Bound to the module in Verilator, where each rule is asserted at the clock's edge. In a proof the checker of
//         a module asserts manager_o and assumes subordinate_o, each of which is up while the rules are kept.

module axi_check #(
  parameter int unsigned Reads  = 256,
  parameter int unsigned Writes = 64,
  localparam int unsigned IdW     = pipegs_pkg::AxiIdW,
  localparam int unsigned ReadsW  = $clog2(Reads + 1) + 1,
  localparam int unsigned WritesW = $clog2(Writes + 1) + 1
) (
  input  logic               clk_i,
  input  logic               rst_ni,
  input  logic               pick_i,

  input  pipegs_pkg::axi_manager_t     manager_i,
  input  pipegs_pkg::axi_subordinate_t subordinate_i,

  output logic               manager_o,      // the manager keeps its rules
  output logic               subordinate_o,  // likewise
  output logic [ReadsW-1:0]  reads_o,        // bursts on AR that are not answered
  output logic [(1<<IdW)*ReadsW-1:0] reads_of_o,  // of each ID
  output logic [WritesW-1:0] addresses_o,    // writes whose address was taken and that are not answered
  output logic [WritesW-1:0] lines_o,        // likewise of their last beat
  output logic [7:0]         beat_o          // beats taken of the burst on W
);

  localparam int unsigned DataW     = pipegs_pkg::AxiDataW;
  localparam int unsigned LineW     = pipegs_pkg::MemoryW;
  localparam int unsigned Ids       = 1 << IdW;
  localparam int unsigned Beats     = LineW / DataW;
  localparam int unsigned GrainB    = DataW < LineW / 2 ? DataW / 8 : LineW / 16;  // bytes of a beat and of half a line
  localparam int unsigned Grains    = DataW / 8 / GrainB;
  localparam logic [2:0]  Size      = 3'($clog2(DataW / 8));

  logic                  ar_take, aw_take, w_take, w_end, r_take, r_end, b_take;
  pipegs_pkg::axi_address_t ar, aw, ar_q, aw_q;
  pipegs_pkg::axi_w_t    w, w_q;
  pipegs_pkg::axi_r_t    r, r_q;
  pipegs_pkg::axi_b_t    b, b_q;
  logic                  ar_waits_q, aw_waits_q, w_waits_q, r_waits_q, b_waits_q, reset_q;

  assign ar_take = manager_i.read.ar_valid && subordinate_i.read.ar_ready;
  assign aw_take = manager_i.write.aw_valid && subordinate_i.write.aw_ready;
  assign w_take  = manager_i.write.w_valid && subordinate_i.write.w_ready;
  assign w_end   = w_take && w.last;
  assign r_take  = subordinate_i.read.r_valid && manager_i.read.r_ready;
  assign r_end   = r_take && r.last;
  assign b_take  = subordinate_i.write.b_valid && manager_i.write.b_ready;
  assign ar      = manager_i.read.ar;
  assign aw      = manager_i.write.aw;
  assign w       = manager_i.write.w;
  assign r       = subordinate_i.read.r;
  assign b       = subordinate_i.write.b;

  // --- what waits ----------------------------------------------------------------------------------------------------
  always_ff @(posedge clk_i) begin
    reset_q    <= !rst_ni;
    ar_waits_q <= rst_ni && manager_i.read.ar_valid && !subordinate_i.read.ar_ready;
    aw_waits_q <= rst_ni && manager_i.write.aw_valid && !subordinate_i.write.aw_ready;
    w_waits_q  <= rst_ni && manager_i.write.w_valid && !subordinate_i.write.w_ready;
    r_waits_q  <= rst_ni && subordinate_i.read.r_valid && !manager_i.read.r_ready;
    b_waits_q  <= rst_ni && subordinate_i.write.b_valid && !manager_i.write.b_ready;
    ar_q       <= ar;
    aw_q       <= aw;
    w_q        <= w;
    r_q        <= r;
    b_q        <= b;
  end

  // --- what is out ---------------------------------------------------------------------------------------------------
  logic [ReadsW-1:0]     reads_q, reads_of_r, reads_of_ar;
  logic [Ids*ReadsW-1:0] reads_of_q;       // of each ID
  logic [WritesW-1:0]    addresses_q, lines_q;
  logic [7:0]            beat_q;
  logic                  tracked_q;        // the chosen burst is out
  logic [IdW-1:0]        tracked_id_q;
  logic [ReadsW-1:0]     tracked_ahead_q;  // bursts of its ID ahead of it
  logic [7:0]            tracked_left_q;   // beats of it that come before its last

  assign reads_of_r  = reads_of_q[r.id*ReadsW +: ReadsW];
  assign reads_of_ar = reads_of_q[ar.id*ReadsW +: ReadsW];

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      reads_q     <= '0;
      reads_of_q  <= '0;
      addresses_q <= '0;
      lines_q     <= '0;
      beat_q      <= '0;
      tracked_q   <= 1'b0;
    end else begin
      reads_q     <= reads_q + ReadsW'(ar_take) - ReadsW'(r_end);
      addresses_q <= addresses_q + WritesW'(aw_take) - WritesW'(b_take);
      lines_q     <= lines_q + WritesW'(w_end) - WritesW'(b_take);
      if (w_take) beat_q <= w.last ? '0 : beat_q + 1'b1;
      if (ar_take && !(r_end && ar.id == r.id)) begin
        reads_of_q[ar.id*ReadsW +: ReadsW] <= reads_of_ar + 1'b1;
      end
      if (r_end && !(ar_take && ar.id == r.id)) begin
        reads_of_q[r.id*ReadsW +: ReadsW] <= reads_of_r - 1'b1;
      end
      if (!tracked_q) tracked_q <= ar_take && pick_i;
      else if (r_end && r.id == tracked_id_q && tracked_ahead_q == '0) tracked_q <= 1'b0;
    end
  end
  always_ff @(posedge clk_i) begin
    if (!tracked_q) begin
      tracked_id_q    <= ar.id;
      tracked_ahead_q <= reads_of_ar - ReadsW'(r_end && r.id == ar.id);
      tracked_left_q  <= ar.len;
    end else if (r_take && r.id == tracked_id_q) begin
      if (tracked_ahead_q == '0) tracked_left_q <= tracked_left_q - 1'b1;
      else if (r.last) tracked_ahead_q <= tracked_ahead_q - 1'b1;
    end
  end

  assign reads_o     = reads_q;
  assign reads_of_o  = reads_of_q;
  assign addresses_o = addresses_q;
  assign lines_o     = lines_q;
  assign beat_o      = beat_q;

  // --- rules of the manager ------------------------------------------------------------------------------------------
  logic        ar_whole, ar_half;  // of the burst: lines, half a line
  logic        silent, ar_stays, aw_stays, w_stays, ar_legal, aw_legal, w_legal, w_behind, few;
  logic [8:0]  ar_beats;
  logic [13:0] ar_end, aw_end;  // of the burst, in bytes from the begin of its 4 KB

  assign ar_beats = {1'b0, ar.len} + 9'd1;
  assign ar_end   = 14'(ar.addr[11:0]) + (14'(ar_beats) << Size);
  assign aw_end   = 14'(aw.addr[11:0]) + (14'(Beats) << Size);
  assign silent   = (rst_ni && !reset_q) ||
                    !(manager_i.read.ar_valid || manager_i.write.aw_valid || manager_i.write.w_valid);
  assign ar_stays = !ar_waits_q || !rst_ni || (manager_i.read.ar_valid && ar == ar_q);
  assign aw_stays = !aw_waits_q || !rst_ni || (manager_i.write.aw_valid && aw == aw_q);
  assign w_stays  = !w_waits_q || !rst_ni || (manager_i.write.w_valid && w == w_q);
  assign ar_whole = ar.size == Size && (12'(ar.addr[11:0]) & (12'(LineW / 8) - 12'd1)) == '0 &&
                    ar_end <= 14'd4096 && (ar_beats & (9'(Beats) - 9'd1)) == '0 && ar_beats <= 9'(8 * Beats);
  assign ar_half  = pipegs_pkg::Coded && (12'(ar.addr[11:0]) & (12'(LineW / 16) - 12'd1)) == '0 &&
                    ar.size == (Beats == 1 ? Size - 3'd1 : Size) && ar_beats == 9'(Beats == 1 ? 1 : Beats / 2);
  assign ar_legal = !manager_i.read.ar_valid || (ar.burst == 2'b01 && (ar_whole || ar_half));
  assign aw_legal = !manager_i.write.aw_valid ||
      (aw.burst == 2'b01 && aw.size == Size && (12'(aw.addr[11:0]) & (12'(LineW / 8) - 12'd1)) == '0 &&
       aw_end <= 14'd4096 && aw.len == 8'(Beats - 1) && aw.id == '0);
  logic [Grains-1:0] w_whole;  // strobes of half a line are alike
  for (genvar i = 0; i < Grains; i += 1) begin : gen_grain
    assign w_whole[i] = w.strb[i*GrainB +: GrainB] == {GrainB{w.strb[i*GrainB]}};
  end
  assign w_legal  = !manager_i.write.w_valid || (w_whole == {Grains{1'b1}} && w.last == (beat_q == 8'(Beats - 1)));
  assign w_behind = !manager_i.write.w_valid || addresses_q + WritesW'(manager_i.write.aw_valid) > lines_q;
  assign few      = reads_q + ReadsW'(manager_i.read.ar_valid) <= ReadsW'(Reads) &&
                    addresses_q + WritesW'(manager_i.write.aw_valid) <= WritesW'(Writes);
  assign manager_o = silent && (!rst_ni || (ar_stays && aw_stays && w_stays && ar_legal && aw_legal && w_legal &&
                                            w_behind && few));

  // --- rules of the subordinate --------------------------------------------------------------------------------------
  logic asked, r_stays, b_stays, r_legal, b_legal, r_last;

  assign asked   = (rst_ni && !reset_q) || !(subordinate_i.read.r_valid || subordinate_i.write.b_valid);
  assign r_stays = !r_waits_q || !rst_ni || (subordinate_i.read.r_valid && r == r_q);
  assign b_stays = !b_waits_q || !rst_ni || (subordinate_i.write.b_valid && b == b_q);
  assign r_legal = !subordinate_i.read.r_valid || (reads_of_r != '0 && r.resp != 2'b01);
  assign r_last  = !(subordinate_i.read.r_valid && tracked_q && r.id == tracked_id_q && tracked_ahead_q == '0) ||
                   r.last == (tracked_left_q == '0);
  assign b_legal = !subordinate_i.write.b_valid ||
                   (addresses_q != '0 && lines_q != '0 && b.id == '0 && b.resp != 2'b01);
  assign subordinate_o = asked && (!rst_ni || (r_stays && b_stays && r_legal && r_last && b_legal));

`ifndef SYNTHESIS
  logic began_q = 1'b0;  // some edge came in reset: registers hold what they shall
  always_ff @(posedge clk_i) if (!rst_ni) began_q <= 1'b1;
  always_ff @(posedge clk_i) if (began_q) begin
    assert (silent) else $error("axi_check: valid in reset");
    assert (asked) else $error("axi_check: an answer in reset");
  end
  always_ff @(posedge clk_i) if (rst_ni && began_q) begin
    assert (ar_stays) else $error("axi_check: AR fell or changed before it was taken");
    assert (aw_stays) else $error("axi_check: AW fell or changed before it was taken");
    assert (w_stays) else $error("axi_check: W fell or changed before it was taken");
    assert (ar_legal) else $error("axi_check: a burst on AR that is not legal");
    assert (aw_legal) else $error("axi_check: a burst on AW that is not legal");
    assert (w_legal) else $error("axi_check: strobes or WLAST are wrong");
    assert (w_behind) else $error("axi_check: data before its address");
    assert (few) else $error("axi_check: too many bursts are unanswered");
    assert (r_stays && b_stays) else $error("axi_check: an answer fell or changed before it was taken");
    assert (r_legal) else $error("axi_check: R to nobody");
    assert (r_last) else $error("axi_check: RLAST is wrong");
    assert (b_legal) else $error("axi_check: B to nobody");
  end
`endif

endmodule
