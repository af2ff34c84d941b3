// SPDX-License-Identifier: Apache-2.0
// photograph: a picture file as its camera saw it, and the same with fewer pixels.
//
// Reads   PNG and JPEG, recognised by their first bytes. Grey and CMYK become RGB, 16 bits become 8, a gAMA becomes
//         that of sRGB; colours of a PNG with alpha stand over black. Colours that are not sRGB's, by ICC, cICP, cHRM
//         or EXIF, are named and left alone. A file that ends early or holds codes that are none is refused; libjpeg
//         would fill it with grey.
// Rule    A picture has the size that its camera says. One that is stored turned, and says so by its EXIF orientation,
//         is turned when only then it fits, and stays otherwise. Of another size but of one shape: the camera gets its
//         pixels.
// Errors  InputError with file and sizes, or with the library's own words.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "cpp_model/float/image.hpp"
#include "scenes/camera.hpp"
#include "scenes/check/finding.hpp"

namespace pipegs {

struct Photograph {
  Rgb8 picture;
  Camera camera;  // of the size of the picture
  bool turned = false, unturned = false, resized = false, inks = false, deep = false, gamma = false;
  std::string profile;  // the name of one that is not sRGB's, or of other colours
};

Photograph read_photograph(const std::filesystem::path& path, const Camera& camera);

// What was done to photographs to read them: a finding of each kind.
class PhotographFindings {
 public:
  void add(const std::string& name, const Photograph& photograph);
  Findings all() const;

 private:
  struct Found {
    std::size_t count = 0;
    std::string first, detail;
  };
  std::size_t photographs_ = 0;
  std::map<std::string, Found> found_;  // by key
};

// Each pixel the mean of what it covers of the larger picture; both show the same rectangle. Codes, rounded.
Rgb8 shrunk(const Rgb8& picture, int width, int height);

}  // namespace pipegs
