// SPDX-License-Identifier: Apache-2.0
// pu_cull: moves a Gaussian into view space and drops it when it is behind the near plane or cannot reach the window.
//
// Paper   Sec. 4.2, frustum culling of the preprocessing.
// Idea    view = origin + W offset; keep iff z > near (unless NearTest is 0) and fx x - a z + reach s >= 0 and the same
//         on the three other sides. x, z, s are cut to 17 bits with a common exponent, always to the side that keeps
//         (see the model). Two sides make an axis (pu_cull_axis). Stages, behind a register of what comes:
//           1 nine products   2 sums       3 shift to view units   4 view   5 edges; near plane; common exponent
//           6 cut             7 six products                       8 four signs -> output
//         With Occlusion the four sides are those of the rectangle around the open regions (pipegs_open), as known in
//         stage 5: regions beside it times z are taken off in stages 7 and 8. The first of two eyes sees all of it half
//         the distance between them further to the right, the second one to the left: stage 4 adds that.
// Stream  fetched in, visible out: only those that survive, and every end beat, all its other fields zero. Beside it
//         what pu_reach needs (TightCull), else zero.
// Pace    One per cycle, latency 9; the pipeline stands still while the output is not taken. A stage's registers are
//         clocked for a record only, the output's for one that survives.
// Model   cpp_model/pu/front/pu_cull.hpp

