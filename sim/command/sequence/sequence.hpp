// SPDX-License-Identifier: Apache-2.0
// sequence.hpp: `pipegs sim --views 0-9`, `--path 300`: frames one after the other in one machine, without a reset.
//
// Idea    --views takes views of the file, the framing or the orbit; --path takes them for key views of a smooth way of
//         so many frames. With the RTL all frames run twice, each queued behind the one before and each when the
//         machine is empty, and every beat and pixel is compared. With --no-rtl the golden model draws and the timing
//         model counts, frame by frame: for hundreds of frames, and a run that was stopped goes on where it was. With
//         --budget the driver (pipegs_budget.h) chooses what each frame gives up by what the last one took. With --gaze
//         each view, or the one of --view, is a picture in parts (gaze_views.hpp), which are frames.
// Writes  Pictures (frame_files.hpp), sequence.json, frames.csv; sequence.html with --page; kept/ with --no-rtl.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/command/command.hpp"
#include "sim/command/frame/against_argument.hpp"
#include "sim/command/frame/picture_arguments.hpp"
#include "sim/command/page/viewer_argument.hpp"

namespace pipegs {

struct SequenceArguments {
  std::vector<int> views;  // first and last; nothing: not asked for
  int path = 0;            // frames
  std::vector<std::string> frames = {"png"};
  bool truth = false;     // the float64 renders of each frame, too
  uint64_t budget = 0;    // cycles of a frame; 0: rest and level of detail are those of the options
  std::vector<int> gaze;  // x, y, full, half as in Gaze; nothing: each view is one frame

  void add(CLI::App& app);
  bool wanted() const { return several() || !gaze.empty(); }
  bool several() const { return !views.empty() || path > 0; }  // else, with a gaze, the one of --view
  // ConfigError: what cannot be written, or belongs to a sequence when none is wanted.
  void check(const CLI::App& command, const std::string& out) const;
};

struct SequenceRunArguments {
  std::string out;
  bool rtl = true, json = false;
  // The command that runs the same again with waves, around a cycle where one is known.
  std::function<std::string(std::optional<int64_t>)> replay;
  const ViewerArgument& viewer;
  AgainstArgument against;
  bool page = false;
  const CLI::App& command;
};

// Returns the exit code.
int run_sequence(const ViewArguments& view, const SequenceArguments& sequence, const PictureArguments& picture,
                 const SimulateOptions& options, const SequenceRunArguments& run);

}  // namespace pipegs
