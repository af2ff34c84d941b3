// SPDX-License-Identifier: Apache-2.0
// dopu_test: can a node of the scene hold a Gaussian that touches the window? Never says no when it can.
//
// Paper   Sec. 4.1.
// Idea    The corner of the box farthest along a plane's normal decides: three products, one more for reach * scale.
//         Corners, scale and near distance share one block exponent; what flooring takes away is given back as a
//         constant Slack. The box is that of the means or, with TightBoxes, that of the ellipsoids (dopu_hull). Eyes
//         that stand apart move the side planes out, each by a scale's reach; planes of one eye's walk move to its
//         side.
// Stream  node: a node, the set of planes to use (each side plane may become a tighter one while the node is inside), a
//         tag. result: node, tag, pass; it has no ready: the caller asks only for what it can take.
//         nearest (with watermarks, else 0): in units of 2^(exponent - 18) world units no Gaussian of the node is
//         nearer: there the nearest corner takes the place beside the fifth plane. farthest (where windows have walks,
//         else 0), likewise: about where the node ends, what the near plane's test says of the box that counts.
// Pace    One node in three cycles (two planes per cycle, eight TestW-bit multipliers), result 14 cycles later. A node
//         is taken in every third cycle; Phase shifts which. While the DOPU sleeps the phase
//         stands, whether its clock does or not.
// slot 0: corners, one axis per cycle | 1: exponent, shift x, y | 2: shift z, near+left, right+top | 3: bottom, sum
// Model   cpp_model/dopu/dopu_test.hpp, cpp_model/dopu/nearest/dopu_depth.hpp (nearest)