module pu_cull #(
  localparam int unsigned HalfW = pipegs_pkg::Eyes > 1 ? pipegs_pkg::HalfEyeW : 1
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,

  input  pipegs_pkg::rotation_t rotation_i,
  input  pipegs_pkg::lens_t     lens_i,
  input  pipegs_pkg::windows_t  windows_i,
  input  pipegs_pkg::open_t     open_i,
  input  logic signed [HalfW-1:0] half_x_i,  // of the distance between the eyes, world units; 0 where there is one
  input  logic signed [HalfW-1:0] half_y_i,

  input  logic                  fetched_valid_i,
  output logic                  fetched_ready_o,
  input  pipegs_pkg::fetched_t  fetched_i,
  input  logic                  eye_i,

  output logic                  visible_valid_o,
  input  logic                  visible_ready_i,
  output pipegs_pkg::visible_t  visible_o,
  output pipegs_pkg::gap_t      gap_o,

  output logic                  busy_o
);

  localparam int unsigned KindW   = pipegs_pkg::KindW;
  localparam int unsigned ViewW   = pipegs_pkg::ViewW;
  localparam int unsigned PosW    = pipegs_pkg::PosW;
  localparam int unsigned RotW    = pipegs_pkg::RotW;
  localparam int unsigned RotF    = pipegs_pkg::RotF;
  localparam int unsigned ExpW    = pipegs_pkg::ExpW;
  localparam int unsigned QuatW   = pipegs_pkg::QuatW;
  localparam int unsigned ScaleW  = pipegs_pkg::ScaleW;
  localparam int unsigned ScaleMW = pipegs_pkg::ScaleMW;
  localparam int unsigned WorldW  = pipegs_pkg::WorldW;
  localparam int unsigned WindowW = pipegs_pkg::WindowW;
  localparam int unsigned PlaceW  = pipegs_pkg::PlaceW;
  localparam int unsigned Stages  = 7;  // before the output register

  // --- handshake: all stages advance together ----------------------------------------------------------------------
  logic [Stages:0] valid_q;  // 0: the record as it came, out of a memory
  logic [Stages:0] load;     // register n takes a record
  logic            out_valid_q, advance, keep, load_out;
  assign advance         = !out_valid_q || visible_ready_i;
  assign load            = {valid_q[Stages-1:0], fetched_valid_i} & {(Stages + 1){advance}};
  assign load_out        = valid_q[Stages] && advance && keep;
  assign fetched_ready_o = advance;
  assign visible_valid_o = out_valid_q;
  assign busy_o          = valid_q != '0 || out_valid_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      valid_q     <= '0;
      out_valid_q <= 1'b0;
    end else if (advance) begin
      valid_q     <= {valid_q[Stages-1:0], fetched_valid_i};
      out_valid_q <= valid_q[Stages] && keep;
    end
  end
  pipegs_pkg::fetched_t fetched_q;
  wire [pipegs_pkg::FetchedBits-1:0] fetched_bits = fetched_q;
  always_ff @(posedge clk_i) if (load[0]) fetched_q <= fetched_i;

  // --- what rides along: all of visible_t but the view coordinates, as vectors -------------------------------------
  localparam int unsigned RideW = pipegs_pkg::VisibleBits - 3 * ViewW;
  typedef struct packed {
    logic [RideW-KindW-PlaceW-ExpW-1:0] gaussian;
    logic [ExpW-1:0]                    view_exp;
    logic [PlaceW-1:0]                  place;  // window and walk
    logic [KindW-1:0]                   kind;
  } ride_t;
  ride_t            ride, ride2, ride4, ride6, ride7;  // rideN: the record in register N, read in stage N + 1
  logic [RideW-1:0] ride_q [Stages+1];          // 1 to 7
  localparam int unsigned GaussianW = RideW - KindW - PlaceW - ExpW - pipegs_pkg::EyeW;
  assign ride.gaussian[GaussianW-1:0] = {fetched_q.slot, fetched_q.index, fetched_q.base_b, fetched_q.base_g,
                                         fetched_q.base_r, fetched_q.opacity, fetched_q.scale_2, fetched_q.scale_1,
                                         fetched_q.scale_0, fetched_q.qz, fetched_q.qy, fetched_q.qx, fetched_q.qw};
  assign ride.view_exp = fetched_q.view_exp;
  assign ride.place    = fetched_bits[KindW +: PlaceW];
  assign ride.kind     = fetched_q.kind;
  assign ride2 = ride_q[2];
  assign ride4 = ride_q[4];
  assign ride6 = ride_q[6];
  assign ride7 = ride_q[7];
  always_ff @(posedge clk_i) begin
    if (load[1]) ride_q[1] <= ride;
    for (int unsigned i = 1; i < Stages; i += 1) if (load[i+1]) ride_q[i+1] <= ride_q[i];
  end

  // --- stages 1 to 3: W offset, shifted to view units --------------------------------------------------------------
  localparam int unsigned ProductW = RotW + PosW;
  localparam int unsigned SumW     = ProductW + 2;
  localparam int unsigned DownW    = ExpW + 1;  // of a shift by RotF + view_exp - offset_exp
  logic signed [ProductW-1:0] xx_q, xy_q, xz_q, yx_q, yy_q, yz_q, zx_q, zy_q, zz_q;
  logic signed [SumW-1:0]     x2_q, y2_q, z2_q, x3_q, y3_q, z3_q;
  logic signed [ViewW-1:0]    origin_x_q [4], origin_y_q [4], origin_z_q [4];  // 1 to 3
  logic        [DownW-1:0]    down1_q, down2_q;
  always_ff @(posedge clk_i) begin
    if (load[1]) begin
      xx_q <= ProductW'(rotation_i.w00) * ProductW'(fetched_q.offset_x);
      xy_q <= ProductW'(rotation_i.w01) * ProductW'(fetched_q.offset_y);
      xz_q <= ProductW'(rotation_i.w02) * ProductW'(fetched_q.offset_z);
      yx_q <= ProductW'(rotation_i.w10) * ProductW'(fetched_q.offset_x);
      yy_q <= ProductW'(rotation_i.w11) * ProductW'(fetched_q.offset_y);
      yz_q <= ProductW'(rotation_i.w12) * ProductW'(fetched_q.offset_z);
      zx_q <= ProductW'(rotation_i.w20) * ProductW'(fetched_q.offset_x);
      zy_q <= ProductW'(rotation_i.w21) * ProductW'(fetched_q.offset_y);
      zz_q <= ProductW'(rotation_i.w22) * ProductW'(fetched_q.offset_z);
      down1_q <= DownW'(RotF - 1) + DownW'(fetched_q.view_exp) - DownW'(fetched_q.offset_exp);
      origin_x_q[1] <= fetched_q.origin_x;
      origin_y_q[1] <= fetched_q.origin_y;
      origin_z_q[1] <= fetched_q.origin_z;
    end
    if (load[2]) begin
      x2_q <= SumW'(xx_q) + SumW'(xy_q) + SumW'(xz_q);
      y2_q <= SumW'(yx_q) + SumW'(yy_q) + SumW'(yz_q);
      z2_q <= SumW'(zx_q) + SumW'(zy_q) + SumW'(zz_q);
      down2_q <= down1_q;
    end
    if (load[3]) begin
      // One bit less than the whole shift: the last one rounds, in stage 4.
      x3_q <= x2_q >>> down2_q;
      y3_q <= y2_q >>> down2_q;
      z3_q <= z2_q >>> down2_q;
    end
    for (int unsigned i = 1; i < 3; i += 1) begin
      if (load[i+1]) begin
        origin_x_q[i+1] <= origin_x_q[i];
        origin_y_q[i+1] <= origin_y_q[i];
        origin_z_q[i+1] <= origin_z_q[i];
      end
    end
  end

  // --- stage 4: the view coordinates -------------------------------------------------------------------------------
  logic signed [ViewW-1:0] x4, y4, z4, x4_q, y4_q, z4_q;
  function automatic logic signed [SumW:0] place(input logic signed [SumW-1:0]  twice,
                                                 input logic signed [ViewW-1:0] origin);
    place = ((SumW + 1)'(twice) + ((SumW + 1)'(origin) <<< 1) + $signed((SumW + 1)'(1))) >>> 1;
  endfunction
  logic signed [ViewW-1:0] x_middle4, y_middle4;  // as seen from between the eyes
  pipegs_saturate #(.InW(SumW + 1), .OutW(ViewW)) u_x4 (
    .in_i(place(x3_q, origin_x_q[3])),
    .out_o(x_middle4)
  );
  pipegs_saturate #(.InW(SumW + 1), .OutW(ViewW)) u_y4 (
    .in_i(place(y3_q, origin_y_q[3])),
    .out_o(y_middle4)
  );
  pipegs_saturate #(.InW(SumW + 1), .OutW(ViewW)) u_z4 (
    .in_i(place(z3_q, origin_z_q[3])),
    .out_o(z4)
  );

  if (pipegs_pkg::Eyes > 1) begin : gen_eyes
    logic                    eye_q, eye1_q, eye2_q;
    logic signed [HalfW:0]   x_shift3_q, y_shift3_q;  // of the eye
    logic signed [ViewW:0]   x_seen, y_seen;
    // Rounded to the unit of the chunk's view space, before its sign.
    function automatic logic signed [HalfW:0] shift(input logic signed [HalfW-1:0] half, input logic [ExpW-1:0] down,
                                                    input logic eye);
      logic signed [HalfW:0] twice, rounded;
      twice   = ((HalfW + 1)'(half) <<< 1) >>> down;
      rounded = (twice + $signed((HalfW + 1)'(1))) >>> 1;
      shift   = eye ? -rounded : rounded;
    endfunction
    always_ff @(posedge clk_i) begin
      if (load[0]) eye_q <= eye_i;
      if (load[1]) eye1_q <= eye_q;
      if (load[2]) eye2_q <= eye1_q;
      if (load[3]) begin
        x_shift3_q <= shift(half_x_i, ride2.view_exp, eye2_q);
        y_shift3_q <= shift(half_y_i, ride2.view_exp, eye2_q);
      end
    end
    assign ride.gaussian[GaussianW] = eye_q;
    logic unused_shift;  // the unit of view space leaves room for it
    assign unused_shift = ^{x_shift3_q, y_shift3_q};
    assign x_seen = (ViewW + 1)'(x_middle4) + (ViewW + 1)'(x_shift3_q);
    assign y_seen = (ViewW + 1)'(y_middle4) + (ViewW + 1)'(y_shift3_q);
    pipegs_saturate #(.InW(ViewW + 1), .OutW(ViewW)) u_x_seen (
      .in_i(x_seen),
      .out_o(x4)
    );
    pipegs_saturate #(.InW(ViewW + 1), .OutW(ViewW)) u_y_seen (
      .in_i(y_seen),
      .out_o(y4)
    );
  end else begin : gen_one_eye
    assign x4 = x_middle4;
    assign y4 = y_middle4;
    logic unused_eye;
    assign unused_eye = ^{eye_i, half_x_i, half_y_i};
  end

  // --- stages 1 to 3 beside them: the largest scale in view units, rounded up --------------------------------------
  localparam int unsigned Bias   = 8;                  // of a scale's exponent field
  localparam int unsigned SlackW = ScaleMW + 5 > QuatW ? ScaleMW + 5 - QuatW : 0;
  localparam int unsigned OneW   = ScaleMW + 2;        // leading one, and room for the slack of rounded quaternions
  localparam int unsigned HighW  = ViewW + OneW;       // a scale at the upper end of the range that is not huge
  localparam int unsigned StepW  = ExpW + 2;
  localparam logic signed [StepW-1:0] TopStep = StepW'(ViewW + Bias + ScaleMW);
  localparam int unsigned WeightW = 9;                 // u1.8, from the leading bits of the opacity
  localparam int unsigned WeightedW = OneW + WeightW;
  logic [ScaleW-1:0]        larger, scale1_q;
  logic [WeightW-1:0]       weight1_q;
  logic [OneW-1:0]          one1;
  logic [WeightedW-1:0]     weighted1;
  logic [OneW-1:0]          one2_q;
  logic signed [StepW-1:0]  lower2_q;  // how far below the upper end; negative: beyond it
  logic [HighW-1:0]         size3;
  logic                     huge3_q, huge4_q, huge5_q, huge6_q, huge7_q, some1;
  logic [ViewW-1:0]         s3_q, s4_q;
  assign larger = fetched_q.scale_0 > fetched_q.scale_1 ? fetched_q.scale_0 : fetched_q.scale_1;
  assign some1  = scale1_q[ScaleW-1:ScaleMW] != '0;
  assign size3  = {one2_q, {ViewW{1'b0}}} >> $unsigned(lower2_q);
  // The mantissa, its slack and the weight, rounded up.
  assign one1      = {2'b01, scale1_q[ScaleMW-1:0]} + OneW'(64'd1 << SlackW);
  assign weighted1 = WeightedW'(one1) * WeightedW'(weight1_q) + WeightedW'(255);
  ride_t ride1;
  assign ride1 = ride_q[1];
  logic beyond3;
  assign beyond3 = one2_q != '0 && (lower2_q < 0 || size3 >= HighW'((64'd1 << (ViewW - 1)) - 64'd1));
  always_ff @(posedge clk_i) begin
    if (load[1]) begin
      scale1_q <= larger > fetched_q.scale_2 ? larger : fetched_q.scale_2;
      weight1_q <= pipegs_pkg::CullWeights[WeightW*32'(fetched_q.opacity[pipegs_pkg::OpacityW-1 -: 6]) +: WeightW];
    end
    if (load[2]) begin
      one2_q   <= some1 ? OneW'(weighted1 >> (WeightW - 1)) : '0;
      lower2_q <= TopStep + $signed(StepW'(ride1.view_exp)) - $signed(StepW'(scale1_q[ScaleW-1:ScaleMW]));
    end
    if (load[3]) begin
      huge3_q  <= beyond3;
      s3_q     <= beyond3 ? ViewW'((64'd1 << (ViewW - 1)) - 64'd1) : size3[ViewW-1:0] + ViewW'(1);
    end
    if (load[4]) {huge4_q, s4_q} <= {huge3_q, s3_q};
  end

  // --- stages 4 and 5: near plane, common exponent -----------------------------------------------------------------
  localparam int unsigned CutW   = pipegs_pkg::CutW;
  localparam int unsigned ShiftW = pipegs_pkg::CutShiftW;
  logic [2:0] walk4, walk6;  // of one part, half a window's side long: 1, its row, its column
  if (pipegs_pkg::HasWalks) begin : gen_walk
    assign {walk4, walk6} = {ride4.place[PlaceW-1 -: 3], ride6.place[PlaceW-1 -: 3]};
  end else begin : gen_whole
    assign {walk4, walk6} = '0;
  end
  logic                       front7;
  logic signed [ViewW-1:0]    x5_q, y5_q, z5_q, sizes, normal;
  logic [ViewW-1:0]           s5_q;
  logic [ShiftW-1:0]          shift, cut5_q;
  ride_t                      ride3;
  assign ride3 = ride_q[3];
  assign sizes = (x4_q ^ (x4_q >>> (ViewW - 1))) | (y4_q ^ (y4_q >>> (ViewW - 1))) | (z4_q ^ (z4_q >>> (ViewW - 1))) |
                 $signed({1'b0, s4_q[ViewW-2:0]});
  pipegs_normalize #(.DataW(ViewW)) u_normalize (
    .in_i(sizes),
    .out_o(normal),
    .shift_o(shift)
  );
  localparam logic [ShiftW-1:0] NoCut = ShiftW'(ViewW - CutW);  // shift of a value of CutW bits
  always_ff @(posedge clk_i) begin
    if (load[4]) {x4_q, y4_q, z4_q} <= {x4, y4, z4};
    if (load[5]) begin
      {x5_q, y5_q, z5_q, s5_q, huge5_q} <= {x4_q, y4_q, z4_q, s4_q, huge4_q};
      cut5_q <= shift < NoCut ? NoCut - shift : '0;
    end
  end

  if (pipegs_pkg::NearTest != 0) begin : gen_near
    logic [WorldW-1:0] near4_q;
    logic              front5_q, front6_q, front7_q;
    always_ff @(posedge clk_i) begin
      if (load[4]) near4_q  <= lens_i.near_plane >> ride3.view_exp;
      if (load[5]) front5_q <= !z4_q[ViewW-1] && WorldW'($unsigned(z4_q)) > near4_q;
      if (load[6]) front6_q <= front5_q;
      if (load[7]) front7_q <= front6_q;
    end
    assign front7 = front7_q;
  end else begin : gen_no_near
    assign front7 = 1'b1;
  end

  // --- stages 6 and 7: cut; the walk's side times z ----------------------------------------------------------------
  localparam int unsigned EdgeF = 4;  // fraction of a pixel
  localparam int unsigned HalfF = $clog2(pipegs_pkg::Window) - 1 + EdgeF;  // of half a window's side: that of a part
  localparam int unsigned Span  = ((pipegs_pkg::Window - 1 + 2 * pipegs_pkg::ReachMargin) << EdgeF) + 1;
  localparam int unsigned SpanW = $clog2(Span + 1) + CutW;
  logic signed [ViewW-1:0] x6_q, y6_q, z6_q, x7_q, y7_q, z7_q;  // the view coordinates
  logic signed [CutW-1:0]  cx6_q, cy6_q, cz6_q;                 // cut
  logic        [CutW-1:0]  cs6_q;
  logic signed [SpanW-1:0] span7;
  always_ff @(posedge clk_i) begin
    if (load[6]) begin
      {x6_q, y6_q, z6_q, huge6_q} <= {x5_q, y5_q, z5_q, huge5_q};
      cx6_q <= CutW'(x5_q >>> cut5_q);
      cy6_q <= CutW'(y5_q >>> cut5_q);
      cz6_q <= CutW'(z5_q >>> cut5_q);
      cs6_q <= CutW'(s5_q >> cut5_q) + CutW'(1);
    end
    if (load[7]) {x7_q, y7_q, z7_q, huge7_q} <= {x6_q, y6_q, z6_q, huge6_q};
  end
  if (pipegs_pkg::HasLists) begin : gen_frame  // a product of either axis
    assign span7 = '0;
  end else begin : gen_window
    logic signed [SpanW-1:0] span7_q, less6;  // less6: what a part's is less
    assign less6 = walk6[2] ? SpanW'(cz6_q) <<< HalfF : '0;
    always_ff @(posedge clk_i) if (load[7]) span7_q <= $signed(SpanW'(Span)) * SpanW'(cz6_q) - less6;
    assign span7 = span7_q;
  end

  // --- stages 5 to 8: the two axes ---------------------------------------------------------------------------------
  pipegs_pkg::closed_t                closed4;  // of the walk, at each side
  logic signed [pipegs_pkg::GapW-1:0] gap_x, gap_y;
  logic                               touch_x, touch_y;
  if (pipegs_pkg::Occlusion != 0) begin : gen_open
    pipegs_closed u_closed (
      .open_i,
      .place_i(ride4.place),
      .closed_o(closed4)
    );
  end else begin : gen_walk_alone
    assign closed4 = '0;
    logic unused_open;
    assign unused_open = ^open_i;
  end
  pu_cull_axis #(.EdgeF(EdgeF), .Span(Span), .SpanW(SpanW)) u_x (
    .clk_i,
    .load_i(load[7:5]),
    .focal_i(lens_i.focal_x),
    .center_i(lens_i.center_x),
    .reach_i(lens_i.reach_x),
    .first_i(windows_i.first_x),
    .last_i(windows_i.last_x),
    .window4_i(ride4.place[0 +: WindowW]),
    .behind4_i(walk4[0]),
    .closed_near4_i(closed4.left),
    .closed_far4_i(closed4.right),
    .c6_i(cx6_q),
    .z6_i(cz6_q),
    .s6_i(cs6_q),
    .part6_i(walk6[2]),
    .span7_i(span7),
    .touch_o(touch_x),
    .gap_o(gap_x)
  );
  pu_cull_axis #(.EdgeF(EdgeF), .Span(Span), .SpanW(SpanW)) u_y (
    .clk_i,
    .load_i(load[7:5]),
    .focal_i(lens_i.focal_y),
    .center_i(lens_i.center_y),
    .reach_i(lens_i.reach_y),
    .first_i(windows_i.first_y),
    .last_i(windows_i.last_y),
    .window4_i(ride4.place[WindowW +: WindowW]),
    .behind4_i(walk4[1]),
    .closed_near4_i(closed4.top),
    .closed_far4_i(closed4.bottom),
    .c6_i(cy6_q),
    .z6_i(cz6_q),
    .s6_i(cs6_q),
    .part6_i(walk6[2]),
    .span7_i(span7),
    .touch_o(touch_y),
    .gap_o(gap_y)
  );

  assign keep = ride7.kind != pipegs_pkg::KindData || (front7 && (huge7_q || (touch_x && touch_y)));

  pipegs_pkg::visible_t out_q;
  assign visible_o = out_q;
  always_ff @(posedge clk_i) begin
    if (load_out) begin
      out_q      <= '0;
      out_q.kind <= ride7.kind;
      if (ride7.kind == pipegs_pkg::KindData) begin
        out_q <= {ride7.gaussian, ride7.view_exp, z7_q, y7_q, x7_q, ride7.place, ride7.kind};
      end
    end
  end

  // --- beside stages 7 and 8: how far the mean lies beyond the window, times z ---------------------------------------
  if (pipegs_pkg::TightCull != 0) begin : gen_gap
    logic signed [CutW-1:0] cx7_q, cy7_q, cz7_q;
    logic [ShiftW-1:0]      cut6_q, cut7_q;
    pipegs_pkg::gap_t       gap_q;
    always_ff @(posedge clk_i) begin
      if (load[6]) cut6_q <= cut5_q;
      if (load[7]) {cut7_q, cx7_q, cy7_q, cz7_q} <= {cut6_q, cx6_q, cy6_q, cz6_q};
      if (load_out) begin
        gap_q <= '0;
        if (ride7.kind == pipegs_pkg::KindData) begin
          gap_q <= {huge7_q, gap_y, gap_x, cut7_q, cz7_q, cy7_q, cx7_q};
        end
      end
    end
    assign gap_o = gap_q;
  end else begin : gen_no_gap
    assign gap_o = '0;
  end

  // Of the normalised sizes only the shift is used.
  wire unused_bits = &{1'b0, lens_i, normal, gap_x, gap_y, ride1, ride2, ride3, ride4, ride6, walk4, walk6,
                       fetched_bits, s4_q[ViewW-1], size3[HighW-1:ViewW]};

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni)
    assert (!(pipegs_pkg::NearTest == 0 && out_valid_q && out_q.kind == pipegs_pkg::KindData) || out_q.view_z > 0)
    else $error("pu_cull: a Gaussian behind the camera, and NearTest is 0");
  pipegs_stream_check #(.DataW($bits({visible_o, gap_o}))) u_check_visible (
    .clk_i,
    .rst_ni,
    .valid_i(visible_valid_o),
    .ready_i(visible_ready_i),
    .beat_i({visible_o, gap_o})
  );
`endif

endmodule
