// SPDX-License-Identifier: Apache-2.0
// results.cpp: see results.hpp.
#include "sim/command/report/results.hpp"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "scenes/input_error.hpp"
#include "scenes/text/json.hpp"
#include "scenes/text/json_node.hpp"
#include "scenes/text/text_file.hpp"
#include "sim/design/design_point.hpp"
#include "sim/photos/photograph.hpp"

namespace pipegs {
namespace {

namespace fs = std::filesystem;

constexpr int kMostBelow = 12;  // folders inside each other
constexpr uint64_t kMostCount = uint64_t{1} << 53, kMostSide = 1 << 20;
constexpr size_t kMostElements = 100000;
constexpr size_t kMostBars = 16;  // more results are a line

// A column, and where its figure lies in a file.
struct Field {
  enum Form { kWord, kSize, kCount, kRate, kReal };
  const char* heading;
  Form form;
  std::vector<const char*> place;
  int digits = 0;
  double unit = 1;
  bool must = false;  // what was not run is null, or not there
};
constexpr double kMega = 1e-6;

const std::vector<Field> kFrameFields = {{"scene", Field::kWord, {"scene", "name"}, 0, 1, true},
                                         {"camera", Field::kWord, {"camera", "name"}, 0, 1, true},
                                         {"pixels", Field::kSize, {"camera"}, 0, 1, true},
                                         {"memory", Field::kWord, {"config", "memory"}, 0, 1, true},
                                         {"Gaussians", Field::kCount, {"scene", "gaussians"}, 0, 1, true},
                                         {"cycles", Field::kCount, {"cycles"}},
                                         {"frames/s at 1 GHz", Field::kRate, {"cycles"}, 1},
                                         {"MB read", Field::kCount, {"memory", "bytes_read"}, 2, kMega},
                                         {"MB written", Field::kCount, {"memory", "bytes_written"}, 2, kMega},
                                         {"numeric dB", Field::kReal, {"psnr_numeric_db"}, 2},
                                         {"order dB", Field::kReal, {"psnr_order_db"}, 2},
                                         {"total dB", Field::kReal, {"psnr_total_db"}, 2},
                                         {"photograph dB", Field::kReal, {"psnr_db"}, 2},
                                         {"SSIM", Field::kReal, {"ssim"}, 4},
                                         {"mismatches", Field::kCount, {"mismatches"}}};
const std::vector<Field> kViewFields = {{"camera", Field::kWord, {"camera"}, 0, 1, true},
                                        {"view", Field::kReal, {"view"}, 2, 1, true},
                                        {"cycles", Field::kCount, {"cycles_alone"}, 0, 1, true},
                                        {"queued", Field::kCount, {"cycles_queued"}},
                                        {"mismatches", Field::kCount, {"mismatches"}},
                                        {"MB read", Field::kCount, {"bytes_read"}, 2, kMega, true},
                                        {"MB written", Field::kCount, {"bytes_written"}, 2, kMega, true},
                                        {"us", Field::kReal, {"us"}, 1},
                                        {"chip uJ", Field::kReal, {"chip_uj"}, 1},
                                        {"DRAM uJ", Field::kReal, {"dram_uj"}, 1},
                                        {"photograph dB", Field::kReal, {"psnr_db"}, 2},
                                        {"SSIM", Field::kReal, {"ssim"}, 4},
                                        {"numeric dB", Field::kReal, {"psnr_numeric_db"}, 2},
                                        {"order dB", Field::kReal, {"psnr_order_db"}, 2},
                                        {"total dB", Field::kReal, {"psnr_total_db"}, 2}};
const std::vector<Field> kTrainFields = {{"input", Field::kWord, {"input"}, 0, 1, true},
                                         {"steps", Field::kCount, {"steps"}, 0, 1, true},
                                         {"Gaussians", Field::kCount, {"gaussians"}, 0, 1, true},
                                         {"minutes", Field::kReal, {"minutes"}, 1, 1, true}};
const std::vector<Field> kDrawnFields = {{"dB", Field::kReal, {"psnr_db"}, 2},
                                         {"SSIM", Field::kReal, {"ssim"}, 4},
                                         {"cycles a frame", Field::kCount, {"cycles"}}};

void add_columns(Table& table, const std::vector<Field>& fields) {
  for (const Field& field : fields) {
    const bool word = field.form == Field::kWord || field.form == Field::kSize;
    table.columns.push_back({.heading = field.heading, .digits = field.digits, .word = word});
  }
}

TableCell cell_of(JsonNode node, const Field& field) {
  for (const char* key : field.place) {
    node.keys();  // an object
    if (!field.must && (!node.has(key) || node[key].is_null()))
      return text_cell(field.form == Field::kCount && field.digits == 0 ? "not run" : "-");
    node = JsonNode(node[key]);
  }
  switch (field.form) {
    case Field::kWord: return text_cell(node.text());
    case Field::kSize:
      return text_cell(fmt::format("{}x{}", node["width"].integer(1, kMostSide), node["height"].integer(1, kMostSide)));
    case Field::kCount: return number_cell(field.unit * static_cast<double>(node.integer(0, kMostCount)));
    case Field::kRate: {
      const uint64_t cycles = node.integer(0, kMostCount);
      return cycles > 0 ? number_cell(1e9 / static_cast<double>(cycles)) : text_cell("-");
    }
    case Field::kReal: break;
  }
  return number_cell(node.real());
}

void add_cells(std::vector<TableCell>& row, const JsonNode& node, const std::vector<Field>& fields) {
  for (const Field& field : fields) row.push_back(cell_of(node, field));
}

// The column of this heading.
std::vector<double> values_of(const Table& table, std::string_view heading) {
  const auto column = std::find_if(table.columns.begin(), table.columns.end(),
                                   [&](const TableColumn& one) { return one.heading == heading; });
  std::vector<double> values;
  for (const std::vector<TableCell>& row : table.rows)
    values.push_back(row[static_cast<size_t>(column - table.columns.begin())].value.value_or(
        std::numeric_limits<double>::quiet_NaN()));
  return values;
}

void add_series(Chart& chart, const std::string& name, const Table& table, std::string_view heading) {
  std::vector<double> values = values_of(table, heading);
  if (std::any_of(values.begin(), values.end(), [](double value) { return value == value; }))
    chart.series.push_back({.name = name, .values = std::move(values)});
}

// Over all frames: bars, or lines where they are many.
Chart over_frames(const Table& frames, const char* title, const char* unit) {
  Chart chart{.form = Chart::Form::kBars, .title = title, .y_label = unit};
  for (const std::vector<TableCell>& row : frames.rows) {
    if (frames.rows.size() > kMostBars) chart.x.push_back(static_cast<double>(chart.x.size()));
    chart.categories.push_back(row[0].text);
  }
  if (!chart.x.empty()) chart.form = Chart::Form::kLines;
  return chart;
}

std::vector<Chart> charts_of(const Table& frames) {
  std::vector<Chart> charts = {over_frames(frames, "Cycles of a frame", "cycles"), over_frames(frames, "PSNR", "dB")};
  add_series(charts[0], "cycles", frames, "cycles");
  charts[1].from_zero = false;
  for (const char* error : {"numeric", "order", "total"})
    add_series(charts[1], error, frames, fmt::format("{} dB", error));
  std::erase_if(charts, [](const Chart& chart) { return chart.series.empty(); });
  return charts;
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

// InputError when the pictures have more pixels than their bytes, and a free share, are good for: a few kilobytes may
// hold as many as take seconds to unpack.
void count_pixels(const fs::path& file, FolderResults& results) {
  constexpr uint64_t kFree = uint64_t{1} << 26, kMostOfAByte = 16;
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&png, file.c_str()) == 0) return;  // read_png8 refuses it
  png_image_free(&png);
  const uint64_t pixels = uint64_t{png.width} * png.height, bytes = fs::file_size(file);
  if (results.pixels_read + pixels > kFree + kMostOfAByte * (results.bytes_read + bytes))
    throw InputError(
        fmt::format("found {}x{} pixels in {} bytes, which with the other pictures are too many for a page", png.width,
                    png.height, bytes));
  results.pixels_read += pixels;
  results.bytes_read += bytes;
}

Rgb8 thumbnail(const Rgb8& picture) {
  const int longest = FolderResults::kLongestSide,
            step = (std::max(picture.width, picture.height) + longest - 1) / longest;
  return step <= 1 ? picture : shrunk(picture, (picture.width + step - 1) / step, (picture.height + step - 1) / step);
}

// The id of the picture in the page; empty without one.
std::string add_picture(const fs::path& file, const std::string& caption, FolderResults& results) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return "";
  try {
    count_pixels(file, results);
    results.pictures.push_back(
        {caption, fmt::format("picture-{}", results.pictures.size()), thumbnail(read_png8(file))});
    return results.pictures.back().id;
  } catch (const std::runtime_error& wrong) {
    results.left_out.push_back({one_line(file.string()), one_line(wrong.what())});
    return "";
  }
}

