// SPDX-License-Identifier: Apache-2.0
// pu_allocate: gives each Gaussian of a window its lines in the alpha store, and nothing to regions that are opaque.
//
// Paper   "cache the alphas" (Sec. 3); the paper does not say where: docs/units/pu.md.
// Idea    n regions take n slots of the lane's alpha store, and n addresses in a row, if the lines of their own layer
//         leave room for them, waiting until older ones have left it: a slot is free when its line was read
//         (line_free_i), addresses are a layer at a time. Otherwise they take lines in memory (Overflow 0: there is
//         always room), in one of two areas that the layers with lines there use in turn; pu_spill knows their size. So
//         where a line lies depends on the stream only, not on timing.
// Stream  tiles in; row_job and color_job out (each taken by itself), or nothing when no region is left. Ends pass.
//         At most AlphaLayers live: behind the end of that many, beats wait for layer_free_i.
// Pace    One Gaussian per four cycles (take, count, decide, offer).
// Model   cpp_model/pu/rows/pu_allocate.hpp

module pu_allocate #(
  localparam int unsigned Units   = pipegs_pkg::Units,
  localparam int unsigned Regions = pipegs_pkg::Regions,
  localparam int unsigned WindowW = pipegs_pkg::WindowW,
  localparam int unsigned CountW  = pipegs_pkg::RegionW + 1
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  pipegs_pkg::windows_t     windows_i,
  input  logic                     restart_i,  // a frame begins; the PU is empty

  input  logic                     tiles_valid_i,
  output logic                     tiles_ready_o,
  input  pipegs_pkg::tiles_t       tiles_i,
  input  pipegs_pkg::payload_t     payload_i,  // of the Gaussian in tiles_i

  output logic                     row_job_valid_o,
  input  logic                     row_job_ready_i,
  output pipegs_pkg::row_job_t     row_job_o,

  output logic                     color_job_valid_o,
  input  logic                     color_job_ready_i,
  output pipegs_pkg::color_job_t   color_job_o,

  input  logic [Units*Regions-1:0] done_i,    // RU j: its opaque regions of window done_x, done_y
  input  logic [Units*WindowW-1:0] done_x_i,
  input  logic [Units*WindowW-1:0] done_y_i,
  input  logic                     line_free_i,   // a line of the store was read, or nobody needs it any more
  input  logic                     layer_free_i,  // all RUs have finished the oldest layer

  output logic [CountW-1:0]        overflowed_o,  // lines sent to the overflow area in this cycle
  output logic                     waiting_o,     // for older layers (pipegs_perf: blocked)
  output logic                     active_o       // needs a clock
);

  localparam int unsigned AlphaAddressW = pipegs_pkg::AlphaAddressW;
  localparam int unsigned LinesW   = $clog2(pipegs_pkg::AlphaLines + 1);
  localparam int unsigned HeadW    = $clog2(pipegs_pkg::AlphaAddresses);
  localparam int unsigned SumW     = (HeadW > CountW ? HeadW : CountW) + 2;
  localparam int unsigned Layers   = pipegs_pkg::AlphaLayers;
  localparam int unsigned EndedW   = $clog2(Layers + 1);

  typedef enum logic [1:0] {
    StateTake,    // waits for a beat (and for a free pulse while AlphaLayers have ended)
    StateCount,   // regions left
    StateDecide,  // store or overflow; waits for older layers
    StateOffer    // waits until both outputs have taken it
  } state_e;

  state_e                     state_q;
  pipegs_pkg::tiles_t         tiles_q;
  pipegs_pkg::payload_t       payload_q;
  logic [CountW-1:0]          count_q;
  logic [AlphaAddressW-1:0]   address_q;
  logic                       ext_q;
  logic                       row_valid_q, color_valid_q;

  logic [Regions-1:0]         done;

  logic [EndedW-1:0]          ended_q;           // layers that ended here and are not free yet
  logic [LinesW-1:0]          lines_q [Layers];  // of each the lines that it had in the store, the oldest one's first
  logic [Layers-1:0]          spilled_q;         // of each whether it has an overflow area
  logic [LinesW-1:0]          own_q;             // lines of the present layer in the store
  logic                       own_spilled_q;
  logic [LinesW-1:0]          used_q;            // slots that are not free
  logic [HeadW:0]             held_q;            // addresses that are not
  logic [HeadW-1:0]           head_q;
  logic [1:0]                 areas_q;           // overflow areas that are not
  logic                       area_q;            // of the present layer
  logic [AlphaAddressW-2:0]   overflow_q;        // its lines there
  logic                       take, take_end, fits, room, decided, local_lines, spills;

  pu_done u_done (
    .clk_i,
    .rst_ni,
    .windows_i,
    .restart_i,
    .advance_i(take_end && tiles_i.kind == pipegs_pkg::KindWindowEnd),
    .done_i,
    .done_x_i,
    .done_y_i,
    .done_o(done)
  );

  assign tiles_ready_o = state_q == StateTake && ended_q != EndedW'(Layers);
  assign take          = tiles_valid_i && tiles_ready_o;
  assign take_end      = take && tiles_i.kind != pipegs_pkg::KindData;

  assign fits        = pipegs_pkg::Overflow == 0 || SumW'(own_q) + SumW'(count_q) <= SumW'(pipegs_pkg::AlphaLines);
  assign room        = fits ? SumW'(used_q) + SumW'(count_q) <= SumW'(pipegs_pkg::AlphaLines) &&
                              SumW'(held_q) + SumW'(count_q) <= SumW'(pipegs_pkg::AlphaAddresses)
                            : own_spilled_q || areas_q != 2'd2;
  assign decided     = state_q == StateDecide && room;
  assign local_lines = decided && fits;
  assign spills      = decided && !fits;

  assign overflowed_o = spills ? count_q : '0;
  assign waiting_o    = (state_q == StateDecide && !decided) || (tiles_valid_i && ended_q == EndedW'(Layers));

  always_comb begin
    unique case (state_q)
      StateTake:   active_o = take;
      StateCount:  active_o = 1'b1;
      StateDecide: active_o = decided;
      default:     active_o = (row_valid_q && row_job_ready_i) || (color_valid_q && color_job_ready_i);
    endcase
    if (line_free_i || layer_free_i || restart_i) active_o = 1'b1;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q       <= StateTake;
      row_valid_q   <= 1'b0;
      color_valid_q <= 1'b0;
    end else begin
      if (row_job_ready_i) row_valid_q <= 1'b0;
      if (color_job_ready_i) color_valid_q <= 1'b0;
      unique case (state_q)
        StateTake:  if (take) state_q <= take_end ? StateOffer : StateCount;
        StateCount: state_q <= tiles_q.mask == '0 ? StateTake : StateDecide;
        StateDecide: if (decided) state_q <= StateOffer;
        default: begin
          if ((!row_valid_q || row_job_ready_i) && (!color_valid_q || color_job_ready_i)) state_q <= StateTake;
        end
      endcase
      if (take_end || decided) begin
        row_valid_q   <= 1'b1;
        color_valid_q <= 1'b1;
      end
    end
  end

  // Layers and their lines.
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      ended_q       <= '0;
      own_q         <= '0;
      own_spilled_q <= 1'b0;
      used_q        <= '0;
      held_q        <= '0;
      head_q        <= '0;
      areas_q       <= '0;
      area_q        <= 1'b0;
      overflow_q    <= '0;
    end else begin
      ended_q <= ended_q + EndedW'(take_end) - EndedW'(layer_free_i);
      used_q  <= used_q + (local_lines ? LinesW'(count_q) : '0) - LinesW'(line_free_i);
      held_q  <= held_q + (local_lines ? (HeadW+1)'(count_q) : '0) - (layer_free_i ? (HeadW+1)'(lines_q[0]) : '0);
      areas_q <= areas_q + 2'(spills && !own_spilled_q) - 2'(layer_free_i && spilled_q[0]);
      if (local_lines) begin
        own_q  <= own_q + LinesW'(count_q);
        head_q <= head_q + HeadW'(count_q);
      end
      if (spills) begin
        own_spilled_q <= 1'b1;
        overflow_q    <= overflow_q + (AlphaAddressW-1)'(count_q);
      end
      if (take_end) begin
        own_q         <= '0;
        own_spilled_q <= 1'b0;
        overflow_q    <= '0;
        area_q        <= area_q ^ own_spilled_q;
      end
      if (restart_i) begin  // a frame's lines lie where they would lie behind a reset
        head_q <= '0;
        area_q <= 1'b0;
      end
    end
  end
  logic [EndedW-1:0] behind;  // where the layer that ends will stand among those that ended
  assign behind = ended_q - EndedW'(layer_free_i);
  always_ff @(posedge clk_i) begin
    for (int unsigned i = 0; i < Layers; i += 1) begin
      if (take_end && EndedW'(i) == behind) begin
        lines_q[i]   <= own_q;
        spilled_q[i] <= own_spilled_q;
      end else if (layer_free_i) begin
        lines_q[i]   <= lines_q[(i+1)%Layers];
        spilled_q[i] <= spilled_q[(i+1)%Layers];
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (take) begin
      tiles_q      <= tiles_i;
      tiles_q.mask <= tiles_i.mask & ~done;
      payload_q    <= payload_i;
      ext_q        <= 1'b0;
    end
    if (state_q == StateCount) count_q <= CountW'($countones(tiles_q.mask));
    if (decided) begin
      address_q <= fits ? AlphaAddressW'(head_q) : {area_q, overflow_q};
      ext_q     <= !fits;
    end
  end

  // Both outputs are views of the one register.
  assign row_job_valid_o   = row_valid_q;
  assign color_job_valid_o = color_valid_q;
  always_comb begin
    row_job_o.kind    = tiles_q.kind;
    row_job_o.a       = tiles_q.a;
    row_job_o.b       = tiles_q.b;
    row_job_o.c       = tiles_q.c;
    row_job_o.d       = tiles_q.d;
    row_job_o.e       = tiles_q.e;
    row_job_o.f       = tiles_q.f;
    row_job_o.mask    = tiles_q.mask;
    row_job_o.address = address_q;
    row_job_o.ext     = ext_q;
    row_job_o.index   = pipegs_pkg::ShownIndexW'(payload_q.index);
    color_job_o.kind    = tiles_q.kind;
    color_job_o.depth   = payload_q.depth;
    color_job_o.index   = pipegs_pkg::SplatIndexW'(payload_q.index);
    color_job_o.slot    = payload_q.slot;
    color_job_o.mask    = tiles_q.mask;
    color_job_o.address = address_q;
    color_job_o.ext     = ext_q;
    color_job_o.dir_x   = payload_q.dir_x;
    color_job_o.dir_y   = payload_q.dir_y;
    color_job_o.dir_z   = payload_q.dir_z;
    color_job_o.base_r  = payload_q.base_r;
    color_job_o.base_g  = payload_q.base_g;
    color_job_o.base_b  = payload_q.base_b;
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!layer_free_i || ended_q != '0)
    else $error("a layer was freed that has not ended");
  always_ff @(posedge clk_i) if (rst_ni) assert (!line_free_i || used_q != '0)
    else $error("a line was freed that is in no slot");
  always_ff @(posedge clk_i) if (rst_ni) assert (!restart_i || (!take && {ended_q, held_q, areas_q, used_q} == '0))
    else $error("a frame begins in a PU that is not empty");
  always_ff @(posedge clk_i) if (rst_ni)
    assert (!(pipegs_pkg::Overflow == 0 && state_q == StateDecide) ||
            SumW'(own_q) + SumW'(count_q) <= SumW'(pipegs_pkg::AlphaLines))
    else $error("pu_allocate: the alphas of a layer do not fit, and Overflow is 0");
  pipegs_stream_check #(.DataW($bits(color_job_o)), .Proven(1)) u_check_color_job (
    .clk_i,
    .rst_ni,
    .valid_i(color_job_valid_o),
    .ready_i(color_job_ready_i),
    .beat_i(color_job_o)
  );
  pipegs_stream_check #(.DataW($bits(row_job_o)), .Proven(1)) u_check_row_job (
    .clk_i,
    .rst_ni,
    .valid_i(row_job_valid_o),
    .ready_i(row_job_ready_i),
    .beat_i(row_job_o)
  );
`endif

endmodule
