// SPDX-License-Identifier: Apache-2.0
// sequence.cpp: see sequence.hpp.
#include "sim/command/sequence/sequence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "cpp_model/dopu/nearest/dopu_lod.hpp"
#include "cpp_model/driver/pipegs_budget.h"
#include "cpp_model/float/metrics.hpp"
#include "cpp_model/frame_setup.hpp"
#include "scenes/cameras/path.hpp"
#include "scenes/check/view_check.hpp"
#include "scenes/text/json.hpp"
#include "scenes/text/quote.hpp"
#include "sim/command/own_tables.hpp"
#include "sim/command/page/study_output.hpp"
#include "sim/command/sequence/frame_files.hpp"
#include "sim/command/sequence/frame_table.hpp"
#include "sim/command/sequence/gaze_views.hpp"
#include "sim/progress.hpp"
#include "sim/rtl/rtl_fault.hpp"
#include "sim/report/finite.hpp"
#include "sim/report/measurement_store.hpp"
#include "sim/report/report.hpp"
#include "sim/timing/timing_model.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

// Of a path through these views.
std::vector<FrameRow> path_of(const std::vector<FrameRow>& views, int frames) {
  const double first = views.front().view, step = (views.back().view - first) / (frames - 1);
  std::vector<FrameRow> rows;
  for (const Camera& camera : camera_path(cameras_of(views), frames))
    rows.push_back({.view = first + step * static_cast<double>(rows.size()), .camera = camera});
  return rows;
}

// What --no-rtl keeps of a frame.
struct KeptFrame {
  uint64_t cycles = 0;
  MemoryBytes bytes;
  std::optional<double> steady;
  std::optional<Quality::Truth> truth;
  Json files;  // FrameFiles::fingerprint
};

KeptFrame read_kept(const Json& json) {
  KeptFrame kept{json_integer<uint64_t>(json.at("cycles")),
                 {json_integer<uint64_t>(json.at("read")), json_integer<uint64_t>(json.at("written"))},
                 {},
                 {},
                 json.at("files")};
  if (json.contains("steady")) kept.steady = psnr_from(json.at("steady"));
  if (json.contains("truth")) {
    const Json& truth = json.at("truth");
    kept.truth = {psnr_from(truth.at("numeric")), psnr_from(truth.at("order")), psnr_from(truth.at("total"))};
  }
  return kept;
}

// What each frame gives up, rest and level of detail: as the options say, or the driver, by what the frame before took.
class Levels {
 public:
  Levels(const SimulateOptions& options, const Camera& camera, uint64_t cycles) {
    const pipegs_configuration config = driver_configuration(options.config);
    const pipegs_camera seen = driver_camera(camera, options.near_plane);
    if (cycles == 0) return;
    if (!pipegs_budget_begin(&config, &seen, cycles, &budget_.emplace()))
      throw ConfigError("--budget: found a machine that can give up nothing, expected early_stop=1 or lod=1");
  }
  bool budget() const { return budget_.has_value(); }
  void set(Frame& frame) {
    if (!budget_) return;
    pipegs_frame fields = {};
    pipegs_budget_set(&*budget_, &fields);
    frame.raster.rest = fields.raster_rest;
    frame.lod = fields.lod;
  }
  void took(uint64_t cycles) {
    if (budget_) pipegs_budget_took(&*budget_, cycles);
  }

 private:
  std::optional<pipegs_budget> budget_;
};

class Sequence {
 public:
  Sequence(const LoadedView& loaded, std::vector<FrameRow> rows, const SimulateOptions& options,
           const PictureArguments& picture, bool truth, const FrameFilesOptions& files, std::optional<GazeViews> gaze)
      : table_{loaded.scene.name, options.config, options.memory.dram, std::move(rows)},
        scene_(loaded.scene),
        options_(options),
        picture_(picture),
        truth_(truth),
        files_(files),
        gaze_(std::move(gaze)) {
    packed_ = pack_views(scene_, cameras_of(table_.rows), options);
  }

