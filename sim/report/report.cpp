// SPDX-License-Identifier: Apache-2.0
// report.cpp: see report.hpp.
#include "sim/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/host_use.hpp"
#include "sim/report/finite.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

// A figure of what was run; null when it was not.
Json of(bool run, Json value) { return run ? std::move(value) : Json(nullptr); }

// Null says of equal images as well that their PSNR is no number.
Json decibels(bool run, double value) { return of(run, finite_json(value)); }

Json units_json(const std::vector<UnitCycles>& units) {
  Json array = Json::array();
  for (const UnitCycles& unit : units) {
    array.push_back(
        {{"busy", unit.busy}, {"starved", unit.starved}, {"blocked", unit.blocked}, {"memory", unit.memory}});
  }
  return array;
}

// Over the pins of external memory.
MemoryBytes total_bytes(const Simulation& simulation) {
  MemoryBytes bytes;
  for (const MemoryTraffic& traffic : simulation.traffic)
    bytes.read += traffic.bytes_read, bytes.written += traffic.bytes_written;
  return bytes;
}

// Gaussians of the frame that are fetched. Behind what is opaque as many are left out as time has it (occlusion): then
// no more than came over the pins.
uint64_t fetched(const Simulation& simulation, const Config& config) {
  uint64_t most = simulation.golden.work.fetched;
  for (const MemoryTraffic& traffic : simulation.traffic) {
    if (config.occlusion && traffic.stream == "geometry" && traffic.bytes_read != 0)
      most = std::min<uint64_t>(most, traffic.bytes_read * 8 / config.memory_w() * config.gaussians_per_line());
  }
  return most;
}

}  // namespace

Json traffic_json(const std::vector<MemoryTraffic>& streams) {
  uint64_t read = 0, written = 0;
  Json by_stream;
  for (const auto& [stream, bytes_read, bytes_written, bursts] : streams) {
    read += bytes_read, written += bytes_written;
    by_stream[stream] = {{"read", bytes_read}, {"written", bytes_written}, {"bursts", bursts}};
  }
  return {{"bytes_read", read}, {"bytes_written", written}, {"by_stream", by_stream}};
}

Json mismatch_json(const std::optional<Mismatch>& mismatch) {
  if (!mismatch) return nullptr;
  const auto given = [](const auto& value) { return value ? Json(*value) : Json(nullptr); };
  const auto said = [](const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); };
  return {{"cycle", mismatch->cycle},        {"window", {mismatch->window_x, mismatch->window_y}},
          {"stream", mismatch->stream()},    {"signal", said(mismatch->signal())},
          {"unit", given(mismatch->unit)},   {"gaussian", given(mismatch->gaussian)},
          {"layer", given(mismatch->layer)}, {"region", given(mismatch->region)},
          {"pixel", given(mismatch->pixel)}, {"field", said(mismatch->field)},
          {"expected", mismatch->expected},  {"found", said(mismatch->found)},
          {"what", mismatch->what}};
}

Bounds work_bounds(const Simulation& simulation, const SimulateOptions& options) {
  const Config& config = options.config;
  const Work& work = simulation.golden.work;
  const double units = config.units;
  Bounds bounds;
  // Regions that are done are skipped, save by PUs that cache the alphas of the whole frame before the first is
  // blended.
  const uint64_t rows = config.caches_alphas() && config.has_lists() ? work.regions : work.open_regions;
  if (config.quads) {
    bounds.rows = static_cast<double>(work.open_regions) / units;
    bounds.ru = static_cast<double>(work.quads) / Config::ru_groups() / units;
  } else {
    bounds.rows = static_cast<double>(rows) * 8 / config.pixels_per_row / units;
    bounds.ru = static_cast<double>(work.open_regions) * 4 / units;
  }
  bounds.su = static_cast<double>(work.keys) / units;
  bounds.cull = static_cast<double>(fetched(simulation, config)) / config.pu_fronts();
  const MemoryBytes bytes = total_bytes(simulation);
  bounds.memory = static_cast<double>(bytes.read + bytes.written) / memory_peak(options.memory);
  // A beat of each of its two channels in a cycle.
  if (config.bus_w > 0) bounds.bus = static_cast<double>(std::max(bytes.read, bytes.written)) * 8 / config.bus_w;
  for (const auto& [name, value] : {std::pair{"Row Units", bounds.rows},
                                    {"RU", bounds.ru},
                                    {"SU", bounds.su},
                                    {"cull", bounds.cull},
                                    {"memory", bounds.memory},
                                    {"bus", bounds.bus}}) {
    if (value > bounds.largest) bounds.largest = value, bounds.largest_name = name;
  }
  return bounds;
}

