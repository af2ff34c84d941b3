// SPDX-License-Identifier: Apache-2.0
// pictures.hpp: pictures made small enough that all of them fit into a page.
#pragma once

#include <string>
#include <vector>

#include "cpp_model/float/image.hpp"

namespace pipegs {

struct NamedPicture {
  std::string caption, id;
  const Rgb8* picture = nullptr;
};

struct SmallPicture {
  std::string caption, id, png;  // contents of the file
};

// The mean of `step` x `step` pixels each, of fewer at the right and lower edge.
Rgb8 smaller(const Rgb8& picture, int step);

// The contents of a PNG file.
std::string png_bytes(const Rgb8& picture);

// As wide as the page shows them, and narrower until all together have about three megabytes.
std::vector<SmallPicture> small_pictures(const std::vector<NamedPicture>& pictures);

}  // namespace pipegs
