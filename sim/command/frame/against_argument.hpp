// SPDX-License-Identifier: Apache-2.0
// against_argument.hpp: `--against`: photographs beside what was drawn, and how far each frame is from its own.
//
// Idea    A file is the photograph of the one view that is drawn. In a folder lies one for each view, by the name of
//         its camera, with or without its folders and its ending, or by that of our own picture, so that two sequences
//         can be held against each other. Views without one have no figures.
// Rule    Compared are 8-bit pictures as they are written, over the same background. A photograph of more pixels and
//         the same shape is made smaller; what else differs is read as training reads it, and told, or refused.
// Errors  ConfigError, InputError with the name of the photograph, all before anything is drawn.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/command/command.hpp"

namespace pipegs {

struct AgainstFigures {
  std::string photograph;
  double psnr_db = 0, ssim = 0;  // infinite of equal pictures; NaN of pictures too small for one
};

// "against photo.png: 27.31 dB, SSIM 0.8712", a line.
std::string against_text(const AgainstFigures& figures);

class AgainstArgument {
 public:
  void add(CLI::App& app);
  bool wanted() const { return !given_.empty(); }
  // Finds and reads the photographs of these views; our own pictures of a sequence are frame_0000 and so on.
  void begin(const LoadedView& loaded, const std::vector<Camera>& cameras, const SimulateOptions& options,
             bool sequence);
  // Of the pixels that were asked for; nothing where there is none.
  std::optional<Rgb8> photograph(size_t view) const;
  std::optional<AgainstFigures> figures(size_t view, const Rgb8& drawn) const;

 private:
  std::optional<std::filesystem::path> find(const Camera& camera, const std::string& own) const;

  std::string given_;
  struct View {
    Camera camera;
    PixelRect asked;
    std::optional<std::filesystem::path> file;
    std::optional<Rgb8> picture = {};  // kept where there is one view
  };
  std::vector<View> views_;
};

}  // namespace pipegs
