// SPDX-License-Identifier: Apache-2.0
// pipegs_open: the rectangle around the regions of a window that the RUs have not closed, told by what lies beside it.
//
// Paper   Sec. 4.2.3 stops work in opaque regions; here it is not begun either (Occlusion).
// Idea    A column or row of regions that are all closed needs nothing more. Of the whole window, and of each part
//         and each eye alone, the closed ones are counted from each side to the first with an open region. Nothing is
//         known while
//         the RUs are in different windows; where no region is open at all, 0 is said: the walk ends by itself then.
//         Within a window the RUs only close regions, so the rectangle only shrinks, and an old one holds the new one.
// Stream  progress_i of each cycle -> open_o in the next one.
// Pace    Combinational, and one register.
// Model   cpp_model/open.hpp

module pipegs_open (
  input  logic                  clk_i,
  input  logic                  rst_ni,

  input  pipegs_pkg::progress_t progress_i,
  output pipegs_pkg::open_t     open_o
);

  localparam int unsigned Units   = pipegs_pkg::Units;
  localparam int unsigned Regions = pipegs_pkg::Regions;
  localparam int unsigned MaskW   = pipegs_pkg::MaskW;
  localparam int unsigned Parts   = pipegs_pkg::Parts;
  localparam int unsigned Squares = pipegs_pkg::Squares;
  localparam int unsigned Eyes    = pipegs_pkg::Eyes;
  localparam int unsigned PartsX  = pipegs_pkg::PartsX;
  localparam int unsigned PartX   = pipegs_pkg::PartRegionsX;
  localparam int unsigned SideX   = PartsX * PartX;  // regions along the window's side
  localparam int unsigned ClosedW = pipegs_pkg::ClosedW;
  localparam int unsigned Bits    = pipegs_pkg::ClosedBits;

  // --- open regions -------------------------------------------------------------------------------------------------
  logic [Units-1:0]   here;  // in the window of the first one
  logic [Regions-1:0] open;
  logic [Regions-1:0] closed_unit [Units];
  for (genvar j = 0; j < Units; j += 1) begin : gen_unit
    logic [MaskW-1:0] own;  // of each part
    ru_own u_own (
      .unit_i(pipegs_pkg::UnitW'(j)),
      .own_o(own)
    );
    assign here[j]        = progress_i.x[j] == progress_i.x[0] && progress_i.y[j] == progress_i.y[0];
    assign closed_unit[j] = progress_i.done[j] & {Parts{own}};
  end
  always_comb begin
    open = '1;
    for (int unsigned j = 0; j < Units; j += 1) open &= ~closed_unit[j];
  end

  // --- columns and rows that hold one -------------------------------------------------------------------------------
  logic [Parts*PartX-1:0] columns, rows;  // of each part
  logic [SideX-1:0]       all_columns, all_rows;
  logic [Eyes*SideX-1:0]  eye_columns, eye_rows;
  always_comb begin
    columns     = '0;
    rows        = '0;
    all_columns = '0;
    all_rows    = '0;
    eye_columns = '0;
    eye_rows    = '0;
    for (int unsigned p = 0; p < Parts; p += 1) begin
      for (int unsigned r = 0; r < MaskW; r += 1) begin
        if (open[p*MaskW+r]) begin
          columns[p*PartX + r%PartX]                   = 1'b1;
          rows[p*PartX + r/PartX]                      = 1'b1;
          all_columns[(p%PartsX)*PartX + r%PartX]      = 1'b1;
          all_rows[(p%Squares/PartsX)*PartX + r/PartX] = 1'b1;
          eye_columns[p/Squares*SideX + (p%PartsX)*PartX + r%PartX]   = 1'b1;
          eye_rows[p/Squares*SideX + (p%Squares/PartsX)*PartX + r/PartX] = 1'b1;
        end
      end
    end
  end

  // --- counted from either side -------------------------------------------------------------------------------------
  function automatic logic [ClosedW-1:0] from_low(input logic [SideX-1:0] some);
    from_low = '0;
    for (int unsigned i = SideX; i > 0; i -= 1) if (some[i-1]) from_low = ClosedW'(i - 1);
  endfunction
  function automatic logic [ClosedW-1:0] from_high(input logic [SideX-1:0] some, input int unsigned side);
    from_high = '0;
    for (int unsigned i = 0; i < SideX; i += 1) if (some[i]) from_high = ClosedW'(side - 1 - i);
  endfunction
  // A closed_t.
  function automatic logic [Bits-1:0] closed_of(input logic [SideX-1:0] x, input logic [SideX-1:0] y,
                                                input int unsigned side);
    closed_of = {from_high(y, side), from_low(y), from_high(x, side), from_low(x)};
  endfunction

  pipegs_pkg::open_t open_d, open_q;
  logic [Bits-1:0]   part [4*Eyes];
  for (genvar p = 0; p < 4 * Eyes; p += 1) begin : gen_part
    if (pipegs_pkg::HasWalks) begin : gen_walk
      assign part[p] = closed_of(SideX'(columns[p*PartX +: PartX]), SideX'(rows[p*PartX +: PartX]), PartX);
    end else begin : gen_none
      assign part[p] = '0;
      logic unused_lines;
      assign unused_lines = ^{columns, rows};
    end
  end
  localparam int unsigned CommonW = 1 + 2 * pipegs_pkg::WindowW + 5 * Bits;
  logic [CommonW-1:0] common;  // the fields that an open_t always has
  assign common = {part[3], part[2], part[1], part[0], closed_of(all_columns, all_rows, SideX),
                   progress_i.y[0], progress_i.x[0], here == '1};
  if (pipegs_pkg::WalkEyeW != 0) begin : gen_eyes
    logic [Bits-1:0] eye [2];
    for (genvar e = 0; e < 2; e += 1) begin : gen_eye
      assign eye[e] = closed_of(eye_columns[e*SideX +: SideX], eye_rows[e*SideX +: SideX], SideX);
    end
    assign open_d = {part[7], part[6], part[5], part[4], eye[1], eye[0], common};
  end else begin : gen_one_eye
    assign open_d = common;
    logic unused_eyes;
    assign unused_eyes = ^{eye_columns, eye_rows};
  end
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) open_q <= '0;
    else open_q <= open_d;
  end
  assign open_o = open_q;

endmodule