Json report_json(const Scene& scene, const Camera& camera, const SimulateOptions& options, const Simulation& simulation,
                 const Findings& odd) {
  Json report;
  report["scene"] = {{"name", scene.name},
                     {"gaussians", scene.gaussians.size()},
                     {"sh_degree", scene.sh_degree},
                     {"packed", simulation.packed.counts.packed},
                     {"chunks", simulation.packed.chunks.size()},
                     {"left_out",
                      {{"non_finite", simulation.packed.counts.non_finite},
                       {"zero_quaternion", simulation.packed.counts.zero_quaternion},
                       {"transparent", simulation.packed.counts.transparent},
                       {"out_of_range", simulation.packed.counts.out_of_range}}}};
  report["findings"] = to_json(odd);
  report["camera"] = {{"name", camera.name},     {"id", camera.id}, {"width", camera.width},
                      {"height", camera.height}, {"fx", camera.fx}, {"fy", camera.fy}};
  if (options.window) report["window"] = {(*options.window)[0], (*options.window)[1]};
  if (options.crop) {
    const PixelRect& crop = *options.crop;
    report["crop"] = {crop.x0, crop.y0, crop.x1 - crop.x0, crop.y1 - crop.y0};
  }
  Json config;
  for (const ConfigEntry& entry : config_entries(options.config)) config[std::string(entry.name)] = entry.value;
  config["memory"] = options.memory.dram;
  if (options.memory.dram == "ideal") {
    config["memory_latency"] = options.memory.latency;
    config["memory_jitter"] = options.memory.jitter;
  }
  config["memory_bytes_per_cycle"] = memory_peak(options.memory);
  if (options.config.has_walks()) config["walk_most"] = options.walk_most;
  if (options.rest != 0) config["rest"] = options.rest;
  if (options.lod_pixels != 0) config["lod_pixels"] = options.lod_pixels;
  config["picture"] = options.raster ? "raster" : "windows";
  config["seed"] = options.rtl.seed;
  report["config"] = config;

  // A run leaves its traffic, and a picture, even where they are empty.
  const bool rtl = !simulation.traffic.empty(), truth = simulation.truth_order.width > 0;
  report["ran"] = {{"truth", truth}, {"rtl", rtl}};
  report["cycles"] = of(rtl, simulation.rtl.cycles);
  report["preprocess_cycles"] = of(rtl, simulation.rtl.preprocess_cycles);
  report["units"] = of(rtl, {{"dopu", units_json(simulation.rtl.dopu)},
                             {"pu", units_json(simulation.rtl.pu)},
                             {"su", units_json(simulation.rtl.su)},
                             {"ru", units_json(simulation.rtl.ru)}});
  report["memory"] = of(rtl, traffic_json(simulation.traffic));
  if (simulation.dram) {
    const Dram::Statistics& s = simulation.dram->statistics;
    report["memory"]["dram"] = {{"gbps", simulation.dram->gbps},
                                {"peak_gbps", simulation.dram->peak_gbps},
                                {"row_hits", s.row_hits},
                                {"row_misses", s.row_misses},
                                {"row_conflicts", s.row_conflicts},
                                {"activates", s.activates},
                                {"refreshes", s.refreshes},
                                {"read_latency_cycles",
                                 {{"mean", s.latency_mean},
                                  {"p50", s.latency_p50},
                                  {"p90", s.latency_p90},
                                  {"p99", s.latency_p99},
                                  {"max", s.latency_max}}}};
  }
  const Work& work = simulation.golden.work;
  report["work"] = {{"fetched", work.fetched},
                    {"visible", work.visible},
                    {"records", work.records},
                    {"regions", work.regions},
                    {"open_regions", work.open_regions},
                    {"quads", of(options.config.quads != 0, work.quads)},
                    {"alphas", work.alphas},
                    {"blended", work.blended},
                    {"keys", work.keys},
                    {"overflow_lines", of(rtl, simulation.rtl.overflow_lines)},
                    {"chunks", work.chunks},
                    {"layers", work.layers},
                    {"windows", work.windows}};
  const Bounds bounds = work_bounds(simulation, options);
  // What memory and bus need is known from the traffic of the RTL alone, and so is which bound is the largest.
  report["bounds"] = {{"pu_rows", std::llround(bounds.rows)},
                      {"ru", std::llround(bounds.ru)},
                      {"su", std::llround(bounds.su)},
                      {"cull", std::llround(bounds.cull)},
                      {"memory", of(rtl, std::llround(bounds.memory))},
                      {"bus", of(rtl && options.config.bus_w > 0, std::llround(bounds.bus))},
                      {"largest", of(rtl && bounds.largest > 0, bounds.largest_name)},
                      {"cycles_over_largest",
                       of(rtl && bounds.largest > 0, static_cast<double>(simulation.rtl.cycles) / bounds.largest)}};
  report["beats_compared"] = of(rtl, simulation.beats);
  report["mismatches"] = of(rtl, simulation.mismatches);
  report["first_mismatch"] = mismatch_json(simulation.first_mismatch);
  report["psnr_numeric_db"] = decibels(truth, simulation.psnr_numeric);
  report["psnr_order_db"] = decibels(truth, simulation.psnr_order);
  report["psnr_total_db"] = decibels(truth, simulation.psnr_total);
  report["max_abs_error"] = of(truth, simulation.max_abs_error);
  const PackCounts& counts = simulation.packed.counts;
  const Saturations& saturations = simulation.golden.saturations;
  report["saturations"] = {{"scale", counts.saturated_scale},
                           {"base", counts.saturated_base},
                           {"sh", counts.saturated_sh},
                           {"mean", saturations.mean},
                           {"dead", saturations.dead},
                           {"color", saturations.color},
                           {"accumulated", saturations.accumulated}};
  report["wall_seconds"] = {{"truth", of(truth, simulation.wall_truth)},
                            {"golden", simulation.wall_golden},
                            {"rtl", of(rtl, simulation.wall_rtl)}};
  report["host"] = {{"cpu_seconds",
                     {{"pack", simulation.cpu_pack},
                      {"golden", simulation.cpu_golden},
                      {"truth", of(truth, simulation.cpu_truth)},
                      {"all", process_seconds()}}},
                    {"peak_memory_bytes", peak_memory_bytes()}};
  report["rtl_khz"] =
      of(rtl && simulation.wall_rtl > 0, static_cast<double>(simulation.rtl.cycles) / simulation.wall_rtl / 1000);
  return report;
}

