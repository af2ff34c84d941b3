// SPDX-License-Identifier: Apache-2.0
// report.cpp: see report.hpp.
#include "sim/studies/accuracy/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/design/design_point.hpp"
#include "sim/studies/accuracy/accuracy_json.hpp"
#include "sim/silicon/report.hpp"

namespace pipegs {
namespace {

constexpr double kFlat = 1;  // decibels that a step must gain to be worth a word

double percent(double value, double base) { return 100 * (value / base - 1); }
double cycles(const MeasuredPoint& point) { return static_cast<double>(point.figures.cycles); }
double bytes(const MeasuredPoint& point) { return static_cast<double>(point.figures.bytes); }

// What a knob is judged by: an order knob by the sum of both errors.
double quality(const Knob& knob, const Accuracy& a) {
  const double sum = mean_square(a.numeric.psnr) + (knob.orders ? mean_square(a.order.psnr) : 0);
  return -10 * std::log10(sum);
}

std::string row_text(const std::string& label, const MeasuredPoint& point, const Accuracy& base) {
  const Accuracy& a = point.figures;
  if (!a.failure.empty()) return fmt::format("  {:<14}{}\n", label, a.failure);
  return fmt::format(
      "  "
      "{:<14}{:>8}{:>8}{:>8}{:>9.5f}{:>8.4f}{:>8.4f}{:>9.4f}{:>10}{:>+8.2f}{:>7}{:>9}{:>8.1f}{:>7.1f}{:>9.1f}{:>7}"
      "{:>7}{:>8.1f}\n",
      label, decibels(a.numeric.psnr), decibels(a.order.psnr), decibels(a.total.psnr), a.total.ssim, a.numeric.max,
      a.numeric.p999, 100 * a.flips.share(), a.cycles,
      percent(static_cast<double>(a.cycles), static_cast<double>(base.cycles)), clock_text(point), time_text(point),
      static_cast<double>(a.bytes) / 1e6, a.gbps(), a.buffer_kb(), area_text(point), energy_text(point),
      a.seconds_golden + a.seconds_truth + a.seconds_trace + a.seconds_model);
}

std::string front_text(const std::vector<MeasuredPoint>& points, Cost cost, const char* name, const Config& base) {
  std::string text = fmt::format("\n  front over {}\n  {:>8}{:>8}{:>8}{:>10}{:>9}{:>8}{:>9}{:>7}{:>7}  configuration\n",
                                 name, "numeric", "order", "total", "cycles", "us", "MB", "buf KB", "mm2", "mJ");
  for (const MeasuredPoint* point : pareto_front(points, cost)) {
    const Accuracy& a = point->figures;
    text += fmt::format("  {:>8}{:>8}{:>8}{:>10}{:>9}{:>8.1f}{:>9.1f}{:>7}{:>7}  {}\n", decibels(a.numeric.psnr),
                        decibels(a.order.psnr), decibels(a.total.psnr), a.cycles, time_text(*point),
                        static_cast<double>(a.bytes) / 1e6, a.buffer_kb(), area_text(*point), energy_text(*point),
                        difference(point->config, base));
  }
  return text;
}

bool clock_known(const std::vector<MeasuredPoint>& points) {
  return std::any_of(points.begin(), points.end(),
                     [](const MeasuredPoint& point) { return has_cost(point, Cost::kTime); });
}

// Every measured row: knob, label, point.
template <class Visit>
void each_row(const AccuracySweep& sweep, Visit&& visit) {
  visit("base", "", sweep.base);
  for (const SweptKnob& knob : sweep.knobs) {
    for (size_t i = 0; i < knob.points.size(); ++i) visit(knob.knob->name, knob.values[i]->label, knob.points[i]);
  }
  for (size_t i = 0; i < sweep.together.size(); ++i) visit("together", fmt::format("{}", i + 1), sweep.together[i]);
}

Chart front_chart(const AccuracySweep& sweep, Cost cost, const std::string& name, const std::string& title,
                  const std::string& label) {
  Chart chart{.name = "by_" + name,
              .form = Chart::Form::kScatter,
              .title = title,
              .x_label = label,
              .y_label = "numeric PSNR, dB"};
  const double unit = cost == Cost::kBytes ? 1e6 : cost == Cost::kCycles ? 1e3 : cost == Cost::kEnergy ? 1e-3 : 1;
  const auto add = [&](Series& series, const MeasuredPoint& point) {
    if (!point.figures.failure.empty() || !has_cost(point, cost)) return;
    series.x.push_back(cost_of(point, cost) / unit);
    series.values.push_back(point.figures.numeric.psnr);
    series.labels.push_back(difference(point.config, sweep.base.config));
    series.copies.push_back(machine_words(point.config));
  };
  Series alone{.name = "one knob"}, together{.name = "together"}, base{.name = "base"},
      front{.name = "front", .outlined = true};
  for (const SweptKnob& knob : sweep.knobs) {
    for (const MeasuredPoint& point : knob.points) {
      if (!(point.config == sweep.base.config)) add(alone, point);
    }
  }
  for (const MeasuredPoint& point : sweep.together) add(together, point);
  add(base, sweep.base);
  const std::vector<MeasuredPoint> all = sweep.all();
  for (const MeasuredPoint* point : pareto_front(all, cost)) add(front, *point);
  chart.series = {alone, together, base, front};
  return chart;
}

}  // namespace

std::string area_text(const MeasuredPoint& point) {
  return point.silicon ? interpolated_text(point.silicon->mm2.mid, point.silicon->extrapolated_area, 2) : "-";
}
std::string energy_text(const MeasuredPoint& point) {
  return point.silicon ? interpolated_text(point.silicon->joules() * 1e3, point.silicon->extrapolated_energy, 2) : "-";
}

std::string clock_text(const MeasuredPoint& point) {
  return has_cost(point, Cost::kTime) ? interpolated_text(*point.silicon->ghz(), point.silicon->extrapolated_path, 3)
                                      : "-";
}
std::string time_text(const MeasuredPoint& point) {
  return has_cost(point, Cost::kTime) ? interpolated_text(point.silicon->us, point.silicon->extrapolated_path, 1) : "-";
}

std::string decibels(double psnr) { return std::isfinite(psnr) ? fmt::format("{:.2f}", psnr) : "inf"; }

std::string difference(const Config& config, const Config& base) {
  std::string text;
  for (const ConfigEntry& entry : config_entries(config)) {
    if (entry.member == nullptr || base.*entry.member == entry.value) continue;
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", entry.name, entry.value);
  }
  return text.empty() ? "base" : text;
}

std::string config_file(const Config& config, const std::string& comment) {
  std::string text = "# " + comment + "\n";
  for (const ConfigEntry& entry : config_entries(config)) {
    if (entry.member != nullptr) text += fmt::format("{}={}\n", entry.name, entry.value);
  }
  return text;
}

std::string knob_sentence(const SweptKnob& swept) {
  const Knob& knob = *swept.knob;
  std::vector<size_t> measured;
  for (size_t i = 0; i < swept.points.size(); ++i) {
    if (swept.points[i].figures.failure.empty()) measured.push_back(i);
  }
  if (measured.size() < 2) return fmt::format("{}: one value only.", knob.name);
  const char* what = knob.orders ? "numeric and order error" : "numeric error";
  // The last step that gains a decibel over all before it.
  size_t from = measured[0], to = measured[0];
  double best = quality(knob, swept.points[measured[0]].figures);
  size_t best_at = measured[0];
  for (size_t k = 1; k < measured.size(); ++k) {
    const double here = quality(knob, swept.points[measured[k]].figures);
    if (here >= best + kFlat) from = best_at, to = measured[k];
    if (here > best) best = here, best_at = measured[k];
  }
  const auto cost = [&](const MeasuredPoint& a, const MeasuredPoint& b) {
    const double kb = b.figures.buffer_kb() - a.figures.buffer_kb();
    const std::string text = fmt::format("{:+.2f} % cycles, {:+.2f} % bytes, {:+.1f} KB of buffers",
                                         percent(cycles(b), cycles(a)), percent(bytes(b), bytes(a)), kb);
    if (!a.silicon || !b.silicon) return text;
    return text + fmt::format(", {}{:+.1f} % area and {}{:+.1f} % energy",
                              a.silicon->extrapolated_area || b.silicon->extrapolated_area ? "~" : "",
                              percent(b.silicon->mm2.mid, a.silicon->mm2.mid),
                              a.silicon->extrapolated_energy || b.silicon->extrapolated_energy ? "~" : "",
                              percent(b.silicon->joules(), a.silicon->joules()));
  };
  const size_t last = measured.back();
  if (to == from) {
    const double coarse = quality(knob, swept.points[from].figures);
    return fmt::format("{}: {} is enough: {:.1f} dB of {}, {:.1f} dB at best; {} in its place costs {}.", knob.name,
                       swept.values[from]->label, coarse, what, best, swept.values[last]->label,
                       cost(swept.points[from], swept.points[last]));
  }
  const double gain = quality(knob, swept.points[to].figures) - quality(knob, swept.points[from].figures);
  std::string text = fmt::format("{}: from {} to {} {:+.1f} dB of {} for {}", knob.name, swept.values[from]->label,
                                 swept.values[to]->label, gain, what, cost(swept.points[from], swept.points[to]));
  if (to != last) {
    text += fmt::format("; beyond, to {}, {:+.1f} dB for {}", swept.values[last]->label,
                        quality(knob, swept.points[last].figures) - quality(knob, swept.points[to].figures),
                        cost(swept.points[to], swept.points[last]));
  }
  return text + ".";
}

std::string accuracy_text(const AccuracySweep& sweep) {
  const Accuracy& base = sweep.base.figures;
  std::string text =
      fmt::format("  {:<14}{:>8}{:>8}{:>8}{:>9}{:>8}{:>8}{:>9}{:>10}{:>8}{:>7}{:>9}{:>8}{:>7}{:>9}{:>7}{:>7}{:>8}\n",
                  "", "numeric", "order", "total", "SSIM", "max", "99.9 %", "flips %", "cycles", "%", "GHz", "us", "MB",
                  "GB/s", "buf KB", "mm2", "mJ", "host s");
  text += row_text("base", sweep.base, base);
  for (const SweptKnob& knob : sweep.knobs) {
    text += fmt::format("\n  {}: {}\n", knob.knob->name, knob.knob->what);
    for (size_t i = 0; i < knob.points.size(); ++i) {
      const bool is_base = knob.points[i].config == sweep.base.config;
      text += row_text(knob.values[i]->label + (is_base ? " *" : ""), knob.points[i], base);
    }
    text += "  " + knob_sentence(knob) + "\n";
  }
  for (const std::string& reason : sweep.skipped) text += fmt::format("\n  left out: {}", reason);
  if (!sweep.skipped.empty()) text += "\n";
  const std::vector<MeasuredPoint> all = sweep.all();
  text += front_text(all, Cost::kCycles, "cycles", sweep.base.config) +
          (clock_known(all) ? front_text(all, Cost::kTime, "time", sweep.base.config) : "") +
          front_text(all, Cost::kBytes, "bytes", sweep.base.config) +
          front_text(all, Cost::kBuffers, "buffers", sweep.base.config) +
          front_text(all, Cost::kArea, "area", sweep.base.config) +
          front_text(all, Cost::kEnergy, "energy", sweep.base.config);
  text += fmt::format(
      "\n  * the base; flips: of {:.0f} % of the pixels; host s: of one core\n  mm2, mJ: 28 nm, mid, SRAMs and DRAM in "
      "them, interpolated (docs/numerics/accuracy.md); ~: beyond what was synthesised or measured,\n"
      "  -: no machine of the kind was\n",
      100 * sweep.flips_sampled);
  text += clock_known(all) ? "  GHz: what the longest path allows, 28 nm, mid, interpolated; us: cycles / GHz\n"
                           : "  GHz: no longest path of such a machine is known, so cycles count at 1 GHz\n";
  return text + fmt::format("  {} points measured in {:.0f} s, {} taken from the folder\n", sweep.computed,
                            sweep.seconds, sweep.kept);
}

std::string accuracy_csv(const AccuracySweep& sweep) {
  std::string text =
      "knob,value,configuration,numeric_db,order_db,total_db,numeric_ssim,order_ssim,total_ssim,numeric_max,numeric_"
      "p999,total_max,total_p999,"
      "decisions,flipped,cycles,ms_at_1ghz,bytes,gbps,buffer_bytes,mm2,chip_mj,dram_mj,ghz,us,golden_s,truth_s,trace_s,"
      "model_s\n";
  each_row(sweep, [&](const std::string& knob, const std::string& label, const MeasuredPoint& point) {
    const Accuracy& a = point.figures;
    if (!a.failure.empty()) return;
    text += fmt::format(
        "{},{},{},{:.4f},{:.4f},{:.4f},{:.7f},{:.7f},{:.7f},{:.6f},{:.6f},{:.6f},{:.6f},{},{},{},{:.6f},{},{:.3f},{},"
        "{},{},{:.3f},{:.3f},{:.3f},{:.3f}\n",
        knob, label, difference(point.config, Config{}), a.numeric.psnr, a.order.psnr, a.total.psnr, a.numeric.ssim,
        a.order.ssim, a.total.ssim, a.numeric.max, a.numeric.p999, a.total.max, a.total.p999, a.flips.decisions,
        a.flips.flipped, a.cycles, static_cast<double>(a.cycles) * 1e-6, a.bytes, a.gbps(), a.buffer_bits / 8,
        point.silicon ? fmt::format("{:.4f},{:.5f},{:.5f}", point.silicon->mm2.mid, point.silicon->chip.mid * 1e3,
                                    point.silicon->dram.mid * 1e3)
                      : ",,",
        has_cost(point, Cost::kTime) ? fmt::format("{:.4f},{:.3f}", *point.silicon->ghz(), point.silicon->us) : ",",
        a.seconds_golden, a.seconds_truth, a.seconds_trace, a.seconds_model);
  });
  return text;
}

nlohmann::ordered_json accuracy_json(const AccuracySweep& sweep) {
  using Json = nlohmann::ordered_json;
  const auto row = [&](const MeasuredPoint& point) {
    Json json = to_json(point.figures);
    if (const std::optional<FrameCost>& silicon = point.silicon) {
      json["silicon"] = {{"mm2", to_json(silicon->mm2)},
                         {"chip_mj", to_json(silicon->chip * 1e3)},
                         {"dram_mj", to_json(silicon->dram * 1e3)},
                         {"extrapolated_area", silicon->extrapolated_area},
                         {"extrapolated_energy", silicon->extrapolated_energy},
                         {"path_ps", nullptr},
                         {"ghz", nullptr},
                         {"us", nullptr}};
      if (has_cost(point, Cost::kTime)) {
        json["silicon"].update({{"path_ps", to_json(kFo4Ps * *silicon->path_fo4)},
                                {"ghz", *silicon->ghz()},
                                {"us", silicon->us},
                                {"extrapolated_path", silicon->extrapolated_path}});
      }
    } else if (point.figures.failure.empty()) {
      json["silicon"] = nullptr;
    }
    json["configuration"] = config_difference(point.config);
    return json;
  };
  Json json = {{"base", row(sweep.base)},
               {"flips_sampled", sweep.flips_sampled},
               {"knobs", Json::array()},
               {"together", Json::array()}};
  for (const SweptKnob& knob : sweep.knobs) {
    Json one = {{"name", knob.knob->name},
                {"what", knob.knob->what},
                {"sentence", knob_sentence(knob)},
                {"values", Json::array()}};
    for (size_t i = 0; i < knob.points.size(); ++i) {
      one["values"].push_back(row(knob.points[i]));
      one["values"].back()["label"] = knob.values[i]->label;
    }
    json["knobs"].push_back(one);
  }
  for (const MeasuredPoint& point : sweep.together) json["together"].push_back(row(point));
  const std::vector<MeasuredPoint> all = sweep.all();
  for (const auto& [name, cost] : {std::pair{"cycles", Cost::kCycles},
                                   {"time", Cost::kTime},
                                   {"bytes", Cost::kBytes},
                                   {"buffers", Cost::kBuffers},
                                   {"area", Cost::kArea},
                                   {"energy", Cost::kEnergy}}) {
    json["front"][name] = Json::array();
    for (const MeasuredPoint* point : pareto_front(all, cost))
      json["front"][name].push_back(config_difference(point->config));
  }
  json["skipped"] = sweep.skipped;
  return json;
}

std::vector<Chart> front_charts(const AccuracySweep& sweep) {
  std::vector<Chart> charts = {
      front_chart(sweep, Cost::kCycles, "cycles", "Accuracy against cycles", "kilocycles of the frame"),
      front_chart(sweep, Cost::kBytes, "bytes", "Accuracy against memory traffic", "MB a frame"),
      front_chart(sweep, Cost::kBuffers, "buffers", "Accuracy against buffers", "KB of SRAM"),
      front_chart(sweep, Cost::kArea, "area", "Accuracy against area", "mm2 in 28 nm, mid, interpolated"),
      front_chart(sweep, Cost::kEnergy, "energy", "Accuracy against energy",
                  "mJ a frame with DRAM, mid, interpolated")};
  if (clock_known(sweep.all()))
    charts.insert(charts.begin() + 1,
                  front_chart(sweep, Cost::kTime, "time", "Accuracy against time", "us of a frame"));
  return charts;
}

Chart knob_chart(const SweptKnob& knob) {
  Chart chart{.name = knob.knob->name,
              .form = Chart::Form::kLines,
              .title = knob.knob->name,
              .x_label = knob.knob->name + ", coarse to fine",
              .y_label = "PSNR, dB"};
  chart.series = {{.name = "numeric"}, {.name = "order"}, {.name = "total"}};
  for (size_t i = 0; i < knob.points.size(); ++i) {
    const Accuracy& a = knob.points[i].figures;
    chart.x.push_back(static_cast<double>(i));
    chart.categories.push_back(knob.values[i]->label);
    const double values[3] = {a.numeric.psnr, a.order.psnr, a.total.psnr};
    for (int k = 0; k < 3; ++k) chart.series[k].values.push_back(a.failure.empty() ? values[k] : std::nan(""));
  }
  chart.from_zero = false;
  return chart;
}

}  // namespace pipegs
