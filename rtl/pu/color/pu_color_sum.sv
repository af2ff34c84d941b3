// SPDX-License-Identifier: Apache-2.0
// pu_color_sum: coefficients times basis, plus the constant band, clamped to the colour's range.
//
// Idea    All coefficients of a Gaussian share one exponent e, so the 15 products of a channel are added exactly as
//         integers and the sum is shifted once:  sum * 2^(e - 26 - ShMW - BasisF)  ->  s8.WorkF, two guard bits
//         below base and colour. A step takes two basis functions times three channels: six multipliers of ShMW x
//         BasisW bits. If Coded the six are made of their codes first: each band's are shifted by its own number.
// Stream  color_task, SH line and sh_basis (the last two for data beats of a frame with SH) -> colored.
// Pace    One Gaussian in 8 cycles at degree 3, 5 at degree 1 and 2, 2 without SH; latency 12 (9, 6, 2).
// Model   cpp_model/pu/color/pu_color_sum.hpp
//
//         step n: operands -> products -> sums;   after the last step, tail 1 2: sums settle, 3: shift, 4: base, clamp

module pu_color_sum (
  input  logic                             clk_i,
  input  logic                             rst_ni,
  input  logic [pipegs_pkg::KindW-1:0]     sh_degree_i,  // of the scene

  input  logic                             task_valid_i,
  output logic                             task_ready_o,
  input  pipegs_pkg::color_task_t          task_i,

  input  logic                             line_valid_i,
  output logic                             line_ready_o,
  input  logic [pipegs_pkg::MemoryW-1:0]   line_i,

  input  logic                             basis_valid_i,
  output logic                             basis_ready_o,
  input  pipegs_pkg::sh_basis_t            basis_i,

  output logic                             colored_valid_o,
  input  logic                             colored_ready_i,
  output pipegs_pkg::colored_t               colored_o,

  output logic                             busy_o,           // a Gaussian left its queue, but not this module
  output logic                             waiting_memory_o  // the oldest Gaussian lacks its line
);

  localparam int unsigned CoefW = pipegs_pkg::ShMW;
  localparam int unsigned ExpW = pipegs_pkg::ShEW;
  localparam int unsigned BasisW = pipegs_pkg::BasisW;
  localparam int unsigned BaseW = pipegs_pkg::BaseW;
  localparam int unsigned ColorW = pipegs_pkg::ColorW;
  localparam int unsigned BaseF = BaseW - 3;
  localparam int unsigned ColorF = ColorW - 2;
  localparam int unsigned WorkF = (BaseF > ColorF ? BaseF : ColorF) + 2;
  localparam int unsigned WorkW = WorkF + 9;            // s8.WorkF: 15 coefficients below 16
  localparam int unsigned TotalW = WorkW + 1;
  localparam int unsigned ProductW = CoefW + BasisW;
  localparam int unsigned SumW = ProductW + 4;          // 15 products
  localparam int unsigned Steps = 8;
  localparam int unsigned ShiftTop = 25 + CoefW + pipegs_pkg::BasisF - WorkF;  // shift - 1 at exponent 0; at least 31
  localparam int unsigned ShiftW = 6;

  // --- control: which Gaussian is summed, and the tail of the one before ---------------------------------------
  logic [2:0]                  step_q, last_step;
  logic [2:0]                  tail_q;  // 0: nothing under way
  logic [1:0]                  degree;
  logic                        shaded, pass, ready, final_step, step, pop;
  logic                        colored_valid_q;
  pipegs_pkg::colored_t          colored_q;

  always_comb begin
    degree = '0;  // the smaller one of frame and machine
    for (int unsigned i = 1; i <= pipegs_pkg::ShDegree; i += 1) if (sh_degree_i >= 2'(i)) degree = 2'(i);
    unique case (degree)
      2'd1:    last_step = 3'd1;
      2'd2:    last_step = 3'd3;
      default: last_step = 3'd7;
    endcase
  end

  // The output register takes the Gaussian with its last step and gets its colour at the end of the tail.
  assign shaded     = task_i.kind == pipegs_pkg::KindData && degree != 2'd0;
  assign ready      = task_valid_i && (!shaded || (line_valid_i && basis_valid_i));
  assign final_step = !shaded || step_q == last_step;
  assign pass       = !final_step || (tail_q == 3'd0 && (!colored_valid_q || colored_ready_i));
  assign step       = ready && pass;
  assign pop        = step && final_step;

  assign task_ready_o     = pop;
  assign line_ready_o     = pop && shaded;
  assign basis_ready_o    = pop && shaded;
  assign busy_o           = tail_q != 3'd0 || colored_valid_q;
  assign waiting_memory_o = task_valid_i && shaded && !line_valid_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      step_q        <= '0;
      tail_q        <= '0;
      colored_valid_q <= 1'b0;
    end else begin
      if (pop) step_q <= '0;
      else if (step) step_q <= step_q + 3'd1;
      if (pop) tail_q <= shaded ? 3'd1 : 3'd4;
      else if (tail_q == 3'd4) tail_q <= '0;
      else if (tail_q != '0) tail_q <= tail_q + 3'd1;
      if (tail_q == 3'd4) colored_valid_q <= 1'b1;
      else if (colored_ready_i) colored_valid_q <= 1'b0;
    end
  end

  // --- operands: the pair of coefficients and basis functions of this step -------------------------------------
  typedef struct packed {logic [Steps-1:0][2*BasisW-1:0] of;} functions_t;
  typedef struct packed {logic [5:0][CoefW-1:0] of;} pair_t;  // three channels of one function, then of the other
  functions_t                          functions;
  pair_t                               coef_pair, pair_q;
  logic [ExpW-1:0]                     slot_exponent;
  logic [2*BasisW-1:0]                 function_pair;
  logic signed [BasisW-1:0]            even_q, odd_q;
  logic                                operand_valid_q, operand_first_q, product_valid_q, product_first_q;

  always_comb begin
    functions     = (2*Steps*BasisW)'(basis_i);
    function_pair = '0;
    for (int unsigned i = 0; i < Steps; i += 1) if (step_q == 3'(i)) function_pair = functions.of[i];
  end

  if (pipegs_pkg::Coded) begin : gen_codes
    pu_color_codes u_codes (
      .sh_degree_i,
      .degree_i(degree),
      .step_i(step_q),
      .quarter_i(task_i.quarter),
      .line_i,
      .pair_o(coef_pair),
      .exponent_o(slot_exponent)
    );
  end else begin : gen_mantissas
    pu_color_mantissas u_mantissas (
      .sh_degree_i,
      .degree_i(degree),
      .step_i(step_q),
      .quarter_i(task_i.quarter),
      .line_i,
      .pair_o(coef_pair),
      .exponent_o(slot_exponent)
    );
  end

  always_ff @(posedge clk_i) begin
    if (step) begin
      pair_q          <= coef_pair;
      even_q          <= function_pair[BasisW-1:0];
      odd_q           <= function_pair[2*BasisW-1:BasisW];
      operand_first_q <= step_q == '0;
    end
    product_first_q <= operand_first_q;
  end
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      operand_valid_q <= 1'b0;
      product_valid_q <= 1'b0;
    end else begin
      operand_valid_q <= step && shaded;
      product_valid_q <= operand_valid_q;
    end
  end

  // --- what the tail needs of the Gaussian that left -------------------------------------------------------------
  logic [ExpW-1:0] exponent_q;
  logic            data_q, shaded_q;

  always_ff @(posedge clk_i) begin
    if (pop) begin
      exponent_q <= slot_exponent;
      data_q     <= task_i.kind == pipegs_pkg::KindData;
      shaded_q   <= shaded;
    end
  end

  // --- three channels ----------------------------------------------------------------------------------------------
  typedef struct packed {logic [2:0][BaseW-1:0] of;} bases_t;
  typedef struct packed {logic [2:0][ColorW-1:0] of;} colors_t;
  bases_t              bases_q;
  colors_t             colors;
  logic [ShiftW-1:0]   shift;

  assign shift = ShiftW'(ShiftTop) - ShiftW'(exponent_q);
  always_ff @(posedge clk_i) begin
    if (pop) bases_q <= {task_i.base_b, task_i.base_g, task_i.base_r};
  end

  for (genvar c = 0; c < 3; c += 1) begin : gen_channel
    logic signed [BaseW-1:0]  base;
    logic signed [WorkW-1:0]  bands;
    logic signed [TotalW-1:0] total, value;
    logic [ColorW-1:0]        color;

    if (pipegs_pkg::ShDegree != 0) begin : gen_bands
      logic signed [CoefW-1:0]    even, odd;
      logic signed [ProductW-1:0] even_product_q, odd_product_q;
      logic signed [SumW-1:0]     both, sum_q, cut, near;
      logic signed [WorkW-1:0]    bands_q;

      assign even = pair_q.of[c];
      assign odd  = pair_q.of[3+c];
      assign both = SumW'(even_product_q) + SumW'(odd_product_q);
      // To nearest: the first bit that is dropped is added.
      assign cut  = sum_q >>> shift;
      assign near = (cut >>> 1) + SumW'($signed({1'b0, cut[0]}));

      always_ff @(posedge clk_i) begin
        if (operand_valid_q) begin
          even_product_q <= ProductW'(even) * ProductW'(even_q);
          odd_product_q  <= ProductW'(odd) * ProductW'(odd_q);
        end
        if (product_valid_q) sum_q <= product_first_q ? both : sum_q + both;
        if (tail_q == 3'd3) bands_q <= WorkW'(near);
      end
      assign bands = shaded_q ? bands_q : WorkW'(0);

      wire unused_high = &{1'b0, near[SumW-1:WorkW]};
    end else begin : gen_flat
      assign bands = '0;
      wire unused_bands = &{1'b0, pair_q, even_q, odd_q, operand_valid_q, product_valid_q, product_first_q, shaded_q,
                            shift};
    end

    assign base  = bases_q.of[c];
    assign total = TotalW'(bands) + (TotalW'(base) <<< (WorkF - BaseF));
    assign value = (total >>> (WorkF - ColorF)) + TotalW'($signed({1'b0, total[WorkF-ColorF-1]}));

    always_comb begin
      color = value[ColorW-1:0];
      if (pipegs_pkg::Saturation != 0 && value[TotalW-1:ColorW] != '0) color = '1;
      if (value[TotalW-1] || !data_q) color = '0;
    end
    assign colors.of[c] = color;
  end

  always_ff @(posedge clk_i) begin
    if (pop) begin
      colored_q.kind    <= task_i.kind;
      colored_q.depth   <= task_i.depth;
      colored_q.index   <= task_i.index;
      colored_q.mask    <= task_i.mask;
      colored_q.address <= task_i.address;
      colored_q.ext     <= task_i.ext;
    end
    if (tail_q == 3'd4) begin
      colored_q.red   <= colors.of[0];
      colored_q.green <= colors.of[1];
      colored_q.blue  <= colors.of[2];
    end
  end

  assign colored_valid_o = colored_valid_q;
  assign colored_o       = colored_q;

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits(colored_o))) u_check_colored (
    .clk_i,
    .rst_ni,
    .valid_i(colored_valid_o),
    .ready_i(colored_ready_i),
    .beat_i(colored_o)
  );
`endif

endmodule
