// SPDX-License-Identifier: Apache-2.0
// frame_model.cpp: see frame_model.hpp.
#include "sim/silicon/frame_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "scenes/input_error.hpp"
#include "scenes/text/csv.hpp"
#include "sim/silicon/area/machine_kind.hpp"

namespace pipegs {
namespace {

constexpr const char* kHeader = "scene,configuration,cycles,row,kilo_nand2,frame_uj";
constexpr const char* kRows[] = {"DOPU", "PU", "SU", "RU", "Other"};

std::string row_of(const std::string& unit) {
  static const std::map<std::string, std::string> kRow = {{"dopu", "DOPU"}, {"pu", "PU"}, {"su", "SU"}, {"ru", "RU"}};
  return kRow.contains(unit) ? kRow.at(unit) : "Other";
}

// What one read of every SRAM takes: how an access grows with the configuration.
Range read_of_each(const Config& config, const SramLaw& law) { return sram_sum(config, law, &SramFigures::read_pj); }

// But for its pace, by which the gates of its PUs differ more than what each takes.
bool same_design_point(const Config& a, const Config& b) {
  Config other = b;
  other.pace = a.pace;
  return kind_of(a) == kind_of(other);
}

}  // namespace

std::vector<MeasuredFrame> read_frames(const std::filesystem::path& csv) {
  std::vector<MeasuredFrame> frames;
  std::set<std::string> names;
  std::string name;
  read_csv(csv, kHeader, [&](const CsvRow& row) {
    const std::string frame = row.text("scene") + "," + row.text("configuration");
    const auto cycles = row.integer<uint64_t>("cycles", 1);
    if (frame != name) {
      name = frame;
      if (!names.insert(name).second) row.fail("scene", "found " + quote(name) + " again, expected its rows once");
      frames.push_back({row.text("scene"), config_of(row.text("configuration")), cycles, {}, {}});
    }
    MeasuredFrame& last = frames.back();
    if (cycles != last.cycles) row.fail("cycles", "found other cycles than in the frame's first row");
    const std::string& part = row.text("row");
    if (!last.joules.try_emplace(part, row.real("frame_uj", kNotNegative) * 1e-6).second)
      row.fail("row", "found a second " + quote(part) + ", expected one");
    if (part == "Buffers") row.real("kilo_nand2", kNotNegative);
    else last.kilo_nand2[part] = row.real("kilo_nand2", kPositive);
  });
  for (const MeasuredFrame& frame : frames) {
    bool whole = frame.joules.size() == 6 && frame.joules.contains("Buffers");
    for (const char* row : kRows) whole = whole && frame.kilo_nand2.contains(row);
    if (!whole) throw InputError(csv.string(), frame.scene, "expected the rows DOPU, PU, SU, RU, Other, Buffers");
  }
  return frames;
}

std::string interpolated_text(double value, bool extrapolated, int digits) {
  return fmt::format("{}{:.{}f}", extrapolated ? "~" : "", value, digits);
}

FrameModel::FrameModel(AreaModel area, PathModel paths, SramLaw law, std::vector<MeasuredFrame> frames)
    : area_(std::move(area)), paths_(std::move(paths)), law_(std::move(law)), frames_(std::move(frames)) {}

FrameModel FrameModel::without(size_t frame) const {
  std::vector<MeasuredFrame> rest = frames_;
  rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(frame));
  return {area_, paths_, law_, rest};
}

bool FrameModel::measured(const Config& config) const {
  return std::any_of(frames_.begin(), frames_.end(),
                     [&](const MeasuredFrame& frame) { return same_design_point(frame.config, config); });
}

double FrameModel::rate(const std::string& row, const Config& config) const {
  const bool known = measured(config);
  double sum = 0;
  int count = 0;
  for (const MeasuredFrame& frame : frames_) {
    if (known && !same_design_point(frame.config, config)) continue;
    const double size = row == "Buffers" ? read_of_each(frame.config, law_).mid : frame.kilo_nand2.at(row);
    sum += frame.joules.at(row) / (size * static_cast<double>(frame.cycles));
    ++count;
  }
  return count == 0 ? 0 : sum / count;
}

Range FrameModel::dynamic(const Config& config, const std::map<std::string, double>& kilo_nand2,
                          uint64_t cycles) const {
  const auto clocked = static_cast<double>(cycles);
  double gates = 0;
  for (const auto& [row, kilo] : kilo_nand2) gates += rate(row, config) * kilo * clocked;
  return kNand2InputFf * (gates / kNand2InputFf.mid) + read_of_each(config, law_) * (rate("Buffers", config) * clocked);
}

std::optional<FrameCost> FrameModel::cost(const Config& config, uint64_t cycles, uint64_t bytes) const {
  if (!area_.knows(config)) return std::nullopt;
  const std::map<std::string, double> nand2 = area_.nand2(config);
  std::map<std::string, double> kilo_nand2;
  for (const auto& [unit, gates] : nand2) kilo_nand2[row_of(unit)] += gates / 1000;
  const double all = sum(nand2);
  FrameCost cost;
  cost.mm2 = kNand2Um2 * (all * 1e-6) + sram_sum(config, law_, &SramFigures::area_mm2);
  const Range leakage = kNand2LeakageNw * (all * 1e-9) + sram_sum(config, law_, &SramFigures::leak_mw) * 1e-3;
  cost.path_fo4 = paths_.fo4(config);
  cost.us = static_cast<double>(cycles) / (1e3 * cost.ghz().value_or(1));
  cost.chip = dynamic(config, kilo_nand2, cycles) + leakage * (cost.us * 1e-6);
  cost.dram = kDramPjPerBit * (8e-12 * static_cast<double>(bytes));
  cost.extrapolated_area = !area_.inside(config);
  cost.extrapolated_path = cost.path_fo4 && !paths_.inside(config);
  cost.extrapolated_energy = cost.extrapolated_area || !measured(config);
  return cost;
}

FrameModel read_frame_model() {
  const std::filesystem::path folder = PIPEGS_SOURCE_DIR "/synth/data";
  const AreaModel area(read_area_points(folder / "points.csv"), read_dependences(folder / "depends.csv"));
  return {area, PathModel(read_path_points(folder / "paths.csv"), area.unit_knobs()), SramLaw(folder / "sram.csv"),
          read_frames(folder / "energy.csv")};
}

}  // namespace pipegs
