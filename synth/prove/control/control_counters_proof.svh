// SPDX-License-Identifier: Apache-2.0
// The end of rtl/control/pipegs_control_counters.sv in its proof: both words of a counter are of one moment.
//
// Rule    The low word of any counter of the table is its own; the high word is that which the counter had when its low
//         word was read, if no other low word was read since. What is not hit, or not there, reads 0, and so does all
//         that is read while apart_i is up.

(* anyconst *) logic [$clog2(Counters+1)-1:0] number;  // any counter
logic [WordW-1:0] low_word;
logic [PerfW-1:0] its_count;
logic [HighW-1:0] kept_q;
logic             paired_q;

always_comb begin
  low_word  = '0;
  its_count = '0;
  for (int unsigned i = 0; i < Counters; i += 1) begin
    if (32'(number) == i) begin
      low_word  = pipegs_pkg::ControlCounterTable[16*i+2 +: WordW];
      its_count = apart_i ? '0 : counters_i[i*PerfW +: PerfW];
    end
  end
end

proof_reset u_proof_reset (.clk_i, .rst_ni);
always_ff @(posedge clk_i or negedge rst_ni) begin
  if (!rst_ni) paired_q <= 1'b0;
  else if (read_i && read_word_i == low_word) paired_q <= 1'b1;
  else if (read_i && read_hit_o && !read_word_i[0]) paired_q <= 1'b0;
end
always_ff @(posedge clk_i) if (read_i && read_word_i == low_word) kept_q <= its_count[PerfW-1:32];

always_comb begin
  assume (32'(number) < Counters);
  if (rst_ni) begin
    assert (read_word_i != low_word || (read_hit_o && read_data_o == its_count[31:0]));
    assert (!paired_q || high_q == kept_q);
    assert (!paired_q || read_word_i != (low_word | 1'b1) || (read_hit_o && read_data_o == 32'(kept_q)));
    assert (read_hit_o || read_data_o == '0);
  end
end
