// SPDX-License-Identifier: Apache-2.0
// pu_late: the back of a PU that caches coefficients: a splat takes A to F along, the Row Units stand in the RUs.
//
// Paper   Eq. 3; the paper caches alphas (pu_cache). Coefficients take 28 bytes a Gaussian and window instead of 64 a
//         region, and regions that close before the Gaussian's turn are never computed.
// Idea    Regions that are done leave the mask; a Gaussian without regions is dropped. Mask and coefficients wait in a
//         queue beside the colour; both make the splat. With parts a Gaussian comes once for each: it asks for its
//         colour with the first and keeps it for the others.
// Stream  tiles in; splat out, in order; one port to external memory. Ends pass behind the splats before them.
// Pace    One Gaussian per cycle; the colour sets the pace.
// Model   preprocess() in cpp_model/golden.cpp

module pu_late #(
  localparam int unsigned Units    = pipegs_pkg::Units,
  localparam int unsigned AddressW = pipegs_pkg::AddressW,
  localparam int unsigned MemoryW  = pipegs_pkg::MemoryW
) (
  input  logic                                 clk_i,
  input  logic                                 rst_ni,
  input  pipegs_pkg::rotation_t                rotation_i,
  input  pipegs_pkg::span_t                    colors_i,     // the SH coefficients
  input  logic [pipegs_pkg::KindW-1:0]         sh_degree_i,  // of the scene
  input  pipegs_pkg::windows_t                 windows_i,
  input  logic                                 restart_i,   // a frame begins; the PU is empty

  input  logic                                 tiles_valid_i,
  output logic                                 tiles_ready_o,
  input  pipegs_pkg::tiles_t                   tiles_i,
  input  pipegs_pkg::parted_t                  parted_i,    // of the Gaussian in tiles_i

  input  logic [Units*pipegs_pkg::Regions-1:0] done_i,      // from the RUs
  input  logic [Units*pipegs_pkg::WindowW-1:0] done_x_i,
  input  logic [Units*pipegs_pkg::WindowW-1:0] done_y_i,

  output logic                                 color_valid_o,  // SH coefficients
  input  logic                                 color_ready_i,
  output logic [AddressW-1:0]                  color_address_o,
  output logic [pipegs_pkg::HalvesW-1:0]       color_halves_o,
  input  logic                                 color_rsp_valid_i,
  input  logic [MemoryW-1:0]                   rsp_data_i,

  output logic                                 splat_valid_o,
  input  logic                                 splat_ready_i,
  output pipegs_pkg::splat_t                   splat_o,

  output logic                                 bad_o,            // see pu_color_fetch
  output logic [AddressW-1:0]                  bad_line_o,
  output logic                                 moved_o,          // a beat moved inside
  output logic                                 busy_o,           // something is inside
  output logic                                 color_busy_o,
  output logic                                 color_waiting_o   // a colour waits for its coefficients
);

  localparam int unsigned Regions = pipegs_pkg::Regions;
  localparam int unsigned MaskW   = pipegs_pkg::MaskW;
  localparam int unsigned AW      = pipegs_pkg::AW;
  localparam int unsigned BcW     = pipegs_pkg::BcW;
  localparam int unsigned DefW    = pipegs_pkg::DefW;
  localparam int unsigned SplatW  = MaskW + AW + 2 * BcW + 3 * DefW;
  localparam int unsigned QueuedW = SplatW + (pipegs_pkg::Parts > 1 ? 1 + pipegs_pkg::PartW : 0);
  localparam int unsigned Depth   = pipegs_pkg::LateDepth;

  logic                   valid_q, is_end, drop, take, leave, window_end, again;
  pipegs_pkg::tiles_t     tiles_q;
  pipegs_pkg::parted_t    parted_q;
  pipegs_pkg::payload_t   payload;
  logic [Regions-1:0]     done;
  logic [MaskW-1:0]       part_done;
  logic                   job_valid, job_ready, queued_room, queued_valid;
  logic                   colored_valid, colored_ready;
  pipegs_pkg::color_job_t job;
  pipegs_pkg::colored_t   colored, shown;  // shown: of the splat
  logic [SplatW-1:0]      made;
  logic [QueuedW-1:0]     queued_in, queued;
  logic [$clog2(Depth+1)-1:0] count;

  pu_done u_done (
    .clk_i,
    .rst_ni,
    .windows_i,
    .restart_i,
    .advance_i(window_end),
    .done_i,
    .done_x_i,
    .done_y_i,
    .done_o(done)
  );

  assign is_end        = tiles_q.kind != pipegs_pkg::KindData;
  assign drop          = valid_q && !is_end && tiles_q.mask == '0;
  assign job_valid     = valid_q && !drop && !again && queued_room;
  assign leave         = drop || (job_valid && job_ready) || (valid_q && again && queued_room);
  assign tiles_ready_o = !valid_q || leave;
  assign take          = tiles_valid_i && tiles_ready_o;
  assign window_end    = take && tiles_i.kind == pipegs_pkg::KindWindowEnd;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= 1'b0;
    else if (tiles_ready_o) valid_q <= tiles_valid_i;
  end
  always_ff @(posedge clk_i) begin
    if (take) begin
      tiles_q      <= tiles_i;
      tiles_q.mask <= tiles_i.mask & ~part_done;
      parted_q     <= parted_i;
    end
  end

  assign payload = parted_q.payload;
  always_comb begin
    job.kind    = tiles_q.kind;
    job.depth   = payload.depth;
    job.index   = pipegs_pkg::SplatIndexW'(payload.index);
    job.slot    = payload.slot;
    job.mask    = tiles_q.mask;
    job.address = '0;
    job.ext     = 1'b0;
    job.dir_x   = payload.dir_x;
    job.dir_y   = payload.dir_y;
    job.dir_z   = payload.dir_z;
    job.base_r  = payload.base_r;
    job.base_g  = payload.base_g;
    job.base_b  = payload.base_b;
  end

  pipegs_pkg::splat_t sent;  // all but the part
  assign made = {tiles_q.mask, tiles_q.f, tiles_q.e, tiles_q.d, tiles_q.c, tiles_q.b, tiles_q.a};

  // --- parts of one Gaussian share its colour ------------------------------------------------------------------------
  if (pipegs_pkg::Parts > 1) begin : gen_parts
    localparam int unsigned SlotW = pipegs_pkg::SlotW;
    logic                 asked_q, held;  // asked: for the colour of the Gaussian in last_q
    logic [SlotW-1:0]     last_q;
    pipegs_pkg::colored_t held_q;

    assign part_done = done[parted_i.part*MaskW +: MaskW];
    assign again     = asked_q && !drop && !is_end && payload.slot == last_q;
    assign queued_in = {again, parted_q.part, made};
    assign held          = queued[QueuedW-1];
    assign splat_valid_o = queued_valid && (held || colored_valid);
    assign colored_ready = queued_valid && !held && splat_ready_i;
    assign shown         = held ? held_q : colored;
    always_comb begin
      splat_o      = sent;
      splat_o.part = queued[SplatW +: pipegs_pkg::PartW];
    end
    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) asked_q <= 1'b0;
      else if (leave && !drop) asked_q <= !is_end;
    end
    always_ff @(posedge clk_i) begin
      if (leave && !drop) last_q <= payload.slot;
      if (colored_valid && colored_ready) held_q <= colored;
    end
  end else begin : gen_whole
    assign part_done     = done;
    assign again         = 1'b0;
    assign queued_in     = made;
    assign splat_valid_o = queued_valid && colored_valid;
    assign colored_ready = queued_valid && splat_ready_i;
    assign shown         = colored;
    assign splat_o       = sent;
  end

  pipegs_sram_fifo #(.DataW(QueuedW), .Depth(Depth)) u_coeffs (
    .clk_i,
    .rst_ni,
    .in_valid_i(leave && !drop),
    .in_ready_o(queued_room),
    .in_i(queued_in),
    .out_valid_o(queued_valid),
    .out_ready_i(splat_valid_o && splat_ready_i),
    .out_o(queued),
    .count_o(count)
  );

  pu_color u_color (
    .clk_i,
    .rst_ni,
    .rotation_i,
    .colors_i,
    .sh_degree_i,
    .job_valid_i(job_valid),
    .job_ready_o(job_ready),
    .job_i(job),
    .mem_valid_o(color_valid_o),
    .mem_ready_i(color_ready_i),
    .mem_address_o(color_address_o),
    .mem_halves_o(color_halves_o),
    .rsp_valid_i(color_rsp_valid_i),
    .rsp_data_i,
    .colored_valid_o(colored_valid),
    .colored_ready_i(colored_ready),
    .colored_o(colored),
    .bad_o,
    .bad_line_o,
    .busy_o(color_busy_o),
    .waiting_memory_o(color_waiting_o)
  );

  always_comb begin
    sent       = '0;
    sent.kind  = shown.kind;
    sent.depth = shown.depth;
    sent.index = shown.index;
    sent.red   = shown.red;
    sent.green = shown.green;
    sent.blue  = shown.blue;
    {sent.mask, sent.f, sent.e, sent.d, sent.c, sent.b, sent.a} = queued[SplatW-1:0];
  end

  assign moved_o = take || leave || (splat_valid_o && splat_ready_i);
  assign busy_o  = valid_q || color_busy_o || count != '0;

  logic unused_in;
  assign unused_in = &{1'b0, payload, shown, queued, count};

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits(splat_o))) u_check_splat (
    .clk_i,
    .rst_ni,
    .valid_i(splat_valid_o),
    .ready_i(splat_ready_i),
    .beat_i(splat_o)
  );
  pipegs_stream_check #(.DataW($bits(job))) u_check_job (
    .clk_i,
    .rst_ni,
    .valid_i(job_valid),
    .ready_i(job_ready),
    .beat_i(job)
  );
`endif

endmodule
