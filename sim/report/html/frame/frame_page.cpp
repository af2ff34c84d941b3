// SPDX-License-Identifier: Apache-2.0
// frame_page.cpp: see frame_page.hpp.
#include "sim/report/html/frame/frame_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/report/html/frame/pixel_map.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

void add_picture(HtmlDocument& page, const std::string& name, const std::string& title, const Rgb8& picture) {
  page.add_plane(name, picture.width, picture.height, 3, picture.data);
  page.data["pictures"].push_back({{"name", name}, {"title", title}});
}

// As its difference from the machine's picture, which is small.
void add_difference(HtmlDocument& page, const std::string& name, const std::string& title, const Rgb8& picture,
                    const Rgb8& machine) {
  Rgb8 difference = picture;
  for (size_t i = 0; i < difference.data.size(); ++i)
    difference.data[i] = static_cast<uint8_t>(picture.data[i] - machine.data.at(i));
  add_picture(page, name, title, difference);
  page.data["pictures"].back()["less"] = "machine";
}

PixelMap error_map(const std::string& name, const std::string& title, const std::string& what, const Image& a,
                   const Image& b) {
  return {.name = name,
          .title = title,
          .unit = "of 1",
          .what = what,
          .width = a.width,
          .height = a.height,
          .values = largest_errors(a, b),
          .logarithmic = true,
          .low = 0x1p-16,
          .steps = 6};
}

// Float64 of the eye that the page looks at.
struct Truths {
  Image order, exact, inria;
};

Truths truths_of(const Simulation& simulation, int width) {
  const auto eye = [&](const Image& both) {
    return both.width > width ? cropped(both, {0, 0, width, both.height}) : both;
  };
  return {eye(simulation.truth_order), eye(simulation.truth_exact), eye(simulation.truth_inria)};
}

void add_truth_maps(HtmlDocument& page, const Truths& truths, const Image& golden) {
  const PixelMap numeric =
      error_map("numeric", "numeric error",
                "Machine against float64 in the machine's own order: what fixed point costs.", golden, truths.order);
  add_map(page, numeric);
  add_map(
      page,
      error_map("order", "order error",
                "Float64 in the machine's order against float64 in exact order: layers, or depths that round to one.",
                truths.order, truths.exact));
  const PixelMap total =
      error_map("total", "total error", "Machine against INRIA's rules in float64: all differences together.", golden,
                truths.inria);
  add_map(page, total, &numeric);
}

// Of the 8x8 regions that these pixels touch.
PixelMap region_map(const std::string& name, const std::string& title, const PixelRect& r) {
  return {
      .name = name, .title = title, .cell = 8, .width = (r.x1 + 7) / 8 - r.x0 / 8, .height = (r.y1 + 7) / 8 - r.y0 / 8};
}

void add_golden_maps(HtmlDocument& page, const Simulation& simulation, const Image& golden,
                     const SimulateOptions& options) {
  PixelMap blended{.name = "blended",
                   .title = "Gaussians blended",
                   .unit = "Gaussians",
                   .what = "How many Gaussians changed the pixel before it stopped.",
                   .width = golden.width,
                   .height = golden.height};
  PixelMap left{.name = "transmittance",
                .title = "transmittance left",
                .unit = "of 1",
                .what = "T after the last Gaussian: the share of the background that shines through.",
                .width = golden.width,
                .height = golden.height,
                .step = 1.0 / 255};
  blended.values.assign(golden.blended.begin(), golden.blended.end());
  left.values = golden.transmittance;
  add_map(page, blended);
  add_map(page, left);
  const Image& whole = simulation.golden.image;
  const PixelRect r = asked_pixels(whole.width, whole.height, options);
  PixelMap closed = region_map("closed", "regions closed", r);
  closed.unit = "of 64 pixels";
  closed.what =
      "Pixels of the 8x8 region that had stopped at the end; a region with all 64 is closed, and what lies behind it "
      "is "
      "skipped.";
  closed.values.assign(static_cast<size_t>(closed.width) * static_cast<size_t>(closed.height), 0);
  for (int y = r.y0; y < r.y1; ++y) {
    for (int x = r.x0; x < r.x1; ++x)
      closed.values[static_cast<size_t>((y / 8 - r.y0 / 8) * closed.width + x / 8 - r.x0 / 8)] +=
          simulation.golden.stopped[whole.at(x, y)];
  }
  add_map(page, closed);
}

// Depth of what is seen, and whose it is, where the frame writes them.
void add_aov_maps(HtmlDocument& page, const Simulation& simulation, const Image& golden,
                  const SimulateOptions& options) {
  const Frame& frame = simulation.input.frame;
  const auto wants = [&](Aov aov) { return wants_aov(options.config, frame, aov); };
  const PackedScene& packed = *simulation.input.packed;
  const double range = std::ldexp(1.0, static_cast<int>(frame.raster.aovs.range) + 1 + packed.scene_exponent);
  PixelMap map{.unit = "scene units",
               .width = golden.width,
               .height = golden.height,
               .logarithmic = true,
               .low = std::ldexp(range, -options.config.linear_w()),
               .steps = 64};
  if (wants(Aov::kDepth)) {
    map.name = "depth", map.title = "expected depth";
    map.what = "Sum of weight times depth, over the light that the pixel stops; nothing where none is stopped.";
    for (size_t i = 0; i < golden.depth.size(); ++i) {
      const double stopped = 1 - golden.transmittance[i];
      map.values.push_back(stopped > 0 ? golden.depth[i] / stopped : 0);
    }
    add_map(page, map);
  }
  if (wants(Aov::kMedian)) {
    map.name = "median", map.title = "median depth";
    map.what = "Depth of the Gaussian with which T falls below one half; nothing where none does.";
    map.values = golden.median;
    add_map(page, map);
  }
  if (!wants(Aov::kIndex)) return;
  const double step = std::ceil((static_cast<double>(packed.scene_gaussians) + 1) / 65000);
  PixelMap index{.name = "index",
                 .title = "Gaussian that weighs most",
                 .unit = "one more than its index",
                 .what = fmt::format("The nearest of equal ones, to {}; 0 where there is none.", step),
                 .width = golden.width,
                 .height = golden.height,
                 .step = step};
  for (const uint32_t one : golden.index) index.values.push_back(one == kNoGaussian ? 0 : 1.0 + one);
  add_map(page, index);
}

