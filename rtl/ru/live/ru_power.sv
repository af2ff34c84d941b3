// SPDX-License-Identifier: Apache-2.0
// ru_power: the powers of all 64 pixels of a region, and what of it goes to the lanes: halves with a quad that lives.
//
// Paper   Eq. 3, steps 2 and 3 of Fig. 5a, unrolled: adders only, so all pixels are computed, and only those that a
//         Gaussian changes go on to the exponential and the blending.
// Idea    A quad is 2x2 pixels; group g of the lanes owns column (g + 2 row) mod 4 of each row of quads. A quad lives
//         where a pixel of it is visible (power >= -PowerCut) and not all four have stopped. A half is two rows of
//         quads: two of each group.
//           starts of the eight rows | 64 powers, clamped | the live halves leave, one in a cycle
// Stream  region_t in; out: for each group whether it has live quads in the half, which of the two, and their
//         exponents, first quad lowest, pixels row by row; those of a dead quad are of an earlier region. All groups
//         with live quads take it in one cycle.
// Pace    One region per cycle, or per live half; latency 2.
// Model   cpp_model/ru/ru_quads.hpp

module ru_power #(
  localparam int unsigned Groups    = pipegs_pkg::RuGroups,
  localparam int unsigned Slots     = pipegs_pkg::Regions / pipegs_pkg::Units,
  localparam int unsigned ColorsW   = pipegs_pkg::RuColorsW,
  localparam int unsigned ExponentW = pipegs_pkg::ExponentBits,
  localparam int unsigned PairW     = 8 * ExponentW  // of two quads
) (
  input  logic                             clk_i,
  input  logic                             rst_ni,
  input  logic [Slots*16-1:0]              stopped_i,  // quads whose pixels have all stopped: [group, slot, row]

  input  logic                             region_valid_i,
  output logic                             region_ready_o,
  input  pipegs_pkg::region_t              region_i,
  input  logic [ColorsW-1:0]               color_i,

  output logic [Groups-1:0]                out_push_o,   // into the groups' queues, all of a half at once, ...
  input  logic [Groups-1:0]                out_room_i,   // ... which have room
  output logic [Groups*2-1:0]              out_live_o,   // of each group's two quads
  output logic [Groups*PairW-1:0]          out_o,
  output logic                             out_half_o,
  output logic [pipegs_pkg::RegionW-1:0]   out_region_o,
  output logic [ColorsW-1:0]               out_color_o,
  output logic [pipegs_pkg::ShownIndexW-1:0] out_index_o,

  output logic                             busy_o
);

  localparam int unsigned PowerW    = pipegs_pkg::PowerW;
  localparam int unsigned GradientW = pipegs_pkg::GradientW;
  localparam int unsigned CurveW    = pipegs_pkg::CurveW;
  localparam int unsigned RegionW   = pipegs_pkg::RegionW;
  localparam int unsigned ShownIndexW = pipegs_pkg::ShownIndexW;
  localparam int unsigned BendW     = CurveW + 6;  // x (x - 1) curve, x (x - 1) at most 42

  typedef struct packed {
    logic [ShownIndexW-1:0] index;
    logic [RegionW-1:0]   region;
    logic [ColorsW-1:0]   color;
  } tag_t;
  logic       rows_valid_q, rows_move, pixels_move;
  tag_t       rows_tag_q, tag_q;
  logic [1:0] halves_q;  // live ones that have not left
  logic       fire;

  assign pixels_move    = halves_q == '0 || (fire && (halves_q == 2'b01 || halves_q == 2'b10));
  assign rows_move      = !rows_valid_q || pixels_move;
  assign region_ready_o = rows_move;
  assign busy_o         = rows_valid_q || halves_q != '0;

  // --- starts of the rows; what the columns add ----------------------------------------------------------------------
  typedef struct packed {
    logic [7:0][PowerW-1:0]    power;
    logic [7:0][GradientW-1:0] slope;
    logic [5:0][BendW-1:0]     bend;  // from column 2 on
  } rows_t;
  rows_t rows_q;
  logic signed [CurveW-1:0] curve_x;
  assign curve_x = region_i.curve_x;
  for (genvar i = 0; i < 8; i += 1) begin : gen_row
    logic signed [PowerW-1:0]    power;
    logic signed [GradientW-1:0] slope;
    pu_row_init #(.Dy(i)) u_init (
      .power_i(region_i.power),
      .slope_x_i(region_i.slope_x),
      .slope_y_i(region_i.slope_y),
      .curve_x_i(region_i.curve_x),
      .curve_y_i(region_i.curve_y),
      .twist_i(region_i.twist),
      .power_o(power),
      .slope_o(slope)
    );
    always_ff @(posedge clk_i) begin
      if (region_valid_i && rows_move) begin
        rows_q.power[i] <= power;
        rows_q.slope[i] <= slope;
      end
    end
  end
  // x (x - 1) curve of columns 2 to 7; it is 0 in columns 0 and 1.
  for (genvar x = 2; x < 8; x += 1) begin : gen_bend
    always_ff @(posedge clk_i) begin
      if (region_valid_i && rows_move) rows_q.bend[x-2] <= BendW'(curve_x) * BendW'(x * (x - 1));
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) rows_valid_q <= 1'b0;
    else if (rows_move) rows_valid_q <= region_valid_i;
  end
  always_ff @(posedge clk_i) begin
    if (region_valid_i && rows_move) rows_tag_q <= {region_i.index, region_i.region, color_i};
  end

  // --- the pixels: P(x) = P(0) + x slope + x (x - 1) curve -----------------------------------------------------------
  typedef struct packed {logic [63:0][ExponentW-1:0] of;} exponents_t;  // of each pixel, row by row
  exponents_t              exponents, exponents_q;
  logic [63:0]             visible;
  logic [15:0]             live, live_q, stopped;  // quads, row by row
  logic [RegionW-1:0]      slot;
  for (genvar i = 0; i < 64; i += 1) begin : gen_pixel
    localparam int unsigned Row = i / 8, Column = i % 8;
    logic signed [PowerW-1:0]    power, start;
    logic signed [GradientW-1:0] slope;
    logic signed [BendW-1:0]     bend;
    assign start = rows_q.power[Row];
    assign slope = rows_q.slope[Row];
    if (Column < 2) begin : gen_straight
      assign bend = '0;
    end else begin : gen_bent
      assign bend = rows_q.bend[Column-2];
    end
    assign power = start + PowerW'(slope) * PowerW'(Column) + PowerW'(bend);
    pu_clamp u_clamp (
      .power_i(power),
      .exponent_o(exponents.of[i])
    );
    assign visible[i] = exponents.of[i][ExponentW-1:ExponentW-1];  // the highest field
  end
  typedef struct packed {logic [Groups*Slots-1:0][3:0] of;} slots_t;  // rows of each group's slots
  slots_t slots;
  assign slots = stopped_i;
  ru_slot u_slot (
    .region_i(rows_tag_q.region),
    .slot_o(slot)
  );
  for (genvar g = 0; g < 4; g += 1) begin : gen_stopped
    logic [3:0] rows;  // of the group, in the region
    assign rows = slots.of[Slots*g + 32'(slot)];
    for (genvar r = 0; r < 4; r += 1) begin : gen_row
      assign stopped[4*r+(g+2*r)%4] = rows[r];
    end
  end
  for (genvar i = 0; i < 16; i += 1) begin : gen_quad
    localparam int unsigned First = 16 * (i / 4) + 2 * (i % 4);
    assign live[i] = (visible[First] || visible[First+1] || visible[First+8] || visible[First+9]) && !stopped[i];
    always_ff @(posedge clk_i) begin  // what lies behind a dead quad stands still
      if (rows_valid_q && pixels_move && live[i]) begin
        exponents_q.of[First]   <= exponents.of[First];
        exponents_q.of[First+1] <= exponents.of[First+1];
        exponents_q.of[First+8] <= exponents.of[First+8];
        exponents_q.of[First+9] <= exponents.of[First+9];
      end
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) halves_q <= '0;
    else if (pixels_move) halves_q <= rows_valid_q ? {live[15:8] != '0, live[7:0] != '0} : '0;
    else if (fire) halves_q <= 2'b10;  // the second half is left
  end
  always_ff @(posedge clk_i) begin
    if (rows_valid_q && pixels_move) begin
      live_q <= live;
      tag_q  <= rows_tag_q;
    end
  end

  // --- the half that leaves ------------------------------------------------------------------------------------------
  typedef struct packed {logic [8*Groups-1:0][ExponentW-1:0] of;} half_t;  // of each group's two quads
  half_t             leaving;
  logic              half;
  logic [Groups-1:0] some;
  assign half        = !halves_q[0];
  assign fire        = halves_q != '0 && (some & ~out_room_i) == '0;
  assign out_push_o  = fire ? some : '0;
  assign out_half_o  = half;
  assign out_o       = leaving;
  assign {out_index_o, out_region_o, out_color_o} = tag_q;
  for (genvar g = 0; g < Groups; g += 1) begin : gen_group
    for (genvar j = 0; j < 2; j += 1) begin : gen_side  // the row of quads in the half
      localparam int unsigned Column = (g + 2 * j) % 4;
      assign out_live_o[2*g+j] = half ? live_q[4*(2+j)+Column] : live_q[4*j+Column];
      for (genvar p = 0; p < 4; p += 1) begin : gen_lane
        localparam int unsigned Pixel = 16 * j + 2 * Column + 8 * (p / 2) + p % 2;  // of the first half
        assign leaving.of[8*g+4*j+p] = half ? exponents_q.of[32+Pixel] : exponents_q.of[Pixel];
      end
    end
    assign some[g] = out_live_o[2*g] || out_live_o[2*g+1];
  end

  wire unused_region = &{1'b0, region_i};  // where alphas lie

endmodule
