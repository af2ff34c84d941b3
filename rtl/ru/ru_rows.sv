// SPDX-License-Identifier: Apache-2.0
// ru_rows: turns each splat into the lines of alphas of the regions that this RU owns, nearest splat first.
//
// Paper   Eq. 3, Fig. 5a; the paper's Row Units stand in the PU. Here they stand behind the sort, so nothing is
//         computed for regions that nearer splats have closed, and no alpha is ever stored.
// Idea    Owned regions that are still open make a job for the same Row Units as in pu_cache; the colour waits in a
//         queue beside them with the mask, so that the last line of a splat is known. The lanes hold a line while they
//         blend it, so two lines wait in a queue, or the Row Units would stand still meanwhile. The done mask is not
//         looked at while an earlier window is still being blended.
// Stream  sorted_t in; blend_t with its line of alphas beside it out; end beats pass in order.
// Pace    One region per 8 / PixelsPerRow cycles; a splat without an open region takes one cycle.
// Model   cpp_model/pu/rows/pu_rows.hpp, ru_own_mask in cpp_model/ru/ru_walk.hpp

module ru_rows #(
  parameter int unsigned EndsMax = 16,  // windows that may end between here and the lanes
  localparam int unsigned EndsW  = $clog2(EndsMax + 1),
  localparam int unsigned LineW  = pipegs_pkg::LineW
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
  output pipegs_pkg::blend_t             out_o,
  output logic [LineW-1:0]               out_line_o,

  output logic                           idle_o
);

  localparam int unsigned Regions = pipegs_pkg::Regions;
  localparam int unsigned ColorW  = pipegs_pkg::ColorW;
  localparam int unsigned TagW    = Regions + 3 * ColorW;  // {blue, green, red, mask}
  localparam int unsigned TagDepth = 8;                    // more jobs than the Row Units' pipeline holds

  logic [Regions-1:0]    own, live, tag_mask, above;
  logic                  splat_valid_q, is_data, drop, offer, leave, window_end;
  pipegs_pkg::sorted_t   splat_q;
  logic [EndsW-1:0]      ends_q;      // window ends that passed here and not yet the lanes
  logic                  job_valid, job_ready, tag_room, tag_valid, tag_pop, rows_active;
  pipegs_pkg::row_job_t  job;
  localparam int unsigned LinesDepth = pipegs_pkg::RuRowLines;
  logic                  made_valid, made_ready, lines_valid;
  logic [LineW-1:0]      made_line;
  pipegs_pkg::alphas_t   made, alphas;
  logic [$clog2(LinesDepth+1)-1:0] lines_count;
  typedef struct packed {logic [ColorW-1:0] blue, green, red;} color_t;
  color_t                tag_color;
  logic [$clog2(TagDepth+1)-1:0] tag_count;

  ru_own u_own (
    .unit_i,
    .own_o(own)
  );

  assign live       = ends_q == '0 ? splat_q.mask & own & ~done_i : splat_q.mask & own;
  assign is_data    = splat_q.kind == pipegs_pkg::KindData;
  assign drop       = splat_valid_q && is_data && live == '0;
  assign offer      = splat_valid_q && !drop && (!is_data || tag_room);
  assign job_valid  = offer;
  assign leave      = drop || (offer && job_ready);
  assign in_ready_o = !splat_valid_q || leave;
  assign window_end = offer && job_ready && splat_q.kind == pipegs_pkg::KindWindowEnd;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      splat_valid_q <= 1'b0;
      ends_q        <= '0;
    end else begin
      if (in_ready_o) splat_valid_q <= in_valid_i;
      if (window_end && !window_done_i) ends_q <= ends_q + 1'b1;
      if (window_done_i && !window_end) ends_q <= ends_q - 1'b1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (in_valid_i && in_ready_o) splat_q <= in_i;
  end

  always_comb begin
    job.kind    = splat_q.kind;
    job.a       = splat_q.a;
    job.b       = splat_q.b;
    job.c       = splat_q.c;
    job.d       = splat_q.d;
    job.e       = splat_q.e;
    job.f       = splat_q.f;
    job.mask    = live;
    job.address = '0;
    job.ext     = 1'b0;
    job.index   = splat_q.index;
  end

  pipegs_fifo #(.DataW(TagW), .Depth(TagDepth)) u_tags (
    .clk_i,
    .rst_ni,
    .in_valid_i(offer && job_ready && is_data),
    .in_ready_o(tag_room),
    .in_i({splat_q.blue, splat_q.green, splat_q.red, live}),
    .out_valid_o(tag_valid),
    .out_ready_i(tag_pop),
    .out_o({tag_color, tag_mask}),
    .count_o(tag_count)
  );

  pu_rows u_rows (
    .clk_i,
    .rst_ni,
    .row_job_valid_i(job_valid),
    .row_job_ready_o(job_ready),
    .row_job_i(job),
    .alphas_valid_o(made_valid),
    .alphas_ready_i(made_ready),
    .alphas_o(made),
    .line_o(made_line),
    .active_o(rows_active)
  );

  pipegs_fifo #(.DataW(pipegs_pkg::AlphasBits + LineW), .Depth(LinesDepth)) u_lines (
    .clk_i,
    .rst_ni,
    .in_valid_i(made_valid),
    .in_ready_o(made_ready),
    .in_i({made, made_line}),
    .out_valid_o(lines_valid),
    .out_ready_i(out_ready_i),
    .out_o({alphas, out_line_o}),
    .count_o(lines_count)
  );
  assign out_valid_o = lines_valid;

  // Regions come lowest first: the last one has none above it.
  assign above   = tag_mask & ~((Regions'(2) << alphas.region) - Regions'(1));
  assign tag_pop = out_valid_o && out_ready_i && alphas.kind == pipegs_pkg::KindData && above == '0;

  always_comb begin
    out_o.kind   = alphas.kind;
    out_o.region = alphas.region;
    out_o.ext    = 1'b0;
    out_o.red    = tag_color.red;
    out_o.green  = tag_color.green;
    out_o.blue   = tag_color.blue;
    out_o.index  = alphas.index;
  end

  assign idle_o = !splat_valid_q && !rows_active && lines_count == '0;

  logic unused_fields;
  assign unused_fields = &{1'b0, splat_q.depth, alphas.address, alphas.ext, tag_valid, tag_count};

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!(out_valid_o && alphas.kind == pipegs_pkg::KindData) || tag_valid)
    else $error("ru_rows: a line without its colour");
  always_ff @(posedge clk_i) if (rst_ni) assert (!window_done_i || ends_q != '0)
    else $error("ru_rows: a window ended that never came");
  // An end has no colour and no line: what stands there is that of the splat behind it, as soon as it comes.
  localparam int unsigned BeatW = $bits({out_o, out_line_o});
  pipegs_stream_check #(.DataW($bits(out_o.kind) + BeatW)) u_check_out (
    .clk_i,
    .rst_ni,
    .valid_i(out_valid_o),
    .ready_i(out_ready_i),
    .beat_i({out_o.kind, out_o.kind == pipegs_pkg::KindData ? {out_o, out_line_o} : BeatW'(0)})
  );
`endif

endmodule
