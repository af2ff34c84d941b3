// SPDX-License-Identifier: Apache-2.0
// results.hpp: what the commands have left in a folder and the folders below it, as tables and charts of a page.
//
// Files   report.json   of `sim` and `ladder`, with frame.png beside it
//         sequence.json of `sim --views` and `--path`, with the first frame_*.png
//         train.json    of `train`
// Rule    Files are anybody's: each field is held against what it may be, and a file with another one is left out with
//         its reason. Links are not followed.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "cpp_model/float/image.hpp"
#include "sim/report/chart.hpp"
#include "sim/report/table.hpp"

namespace pipegs {

struct LeftOut {
  std::string file, reason;
};

struct FolderResults {
  static constexpr int kLongestSide = 640;
  struct Picture {
    std::string caption, id;
    Rgb8 pixels;  // shrunken to that
  };
  Table frames, trained;                       // a row for each frame; for each who draws the views held out
  std::vector<Chart> charts;                   // of the frames
  std::vector<std::pair<Chart, Table>> walks;  // of each sequence: a row for each of its frames
  std::vector<Picture> pictures;
  std::vector<LeftOut> left_out;
  std::size_t trained_scenes = 0;
  std::uint64_t pixels_read = 0, bytes_read = 0;  // of pictures in their files

  std::size_t count() const { return frames.rows.size() + walks.size() + trained_scenes; }
};

// Throws InputError when `folder` is none.
FolderResults read_results(const std::filesystem::path& folder);

}  // namespace pipegs
