// SPDX-License-Identifier: Apache-2.0
// figures.cpp: see figures.hpp.
#include "sim/studies/explore/figures.hpp"

#include <limits>

#include "scenes/text/json.hpp"
#include "sim/report/finite.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

// Equal images have a PSNR of null.
double psnr_from(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::infinity() : json_real(json);
}

Json to_json(const ErrorFigures& e) {
  return {{"psnr_db", finite_json(e.psnr)}, {"ssim", finite_json(e.ssim)}, {"max", e.max}, {"p999", e.p999}};
}

ErrorFigures errors_from(const Json& json) {
  const Json& ssim = json.at("ssim");
  return {psnr_from(json.at("psnr_db")), ssim.is_null() ? std::nan("") : json_real(ssim, {-1, 1}),
          json_real(json.at("max"), kNotNegative), json_real(json.at("p999"), kNotNegative)};
}

}  // namespace

Json to_json(const Figures& f, Measured measured) {
  if (!f.failure.empty()) return {{"failure", f.failure}};
  Json json = Json::object();
  if (measured == Measured::kErrors) json = {{"numeric", to_json(f.numeric)}, {"order", to_json(f.order)}};
  if (measured != Measured::kCycles) json["total"] = to_json(f.total);
  if (measured == Measured::kErrors) json.update({{"decisions", f.flips.decisions}, {"flipped", f.flips.flipped}});
  json.update({{"cycles", f.cycles}, {"bytes", f.bytes}, {"buffer_bits", f.buffer_bits}});
  if (measured != Measured::kCycles) {
    json["seconds"] = {{"golden", f.seconds_golden},
                       {"truth", f.seconds_truth},
                       {"trace", f.seconds_trace},
                       {"model", f.seconds_model}};
  }
  return json;
}

Figures figures_from_json(const Json& json, Measured measured) {
  Figures f;
  if (json.contains("failure")) {
    f.failure = json.at("failure").get<std::string>();
    return f;
  }
  f.cycles = json_integer<uint64_t>(json.at("cycles"), 1);
  f.bytes = json_integer<uint64_t>(json.at("bytes"));
  f.buffer_bits = json_integer<uint64_t>(json.at("buffer_bits"));
  if (measured == Measured::kCycles) return f;
  f.total = errors_from(json.at("total"));
  const Json& seconds = json.at("seconds");
  f.seconds_golden = json_real(seconds.at("golden"), kNotNegative);
  f.seconds_truth = json_real(seconds.at("truth"), kNotNegative);
  f.seconds_trace = json_real(seconds.at("trace"), kNotNegative);
  f.seconds_model = json_real(seconds.at("model"), kNotNegative);
  if (measured == Measured::kPicture) return f;
  f.numeric = errors_from(json.at("numeric"));
  f.order = errors_from(json.at("order"));
  f.flips = {json_integer<uint64_t>(json.at("decisions")), json_integer<uint64_t>(json.at("flipped"))};
  return f;
}

}  // namespace pipegs