namespace {

// Lines of text, one after the other.
struct Lines {
  std::string text;
  template <class... T>
  void add(fmt::format_string<T...> format, T&&... arguments) {
    text += fmt::format(format, std::forward<T>(arguments)...) + "\n";
  }
};

void add_units(Lines& lines, const Json& report) {
  const double cycles = std::max<double>(1, report["cycles"].get<double>());
  lines.add("  where every cycle went     busy  starved  blocked   memory");
  for (const auto& kind : report["units"].items()) {
    for (size_t i = 0; i < kind.value().size(); ++i) {
      const Json& unit = kind.value()[i];
      const auto share = [&](const char* what) { return 100 * unit[what].get<double>() / cycles; };
      lines.add("    {:<4} {:<18} {:7.1f}% {:7.1f}% {:7.1f}% {:7.1f}%", kind.key(), i, share("busy"), share("starved"),
                share("blocked"), share("memory"));
    }
  }
  lines.add("");
}

void add_cycles(Lines& lines, const Json& report) {
  const Json& bounds = report["bounds"];
  lines.add("  cycles {:>12}    {}", report["cycles"].get<uint64_t>(),
            bounds["largest"].is_null()
                ? std::string("no work, so no roofline")
                : fmt::format("roofline ratio {:.3f}, bound by {}", bounds["cycles_over_largest"].get<double>(),
                              bounds["largest"].get<std::string>()));
  if (const auto before = report["preprocess_cycles"].get<uint64_t>(); before > 0)
    lines.add("         {:>12}    of these before the first list is read", before);
}

void add_memory(Lines& lines, const Json& report) {
  const Json& memory = report["memory"];
  lines.add("  memory {:>12.1f} MB read, {:.1f} MB written", memory["bytes_read"].get<double>() / 1e6,
            memory["bytes_written"].get<double>() / 1e6);
  for (const auto& [stream, bytes] : memory["by_stream"].items()) {
    lines.add("    {:<22} {:9.1f} MB read {:9.1f} MB written", stream, bytes["read"].get<double>() / 1e6,
              bytes["written"].get<double>() / 1e6);
  }
  if (!memory.contains("dram")) return;
  const Json &dram = memory["dram"], &latency = dram["read_latency_cycles"];
  const double columns =
      dram["row_hits"].get<double>() + dram["row_misses"].get<double>() + dram["row_conflicts"].get<double>();
  lines.add(
      "    {}: {:.1f} GB/s (bytes over the pins / time) of {:.1f}, {:.1f}% row hits; read latency {} / {} / {} "
      "cycles (50, 90, 99 %)",
      report["config"]["memory"].get<std::string>(), dram["gbps"].get<double>(), dram["peak_gbps"].get<double>(),
      100 * dram["row_hits"].get<double>() / std::max(1.0, columns), latency["p50"].get<int64_t>(),
      latency["p90"].get<int64_t>(), latency["p99"].get<int64_t>());
}

// What was compared with the golden model. A machine without taps shows no streams.
std::string compared(const Json& report) {
  if (!report["ran"]["rtl"].get<bool>()) return "RTL not run, nothing compared";
  const std::string streams = report["config"]["taps"] == 0 ? "every pixel compared, no stream (taps=0)"
                                                            : fmt::format("{} beats and every pixel compared",
                                                                          report["beats_compared"].get<uint64_t>());
  return fmt::format("{}: {} mismatches", streams, report["mismatches"].get<uint64_t>());
}

}  // namespace

