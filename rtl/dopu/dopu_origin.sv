// SPDX-License-Identifier: Apache-2.0
// dopu_origin: the centre of a chunk in view space, block-normalised for the PU.
//
// Paper   Sec. 4.2 (world to view).
// Idea    origin = W (centre - camera), exact: the difference is cut into a low half of LowW bits and a high half, and
//         three multipliers make one row's sum of one half per cycle. Then the exponent, and three rounding shifts.
//           view_exp = max(0, L + 2 - ViewW), L = max(bit length of the largest |origin_i|, PosW + offset_exp)
// Stream  node in (or an end, which passes unchanged); chunk out.
// Pace    One chunk in 10 cycles, latency 14: products and shifts of two chunks overlap.
// Model   cpp_model/dopu/dopu_origin.hpp

module dopu_origin (
  input  logic                            clk_i,
  input  logic                            rst_ni,

  input  pipegs_pkg::position_t           position_i,
  input  pipegs_pkg::rotation_t           rotation_i,

  input  logic                            node_valid_i,
  output logic                            node_ready_o,
  input  logic [pipegs_pkg::KindW-1:0]    kind_i,
  input  logic [pipegs_pkg::PlaceW-1:0]   place_i,  // its window and walk
  input  pipegs_pkg::node_t               node_i,
  input  logic [pipegs_pkg::DepthW-1:0]   mark_i,   // a layer end's watermark, if there are any

  output logic                            chunk_valid_o,
  input  logic                            chunk_ready_i,
  output pipegs_pkg::chunk_t              chunk_o,

  output logic                            active_o  // something is inside
);

  localparam int unsigned WorldW = pipegs_pkg::WorldW;
  localparam int unsigned RotW = pipegs_pkg::RotW;
  localparam int unsigned RotF = pipegs_pkg::RotF;
  localparam int unsigned ViewW = pipegs_pkg::ViewW;
  localparam int unsigned ExpW = pipegs_pkg::ExpW;
  localparam int unsigned PlaceW = pipegs_pkg::PlaceW;
  localparam int unsigned BodyAt = pipegs_pkg::KindW + PlaceW;  // where in a chunk the rest begins
  localparam int unsigned DeltaW = WorldW + 1;
  localparam int unsigned LowW = DeltaW / 2;               // bits of the low half, unsigned
  localparam int unsigned HalfW = DeltaW - LowW + 1;       // either half with a sign
  localparam int unsigned ProductW = RotW + HalfW;
  localparam int unsigned OriginW = DeltaW + RotW + 2;     // s44.24
  localparam int unsigned LengthW = ExpW + 1;
  localparam logic [3:0] LastStep = 4'd8;

  // --- products: step k takes operands k (row k / 2, half k % 2), multiplies k - 1, sums k - 2 ---------------------
  logic                         busy_q, done, take;
  logic [3:0]                   step_q, added;
  logic                         handover;  // the sums move on to the shifts
  logic [pipegs_pkg::KindW-1:0] kind_q;
  logic [PlaceW-1:0]            place_q;
  logic [ExpW-1:0]              offset_exp_q;
  logic [pipegs_pkg::SlotW-1:0] slot_q;
  logic [pipegs_pkg::CountW-1:0] count_q;
  logic signed [DeltaW-1:0]     delta_x_q, delta_y_q, delta_z_q;
  logic signed [RotW-1:0]       w0, w1, w2, w0_q, w1_q, w2_q;
  logic signed [HalfW-1:0]      x_q, y_q, z_q;
  logic signed [ProductW-1:0]   px_q, py_q, pz_q;
  logic signed [OriginW-1:0]    sum, low_q, row;
  logic signed [OriginW-1:0]    origin_q [3];
  logic [OriginW-1:0]           magnitudes_q;

  assign node_ready_o = !busy_q;
  assign take         = node_valid_i && node_ready_o;
  assign done         = busy_q && step_q == LastStep;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      busy_q <= 1'b0;
      step_q <= '0;
    end else begin
      if (take) begin
        busy_q <= 1'b1;
        step_q <= kind_i == pipegs_pkg::KindData ? '0 : LastStep;  // an end has nothing to compute
      end else if (busy_q && step_q != LastStep) begin
        step_q <= step_q + 1'b1;
      end else if (handover) begin
        busy_q <= 1'b0;
      end
    end
  end

  always_comb begin
    case (step_q[3:1])
      3'd0: begin w0 = rotation_i.w00; w1 = rotation_i.w01; w2 = rotation_i.w02; end
      3'd1: begin w0 = rotation_i.w10; w1 = rotation_i.w11; w2 = rotation_i.w12; end
      default: begin w0 = rotation_i.w20; w1 = rotation_i.w21; w2 = rotation_i.w22; end
    endcase
  end
  assign added = step_q - 4'd2;
  assign sum   = OriginW'(px_q) + OriginW'(py_q) + OriginW'(pz_q);
  assign row   = low_q + (sum <<< LowW);

  always_ff @(posedge clk_i) begin
    if (take) begin
      kind_q       <= kind_i;
      place_q      <= place_i;
      offset_exp_q <= node_i.offset_exp;
      slot_q       <= node_i.first;
      count_q      <= node_i.count;
      delta_x_q    <= DeltaW'(node_i.center_x) - DeltaW'(position_i.x);
      delta_y_q    <= DeltaW'(node_i.center_y) - DeltaW'(position_i.y);
      delta_z_q    <= DeltaW'(node_i.center_z) - DeltaW'(position_i.z);
    end
    w0_q <= w0;
    w1_q <= w1;
    w2_q <= w2;
    x_q  <= step_q[0] ? HalfW'(delta_x_q >>> LowW) : HalfW'({1'b0, delta_x_q[LowW-1:0]});
    y_q  <= step_q[0] ? HalfW'(delta_y_q >>> LowW) : HalfW'({1'b0, delta_y_q[LowW-1:0]});
    z_q  <= step_q[0] ? HalfW'(delta_z_q >>> LowW) : HalfW'({1'b0, delta_z_q[LowW-1:0]});
    px_q <= ProductW'(w0_q) * ProductW'(x_q);
    py_q <= ProductW'(w1_q) * ProductW'(y_q);
    pz_q <= ProductW'(w2_q) * ProductW'(z_q);
    if (!added[0]) low_q <= sum;
    if (step_q == '0) magnitudes_q <= '0;
    for (int unsigned i = 0; i < 3; i += 1) begin
      if (busy_q && added == 4'(2 * i + 1)) begin
        origin_q[i]  <= row;
        magnitudes_q <= magnitudes_q | (row[OriginW-1] ? ~row : row);
      end
    end
  end

  // --- shifts: x, y, z through one rounding shifter -----------------------------------------------------------------
  localparam int unsigned WholeW = OriginW - RotF;  // of a number without its fraction
  logic [$clog2(WholeW+1)-1:0] length;
  logic [LengthW-1:0]        reach, longest;
  logic [ExpW-1:0]           view_exp_q;
  logic [1:0]                shift_step_q;  // 0 to 2: x, y, z; 3: stands at the output
  logic                      shifting_q;
  logic signed [OriginW-RotF:0] source_q [3];  // one bit below the unit is kept for rounding
  logic signed [OriginW-RotF:0] shifted;
  logic signed [ViewW-1:0]   rounded;
  pipegs_pkg::chunk_t        chunk_q;  // but for its place and watermark
  logic [PlaceW-1:0]         place_out_q;

  pipegs_bit_length #(.DataW(WholeW)) u_length (
    .in_i(magnitudes_q[OriginW-1:RotF]),
    .length_o(length)
  );
  assign reach         = LengthW'(offset_exp_q) + LengthW'(pipegs_pkg::PosW);
  assign longest       = LengthW'(length) > reach ? LengthW'(length) : reach;
  assign handover      = done && (!shifting_q || (shift_step_q == 2'd3 && chunk_ready_i));
  assign shifted       = source_q[0] >>> view_exp_q;
  assign rounded       = ViewW'(shifted >>> 1) + ViewW'({1'b0, shifted[0]});
  assign chunk_valid_o = shifting_q && shift_step_q == 2'd3;
  assign active_o      = busy_q || shifting_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      shifting_q   <= 1'b0;
      shift_step_q <= '0;
    end else if (handover) begin
      shifting_q   <= 1'b1;
      shift_step_q <= kind_q == pipegs_pkg::KindData ? '0 : 2'd3;
    end else if (shifting_q && shift_step_q != 2'd3) begin
      shift_step_q <= shift_step_q + 1'b1;
    end else if (chunk_ready_i) begin
      shifting_q   <= 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (handover) begin
      for (int unsigned i = 0; i < 3; i += 1) source_q[i] <= origin_q[i][OriginW-1:RotF-1];
      view_exp_q       <= longest > LengthW'(ViewW - 2) ? ExpW'(longest - LengthW'(ViewW - 2)) : '0;
      chunk_q          <= '0;
      chunk_q.kind     <= kind_q;
      place_out_q      <= place_q;
      if (kind_q == pipegs_pkg::KindData) begin
        chunk_q.offset_exp <= offset_exp_q;
        chunk_q.slot       <= slot_q;
        chunk_q.count      <= count_q;
      end
    end else if (shift_step_q != 2'd3) begin
      source_q[0] <= source_q[1];
      source_q[1] <= source_q[2];
      if (shift_step_q == 2'd0) chunk_q.origin_x <= rounded;
      if (shift_step_q == 2'd1) chunk_q.origin_y <= rounded;
      if (shift_step_q == 2'd2) chunk_q.origin_z <= rounded;
      chunk_q.view_exp <= view_exp_q;
    end
  end

  // The place stands behind the kind. A watermark passes like the end that carries it: it is the chunk's last field.
  logic [pipegs_pkg::ChunkBits-1:0] beat;
  if (pipegs_pkg::Coded) begin : gen_scale
    localparam int unsigned ScaleEW = pipegs_pkg::ScaleEW;
    localparam int unsigned ScaleAt = BodyAt + 3 * ViewW + 2 * ExpW;  // behind offset_exp
    logic [ScaleEW-1:0] scale_exp_q, scale_out_q;
    always_ff @(posedge clk_i) begin
      if (take) scale_exp_q <= node_i.scale_max[pipegs_pkg::ScaleW-1 -: ScaleEW];
      if (handover) scale_out_q <= kind_q == pipegs_pkg::KindData ? scale_exp_q : '0;
    end
    always_comb begin
      beat                     = chunk_q;
      beat[ScaleAt +: ScaleEW] = scale_out_q;
    end
  end else begin : gen_no_scale
    assign beat = chunk_q;
  end
  if (pipegs_pkg::HasWatermarks) begin : gen_mark
    localparam int unsigned DepthW = pipegs_pkg::DepthW;
    logic [DepthW-1:0] mark_taken_q, mark_q;
    always_ff @(posedge clk_i) begin
      if (take) mark_taken_q <= mark_i;
      if (handover) mark_q <= mark_taken_q;
    end
    assign chunk_o = {mark_q, beat[pipegs_pkg::ChunkBits-DepthW-1:BodyAt], place_out_q, chunk_q.kind};
  end else begin : gen_no_mark
    assign chunk_o = {beat[pipegs_pkg::ChunkBits-1:BodyAt], place_out_q, chunk_q.kind};
  end

  logic unused;  // fields and bits that do not matter here
  assign unused = &{1'b0, node_i, mark_i, beat, shifted, magnitudes_q[RotF-1:0], origin_q[0], origin_q[1],
                  origin_q[2]};

`ifndef SYNTHESIS
  pipegs_stream_check #(.DataW($bits(chunk_o))) u_check_chunk (
    .clk_i,
    .rst_ni,
    .valid_i(chunk_valid_o),
    .ready_i(chunk_ready_i),
    .beat_i(chunk_o)
  );
`endif

endmodule
