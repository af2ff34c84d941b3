// SPDX-License-Identifier: Apache-2.0
// unknown_stimulus.cpp: unknown_stimulus FOLDER [key=value ...]: one small window as files for unknown_bench.v.
//
// A scene of a few Gaussians, large ones and specks, before a camera whose image is one window of the machine with
// these settings. Into FOLDER go memory.hex (the scene as it lies in external memory; the pixels' lines are not in it,
// they start X), expected.hex and places.hex (the golden model's lines of pixels, and where they belong), inputs.vh
// (the ports that are taken with the frame) and sizes.vh (widths of ports, where the fields of a request lie, how many
// lines). Exit code 2 on bad arguments.
#include <fmt/format.h>
#include <fmt/os.h>

#include <map>

#include "cpp_model/areas/frame_areas.hpp"
#include "cpp_model/frame_setup.hpp"
#include "cpp_model/ru/ru_raster.hpp"
#include "cpp_model/ru/ru_resolve.hpp"
#include "sim/compare/simulate.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

constexpr size_t kGaussians = 40;

std::string hex(const uint32_t* words, int width) {
  std::string text;
  for (int at = (width + 3) / 4 * 4 - 4; at >= 0; at -= 4)
    text += fmt::format("{:x}", get_bits(words, at, std::min(4, width - at)));
  return text;
}

// The lines of the frame's pixels, each whole: the image is one window.
std::map<uint64_t, MemoryLine> pixel_lines(const Config& config, const Simulation& simulation) {
  std::map<uint64_t, MemoryLine> lines;
  const Frame& frame = simulation.input.frame;
  for (int y = 0; y < config.window; ++y) {
    for (int x = 0; x < config.window; ++x) {
      MemoryLine& line = lines[ru_pixel_line(config, frame, 0, 0, region_at(config, x / 8, y / 8), y % 8)];
      put_bits(line.data(), ru_pixel_bit(config, y % 8, x % 8), config.pixel_w,
               simulation.golden.pixels[static_cast<size_t>(y * config.window + x)]);
    }
  }
  return lines;
}

// Where the fields of a record lie, as definitions NAME_AT and NAME_W.
struct Places final : FieldVisitor {
  void visit(const FieldName& field, uint64_t&, int width, bool) override {
    std::string name = field.text();
    for (char& letter : name) letter = static_cast<char>(std::toupper(letter));
    text += fmt::format("`define {}_AT {}\n`define {}_W {}\n", name, at, name, width);
    at += width;
  }
  std::string text;
  int at = 0;
};

// The connection of an input that is X when no frame is valid.
std::string input(const char* name, int width, const std::vector<uint32_t>& words) {
  return fmt::format("    .{}_i(frame_valid ? {}'h{} : {{{}{{1'bx}}}}),\n", name, width, hex(words.data(), width),
                     width);
}

template <typename R>
std::string input(const char* name, const Config& config, const R& record) {
  std::vector<uint32_t> words(static_cast<size_t>(record_words<R>(config)) + 1);
  pack(config, record, words.data());
  return input(name, record_width<R>(config), words);
}

void write_stimulus(const std::string& folder, const Config& config) {
  SimulateOptions options;
  options.config = config;
  Scene scene = random_scene(5, kGaussians, config.sh_degree);
  scene.gaussians[0] = gaussian_at({0.2f, 0.1f, 3}, 0.8f, 0.95);  // covers much of the window
  Simulation simulation;
  simulate_golden(scene, test_camera(config.window, config.window, config.window), options, simulation);

  auto memory = fmt::output_file(folder + "/memory.hex");
  const MemoryImage image = memory_image(simulation.packed);
  for (const MemoryLine& line : image.lines) memory.print("{}\n", hex(line.data(), 512));
  auto expected = fmt::output_file(folder + "/expected.hex");
  auto places = fmt::output_file(folder + "/places.hex");
  const std::map<uint64_t, MemoryLine> lines = pixel_lines(config, simulation);
  for (const auto& [place, line] : lines) {
    expected.print("{}\n", hex(line.data(), 512));
    places.print("{:x}\n", place);
  }
  Places fields;
  MemoryRequest request;
  visit_fields(config, request, fields);
  const Frame& frame = simulation.input.frame;
  auto inputs = fmt::output_file(folder + "/inputs.vh");
  inputs.print("{}", input("frame", config, frame));
  inputs.print("{}", input("areas", config, frame_areas(config, simulation.packed, frame)));
  inputs.print("{}", input("picture", 1 + config.address_w() + config.stride_w(), picture_words(config, {})));
  auto sizes = fmt::output_file(folder + "/sizes.vh");
  sizes.print("{}`define REQUEST_W {}\n`define COUNTER_W {}\n", fields.text, fields.at, config.perf_w());
  sizes.print("`define PERF_UNITS {}\n`define SCENE_LINES {}\n`define LINES {}\n`define PIXEL_LINES {}\n",
              1 + 3 * config.units, image.lines.size(), frame.tables.overflow, lines.size());
}

}  // namespace
}  // namespace pipegs

int main(int count, char** words) {
  try {
    if (count < 2) throw pipegs::ConfigError("expected FOLDER [key=value ...]");
    pipegs::Config config;
    for (int i = 2; i < count; ++i) pipegs::config_set(config, words[i]);
    pipegs::config_check(config);
    pipegs::write_stimulus(words[1], config);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "unknown_stimulus: {}\n", error.what());
    return 2;
  }
}
