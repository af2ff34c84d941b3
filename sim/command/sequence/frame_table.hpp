// SPDX-License-Identifier: Apache-2.0
// frame_table.hpp: what each frame of a sequence took, as text, CSV, JSON and charts.
//
// Idea    A percentile is a frame's own value: the least that so many percent of the frames do not exceed (nearest
//         rank). So the 99th of fewer than a hundred frames is the largest.
// Energy  By the frame model (sim/silicon/frame_model.hpp): rates of measured frames times cycles and bytes;
//         nothing where it does not know the machine.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/command/sequence/quality.hpp"
#include "sim/compare/simulate.hpp"
#include "sim/report/chart.hpp"
#include "sim/silicon/frame_model.hpp"

namespace pipegs {

struct FrameRow {
  double view = 0;  // its number in the file; between two on a path
  Camera camera;
  std::optional<int> sample = {};         // of a part of a picture (--gaze): pixels of a sample in each direction
  std::optional<double> rest = {};        // transmittance below which a pixel stops, where the machine has the field
  std::optional<double> lod_pixels = {};  // proxies that differ by less than so many, where the machine has proxies
  std::optional<double> steady = {};      // PSNR to the frame before, where that is as large
  uint64_t cycles = 0;                    // of the frame alone
  MemoryBytes bytes;
  std::optional<FrameCost> cost = {};
  // Of the RTL, where it has run.
  std::optional<uint64_t> cycles_queued = {}, gap_queued = {}, gap_alone = {}, mismatches = {};
  Quality quality = {};
};

// The views from the first to the last of --views, or all: of each its number and camera. Throws ConfigError.
std::vector<FrameRow> views_of(const std::vector<Camera>& cameras, const std::vector<int>& views);
std::vector<Camera> cameras_of(const std::vector<FrameRow>& rows);

// One picture in parts, which are as many rows, and its rings of samples as large.
struct GazeRing {
  int sample = 1;  // pixels in each direction
  uint64_t pixels = 0;
  double from_degrees = 0;  // from the gaze
  struct Decibels {
    double repeated, smooth, mean;  // to the whole picture in float64: samples repeated, blended, against its means
  };
  std::optional<Decibels> db = {};
};
struct GazeView {
  size_t parts = 0;
  std::vector<GazeRing> rings;
};

struct FrameTable {
  std::string scene;
  Config config;
  std::string memory;
  std::vector<FrameRow> rows;
  std::vector<GazeView> gaze = {};  // all rows belong to one, in their order, or there is none

  bool rtl() const { return !rows.empty() && rows[0].cycles_queued.has_value(); }
  bool priced() const { return !rows.empty() && rows[0].cost.has_value(); }
};

// The number of a view, whole where it is.
TableCell view_cell(double view);

std::string frames_csv(const FrameTable& table);
nlohmann::ordered_json to_json(const FrameTable& table);
// One line; then the frames where they are few or all are wanted, percentiles, and how good the pictures are.
std::string head_of(const FrameTable& table);
std::vector<Table> frame_tables(const FrameTable& table, bool all);
std::string to_text(const FrameTable& table);
std::vector<Chart> frame_charts(const FrameTable& table);

}  // namespace pipegs