  // The golden model draws, the timing model counts; one frame after the other.
  void model(const std::string& keep, uint64_t budget) {
    Levels levels(options_, table_.rows[0].camera, budget);
    const MeasurementStore store(keep, scene_, table_.rows[0].camera, options_,
                                 {{"sequence", packed_.scene_exponent}, {"background", picture_.background}});
    Progress progress("frames");
    Frame last;  // of the frame before
    for (size_t i = 0; i < table_.rows.size(); ++i) {
      FrameRow& row = table_.rows[i];
      Simulation simulation;
      const Frame frame = set_up(row, levels, simulation), before = std::exchange(last, frame);
      const MeasurementStore mine = store.of(row.camera).with({{"rest", frame.raster.rest}, {"lod", frame.lod}});
      const auto kept = mine.load(options_.config, read_kept);
      if (kept && (kept->truth || !truth_) && files_.take(kept->files)) {
        row.cycles = kept->cycles;
        row.bytes = kept->bytes;
        row.steady = kept->steady;
        if (truth_) row.quality.truth = kept->truth;
        levels.took(row.cycles);
        before_ = {};
        if (gaze_) gaze_->add(drawn(row.camera, frame));
        continue;
      }
      const auto at = [&](double share) {
        if (interrupted())
          throw std::runtime_error(
              fmt::format("interrupted after {} of {} frames; the same command goes on there", i, table_.rows.size()));
        progress.update((static_cast<double>(i) + share) / static_cast<double>(table_.rows.size()),
                        fmt::format("{} of {}", i + 1, table_.rows.size()));
      };
      if (i > 0 && before_.width == 0 && !gaze_) before_ = drawn(table_.rows[i - 1].camera, before);
      simulate_golden(options_, simulation, {.progress = [&](double share) { at(0.4 * share); }});
      write(simulation, row);
      at(0.4);
      const TimingResult timing = timing_run(timing_trace(simulation.input), options_.config, options_.memory);
      row.cycles = timing.cycles;
      levels.took(row.cycles);
      for (const MemoryTraffic& stream : timing.streams)
        row.bytes = {row.bytes.read + stream.bytes_read, row.bytes.written + stream.bytes_written};
      Json measured = {{"cycles", row.cycles},
                       {"read", row.bytes.read},
                       {"written", row.bytes.written},
                       {"files", files_.fingerprint()}};
      if (row.steady) measured["steady"] = finite_json(*row.steady);
      if (const auto truth = hold_to_truth(row, simulation))
        measured["truth"] = {{"numeric", finite_json(truth->numeric_db)},
                             {"order", finite_json(truth->order_db)},
                             {"total", finite_json(truth->total_db)}};
      mine.save(options_.config, measured);
    }
  }

  // All frames through the RTL, queued and alone.
  void rtl(const std::function<std::string(std::optional<int64_t>)>& replay, uint64_t budget) {
    Levels levels(options_, table_.rows[0].camera, budget);
    std::vector<std::unique_ptr<Simulation>> simulations;
    std::vector<Simulation*> frames;
    for (FrameRow& row : table_.rows) {
      frames.push_back(simulations.emplace_back(std::make_unique<Simulation>()).get());
      set_up(row, levels, *frames.back());
      simulate_golden(options_, *frames.back());
      if (levels.budget())
        levels.took(timing_run(timing_trace(frames.back()->input), options_.config, options_.memory).cycles);
      hold_to_truth(row, *frames.back());
      row.mismatches = 0;
    }
    for (const bool queued : {true, false}) {
      options_.rtl.queued = queued;
      if (!queued) options_.rtl.waves.clear();  // of one of the runs
      try {
        add_run(simulate_sequence(options_, frames), frames, queued);
      } catch (const RtlFault& fault) {
        fmt::print(stderr, "replay with waves: {}\n", replay(fault.cycle));
        throw;
      }
    }
    for (size_t i = 0; i < frames.size(); ++i) write(*frames[i], table_.rows[i]);
    if (wrong_.is_null()) return;
    // Waves are of the first run.
    const bool queued = wrong_["queued"];
    wrong_["replay"] = replay(queued ? std::optional<int64_t>(wrong_["cycle"]) : std::nullopt);
  }

