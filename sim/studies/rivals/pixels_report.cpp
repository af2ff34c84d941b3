// SPDX-License-Identifier: Apache-2.0
// pixels_report.cpp: see pixels_report.hpp.
//
// Idea    A row is an object of JSON; the table prints the columns that the list of columns names, so the two agree.
#include "sim/studies/rivals/pixels_report.hpp"

#include <fmt/format.h>

#include <span>

#include "sim/report/finite.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

struct Column {
  const char *key, *heading;
  int digits;    // behind the point; -1: as it is
  double scale;  // of the table
  const char* what;
};
constexpr Column kStreams[] = {
    {"voxel", "voxel", 3, 1, "edge of a voxel, scene units"},
    {"part", "part", -1, 1, "of the scene's extent that this edge is, one in so many; 0: an edge that was asked for"},
    {"group", "group", -1, 1, "side of a group, pixels"},
    {"psnr_db", "PSNR", 2, 1, "against exact order of all Gaussians"},
    {"order_db", "order", 2, 1, "PSNR against exact order of the Gaussians that the groups have: the order alone"},
    {"lost_db", "lost", 2, 1, "PSNR of exact order of those Gaussians against that of all: what is lost alone"},
    {"largest", "largest", 3, 1, "error of a channel of a pixel, of 1"},
    {"visible", "visible%", 2, 100, "share of the pixels that differ by more than 1/255"},
    {"late", "late%", 3, 100, "share of the blends that are nearer than one before them in their pixel"},
    {"lost_voxel", "unmet%", 2, 100, "share of (Gaussian, group) with a pixel whose voxel the group does not meet"},
    {"lost_coarse", "coarse%", 3, 100, "share of (Gaussian, group) with a pixel that the coarse filter drops"},
    {"fetched", "fetched M", 2, 1e-6, "(Gaussian, group) in voxels until the group has stopped"},
    {"passed", "passed M", 3, 1e-6, "of those, through the coarse filter"},
    {"bytes", "MB", 1, 1e-6, "16 for each fetched, an index for each that passed; pixels not counted"},
};
constexpr Column kFrames[] = {
    {"machine", "order", -1, 1,
     "gsacc_all, _seen: last frame's depths; neo: last frame's tables; neo_even: newcomers by last depths too"},
    {"speed", "speed", 2, 1, "times the step"},
    {"psnr_db", "PSNR", 2, 1, "of the mean squared error of all frames, against exact order"},
    {"worst_db", "worst", 2, 1, "PSNR of the worst frame"},
    {"largest", "largest", 3, 1, "error of a channel of a pixel, of 1"},
    {"visible", "visible%", 2, 100, "share of the pixels that differ by more than 1/255"},
    {"late", "late%", 3, 100, "share of the blends that are nearer than one before them in their pixel"},
    {"newcomers", "newcomers%", 2, 100, "share of the Gaussians that touch no tile of the frame before"},
};

double share(uint64_t part, uint64_t all) {
  return all == 0 ? 0 : static_cast<double>(part) / static_cast<double>(all);
}

Json row_of(const StreamRow& row) {
  const StreamCounts& c = row.counts;
  return {{"voxel", row.edge},
          {"part", row.part},
          {"group", row.side},
          {"psnr_db", finite_json(row.whole.psnr_db)},
          {"order_db", finite_json(row.order.psnr_db)},
          {"lost_db", finite_json(row.lost.psnr_db)},
          {"largest", row.whole.largest},
          {"visible", row.whole.visible},
          {"late", share(row.blends.late, row.blends.blends)},
          {"lost_voxel", share(c.lost_voxel, c.pairs)},
          {"lost_coarse", share(c.lost_coarse, c.pairs)},
          {"fetched", c.fetched},
          {"passed", c.coarse},
          {"bytes", row.bytes},
          {"occupied", row.occupied},
          {"met", c.met},
          {"taken", c.taken},
          {"pairs", c.pairs},
          {"fine", c.fine}};
}

