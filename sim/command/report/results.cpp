// SPDX-License-Identifier: Apache-2.0
// results.cpp: see results.hpp.
#include "sim/command/report/results.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "scenes/input_error.hpp"
#include "scenes/text/csv.hpp"
#include "scenes/text/json.hpp"
#include "scenes/text/json_node.hpp"
#include "scenes/text/text_file.hpp"
#include "sim/command/campaign/merge.hpp"
#include "sim/design/design_point.hpp"

namespace pipegs {
namespace {

namespace fs = std::filesystem;

constexpr int kMostBelow = 12;  // folders inside each other
constexpr uint64_t kMostCount = uint64_t{1} << 53;
constexpr uint64_t kMostSide = 1 << 20;
constexpr size_t kMostElements = 100000;

uint64_t count_of(const JsonNode& node) { return node.integer(0, kMostCount); }

// What was not run is null, or not there.
std::optional<uint64_t> count_if_there(const JsonNode& node, const char* key) {
  if (!node.has(key) || node[key].is_null()) return std::nullopt;
  return count_of(node[key]);
}
std::optional<double> real_if_there(const JsonNode& node, const char* key) {
  if (!node.has(key) || node[key].is_null()) return std::nullopt;
  return node[key].real();
}

JsonNode read_node(const fs::path& file) {
  return JsonNode::parse(file.string(), read_text_file(file, "a JSON file", kMostJsonBytes));
}

size_t elements(const JsonNode& list) {
  if (list.size() > kMostElements) list.refuse(fmt::format("at most {} elements", kMostElements));
  return list.size();
}

Config config_of(const JsonNode& node) {
  Config config;
  for (const ConfigEntry& entry : config_entries(config)) {
    const std::string name(entry.name);
    if (entry.member == nullptr || !node.has(name.c_str())) continue;
    config.*entry.member = static_cast<int>(
        node[name.c_str()].integer(static_cast<uint64_t>(entry.low), static_cast<uint64_t>(entry.high)));
  }
  return config;
}

std::optional<Rgb8> picture_of(const fs::path& file, FolderResults& results) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return std::nullopt;
  try {
    return read_png8(file);
  } catch (const std::runtime_error& wrong) {
    results.left_out.push_back({file.string(), one_line(wrong.what())});
    return std::nullopt;
  }
}

void read_units(const JsonNode& report, FrameResult& result) {
  if (!report.has("units") || report["units"].is_null()) return;
  for (const std::string& kind : report["units"].keys()) {
    const JsonNode units = report["units"][kind.c_str()];
    UnitShares shares{.kind = kind};
    for (size_t i = 0; i < elements(units); ++i) {
      constexpr const char* kStates[] = {"busy", "starved", "blocked", "memory"};
      for (size_t k = 0; k < 4; ++k) shares.cycles[k] += static_cast<double>(count_of(units[i][kStates[k]]));
    }
    result.units.push_back(shares);
  }
}

void read_memory(const JsonNode& report, FrameResult& result) {
  if (!report.has("memory") || report["memory"].is_null()) return;
  const JsonNode memory = report["memory"];
  if (memory.keys().empty()) return;
  result.bytes_read = count_if_there(memory, "bytes_read");
  result.bytes_written = count_if_there(memory, "bytes_written");
  if (!memory.has("by_stream") || memory["by_stream"].is_null()) return;
  const JsonNode streams = memory["by_stream"];
  for (const std::string& name : streams.keys()) {
    const JsonNode stream = streams[name.c_str()];
    result.streams.emplace_back(name, static_cast<double>(count_of(stream["read"]) + count_of(stream["written"])));
  }
}

void add_frame(const fs::path& file, const std::string& name, FolderResults& results) {
  const JsonNode report = read_node(file);
  FrameResult result{.name = name};
  result.scene = report["scene"]["name"].text();
  result.gaussians = count_of(report["scene"]["gaussians"]);
  const JsonNode camera = report["camera"];
  result.camera = camera["name"].text();
  result.width = camera["width"].integer(1, kMostSide), result.height = camera["height"].integer(1, kMostSide);
  const Config config = config_of(report["config"]);
  result.machine = machine_name(config), result.settings = machine_words(config);
  result.memory = report["config"]["memory"].text();
  result.cycles = count_if_there(report, "cycles");
  result.mismatches = count_if_there(report, "mismatches");
  result.numeric_db = real_if_there(report, "psnr_numeric_db");
  result.order_db = real_if_there(report, "psnr_order_db");
  result.total_db = real_if_there(report, "psnr_total_db");
  read_units(report, result);
  read_memory(report, result);
  result.picture = picture_of(file.parent_path() / "frame.png", results);
  results.frames.push_back(std::move(result));
}

std::string text_of(const JsonNode& node, const char* key) { return node.has(key) ? node[key].text() : ""; }

WalkResult read_sequence(const fs::path& file) {
  const JsonNode sequence = read_node(file);
  WalkResult result{.scene = sequence["scene"].text(),
                    .configuration = text_of(sequence, "configuration"),
                    .memory = text_of(sequence, "memory")};
  const JsonNode views = sequence["views"];
  for (size_t i = 0; i < elements(views); ++i) {
    const JsonNode view = views[i];
    result.frames.push_back({.view = fmt::format("{:.8g}", view["view"].real()),
                             .camera = view["camera"].text(),
                             .cycles = count_of(view["cycles_alone"]),
                             .bytes_read = count_of(view["bytes_read"]),
                             .bytes_written = count_of(view["bytes_written"]),
                             .queued = count_if_there(view, "cycles_queued"),
                             .mismatches = count_if_there(view, "mismatches"),
                             .us = real_if_there(view, "us"),
                             .chip_uj = real_if_there(view, "chip_uj"),
                             .dram_uj = real_if_there(view, "dram_uj")});
  }
  if (result.frames.empty()) views.refuse("at least one frame");
  return result;
}

WalkResult read_frames_table(const fs::path& file) {
  constexpr const char* kHeader =
      "frame,view,camera,width,height,cycles,cycles_queued,mismatches,bytes_read,bytes_written,us,chip_uj,dram_uj";
  WalkResult result;
  const auto real = [](const CsvRow& row, const char* name) {
    return row.text(name).empty() ? std::nullopt : std::optional(row.real(name));
  };
  const auto count = [](const CsvRow& row, const char* name) {
    return row.text(name).empty() ? std::nullopt : std::optional(row.integer<uint64_t>(name, 0, kMostCount));
  };
  read_csv(file, kHeader, [&](const CsvRow& row) {
    result.frames.push_back({.view = row.text("view"),
                             .camera = row.text("camera"),
                             .cycles = row.integer<uint64_t>("cycles", 0, kMostCount),
                             .bytes_read = row.integer<uint64_t>("bytes_read", 0, kMostCount),
                             .bytes_written = row.integer<uint64_t>("bytes_written", 0, kMostCount),
                             .queued = count(row, "cycles_queued"),
                             .mismatches = count(row, "mismatches"),
                             .us = real(row, "us"),
                             .chip_uj = real(row, "chip_uj"),
                             .dram_uj = real(row, "dram_uj")});
  });
  if (result.frames.empty()) throw InputError(file.string(), "", "found no frame, expected at least one");
  return result;
}

void add_walk(const fs::path& file, const std::string& name, FolderResults& results) {
  WalkResult result = file.extension() == ".csv" ? read_frames_table(file) : read_sequence(file);
  result.name = name;
  result.picture = picture_of(file.parent_path() / "frame_0000.png", results);
  results.walks.push_back(std::move(result));
}

void add_campaign(const fs::path& file, const std::string& name, FolderResults& results) {
  CampaignResult result{
      .name = name,
      .columns = {"scene", "view", "camera", "configuration", "design", "window_x", "window_y", "windows"}};
  for (const FigureColumn& column : point_figures()) result.columns.emplace_back(column.name);
  read_csv(file, fmt::format("{}", fmt::join(result.columns, ",")), [&](const CsvRow& row) {
    std::vector<std::string>& texts = result.rows.emplace_back();
    for (const std::string& column : result.columns) texts.push_back(row.text(column));
  });
  if (result.rows.empty()) throw InputError(file.string(), "", "found no point, expected at least one");
  results.campaigns.push_back(std::move(result));
}

TrainedBy trained_by(const std::string& who, const JsonNode& node) {
  return {.who = who,
          .psnr = real_if_there(node, "psnr_db"),
          .ssim = real_if_there(node, "ssim"),
          .cycles = count_if_there(node, "cycles")};
}

void add_trained(const fs::path& file, const std::string& name, FolderResults& results) {
  const JsonNode train = read_node(file);
  TrainResult result{.name = name,
                     .input = train["input"].text(),
                     .steps = count_of(train["steps"]),
                     .gaussians = count_of(train["gaussians"]),
                     .minutes = train["minutes"].real()};
  const JsonNode held_out = train["held_out"];
  result.held_out = {trained_by("exact order", held_out["exact"]), trained_by("layers", held_out["layered"])};
  if (held_out.has("machines")) {
    for (const std::string& machine : held_out["machines"].keys())
      result.held_out.push_back(trained_by(machine, held_out["machines"][machine.c_str()]));
  }
  results.trained.push_back(std::move(result));
}

using Add = void (*)(const fs::path&, const std::string&, FolderResults&);

// Whether the file was what its name says.
bool add(Add add_file, const fs::path& file, const std::string& name, FolderResults& results) {
  try {
    add_file(file, name, results);
    return true;
  } catch (const std::bad_alloc&) { throw; } catch (const std::runtime_error& wrong) {
    std::string reason = one_line(wrong.what());
    const std::string prefix = file.string() + ": ";
    if (reason.starts_with(prefix)) reason.erase(0, prefix.size());
    results.left_out.push_back({file.string(), reason});
    return false;
  }
}

}  // namespace

