// store.cpp: see store.hpp.
#include "sim/accuracy/store.hpp"

#include <cmath>
#include <limits>

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

// JSON has no infinity: equal images have a PSNR of null.
Json psnr_json(double psnr) { return std::isfinite(psnr) ? Json(psnr) : Json(nullptr); }
double psnr_from(const Json& json) { return json.is_null() ? std::numeric_limits<double>::infinity() : json.get<double>(); }

Json to_json(const ErrorFigures& e) {
  return {{"psnr_db", psnr_json(e.psnr)}, {"ssim", std::isfinite(e.ssim) ? Json(e.ssim) : Json(nullptr)}, {"max", e.max}, {"p999", e.p999}};
}

ErrorFigures errors_from(const Json& json) {
  const Json& ssim = json.at("ssim");
  return {psnr_from(json.at("psnr_db")), ssim.is_null() ? std::nan("") : ssim.get<double>(), json.at("max").get<double>(), json.at("p999").get<double>()};
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
          {"seconds", {{"golden", a.seconds_golden}, {"truth", a.seconds_truth}, {"trace", a.seconds_trace}, {"model", a.seconds_model}}}};
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
  a.flips = {json.at("decisions").get<uint64_t>(), json.at("flipped").get<uint64_t>()};
  a.cycles = json.at("cycles").get<uint64_t>();
  a.bytes = json.at("bytes").get<uint64_t>();
  a.buffer_bits = json.at("buffer_bits").get<uint64_t>();
  const Json& seconds = json.at("seconds");
  a.seconds_golden = seconds.at("golden").get<double>();
  a.seconds_truth = seconds.at("truth").get<double>();
  a.seconds_trace = seconds.at("trace").get<double>();
  a.seconds_model = seconds.at("model").get<double>();
  return a;
}

std::optional<Accuracy> AccuracyStore::load(const Config& config) const {
  const std::optional<Json> measured = store_.load(config);
  try {
    return measured ? std::optional(accuracy_from_json(*measured)) : std::nullopt;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

}  // namespace pipegs
