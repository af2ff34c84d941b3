// SPDX-License-Identifier: Apache-2.0
// pu_shape: from a visible Gaussian to its conic, one stage behind the other; what they do not look at goes beside
//         them.
//
// Paper   Sec. 4.2.1, Eq. 1.
// Idea    project -> orient -> jacobian -> factors -> squares -> covariance -> (axes, box, with the oriented box ->)
//         (compensate, with Antialias ->) conic.
//         The centre (mean and opacity) waits in a queue from pu_project to pu_covariance; the payload (depth,
//         direction, base colour, index, slot) leaves at once. Only wiring here.
// Stream  visible in, conic out, in order; ends pass. payload: one for each Gaussian, in order, before its conic; not
//         refused.
// Pace    One Gaussian per Pace cycles, 8 or 4; per 14 with the oriented box and without compensate.
// Model   golden_conic in cpp_model/golden.cpp

module pu_shape (
  input  logic                   clk_i,
  input  logic                   rst_ni,
  input  pipegs_pkg::quaternion_t quaternion_i,
  input  pipegs_pkg::lens_t      lens_i,
  input  pipegs_pkg::tables_t    tables_i,

  input  logic                   visible_valid_i,
  output logic                   visible_ready_o,
  input  pipegs_pkg::visible_t   visible_i,

  output logic                   payload_valid_o,
  output pipegs_pkg::payload_t   payload_o,

  output logic                   conic_valid_o,
  input  logic                   conic_ready_i,
  output pipegs_pkg::conic_t     conic_o,

  output logic                   moved_o,  // a beat moved
  output logic                   busy_o    // a record is inside
);

  localparam int unsigned CenterDepth = pipegs_pkg::CenterDepth;

  // The stages and, with the same number, the stream behind each.
  localparam int unsigned Project    = 0;
  localparam int unsigned Orient     = 1;
  localparam int unsigned Jacobian   = 2;
  localparam int unsigned Factors    = 3;
  localparam int unsigned Squares    = 4;
  localparam int unsigned Covariance = 5;
  localparam int unsigned Axes       = 6;
  localparam int unsigned Box        = 7;
  localparam int unsigned Compensate = 8;
  localparam int unsigned Conic      = 9;
  localparam int unsigned Stages     = 10;

  logic [Stages-1:0]       valid /* verilator split_var */, ready /* verilator split_var */, busy;
  pipegs_pkg::projected_t  projected;
  pipegs_pkg::oriented_t   oriented;
  pipegs_pkg::jacobian_t   jacobian;
  pipegs_pkg::factors_t    factors;
  pipegs_pkg::squares_t    squares;
  pipegs_pkg::covariance_t covariance, boxed, compensated;

  logic                             center_valid, center_room, center_held, center_take;
  pipegs_pkg::center_t              center_in, center;
  logic [$clog2(CenterDepth+1)-1:0] center_count;

  assign conic_valid_o = valid[Conic];
  assign ready[Conic]  = conic_ready_i;
  assign moved_o       = |(valid & ready);
  assign busy_o        = |busy;

  if (pipegs_pkg::Pace == 4) begin : gen_four_project
    pu_four_project u_project (
      .clk_i,
      .rst_ni,
      .lens_i,
      .visible_valid_i,
      .visible_ready_o,
      .visible_i,
      .projected_valid_o(valid[Project]),
      .projected_ready_i(ready[Project]),
      .projected_o(projected),
      .center_valid_o(center_valid),
      .center_o(center_in),
      .payload_valid_o,
      .payload_o,
      .busy_o(busy[Project])
    );
  end else begin : gen_project
    pu_project u_project (
      .clk_i,
      .rst_ni,
      .lens_i,
      .visible_valid_i,
      .visible_ready_o,
      .visible_i,
      .projected_valid_o(valid[Project]),
      .projected_ready_i(ready[Project]),
      .projected_o(projected),
      .center_valid_o(center_valid),
      .center_o(center_in),
      .payload_valid_o,
      .payload_o,
      .busy_o(busy[Project])
    );
  end

  pipegs_sram_fifo #(.DataW(pipegs_pkg::CenterBits), .Depth(CenterDepth)) u_centers (
    .clk_i,
    .rst_ni,
    .in_valid_i(center_valid),
    .in_ready_o(center_room),
    .in_i(center_in),
    .out_valid_o(center_held),
    .out_ready_i(center_take),
    .out_o(center),
    .count_o(center_count)
  );

  if (pipegs_pkg::Pace == 4) begin : gen_four_orient
    pu_four_orient u_orient (
      .clk_i,
      .rst_ni,
      .quaternion_i,
      .projected_valid_i(valid[Project]),
      .projected_ready_o(ready[Project]),
      .projected_i(projected),
      .oriented_valid_o(valid[Orient]),
      .oriented_ready_i(ready[Orient]),
      .oriented_o(oriented),
      .busy_o(busy[Orient])
    );
  end else begin : gen_orient
    pu_orient u_orient (
      .clk_i,
      .rst_ni,
      .quaternion_i,
      .projected_valid_i(valid[Project]),
      .projected_ready_o(ready[Project]),
      .projected_i(projected),
      .oriented_valid_o(valid[Orient]),
      .oriented_ready_i(ready[Orient]),
      .oriented_o(oriented),
      .busy_o(busy[Orient])
    );
  end

  if (pipegs_pkg::Pace == 4) begin : gen_four_jacobian
    pu_four_jacobian u_jacobian (
      .clk_i,
      .rst_ni,
      .focal_x_i(lens_i.focal_x),
      .focal_y_i(lens_i.focal_y),
      .oriented_valid_i(valid[Orient]),
      .oriented_ready_o(ready[Orient]),
      .oriented_i(oriented),
      .jacobian_valid_o(valid[Jacobian]),
      .jacobian_ready_i(ready[Jacobian]),
      .jacobian_o(jacobian),
      .busy_o(busy[Jacobian])
    );
  end else begin : gen_jacobian
    pu_jacobian u_jacobian (
      .clk_i,
      .rst_ni,
      .focal_x_i(lens_i.focal_x),
      .focal_y_i(lens_i.focal_y),
      .oriented_valid_i(valid[Orient]),
      .oriented_ready_o(ready[Orient]),
      .oriented_i(oriented),
      .jacobian_valid_o(valid[Jacobian]),
      .jacobian_ready_i(ready[Jacobian]),
      .jacobian_o(jacobian),
      .busy_o(busy[Jacobian])
    );
  end

  if (pipegs_pkg::Pace == 4) begin : gen_four_factors
    pu_four_factors u_factors (
      .clk_i,
      .rst_ni,
      .jacobian_valid_i(valid[Jacobian]),
      .jacobian_ready_o(ready[Jacobian]),
      .jacobian_i(jacobian),
      .factors_valid_o(valid[Factors]),
      .factors_ready_i(ready[Factors]),
      .factors_o(factors),
      .busy_o(busy[Factors])
    );
  end else begin : gen_factors
    pu_factors u_factors (
      .clk_i,
      .rst_ni,
      .jacobian_valid_i(valid[Jacobian]),
      .jacobian_ready_o(ready[Jacobian]),
      .jacobian_i(jacobian),
      .factors_valid_o(valid[Factors]),
      .factors_ready_i(ready[Factors]),
      .factors_o(factors),
      .busy_o(busy[Factors])
    );
  end

  if (pipegs_pkg::Pace == 4) begin : gen_four_squares
    pu_four_squares u_squares (
      .clk_i,
      .rst_ni,
      .factors_valid_i(valid[Factors]),
      .factors_ready_o(ready[Factors]),
      .factors_i(factors),
      .squares_valid_o(valid[Squares]),
      .squares_ready_i(ready[Squares]),
      .squares_o(squares),
      .busy_o(busy[Squares])
    );
  end else begin : gen_squares
    pu_squares u_squares (
      .clk_i,
      .rst_ni,
      .factors_valid_i(valid[Factors]),
      .factors_ready_o(ready[Factors]),
      .factors_i(factors),
      .squares_valid_o(valid[Squares]),
      .squares_ready_i(ready[Squares]),
      .squares_o(squares),
      .busy_o(busy[Squares])
    );
  end

  if (pipegs_pkg::Pace == 4) begin : gen_four_covariance
    pu_four_covariance u_covariance (
      .clk_i,
      .rst_ni,
      .squares_valid_i(valid[Squares]),
      .squares_ready_o(ready[Squares]),
      .squares_i(squares),
      .center_i(center),
      .center_take_o(center_take),
      .covariance_valid_o(valid[Covariance]),
      .covariance_ready_i(ready[Covariance]),
      .covariance_o(covariance),
      .busy_o(busy[Covariance])
    );
  end else begin : gen_covariance
    pu_covariance u_covariance (
      .clk_i,
      .rst_ni,
      .squares_valid_i(valid[Squares]),
      .squares_ready_o(ready[Squares]),
      .squares_i(squares),
      .center_i(center),
      .center_take_o(center_take),
      .covariance_valid_o(valid[Covariance]),
      .covariance_ready_i(ready[Covariance]),
      .covariance_o(covariance),
      .busy_o(busy[Covariance])
    );
  end

  if (pipegs_pkg::Oriented) begin : gen_oriented
    pipegs_pkg::axes_t axes;
    pu_axes u_axes (
      .clk_i,
      .rst_ni,
      .covariance_valid_i(valid[Covariance]),
      .covariance_ready_o(ready[Covariance]),
      .covariance_i(covariance),
      .axes_valid_o(valid[Axes]),
      .axes_ready_i(ready[Axes]),
      .axes_o(axes),
      .busy_o(busy[Axes])
    );
    pu_box u_box (
      .clk_i,
      .rst_ni,
      .axes_valid_i(valid[Axes]),
      .axes_ready_o(ready[Axes]),
      .axes_i(axes),
      .covariance_valid_o(valid[Box]),
      .covariance_ready_i(ready[Box]),
      .covariance_o(boxed),
      .busy_o(busy[Box])
    );
  end else begin : gen_reached
    assign valid[Box:Axes]   = {2{valid[Covariance]}};
    assign ready[Axes]       = ready[Box];
    assign ready[Covariance] = ready[Box];
    assign boxed             = covariance;
    assign busy[Box:Axes]    = '0;
  end

  if (pipegs_pkg::Antialias == 1) begin : gen_compensate
    pu_compensate u_compensate (
      .clk_i,
      .rst_ni,
      .antialias_i(tables_i.antialias),
      .covariance_valid_i(valid[Box]),
      .covariance_ready_o(ready[Box]),
      .covariance_i(boxed),
      .compensated_valid_o(valid[Compensate]),
      .compensated_ready_i(ready[Compensate]),
      .compensated_o(compensated),
      .busy_o(busy[Compensate])
    );
  end else begin : gen_sharp
    assign valid[Compensate] = valid[Box];
    assign ready[Box]        = ready[Compensate];
    assign compensated       = boxed;
    assign busy[Compensate]  = 1'b0;
  end

  if (pipegs_pkg::Pace == 4) begin : gen_four_conic
    pu_four_conic u_conic (
      .clk_i,
      .rst_ni,
      .covariance_valid_i(valid[Compensate]),
      .covariance_ready_o(ready[Compensate]),
      .covariance_i(compensated),
      .conic_valid_o(valid[Conic]),
      .conic_ready_i(ready[Conic]),
      .conic_o,
      .busy_o(busy[Conic])
    );
  end else begin : gen_conic
    pu_conic u_conic (
      .clk_i,
      .rst_ni,
      .covariance_valid_i(valid[Compensate]),
      .covariance_ready_o(ready[Compensate]),
      .covariance_i(compensated),
      .conic_valid_o(valid[Conic]),
      .conic_ready_i(ready[Conic]),
      .conic_o,
      .busy_o(busy[Conic])
    );
  end

  logic unused;  // of the tables only the flag, with Antialias
  assign unused = &{1'b0, tables_i, center_room, center_held, center_count};

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert (!center_valid || center_room)
    else $error("more Gaussians than places for their centres");
  always_ff @(posedge clk_i) if (rst_ni) assert (!center_take || center_held)
    else $error("a centre is not there in time");
  pipegs_stream_check #(.DataW($bits(conic_o))) u_check_conic (
    .clk_i,
    .rst_ni,
    .valid_i(conic_valid_o),
    .ready_i(conic_ready_i),
    .beat_i(conic_o)
  );
`endif

endmodule
