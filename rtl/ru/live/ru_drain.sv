// SPDX-License-Identifier: Apache-2.0
// ru_drain: brings the pixels of a finished window to external memory, region by region, out of the lanes' own buffer.
//
// Paper   None: its RUs have T and RGB twice, and write one half while they blend the other.
// Idea    One buffer. A region of the finished window is held until its four words were read and cleared; then the next
//         window may blend it. Regions that the next splat wants go first. A job takes one turn of all groups of lanes
//         and its word comes three cycles later, so there is a place for it before it is asked for. Where the word lies
//         is found out meanwhile; in raster order words below the picture are read and cleared only. Behind its
//         colours a word's AOVs are written, each to the same place so many lines further.
// Stream  start_i with the window's first line, its rows and the slots outside the image, which are clear already.
//         restart_i: all is cleared, nothing written. Jobs out, words in, write requests out.
// Pace    A word per cycle while there is room; RuDrained words in five cycles, in six when each is two requests.
// Model   cpp_model/ru/ru_resolve.hpp, cpp_model/ru/ru_raster.hpp

module ru_drain #(
  localparam int unsigned Lanes   = 16,
  localparam int unsigned Slots   = pipegs_pkg::Regions / pipegs_pkg::Units,
  localparam int unsigned AddrW   = $clog2(Slots * 4),
  localparam int unsigned WordW   = Lanes * (pipegs_pkg::TW + 3 * pipegs_pkg::RgbW + 1),
  localparam int unsigned AovsW   = pipegs_pkg::HasAovs ? Lanes * pipegs_pkg::AovBits : 4,
  localparam int unsigned Kinds   = pipegs_pkg::AovKinds
) (
  input  logic                            clk_i,
  input  logic                            rst_ni,
  input  logic [pipegs_pkg::Regions-1:0]  own_i,
  input  logic                            raster_i,   // pixels in raster order, else by windows
  input  logic [pipegs_pkg::StrideW-1:0]  stride_i,   // lines from row to row, in raster order
  input  logic [pipegs_pkg::AddressW-1:0] eye_lines_i,  // from the first eye's pixels to the second one's

  input  logic                            restart_i,
  input  logic                            start_i,
  input  logic [pipegs_pkg::AddressW-1:0] line_i,     // first one of the window's pixels
  input  logic [$clog2(pipegs_pkg::Window):0] columns_i,  // pixels of the window inside the image
  input  logic [$clog2(pipegs_pkg::Window):0] rows_i,
  input  logic [Slots-1:0]                outside_i,
  input  logic [Slots-1:0]                wanted_i,
  output logic [Slots-1:0]                held_o,     // not handed over yet
  output logic                            ready_o,    // none is held
  output logic                            idle_o,     // and all pixels are written

  output logic                            job_o,
  output logic [AddrW-1:0]                job_address_o,
  input  logic [WordW-1:0]                word_i,     // of the job three cycles ago
  input  logic [AovsW-1:0]                aovs_i,     // of its pixels
  input  logic [Kinds-1:0]                wanted_aovs_i,  // what is written of them
  input  logic [Kinds*pipegs_pkg::AddressW-1:0] ahead_i,  // how many lines behind the colours

  output logic                            mem_valid_o,
  input  logic                            mem_ready_i,
  output logic [pipegs_pkg::AddressW-1:0] mem_address_o,
  output logic [pipegs_pkg::HalvesW-1:0]  mem_halves_o,  // of the line
  output logic                            mem_wide_o,    // both are in the picture
  output logic [pipegs_pkg::MemoryW-1:0]  mem_data_o
);

  localparam int unsigned Units     = pipegs_pkg::Units;
  localparam int unsigned RegionW   = pipegs_pkg::RegionW;
  localparam int unsigned AddressW  = pipegs_pkg::AddressW;
  localparam int unsigned SlotW     = Slots > 1 ? $clog2(Slots) : 1;
  localparam int unsigned LinesW    = Lanes * pipegs_pkg::PixelW;
  localparam int unsigned OffsetW   = pipegs_pkg::StrideW + pipegs_pkg::PlacesW + 3;
  localparam int unsigned Depth     = pipegs_pkg::RuDrained;

  // --- which word is next --------------------------------------------------------------------------------------------
  logic [Slots-1:0]   held_q, chosen_q, left, first, next;  // chosen: one slot or none
  logic [SlotW-1:0]   slot_q, next_slot;
  logic [1:0]         row_q;
  logic [AddressW-1:0] line_q;
  logic [$clog2(pipegs_pkg::Window):0] columns_q, rows_q;
  logic               quiet_q, room, last;  // quiet: nothing is written

  assign left  = held_q & ~chosen_q;
  assign first = left & wanted_i;
  pipegs_first_set #(.DataW(Slots)) u_next (
    .mask_i(first != '0 ? first : left),
    .one_hot_o(next),
    .number_o(next_slot)
  );
  assign job_o         = chosen_q != '0 && (quiet_q || room);
  assign job_address_o = AddrW'({slot_q, row_q});
  assign last          = job_o && row_q == 2'd3;
  assign held_o        = held_q;
  assign ready_o       = held_q == '0;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      held_q   <= '0;
      chosen_q <= '0;
      row_q    <= '0;
      quiet_q  <= 1'b0;
    end else begin
      if (restart_i) held_q <= '1;
      else if (start_i) held_q <= ~outside_i;
      else if (last) held_q <= left;
      if (restart_i || start_i) quiet_q <= restart_i;
      if (chosen_q == '0 || last) chosen_q <= next;
      if (job_o) row_q <= row_q + 1'b1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (start_i) {line_q, columns_q, rows_q} <= {line_i, columns_i, rows_i};
    if (chosen_q == '0 || last) slot_q <= next_slot;
  end

  // --- where it belongs ----------------------------------------------------------------------------------------------
  logic [RegionW-1:0] region;
  if (Units > 1) begin : gen_place
    logic [Units-1:0]         owned;  // one of the slot's regions
    logic [$clog2(Units)-1:0] place;
    assign owned = own_i[slot_q*Units +: Units];
    always_comb begin
      place = '0;
      for (int unsigned i = 0; i < Units; i += 1) if (owned[i]) place |= $clog2(Units)'(i);
    end
    assign region = RegionW'({slot_q, place});
  end else begin : gen_all
    assign region = RegionW'(slot_q);
    logic unused_own;
    assign unused_own = &{1'b0, own_i};
  end

  logic [AddressW-1:0] first_line;  // of the eye's pixels of the window
  if (pipegs_pkg::Eyes > 1) begin : gen_eyes
    logic                second_q;  // the last job was of the second eye
    logic [AddressW-1:0] second_line_q;
    always_ff @(posedge clk_i) begin
      if (job_o) second_q <= region[RegionW-1];
      if (start_i) second_line_q <= line_i + eye_lines_i;
    end
    assign first_line = second_q ? second_line_q : line_q;
  end else begin : gen_one_eye
    assign first_line = line_q;
    logic unused_eye;
    assign unused_eye = ^eye_lines_i;
  end
  logic [OffsetW-1:0] offset, offset_q;  // of the job's word from the window's first line; _q: of the last cycle's
  logic               half, half_q, wide, wide_q, two, two_q, shown;
  ru_offset u_offset (
    .raster_i,
    .stride_i,
    .columns_i(columns_q),
    .rows_i(rows_q),
    .region_i(region),
    .quarter_i(row_q),
    .offset_o(offset),
    .half_o(half),
    .wide_o(wide),
    .shown_o(shown),
    .two_o(two),
    .more_o()
  );
  always_ff @(posedge clk_i) if (job_o) {offset_q, half_q, wide_q, two_q} <= {offset, half, wide, two};

  // --- jobs -> words -> lines ----------------------------------------------------------------------------------------
  logic [2:0]          flying_q;  // a job whose word is written, of one, two, three cycles ago
  logic [AddressW-1:0] place;     // line of the word that is written next
  logic                place_half, place_two, second_q;
  logic [LinesW-1:0]   lines, word, shown_word;  // shown: of it the colours, or an AOV
  logic [AddressW-1:0] line, ahead;
  logic                word_valid, tag_ready, tag_valid, written, pop, word_ready;
  logic [$clog2(Depth+1)-1:0] tags, words;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) flying_q <= '0;
    else flying_q <= {flying_q[1:0], job_o && !quiet_q && shown};
  end
  assign room = tags + {1'b0, flying_q[0]} != ($clog2(Depth + 1))'(Depth);
  pipegs_fifo #(.DataW(AddressW + 3), .Depth(Depth)) u_tags (
    .clk_i,
    .rst_ni,
    .in_valid_i(flying_q[0]),
    .in_ready_o(tag_ready),
    .in_i({first_line + AddressW'(offset_q), half_q, wide_q, two_q}),
    .out_valid_o(tag_valid),
    .out_ready_i(pop),
    .out_o({place, place_half, mem_wide_o, place_two}),
    .count_o(tags)
  );
  ru_pixels u_pixels (
    .word_i,
    .raster_i,
    .lines_o(lines)
  );
  pipegs_fifo #(.DataW(LinesW), .Depth(Depth)) u_words (
    .clk_i,
    .rst_ni,
    .in_valid_i(flying_q[2]),
    .in_ready_o(word_ready),
    .in_i(lines),
    .out_valid_o(word_valid),
    .out_ready_i(pop),
    .out_o(word),
    .count_o(words)
  );
  ru_lines u_lines (
    .raster_i,
    .stride_i,
    .first_i(line),
    .half_i(place_half),
    .second_i(second_q),
    .lines_i(shown_word),
    .address_o(mem_address_o),
    .halves_o(mem_halves_o),
    .data_o(mem_data_o)
  );
  assign mem_valid_o = word_valid;
  assign line        = place + ahead;
  assign written     = word_valid && mem_ready_i && (second_q || !place_two);  // colours, or an AOV
  assign idle_o      = ready_o && !flying_q[0] && !tag_valid;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) second_q <= 1'b0;
    else if (mem_valid_o && mem_ready_i) second_q <= !second_q && place_two;
  end

  // --- AOVs ---------------------------------------------------------------------------------------------------------
  if (pipegs_pkg::HasAovs) begin : gen_aovs
    localparam int unsigned TW    = pipegs_pkg::TW;
    localparam int unsigned KeptW = AovsW - Lanes * pipegs_pkg::BestW + (pipegs_pkg::AovCoverage != 0 ? 16 * Lanes : 0);
    logic [KeptW-1:0]  kept_in, kept;
    logic [Kinds-1:0]  turn_q, later, following;  // turn: whose, none: the colours'
    logic [LinesW-1:0] aov;
    logic              kept_valid, kept_ready;
    logic [$clog2(Depth+1)-1:0] kept_words;
    ru_aov_lines u_lines (
      .t_i(word_i[Lanes*3*pipegs_pkg::RgbW +: Lanes*TW]),
      .aovs_i,
      .kept_o(kept_in),
      .kept_i(kept),
      .which_i(turn_q),
      .lines_o(aov)
    );
    pipegs_fifo #(.DataW(KeptW), .Depth(Depth)) u_kept (
      .clk_i,
      .rst_ni,
      .in_valid_i(flying_q[2]),
      .in_ready_o(kept_ready),
      .in_i(kept_in),
      .out_valid_o(kept_valid),
      .out_ready_i(pop),
      .out_o(kept),
      .count_o(kept_words)
    );
    assign later = wanted_aovs_i & (turn_q == '0 ? '1 : ~(turn_q | (turn_q - 1'b1)));
    assign following = later & (~later + 1'b1);
    always_comb begin
      ahead = '0;
      for (int unsigned i = 0; i < Kinds; i += 1) begin
        if (turn_q[i]) ahead |= ahead_i[i*AddressW +: AddressW];
      end
    end
    assign shown_word = turn_q == '0 ? word : aov;
    assign pop        = written && following == '0;
    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) turn_q <= '0;
      else if (written) turn_q <= following;
    end
    logic unused_kept;
    assign unused_kept = &{1'b0, kept_valid, kept_ready, kept_words};
  end else begin : gen_colors
    assign ahead      = '0;
    assign shown_word = word;
    assign pop        = written;
    logic unused_aovs;
    assign unused_aovs = &{1'b0, aovs_i, wanted_aovs_i, ahead_i};
  end

  logic unused_counts;
  assign unused_counts = &{1'b0, words};

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni) assert ((!flying_q[2] || word_ready) && (!flying_q[0] || tag_ready))
    else $error("ru_drain: a word came for which there is no place");
  always_ff @(posedge clk_i) if (rst_ni) assert (!start_i || ready_o)
    else $error("ru_drain: a window came before the last one was handed over");
  pipegs_stream_check #(.DataW($bits({mem_address_o, mem_data_o}))) u_check_mem (
    .clk_i,
    .rst_ni,
    .valid_i(mem_valid_o),
    .ready_i(mem_ready_i),
    .beat_i({mem_address_o, mem_data_o})
  );
`endif

endmodule
