// SPDX-License-Identifier: Apache-2.0
// dopu_rank: which nodes can touch the window, and in which bucket of depth they lie.
//
// Paper   None.
// Idea    Three box tests, out of step, take turns. The depth of a node's nearest corner gives its step; relative to
//         the near plane's step it is the bucket, clamped at both ends, and never below the parent's: what holds for
//         the parent's box holds for what lies inside. Where windows have walks, the bucket of the farthest corner,
//         too. Of a group with proxies its bucket says which of its ranges is opened (dopu_lod).
// Stream  node: a node, its set of planes, its parent's bucket, which of its boxes counts, its level and whether it is
//         its parent's last child. result: these two, pass, bucket and those fields of the node that are still needed,
//         in the order of the nodes; it has no ready: the caller asks only for what it can take.
// Pace    One node per cycle, results 15 cycles later, with proxies 16: the bucket comes late.
// Model   cpp_model/dopu/nearest/dopu_nearest.hpp

module dopu_rank #(
  localparam int unsigned BucketW = pipegs_pkg::BucketW,
  localparam int unsigned StepW = pipegs_pkg::StepW,
  localparam int unsigned LoadW = pipegs_pkg::LoadW,
  localparam int unsigned PlaceW = pipegs_pkg::NodePlaceW,                     // scale_exp, offset_exp, centre z, y, x
  localparam int unsigned RangeW = pipegs_pkg::ChildrenW + pipegs_pkg::SlotW   // error if there is one, count, first
) (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,
  input  logic                                  awake_i,  // the unit's clock does not stand, or would not

  input  pipegs_pkg::position_t                 position_i,
  input  logic [pipegs_pkg::TestEyesW-1:0]        test_eyes_i,  // of dopu_test; one eye: 0
  input  logic [pipegs_pkg::WorldW-1:0]         near_plane_i,
  input  logic [2*5*pipegs_pkg::PlaneBits-1:0]  planes_i,
  input  logic [StepW-1:0]                      near_step_i,  // of the near plane

  input  logic                                  node_valid_i,
  output logic                                  node_ready_o,
  input  pipegs_pkg::node_t                     node_i,
  input  logic                                  set_i,
  input  logic [BucketW-1:0]                    parent_i,
  input  logic                                  tight_i,      // with TightBoxes: what dopu_hull says of the node
  input  logic [pipegs_pkg::ScaleW-1:0]         scale_i,
  input  logic                                  last_i,       // these two go along
  input  logic [1:0]                            level_i,      // 1: a group, whose range may become its proxies'
  input  logic [StepW-1:0]                      lod_i,        // of the frame

  output logic                                  result_valid_o,
  output logic                                  result_pass_o,
  output logic                                  result_last_o,
  output logic [1:0]                            result_level_o,
  output logic [BucketW-1:0]                    result_bucket_o,
  output logic [LoadW-1:0]                      result_far_o,    // leading bits of the farthest corner's
  output logic [PlaceW-1:0]                     result_place_o,
  output logic [RangeW-1:0]                     result_range_o   // of a parent the children that are opened
);

  localparam int unsigned Tests = 3;
  localparam int unsigned NodeBits = pipegs_pkg::NodeBits;
  localparam int unsigned ExpW = pipegs_pkg::ExpW;
  localparam int unsigned DistanceW = 2 * pipegs_pkg::TestW + 2;
  localparam int unsigned SumW = StepW + 1;
  localparam int unsigned TagW = 3 + BucketW;  // what goes beside a node through its test

  logic [Tests-1:0]           ready, valid, pass;
  logic [TagW-1:0]            tag [Tests];
  logic [NodeBits-1:0]        node [Tests];
  logic signed [DistanceW-1:0] nearest [Tests];
  logic signed [DistanceW-1:0] farthest [Tests];
  logic [ExpW-1:0]            exponent [Tests];

  generate
    for (genvar t = 0; t < Tests; t += 1) begin : gen_tests
      dopu_test #(.TagW(TagW), .Phase(t)) u_test (
        .clk_i,
        .rst_ni,
        .awake_i,
        .position_i,
        .test_eyes_i,
        .near_plane_i,
        .planes_i,
        .node_valid_i,
        .node_ready_o(ready[t]),
        .node_i,
        .set_i,
        .tight_i,
        .scale_i,
        .tag_i({last_i, level_i, parent_i}),
        .result_valid_o(valid[t]),
        .result_pass_o(pass[t]),
        .result_node_o(node[t]),
        .result_tag_o(tag[t]),
        .result_nearest_o(nearest[t]),
        .result_farthest_o(farthest[t]),
        .result_exponent_o(exponent[t])
      );
    end
  endgenerate
  assign node_ready_o = ready != '0;  // one of them is

  // --- the result's bucket, one cycle later -------------------------------------------------------------------------
  typedef struct packed {
    logic               pass, last;
    logic [1:0]         level;
    logic [BucketW-1:0] bucket;
    logic [LoadW-1:0]   far_load;
    logic [PlaceW-1:0]  place;
    logic [RangeW-1:0]  range;
  } result_t;

  logic [1:0]                  which;
  logic                        valid_q, pass_q;
  logic [TagW-1:0]             tag_q;
  pipegs_pkg::node_t           tested;
  logic signed [DistanceW-1:0] nearest_q;
  logic [ExpW-1:0]             exponent_q;
  logic [StepW-1:0]            step;
  logic signed [SumW-1:0]      beyond;
  logic [BucketW-1:0]          parent, own;
  logic [PlaceW-1:0]           place_q;
  logic [RangeW-1:0]           range_q;
  result_t                     ranked, shown;  // shown: the range is that which is opened

  assign which  = valid[0] ? 2'd0 : valid[1] ? 2'd1 : 2'd2;
  assign tested = node[which];

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= 1'b0;
    else valid_q <= valid != '0;
  end
  always_ff @(posedge clk_i) begin
    pass_q     <= pass[which];
    tag_q      <= tag[which];
    nearest_q  <= nearest[which];
    exponent_q <= exponent[which];
    place_q    <= PlaceW'({tested.scale_max[pipegs_pkg::ScaleW-1:pipegs_pkg::ScaleMW], tested.offset_exp,
                           tested.center_z, tested.center_y, tested.center_x});
    range_q    <= tested[NodeBits-1 -: RangeW];
  end

  dopu_depth #(.ValueW(DistanceW), .Down(pipegs_pkg::RotF - (pipegs_pkg::RotW - pipegs_pkg::TestW))) u_depth (
    .value_i(nearest_q),
    .exponent_i(exponent_q),
    .step_o(step)
  );
  assign beyond = $signed({1'b0, step}) - $signed({1'b0, near_step_i});
  assign own    = beyond[SumW-1] ? '0 : beyond[SumW-2:BucketW] != '0 ? '1 : beyond[BucketW-1:0];

  assign {ranked.last, ranked.level, parent} = tag_q;
  assign ranked.pass                         = pass_q;
  assign ranked.bucket                       = own > parent ? own : parent;
  assign ranked.place                        = place_q;
  assign ranked.range                        = range_q;

  if (pipegs_pkg::HasWalks) begin : gen_far
    logic signed [DistanceW-1:0] farthest_q;
    logic [StepW-1:0]            far_step;
    logic signed [SumW-1:0]      far_beyond;
    logic [BucketW-1:0]          far;
    always_ff @(posedge clk_i) farthest_q <= farthest[which];
    dopu_depth #(.ValueW(DistanceW), .Down(pipegs_pkg::RotF - (pipegs_pkg::RotW - pipegs_pkg::TestW))) u_far (
      .value_i(farthest_q),
      .exponent_i(exponent_q),
      .step_o(far_step)
    );
    assign far_beyond      = $signed({1'b0, far_step}) - $signed({1'b0, near_step_i});
    assign far             = far_beyond[SumW-1] ? '0 : far_beyond[SumW-2:BucketW] != '0 ? '1 : far_beyond[BucketW-1:0];
    assign ranked.far_load = far[BucketW-1 -: LoadW];
    logic unused_far;
    assign unused_far      = ^far;
  end else begin : gen_no_far
    assign ranked.far_load = '0;
    logic unused_farthest;
    assign unused_farthest = ^farthest[0] ^ ^farthest[1] ^ ^farthest[2];
  end

  // --- which children are opened, with proxies another cycle later --------------------------------------------------
  if (pipegs_pkg::Lod == 1) begin : gen_lod
    result_t           ranked_q;
    logic              ranked_valid_q;
    logic [RangeW-1:0] group_range;

    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) ranked_valid_q <= 1'b0;
      else ranked_valid_q <= valid_q;
    end
    always_ff @(posedge clk_i) ranked_q <= ranked;

    dopu_lod u_lod (
      .lod_i,
      .near_step_i,
      .range_i(ranked_q.range),
      .bucket_i(ranked_q.bucket),
      .range_o(group_range)
    );
    always_comb begin
      shown = ranked_q;
      if (ranked_q.level == 2'd1) shown.range = group_range;
    end
    assign result_valid_o = ranked_valid_q;
  end else begin : gen_no_lod
    assign shown          = ranked;
    assign result_valid_o = valid_q;
    logic unused_lod;
    assign unused_lod     = ^lod_i;
  end
  assign {result_pass_o, result_last_o, result_level_o, result_bucket_o, result_far_o, result_place_o, result_range_o} =
         shown;

  logic unused_node;  // what only the test needs
  assign unused_node = ^tested;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert ($onehot(ready));
  always_ff @(posedge clk_i) if (rst_ni) assert ($onehot0(valid));
`endif

endmodule
