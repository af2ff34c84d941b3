// SPDX-License-Identifier: Apache-2.0
// xyzs: a Gaussian a line of text, for scenes that a script writes or a person; SH degree 0.
//
// Layout  The first line is "xyzs 1". Each other one has 14 numbers with blanks between: x y z, three scales (linear),
//         quaternion w x y z, opacity, red green blue from 0 to 1. An empty line is none.
// Errors  InputError with the line's number.
#include <fmt/format.h>

#include "scenes/formats/format.hpp"
#include "scenes/input_error.hpp"
#include "scenes/text/number.hpp"
#include "scenes/text/text_file.hpp"

namespace pipegs {
namespace {

constexpr std::string_view kBlanks = " \t";
constexpr std::size_t kNumbers = 14;

std::vector<double> numbers_of(std::string_view line) {
  std::vector<double> numbers;
  for (std::size_t at = line.find_first_not_of(kBlanks); at != std::string_view::npos;
       at = line.find_first_not_of(kBlanks, at)) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
    numbers.push_back(parse_value(line.substr(at, end - at)));
    if (numbers.size() > kNumbers) break;
    at = end;
  }
  return numbers;
}

Gaussian gaussian_of(std::string_view line) {
  const std::vector<double> n = numbers_of(line);
  if (n.size() != kNumbers)
    throw NumberError(fmt::format("found {} numbers, expected {}",
                                  n.size() > kNumbers ? "more" : fmt::to_string(n.size()), kNumbers));
  Gaussian g{};
  for (int k = 0; k < 3; ++k) {
    const auto at = static_cast<std::size_t>(k);
    g.mean[k] = narrow(n[at]);
    g.log_scale[k] = narrow(n[3 + at]);
    g.sh_dc[k] = dc_of(n[11 + at]);
  }
  for (int k = 0; k < 4; ++k) g.rotation[k] = narrow(n[6 + static_cast<std::size_t>(k)]);
  g.opacity_logit = logit_of(n[10]);
  return g;
}

}  // namespace

Scene read_xyzs(const InputFile& file, SceneFormat& format) {
  format.name = ".xyzs version 1";
  format.axes = "RDF";
  format.fields = {{"position", "text"}, {"scale", "text, linear"},
                   {"rotation", "text"}, {"opacity", "text"},
                   {"colour", "text"},   {"SH", "none: colours do not change with the view"}};
  const std::vector<std::string_view> lines = lines_of(file.text());
  Scene scene;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string where = fmt::format("line {}", i + 1);
    if (i == 0) {
      if (lines[i] != "xyzs 1")
        throw InputError(file.name(), where, "found " + quote(lines[i]) + ", expected 'xyzs 1'");
    } else if (lines[i].find_first_not_of(kBlanks) != std::string_view::npos) {
      try {
        scene.gaussians.push_back(gaussian_of(lines[i]));
      } catch (const NumberError& error) { throw InputError(file.name(), where, error.what()); }
    }
  }
  take_linear_scales(scene, format);
  return scene;
}

}  // namespace pipegs