std::string bytes_of(const std::vector<uint32_t>& words) {
  std::string bytes;
  for (const uint32_t word : words) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 255);
  }
  return bytes;
}

// Rows of cycles by piece, a row for each state of each unit; lines of each stream; windows in units.
void add_timeline(HtmlDocument& page, const FrameRecord& record, const Simulation& simulation, const Config& config) {
  std::vector<uint16_t> values;
  for (const auto& unit : record.units()) {
    for (size_t state = 0; state < 4; ++state) {
      for (const FrameRecord::States& piece : unit) values.push_back(static_cast<uint16_t>(piece[state]));
    }
  }
  std::vector<std::string> names = {"DOPU"};
  for (const char* kind : {"PU", "SU", "RU"}) {
    for (int k = 0; k < config.units; ++k) names.push_back(fmt::format("{} {}", kind, k));
  }
  const auto pieces = static_cast<int>(record.pieces());
  page.add_plane("states", pieces, static_cast<int>(4 * names.size()), values);
  std::vector<uint32_t> lines, spans;
  for (const auto& stream : record.streams()) lines.insert(lines.end(), stream.begin(), stream.end());
  page.add_file("lines", bytes_of(lines));
  for (const auto& [place, span] : record.spans()) {
    for (const uint64_t word : {static_cast<uint64_t>(place.first), place.second, span.begin, span.end})
      spans.push_back(static_cast<uint32_t>(word));
  }
  page.add_file("spans", bytes_of(spans));
  page.data["timeline"] = {{"piece", record.piece_cycles()},
                           {"pieces", pieces},
                           {"units", names},
                           {"streams", memory_streams(config)},
                           {"window_cycles", record.window_cycles()}};
  if (simulation.dram) page.data["latency"] = simulation.dram->latencies;
}

// Beats of the lanes in each region, those of the picture that was asked for.
void add_blends(HtmlDocument& page, const FrameRecord& record, const Frame& frame, const PixelRect& r,
                const Config& config) {
  const int side = config.window / 8,
            columns = static_cast<int>(frame.raster.windows.last_x - frame.raster.windows.first_x + 1) * side,
            x0 = r.x0 / 8 - static_cast<int>(frame.raster.windows.first_x) * side,
            y0 = r.y0 / 8 - static_cast<int>(frame.raster.windows.first_y) * side;
  PixelMap map = region_map("blends", "work of the RUs", r);
  map.unit = config.quads ? "rows of quads" : "lines of alphas";
  map.what = config.quads ? "Rows of living quads that the RUs blended into the 8x8 region."
                          : "Lines of 64 alphas that the RUs blended into the 8x8 region.";
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x)
      map.values.push_back(record.blends()[static_cast<size_t>((y + y0) * columns + x + x0)]);
  }
  add_map(page, map);
}

}  // namespace

HtmlDocument frame_document(const FramePage& given, const Simulation& simulation, const SimulateOptions& options) {
  const Config& config = options.config;
  HtmlDocument page("frame", given.title, given.command);
  const Image golden = crop_window(simulation.golden.image, options);
  const Frame& frame = simulation.input.frame;
  const PixelRect r = asked_pixels(simulation.golden.image.width, simulation.golden.image.height, options);
  page.data["explain"] = given.explain;
  page.data["report"] = given.report;
  page.data["sentences"] = frame_sentences(given.report);
  page.data["picture"] = {{"x", r.x0}, {"y", r.y0}, {"width", golden.width}, {"height", golden.height}};
  page.data["windows"] = {{"side", config.window},
                          {"first_x", frame.raster.windows.first_x},
                          {"first_y", frame.raster.windows.first_y},
                          {"columns", frame.raster.windows.last_x - frame.raster.windows.first_x + 1},
                          {"rows", frame.raster.windows.last_y - frame.raster.windows.first_y + 1}};
  page.data["maps"] = Json::array();
  // Of two eyes the page looks at the first one; it shows what the second one sees.
  const bool pair = given.picture.width > golden.width;
  const Rgb8 picture = pair ? cropped(given.picture, {0, 0, golden.width, golden.height}) : given.picture;
  const char* source = given.report["ran"]["rtl"].get<bool>() ? "RTL, bit for bit" : "golden model";
  add_picture(page, "machine", fmt::format("machine ({}{})", pair ? "left eye, " : "", source), picture);
  if (pair)
    add_picture(page, "second", "right eye",
                cropped(given.picture, {golden.width, 0, given.picture.width, golden.height}));
  const bool truth = simulation.truth_exact.width > 0;
  const Truths truths = truths_of(simulation, golden.width);
  if (truth) add_difference(page, "exact", "float64, exact order", to_rgb8(truths.exact, glm::dvec3(0)), picture);
  if (given.against) add_picture(page, "against", given.against_name, *given.against);
  if (truth) add_truth_maps(page, truths, golden);
  add_golden_maps(page, simulation, golden, options);
  add_aov_maps(page, simulation, golden, options);
  if (given.record == nullptr) return page;
  if (config.taps != 0) add_blends(page, *given.record, frame, r, config);
  add_timeline(page, *given.record, simulation, config);
  return page;
}

}  // namespace pipegs
