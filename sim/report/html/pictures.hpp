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

// The contents of a PNG file.
std::string png_bytes(const Rgb8& picture);

// As wide as the page shows them, and narrower until all together have about three megabytes.
std::vector<SmallPicture> small_pictures(const std::vector<NamedPicture>& pictures);

}  // namespace pipegs