module dopu_test #(
  parameter int unsigned TagW = 4,
  parameter int unsigned Phase = 0,  // 0 to 2
  localparam int unsigned DistanceW = 2 * pipegs_pkg::TestW + 2
) (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,
  input  logic                                  awake_i,  // the unit's clock does not stand, or would not

  input  pipegs_pkg::position_t                 position_i,
  input  logic [pipegs_pkg::TestEyesW-1:0]      test_eyes_i,  // one eye: 0
  input  logic [pipegs_pkg::WorldW-1:0]         near_plane_i,
  input  logic [2*5*pipegs_pkg::PlaneBits-1:0]  planes_i,  // two sets: near, left, right, top, bottom

  input  logic                                  node_valid_i,
  output logic                                  node_ready_o,
  input  pipegs_pkg::node_t                     node_i,
  input  logic                                  set_i,
  input  logic                                  tight_i,  // with TightBoxes: what dopu_hull says of the node
  input  logic [pipegs_pkg::ScaleW-1:0]         scale_i,
  input  logic [TagW-1:0]                       tag_i,

  output logic                                  result_valid_o,
  output logic                                  result_pass_o,
  output pipegs_pkg::node_t                     result_node_o,
  output logic [TagW-1:0]                       result_tag_o,
  output logic signed [DistanceW-1:0]            result_nearest_o,
  output logic signed [DistanceW-1:0]            result_farthest_o,
  output logic [pipegs_pkg::ExpW-1:0]           result_exponent_o
);

  localparam int unsigned WorldW = pipegs_pkg::WorldW;
  localparam int unsigned TestW = pipegs_pkg::TestW;
  localparam int unsigned ExpW = pipegs_pkg::ExpW;
  localparam int unsigned ScaleMW = pipegs_pkg::ScaleMW;
  localparam int unsigned ScaleEW = pipegs_pkg::ScaleEW;
  localparam int unsigned PlaneBits = pipegs_pkg::PlaneBits;
  localparam int unsigned CornerW = WorldW + 2;
  localparam int unsigned ProductW = 2 * TestW;
  localparam int unsigned SumW = ProductW + 2;
  localparam int unsigned StageW = pipegs_pkg::NodeBits + TagW + 1;
  localparam logic signed [SumW-1:0] Slack = SumW'(1) <<< (TestW + 2);
  localparam int unsigned ScaleBias = 7;  // scale < 2^(exponent field - 7)

  // --- slots: the node moves on every third cycle -------------------------------------------------------------
  logic [1:0]        phase_q;
  logic [4:0]        valid_q;   // of slots 0 to 3; 4: the result
  logic [StageW-1:0]  slot0_q, slot1_q, slot2_q, slot3_q;
  logic              last_phase;

  assign last_phase   = phase_q == 2'd2;
  assign node_ready_o = last_phase;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      phase_q <= 2'(Phase);
      valid_q <= '0;
    end else begin
      if (awake_i) phase_q <= last_phase ? '0 : phase_q + 1'b1;
      if (last_phase) valid_q[3:0] <= {valid_q[2:0], node_valid_i};
      valid_q[4] <= valid_q[3] && phase_q == 2'd1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (last_phase) begin
      slot0_q <= {set_i, tag_i, node_i};
      slot1_q <= slot0_q;
      slot2_q <= slot1_q;
      slot3_q <= slot2_q;
    end
  end

  // --- slot 0: low and high corner of one axis per cycle, relative to the camera --------------------------------
  pipegs_pkg::node_t          node0, node1;
  logic signed [WorldW-1:0]   center, camera;
  logic [pipegs_pkg::HalfW-1:0] half, down, up;  // of the means; of the box that counts
  logic signed [CornerW-1:0]  delta, low, high;
  logic [CornerW-1:0]         magnitude, magnitudes_q;
  logic signed [CornerW-1:0]  low_q [4];   // delay until the exponent is known
  logic signed [CornerW-1:0]  high_q [4];

  assign node0 = slot0_q[pipegs_pkg::NodeBits-1:0];
  always_comb begin
    case (phase_q)
      2'd0: begin center = node0.center_x; camera = position_i.x; half = node0.half_x; end
      2'd1: begin center = node0.center_y; camera = position_i.y; half = node0.half_y; end
      default: begin center = node0.center_z; camera = position_i.z; half = node0.half_z; end
    endcase
  end
  assign delta     = CornerW'(center) - CornerW'(camera);
  assign low       = delta - (CornerW'({1'b0, down}) <<< node0.half_exp);
  assign high      = delta + (CornerW'({1'b0, up}) <<< node0.half_exp);
  assign magnitude = (low[CornerW-1] ? ~low : low) | (high[CornerW-1] ? ~high : high);

  always_ff @(posedge clk_i) begin
    if (valid_q[0]) magnitudes_q <= phase_q == '0 ? magnitude : magnitudes_q | magnitude;
    if (valid_q[1:0] != '0) begin
      low_q[0]  <= low;
      high_q[0] <= high;
      for (int unsigned i = 1; i < 4; i += 1) begin
        low_q[i]  <= low_q[i-1];
        high_q[i] <= high_q[i-1];
      end
    end
  end

  // --- slot 1, phase 0: the block exponent; then the corners through two shifters ---------------------------------
  logic [$clog2(CornerW+1)-1:0] corner_length;
  logic [ExpW:0]             length;
  logic [ExpW-1:0]           exponent_d, exponent_q, eyes_length;
  logic [ScaleEW-1:0]        scale_e;
  logic [pipegs_pkg::ScaleW-1:0] scale1;
  logic signed [CornerW-1:0] low_wide, high_wide;
  logic signed [TestW-1:0]   low_cut, high_cut, low_x_cut_q, high_x_cut_q, low_y_cut_q, high_y_cut_q;

  assign node1   = slot1_q[pipegs_pkg::NodeBits-1:0];
  assign scale_e = scale1[pipegs_pkg::ScaleW-1:ScaleMW];
  pipegs_bit_length #(.DataW(CornerW)) u_length (
    .in_i(magnitudes_q),
    .length_o(corner_length)
  );
  always_comb begin
    length = (ExpW+1)'(corner_length);
    if ((ExpW+1)'(scale_e) > length + (ExpW+1)'(ScaleBias)) length = (ExpW+1)'(scale_e) - (ExpW+1)'(ScaleBias);
    if (eyes_length != '0) length = ((ExpW+1)'(eyes_length) > length ? (ExpW+1)'(eyes_length) : length) + 1'b1;
    exponent_d = length > (ExpW+1)'(TestW - 1) ? ExpW'(length - (ExpW+1)'(TestW - 1)) : '0;
  end
  assign low_wide  = low_q[3] >>> exponent_q;
  assign high_wide = high_q[3] >>> exponent_q;
  assign low_cut   = low_wide[TestW-1:0];
  assign high_cut  = high_wide[TestW-1:0];
  logic unused_corners;  // sign bits beyond TestW
  assign unused_corners = ^{low_wide[CornerW-1:TestW], high_wide[CornerW-1:TestW]};

  always_ff @(posedge clk_i) begin
    if (phase_q == 2'd0) exponent_q <= exponent_d;
    if (phase_q == 2'd1) begin
      low_x_cut_q  <= low_cut;
      high_x_cut_q <= high_cut;
    end
    if (phase_q == 2'd2) begin
      low_y_cut_q  <= low_cut;
      high_y_cut_q <= high_cut;
    end
  end

  // Scale (phase 1) and near distance (phase 2) in the same unit, floored.
  logic [TestW-2:0]   scale_top, scale_cut_q, near_cut_q;
  logic [ExpW+1:0]    scale_shift;
  logic [WorldW-1:0]  near_wide;

  assign scale_top   = (TestW-1)'({1'b1, scale1[ScaleMW-1:0]}) << (TestW - 2 - ScaleMW);
  assign scale_shift = (ExpW+2)'(exponent_q) + (ExpW+2)'(TestW + ScaleBias - 1) - (ExpW+2)'(scale_e);
  assign near_wide   = near_plane_i >> exponent_q;

  always_ff @(posedge clk_i) begin
    if (phase_q == 2'd1) scale_cut_q <= scale_e == '0 ? '0 : scale_top >> scale_shift;
    if (phase_q == 2'd2) near_cut_q <= near_wide[WorldW-1:TestW-1] != '0 ? '1 : near_wide[TestW-2:0];
  end

  // With two eyes the side planes move, by a scale: phase 0 takes it, with that of the node.
  typedef struct packed {logic signed [TestW-1:0] bottom, top, right, left;} moved_t;
  moved_t moved_cut;
  if (pipegs_pkg::Eyes > 1) begin : gen_eyes
    localparam int unsigned ReachW = pipegs_pkg::EyeReachW;
    typedef struct packed {
      logic              negative;  // half the way between the eyes
      logic [ReachW-1:0] reach;
    } side_t;
    typedef struct packed {
      logic [ExpW-1:0] length;
      side_t           y, x;
      logic [1:0]      one, eye;  // of each set: planes are for one eye, and for which
    } eyes_t;
    eyes_t                   eyes;
    side_t                   shifted, axis_q;
    logic [ReachW-1:0]       reach_wide;
    logic [TestW-2:0]        cut_q;
    logic signed [TestW-1:0] beside, plus, minus, lower, upper, lower_x_q, upper_x_q;
    logic                    set, one, eye;
    assign eyes        = test_eyes_i;
    assign eyes_length = eyes.length;
    // Phase 1 shifts x, phase 2 y; phase 2 adds x, phase 0 y.
    assign shifted     = phase_q == 2'd1 ? eyes.x : eyes.y;
    assign reach_wide  = shifted.reach >> exponent_q;
    assign set         = phase_q == 2'd0 ? slot2_q[StageW-1] : slot1_q[StageW-1];
    assign one         = eyes.one[set];
    assign eye         = eyes.eye[set];
    assign beside      = {1'b0, scale_cut_q} + TestW'(axis_q.reach != '0);  // what flooring takes, given back
    assign plus        = beside + {1'b0, cut_q};
    assign minus       = beside - {1'b0, cut_q};
    assign lower       = !one || eye == axis_q.negative ? plus : minus;
    assign upper       = !one || eye != axis_q.negative ? plus : minus;
    always_ff @(posedge clk_i) begin
      axis_q <= shifted;
      cut_q  <= reach_wide[TestW-2:0];
      if (phase_q == 2'd2) {upper_x_q, lower_x_q} <= {upper, lower};
    end
    assign moved_cut = {upper, lower, upper_x_q, lower_x_q};
    logic unused_reach;  // bits that the exponent leaves 0
    assign unused_reach = ^reach_wide[ReachW-1:TestW-1];
  end else begin : gen_one_eye
    assign eyes_length = '0;
    assign moved_cut   = {4{1'b0, scale_cut_q}};
    logic unused_eyes;
    assign unused_eyes = ^test_eyes_i;
  end

  // --- slot 2, phase 0: z comes out of the shifter; all corners stand for three cycles ------------------------------
  logic signed [TestW-1:0] low_x_q, high_x_q, low_y_q, high_y_q, low_z_q, high_z_q;
  logic signed [TestW-1:0] near_q;
  moved_t                  moved_q;  // what the sides' reach is multiplied with
  logic                    set_q;

  always_ff @(posedge clk_i) begin
    if (phase_q == 2'd0) begin
      low_x_q  <= low_x_cut_q;
      high_x_q <= high_x_cut_q;
      low_y_q  <= low_y_cut_q;
      high_y_q <= high_y_cut_q;
      low_z_q  <= low_cut;
      high_z_q <= high_cut;
      moved_q  <= moved_cut;
      near_q   <= {1'b0, near_cut_q};
      set_q    <= slot2_q[StageW-1];
    end
  end

  // --- two planes per cycle: near and left, right and top, bottom ---------------------------------------------------
  localparam bit Ranks = pipegs_pkg::HasWatermarks;
  logic                       set_d;
  typedef struct packed {logic [9:0][PlaneBits-1:0] of;} planes_t;  // five of each set
  planes_t                    planes;
  logic [1:0]                 first_q, second_q, third_q;  // phases 1, 2 and 0, of either set
  logic                       nearest;    // phase 0: plane b is the near plane's normal, of the corner nearest to it
  pipegs_pkg::plane_t         plane_a, plane_b;
  logic signed [TestW-1:0]    operand_a, operand_b;
  logic signed [ProductW-1:0] ax_q, ay_q, az_q, ar_q, bx_q, by_q, bz_q, br_q;
  logic signed [SumW-1:0]     corner_a, sum_a, sum_b;
  logic                       outside, outside_q;

  // Which pair stands here, and of which set, from registers of its own: the choice leads into the multipliers.
  assign set_d = phase_q == 2'd0 ? slot2_q[StageW-1] : set_q;
  always_ff @(posedge clk_i) begin
    first_q  <= phase_q == 2'd0 ? {set_d, !set_d} : '0;
    second_q <= phase_q == 2'd1 ? {set_d, !set_d} : '0;
    third_q  <= last_phase ? {set_d, !set_d} : '0;
  end
  assign planes = planes_i;
  always_comb begin
    plane_a = '0;
    plane_b = '0;
    for (int unsigned set = 0; set < 2; set += 1) begin
      plane_a |= ({PlaneBits{first_q[set]}} & planes.of[5*set]) |
                 ({PlaneBits{second_q[set]}} & planes.of[5*set+2]) |
                 ({PlaneBits{third_q[set]}} & planes.of[5*set+4]);
      plane_b |= ({PlaneBits{first_q[set]}} & planes.of[5*set+1]) |
                 ({PlaneBits{second_q[set]}} & planes.of[5*set+3]) |
                 ({PlaneBits{third_q[set]}} & planes.of[5*set + (Ranks ? 0 : 4)]);
    end
  end
  assign nearest   = Ranks && third_q != '0;
  if (pipegs_pkg::Eyes > 1) begin : gen_moved
    assign operand_a = first_q != '0 ? near_q : second_q != '0 ? moved_q.right : moved_q.bottom;
    assign operand_b = first_q != '0 ? moved_q.left : moved_q.top;
  end else begin : gen_scale  // all four are one
    assign operand_a = first_q != '0 ? near_q : moved_q.left;
    assign operand_b = moved_q.left;
    logic unused_moved;
    assign unused_moved = ^moved_q;
  end

  // --- which box counts; the corner of the means that is nearest to the near plane -----------------------------------
  logic signed [TestW-1:0] nearest_x, nearest_y, nearest_z;
  if (pipegs_pkg::TightBoxes != 0) begin : gen_hull
    localparam int unsigned ScaleW = pipegs_pkg::ScaleW;
    logic                       tight_q, ahead;  // ahead: the near plane's normal rises along the axis
    logic [ScaleW-1:0]          scale0_q, scale1_q;
    logic [3*TestW-1:0]         normal;
    logic signed [CornerW-1:0]  extent, corner, corner_wide;
    logic signed [CornerW-1:0]  corner_q [4];
    logic signed [TestW-1:0]    cut, x_cut_q, y_cut_q, x_q, y_q, z_q;

    always_ff @(posedge clk_i) begin
      if (last_phase) begin
        {tight_q, scale0_q} <= {tight_i, scale_i};
        scale1_q <= scale0_q;
      end
    end
    assign scale1 = scale1_q;
    assign normal = (3*TestW)'(slot0_q[StageW-1] ? planes.of[5] : planes.of[0]);  // x lowest
    always_comb begin
      case (phase_q)
        2'd0: begin {down, up} = {node0.down_x, 1'b0, node0.up_x, 1'b0}; ahead = !normal[TestW-1]; end
        2'd1: begin {down, up} = {node0.down_y, 1'b0, node0.up_y, 1'b0}; ahead = !normal[2*TestW-1]; end
        default: begin {down, up} = {node0.down_z, 1'b0, node0.up_z, 1'b0}; ahead = !normal[3*TestW-1]; end
      endcase
      if (!tight_q) {down, up} = {half, half};
    end
    assign extent      = CornerW'({1'b0, half}) <<< node0.half_exp;
    assign corner      = ahead ? delta - extent : delta + extent;
    assign corner_wide = corner_q[3] >>> exponent_q;
    assign cut         = corner_wide[TestW-1:0];
    always_ff @(posedge clk_i) begin
      if (valid_q[1:0] != '0) begin
        corner_q[0] <= corner;
        for (int unsigned i = 1; i < 4; i += 1) corner_q[i] <= corner_q[i-1];
      end
      if (phase_q == 2'd1) x_cut_q <= cut;
      if (phase_q == 2'd2) y_cut_q <= cut;
      if (phase_q == 2'd0) {x_q, y_q, z_q} <= {x_cut_q, y_cut_q, cut};
    end
    assign {nearest_x, nearest_y, nearest_z} = {x_q, y_q, z_q};
    logic unused_corner;  // sign bits beyond TestW
    assign unused_corner = ^{corner_wide[CornerW-1:TestW], normal};
  end else begin : gen_means
    assign scale1    = node1.scale_max;
    assign down      = half;
    assign up        = half;
    assign nearest_x = plane_b.nx[TestW-1] ? high_x_q : low_x_q;
    assign nearest_y = plane_b.ny[TestW-1] ? high_y_q : low_y_q;
    assign nearest_z = plane_b.nz[TestW-1] ? high_z_q : low_z_q;
    logic unused_hull;
    assign unused_hull = ^{tight_i, scale_i};
  end

  // The far corner of each plane.
  logic signed [TestW-1:0] far_ax, far_ay, far_az, far_bx, far_by, far_bz;
  assign far_ax = plane_a.nx[TestW-1] ? low_x_q : high_x_q;
  assign far_ay = plane_a.ny[TestW-1] ? low_y_q : high_y_q;
  assign far_az = plane_a.nz[TestW-1] ? low_z_q : high_z_q;
  assign far_bx = nearest ? nearest_x : plane_b.nx[TestW-1] ? low_x_q : high_x_q;
  assign far_by = nearest ? nearest_y : plane_b.ny[TestW-1] ? low_y_q : high_y_q;
  assign far_bz = nearest ? nearest_z : plane_b.nz[TestW-1] ? low_z_q : high_z_q;

  always_ff @(posedge clk_i) begin
    ax_q <= ProductW'(plane_a.nx) * ProductW'(far_ax);
    ay_q <= ProductW'(plane_a.ny) * ProductW'(far_ay);
    az_q <= ProductW'(plane_a.nz) * ProductW'(far_az);
    ar_q <= ProductW'(plane_a.reach) * ProductW'(operand_a);
    bx_q <= ProductW'(plane_b.nx) * ProductW'(far_bx);
    by_q <= ProductW'(plane_b.ny) * ProductW'(far_by);
    bz_q <= ProductW'(plane_b.nz) * ProductW'(far_bz);
    br_q <= nearest ? '0 : ProductW'(plane_b.reach) * ProductW'(operand_b);
  end

  assign corner_a = SumW'(ax_q) + SumW'(ay_q) + SumW'(az_q) + Slack;
  assign sum_a   = corner_a + SumW'(ar_q);
  assign sum_b   = SumW'(bx_q) + SumW'(by_q) + SumW'(bz_q) + SumW'(br_q) + Slack;
  assign outside = sum_a[SumW-1] || (sum_b[SumW-1] && !(Ranks && phase_q == 2'd1));
  always_ff @(posedge clk_i) outside_q <= phase_q == 2'd2 ? outside : outside_q || outside;

  // The last sum is made in phase 1 of slot 3; the result stands in phase 2.
  assign result_valid_o = valid_q[4];
  assign result_pass_o  = !outside_q;
  assign result_node_o  = slot3_q[pipegs_pkg::NodeBits-1:0];
  assign result_tag_o   = slot3_q[StageW-2:pipegs_pkg::NodeBits];

  // --- the depth of the nearest corner, what roundings may take off, and its unit -----------------------------------
  if (Ranks) begin : gen_nearest
    localparam int unsigned ViewW = pipegs_pkg::ViewW;
    localparam int unsigned Boxes = ViewW < 24 ? 24 - ViewW : 0;
    localparam int unsigned MoreW = pipegs_pkg::PosW + (pipegs_pkg::Eyes > 1 ? 3 : 2);
    localparam int unsigned Offsets = MoreW > ViewW ? MoreW - ViewW : 0;
    localparam int unsigned Rounding = Boxes > Offsets ? Boxes : Offsets;
    localparam int unsigned NormalF = pipegs_pkg::RotF - (pipegs_pkg::RotW - TestW);
    localparam logic signed [SumW-1:0] Lost = Slack + (SumW'(1) <<< (TestW + 1)) + (SumW'(1) <<< (Rounding + NormalF));
    logic signed [SumW-1:0] depth_q;
    logic [ExpW-1:0]        exponent2_q, exponent3_q;  // in slots 2 and 3
    always_ff @(posedge clk_i) begin
      depth_q <= sum_b - Lost;
      if (last_phase) begin
        exponent2_q <= exponent_q;
        exponent3_q <= exponent2_q;
      end
    end
    assign result_nearest_o  = depth_q;
    assign result_exponent_o = exponent3_q;
  end else begin : gen_no_nearest
    assign result_nearest_o  = '0;
    assign result_exponent_o = '0;
  end

  if (pipegs_pkg::HasWalks) begin : gen_farthest
    logic signed [SumW-1:0] corner_q;
    always_ff @(posedge clk_i) if (last_phase) corner_q <= corner_a;
    assign result_farthest_o = corner_q;
  end else begin : gen_no_farthest
    assign result_farthest_o = '0;
  end

  logic unused;  // fields that do not matter here
  assign unused = &{1'b0, slot3_q[StageW-1], node0, node1};

endmodule
