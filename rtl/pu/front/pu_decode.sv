// SPDX-License-Identifier: Apache-2.0
// pu_decode: the geometry of a Gaussian from its code of 16 bytes (Record = 48).
//
// Paper   None: the paper's Gaussians lie in memory as they are worked with.
// Idea    Three components of the quaternion come as codes, the largest is the root of what they leave of one. Scales
//         and opacity out of tables, offsets and colours a shift; see the model.
//           1 the code as it came, out of a memory   2 three squares; all that tables give   3, 4 the root -> output
// Stream  coded in, fetched out, in order; an end beat carries zeros.
// Pace    One per cycle, latency 4; stands still while the output is not taken, with or without a record at it: so
//         pu_cull behind it and this are one pipeline.
// Model   cpp_model/pu/front/pu_decode.hpp

module pu_decode (
  input  logic                 clk_i,
  input  logic                 rst_ni,

  input  logic                 coded_valid_i,
  output logic                 coded_ready_o,
  input  pipegs_pkg::coded_t   coded_i,

  output logic                 fetched_valid_o,
  input  logic                 fetched_ready_i,  // waits for no valid
  output pipegs_pkg::fetched_t fetched_o,

  output logic                 busy_o
);

  localparam int unsigned PosW     = pipegs_pkg::PosW;
  localparam int unsigned QuatW    = pipegs_pkg::QuatW;
  localparam int unsigned ScaleW   = pipegs_pkg::ScaleW;
  localparam int unsigned ScaleMW  = pipegs_pkg::ScaleMW;
  localparam int unsigned ScaleEW  = pipegs_pkg::ScaleEW;
  localparam int unsigned CodeW    = pipegs_pkg::ScaleCodeW;
  localparam int unsigned TurnW    = pipegs_pkg::TurnCodeW;
  localparam int unsigned OpacityW = pipegs_pkg::OpacityW;
  localparam int unsigned BaseW    = pipegs_pkg::BaseW;
  localparam int unsigned Stages   = 4;

  // --- handshake: all stages advance together -----------------------------------------------------------------------
  logic [Stages-1:0] valid_q, load;
  assign load            = {valid_q[Stages-2:0], coded_valid_i} & {Stages{fetched_ready_i}};
  assign coded_ready_o   = fetched_ready_i;
  assign fetched_valid_o = valid_q[Stages-1];
  assign busy_o          = valid_q != '0;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else if (fetched_ready_i) valid_q <= {valid_q[Stages-2:0], coded_valid_i};
  end

  pipegs_pkg::coded_t coded_q;
  pipegs_pkg::code_t  code;
  always_ff @(posedge clk_i) if (load[0]) coded_q <= coded_i;
  assign code = coded_q.code;

  // --- scales: 8 times 2^scale_exp, less the code's sixteenths of an octave -----------------------------------------
  localparam int unsigned PlaceW = ScaleEW + 6;  // signed, sixteenths
  localparam logic signed [PlaceW-1:0] Most = PlaceW'((16 << ScaleEW) - 1);
  function automatic logic [ScaleW-1:0] scale(input logic [CodeW-1:0] steps);
    logic signed [PlaceW-1:0] place;
    place = $signed(PlaceW'({coded_q.scale_exp, 4'd0})) + PlaceW'(48) - $signed(PlaceW'(steps));
    if (place > Most) place = Most;
    scale = {place[ScaleEW+3:4], pipegs_pkg::ScaleSteps[ScaleMW*32'(place[3:0]) +: ScaleMW]};
    if (steps == '1 || place < PlaceW'(16)) scale = '0;
  endfunction

  // --- rotation: three components times sqrt(1/2), the square of the fourth ------------------------------------------
  localparam int unsigned TurnDown = 16 + TurnW - 1 - (QuatW - 1);
  localparam int unsigned ProductW = TurnW + 17;
  function automatic logic signed [QuatW-1:0] turned(input logic signed [TurnW-1:0] turn);
    logic signed [ProductW-1:0] product;
    product = ProductW'(turn) * $signed(ProductW'(46341)) + $signed(ProductW'(1) << (TurnDown - 1));
    turned  = QuatW'(product >>> TurnDown);
  endfunction
  localparam int unsigned RootW = 18;       // u1.17
  localparam int unsigned SumW  = 2 * TurnW + 1;
  logic [SumW-1:0]  squares;
  logic [RootW-1:0] rest_q, root;
  function automatic logic [SumW-1:0] square(input logic signed [TurnW-1:0] turn);
    square = SumW'($unsigned((2*TurnW)'(turn) * (2*TurnW)'(turn)));
  endfunction
  assign squares = square(code.turn_0) + square(code.turn_1) + square(code.turn_2);

  // --- what rides along beside the root: all but the largest component -----------------------------------------------
  localparam int unsigned HeaderW = pipegs_pkg::FetchedBits - 3 * PosW - 4 * QuatW - 3 * ScaleW - OpacityW - 3 * BaseW -
                                    pipegs_pkg::IndexW - pipegs_pkg::SlotW;
  typedef struct packed {
    logic [pipegs_pkg::SlotW-1:0]                                   slot;
    logic [2:0][pipegs_pkg::BaseCodeW-1:0]                          base;
    logic                                                           data;
    logic [OpacityW-1:0]                                            opacity;
    logic [2:0][ScaleW-1:0]                                         scale;
    logic [2:0][QuatW-1:0]                                          turn;
    logic [pipegs_pkg::AxisW-1:0]                                   axis;
    logic [2:0][pipegs_pkg::OffsetCodeW-1:0]                        offset;
    logic [HeaderW-1:0]                                             header;
  } ride_t;
  ride_t ride, ride_q [1:Stages-1];
  logic  data;
  wire [pipegs_pkg::CodedBits-1:0] coded_bits = coded_q;
  assign data         = coded_q.kind == pipegs_pkg::KindData;
  assign ride.header  = coded_bits[HeaderW-1:0];
  assign ride.offset  = {code.offset_z, code.offset_y, code.offset_x};
  assign ride.axis    = code.axis;
  assign ride.turn    = {turned(code.turn_2), turned(code.turn_1), turned(code.turn_0)};
  assign ride.scale   = {scale(code.scale_2), scale(code.scale_1), scale(code.scale_0)} & {3 * ScaleW{data}};
  assign ride.opacity = pipegs_pkg::OpacityCodes[OpacityW*32'(code.opacity) +: OpacityW] & {OpacityW{data}};
  assign ride.data    = data;
  assign ride.base    = {code.base_b, code.base_g, code.base_r};
  assign ride.slot    = coded_q.slot;
  always_ff @(posedge clk_i) begin
    if (load[1]) begin
      ride_q[1] <= ride;
      rest_q    <= squares > SumW'(1 << 17) ? '0 : RootW'(SumW'(1 << 17) - squares);
    end
    for (int unsigned i = 2; i < Stages; i += 1) if (load[i]) ride_q[i] <= ride_q[i-1];
  end

  pipegs_sqrt u_root (
    .clk_i,
    .enable_i(fetched_ready_i),
    .v_i     (rest_q),
    .root_o  (root)
  );

  // --- output --------------------------------------------------------------------------------------------------------
  localparam int unsigned RootDown = RootW - 1 - (QuatW - 1);
  ride_t            last;
  logic [RootW-1:0] near;
  logic [QuatW-1:0] largest;
  assign last = ride_q[Stages-1];
  assign near    = (root >> RootDown) + RootW'(root[RootDown-1]);
  assign largest = !last.data ? '0 : near[QuatW-1] ? {1'b0, {(QuatW - 1){1'b1}}} : near[QuatW-1:0];  // one does not fit

  function automatic logic signed [PosW-1:0] offset(input logic [pipegs_pkg::OffsetCodeW-1:0] code_of);
    offset = PosW'($signed(code_of)) <<< (PosW - pipegs_pkg::OffsetCodeW);
  endfunction
  localparam int unsigned BaseUp = BaseW - 3 - (pipegs_pkg::BaseCodeW - 1);
  function automatic logic signed [BaseW-1:0] base(input logic signed [pipegs_pkg::BaseCodeW-1:0] code_of);
    base = last.data ? (BaseW'(code_of) + $signed(BaseW'(64))) <<< BaseUp : '0;
  endfunction
  typedef struct packed {logic [3:0][QuatW-1:0] of;} quaternion_t;
  quaternion_t quaternion;
  always_comb begin
    quaternion.of[0] = last.axis == 2'd0 ? largest : last.turn[0];
    quaternion.of[1] = last.axis == 2'd1 ? largest : last.axis == 2'd0 ? last.turn[0] : last.turn[1];
    quaternion.of[2] = last.axis == 2'd2 ? largest : last.axis == 2'd3 ? last.turn[2] : last.turn[1];
    quaternion.of[3] = last.axis == 2'd3 ? largest : last.turn[2];
  end
  assign fetched_o = {last.slot, pipegs_pkg::IndexW'(last.slot),
                      base(last.base[2]), base(last.base[1]), base(last.base[0]), last.opacity, last.scale,
                      quaternion, offset(last.offset[2]), offset(last.offset[1]), offset(last.offset[0]), last.header};

  wire unused_bits = &{1'b0, near, coded_bits};

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits(fetched_o))) u_check_fetched (
    .clk_i,
    .rst_ni,
    .valid_i(fetched_valid_o),
    .ready_i(fetched_ready_i),
    .beat_i (fetched_o)
  );
`endif

endmodule