FolderResults read_results(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw InputError(folder.string(), "",
                     fs::exists(folder, error) ? "found a file, expected a folder of results"
                                               : "found no folder, expected one of results");
  std::vector<fs::path> files;
  for (fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error), end;
       !error && at != end; at.increment(error)) {
    if (at.depth() >= kMostBelow) at.disable_recursion_pending();
    std::error_code unknown;
    if (at->is_regular_file(unknown) && !at->is_symlink(unknown)) files.push_back(at->path());
  }
  std::sort(files.begin(), files.end());
  FolderResults results;
  for (const fs::path& file : files) {
    const fs::path below = fs::relative(file.parent_path(), folder);
    const std::string name = valid_utf8((below == "." ? fs::canonical(folder).filename() : below).generic_string());
    const std::string own = file.filename().string();
    if (own == "report.json") add(add_frame, file, name, results);
    if (own == "results.csv") add(add_campaign, file, name, results);
    if (own == "train.json") add(add_trained, file, name, results);
    // The same frames once: from the table only where the JSON is not to be had.
    if (own == "frames.csv") {
      const fs::path sequence = file.parent_path() / "sequence.json";
      if (!fs::exists(sequence, error) || !add(add_walk, sequence, name, results)) add(add_walk, file, name, results);
    } else if (own == "sequence.json" && !fs::exists(file.parent_path() / "frames.csv", error)) {
      add(add_walk, file, name, results);
    }
  }
  return results;
}

}  // namespace pipegs
