// SPDX-License-Identifier: Apache-2.0
// pu_rows: eight Row Units turn the regions of a Gaussian into lines of 64 alphas.
//
// Paper   Fig. 5a, Fig. 7: eight Row Units per Preprocessing Unit.
// Idea    Unit dy walks row dy: each cycle gives PixelsPerRow columns of all eight rows. The line is a shift register
//         per row. The whole pipeline moves together and stops only when a line waits at the output.
//
//           pu_region | 8 x pu_row_init -> pu_row_unit | cut, clamp | exp2 | shift, round -> line
//         With Quadratic pu_power stands in the place of the second column, for the ladder's baseline.
//
// Stream  row_job in; alphas and their line out (an end beat: kind only, its line means nothing).
// Pace    One region per 8 / PixelsPerRow cycles, no bubble between regions or jobs. Latency 8 + 8 / PixelsPerRow.
// Model   cpp_model/pu/rows/pu_rows.hpp

module pu_rows (
  input  logic                         clk_i,
  input  logic                         rst_ni,

  input  logic                         row_job_valid_i,
  output logic                         row_job_ready_o,
  input  pipegs_pkg::row_job_t         row_job_i,

  output logic                         alphas_valid_o,
  input  logic                         alphas_ready_i,
  output pipegs_pkg::alphas_t          alphas_o,
  output logic [pipegs_pkg::LineW-1:0] line_o,

  output logic                         active_o  // needs a clock
);

  localparam int unsigned Rows    = 8;
  localparam int unsigned AlphaW  = pipegs_pkg::AlphaW;
  localparam int unsigned PowerW  = pipegs_pkg::PowerW;
  localparam int unsigned Pixels  = pipegs_pkg::PixelsPerRow;
  localparam int unsigned Steps   = Rows / Pixels;
  localparam int unsigned StepW   = $clog2(Steps);
  localparam int unsigned RowW    = Rows * AlphaW;     // codes of a row
  localparam int unsigned ColumnW = Pixels * AlphaW;   // codes of a row in one cycle

  logic                             region_valid, region_ready, region_busy;
  pipegs_pkg::region_t              region;
  logic                             move, take;
  logic                             row_valid_q, clamp_valid_q, exp_valid_q, alphas_valid_q;
  logic                             row_last, clamp_last_q, exp_last_q;
  logic [StepW-1:0]                 step_q;
  logic signed [pipegs_pkg::CurveW-1:0] curve_q;
  pipegs_pkg::alphas_t              row_q, clamp_q, exp_q, alphas_q;

  pu_region u_region (
    .clk_i,
    .rst_ni,
    .row_job_valid_i,
    .row_job_ready_o,
    .row_job_i,
    .region_valid_o(region_valid),
    .region_ready_i(region_ready),
    .region_o(region),
    .busy_o(region_busy)
  );

  assign move           = !alphas_valid_q || alphas_ready_i;
  assign row_last       = step_q == '0;
  assign region_ready   = move && (!row_valid_q || row_last);
  assign take           = region_valid && region_ready;
  assign alphas_valid_o = alphas_valid_q;
  assign alphas_o       = alphas_q;
  assign active_o       = row_job_valid_i || region_busy || row_valid_q || clamp_valid_q || exp_valid_q
                       || alphas_valid_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      row_valid_q    <= 1'b0;
      clamp_valid_q  <= 1'b0;
      exp_valid_q    <= 1'b0;
      alphas_valid_q <= 1'b0;
    end else if (move) begin
      row_valid_q    <= take || (row_valid_q && !row_last);
      clamp_valid_q  <= row_valid_q;
      exp_valid_q    <= clamp_valid_q;
      alphas_valid_q <= exp_valid_q && exp_last_q;
    end
  end

  always_ff @(posedge clk_i) begin
    if (take) begin
      step_q  <= region.kind == pipegs_pkg::KindData ? StepW'(Steps - 1) : '0;  // steps that follow the first
      curve_q <= region.curve_x;
      row_q.kind    <= region.kind;
      row_q.address <= region.address;
      row_q.ext     <= region.ext;
      row_q.index   <= region.index;
      row_q.region  <= region.region;
    end else if (move) begin
      step_q <= step_q - StepW'(1);
    end
    if (move) begin
      clamp_last_q <= row_last;
      exp_last_q   <= clamp_last_q;
      if (row_valid_q && row_last) clamp_q <= row_q;
      if (clamp_valid_q && clamp_last_q) exp_q <= clamp_q;
      if (exp_valid_q && exp_last_q) alphas_q <= exp_q;
    end
  end

  for (genvar dy = 0; dy < Rows; dy += 1) begin : gen_row
    logic [Pixels*PowerW-1:0]                power;
    logic [ColumnW-1:0]                      codes;
    logic [RowW-1:0]                         codes_q;

    if (pipegs_pkg::Quadratic == 0) begin : gen_differential
      logic signed [PowerW-1:0]                power_init;
      logic signed [pipegs_pkg::GradientW-1:0] slope_init;

      pu_row_init #(.Dy(dy)) u_row_init (
        .power_i(region.power),
        .slope_x_i(region.slope_x),
        .slope_y_i(region.slope_y),
        .curve_x_i(region.curve_x),
        .curve_y_i(region.curve_y),
        .twist_i(region.twist),
        .power_o(power_init),
        .slope_o(slope_init)
      );

      pu_row_unit u_row_unit (
        .clk_i,
        .load_i(take),
        .power_i(power_init),
        .slope_i(slope_init),
        .step_i(move && row_valid_q),
        .curve_i(curve_q),
        .power_o(power)
      );
    end else begin : gen_quadratic
      pu_power #(.Dy(dy)) u_power (
        .clk_i,
        .load_i(take),
        .power_i(region.power),
        .slope_x_i(region.slope_x),
        .slope_y_i(region.slope_y),
        .curve_x_i(region.curve_x),
        .curve_y_i(region.curve_y),
        .twist_i(region.twist),
        .step_i(move && row_valid_q),
        .power_o(power)
      );
      logic unused_curve;
      assign unused_curve = &{1'b0, curve_q};
    end

    for (genvar dx = 0; dx < Pixels; dx += 1) begin : gen_alpha
      pu_alpha u_alpha (
        .clk_i,
        .enable_clamp_i(move && row_valid_q),
        .enable_exp_i(move && clamp_valid_q),
        .power_i(power[dx*PowerW +: PowerW]),
        .code_o(codes[dx*AlphaW +: AlphaW])
      );
    end

    always_ff @(posedge clk_i) begin
      if (move && exp_valid_q) codes_q <= {codes, codes_q[RowW-1:ColumnW]};
    end
    assign line_o[dy*RowW +: RowW] = codes_q;
  end

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits({alphas_o, line_o}))) u_check_alphas (
    .clk_i,
    .rst_ni,
    .valid_i(alphas_valid_o),
    .ready_i(alphas_ready_i),
    .beat_i({alphas_o, line_o})
  );
`endif

endmodule
