// SPDX-License-Identifier: Apache-2.0
// sweep.cpp: `pipegs sweep`: cycles of a frame by design point and memory bandwidth.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cpp_model/float/parallel.hpp"
#include "sim/command/command.hpp"
#include "sim/command/page/page_argument.hpp"
#include "sim/timing/cycle_engine.hpp"
#include "sim/progress.hpp"
#include "sim/rtl/rtl_fault.hpp"

namespace pipegs {
namespace {

constexpr double kPort = 64;    // bytes: the machine's port takes one line per cycle
constexpr double kFlat = 1.05;  // within 5 % of the highest bandwidth

struct SweepArguments {
  ViewArguments view;
  MemoryArguments memory;
  std::vector<double> bandwidths = {12.8, 25.6, 51.2, 102.4};
  std::string engine = "model", svg;
  PageArgument page;
  bool json = false;
};

struct SweepRow {
  const DesignPoint* design_point = nullptr;
  std::vector<EngineResult> results;  // by bandwidth
  std::string failure;

  // The lowest bandwidth from which on more of it saves less than 5 %.
  double knee(const std::vector<double>& bandwidths) const {
    size_t first = bandwidths.size() - 1;
    while (first > 0 &&
           static_cast<double>(results[first - 1].cycles) <= kFlat * static_cast<double>(results.back().cycles))
      --first;
    return bandwidths[first];
  }
};

nlohmann::ordered_json to_json(const std::vector<SweepRow>& rows, const std::vector<double>& bandwidths, bool rtl) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const SweepRow& row : rows) {
    nlohmann::ordered_json json = {{"name", row.design_point->name}};
    if (!row.failure.empty()) {
      json["failure"] = row.failure;
      list.push_back(json);
      continue;
    }
    for (const EngineResult& result : row.results) {
      json["cycles"].push_back(result.cycles);
      json["bytes"].push_back(result.bytes);
      if (rtl) json["mismatches"].push_back(result.mismatches);
    }
    if (!rtl) json["mismatches"] = nullptr;  // nothing compared
    json["memory_bound_below_bytes_per_cycle"] = row.knee(bandwidths);
    list.push_back(json);
  }
  return list;
}

Table to_table(const std::vector<SweepRow>& rows, const std::vector<double>& bandwidths) {
  Table table;
  table.columns.push_back({.key = "design", .heading = "cycles at B/cycle", .word = true});
  for (const double bandwidth : bandwidths)
    table.columns.push_back({.key = fmt::format("cycles_{:g}", bandwidth), .heading = fmt::format("{:g}", bandwidth)});
  table.columns.push_back({.key = "knee", .heading = "not memory-bound from", .unit = "B/cycle"});
  table.columns.push_back({.key = "megabytes", .unit = "MB", .digits = 1});
  table.columns.push_back({.key = "remark", .word = true});
  for (const SweepRow& row : rows) {
    if (!row.failure.empty()) {
      table.notes.push_back(fmt::format("{}: not run: {}", row.design_point->name, row.failure));
      continue;
    }
    std::vector<TableCell>& cells = table.rows.emplace_back();
    cells.push_back(text_cell(std::string(row.design_point->name)));
    for (const EngineResult& result : row.results) cells.push_back(number_cell(static_cast<double>(result.cycles)));
    const double knee = row.knee(bandwidths);
    cells.push_back({.text = fmt::format("{:g}", knee), .value = knee});
    cells.push_back(number_cell(static_cast<double>(row.results.back().bytes) / 1e6));
    cells.push_back(text_cell(knee == bandwidths.back() && knee < kPort ? "(the highest: maybe more)" : ""));
  }
  if (bandwidths.back() > kPort)
    table.notes.push_back(
        fmt::format("the machine's port takes one line per cycle: beyond {:g} B/cycle the memory waits for it", kPort));
  return table;
}

Chart chart(const std::vector<SweepRow>& rows, const std::vector<double>& bandwidths) {
  Chart chart{.form = Chart::Form::kLines,
              .title = "Cycles of a frame by memory bandwidth",
              .x_label = "bytes per cycle (GB/s at 1 GHz)",
              .y_label = "cycles",
              .x = bandwidths,
              .log_x = true,
              .log_y = true};
  for (const SweepRow& row : rows) {
    if (!row.failure.empty()) continue;
    Series series{.name = std::string(row.design_point->name)};
    for (const EngineResult& result : row.results) series.values.push_back(static_cast<double>(result.cycles));
    chart.series.push_back(series);
  }
  return chart;
}

// The same kind of memory with another bandwidth: LPDDR5 by its channels, the ideal one at will.
void set_bandwidth(ExternalMemoryOptions& memory, double bandwidth) {
  memory.bytes_per_cycle = bandwidth;
  if (memory.dram == "ideal") return;
  for (const int channels : {1, 2, 4, 8}) {
    if (bandwidth != 12.8 * channels) continue;
    memory.dram = fmt::format("lpddr5-6400x{}", channels);
    return;
  }
  throw ConfigError(fmt::format(
      "--bandwidth: found {}, expected 12.8, 25.6, 51.2 or 102.4 (LPDDR5 channels) unless --memory ideal", bandwidth));
}

