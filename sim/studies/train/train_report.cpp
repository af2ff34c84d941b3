// SPDX-License-Identifier: Apache-2.0
// train_report.cpp: see train_report.hpp.
#include "sim/studies/train/train_report.hpp"

#include <fmt/format.h>

#include <numeric>

#include "sim/report/finite.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Likeness& likeness) {
  return {{"psnr_db", finite_json(likeness.psnr)}, {"ssim", finite_json(likeness.ssim)}};
}

// The mean over the first so many.
Likeness mean_of(std::vector<Likeness> views, std::size_t count) {
  views.resize(count);
  return mean_of(views);
}

uint64_t mean_cycles(const MachineViews& machine, std::size_t count) {
  return std::accumulate(machine.cycles.begin(), machine.cycles.begin() + static_cast<std::ptrdiff_t>(count),
                         uint64_t{0}) /
         count;
}

Json json_of(const TrainQuality& quality, const TrainReport& report) {
  const std::size_t count = report.held_out;
  Json json = {{"exact", json_of(mean_of(quality.exact, count))},
               {"layered", json_of(mean_of(quality.layered, count))}};
  for (const MachineViews& machine : quality.machines) {
    Json& mean = json["machines"][machine.name] = json_of(mean_of(machine.likeness, count));
    mean["cycles"] = mean_cycles(machine, count);
  }
  json["violators"] = quality.margin.share;
  for (std::size_t i = 0; i < report.measured.size(); ++i) {
    Json view = {{"camera", report.measured[i]},
                 {"held_out", i < count},
                 {"exact", json_of(quality.exact[i])},
                 {"layered", json_of(quality.layered[i])}};
    for (const MachineViews& machine : quality.machines) {
      view[machine.name] = json_of(machine.likeness[i]);
      view[machine.name]["cycles"] = machine.cycles[i];
    }
    json["views"].push_back(view);
  }
  return json;
}

std::string text_of(const char* who, const Likeness& likeness) {
  return fmt::format("    {:14} {:5.2f} dB, SSIM {:.4f}", who, likeness.psnr, likeness.ssim);
}

std::string text_of(const TrainQuality& quality, const TrainReport& report) {
  const std::size_t count = report.held_out;
  std::string text = text_of("exact order", mean_of(quality.exact, count)) + "\n" +
                     text_of(fmt::format("in {} layers", report.layers).c_str(), mean_of(quality.layered, count)) +
                     "\n";
  for (const MachineViews& machine : quality.machines)
    text += fmt::format("{}, {} cycles a frame\n", text_of(machine.name.c_str(), mean_of(machine.likeness, count)),
                        mean_cycles(machine, count));
  for (std::size_t i = count; i < report.measured.size(); ++i) {
    text += fmt::format("    {}, trained on:", report.measured[i]);
    for (const MachineViews& machine : quality.machines)
      text += fmt::format(" {} {:.2f} dB", machine.name, machine.likeness[i].psnr);
    text += "\n";
  }
  const auto& share = quality.margin.share;
  return text + fmt::format("    {:.1f} %, {:.1f} % and {:.1f} % of the Gaussians reach over a plane across x, y, z\n",
                            100 * share[0], 100 * share[1], 100 * share[2]);
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
  given["cldr"] = !regularised ? "none" : options.cldr.form == CldrForm::kPrinted ? "printed" : "logarithm";
  given["cldr_weight"] = regularised ? Json(options.cldr.weight) : Json(nullptr);
  given["layers_begin"] = options.layers > 0 ? Json(options.layers_begin) : Json(nullptr);
  if (report.before) json["held_out_before"] = json_of(*report.before, report);
  json["held_out"] = json_of(report.after, report);
  return json;
}

std::string train_text(const TrainState& state, const TrainReport& report) {
  std::string text = fmt::format("{} Gaussians, SH degree {}, after {} steps in {:.1f} minutes\n",
                                 state.parameters.size(), state.parameters.sh_degree, state.step, state.seconds / 60);
  text += fmt::format("{} of {} views were held out\n", report.held_out, report.held_out + report.trained);
  if (report.before) text += "  before\n" + text_of(*report.before, report) + "  after\n";
  return text + text_of(report.after, report);
}

}  // namespace pipegs
