// SPDX-License-Identifier: Apache-2.0
// render.cpp: `pipegs render`: the pictures of one view or several without the RTL.
#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "cpp_model/float/image.hpp"
#include "cpp_model/float/truth.hpp"
#include "scenes/check/view_check.hpp"
#include "scenes/input_error.hpp"
#include "sim/command/command.hpp"
#include "sim/command/frame/against_argument.hpp"
#include "sim/command/frame/picture_arguments.hpp"
#include "sim/command/page/study_output.hpp"
#include "sim/command/sequence/frame_files.hpp"
#include "sim/command/sequence/frame_table.hpp"
#include "sim/progress.hpp"

namespace pipegs {
namespace {

struct RenderArguments {
  ViewArguments view;
  PictureArguments picture;
  AgainstArgument against;
  std::vector<int> views;  // first and last; nothing: the one of --view
  StudyOutput output;      // of several views
  std::string model = "golden", semantics = "exact", compare;
};

// The picture to compare with, read before anything is rendered.
std::optional<Rgb8> read_other(const std::string& path, const Camera& camera, const SimulateOptions& options) {
  if (path.empty()) return std::nullopt;
  const PixelRect r = asked_pixels(camera.width, camera.height, options);
  const auto width = static_cast<png_uint_32>(r.x1 - r.x0), height = static_cast<png_uint_32>(r.y1 - r.y0);
  // Of its size before it is decoded: a few kilobytes may hold a gigabyte.
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  std::error_code ignored;
  const bool read =  // nobody may write into a pipe
      std::filesystem::is_regular_file(path, ignored) && png_image_begin_read_from_file(&png, path.c_str()) != 0;
  png_image_free(&png);
  if (read && (png.width != width || png.height != height))
    throw InputError(path, "", fmt::format("found {}x{} pixels, expected {}x{}", png.width, png.height, width, height));
  return read_png8(path);  // refuses what is no PNG
}

// Prints how the written picture differs from another one, in 8-bit codes; whether it does.
bool differs(const Rgb8& mine, const Rgb8& other, const std::string& path) {
  int largest = 0;
  size_t differing = 0;
  for (size_t i = 0; i < mine.data.size(); i += 3) {
    int pixel = 0;
    for (size_t k = i; k < i + 3; ++k) pixel = std::max(pixel, std::abs(int{mine.data[k]} - int{other.data[k]}));
    largest = std::max(largest, pixel);
    differing += pixel > 0;
  }
  fmt::print("against {}: {} of {} pixels differ, by {} codes at most\n", path, differing, mine.data.size() / 3,
             largest);
  return differing > 0;
}

// A view as the chosen model draws it.
class Model {
 public:
  Model(const RenderArguments& arguments, const LoadedView& loaded, const std::vector<Camera>& cameras,
        const SimulateOptions& options)
      : arguments_(arguments), scene_(loaded.scene), options_(options) {
    if (arguments.model != "truth") packed_ = pack_views(scene_, cameras, options);
  }

  std::pair<Image, Rgb8> draw(const Camera& camera) const {
    Simulation simulation;
    if (arguments_.model != "truth") {
      simulate_frame(packed_, camera, options_, simulation);
      simulate_golden(options_, simulation);
    }
    if (arguments_.model == "golden")
      return {golden_picture(simulation, options_), arguments_.picture.picture(simulation, options_)};
    TruthOptions truth;
    truth.semantics = arguments_.semantics == "inria"    ? Semantics::kInria
                      : arguments_.semantics == "gsplat" ? Semantics::kGsplat
                                                         : Semantics::kExact;
    if (arguments_.model == "layered") truth.rank = &simulation.golden.rank;
    truth.near_plane = options_.near_plane;
    Progress progress("truth");
    truth.progress = [&](double share) {
      if (interrupted()) throw std::runtime_error("interrupted");
      progress.update(share);
    };
    const Image image = crop_window(render_truth(scene_, camera, truth), options_);
    const Background& behind = arguments_.picture.color();
    return {image, to_rgb8(image, glm::dvec3(behind[0], behind[1], behind[2]) / 255.0)};
  }

