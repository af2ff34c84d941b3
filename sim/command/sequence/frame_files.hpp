// SPDX-License-Identifier: Apache-2.0
// frame_files.hpp: the pictures of a sequence: frame_0000.png and so on, .exr.
//
// Resume  A run that is stopped leaves the frames that were done. What was measured of a frame is kept with hashes of
//         its files (`fingerprint`), so the next run takes it only when the very files still lie there.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "cpp_model/float/image.hpp"

namespace pipegs {

struct FrameFilesOptions {
  std::string folder;
  bool png = true, exr = false;
  std::function<void(const Rgb8&)> show = {};  // each picture in its order, when somebody wants them
};

class FrameFiles {
 public:
  explicit FrameFiles(const FrameFilesOptions& options);

  // Frames come in their order.
  void add(const Image& image, const Rgb8& picture);
  // Takes the next frame from its files instead, when they are those of this fingerprint and all that is needed.
  bool take(const nlohmann::ordered_json& fingerprint);
  // Of the files of the latest frame.
  nlohmann::ordered_json fingerprint() const { return fingerprint_of(number_ - 1); }

 private:
  std::filesystem::path file(int number, const char* extension) const;
  nlohmann::ordered_json fingerprint_of(int number) const;

  FrameFilesOptions options_;
  int number_ = 0;
};

}  // namespace pipegs
