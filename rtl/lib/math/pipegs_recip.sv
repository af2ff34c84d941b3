// SPDX-License-Identifier: Apache-2.0
// pipegs_recip: the reciprocal of a normalised mantissa.
//
// Idea    A table of 64 lines gives 1/v to 2^-14.8: y0 = c0[i] - c1[i] d. One Newton step squares the error:
//           e = 1 - v y0;   y = y0 (1 + e) = (1 - e^2) / v
// Numbers x is u1.(W-1) with its leading one, v = x 2^-(W-1) in [1, 2). y is u0.W with its leading one: 1/v = y 2^-W.
//         v = 1 saturates to 1 - 2^-W, so y is always normalised. At most 1 unit in the last place wrong.
// Stream  No back-pressure: what comes with in_valid_i leaves with out_valid_o four cycles later.
// Pace    One per cycle, latency 4.
// Model   cpp_model/lib/math/recip.hpp

module pipegs_recip #(
  parameter int unsigned DataW = pipegs_pkg::MantissaW  // 18 to 28
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic             in_valid_i,
  input  logic [DataW-1:0] in_i,

  output logic             out_valid_o,
  output logic [DataW-1:0] out_o
);

  localparam int unsigned WorkW  = 28;  // v, u1.27
  localparam int unsigned IndexW = 6;
  localparam int unsigned StepW  = 12;  // d, unit 2^-18
  localparam int unsigned ValueW = 18;  // c0 and y0, u0.18
  localparam int unsigned SlopeW = 11;  // c1, u0.11
  localparam int unsigned ErrorW = 19;  // e, s-14.32
  localparam int unsigned OutF   = 50;  // fraction of y before rounding
  localparam int unsigned Cut    = OutF - DataW;

  // {c0, c1} of the 64 intervals of v.
  function automatic logic [ValueW+SlopeW-1:0] line(input logic [IndexW-1:0] index);
    case (index)
      6'd0:    line = {18'd262135, 11'd2016};
      6'd1:    line = {18'd258102, 11'd1955};
      6'd2:    line = {18'd254192, 11'd1897};
      6'd3:    line = {18'd250398, 11'd1841};
      6'd4:    line = {18'd246717, 11'd1788};
      6'd5:    line = {18'd243141, 11'd1737};
      6'd6:    line = {18'd239668, 11'd1688};
      6'd7:    line = {18'd236292, 11'd1641};
      6'd8:    line = {18'd233011, 11'd1596};
      6'd9:    line = {18'd229819, 11'd1553};
      6'd10:   line = {18'd226713, 11'd1511};
      6'd11:   line = {18'd223691, 11'd1472};
      6'd12:   line = {18'd220747, 11'd1433};
      6'd13:   line = {18'd217881, 11'd1397};
      6'd14:   line = {18'd215087, 11'd1361};
      6'd15:   line = {18'd212365, 11'd1327};
      6'd16:   line = {18'd209711, 11'd1295};
      6'd17:   line = {18'd207122, 11'd1263};
      6'd18:   line = {18'd204596, 11'd1233};
      6'd19:   line = {18'd202131, 11'd1203};
      6'd20:   line = {18'd199725, 11'd1175};
      6'd21:   line = {18'd197375, 11'd1148};
      6'd22:   line = {18'd195080, 11'd1121};
      6'd23:   line = {18'd192838, 11'd1096};
      6'd24:   line = {18'd190646, 11'd1071};
      6'd25:   line = {18'd188504, 11'd1047};
      6'd26:   line = {18'd186410, 11'd1024};
      6'd27:   line = {18'd184362, 11'd1002};
      6'd28:   line = {18'd182358, 11'd980};
      6'd29:   line = {18'd180397, 11'd960};
      6'd30:   line = {18'd178478, 11'd939};
      6'd31:   line = {18'd176599, 11'd920};
      6'd32:   line = {18'd174760, 11'd901};
      6'd33:   line = {18'd172958, 11'd882};
      6'd34:   line = {18'd171194, 11'd865};
      6'd35:   line = {18'd169464, 11'd847};
      6'd36:   line = {18'd167770, 11'd831};
      6'd37:   line = {18'd166108, 11'd814};
      6'd38:   line = {18'd164480, 11'd798};
      6'd39:   line = {18'd162883, 11'd783};
      6'd40:   line = {18'd161317, 11'd768};
      6'd41:   line = {18'd159781, 11'd754};
      6'd42:   line = {18'd158274, 11'd740};
      6'd43:   line = {18'd156794, 11'd726};
      6'd44:   line = {18'd155343, 11'd713};
      6'd45:   line = {18'd153918, 11'd700};
      6'd46:   line = {18'd152518, 11'd687};
      6'd47:   line = {18'd151144, 11'd675};
      6'd48:   line = {18'd149795, 11'd663};
      6'd49:   line = {18'd148469, 11'd651};
      6'd50:   line = {18'd147167, 11'd640};
      6'd51:   line = {18'd145887, 11'd629};
      6'd52:   line = {18'd144629, 11'd618};
      6'd53:   line = {18'd143394, 11'd608};
      6'd54:   line = {18'd142178, 11'd597};
      6'd55:   line = {18'd140983, 11'd587};
      6'd56:   line = {18'd139809, 11'd578};
      6'd57:   line = {18'd138653, 11'd568};
      6'd58:   line = {18'd137516, 11'd559};
      6'd59:   line = {18'd136398, 11'd550};
      6'd60:   line = {18'd135298, 11'd541};
      6'd61:   line = {18'd134216, 11'd533};
      6'd62:   line = {18'd133151, 11'd524};
      default: line = {18'd132102, 11'd516};
    endcase
  endfunction

  logic [WorkW-1:0]  v, v1_q, v2_q;
  logic [ValueW-1:0] value_q, y0_q, y1_q;
  logic [SlopeW-1:0] slope_q;

  assign v = {in_i, {(WorkW - DataW){1'b0}}};

  // 2: the line's value at d.
  logic [SlopeW+StepW-1:0] drop;
  assign drop = (SlopeW + StepW)'(slope_q) * (SlopeW + StepW)'(v1_q[WorkW-2-IndexW-:StepW]);

  // 3: e = 1 - v y0, unit 2^-45. |e| < 2^-14, so the high bits of the product are only the sign.
  logic [WorkW+ValueW-1:0]  product;
  logic [ErrorW+12:0]       rest;
  logic signed [ErrorW-1:0] error_q;
  assign product = (WorkW + ValueW)'(v2_q) * (WorkW + ValueW)'(y0_q);
  assign rest    = -product[ErrorW+12:0];

  // 4: y = y0 (1 + e), rounded to nearest.
  logic signed [OutF:0]          correction;
  logic        [OutF:0]          sum;
  logic        [DataW-1:0]       out_q;
  assign correction = (OutF + 1)'($signed({1'b0, y1_q})) * (OutF + 1)'(error_q);
  assign sum        = {1'b0, y1_q, {(OutF - ValueW){1'b0}}} + $unsigned(correction) + ((OutF + 1)'(1) << (Cut - 1));
  assign out_o      = out_q;

  logic [3:0] valid_q, load;  // a stage's registers are clocked for a value only
  assign load        = {valid_q[2:0], in_valid_i};
  assign out_valid_o = valid_q[3];
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else         valid_q <= load;
  end

  always_ff @(posedge clk_i) begin
    if (load[0]) begin
      {value_q, slope_q} <= line(v[WorkW-2:WorkW-1-IndexW]);
      v1_q <= v;
    end
    if (load[1]) begin
      y0_q <= value_q - ValueW'(drop >> SlopeW);
      v2_q <= v1_q;
    end
    if (load[2]) begin
      error_q <= $signed(rest[ErrorW+12:13]);
      y1_q    <= y0_q;
    end
    if (load[3]) out_q <= sum[OutF] ? '1 : sum[OutF-1:Cut];
  end

  wire unused_sum = &{1'b0, sum[Cut-1:0], product[WorkW+ValueW-1:ErrorW+13], rest[12:0]};

endmodule
