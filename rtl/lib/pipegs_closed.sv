// SPDX-License-Identifier: Apache-2.0
// pipegs_closed: how much of a walk's rectangle is known to be closed, from each side.
//
// Idea    What pipegs_open says holds for one window; of any other one nothing is known, and 0 is said.
// Stream  open_i; a window and walk -> columns and rows. Combinational.
// Model   closed_at in cpp_model/open.hpp

module pipegs_closed (
  input  pipegs_pkg::open_t             open_i,
  input  logic [pipegs_pkg::PlaceW-1:0] place_i,
  output pipegs_pkg::closed_t           closed_o
);

  localparam int unsigned WindowW = pipegs_pkg::WindowW;

  logic                here;
  pipegs_pkg::closed_t walk;

  assign here     = open_i.known && {open_i.window_y, open_i.window_x} == place_i[2*WindowW-1:0];
  assign closed_o = here ? walk : '0;

  if (pipegs_pkg::HasWalks) begin : gen_walks
    always_comb begin
      case (place_i[pipegs_pkg::PlaceW-1:2*WindowW])
        3'd4: walk = open_i.part_0;
        3'd5: walk = open_i.part_1;
        3'd6: walk = open_i.part_2;
        3'd7: walk = open_i.part_3;
        default: walk = open_i.whole;
      endcase
    end
  end else begin : gen_whole
    assign walk = open_i.whole;
    logic unused_parts;
    assign unused_parts = ^open_i;
  end

endmodule