Json row_of(const PathRow& row) {
  return {{"machine", row.machine},
          {"speed", row.speed},
          {"psnr_db", finite_json(row.mean.psnr_db)},
          {"worst_db", finite_json(row.worst_db)},
          {"largest", row.mean.largest},
          {"visible", row.mean.visible},
          {"late", row.late},
          {"newcomers", row.newcomers}};
}

template <class Row>
Json rows_of(const std::vector<Row>& rows) {
  Json all = Json::array();
  for (const Row& row : rows) all.push_back(row_of(row));
  return all;
}

std::string cell(const Json& value, const Column& column) {
  if (value.is_null()) return "equal";
  if (value.is_string()) return value.get<std::string>();
  if (column.digits < 0) return value.dump();
  return fmt::format("{:.{}f}", value.get<double>() * column.scale, column.digits);
}

std::string table(std::span<const Column> columns, const Json& rows) {
  std::string text;
  for (const Column& column : columns) text += fmt::format("  {:<11}{}\n", column.heading, column.what);
  text += "\n ";
  for (const Column& column : columns) text += fmt::format(" {:>10}", column.heading);
  for (const Json& row : rows) {
    text += "\n ";
    for (const Column& column : columns) text += fmt::format(" {:>10}", cell(row.at(column.key), column));
  }
  return text + "\n";
}

}  // namespace

Json pixels_json(const PixelStudy& study, const PixelOptions& options) {
  Json json = {{"parameters",
                {{"near", options.near_plane},
                 {"step", options.step},
                 {"frames", options.frames},
                 {"index_bytes", options.index_bytes},
                 {"extent", study.extent}}},
               {"streaminggs", rows_of(study.streams)},
               {"path",
                {{"arc", study.arc},
                 {"legs", study.legs},
                 {"degrees", study.degrees},
                 {"turn", study.turn},
                 {"move", study.move},
                 {"parallax", study.parallax}}},
               {"frames", rows_of(study.paths)}};
  for (const Column& column : kStreams) json["definitions"]["streaminggs"][column.key] = column.what;
  json["definitions"]["streaminggs"]["occupied"] = "voxels with a Gaussian";
  json["definitions"]["streaminggs"]["met"] = "(voxel, group) that meet";
  json["definitions"]["streaminggs"]["taken"] = "of those, until the group has stopped";
  json["definitions"]["streaminggs"]["pairs"] = "(Gaussian, group) with alpha >= 1/255 at a pixel of the group";
  json["definitions"]["streaminggs"]["fine"] = "of those passed, with alpha >= 1/255 at a pixel of the group";
  json["definitions"]["path"] = {{"arc", "around a lone view, instead of through several"},
                                 {"legs", "from a view to the next"},
                                 {"degrees", "length: of each leg the larger of rotation and parallax"},
                                 {"turn", "rotation of a step at 1x, degrees"},
                                 {"move", "of a step at 1x, scene units"},
                                 {"parallax", "of a step at 1x, degrees at the median depth"}};
  for (const Column& column : kFrames) json["definitions"]["frames"][column.key] = column.what;
  return json;
}

std::string pixels_text(const PixelStudy& study, const PixelOptions& options) {
  return fmt::format(
      "pixels, against exact order, float64\n\n"
      "STREAMINGGS: voxel by voxel, the view; the scene's extent is {:.3f}, an index has {} bytes\n\n{}\n"
      "GSAcc and Neo: in the order of the frame before, {} frames of a path of {:.1f} degrees {}\n"
      "a step at 1x is {:.4f} degrees: it turns by {:.4f} degrees and moves by {:.5f} units, {:.4f} degrees of "
      "parallax\n\n{}",
      study.extent, options.index_bytes, table(kStreams, rows_of(study.streams)), options.frames, study.degrees,
      study.arc ? "around the view" : fmt::format("through {} legs", study.legs), options.step, study.turn, study.move,
      study.parallax, table(kFrames, rows_of(study.paths)));
}

}  // namespace pipegs
