// SPDX-License-Identifier: Apache-2.0
// figures.hpp: what is measured of one view in one configuration, and the same as JSON, there and back.
//
// Rule    What JSON has no number for is null: the PSNR of equal images, an SSIM of images too small for one.
// Errors  NumberError or nlohmann::json::exception: the JSON is not what to_json writes.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

namespace pipegs {

// How much is measured; each includes those before it.
enum class Measured {
  kCycles,   // cycles, bytes, buffers
  kPicture,  // and the picture's error
  kErrors,   // and what of it numbers and order cost
};

struct ErrorFigures {
  double psnr = 0, ssim = 0, max = 0, p999 = 0;  // p999: the 99.9th percentile of the absolute error
};

struct Figures {
  std::string failure;  // one line when the scene does not fit the configuration; then nothing below holds
  std::string empty;    // of pictures: why nothing is in the frame
  ErrorFigures numeric, order, total;  // see view.hpp
  uint64_t cycles = 0, bytes = 0, buffer_bits = 0;

  double gbps() const { return static_cast<double>(bytes) / static_cast<double>(cycles); }  // at 1 GHz
  double buffer_kb() const { return static_cast<double>(buffer_bits) / 8192; }
};

nlohmann::ordered_json to_json(const Figures& figures, Measured measured);
Figures figures_from_json(const nlohmann::ordered_json& json, Measured measured);

}  // namespace pipegs
