// SPDX-License-Identifier: Apache-2.0
// accuracy_json.cpp: see accuracy_json.hpp.
#include "sim/studies/accuracy/accuracy_json.hpp"

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

Json to_json(const Accuracy& a) {
  if (!a.failure.empty()) return {{"failure", a.failure}};
  return {{"numeric", to_json(a.numeric)},
          {"order", to_json(a.order)},
          {"total", to_json(a.total)},
          {"decisions", a.flips.decisions},
          {"flipped", a.flips.flipped},
          {"cycles", a.cycles},
          {"bytes", a.bytes},
          {"buffer_bits", a.buffer_bits},
          {"seconds",
           {{"golden", a.seconds_golden},
            {"truth", a.seconds_truth},
            {"trace", a.seconds_trace},
            {"model", a.seconds_model}}}};
}

Accuracy accuracy_from_json(const Json& json) {
  Accuracy a;
  if (json.contains("failure")) {
    a.failure = json.at("failure").get<std::string>();
    return a;
  }
  a.numeric = errors_from(json.at("numeric"));
  a.order = errors_from(json.at("order"));
  a.total = errors_from(json.at("total"));
  a.flips = {json_integer<uint64_t>(json.at("decisions")), json_integer<uint64_t>(json.at("flipped"))};
  a.cycles = json_integer<uint64_t>(json.at("cycles"), 1);
  a.bytes = json_integer<uint64_t>(json.at("bytes"));
  a.buffer_bits = json_integer<uint64_t>(json.at("buffer_bits"));
  const Json& seconds = json.at("seconds");
  a.seconds_golden = json_real(seconds.at("golden"), kNotNegative);
  a.seconds_truth = json_real(seconds.at("truth"), kNotNegative);
  a.seconds_trace = json_real(seconds.at("trace"), kNotNegative);
  a.seconds_model = json_real(seconds.at("model"), kNotNegative);
  return a;
}

}  // namespace pipegs
