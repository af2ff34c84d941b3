// SPDX-License-Identifier: Apache-2.0
// ru_live: blends of each region only the quads of 2x2 pixels that a splat changes.
//
// Paper   Sec. 4.2.3, Table 2. The paper's lanes work on whole regions (ru_whole).
// Idea    ru_regions -> ru_power -> 4 x ru_quads, each with the bank of pixels that holds its quads; ru_drain brings a
//         finished window out of the banks. Column (g + 2 row) mod 4 of the quads of a row belongs to group g, so a
//         row of quads is one word of each bank.
// Stream  sorted_t in; an end is taken when all before it is blended. Pixels to external memory. Taps: lane g of this
//         RU is its group g.
// Pace    One region per cycle into the powers, one quad per cycle and group out of them.
// Model   cpp_model/ru/ru_quads.hpp

module ru_live #(
  localparam int unsigned Regions   = pipegs_pkg::Regions,
  localparam int unsigned Units     = pipegs_pkg::Units,
  localparam int unsigned Groups    = pipegs_pkg::RuGroups,
  localparam int unsigned Lanes     = 16,
  localparam int unsigned WordW     = Lanes * (pipegs_pkg::TW + 3 * pipegs_pkg::RgbW + 1),
  localparam int unsigned Words     = Regions / Units * 4,
  localparam int unsigned AddrW     = $clog2(Words),
  localparam int unsigned Slots     = Regions / Units,
  localparam int unsigned SideW     = $clog2(pipegs_pkg::Window) + 1,
  localparam int unsigned ShownIndexW = pipegs_pkg::ShownIndexW,
  localparam int unsigned RegionW   = pipegs_pkg::RegionW,
  localparam int unsigned RangeW    = pipegs_pkg::ExpW,
  localparam int unsigned Kinds     = pipegs_pkg::AovKinds,
  localparam int unsigned AddressW  = pipegs_pkg::AddressW
) (
  input  logic                              clk_i,
  input  logic                              rst_ni,
  input  logic [pipegs_pkg::TW-1:0]         rest_i,  // transmittance at which pixels stop, of the frame; 0: 1/TCut
  input  logic                              restart_i,

  input  logic                              in_valid_i,
  output logic                              in_ready_o,
  input  pipegs_pkg::sorted_t               in_i,

  input  logic [Regions-1:0]                own_i,
  input  logic [Regions-1:0]                unwritten_i,  // regions whose pixels do not go to memory
  input  logic [pipegs_pkg::Eyes-1:0]       unseen_i,   // eyes whose pictures are not made
  input  logic [AddressW-1:0]               eye_lines_i,  // from the first one's pixels to the second one's
  input  logic [SideW-1:0]                  columns_i,  // pixels of the window inside the image; in the cycle behind
  input  logic [SideW-1:0]                  rows_i,     // restart_i or window_done_o they are those of the next one
  output logic [Regions-1:0]                done_o,     // own regions that need nothing more

  input  logic                              joined_i,   // windows end together with those of the RU that shares lines
  input  logic                              pair_at_end_i,  // it has nothing left of its window
  input  logic [Slots-1:0]                  pair_wanted_i,  // what its next splat waits for
  output logic                              at_end_o,   // the same of this one
  output logic [Slots-1:0]                  wanted_o,

  input  logic [RangeW-1:0]                 range_i,    // of depths, for AOVs: 2^(range + 1) world units
  input  logic [Kinds-1:0]                  wanted_aovs_i,  // AOVs that the frame writes
  input  logic [Kinds*AddressW-1:0]         ahead_i,    // how many lines they lie behind the pixels
  input  logic                              raster_i,   // pixels in raster order, else by windows
  input  logic [pipegs_pkg::StrideW-1:0]    stride_i,   // lines from row to row, in raster order
  input  logic [pipegs_pkg::AddressW-1:0]   line_i,     // first one of the window's pixels
  output logic                              store_valid_o,
  input  logic                              store_ready_i,
  output logic [pipegs_pkg::AddressW-1:0]   store_address_o,
  output logic [pipegs_pkg::HalvesW-1:0]    store_halves_o,  // of the line
  output logic                              store_wide_o,    // both are in the picture
  output logic [pipegs_pkg::MemoryW-1:0]    store_data_o,

  output logic                              layer_done_o,
  output logic                              window_done_o,
  output logic                              issue_o,    // a quad starts
  output logic                              idle_o,     // nothing inside, all pixels written

  output logic [Groups-1:0]                 tap_line_valid_o,
  output logic [Groups*ShownIndexW-1:0]       tap_line_index_o,
  output logic [Groups*RegionW-1:0]         tap_line_region_o,
  output logic [Groups*2-1:0]               tap_line_quarter_o,
  output logic [Groups*pipegs_pkg::TapLineW-1:0] tap_line_o,
  output logic [Groups-1:0]                 tap_word_valid_o,
  output logic [Groups*RegionW-1:0]         tap_word_region_o,
  output logic [Groups*2-1:0]               tap_word_quarter_o,
  output logic [Groups*pipegs_pkg::TapWordW-1:0] tap_word_o
);

  localparam int unsigned PartSide = pipegs_pkg::PartRegionsX;
  localparam int unsigned PartsX   = pipegs_pkg::PartsX;
  localparam int unsigned Squares  = pipegs_pkg::Squares;
  localparam int unsigned MaskW    = pipegs_pkg::MaskW;  // regions of a part
  localparam int unsigned ColorsW  = pipegs_pkg::RuColorsW;
  localparam int unsigned TW       = pipegs_pkg::TW;
  localparam int unsigned PixelsW  = 3 * pipegs_pkg::RgbW;
  localparam int unsigned BankW    = WordW / Groups;
  localparam int unsigned AovsW    = pipegs_pkg::HasAovs ? Lanes / Groups * pipegs_pkg::AovBits : 1;  // of a bank
  localparam int unsigned StoredW  = pipegs_pkg::HasAovs ? AovsW + BankW : BankW;
  localparam int unsigned PairW    = 8 * pipegs_pkg::ExponentBits;
  localparam int unsigned Side     = pipegs_pkg::Window / 2;  // quads

  // --- a window begins -----------------------------------------------------------------------------------------------
  logic             clear_q;
  logic [Side-1:0]  columns_out, rows_out;  // columns and rows of quads outside the image
  typedef struct packed {logic [Groups-1:0][Words-1:0] outside, stopped;} words_t;  // of each group
  typedef struct packed {logic [Groups*Slots-1:0][3:0] of;} rows_t;                 // of each group's slots
  typedef struct packed {logic [Slots-1:0][Units-1:0] of;} slots_t;                 // a slot's regions
  logic [Groups*Words-1:0] outside;  // [group, slot, row]: as the groups hold them
  words_t              words;
  rows_t               stopped;
  slots_t              own_out;             // own regions whose pixels do not go to memory
  logic [Slots-1:0]    slots_out;           // slots whose pixels do not go to memory
  logic [Slots-1:0]    slots_stopped;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) clear_q <= 1'b0;
    else clear_q <= restart_i || window_done_o;
  end
  for (genvar i = 0; i < Side; i += 1) begin : gen_side
    assign columns_out[i] = columns_i <= SideW'(2 * i);
    assign rows_out[i]    = rows_i <= SideW'(2 * i);
  end
  // A slot is one of Units regions side by side, another one for each RU. Asked for only when a window begins: so a
  // simulator need not find it out in every cycle, nor its gates switch.
  for (genvar g = 0; g < Groups; g += 1) begin : gen_outside
    for (genvar r = 0; r < 4; r += 1) begin : gen_row
      logic [Slots-1:0] of_slots;
      always_comb begin
        of_slots = '0;
        if (clear_q) begin
          for (int unsigned region = 0; region < Regions; region += 1) begin
            of_slots[region/Units] |= own_i[region] &&
                ((pipegs_pkg::Eyes > 1 && unseen_i[region/MaskW/Squares]) ||
                 rows_out[4*(region/MaskW%Squares/PartsX*PartSide + region%MaskW/PartSide) + r] ||
                 columns_out[4*(region/MaskW%PartsX*PartSide + region%MaskW%PartSide) + (g+2*r)%4]);
          end
        end
      end
      for (genvar s = 0; s < Slots; s += 1) begin : gen_slot
        assign outside[Words*g+4*s+r] = of_slots[s];
      end
    end
  end
  assign words.outside = outside;
  assign stopped       = words.stopped;
  assign own_out       = own_i & unwritten_i;
  for (genvar i = 0; i < Slots; i += 1) begin : gen_slot
    logic [Groups-1:0] all;
    for (genvar g = 0; g < Groups; g += 1) begin : gen_all
      assign all[g] = stopped.of[g*Slots+i] == '1;
    end
    assign slots_stopped[i] = all == '1;
    assign slots_out[i]     = own_out.of[i] != '0;
  end
  for (genvar i = 0; i < Regions; i += 1) begin : gen_done
    assign done_o[i] = own_i[i] && !clear_q && slots_stopped[i/Units];
  end

  // --- splats -> regions -> powers -----------------------------------------------------------------------------------
  typedef struct packed {  // of each group
    logic [Groups-1:0][1:0]       live;
    logic [Groups-1:0][PairW-1:0] of;
  } pairs_t;
  logic                         region_valid, region_ready, regions_busy, power_busy, end_valid, ended;
  logic [pipegs_pkg::KindW-1:0] end_kind;
  pipegs_pkg::region_t          region;
  logic [ColorsW-1:0]           region_color, color;
  logic [Groups-1:0]            half_valid, half_ready, group_issue, group_busy;
  pairs_t                       pairs;
  logic                         half;
  logic [RegionW-1:0]           half_region;
  logic [ShownIndexW-1:0]         half_index;

  logic [Slots-1:0]             held;
  logic [Regions-1:0]           wants;
  slots_t                       held_regions, own_wants;
  logic                         drained;

  ru_regions u_regions (
    .clk_i,
    .rst_ni,
    .open_i(own_i & ~done_o),
    .hold_i(clear_q),
    .held_i(held_regions),
    .wants_o(wants),
    .range_i,
    .in_valid_i,
    .in_ready_o,
    .in_i,
    .region_valid_o(region_valid),
    .region_ready_i(region_ready),
    .region_o(region),
    .color_o(region_color),
    .end_valid_o(end_valid),
    .end_kind_o(end_kind),
    .end_ready_i(ended),
    .busy_o(regions_busy)
  );
  ru_power u_power (
    .clk_i,
    .rst_ni,
    .stopped_i(stopped),
    .region_valid_i(region_valid),
    .region_ready_o(region_ready),
    .region_i(region),
    .color_i(region_color),
    .out_push_o(half_valid),
    .out_room_i(half_ready),
    .out_live_o(pairs.live),
    .out_o(pairs.of),
    .out_half_o(half),
    .out_region_o(half_region),
    .out_color_o(color),
    .out_index_o(half_index),
    .busy_o(power_busy)
  );
  logic empty;
  assign empty         = end_valid && !power_busy && group_busy == '0;
  assign at_end_o      = empty && end_kind == pipegs_pkg::KindWindowEnd && drained;
  assign ended         = end_kind == pipegs_pkg::KindWindowEnd ? at_end_o && (!joined_i || pair_at_end_i) : empty;
  assign layer_done_o  = ended;
  assign window_done_o = ended && end_kind == pipegs_pkg::KindWindowEnd;

  // --- the pixels' way out -------------------------------------------------------------------------------------------
  logic             job, drain_idle;
  logic [AddrW-1:0] job_address;
  typedef struct packed {
    logic [Lanes-1:0]              done;
    logic [Lanes-1:0][TW-1:0]      t;
    logic [Lanes-1:0][PixelsW-1:0] rgb;
  } row_t;
  row_t             row;
  logic [Groups*AovsW-1:0] row_aovs;  // of each pixel
  logic [2:0]       job_q, odd_q;  // jobs of one, two, three cycles ago, and their rows of quads
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) job_q <= '0;
    else job_q <= {job_q[1:0], job};
  end
  always_ff @(posedge clk_i) odd_q <= {odd_q[1:0], job_address[0]};

  assign own_wants = wants & own_i;
  for (genvar i = 0; i < Slots; i += 1) begin : gen_held
    assign held_regions.of[i] = {Units{held[i]}};
    assign wanted_o[i]        = own_wants.of[i] != '0;
  end
  ru_drain u_drain (
    .clk_i,
    .rst_ni,
    .own_i,
    .raster_i,
    .stride_i,
    .eye_lines_i,
    .restart_i,
    .start_i(window_done_o),
    .line_i,
    .columns_i,
    .rows_i,
    .outside_i(slots_out),
    .wanted_i(wanted_o | (joined_i ? pair_wanted_i : '0)),
    .held_o(held),
    .ready_o(drained),
    .idle_o(drain_idle),
    .job_o(job),
    .job_address_o(job_address),
    .word_i(row),
    .aovs_i(row_aovs),
    .wanted_aovs_i,
    .ahead_i,
    .mem_valid_o(store_valid_o),
    .mem_ready_i(store_ready_i),
    .mem_address_o(store_address_o),
    .mem_halves_o(store_halves_o),
    .mem_wide_o(store_wide_o),
    .mem_data_o(store_data_o)
  );

  // --- quads ---------------------------------------------------------------------------------------------------------
  typedef struct packed {logic [Groups-1:0][StoredW-1:0] of;} banks_t;
  banks_t banks, written;  // what each bank shows, and is given
  typedef struct packed {
    logic [Groups-1:0][ShownIndexW-1:0]            index;
    logic [Groups-1:0][RegionW-1:0]              quad_region, word_region;
    logic [Groups-1:0][1:0]                      quad_row, word_row;
    logic [Groups-1:0][pipegs_pkg::TapLineW-1:0] quad;
  } taps_t;
  taps_t taps;
  assign {tap_line_index_o, tap_line_region_o, tap_word_region_o, tap_line_quarter_o, tap_word_quarter_o, tap_line_o} =
         taps;
  for (genvar g = 0; g < Groups; g += 1) begin : gen_group
    logic             read, write;
    logic [AddrW-1:0] raddr, waddr;
    logic [BankW-1:0]   wdata;
    logic [AovsW-1:0]   raovs, waovs;
    logic [StoredW-1:0] rdata, stored;

    ru_quads #(.Group(g)) u_quads (
      .clk_i,
      .rst_ni,
      .rest_i,
      .in_valid_i(half_valid[g]),
      .in_ready_o(half_ready[g]),
      .in_live_i(pairs.live[g]),
      .in_i(pairs.of[g]),
      .in_half_i(half),
      .in_region_i(half_region),
      .in_color_i(color),
      .in_index_i(half_index),
      .drain_i(job),
      .drain_address_i(job_address),
      .clear_i(clear_q),
      .outside_i(words.outside[g]),
      .columns_i,
      .rows_i,
      .stopped_o(words.stopped[g]),
      .read_o(read),
      .raddr_o(raddr),
      .rdata_i(rdata[BankW-1:0]),
      .write_o(write),
      .waddr_o(waddr),
      .wdata_o(wdata),
      .raovs_i(raovs),
      .waovs_o(waovs),
      .issue_o(group_issue[g]),
      .busy_o(group_busy[g]),
      .tap_quad_valid_o(tap_line_valid_o[g]),
      .tap_quad_index_o(taps.index[g]),
      .tap_quad_region_o(taps.quad_region[g]),
      .tap_quad_row_o(taps.quad_row[g]),
      .tap_quad_o(taps.quad[g]),
      .tap_word_valid_o(tap_word_valid_o[g]),
      .tap_word_region_o(taps.word_region[g]),
      .tap_word_row_o(taps.word_row[g])
    );
    assign stored[BankW-1:0] = wdata;
    if (pipegs_pkg::HasAovs) begin : gen_aovs
      assign raovs                 = rdata[StoredW-1:BankW];
      assign stored[StoredW-1:BankW] = waovs;
    end else begin : gen_no_aovs
      assign raovs = '0;
      logic unused_aovs;
      assign unused_aovs = &{1'b0, waovs};
    end
    assign written.of[g] = stored;

    pipegs_sram #(.DataW(StoredW), .Depth(Words)) u_pixels (
      .clk_i,
      .write_i(write),
      .waddr_i(waddr),
      .wdata_i(stored),
      .read_i(read),
      .raddr_i(raddr),
      .rdata_o(rdata)
    );
    assign banks.of[g] = rdata;
  end
  assign tap_word_o = written;
  // A row of quads as two rows of eight pixels: of each field all sixteen side by side. What the banks show the lanes
  // is kept from ru_drain, whose arithmetic would switch with it.
  for (genvar i = 0; i < Lanes; i += 1) begin : gen_pixel
    localparam int unsigned Even = i % 8 / 2, Odd = (Even + 2) % 4, Pixel = i / 8 * 2 + i % 2;
    logic [StoredW-1:0] bank;
    assign bank = {StoredW{job_q[2]}} & (odd_q[2] ? banks.of[Odd] : banks.of[Even]);
    assign row.rgb[i]  = bank[Pixel*PixelsW +: PixelsW];
    assign row.t[i]    = bank[4*PixelsW+Pixel*TW +: TW];
    assign row.done[i] = bank[4*(PixelsW+TW)+Pixel];
    if (pipegs_pkg::HasAovs) begin : gen_aovs
      localparam int unsigned AovW = pipegs_pkg::AovBits;
      assign row_aovs[i*AovW +: AovW] = bank[BankW+Pixel*AovW +: AovW];
    end
  end
  if (!pipegs_pkg::HasAovs) begin : gen_no_aovs
    assign row_aovs = '0;
  end

  assign issue_o = group_issue != '0;
  assign idle_o  = !regions_busy && !power_busy && group_busy == '0 && !clear_q && drain_idle;

endmodule