  // The first mismatch as JSON, or null.
  const Json& wrong() const { return wrong_; }
  const std::optional<Mismatch>& first() const { return first_; }

  // What each frame cost is known, and how far it is from its photograph.
  const FrameTable& finish(const std::vector<std::optional<AgainstFigures>>& against) {
    for (size_t i = 0; i < against.size(); ++i) table_.rows[i].quality.against = against[i];
    for (FrameRow& row : table_.rows)
      row.cost = silicon_.cost(table_.config, row.cycles, row.bytes.read + row.bytes.written);
    if (gaze_) table_.gaze = gaze_->done();
    return table_;
  }

 private:
  // The three renders in float64, where they are wanted; they are not kept.
  std::optional<Quality::Truth> hold_to_truth(FrameRow& row, Simulation& simulation) const {
    if (!truth_) return std::nullopt;
    simulate_truth(scene_, row.camera, options_, simulation);
    for (Image* image : {&simulation.truth_order, &simulation.truth_exact, &simulation.truth_inria}) *image = Image();
    row.quality.truth = {simulation.psnr_numeric, simulation.psnr_order, simulation.psnr_total};
    return row.quality.truth;
  }

  void write(const Simulation& simulation, FrameRow& row) {
    Image now = picture_of(simulation, options_);
    files_.add(now, picture_.picture(simulation, options_));
    if (gaze_) return gaze_->add(now);
    if (now.width == before_.width && now.height == before_.height) row.steady = psnr(before_, now);
    before_ = std::move(now);
  }

  // The picture of a frame that was kept.
  Image drawn(const Camera& camera, const Frame& frame) const {
    Simulation simulation;
    simulate_frame(packed_, camera, options_, simulation);
    simulation.input.frame = frame;
    simulate_golden(options_, simulation, {});
    return picture_of(simulation, options_);
  }

  Frame set_up(FrameRow& row, Levels& levels, Simulation& simulation) const {
    simulate_frame(packed_, row.camera, options_, simulation);
    Frame& frame = simulation.input.frame;
    levels.set(frame);
    const Config& config = options_.config;
    if (levels.budget() || options_.rest != 0)
      row.rest = std::ldexp(static_cast<double>(frame.raster.rest), -config.rest_w());
    if (config.lod) row.lod_pixels = dopu_lod_pixels(config, row.camera.fx, frame.lod);
    return frame;
  }

  // What a run says of each frame: cycles from the end of the frame before, or from the start, to its own.
  void add_run(const SequenceRun& run, const std::vector<Simulation*>& frames, bool queued) {
    uint64_t before = 0;
    for (size_t i = 0; i < frames.size(); ++i) {
      FrameRow& row = table_.rows[i];
      const uint64_t cycles = run.rtl.frame_ends[i] - before;
      before = run.rtl.frame_ends[i];
      std::optional<uint64_t> gap;  // the first frame has none
      if (i > 0 && options_.config.taps) gap = run.rtl.frame_gaps.at(i - 1);
      if (queued) {
        row.cycles_queued = cycles;
        row.gap_queued = gap;
      } else {
        row.cycles = cycles;
        row.gap_alone = gap;
        row.bytes = run.frame_bytes[i];
      }
      *row.mismatches += frames[i]->mismatches;
      if (!wrong_.is_null() || !frames[i]->first_mismatch) continue;
      wrong_ = {{"frame", i}, {"queued", queued}};
      first_ = frames[i]->first_mismatch;
      wrong_.update(mismatch_json(first_));
    }
  }