std::string report_text(const Json& report) {
  Lines lines;
  const bool rtl = report["ran"]["rtl"], truth = report["ran"]["truth"];
  const auto decibel = [&](const char* key) {
    return report[key].is_null() ? std::string("equal") : fmt::format("{:.2f} dB", report[key].get<double>());
  };
  const auto seconds = [&](const char* key) {
    const Json& wall = report["wall_seconds"][key];
    return wall.is_null() ? std::string("not run") : fmt::format("{:.1f} s", wall.get<double>());
  };
  lines.add("{}: {} Gaussians, SH degree {}; view {} ({}x{})", report["scene"]["name"].get<std::string>(),
            report["scene"]["gaussians"].get<uint64_t>(), report["scene"]["sh_degree"].get<int>(),
            report["camera"]["name"].get<std::string>(), report["camera"]["width"].get<int>(),
            report["camera"]["height"].get<int>());
  lines.add("");
  if (rtl) add_units(lines, report);
  if (rtl) add_cycles(lines, report);
  if (rtl) add_memory(lines, report);
  const Json& work = report["work"];
  lines.add("  work   fetched {}, visible {}, records {}, regions {} ({} still open), blended {}{}",
            work["fetched"].get<uint64_t>(), work["visible"].get<uint64_t>(), work["records"].get<uint64_t>(),
            work["regions"].get<uint64_t>(), work["open_regions"].get<uint64_t>(), work["blended"].get<uint64_t>(),
            rtl ? fmt::format(", overflow lines {}", work["overflow_lines"].get<uint64_t>()) : "");
  if (truth) {
    lines.add("  error  numeric {}, order {}, total {}; largest {:.4f}", decibel("psnr_numeric_db"),
              decibel("psnr_order_db"), decibel("psnr_total_db"), report["max_abs_error"].get<double>());
  } else {
    lines.add("  error  truth not run, no PSNR");
  }
  lines.add("  wall   truth {}, golden {}, RTL {}{}", seconds("truth"), seconds("golden"), seconds("rtl"),
            report["rtl_khz"].is_null() ? "" : fmt::format(" ({:.0f} kHz)", report["rtl_khz"].get<double>()));
  lines.add("  {}", compared(report));
  return lines.text;
}

}  // namespace pipegs