void add_frame(const JsonNode& report, const fs::path& folder, const std::string& name, FolderResults& results) {
  std::vector<TableCell> row = {text_cell(name)};
  add_cells(row, report, kFrameFields);
  row.push_back(text_cell(machine_words(config_of(report["config"]))));
  row[0].link = add_picture(folder / "frame.png", name, results);
  results.frames.rows.push_back(std::move(row));
}

std::string text_of(const JsonNode& node, const char* key) { return node.has(key) ? node[key].text() : ""; }

void add_walk(const JsonNode& sequence, const fs::path& folder, const std::string& name, FolderResults& results) {
  Table table{.title = name};
  add_columns(table, kViewFields);
  const JsonNode views = sequence["views"];
  if (views.size() > kMostElements) views.refuse(fmt::format("at most {} elements", kMostElements));
  if (views.size() == 0) views.refuse("at least one frame");
  for (size_t i = 0; i < views.size(); ++i) add_cells(table.rows.emplace_back(), views[i], kViewFields);
  table.notes = {fmt::format("{}, memory {}", sequence["scene"].text(), text_of(sequence, "memory"))};
  if (const std::string configuration = text_of(sequence, "configuration"); !configuration.empty())
    table.notes.push_back(configuration);
  Chart chart{.form = Chart::Form::kLines,
              .title = fmt::format("{}: cycles of each frame", name),
              .x_label = "frame",
              .y_label = "cycles"};
  for (size_t i = 0; i < table.rows.size(); ++i) chart.x.push_back(static_cast<double>(i));
  add_series(chart, "alone", table, "cycles");
  add_series(chart, "queued", table, "queued");
  results.walks.emplace_back(std::move(chart), std::move(table));
  add_picture(folder / "frame_0000.png", name + ", first frame", results);
}

