// silicon.cpp: `pipegs silicon`: area and clock in 28 nm unit by unit, beside the paper's Table 2 and GSCore's, and frames per mm2.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "sim/command/command.hpp"
#include "sim/cycle_engine.hpp"
#include "sim/silicon/published.hpp"
#include "sim/silicon/silicon.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

struct Arguments {
  ViewArguments view;
  MemoryArguments memory;
  std::vector<std::string> rungs;
  std::string library = "osu018", folder = PIPEGS_BUILD_DIR "/synth", svg;
  bool json = false;
};

struct SiliconRung {
  std::string name;
  Config config;
  Synth synth;
  std::vector<SiliconRow> rows;
  uint64_t cycles = 0;  // of the view

  const SiliconRow& total() const { return rows.back(); }
  double fps() const { return 1e9 / static_cast<double>(cycles); }  // at 1 GHz
};

Json to_json(const Range& range) { return {{"low", range.low}, {"mid", range.mid}, {"high", range.high}}; }

Json to_json(const SiliconRung& rung) {
  Json json = {{"name", rung.name}, {"configuration", rung.synth.configuration}, {"library", rung.synth.library}, {"cycles", rung.cycles}, {"fps", rung.fps()},
               {"fps_per_mm2", rung.fps() / rung.total().area_mm2.mid}, {"rows", Json::array()}};
  for (const SiliconRow& row : rung.rows) {
    json["rows"].push_back({{"name", row.name}, {"count", row.count}, {"kilo_nand2", row.kilo_nand2}, {"kb", row.kb},
                            {"area_mm2", to_json(row.area_mm2)}, {"path_ps", to_json(row.path_ps)}});
  }
  return json;
}

std::string to_text(const Range& range, int digits) { return fmt::format("{:.{}f} ({:.{}f} to {:.{}f})", range.mid, digits, range.low, digits, range.high, digits); }

std::string to_text(const SiliconRung& rung) {
  std::string text = fmt::format("  {}, gates of {}\n  {:<9}{:>6}{:>9}{:>8}{:>25}{:>24}{:>9}\n", rung.name, rung.synth.library, "", "units", "kNAND2", "KB", "mm2 in 28 nm", "longest path, ps", "paper");
  for (const SiliconRow& row : rung.rows) {
    const auto paper = std::find_if(kPipegsTable2.begin(), kPipegsTable2.end(), [&](const PublishedRow& p) { return p.unit == row.name; });
    text += fmt::format("  {:<9}{:>6}{:>9}{:>8}{:>25}{:>24}{:>9}\n", row.name, row.count > 0 ? std::to_string(row.count) : "",
                        row.kilo_nand2 > 0 ? fmt::format("{:.0f}", row.kilo_nand2) : "", row.kb > 0 ? fmt::format("{:.0f}", row.kb) : "",
                        to_text(row.area_mm2, 3), row.path_ps.mid > 0 ? to_text(row.path_ps, 0) : "",
                        paper == kPipegsTable2.end() ? "" : fmt::format("{:.3f}", paper->area_mm2));
  }
  return text + fmt::format("  {} cycles: {:.0f} frames/s at 1 GHz, {:.0f} frames/s for each mm2\n\n", rung.cycles, rung.fps(), rung.fps() / rung.total().area_mm2.mid);
}

Chart chart(const std::vector<SiliconRung>& rungs) {
  Chart chart{.form = Chart::Form::kStacked, .title = "Area in 28 nm", .y_label = "mm2"};
  for (size_t row = 0; row + 1 < rungs.front().rows.size(); ++row) {
    Series series{.name = rungs.front().rows[row].name, .values = {}};
    for (const SiliconRung& rung : rungs) series.values.push_back(rung.rows[row].area_mm2.mid);
    const auto paper = std::find_if(kPipegsTable2.begin(), kPipegsTable2.end(), [&](const PublishedRow& p) { return p.unit == series.name; });
    series.values.push_back(paper == kPipegsTable2.end() ? 0 : paper->area_mm2);
    chart.series.push_back(series);
  }
  for (const SiliconRung& rung : rungs) chart.categories.push_back(rung.name);
  chart.categories.push_back("paper");
  chart.note = "mid of the ranges";
  return chart;
}

int silicon(const Arguments& arguments) {
  std::vector<SimulateOptions> options;
  if (arguments.rungs.empty()) {
    options.push_back(arguments.view.options());
  } else {
    for (const Rung* rung : find_rungs(arguments.rungs)) options.push_back(arguments.view.options(*rung));
  }
  const SramLaw law(PIPEGS_SOURCE_DIR "/synth/sram.csv");
  std::vector<SiliconRung> rungs;
  for (const SimulateOptions& one : options) {
    const std::string name = config_difference(one.config), rung = rung_name(one.config);
    const Synth synth = read_synth(std::filesystem::path(arguments.folder) / name / arguments.library / "synth.json", one.config);
    rungs.push_back({rung.empty() ? name : rung, one.config, synth, silicon_rows(one.config, synth, law)});
  }
  const LoadedView loaded = load_view(arguments.view);
  for (size_t i = 0; i < rungs.size(); ++i) {
    arguments.memory.apply(options[i]);
    rungs[i].cycles = model_engine(loaded.scene, loaded.camera, options[i])(options[i].config, options[i].memory).cycles;
  }
  write_charts(arguments.svg, {chart(rungs)});
  if (arguments.json) {
    Json json = {{"scene", loaded.scene.name}, {"camera", loaded.camera.name}, {"rungs", Json::array()}};
    for (const SiliconRung& rung : rungs) json["rungs"].push_back(to_json(rung));
    fmt::print("{}\n", json.dump(2));
    return kExitOk;
  }
  fmt::print("{}: view {} ({}x{}), memory {}\n\n", loaded.scene.name, loaded.camera.name, loaded.camera.width, loaded.camera.height, arguments.memory.external.dram);
  for (const SiliconRung& rung : rungs) fmt::print("{}", to_text(rung));
  fmt::print("  GSCore, as published:");
  for (const PublishedRow& row : kGscore) fmt::print(" {} {:.2f}{}", row.unit, row.area_mm2, &row == &kGscore.back() ? " mm2\n" : ",");
  return kExitOk;
}

}  // namespace

void add_silicon(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("silicon", "area and clock in 28 nm, beside the paper's Table 2; frames per mm2 of a view");
  command->footer("Example: pipegs silicon garden.ply --cameras cameras.json --rungs dop,exact --svg silicon.svg\n"
                  "Needs what `make synth` writes for each configuration. Ranges are what 28 nm may be: docs/silicon.md.");
  static Arguments arguments;
  arguments.view.add(*command);
  arguments.memory.add(*command);
  command->add_option("--rungs", arguments.rungs, "which, by commas, instead of --rung: baseline, dpc, tspp, dop, late, exact")->delimiter(',');
  command->add_option("--library", arguments.library, "library whose gates were counted")->capture_default_str();
  command->add_option("--synth", arguments.folder, "folder that `make synth` has written to");
  command->add_option("--svg", arguments.svg, "chart");
  command->add_flag("--json", arguments.json, "as JSON");
  command->callback([&run] { run = [] { return silicon(arguments); }; });
}

}  // namespace pipegs
