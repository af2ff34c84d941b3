// SPDX-License-Identifier: Apache-2.0
// info: see info.hpp.
//
// Idea    One pass activates and collects, then nth_element per percentile.
#include "scenes/info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scenes/percentile.hpp"
#include "scenes/text/json.hpp"

namespace pipegs {
namespace {

constexpr double kFaint = 1.0 / 255;

double rank(const std::vector<double>& values, int percent) {
  return values.empty() ? 0 : percentile(values, percent / 100.0);
}

Percentiles percentiles(const std::vector<double>& values) {
  Percentiles out{};
  for (std::size_t i = 0; i < kPercentiles.size(); ++i) out[i] = rank(values, kPercentiles[i]);
  return out;
}

}  // namespace

SceneInfo inspect(const Scene& scene, const Findings& findings) {
  check_consistent(scene);
  SceneInfo info;
  info.findings = findings;
  info.name = scene.name;
  info.gaussians = scene.gaussians.size();
  info.sh_degree = scene.sh_degree;
  info.antialiased = scene.antialiased;
  std::vector<double> scale, opacity, anisotropy;
  std::array<std::vector<double>, 3> axes;
  std::size_t faint = 0;
  for (std::size_t i = 0; i < scene.gaussians.size(); ++i) {
    ActivatedGaussian g;
    if (activate(scene, i, g) != Cull::kNone) continue;
    ++info.usable;
    const double largest = std::max({g.scale.x, g.scale.y, g.scale.z});
    const double smallest = std::min({g.scale.x, g.scale.y, g.scale.z});
    scale.push_back(largest);
    opacity.push_back(g.opacity);
    anisotropy.push_back(largest > 0 ? largest / smallest : 1);  // a flat one is infinitely anisotropic
    for (int a = 0; a < 3; ++a) axes[static_cast<std::size_t>(a)].push_back(g.mean[a]);
    faint += g.opacity < kFaint;
  }
  for (int a = 0; a < 3; ++a) {
    auto& values = axes[static_cast<std::size_t>(a)];
    info.lowest[a] = rank(values, 0);
    info.highest[a] = rank(values, 100);
    info.box_lowest[a] = rank(values, 2);
    info.box_highest[a] = rank(values, 98);
  }
  info.scale = percentiles(scale);
  info.opacity = percentiles(opacity);
  info.anisotropy = percentiles(anisotropy);
  if (info.usable > 0) info.faint_share = static_cast<double>(faint) / static_cast<double>(info.usable);
  return info;
}

std::string to_text(const SceneInfo& info) {
  std::string out =
      fmt::format("{}: {} Gaussians ({} usable), SH degree {}{}\n", info.name.empty() ? "scene" : info.name,
                  info.gaussians, info.usable, info.sh_degree, info.antialiased ? ", antialiased" : "");
  const auto box = [&](const char* name, const glm::dvec3& a, const glm::dvec3& b) {
    out += fmt::format("  {:<14}[{:.4g}, {:.4g}, {:.4g}] .. [{:.4g}, {:.4g}, {:.4g}]\n", name, a.x, a.y, a.z, b.x, b.y,
                       b.z);
  };
  box("bounds", info.lowest, info.highest);
  box("2..98 % box", info.box_lowest, info.box_highest);
  out += fmt::format("  {:<14}", "percentile");
  for (const int p : kPercentiles) out += fmt::format("{:>11}", p);
  out += '\n';
  const auto line = [&](const char* name, const Percentiles& values) {
    out += fmt::format("  {:<14}", name);
    for (const double v : values) out += fmt::format("{:>11.4g}", v);
    out += '\n';
  };
  line("scale", info.scale);
  line("opacity", info.opacity);
  line("anisotropy", info.anisotropy);
  out += fmt::format("  opacity below 1/255: {:.2f} %\n", 100 * info.faint_share);
  if (!info.format.name.empty()) {
    out += fmt::format("  {:<14}{}; axes {}\n", "format", info.format.name,
                       info.format.axes.empty() ? "not said" : info.format.axes);
    for (const auto& [field, bits] : info.format.fields) out += fmt::format("    {:<12}{}\n", field, bits);
  }
  for (const Finding& finding : info.findings) out += fmt::format("  {}\n", finding_line(finding));
  return out;
}

std::string to_json(const SceneInfo& info) {
  using Json = nlohmann::ordered_json;
  const auto vector = [](const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); };
  const auto table = [](const Percentiles& values) {
    Json out;
    for (std::size_t i = 0; i < values.size(); ++i) {
      // JSON has no infinity; a flat Gaussian's anisotropy is null.
      out["p" + std::to_string(kPercentiles[i])] = std::isfinite(values[i]) ? Json(values[i]) : Json(nullptr);
    }
    return out;
  };
  Json format = nullptr;
  if (!info.format.name.empty()) {
    Json fields = Json::object();
    for (const auto& [field, bits] : info.format.fields) fields[field] = bits;
    format = {{"name", info.format.name},
              {"axes", info.format.axes.empty() ? Json(nullptr) : Json(info.format.axes)},
              {"fields", fields}};
  }
  const Json out = {{"name", info.name},
                    {"format", format},
                    {"gaussians", info.gaussians},
                    {"usable", info.usable},
                    {"sh_degree", info.sh_degree},
                    {"antialiased", info.antialiased},
                    {"bounds", {vector(info.lowest), vector(info.highest)}},
                    {"box_2_98", {vector(info.box_lowest), vector(info.box_highest)}},
                    {"scale", table(info.scale)},
                    {"opacity", table(info.opacity)},
                    {"anisotropy", table(info.anisotropy)},
                    {"faint_share", info.faint_share},
                    {"findings", to_json(info.findings)}};
  return json_text(out, 1);
}

}  // namespace pipegs
