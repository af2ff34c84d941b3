// SPDX-License-Identifier: Apache-2.0
// figures.cpp: see figures.hpp.
#include "sim/studies/explore/figures.hpp"

#include "scenes/text/json.hpp"
#include "sim/report/finite.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

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
  if (!f.empty.empty()) json["empty"] = f.empty;
  json.update({{"cycles", f.cycles}, {"bytes", f.bytes}, {"buffer_bits", f.buffer_bits}});
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
  f.empty = json.value("empty", "");
  if (measured == Measured::kPicture) return f;
  f.numeric = errors_from(json.at("numeric"));
  f.order = errors_from(json.at("order"));
  return f;
}

}  // namespace pipegs
