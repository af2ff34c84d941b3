// SPDX-License-Identifier: Apache-2.0
// viewer.hpp: the page of `pipegs sim --viewer`: the scene in a viewer of the web (Spark on three.js) beside the frame.
//
// Idea    The page holds the scene itself, so its viewer draws from the frame's camera and from any other. Up to
//         kMostPlyBytes the scene is its .ply, number for number; a larger one is an .spz, which rounds, and the page
//         says to what. No Gaussian is left out but those that no renderer draws (scenes/scene.hpp), no SH degree.
// Errors  ConfigError: a scene or a sequence that is too large for a page.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cpp_model/float/image.hpp"
#include "cpp_model/float/projection.hpp"
#include "scenes/camera.hpp"
#include "scenes/scene.hpp"
#include "sim/compare/background.hpp"

namespace pipegs {

inline constexpr std::size_t kMostPlyBytes = 8'000'000;
inline constexpr std::size_t kMostViewerGaussians = 4'000'000;
inline constexpr std::size_t kMostViewerPixels = std::size_t{1} << 26;  // of all frames together

struct ViewerFrame {
  Camera camera;
  PixelRect part;  // of the camera's picture, which the machine rendered
  Rgb8 picture;    // the very one of frame.png
};

struct ViewerPage {
  std::string title, command, version;
  const Scene* scene = nullptr;
  std::string machine;  // its configuration in words
  bool antialias = false;
  double near_plane = 0;
  Background background{};
  std::vector<ViewerFrame> frames;
};

// Before anything is computed.
void check_viewer(const Scene& scene, std::size_t pixels);

struct ViewerHtml {
  std::string html, reduced;  // what was reduced, in a line
};
ViewerHtml viewer_html(const ViewerPage& page, const std::string& html_template);

}  // namespace pipegs
