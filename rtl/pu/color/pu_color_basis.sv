// SPDX-License-Identifier: Apache-2.0
// pu_color_basis: the fifteen SH basis functions of bands 1 to 3 for a unit direction.
//
// Idea    Bands 2 and 3 are built from each other with 25 products on four multipliers. A product is registered, and
//         in the next cycle rounded into a result, so what step n makes can be used from step n + 2 on:
//           step  0: px py zz height    1: cube_x cube_y b1 b2    2: b4 b8 b3 b5     3: b7 b6 rim pole
//                 4: b9 and b15 (two products each)               5: b10 b14 b11 b13  6: b12
// Stream  unit_direction (s1.16) -> sh_basis (s0.16), both registered here.
// Pace    One direction in 7 cycles, latency 9; the last result lands while the next direction is in its step 0.
// Model   cpp_model/pu/color/pu_color_basis.hpp

module pu_color_basis (
  input  logic                         clk_i,
  input  logic                         rst_ni,

  input  logic                         unit_valid_i,
  output logic                         unit_ready_o,
  input  pipegs_pkg::unit_direction_t  unit_i,

  output logic                         basis_valid_o,
  input  logic                         basis_ready_i,
  output pipegs_pkg::sh_basis_t        basis_o
);

  localparam int unsigned W = pipegs_pkg::UnitDirectionW;
  localparam int unsigned F = pipegs_pkg::UnitDirectionF;
  localparam int unsigned BasisW = pipegs_pkg::BasisW;
  localparam int unsigned ProductW = 2 * W;
  localparam int unsigned SumW = ProductW + 1;
  localparam int unsigned LastStep = 6;

  // s1.16, rounded to nearest.
  localparam logic signed [W-1:0] Band1 = W'(32021);     // C1 = 0.4886025119
  localparam logic signed [W-1:0] Pair = W'(71601);      // 2 C2e = 1.0925484306
  localparam logic signed [W-1:0] Height = W'(86696);    // sqrt(7) / 2
  localparam logic signed [W-1:0] Cube = W'(-70787);     // C3a / C2e
  localparam logic signed [W-1:0] SixA = W'(62009);      // 3 C2c
  localparam logic signed [W-1:0] SixB = W'(-20670);     // -C2c
  localparam logic signed [W-1:0] RimA = W'(-74882);     // 5 C3c / 2
  localparam logic signed [W-1:0] RimB = W'(14976);      // -C3c / 2
  localparam logic signed [W-1:0] PoleA = W'(122282);    // 5 C3d
  localparam logic signed [W-1:0] PoleB = W'(-73369);    // -3 C3d

  logic                       busy_q;
  logic [2:0]                 step_q, product_step_q;
  logic                       product_valid_q, landing, go, issue, last, take;
  logic signed [W-1:0]        x_q, y_q, z_q, px_q, py_q, zz_q, height_q, cube_x_q, cube_y_q, rim_q, pole_q;
  logic signed [W-1:0]        a0, a1, a2, a3, b0, b1, b2, b3;
  logic signed [ProductW-1:0] product0_q, product1_q, product2_q, product3_q;
  logic signed [W-1:0]        near0, near1, near2, near3;             // products / 2^F
  logic signed [BasisW-1:0]   twice0, twice1, twice2, twice3, half1;  // 2 * product, product / 2
  logic signed [SumW-1:0]     cross9, cross15;
  pipegs_pkg::sh_basis_t      work_q, done, basis_q;
  logic                       basis_valid_q;

  // The last result lands in the output register: everything waits for that to be free.
  assign landing      = product_valid_q && product_step_q == 3'(LastStep);
  assign go           = !landing || !basis_valid_q || basis_ready_i;
  assign issue        = busy_q && go;
  assign last         = issue && step_q == 3'(LastStep);
  assign unit_ready_o = !busy_q || last;
  assign take         = unit_valid_i && unit_ready_o;

  always_comb begin
    unique case (step_q)
      3'd0: begin
        a0 = Pair;     b0 = x_q;
        a1 = Pair;     b1 = y_q;
        a2 = z_q;      b2 = z_q;
        a3 = Height;   b3 = z_q;
      end
      3'd1: begin
        a0 = Cube;     b0 = x_q;
        a1 = Cube;     b1 = y_q;
        a2 = -Band1;   b2 = y_q;
        a3 = Band1;    b3 = z_q;
      end
      3'd2: begin
        a0 = px_q;         b0 = y_q;
        a1 = px_q - py_q;  b1 = x_q + y_q;
        a2 = -Band1;       b2 = x_q;
        a3 = py_q;         b3 = z_q;
      end
      3'd3: begin
        a0 = px_q;     b0 = z_q;
        a1 = SixA;     b1 = zz_q;
        a2 = RimA;     b2 = zz_q;
        a3 = PoleA;    b3 = zz_q;
      end
      3'd4: begin
        a0 = cube_x_q; b0 = W'(work_q.b8);
        a1 = cube_y_q; b1 = W'(work_q.b8);
        a2 = cube_x_q; b2 = W'(work_q.b4);
        a3 = cube_y_q; b3 = W'(work_q.b4);
      end
      3'd5: begin
        a0 = height_q; b0 = W'(work_q.b4);
        a1 = height_q; b1 = W'(work_q.b8);
        a2 = rim_q;    b2 = y_q;
        a3 = rim_q;    b3 = x_q;
      end
      default: begin
        a0 = pole_q;   b0 = z_q;
        a1 = '0;       b1 = '0;
        a2 = '0;       b2 = '0;
        a3 = '0;       b3 = '0;
      end
    endcase
  end

  // To nearest: the bit below the last one kept is added.
  always_comb begin
    near0   = W'(product0_q >>> F) + W'(product0_q[F-1]);
    near1   = W'(product1_q >>> F) + W'(product1_q[F-1]);
    near2   = W'(product2_q >>> F) + W'(product2_q[F-1]);
    near3   = W'(product3_q >>> F) + W'(product3_q[F-1]);
    twice0  = BasisW'(product0_q >>> (F - 1)) + BasisW'(product0_q[F-2]);
    twice1  = BasisW'(product1_q >>> (F - 1)) + BasisW'(product1_q[F-2]);
    twice2  = BasisW'(product2_q >>> (F - 1)) + BasisW'(product2_q[F-2]);
    twice3  = BasisW'(product3_q >>> (F - 1)) + BasisW'(product3_q[F-2]);
    half1   = BasisW'(product1_q >>> (F + 1)) + BasisW'(product1_q[F]);
    cross9  = SumW'(product1_q) + SumW'(product2_q);
    cross15 = SumW'(product0_q) - SumW'(product3_q);
    done     = work_q;
    done.b12 = BasisW'(near0);
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      busy_q          <= 1'b0;
      step_q          <= '0;
      product_valid_q <= 1'b0;
      basis_valid_q   <= 1'b0;
    end else begin
      if (take) busy_q <= 1'b1;
      else if (last) busy_q <= 1'b0;
      if (take) step_q <= '0;
      else if (issue) step_q <= step_q + 3'd1;
      if (go) product_valid_q <= issue;
      if (landing && go) basis_valid_q <= 1'b1;
      else if (basis_ready_i) basis_valid_q <= 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (take) begin
      x_q <= unit_i.x;
      y_q <= unit_i.y;
      z_q <= unit_i.z;
    end
    if (issue) begin
      product_step_q <= step_q;
      product0_q     <= ProductW'(a0) * ProductW'(b0);
      product1_q     <= ProductW'(a1) * ProductW'(b1);
      product2_q     <= ProductW'(a2) * ProductW'(b2);
      product3_q     <= ProductW'(a3) * ProductW'(b3);
    end
    if (product_valid_q && go) begin
      unique case (product_step_q)
        3'd0: begin
          px_q     <= near0;
          py_q     <= near1;
          zz_q     <= near2;
          height_q <= near3;
        end
        3'd1: begin
          cube_x_q  <= near0;
          cube_y_q  <= near1;
          work_q.b1 <= BasisW'(near2);
          work_q.b2 <= BasisW'(near3);
        end
        3'd2: begin
          work_q.b4 <= BasisW'(near0);
          work_q.b8 <= half1;
          work_q.b3 <= BasisW'(near2);
          work_q.b5 <= BasisW'(-near3);
        end
        3'd3: begin
          work_q.b7 <= BasisW'(-near0);
          work_q.b6 <= BasisW'(near1 + SixB);
          rim_q     <= near2 + RimB;
          pole_q    <= near3 + PoleB;
        end
        3'd4: begin
          work_q.b9  <= BasisW'(cross9 >>> F) + BasisW'(cross9[F-1]);
          work_q.b15 <= BasisW'(cross15 >>> F) + BasisW'(cross15[F-1]);
        end
        3'd5: begin
          work_q.b10 <= twice0;
          work_q.b14 <= twice1;
          work_q.b11 <= twice2;
          work_q.b13 <= twice3;
        end
        default: begin
          work_q.b12 <= done.b12;
          basis_q    <= done;
        end
      endcase
    end
  end

  assign basis_valid_o = basis_valid_q;
  assign basis_o       = basis_q;

  // Bits above the results (no basis function reaches 1) and below the rounding.
  wire unused_bits = &{1'b0, product0_q, product1_q, product2_q, product3_q, cross9, cross15};

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits(basis_o))) u_check_basis (
    .clk_i,
    .rst_ni,
    .valid_i(basis_valid_o),
    .ready_i(basis_ready_i),
    .beat_i(basis_o)
  );
`endif

endmodule