void add_trained(const JsonNode& train, const fs::path&, const std::string& name, FolderResults& results) {
  std::vector<TableCell> scene;
  add_cells(scene, train, kTrainFields);
  const JsonNode held_out = train["held_out"];
  std::vector<std::vector<TableCell>> rows;
  const auto drawn_by = [&](const std::string& who, const JsonNode& node) {
    std::vector<TableCell>& row = rows.emplace_back(std::vector{text_cell(name), text_cell(who)});
    row.insert(row.end(), scene.begin(), scene.end());
    add_cells(row, node, kDrawnFields);
  };
  drawn_by("exact order", held_out["exact"]);
  drawn_by("layers", held_out["layered"]);
  if (held_out.has("machines")) {
    for (const std::string& machine : held_out["machines"].keys())
      drawn_by(machine, held_out["machines"][machine.c_str()]);
  }
  results.trained.rows.insert(results.trained.rows.end(), rows.begin(), rows.end());
  ++results.trained_scenes;
}

using Add = void (*)(const JsonNode&, const fs::path&, const std::string&, FolderResults&);

void add(Add add_file, const fs::path& file, const std::string& name, FolderResults& results) {
  try {
    add_file(JsonNode::parse(file.string(), read_text_file(file, "a JSON file", kMostJsonBytes)), file.parent_path(),
             name, results);
  } catch (const std::bad_alloc&) { throw; } catch (const std::runtime_error& wrong) {
    std::string reason = one_line(wrong.what());
    const std::string prefix = one_line(file.string()) + ": ";
    if (reason.starts_with(prefix)) reason.erase(0, prefix.size());
    results.left_out.push_back({one_line(file.string()), reason});
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
  results.frames = {.title = "Frames", .columns = {{.heading = "result", .word = true}}};
  add_columns(results.frames, kFrameFields);
  results.frames.columns.push_back({.heading = "machine", .word = true, .wrapped = true, .copies = true});
  results.trained = {.columns = {{.heading = "result", .word = true}, {.heading = "held out, drawn by", .word = true}}};
  add_columns(results.trained, kTrainFields);
  add_columns(results.trained, kDrawnFields);
  for (const fs::path& file : files) {
    const fs::path below = fs::relative(file.parent_path(), folder);
    const std::string name = valid_utf8((below == "." ? fs::canonical(folder).filename() : below).generic_string());
    const std::string own = file.filename().string();
    if (own == "report.json") add(add_frame, file, name, results);
    if (own == "sequence.json") add(add_walk, file, name, results);
    if (own == "train.json") add(add_trained, file, name, results);
  }
  results.charts = charts_of(results.frames);
  return results;
}

}  // namespace pipegs
