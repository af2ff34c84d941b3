// SPDX-License-Identifier: Apache-2.0
// su_minmax: the smallest and the largest key of a run that is loaded into the pool.
//
// Paper   Sec. 4.2.2, "MinMax Finder".
// Idea    min = key < min ? key : min;  max = key > max ? key : max;  while the keys stream past into their store.
// Stream  valid_i shows one key; clear_i forgets all of them. min_o and max_o hold from the next cycle on; before the
//         first key they mean nothing.
// Pace    One key per cycle; a key in the cycle of clear_i is not seen.
// Model   cpp_model/su/sort/su_minmax.hpp

module su_minmax (
  input  logic                        clk_i,
  input  logic                        rst_ni,

  input  logic                        clear_i,
  input  logic                        valid_i,
  input  logic [pipegs_pkg::KeyW-1:0] key_i,

  output logic [pipegs_pkg::KeyW-1:0] min_o,
  output logic [pipegs_pkg::KeyW-1:0] max_o
);

  logic                        empty_q;
  logic [pipegs_pkg::KeyW-1:0] min_q, max_q;

  assign min_o = min_q;
  assign max_o = max_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) empty_q <= 1'b1;
    else if (clear_i) empty_q <= 1'b1;
    else if (valid_i) empty_q <= 1'b0;
  end

  always_ff @(posedge clk_i) begin
    if (valid_i && (empty_q || key_i < min_q)) min_q <= key_i;
    if (valid_i && (empty_q || key_i > max_q)) max_q <= key_i;
  end

endmodule
