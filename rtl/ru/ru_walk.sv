// SPDX-License-Identifier: Apache-2.0
// ru_walk: walks the regions of each splat that this RU owns, nearest splat first, and finds the line of their alphas.
//
// Paper   Sec. 4: Gaussians are blended in sorted order, region by region of a tile's bitmap.
// Idea    The lowest bit of the remaining mask is the next region, x & -x; its line is the splat's first line plus the
//         number of lower bits in the whole mask. Regions that are done need no line: skipping them saves work and
//         never changes a pixel. Where their lines lie in an alpha store these are free then (skip). The done mask is
//         not looked at while an earlier window is still being blended.
// Stream  sorted_t in, one fetch_t for each region; end beats pass in order.
// Pace    One region per cycle; a splat with nothing to fetch or to free takes one cycle. Latency three cycles.
// Model   cpp_model/ru/ru_walk.hpp

module ru_walk #(
  parameter int unsigned EndsMax = 64,  // windows that may end between here and the lanes
  localparam int unsigned EndsW = $clog2(EndsMax + 1)
) (
  input  logic                           clk_i,
  input  logic                           rst_ni,
  input  logic [pipegs_pkg::UnitW-1:0]   unit_i,

  input  logic [pipegs_pkg::Regions-1:0] done_i,         // of the window that the lanes are in
  input  logic                           window_done_i,  // the lanes leave their window

  input  logic                           in_valid_i,
  output logic                           in_ready_o,
  input  pipegs_pkg::sorted_t            in_i,

  output logic                           out_valid_o,
  input  logic                           out_ready_i,
  output pipegs_pkg::fetch_t             out_o,

  output logic                           idle_o
);

  localparam int unsigned Regions = pipegs_pkg::Regions;
  localparam int unsigned RegionW = pipegs_pkg::RegionW;
  localparam int unsigned AlphaAddressW = pipegs_pkg::AlphaAddressW;

  logic [Regions-1:0]  own, live, walked, lowest, others;
  logic                splat_valid_q, pick_valid_q, out_valid_q;
  pipegs_pkg::sorted_t splat_q;
  logic [Regions-1:0]  rest_q;      // owned regions of the splat that were not walked yet
  logic [Regions-1:0]  below_q;     // regions of the splat before the picked one
  pipegs_pkg::fetch_t  pick_q, out_q;
  logic [EndsW-1:0]    ends_q;      // window ends that passed here and not yet the lanes
  logic                is_data, emit, leave, window_end, pick_free, out_free;

  logic [RegionW-1:0]  lowest_number;
  logic [RegionW:0]    below_count;

  ru_own u_own (
    .unit_i,
    .own_o(own)
  );
  pipegs_first_set #(.DataW(Regions)) u_lowest (
    .mask_i(walked),
    .one_hot_o(lowest),
    .number_o(lowest_number)
  );
  ru_count u_count (
    .mask_i(below_q),
    .count_o(below_count)
  );

  assign live       = ends_q == '0 ? rest_q & ~done_i : rest_q;
  assign walked     = pipegs_pkg::HasStores && !splat_q.ext ? rest_q : live;
  assign others     = walked & ~lowest;
  assign is_data    = splat_q.kind == pipegs_pkg::KindData;
  assign out_free   = !out_valid_q || out_ready_i;
  assign pick_free  = !pick_valid_q || out_free;
  assign emit       = splat_valid_q && (!is_data || walked != '0) && pick_free;
  assign leave      = splat_valid_q && (is_data ? walked == '0 || (others == '0 && pick_free) : pick_free);
  assign window_end = emit && splat_q.kind == pipegs_pkg::KindWindowEnd;

  assign in_ready_o  = !splat_valid_q || leave;
  assign out_valid_o = out_valid_q;
  assign out_o       = out_q;
  assign idle_o      = !splat_valid_q && !pick_valid_q && !out_valid_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      splat_valid_q <= 1'b0;
      pick_valid_q  <= 1'b0;
      out_valid_q   <= 1'b0;
      ends_q        <= '0;
    end else begin
      if (in_ready_o) splat_valid_q <= in_valid_i;
      if (pick_free) pick_valid_q <= emit;
      if (out_free) out_valid_q <= pick_valid_q;
      if (window_end && !window_done_i) ends_q <= ends_q + 1'b1;
      if (window_done_i && !window_end) ends_q <= ends_q - 1'b1;
    end
  end

  always_ff @(posedge clk_i) begin
    if (in_valid_i && in_ready_o) begin
      splat_q <= in_i;
      rest_q  <= in_i.mask & own;
    end else if (emit) begin
      rest_q <= others;
    end
    if (emit) begin
      below_q        <= splat_q.mask & (lowest - 1'b1);
      pick_q.kind    <= splat_q.kind;
      pick_q.region  <= lowest_number;
      pick_q.address <= splat_q.address;
      pick_q.ext     <= splat_q.ext;
      pick_q.skip    <= is_data && (lowest & live) == '0;
      pick_q.unit    <= splat_q.unit;
      pick_q.red     <= splat_q.red;
      pick_q.green   <= splat_q.green;
      pick_q.blue    <= splat_q.blue;
      pick_q.index   <= splat_q.index;
    end
    if (out_free && pick_valid_q) begin
      out_q         <= pick_q;
      out_q.address <= pick_q.address + AlphaAddressW'(below_count);
    end
  end

  logic unused_depth;
  assign unused_depth = &{1'b0, splat_q.depth};

`ifndef SYNTHESIS
  assert property (@(posedge clk_i) disable iff (!rst_ni) out_valid_o && !out_ready_i |=> out_valid_o && $stable(out_o))
    else $error("ru_walk: a beat changed before it was taken");
  always_ff @(posedge clk_i) if (rst_ni) assert (!window_done_i || ends_q != '0)
    else $error("ru_walk: a window ended that never came");
  pipegs_stream_check #(.DataW($bits(out_o)), .Proven(1)) u_check_out (
    .clk_i,
    .rst_ni,
    .valid_i(out_valid_o),
    .ready_i(out_ready_i),
    .beat_i(out_o)
  );
`endif

endmodule
