// SPDX-License-Identifier: Apache-2.0
// views.cpp: see views.hpp.
#include "sim/command/frame/views.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "sim/rtl/rtl_fault.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

// Cycles from the end of the frame before, or from the start, to the end of each.
std::vector<uint64_t> cycles_of(const RtlResult& rtl) {
  std::vector<uint64_t> cycles;
  uint64_t before = 0;
  for (const uint64_t end : rtl.frame_ends) {
    cycles.push_back(end - before);
    before = end;
  }
  return cycles;
}

// The gap in front of a frame; the first one has none.
std::string gap_of(const Json& one, const char* run) {
  return one.contains(run) ? fmt::to_string(one[run].get<uint64_t>()) : "";
}

std::string text_of(const Json& report) {
  std::string text =
      fmt::format("{:>6}  {:<20} {:>12} {:>12} {:>12} {:>12}\n", "view", "camera", "queued", "gap", "alone", "gap");
  for (const Json& one : report["views"]) {
    text += fmt::format("{:>6}  {:<20.20} {:>12} {:>12} {:>12} {:>12}\n", one["view"].get<int>(),
                        one["camera"].get<std::string>(), one["cycles_queued"].get<uint64_t>(),
                        gap_of(one, "gap_queued"), one["cycles_alone"].get<uint64_t>(), gap_of(one, "gap_alone"));
  }
  const auto queued = report["cycles_queued"].get<uint64_t>(), alone = report["cycles_alone"].get<uint64_t>();
  return text + fmt::format("{:>6}  {:<20} {:>12} {:>12} {:>12} {:>12}  cycles; queued saves {:.1f} %\n", "all", "",
                            queued, "", alone, "",
                            100 - 100 * static_cast<double>(queued) / static_cast<double>(alone));
}

}  // namespace

int simulate_views(const ViewArguments& view, const ViewsArguments& views, const SimulateOptions& options) {
  ViewArguments last = view;
  last.view = views.last;
  const LoadedView loaded = load_view(last);  // refuses a view that is not there
  SimulateOptions run = options;
  follow_scene(loaded.scene, run);
  const std::vector<Camera> cameras(loaded.cameras.begin() + views.first, loaded.cameras.begin() + views.last + 1);
  const PixelBytes held = kGoldenPixels + kRtlPixels;
  for (const Camera& camera : cameras)
    check_picture_memory(camera, run, {held.frame * cameras.size(), held.asked * cameras.size() + kWritePixels.asked});

  const PackedScene packed = pack_views(loaded.scene, cameras, run);
  std::vector<std::unique_ptr<Simulation>> simulations;
  std::vector<Simulation*> frames;
  for (const Camera& camera : cameras) {
    frames.push_back(simulations.emplace_back(std::make_unique<Simulation>()).get());
    simulate_frame(packed, camera, run, *frames.back());
    simulate_golden(*frames.back());
  }

  Json report = {{"scene", loaded.scene.name}, {"configuration", config_difference(run.config)}};
  for (size_t i = 0; i < frames.size(); ++i) {
    report["views"].push_back({{"view", views.first + static_cast<int>(i)},
                               {"camera", cameras[i].name},
                               {"width", cameras[i].width},
                               {"height", cameras[i].height},
                               {"mismatches", 0}});
  }
  std::string wrong;
  for (const bool queued : {true, false}) {
    run.rtl.queued = queued;
    if (!queued) run.rtl.waves.clear();  // of one of the runs
    SequenceRun sequence;
    try {
      sequence = simulate_sequence(run, frames);
    } catch (const RtlFault&) {
      fmt::print(stderr, "replay with waves: {}\n", views.replay);
      throw;
    }
    const std::vector<uint64_t> cycles = cycles_of(sequence.rtl);
    for (size_t i = 0; i < frames.size(); ++i) {
      Json& one = report["views"][i];
      one[queued ? "cycles_queued" : "cycles_alone"] = cycles[i];
      if (i > 0 && run.config.taps) one[queued ? "gap_queued" : "gap_alone"] = sequence.rtl.frame_gaps.at(i - 1);
      one["mismatches"] = one["mismatches"].get<uint64_t>() + frames[i]->mismatches;
      if (!wrong.empty() || frames[i]->mismatches == 0) continue;
      wrong = fmt::format("first mismatch, view {}, window {},{}: {}\nreplay with waves: {}\n",
                          views.first + static_cast<int>(i), frames[i]->first_mismatch->window_x,
                          frames[i]->first_mismatch->window_y, frames[i]->first_mismatch->what, views.replay);
    }
    report[queued ? "cycles_queued" : "cycles_alone"] = sequence.rtl.frame_ends.back();
  }

  for (size_t i = 0; i < frames.size(); ++i)
    write_images(fmt::format("{}/view_{}", views.out, views.first + static_cast<int>(i)),
                 crop_window(frames[i]->golden.image, run), frames[i]->picture);
  write_text(views.out + "/sequence.json", report.dump(2) + "\n");
  if (views.json) {
    fmt::print("{}\n", report.dump(2));
  } else {
    fmt::print("{}  every beat and every pixel of {} frames compared, twice; pictures and figures in {}\n",
               text_of(report), frames.size(), views.out);
  }
  fmt::print(stderr, "{}", wrong);
  return wrong.empty() ? kExitOk : kExitDiffers;
}

}  // namespace pipegs