int sweep(SweepArguments arguments) {
  std::vector<double>& bandwidths = arguments.bandwidths;
  for (const double bandwidth : bandwidths) {
    ExternalMemoryOptions memory = arguments.memory.external;
    set_bandwidth(memory, bandwidth);  // throws when this kind of memory has no such bandwidth
  }
  std::sort(bandwidths.begin(), bandwidths.end());
  bandwidths.erase(std::unique(bandwidths.begin(), bandwidths.end()), bandwidths.end());
  const std::vector<const DesignPoint*> chosen = find_design_points(arguments.view.design_points);
  std::vector<SimulateOptions> options = arguments.view.options(chosen);
  std::vector<SweepRow> rows;
  for (size_t i = 0; i < chosen.size(); ++i) {
    rows.push_back({.design_point = chosen[i]});
    arguments.memory.apply(options[i]);
  }
  try_file("--svg", arguments.svg);
  arguments.page.check();
  const LoadedView loaded = load_view(arguments.view);
  for (SimulateOptions& one : options) follow_scene(loaded.scene, one);
  const bool rtl = arguments.engine == "rtl";
  if (rtl) check_picture_memory(loaded.camera, options.front(), kGoldenPixels + kRtlPixels);
  const CycleEngine engine = (rtl ? rtl_engine : model_engine)(loaded.scene, loaded.camera, options.front());

  bool differs = false;
  size_t done = 0;
  for (size_t i = 0; i < rows.size(); ++i) {
    try {
      std::vector<EngineResult> results(bandwidths.size());
      parallel_for(bandwidths.size(), rtl ? 1 : 0, [&](size_t k) {
        if (rtl && !arguments.json)
          fmt::print(stderr, "{} at {:g} B/cycle\n", rows[i].design_point->name, bandwidths[k]);
        ExternalMemoryOptions memory = options[i].memory;
        set_bandwidth(memory, bandwidths[k]);
        results[k] = engine(options[i].config, memory);
      });
      for (const EngineResult& result : results) differs = differs || result.mismatches > 0;
      rows[i].results = std::move(results);
      ++done;
    } catch (const RtlBuildError& error) { rows[i].failure = error.what(); } catch (const RtlFault& error) {
      rows[i].failure = error.what();
      differs = true;
    }
  }
  const std::string head = fmt::format("{}: view {} ({}x{}); {}, memory {}", loaded.scene.name, loaded.camera.name,
                                       loaded.camera.width, loaded.camera.height, rtl ? "RTL" : "timing model",
                                       arguments.memory.external.dram == "ideal" ? "ideal" : "LPDDR5-6400");
  if (done > 0) {
    write_charts(arguments.svg, {chart(rows, bandwidths)});
    NamedMachines machines;
    for (size_t i = 0; i < rows.size(); ++i) machines.emplace_back(rows[i].design_point->name, options[i].config);
    arguments.page.write({.title = "Cycles by memory bandwidth",
                          .head = head,
                          .charts = {chart(rows, bandwidths)},
                          .tables = {to_table(rows, bandwidths)},
                          .machines = machines});
  }
  if (arguments.json) {
    fmt::print("{}\n",
               nlohmann::ordered_json{{"scene", loaded.scene.name},
                                      {"camera", loaded.camera.name},
                                      {"engine", arguments.engine},
                                      {"memory", arguments.memory.external.dram == "ideal" ? "ideal" : "lpddr5-6400"},
                                      {"bytes_per_cycle", bandwidths},
                                      {"designs", to_json(rows, bandwidths, rtl)}}
                   .dump(2));
  } else {
    fmt::print("{}\n\n{}", head, table_text(to_table(rows, bandwidths)));
  }
  if (differs) return kExitDiffers;
  return done == rows.size() ? kExitOk : kExitOwnFailure;
}

}  // namespace

void add_sweep(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("sweep", "cycles of a view by design point and memory bandwidth");
  command->footer(footer(
      "pipegs sweep garden.ply --cameras cameras.json --bandwidth 12.8,25.6,51.2 --designs dop,late --svg sweep.svg",
      "counted (--engine rtl: and every bit agrees)", "--engine rtl: a bit differs or the RTL stops",
      "A design point is not memory-bound from the bandwidth on beyond which more of it saves less than 5 % of the "
      "cycles."));
  static SweepArguments arguments;
  arguments.view.add(*command, DesignPoints::kSeveral);
  arguments.memory.add(*command, false);
  add_reals(*command, "--bandwidth", arguments.bandwidths, "bytes per cycle, by commas", {.low = 0.1, .high = 1024})
      ->capture_default_str();
  command
      ->add_option("--engine", arguments.engine,
                   "who counts the cycles: model (the timing model), or rtl (with all comparisons)")
      ->check(CLI::IsMember({"model", "rtl"}))
      ->capture_default_str();
  command->add_option("--svg", arguments.svg, "chart");
  arguments.page.add(*command);
  command->add_flag("--json", arguments.json, "as JSON");
  command->callback([&run] { run = [] { return sweep(arguments); }; });
}

}  // namespace pipegs
