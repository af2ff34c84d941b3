// SPDX-License-Identifier: Apache-2.0
// results.cpp: see results.hpp.
#include "sim/command/report/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "scenes/input_error.hpp"
#include "scenes/text/json.hpp"
#include "scenes/text/json_node.hpp"
#include "scenes/text/text_file.hpp"
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

void read_memory(const JsonNode& report, FrameResult& result) {
  if (!report.has("memory") || report["memory"].is_null()) return;
  const JsonNode memory = report["memory"];
  if (memory.keys().empty()) return;
  result.bytes_read = count_if_there(memory, "bytes_read");
  result.bytes_written = count_if_there(memory, "bytes_written");
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

void add_walk(const fs::path& file, const std::string& name, FolderResults& results) {
  WalkResult result = read_sequence(file);
  result.name = name;
  result.picture = picture_of(file.parent_path() / "frame_0000.png", results);
  results.walks.push_back(std::move(result));
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

void add(Add add_file, const fs::path& file, const std::string& name, FolderResults& results) {
  try {
    add_file(file, name, results);
  } catch (const std::bad_alloc&) { throw; } catch (const std::runtime_error& wrong) {
    std::string reason = one_line(wrong.what());
    const std::string prefix = file.string() + ": ";
    if (reason.starts_with(prefix)) reason.erase(0, prefix.size());
    results.left_out.push_back({file.string(), reason});
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
    if (own == "sequence.json") add(add_walk, file, name, results);
    if (own == "train.json") add(add_trained, file, name, results);
  }
  return results;
}

}  // namespace pipegs