 private:
  const RenderArguments& arguments_;
  const Scene& scene_;
  const SimulateOptions& options_;
  PackedScene packed_;
};

PixelBytes memory_of(const RenderArguments& arguments) {
  return kWritePixels + (arguments.model == "truth" ? PixelBytes{} : kGoldenPixels) +
         (arguments.model == "golden" ? PixelBytes{} : kImagePixels);
}

int render_views(const RenderArguments& arguments, const LoadedView& loaded, const SimulateOptions& options) {
  const std::vector<FrameRow> rows = views_of(loaded.cameras, arguments.views);
  const std::vector<Camera> cameras = cameras_of(rows);
  loaded.told->tell(check_views(loaded.scene, cameras, options.near_plane));
  for (const Camera& camera : cameras) check_picture_memory(camera, options, memory_of(arguments));
  AgainstArgument against = arguments.against;
  against.begin(loaded, cameras, options, true);
  FrameFiles files({arguments.output.out()});
  const Model model(arguments, loaded, cameras, options);
  std::vector<Quality> quality;
  for (const Camera& camera : cameras) {
    const auto [image, picture] = model.draw(camera);
    files.add(image, picture);
    quality.push_back({.against = against.figures(quality.size(), picture)});
  }
  Table table{.columns = {{.key = "frame", .heading = "frame"},
                          {.key = "view", .heading = "view"},
                          {.key = "camera", .heading = "camera", .word = true},
                          {.key = "width", .heading = "width"},
                          {.key = "height", .heading = "height"}}};
  add_columns(table, quality);
  nlohmann::ordered_json json = {
      {"scene", loaded.scene.name}, {"model", arguments.model}, {"semantics", arguments.semantics}};
  for (size_t i = 0; i < rows.size(); ++i) {
    const Camera& camera = rows[i].camera;
    table.rows.push_back({number_cell(static_cast<double>(i)), number_cell(rows[i].view), text_cell(camera.name),
                          number_cell(camera.width), number_cell(camera.height)});
    add_cells(table.rows.back(), quality, i);
    json["views"].push_back({{"view", static_cast<int>(rows[i].view)},
                             {"camera", camera.name},
                             {"width", camera.width},
                             {"height", camera.height}});
    add_view(json["views"].back(), quality[i]);
  }
  add_summary(json, quality);
  std::vector<Table> tables = summary_tables(quality);
  tables.insert(tables.begin(), table);
  arguments.output.write({.title = "Pictures of views",
                          .head = fmt::format("{}: {} views, {}", loaded.scene.name, rows.size(), arguments.model),
                          .charts = quality_charts(quality),
                          .tables = tables,
                          .odd = loaded.told->all()},
                         json);
  return kExitOk;
}

int render(const RenderArguments& arguments) {
  SimulateOptions options = arguments.view.options();
  arguments.picture.apply(arguments.view, arguments.model == "golden", options);
  const std::string& out = arguments.output.out();
  arguments.output.check();
  try_folder("--out", out, {"frame.exr", "frame.png", "frame_0000.png"});
  const LoadedView loaded = load_view(arguments.view);
  follow_scene(loaded, options);
  if (!arguments.views.empty()) return render_views(arguments, loaded, options);
  check_picture_memory(loaded.camera, options, memory_of(arguments));
  const std::optional<Rgb8> other = read_other(arguments.compare, loaded.camera, options);
  AgainstArgument against = arguments.against;
  against.begin(loaded, {loaded.camera}, options, false);
  const auto [image, picture] = Model(arguments, loaded, {loaded.camera}, options).draw(loaded.camera);
  write_images(out, image, picture);
  fmt::print("picture {}/frame.png, {}/frame.exr\n", out, out);
  if (const auto like = against.figures(0, picture)) fmt::print("{}", against_text(*like));
  return other && differs(picture, *other, arguments.compare) ? kExitDiffers : kExitOk;
}

}  // namespace

void add_render(CLI::App& app, Run& run) {
  CLI::App& command =
      add_command(app, "render", "the picture of a view, without the RTL",
                  footer("pipegs render garden.ply --cameras cameras.json --model truth --semantics inria --out inria",
                         "written", "with --compare: a pixel differs"));
  static RenderArguments arguments;
  arguments.view.add(command);
  arguments.picture.add(command);
  add_text(command, "--model", arguments.model,
           "truth (float64, global depth order), layered (float64, the hardware's order) or golden (golden model)")
      .shows_default()
      .one_of({"truth", "layered", "golden"});
  add_text(command, "--semantics", arguments.semantics, "of the float64 models: footprints and pixel centres")
      .shows_default()
      .one_of({"exact", "inria", "gsplat"});
  add_span(command, "--views", arguments.views, "instead of --view: these views, or all: frame_0000.png and so on")
      .excludes("--view");
  arguments.against.add(command);
  arguments.output.add(command, "out");
  add_text(command, "--compare", arguments.compare, "say how the picture differs from this 8-bit PNG of the same size")
      .excludes("--views");
  when_chosen(command, run, [] { return render(arguments); });
}

}  // namespace pipegs
