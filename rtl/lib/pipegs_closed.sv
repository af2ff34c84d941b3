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
    logic [2:0]          square;  // of one, and which
    pipegs_pkg::closed_t first;   // of both eyes, or of the first one
    assign square = place_i[pipegs_pkg::PlaceW-1 -: 3];
    always_comb begin
      case (square)
        3'd4: first = open_i.part_0;
        3'd5: first = open_i.part_1;
        3'd6: first = open_i.part_2;
        3'd7: first = open_i.part_3;
        default: first = open_i.whole;
      endcase
    end
    if (pipegs_pkg::Eyes > 1) begin : gen_eyes
      logic one, eye;
      assign {one, eye} = place_i[2*WindowW +: 2];
      always_comb begin
        case ({one, eye, square})
          5'b10000: walk = open_i.eye_0;
          5'b11000: walk = open_i.eye_1;
          5'b11100: walk = open_i.part_4;
          5'b11101: walk = open_i.part_5;
          5'b11110: walk = open_i.part_6;
          5'b11111: walk = open_i.part_7;
          default: walk = first;
        endcase
      end
    end else begin : gen_one_eye
      assign walk = first;
    end
  end else begin : gen_whole
    assign walk = open_i.whole;
    logic unused_parts;
    assign unused_parts = ^open_i;
  end

endmodule
