// SPDX-License-Identifier: Apache-2.0
// ru_slot: where a region lies among the regions that its RU owns.
//
// Idea    Of Units regions in a row (in the order of their numbers) each RU owns one.
// Stream  region_i -> slot_o, 0 .. Regions/Units-1. Combinational.
// Model   ru_slot in cpp_model/ru/ru_walk.hpp

module ru_slot (
  input  logic [pipegs_pkg::RegionW-1:0] region_i,
  output logic [pipegs_pkg::RegionW-1:0] slot_o
);

  assign slot_o = region_i >> $clog2(pipegs_pkg::Units);

endmodule
