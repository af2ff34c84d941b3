// SPDX-License-Identifier: Apache-2.0
// train_report.cpp: see train_report.hpp.
#include "sim/command/train/train_report.hpp"

#include <fmt/format.h>

#include "sim/report/finite.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(CldrForm form) {
  return form == CldrForm::kPrinted ? "printed" : form == CldrForm::kRelative ? "relative" : "logarithm";
}

Json json_of(const Likeness& likeness) {
  return {{"psnr_db", finite_json(likeness.psnr)}, {"ssim", finite_json(likeness.ssim)}};
}

Json json_of(const TrainQuality& quality) {
  return {{"exact", json_of(quality.exact)}, {"layered", json_of(quality.layered)}};
}

std::string text_of(const TrainQuality& quality, int layers) {
  return fmt::format("exact order {:.2f} dB, SSIM {:.4f}; in {} layers {:.2f} dB, SSIM {:.4f}", quality.exact.psnr,
                     quality.exact.ssim, layers, quality.layered.psnr, quality.layered.ssim);
}

}  // namespace

nlohmann::ordered_json train_json(const TrainOptions& options, const TrainState& state, const TrainReport& report) {
  Json json = {{"input", report.input},
               {"fine_tuning", options.schedule.fine_tuning},
               {"steps", state.step},
               {"gaussians", state.parameters.size()},
               {"sh_degree", state.parameters.sh_degree},
               {"minutes", state.seconds / 60},
               {"options",
                {{"steps", options.schedule.steps},
                 {"downscale", report.downscale},
                 {"max_gaussians", options.most_gaussians},
                 {"seed", options.seed},
                 {"layers", options.layers},
                 {"order", options.layers > 0 && options.draws_layered ? "layered" : "exact"}}},
               {"views", {{"trained", report.trained}, {"held_out", report.held_out}}},
               {"measured_layers", report.layers}};
  const bool regularised = options.layers > 0 && options.regularised;
  Json& given = json["options"];
  given["cldr"] = !regularised ? "none" : name_of(options.cldr.form);
  given["cldr_weight"] = regularised ? Json(options.cldr.weight) : Json(nullptr);
  given["layers_begin"] = options.layers > 0 ? Json(options.layers_begin) : Json(nullptr);
  given["gamma"] = regularised ? Json(options.cldr.gamma) : Json(nullptr);
  given["cldr_axes"] = regularised ? Json(options.cldr.all_axes ? "all" : "camera") : Json(nullptr);
  if (report.before) json["held_out_before"] = json_of(*report.before);
  json["held_out"] = json_of(report.after);
  return json;
}

std::string train_text(const TrainState& state, const TrainReport& report) {
  std::string text = fmt::format("{} Gaussians, SH degree {}, after {} steps in {:.1f} minutes\n",
                                 state.parameters.size(), state.parameters.sh_degree, state.step, state.seconds / 60);
  text += fmt::format("{} of {} views were held out\n", report.held_out, report.held_out + report.trained);
  if (report.before) text += fmt::format("  before  {}\n", text_of(*report.before, report.layers));
  return text + fmt::format("  {}{}\n", report.before ? "after   " : "", text_of(report.after, report.layers));
}

}  // namespace pipegs
