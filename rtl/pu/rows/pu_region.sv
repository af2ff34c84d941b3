// SPDX-License-Identifier: Apache-2.0
// pu_region: walks the mask of a job and moves the Gaussian's coefficients to the first pixel of each region.
//
// Paper   Eq. 3, step 1 of Fig. 5a, in the shared form: A to F once per Gaussian, here only shifted by (8 rx, 8 ry).
// Idea    power   = A + 8 (B rx + C ry) + 64 ((D rx + F ry) rx + E ry ry)
//         slope_x = B + 16 D rx + 8 F ry,   slope_y = C + 16 E ry + 8 F rx          rx, ry: three bits
//         exactly in CoeffF fraction bits, then each rounded once to PowerF.
// Stream  row_job in; one region per bit of its mask out, low bits first. An end beat gives one region of its kind.
// Pace    One region per four cycles (select, multiply, square, finish); the next job is taken in the last of them.
// Model   cpp_model/pu/rows/pu_region.hpp

module pu_region (
  input  logic                   clk_i,
  input  logic                   rst_ni,

  input  logic                   row_job_valid_i,
  output logic                   row_job_ready_o,
  input  pipegs_pkg::row_job_t   row_job_i,

  output logic                   region_valid_o,
  input  logic                   region_ready_i,
  output pipegs_pkg::region_t    region_o,

  output logic                   busy_o  // a job or a region is inside
);

  localparam int unsigned Regions   = pipegs_pkg::Regions;
  localparam int unsigned RegionW   = pipegs_pkg::RegionW;
  localparam int unsigned HalfW     = RegionW / 2;      // bits of a column or row of regions
  localparam int unsigned BcW       = pipegs_pkg::BcW;
  localparam int unsigned DefW      = pipegs_pkg::DefW;
  localparam int unsigned AxisW     = 4;                // rx, ry: u3 with a sign bit
  localparam int unsigned LinearW   = BcW + AxisW;      // B rx + C ry
  localparam int unsigned CurvedW   = DefW + AxisW;     // D rx + F ry
  localparam int unsigned SquareW   = CurvedW + AxisW;  // (D rx + F ry) rx + E ry ry
  localparam int unsigned Shift     = pipegs_pkg::CoeffF - pipegs_pkg::PowerF;
  localparam int unsigned PowerW    = pipegs_pkg::PowerW;
  localparam int unsigned GradientW = pipegs_pkg::GradientW;
  localparam int unsigned CurveW    = pipegs_pkg::CurveW;
  localparam int unsigned ExactW    = PowerW + Shift;     // s20.CoeffF
  localparam int unsigned SteepW    = GradientW + Shift;  // s13.CoeffF
  localparam int unsigned BendW     = CurveW + Shift;     // s4.CoeffF
  localparam logic signed [ExactW-1:0] Half = Shift == 0 ? '0 : ExactW'(1) << (Shift == 0 ? 0 : Shift - 1);

  typedef enum logic [2:0] {
    StateIdle,      // waits for a job
    StateSelect,    // the next region of the mask
    StateMultiply,  // coefficients times rx, ry
    StateSquare,    // and once more for the squares
    StateFinish     // sums, rounding; waits for the output register
  } state_e;

  state_e                      state_q;
  pipegs_pkg::row_job_t        job_q;      // mask: regions still to do; address: line of the next one
  logic [RegionW-1:0]          region_q;
  logic                        region_valid_q;
  pipegs_pkg::region_t         out, out_q;

  logic                        finish, load;
  logic [RegionW-1:0]           lowest;

  logic signed [LinearW-1:0]   linear_q;
  logic signed [CurvedW-1:0]   d_rx_q, f_ry_q, e_ry_q, f_rx_q;
  logic signed [SquareW-1:0]   square_q;
  logic signed [AxisW-1:0]     rx, ry;
  logic signed [BcW-1:0]       b, c;
  logic signed [DefW-1:0]      d, e, f;
  logic signed [ExactW-1:0]    power;
  logic signed [SteepW-1:0]    slope_x, slope_y;
  logic signed [BendW-1:0]     curve_x, curve_y, twist;

  assign finish  = state_q == StateFinish && (!region_valid_q || region_ready_i);
  assign load    = row_job_valid_i && row_job_ready_o;
  assign row_job_ready_o = state_q == StateIdle || (finish && job_q.mask == '0);
  assign region_valid_o  = region_valid_q;
  assign region_o        = out_q;
  assign busy_o          = state_q != StateIdle || region_valid_q;

  // Lowest set bit of the mask by halving.
  always_comb begin
    logic [Regions-1:0] part, below;
    part   = job_q.mask;
    lowest = '0;
    for (int level = RegionW - 1; level >= 0; level -= 1) begin
      below = part & ((Regions'(1) << (1 << level)) - Regions'(1));
      if (below == '0) begin
        lowest[level] = 1'b1;
        part = part >> (1 << level);
      end else begin
        part = below;
      end
    end
  end

  // rx and ry are unsigned; the leading 0 makes them signed.
  assign rx = AxisW'(region_q[HalfW-1:0]);
  assign ry = AxisW'(region_q[RegionW-1:HalfW]);
  assign b  = job_q.b;
  assign c  = job_q.c;
  assign d  = job_q.d;
  assign e  = job_q.e;
  assign f  = job_q.f;

  always_comb begin
    power   = ExactW'(signed'(job_q.a)) + (ExactW'(linear_q) <<< 3) + (ExactW'(square_q) <<< 6) + Half;
    slope_x = SteepW'(b) + (SteepW'(d_rx_q) <<< 4) + (SteepW'(f_ry_q) <<< 3) + SteepW'(Half);
    slope_y = SteepW'(c) + (SteepW'(e_ry_q) <<< 4) + (SteepW'(f_rx_q) <<< 3) + SteepW'(Half);
    curve_x = BendW'(d) + BendW'(Half);
    curve_y = BendW'(e) + BendW'(Half);
    twist   = BendW'(f) + BendW'(Half);
    out.kind    = job_q.kind;
    out.power   = PowerW'(power >>> Shift);
    out.slope_x = GradientW'(slope_x >>> Shift);
    out.slope_y = GradientW'(slope_y >>> Shift);
    out.curve_x = CurveW'(curve_x >>> Shift);
    out.curve_y = CurveW'(curve_y >>> Shift);
    out.twist   = CurveW'(twist >>> Shift);
    out.address = job_q.address;
    out.ext     = job_q.ext;
    out.index   = job_q.index;
    out.region  = region_q;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q        <= StateIdle;
      region_valid_q <= 1'b0;
    end else begin
      if (region_ready_i) region_valid_q <= 1'b0;
      unique case (state_q)
        StateSelect:   state_q <= StateMultiply;
        StateMultiply: state_q <= StateSquare;
        StateSquare:   state_q <= StateFinish;
        default: begin
          if (finish) begin
            region_valid_q <= 1'b1;
            state_q        <= job_q.mask == '0 ? StateIdle : StateSelect;
          end
          if (load) state_q <= row_job_i.kind == pipegs_pkg::KindData ? StateSelect : StateFinish;
        end
      endcase
    end
  end

  always_ff @(posedge clk_i) begin
    unique case (state_q)
      StateSelect: begin
        region_q   <= lowest;
        job_q.mask <= job_q.mask & (job_q.mask - Regions'(1));
      end
      StateMultiply: begin
        linear_q <= LinearW'(b) * LinearW'(rx) + LinearW'(c) * LinearW'(ry);
        d_rx_q   <= CurvedW'(d) * CurvedW'(rx);
        f_ry_q   <= CurvedW'(f) * CurvedW'(ry);
        e_ry_q   <= CurvedW'(e) * CurvedW'(ry);
        f_rx_q   <= CurvedW'(f) * CurvedW'(rx);
      end
      StateSquare: square_q <= (SquareW'(d_rx_q) + SquareW'(f_ry_q)) * SquareW'(rx) + SquareW'(e_ry_q) * SquareW'(ry);
      default: begin
        if (finish) begin
          out_q         <= out;
          job_q.address <= job_q.address + pipegs_pkg::AlphaAddressW'(1);
        end
        if (load) begin
          job_q <= row_job_i;
          if (row_job_i.kind != pipegs_pkg::KindData) job_q.mask <= '0;
        end
      end
    endcase
  end

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits(region_o))) u_check_region (
    .clk_i,
    .rst_ni,
    .valid_i(region_valid_o),
    .ready_i(region_ready_i),
    .beat_i(region_o)
  );
`endif

endmodule
