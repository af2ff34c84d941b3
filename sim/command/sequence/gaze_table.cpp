// SPDX-License-Identifier: Apache-2.0
// gaze_table.cpp: see gaze_table.hpp.
#include "sim/command/sequence/gaze_table.hpp"

#include "sim/report/finite.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

// All parts of a picture.
struct Whole {
  double view = 0;
  size_t parts = 0;
  uint64_t cycles = 0, queued = 0, samples = 0;
  MemoryBytes bytes = {};
  double us = 0, chip_uj = 0, dram_uj = 0;
};

std::vector<Whole> wholes(const FrameTable& table) {
  std::vector<Whole> all;
  size_t at = 0;
  for (const GazeView& view : table.gaze) {
    Whole& whole = all.emplace_back();
    whole.view = table.rows[at].view;
    whole.parts = view.parts;
    for (size_t i = 0; i < view.parts; ++i, ++at) {
      const FrameRow& row = table.rows[at];
      whole.cycles += row.cycles;
      whole.queued += row.cycles_queued.value_or(0);
      whole.samples += static_cast<uint64_t>(row.camera.width) * static_cast<uint64_t>(row.camera.height);
      whole.bytes = {whole.bytes.read + row.bytes.read, whole.bytes.written + row.bytes.written};
      if (!row.cost) continue;
      whole.us += row.cost->us;
      whole.chip_uj += 1e6 * row.cost->chip.mid;
      whole.dram_uj += 1e6 * row.cost->dram.mid;
    }
  }
  return all;
}

TableCell count_cell(uint64_t count) { return number_cell(static_cast<double>(count)); }

Table pictures_table(const FrameTable& table) {
  Table pictures{.title = "Pictures",
                 .columns = {{.key = "view", .heading = "view", .digits = 0},
                             {.key = "parts", .heading = "parts"},
                             {.key = "samples", .heading = "samples"},
                             {.key = "cycles", .heading = "cycles"},
                             {.key = "cycles_queued", .heading = "queued"},
                             {.key = "bytes_read", .heading = "read, bytes"},
                             {.key = "bytes_written", .heading = "written"},
                             {.key = "us", .heading = "us", .digits = 1},
                             {.key = "chip_uj", .heading = "uJ, chip", .digits = 1},
                             {.key = "dram_uj", .heading = "uJ, DRAM", .digits = 1}}};
  const auto priced = [&](double value) { return table.priced() ? number_cell(value) : TableCell{}; };
  for (const Whole& one : wholes(table))
    pictures.rows.push_back({view_cell(one.view), count_cell(one.parts), count_cell(one.samples),
                             count_cell(one.cycles), table.rtl() ? count_cell(one.queued) : TableCell{},
                             count_cell(one.bytes.read), count_cell(one.bytes.written), priced(one.us),
                             priced(one.chip_uj), priced(one.dram_uj)});
  return pictures;
}

Table rings_table(const FrameTable& table) {
  Table rings{.title = "Rings around the gaze",
              .columns = {{.key = "view", .heading = "view"},
                          {.key = "sample", .heading = "sample, pixels"},
                          {.key = "from_degrees", .heading = "from", .unit = "degrees", .digits = 1},
                          {.key = "pixels", .heading = "pixels"},
                          {.key = "repeated_db", .heading = "dB, samples repeated", .digits = 2},
                          {.key = "smooth_db", .heading = "dB, blended", .digits = 2},
                          {.key = "mean_db", .heading = "dB to the means", .digits = 2}}};
  const std::vector<Whole> views = wholes(table);
  for (size_t i = 0; i < views.size(); ++i) {
    for (const GazeRing& ring : table.gaze[i].rings) {
      const auto decibels = [&](double GazeRing::Decibels::*one) {
        return ring.db ? number_cell((*ring.db).*one) : TableCell{};
      };
      rings.rows.push_back({view_cell(views[i].view), number_cell(ring.sample), number_cell(ring.from_degrees),
                            count_cell(ring.pixels), decibels(&GazeRing::Decibels::repeated),
                            decibels(&GazeRing::Decibels::smooth), decibels(&GazeRing::Decibels::mean)});
    }
  }
  return rings;
}

}  // namespace

std::vector<Table> gaze_tables(const FrameTable& table) {
  if (table.gaze.empty()) return {};
  return {pictures_table(table), rings_table(table)};
}

Json gaze_json(const FrameTable& table) {
  Json all = Json::array();
  const std::vector<Whole> views = wholes(table);
  for (size_t i = 0; i < views.size(); ++i) {
    const Whole& one = views[i];
    Json json = {{"view", one.view}, {"parts", one.parts}, {"samples", one.samples}, {"cycles_alone", one.cycles}};
    if (table.rtl()) json["cycles_queued"] = one.queued;
    json["bytes_read"] = one.bytes.read;
    json["bytes_written"] = one.bytes.written;
    if (table.priced()) json["us"] = one.us, json["chip_uj"] = one.chip_uj, json["dram_uj"] = one.dram_uj;
    for (const GazeRing& ring : table.gaze[i].rings) {
      Json part = {{"sample", ring.sample}, {"from_degrees", ring.from_degrees}, {"pixels", ring.pixels}};
      if (ring.db) {
        part["repeated_db"] = finite_json(ring.db->repeated);
        part["smooth_db"] = finite_json(ring.db->smooth);
        part["mean_db"] = finite_json(ring.db->mean);
      }
      json["rings"].push_back(part);
    }
    all.push_back(json);
  }
  return all;
}

}  // namespace pipegs