  const FrameModel silicon_ = own_tables(read_frame_model);
  FrameTable table_;
  const Scene& scene_;
  SimulateOptions options_;
  const PictureArguments& picture_;
  const bool truth_;
  FrameFiles files_;
  std::optional<GazeViews> gaze_;
  PackedScene packed_;
  Image before_;  // the picture that was written last
  std::optional<Mismatch> first_;
  Json wrong_;  // the same
};

// An integer, or one of thousands or millions: 4000000, 4000k, 4M.
uint64_t parse_cycles(const std::string& text) {
  const char last = text.empty() ? ' ' : text.back();
  const uint64_t unit = last == 'k' ? 1000 : last == 'M' ? 1000000 : 1, most = uint64_t{1} << 40;
  return unit * parse_integer<uint64_t>(unit == 1 ? text : text.substr(0, text.size() - 1), 1, most / unit);
}

FrameFilesOptions files_of(const SequenceArguments& sequence, const std::string& out) {
  const auto wanted = [&](const char* kind) {
    return std::find(sequence.frames.begin(), sequence.frames.end(), kind) != sequence.frames.end();
  };
  return {out, wanted("png"), wanted("exr")};
}

}  // namespace

void SequenceArguments::add(CLI::App& app) {
  add_span(app, "--views", views, "instead of --view: these views, or all, in one machine without a reset");
  add_integer(app, "--path", path, "so many frames on a smooth path through all views, or those of --views", 2, 100000);
  add_names(app, "--frames", frames, "of a sequence: its pictures in --out, png, exr or none by commas")
      .shows_default();
  add_flag(app, "--truth", truth, "of a sequence: the float64 renders and the PSNR of each frame, too");
  add_read(app, "--budget",
           "of a sequence: cycles of a frame, such as 4M, which the driver holds by --rest and --lod-pixels", "INT",
           [this](const std::string& text) { budget = parse_cycles(text); });
  add_counts(
      app, "--gaze", gaze,
      "samples of a pixel up to FULL pixels from X,Y, of 2x2 up to HALF, of 4x4 farther out: a sequence of frames, "
      "nine at most for a view",
      "X,Y,FULL,HALF", kMaxImageSide);
}

void SequenceArguments::check(const CLI::App& command, const std::string& out) const {
  for (const char* option : {"--frames", "--truth", "--budget"}) {
    if (!wanted() && is_given(command, option))
      throw ConfigError(fmt::format("{}: found one frame, expected --views or --path", option));
  }
  if (!wanted()) return;
  for (const char* option : {"--rest", "--lod-pixels"}) {
    if (budget != 0 && is_given(command, option))
      throw ConfigError(fmt::format("{}: found --budget, too, expected one of them", option));
  }
  for (const char* option : {"--budget", "--against", "--viewer", "--window", "--crop"}) {
    if (!gaze.empty() && is_given(command, option))
      throw ConfigError(fmt::format("{}: found --gaze, too, expected one of them", option));
  }
  if (!gaze.empty() && gaze[3] < gaze[2])
    throw ConfigError(fmt::format(
        "--gaze: found half the resolution from {} pixels and a quarter from {}, expected no less", gaze[2], gaze[3]));
  for (const std::string& kind : frames) {
    if (kind != "png" && kind != "exr" && (kind != "none" || frames.size() > 1))
      throw ConfigError(fmt::format("--frames: found {}, expected png, exr or none alone", quote(kind)));
  }
  for (const char* option : {"--effects", "--view", "--netlist"}) {
    if (is_given(command, option) && (several() || option != std::string("--view")))
      throw ConfigError(fmt::format("{}: found a sequence, expected one view", option));
  }
  try_folder("--out", out,
             {"sequence.json", "frames.csv", "frame_0000.png", "frame_0000.exr", "viewer.html", "sequence.html"});
}

