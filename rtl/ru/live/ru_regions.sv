// SPDX-License-Identifier: Apache-2.0
// ru_regions: moves a splat's coefficients to the first pixel of each open region that this RU owns, one in a cycle.
//
// Paper   Eq. 3, step 1 of Fig. 5a, in the shared form: A to F once per Gaussian, here only shifted by (8 rx, 8 ry).
// Idea    pu_region's arithmetic as a pipeline, because lanes that blend only what lives are through with most regions
//         in one or two cycles.
//           select the lowest open region | times rx, ry | sums, squares | last sum, rounding
//         All steps move together. A region that still holds pixels of the window before waits; the others of its
//         splat go on.
// Stream  sorted_t in; region_t out, splat by splat. A splat without an open region vanishes. An end waits at end_o
//         until all before it has left and end_ready_i takes it.
// Pace    One region per cycle; the first one five cycles after its splat was taken.
// Model   cpp_model/pu/rows/pu_region.hpp, ru_own_mask in cpp_model/ru/ru_walk.hpp

module ru_regions #(
  localparam int unsigned Regions = pipegs_pkg::Regions,
  localparam int unsigned ColorsW = pipegs_pkg::RuColorsW,
  localparam int unsigned RangeW  = pipegs_pkg::ExpW
) (
  input  logic                         clk_i,
  input  logic                         rst_ni,
  input  logic [Regions-1:0]           open_i,        // regions that this RU owns and that are not done
  input  logic                         hold_i,        // they are not known in this cycle
  input  logic [Regions-1:0]           held_i,        // regions that wait
  output logic [Regions-1:0]           wants_o,       // regions that the present splat has left, of any RU
  input  logic [RangeW-1:0]            range_i,       // of depths, for AOVs: 2^(range + 1) world units

  input  logic                         in_valid_i,
  output logic                         in_ready_o,
  input  pipegs_pkg::sorted_t          in_i,

  output logic                         region_valid_o,
  input  logic                         region_ready_i,
  output pipegs_pkg::region_t          region_o,
  output logic [ColorsW-1:0]           color_o,       // {depth, blue, green, red}

  output logic                         end_valid_o,
  output logic [pipegs_pkg::KindW-1:0] end_kind_o,
  input  logic                         end_ready_i,

  output logic                         busy_o         // a splat, an end or a region is inside
);

  localparam int unsigned RegionW   = pipegs_pkg::RegionW;
  localparam int unsigned MaskW     = pipegs_pkg::MaskW;
  localparam int unsigned IndexW    = pipegs_pkg::MaskIndexW;
  localparam int unsigned HalfW     = IndexW / 2;       // bits of a column or row of regions in the part
  localparam int unsigned TagW      = pipegs_pkg::ShownIndexW + RegionW + ColorsW;
  localparam int unsigned AW        = pipegs_pkg::AW;
  localparam int unsigned BcW       = pipegs_pkg::BcW;
  localparam int unsigned DefW      = pipegs_pkg::DefW;
  localparam int unsigned AxisW     = 4;                // rx, ry: u3 with a sign bit
  localparam int unsigned LinearW   = BcW + AxisW;      // B rx + C ry
  localparam int unsigned CurvedW   = DefW + AxisW;     // D rx + F ry
  localparam int unsigned SquareW   = CurvedW + AxisW;  // (D rx + F ry) rx + E ry ry
  localparam int unsigned Shift     = pipegs_pkg::CoeffF - pipegs_pkg::PowerF;
  localparam int unsigned PowerW    = pipegs_pkg::PowerW;
  localparam int unsigned GradientW = pipegs_pkg::GradientW;
  localparam int unsigned CurveW    = pipegs_pkg::CurveW;
  localparam int unsigned ExactW    = PowerW + Shift;     // s20.CoeffF
  localparam int unsigned SteepW    = GradientW + Shift;  // s13.CoeffF
  localparam int unsigned BendW     = CurveW + Shift;     // s4.CoeffF
  localparam logic signed [ExactW-1:0] Half = Shift == 0 ? '0 : ExactW'(1) << (Shift == 0 ? 0 : Shift - 1);

  logic move, valid_1_q, valid_2_q, valid_3_q, valid_4_q;
  assign move = !valid_4_q || region_ready_i;

  // --- the splat, and its next region --------------------------------------------------------------------------------
  logic                splat_valid_q, data, last, pick, leave;
  pipegs_pkg::sorted_t splat_q;
  logic [MaskW-1:0]    left_q, open, free, lowest;  // regions of the splat that were not picked yet
  typedef struct packed {logic [pipegs_pkg::Parts-1:0][MaskW-1:0] of;} masks_t;  // of each part
  masks_t              open_in, held_in, wants;
  logic [MaskW-1:0]    part_open, part_held;
  assign open_in = open_i;
  assign held_in = held_i;
  assign wants_o = wants;
  logic [IndexW-1:0]   index;
  logic [RegionW-1:0]  region;

  pipegs_first_set #(.DataW(MaskW)) u_lowest (
    .mask_i(free),
    .one_hot_o(lowest),
    .number_o(index)
  );
  if (pipegs_pkg::Parts > 1) begin : gen_part
    assign region    = {splat_q.part, index};
    assign part_open = open_in.of[splat_q.part];
    assign part_held = held_in.of[splat_q.part];
    for (genvar p = 0; p < pipegs_pkg::Parts; p += 1) begin : gen_wants
      assign wants.of[p] = splat_valid_q && data && splat_q.part == p ? left_q : '0;
    end
  end else begin : gen_whole
    assign region    = index;
    assign part_open = open_in;
    assign part_held = held_in;
    assign wants     = splat_valid_q && data ? left_q : '0;
  end
  assign data        = splat_q.kind == pipegs_pkg::KindData;
  assign open        = left_q & part_open;
  assign free        = open & ~part_held;
  assign last        = (open & ~lowest) == '0;
  assign pick        = splat_valid_q && data && free != '0 && move && !hold_i;
  assign leave       = data ? !hold_i && last && (move || open == '0) : end_valid_o && end_ready_i;
  assign in_ready_o  = !splat_valid_q || leave;
  assign end_valid_o = splat_valid_q && !data && !valid_1_q && !valid_2_q && !valid_3_q && !valid_4_q;
  assign end_kind_o  = splat_q.kind;
  assign busy_o      = splat_valid_q || valid_1_q || valid_2_q || valid_3_q || valid_4_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) splat_valid_q <= 1'b0;
    else if (in_ready_o) splat_valid_q <= in_valid_i;
  end
  always_ff @(posedge clk_i) begin
    if (in_ready_o && in_valid_i) begin
      splat_q <= in_i;
      left_q  <= in_i.mask;
    end else if (pick) begin
      left_q <= left_q & ~lowest;
    end
  end

  // --- 1: which region of which splat --------------------------------------------------------------------------------
  logic signed [AW-1:0]   a_1_q;
  logic signed [BcW-1:0]  b_1_q, c_1_q;
  logic signed [DefW-1:0] d_1_q, e_1_q, f_1_q;
  logic [TagW-1:0]        tag_1_q, tag_2_q, tag_3_q, tag_4_q;  // {index, region, colour}
  logic [ColorsW-1:0]     color;
  assign color[3*pipegs_pkg::ColorW-1:0] = {splat_q.blue, splat_q.green, splat_q.red};
  if (pipegs_pkg::HasDepths) begin : gen_depth
    ru_linear u_linear (
      .depth_i(splat_q.depth),
      .range_i,
      .linear_o(color[ColorsW-1:3*pipegs_pkg::ColorW])
    );
  end else begin : gen_no_depth
    logic unused_range;
    assign unused_range = &{1'b0, range_i};
  end
  always_ff @(posedge clk_i) begin
    if (pick) begin
      a_1_q   <= splat_q.a;
      b_1_q   <= splat_q.b;
      c_1_q   <= splat_q.c;
      d_1_q   <= splat_q.d;
      e_1_q   <= splat_q.e;
      f_1_q   <= splat_q.f;
      tag_1_q <= {splat_q.index, region, color};
    end
  end

  // --- 2: coefficients times rx, ry; the leading 0 makes them signed -------------------------------------------------
  logic signed [AxisW-1:0]   rx, ry, rx_2_q, ry_2_q;
  logic signed [LinearW-1:0] linear_2_q;
  logic signed [CurvedW-1:0] d_rx_2_q, f_ry_2_q, e_ry_2_q, f_rx_2_q;
  logic signed [AW-1:0]      a_2_q;
  logic signed [BcW-1:0]     b_2_q, c_2_q;
  logic signed [DefW-1:0]    d_2_q, e_2_q, f_2_q;
  assign rx = AxisW'(tag_1_q[ColorsW +: HalfW]);
  assign ry = AxisW'(tag_1_q[ColorsW+HalfW +: HalfW]);
  always_ff @(posedge clk_i) begin
    if (move && valid_1_q) begin
      tag_2_q    <= tag_1_q;
      rx_2_q     <= rx;
      ry_2_q     <= ry;
      linear_2_q <= LinearW'(b_1_q) * LinearW'(rx) + LinearW'(c_1_q) * LinearW'(ry);
      d_rx_2_q   <= CurvedW'(d_1_q) * CurvedW'(rx);
      f_ry_2_q   <= CurvedW'(f_1_q) * CurvedW'(ry);
      e_ry_2_q   <= CurvedW'(e_1_q) * CurvedW'(ry);
      f_rx_2_q   <= CurvedW'(f_1_q) * CurvedW'(rx);
      {a_2_q, b_2_q, c_2_q, d_2_q, e_2_q, f_2_q} <= {a_1_q, b_1_q, c_1_q, d_1_q, e_1_q, f_1_q};
    end
  end

  // --- 3: slopes and curves are ready, the squares -------------------------------------------------------------------
  logic signed [ExactW-1:0]    base_3_q;
  logic signed [SquareW-1:0]   square_3_q;
  logic signed [SteepW-1:0]    slope_x, slope_y;
  logic signed [BendW-1:0]     curve_x, curve_y, twist;
  logic signed [GradientW-1:0] slope_x_3_q, slope_y_3_q;
  logic signed [CurveW-1:0]    curve_x_3_q, curve_y_3_q, twist_3_q;
  assign slope_x = SteepW'(b_2_q) + (SteepW'(d_rx_2_q) <<< 4) + (SteepW'(f_ry_2_q) <<< 3) + SteepW'(Half);
  assign slope_y = SteepW'(c_2_q) + (SteepW'(e_ry_2_q) <<< 4) + (SteepW'(f_rx_2_q) <<< 3) + SteepW'(Half);
  assign curve_x = BendW'(d_2_q) + BendW'(Half);
  assign curve_y = BendW'(e_2_q) + BendW'(Half);
  assign twist   = BendW'(f_2_q) + BendW'(Half);
  always_ff @(posedge clk_i) begin
    if (move && valid_2_q) begin
      tag_3_q     <= tag_2_q;
      base_3_q    <= ExactW'(a_2_q) + (ExactW'(linear_2_q) <<< 3) + Half;
      square_3_q  <= (SquareW'(d_rx_2_q) + SquareW'(f_ry_2_q)) * SquareW'(rx_2_q) +
                     SquareW'(e_ry_2_q) * SquareW'(ry_2_q);
      slope_x_3_q <= GradientW'(slope_x >>> Shift);
      slope_y_3_q <= GradientW'(slope_y >>> Shift);
      curve_x_3_q <= CurveW'(curve_x >>> Shift);
      curve_y_3_q <= CurveW'(curve_y >>> Shift);
      twist_3_q   <= CurveW'(twist >>> Shift);
    end
  end

  // --- 4: the region -------------------------------------------------------------------------------------------------
  logic signed [ExactW-1:0]    power;
  logic signed [PowerW-1:0]    power_4_q;
  logic signed [GradientW-1:0] slope_x_4_q, slope_y_4_q;
  logic signed [CurveW-1:0]    curve_x_4_q, curve_y_4_q, twist_4_q;
  assign power = base_3_q + (ExactW'(square_3_q) <<< 6);
  always_ff @(posedge clk_i) begin
    if (move && valid_3_q) begin
      tag_4_q     <= tag_3_q;
      power_4_q   <= PowerW'(power >>> Shift);
      slope_x_4_q <= slope_x_3_q;
      slope_y_4_q <= slope_y_3_q;
      curve_x_4_q <= curve_x_3_q;
      curve_y_4_q <= curve_y_3_q;
      twist_4_q   <= twist_3_q;
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      valid_1_q <= 1'b0;
      valid_2_q <= 1'b0;
      valid_3_q <= 1'b0;
      valid_4_q <= 1'b0;
    end else if (move) begin
      valid_1_q <= pick;
      valid_2_q <= valid_1_q;
      valid_3_q <= valid_2_q;
      valid_4_q <= valid_3_q;
    end
  end

  assign region_valid_o = valid_4_q;
  assign color_o        = tag_4_q[ColorsW-1:0];
  always_comb begin
    region_o         = '0;
    region_o.kind    = pipegs_pkg::KindData;
    region_o.power   = power_4_q;
    region_o.slope_x = slope_x_4_q;
    region_o.slope_y = slope_y_4_q;
    region_o.curve_x = curve_x_4_q;
    region_o.curve_y = curve_y_4_q;
    region_o.twist   = twist_4_q;
    {region_o.index, region_o.region} = tag_4_q[TagW-1:ColorsW];
  end

  logic unused_in;
  assign unused_in = &{1'b0, splat_q};

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits(end_kind_o))) u_check_end (
    .clk_i,
    .rst_ni,
    .valid_i(end_valid_o),
    .ready_i(end_ready_i),
    .beat_i(end_kind_o)
  );
  pipegs_stream_check #(.DataW($bits({region_o, color_o}))) u_check_region (
    .clk_i,
    .rst_ni,
    .valid_i(region_valid_o),
    .ready_i(region_ready_i),
    .beat_i({region_o, color_o})
  );
`endif

endmodule
