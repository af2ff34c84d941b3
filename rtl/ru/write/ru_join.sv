// SPDX-License-Identifier: Apache-2.0
// ru_join: two RUs whose regions share lines of a picture in raster order write them together.
//
// Paper   None: it says nothing of how pixels leave.
// Idea    Two regions side by side belong to an RU of even number and the next one, and their rows are the two halves
//         of the same lines. Both RUs of the pair bring rows in the same order, so each row waits for the other one,
//         and a line goes whole through the port of the even RU. By windows every RU writes its own lines.
// Stream  in: the requests of this RU; pair: those of the other one. out: requests to this RU's port. Combinational.
// Pace    A request per cycle.
// Model   ru_write in cpp_model/ru/ru.hpp

module ru_join #(
  localparam int unsigned MemoryW = pipegs_pkg::MemoryW,
  localparam int unsigned HalvesW = pipegs_pkg::HalvesW,
  localparam int unsigned HalfW   = MemoryW / 2
) (
  input  logic               joined_i,      // in raster order, and there is another RU
  input  logic               odd_i,         // of the pair this is the second one
  input  logic               wide_i,        // the right one of the two regions lies in the picture, too

  input  logic               in_valid_i,
  output logic               in_ready_o,
  input  logic [HalvesW-1:0] in_halves_i,   // of a joined line: this RU's half
  input  logic [MemoryW-1:0] in_data_i,     // in raster order a row, twice

  output logic               pair_valid_o,  // to the other RU: a row waits
  output logic               pair_taken_o,  // it leaves with that of the other one; from the even RU
  output logic [HalfW-1:0]   pair_row_o,
  input  logic               pair_valid_i,
  input  logic               pair_taken_i,
  input  logic [HalfW-1:0]   pair_row_i,

  output logic               out_valid_o,
  input  logic               out_ready_i,
  output logic [HalvesW-1:0] out_halves_o,
  output logic [MemoryW-1:0] out_data_o
);

  logic [HalfW-1:0] row;
  assign row          = in_data_i[HalfW-1:0];
  assign pair_valid_o = in_valid_i;
  assign pair_row_o   = row;
  assign pair_taken_o = joined_i && !odd_i && in_valid_i && pair_valid_i && out_ready_i;

  always_comb begin
    if (!joined_i) begin
      out_valid_o  = in_valid_i;
      in_ready_o   = out_ready_i;
      out_halves_o = in_halves_i;
      out_data_o   = in_data_i;
    end else begin
      out_valid_o  = in_valid_i && pair_valid_i && !odd_i;
      in_ready_o   = odd_i ? pair_taken_i : pair_taken_o;
      out_halves_o = {wide_i, 1'b1};
      out_data_o   = in_halves_i[0] ? {pair_row_i, row} : {row, pair_row_i};
    end
  end

endmodule