int run_sequence(const ViewArguments& view, const SequenceArguments& sequence, const PictureArguments& picture,
                 const SimulateOptions& options, const SequenceRunArguments& run) {
  if (view.eye_views && sequence.several())
    throw ConfigError("--stereo: found two views, expected the way between the eyes of a sequence");
  const LoadedView loaded = load_view(view);
  SimulateOptions simulated = options;
  follow_scene(loaded, simulated);
  std::vector<FrameRow> rows;
  if (sequence.several()) rows = views_of(loaded.cameras, sequence.views);
  else rows = {{.view = static_cast<double>(view.view), .camera = loaded.camera}};
  if (sequence.path > 0) rows = path_of(rows, sequence.path);
  loaded.told->tell(check_views(loaded.scene, cameras_of(rows), simulated.near_plane));
  FrameFilesOptions files = files_of(sequence, run.out);
  std::optional<GazeViews> gaze;
  if (!sequence.gaze.empty()) {
    const Gaze where = {sequence.gaze[0], sequence.gaze[1], sequence.gaze[2], sequence.gaze[3]};
    for (const FrameRow& view : rows) check_picture_memory(view.camera, simulated, kTruthPixels);
    const Background behind = picture.color();
    gaze.emplace(loaded.scene, rows, where, simulated, glm::dvec3(behind[0], behind[1], behind[2]) / 255.0,
                 files.png ? run.out : "", sequence.truth);
    rows = rows_of_parts(rows, where);
  }
  const uint64_t held = run.rtl ? rows.size() : 1;  // frames in memory at a time
  const PixelBytes each = run.rtl ? kGoldenPixels + kRtlPixels : kGoldenPixels;
  const uint64_t more = kWritePixels.asked + (sequence.truth ? kTruthPixels.asked : 0);
  for (const FrameRow& row : rows)
    check_picture_memory(row.camera, simulated, {each.frame * held, each.asked * held + more});
  AgainstArgument against = run.against;
  against.begin(loaded, cameras_of(rows), simulated, true);
  ViewerArgument viewer = run.viewer;
  viewer.begin(loaded, cameras_of(rows), simulated, picture.color(), run.command);
  std::vector<std::optional<AgainstFigures>> like;
  if (viewer.wanted() || against.wanted())
    files.show = [&](const Rgb8& shown) {
      viewer.add(shown);
      if (against.wanted()) like.push_back(against.figures(like.size(), shown));
    };
  Sequence frames(loaded, std::move(rows), simulated, picture, sequence.truth, files, std::move(gaze));
  if (run.rtl) frames.rtl(run.replay, sequence.budget);
  else frames.model(run.out + "/kept", sequence.budget);
  const FrameTable& table = frames.finish(like);
  Json json = to_json(table);
  json["first_mismatch"] = frames.wrong();
  json["findings"] = to_json(loaded.told->all());
  write_text(run.out + "/frames.csv", frames_csv(table));
  write_text(run.out + "/sequence.json", json.dump(2) + "\n");
  const std::string viewed = viewer.write(run.out);
  if (run.page) {
    StudyPage page = study_page("Frames one after the other", run.command);
    page.lead(head_of(table));
    page.findings(loaded.told->all());
    page.section("Charts");
    page.charts(frame_charts(table));
    page.section("Figures");
    for (const Table& one : frame_tables(table, true)) page.table(one);
    write_page(run.out + "/sequence.html", page);
  }
  if (run.json) {
    fmt::print("{}\n", json.dump(2));
  } else {
    fmt::print(
        "{}  {}pictures and figures in {}: frames.csv, sequence.json\n{}", to_text(table),
        run.rtl ? fmt::format("every beat and every pixel of {} frames compared, twice; ", table.rows.size()) : "",
        run.out, viewed.empty() ? "" : "  " + viewed);
  }
  if (frames.wrong().is_null()) return kExitOk;
  std::fflush(stdout);  // a mismatch stands last
  fmt::print(stderr, "first mismatch, frame {}, {}\nreplay with waves: {}\n", frames.wrong()["frame"].get<size_t>(),
             frames.first()->line(), frames.wrong()["replay"].get<std::string>());
  return kExitDiffers;
}

}  // namespace pipegs
