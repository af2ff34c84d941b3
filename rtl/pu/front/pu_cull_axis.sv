// SPDX-License-Identifier: Apache-2.0
// pu_cull_axis: along one axis, whether a Gaussian reaches between the two sides of a walk, and its gap to them.
//
// Paper   Sec. 4.2, frustum culling of the preprocessing.
// Idea    It touches iff focal c - a z + reach s >= 0 at the near side a (left, upper) and focal c - b z - reach s <= 0
//         at the far one. What was cut off c and z is slack on either side. With Occlusion each region that is closed
//         at a side moves it inwards by 8 pixels times z; at the near one that is taken off the slack.
// Stream  Beside stages 5 to 8 of pu_cull: a port's number is that of pu_cull's register it comes from. c, z, s have a
//         common exponent, a and b the unit 2^-EdgeF pixel. touch is of register 7; gap too: focal c - b z or a z -
//         focal c, without reach and what is closed, floored to 2^-EdgeF.
// Pace    pu_cull's: a Gaussian a cycle; its registers are clocked when pu_cull's are.
// Model   cpp_model/pu/front/pu_cull.hpp

module pu_cull_axis #(
  parameter int unsigned EdgeF = 4,
  parameter int unsigned Span  = 2097,  // of a window with its margins
  parameter int unsigned SpanW = 30     // of a span times z
) (
  input  logic                                  clk_i,
  input  logic [2:0]                            load_i,  // registers 5 to 7

  input  logic [pipegs_pkg::FocalW-1:0]         focal_i,  // the lens
  input  logic signed [pipegs_pkg::CenterW-1:0] center_i,
  input  logic [pipegs_pkg::ReachW-1:0]         reach_i,
  input  logic [pipegs_pkg::WindowW-1:0]        first_i,  // lists: of the frame's windows
  input  logic [pipegs_pkg::WindowW-1:0]        last_i,

  input  logic [pipegs_pkg::WindowW-1:0]        window4_i,
  input  logic                                  behind4_i,  // the walk begins in the window's middle
  input  logic [pipegs_pkg::ClosedW-1:0]        closed_near4_i,
  input  logic [pipegs_pkg::ClosedW-1:0]        closed_far4_i,
  input  logic signed [pipegs_pkg::CutW-1:0]    c6_i,
  input  logic signed [pipegs_pkg::CutW-1:0]    z6_i,
  input  logic [pipegs_pkg::CutW-1:0]           s6_i,
  input  logic                                  part6_i,  // the walk has half the window's side
  input  logic signed [SpanW-1:0]               span7_i,  // without lists: the walk's, times z

  output logic                                  touch_o,
  output logic signed [pipegs_pkg::GapW-1:0]    gap_o  // with TightCull, else 0
);

  localparam int unsigned CutW    = pipegs_pkg::CutW;
  localparam int unsigned FocalW  = pipegs_pkg::FocalW;
  localparam int unsigned CenterW = pipegs_pkg::CenterW;
  localparam int unsigned ReachW  = pipegs_pkg::ReachW;
  localparam int unsigned WindowW = pipegs_pkg::WindowW;
  localparam int unsigned ClosedW = pipegs_pkg::ClosedW;
  localparam int unsigned Margin  = pipegs_pkg::ReachMargin;
  localparam int unsigned WideF   = $clog2(pipegs_pkg::Window) + EdgeF;  // of a window's side
  localparam int unsigned EdgeW   = WindowW + WideF + 2;
  localparam int unsigned ToEdge  = pipegs_pkg::FocalF - EdgeF;
  localparam int unsigned AsideW  = (FocalW > EdgeW + ToEdge ? FocalW : EdgeW + ToEdge) + 2;
  localparam int unsigned SideW   = (FocalW > ReachW ? FocalW : ReachW) + CutW + 3;
  localparam int unsigned Coarse  = 8;  // low bits of reach that are rounded up
  localparam int unsigned SmallW  = ReachW - Coarse + 1;

  // --- stages 5 and 6: the near side; from it the far one ----------------------------------------------------------
  logic signed [EdgeW-1:0]   edge5_q, edge6_q, far6;
  logic signed [CenterW:0]   center;
  assign center = (CenterW + 1)'(center_i);
  always_ff @(posedge clk_i) begin
    // -ceil(center) = floor(-center).
    if (load_i[0]) edge5_q <= $signed(EdgeW'({window4_i, behind4_i}) << (WideF - 1)) - EdgeW'(Margin << EdgeF) +
                              EdgeW'((-center) >>> (pipegs_pkg::CenterF - EdgeF));
    if (load_i[1]) edge6_q <= edge5_q;
  end

  // --- stage 7: products, and the slack of what the cutting of c and z may have taken away -------------------------
  logic signed [SideW-1:0]  focal7_q, edge7_q, reach7_q, far7;  // the far side times z
  logic signed [AsideW-1:0] near_slack6, near_slack7_q, far_slack7_q;
  logic [SmallW-1:0]        reach;
  assign reach       = SmallW'(reach_i[ReachW-1:Coarse]) + SmallW'(reach_i[Coarse-1:0] != '0);
  assign near_slack6 = $signed(AsideW'(focal_i)) - (edge6_q < 0 ? AsideW'(edge6_q) <<< ToEdge : '0);
  always_ff @(posedge clk_i) begin
    if (load_i[2]) begin
      near_slack7_q <= near_slack6;
      far_slack7_q  <= far6 > 0 ? AsideW'(far6) <<< ToEdge : '0;
      focal7_q <= $signed(SideW'(focal_i)) * SideW'(c6_i);
      edge7_q  <= SideW'(edge6_q) * SideW'(z6_i);
      reach7_q <= $signed(SideW'(reach)) * $signed(SideW'(s6_i));
    end
  end

  if (pipegs_pkg::HasLists) begin : gen_frame  // that of all windows: one more product
    logic [WindowW-1:0]      more;  // windows behind the first one
    logic signed [EdgeW-1:0] far6_q;
    logic signed [SideW-1:0] far7_q;
    assign more = last_i - first_i;
    always_ff @(posedge clk_i) begin
      if (load_i[1]) far6_q <= edge5_q + EdgeW'(Span) + $signed(EdgeW'(more) << WideF);
      if (load_i[2]) far7_q <= SideW'(far6_q) * SideW'(z6_i);
    end
    assign far6 = far6_q;
    assign far7 = far7_q;
    logic unused_walk;
    assign unused_walk = ^{part6_i, span7_i};
  end else begin : gen_window
    assign far6 = edge6_q + EdgeW'(Span) - (part6_i ? EdgeW'(64'd1 << (WideF - 1)) : '0);
    assign far7 = edge7_q + SideW'(span7_i);
    logic unused_windows;
    assign unused_windows = ^{first_i, last_i};
  end

  // --- stage 8: both lines are 0 or more exactly when it touches ---------------------------------------------------
  logic signed [SideW-1:0] open_slack7, open_far7, low, high;
  if (pipegs_pkg::Occlusion != 0) begin : gen_open
    localparam int unsigned RegionF = 3 + EdgeF;  // of a region's side
    logic [ClosedW-1:0]      closed_near5_q, closed_near6_q, closed_far5_q, closed_far6_q;
    logic signed [SideW-1:0] open_slack7_q, closed7_q;
    function automatic logic signed [SideW-1:0] aside(input logic [ClosedW-1:0] regions,
                                                      input logic signed [CutW-1:0] z);
      aside = ($signed(SideW'(regions)) * SideW'(z)) <<< RegionF;
    endfunction
    always_ff @(posedge clk_i) begin
      if (load_i[0]) {closed_near5_q, closed_far5_q} <= {closed_near4_i, closed_far4_i};
      if (load_i[1]) {closed_near6_q, closed_far6_q} <= {closed_near5_q, closed_far5_q};
      if (load_i[2]) begin
        open_slack7_q <= SideW'(near_slack6) - (aside(closed_near6_q, z6_i) <<< ToEdge);
        closed7_q     <= aside(closed_far6_q, z6_i);
      end
    end
    assign open_slack7 = open_slack7_q;
    assign open_far7   = far7 - closed7_q;
  end else begin : gen_walk_alone
    assign open_slack7 = SideW'(near_slack7_q);
    assign open_far7   = far7;
    logic unused_closed;
    assign unused_closed = ^{closed_near4_i, closed_far4_i};
  end
  assign low     = focal7_q + open_slack7 - (edge7_q <<< ToEdge) + (reach7_q <<< Coarse);
  assign high    = focal7_q - (open_far7 <<< ToEdge) - (reach7_q <<< Coarse) - SideW'(far_slack7_q);
  assign touch_o = low >= 0 && high <= 0;

  // --- beside it: on one side at most the mean is beyond -----------------------------------------------------------
  if (pipegs_pkg::TightCull != 0) begin : gen_gap
    logic signed [SideW-1:0] gap_low, gap_high, gap;
    assign gap_low  = (edge7_q <<< ToEdge) - focal7_q - SideW'(near_slack7_q);
    assign gap_high = focal7_q - (far7 <<< ToEdge) - SideW'(far_slack7_q);
    assign gap      = gap_low > 0 ? gap_low : gap_high;
    assign gap_o    = pipegs_pkg::GapW'(gap >>> ToEdge);
  end else begin : gen_no_gap
    assign gap_o = '0;
    logic unused_slack;
    assign unused_slack = ^near_slack7_q;
  end

endmodule
