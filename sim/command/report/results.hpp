// SPDX-License-Identifier: Apache-2.0
// results.hpp: what the commands have left in a folder and the folders below it: read for a page.
//
// Files   report.json   of `sim` and `ladder`, with frame.png beside it
//         sequence.json of `sim --views` and `--path`, with the first frame_*.png
//         train.json    of `train`
// Rule    Files are anybody's: each field is held against what it may be, and a file with another one is left out with
//         its reason. Links are not followed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cpp_model/float/image.hpp"

namespace pipegs {

struct FrameResult {
  std::string name;  // the folder
  std::string scene, camera, memory, machine, settings;
  uint64_t width = 0, height = 0, gaussians = 0;
  std::optional<uint64_t> cycles, mismatches, bytes_read, bytes_written;
  std::optional<double> numeric_db, order_db, total_db;
  std::optional<Rgb8> picture;
};

struct WalkFrame {
  std::string view, camera;
  uint64_t cycles = 0, bytes_read = 0, bytes_written = 0;
  std::optional<uint64_t> queued, mismatches;
  std::optional<double> us, chip_uj, dram_uj;
};

struct WalkResult {
  std::string name, scene, configuration, memory;
  std::vector<WalkFrame> frames;
  std::optional<Rgb8> picture;  // the first
};

struct TrainedBy {
  std::string who;
  std::optional<double> psnr, ssim;
  std::optional<uint64_t> cycles;
};

struct TrainResult {
  std::string name, input;
  uint64_t steps = 0, gaussians = 0;
  double minutes = 0;
  std::vector<TrainedBy> held_out;
};

struct LeftOut {
  std::string file, reason;
};

struct FolderResults {
  std::vector<FrameResult> frames;
  std::vector<WalkResult> walks;
  std::vector<TrainResult> trained;
  std::vector<LeftOut> left_out;

  size_t count() const { return frames.size() + walks.size() + trained.size(); }
};

// Throws InputError when `folder` is none.
FolderResults read_results(const std::filesystem::path& folder);

}  // namespace pipegs
