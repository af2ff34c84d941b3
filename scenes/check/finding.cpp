// SPDX-License-Identifier: Apache-2.0
// finding: see finding.hpp.
#include "scenes/check/finding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "scenes/text/quote.hpp"

namespace pipegs {
namespace {

constexpr Severity kNote = Severity::kNote, kWarning = Severity::kWarning, kError = Severity::kError;

constexpr bool kTold = true, kOnlyInfo = false, kShowsNothing = true;

constexpr std::array kFindingKinds = {
    // A scene as a whole.
    FindingKind{"non_finite", kWarning}, FindingKind{"zero_rotation", kWarning},
    FindingKind{"no_gaussian", kWarning, kTold, kShowsNothing},
    FindingKind{"nothing_usable", kError, kTold, kShowsNothing}, FindingKind{"rotation_length", kNote, kOnlyInfo},
    FindingKind{"faint", kNote, kOnlyInfo}, FindingKind{"needle", kNote, kOnlyInfo},
    FindingKind{"large", kNote, kOnlyInfo}, FindingKind{"all_faint", kWarning, kTold, kShowsNothing},
    FindingKind{"scale_form", kWarning}, FindingKind{"opacity_form", kWarning}, FindingKind{"color_form", kWarning},
    FindingKind{"rotation_form", kWarning}, FindingKind{"far_away", kWarning},
    // What its reader has mended or left out.
    FindingKind{"axes_unknown", kNote, kOnlyInfo}, FindingKind{"origin", kNote}, FindingKind{"rgb_colors", kNote},
    FindingKind{"opacity_codes", kNote}, FindingKind{"one_scale", kNote}, FindingKind{"other_names", kNote},
    FindingKind{"not_read", kWarning}, FindingKind{"other_elements", kNote}, FindingKind{"filter_3d", kNote},
    FindingKind{"sh_degree", kNote}, FindingKind{"behind_end", kNote}, FindingKind{"gzip_missing", kNote},
    FindingKind{"gzip_around", kNote}, FindingKind{"zip_around", kNote}, FindingKind{"guessed", kWarning},
    FindingKind{"lossy_texture", kWarning}, FindingKind{"log_scales", kNote}, FindingKind{"logit_opacities", kNote},
    FindingKind{"linear_colors", kNote}, FindingKind{"no_scene", kNote},
    // A view, a frame.
    FindingKind{"empty_view", kWarning, kTold, kShowsNothing}, FindingKind{"near_plane", kWarning},
    FindingKind{"empty_frame", kWarning}, FindingKind{"left_out", kWarning},
    // Cameras.
    FindingKind{"applied_scale", kNote}, FindingKind{"nerfstudio_export", kNote}, FindingKind{"exported_poses", kNote},
    FindingKind{"camera_folder", kNote}, FindingKind{"unused_lens", kNote}, FindingKind{"no_2d_points", kNote},
    FindingKind{"backslashes", kNote}, FindingKind{"whole_paths", kNote}, FindingKind{"ply_points", kNote},
    FindingKind{"other_ending", kNote}, FindingKind{"test_list", kNote},
    // Photographs.
    FindingKind{"turned_photographs", kNote}, FindingKind{"unturned_photographs", kNote},
    FindingKind{"resized_photographs", kNote}, FindingKind{"converted_photographs", kNote},
    FindingKind{"deep_photographs", kNote}, FindingKind{"gamma_photographs", kNote},
    FindingKind{"profiled_photographs", kNote}, FindingKind{"more_photographs", kNote},
    FindingKind{"near_chosen", kNote},
    // What is written.
    FindingKind{"not_written", kNote}};

}  // namespace

std::span<const FindingKind> finding_kinds() { return kFindingKinds; }

std::string_view name_of(Severity severity) {
  return severity == kNote ? "note" : severity == kWarning ? "warning" : "error";
}

Finding::Finding(std::string_view key, std::string text, std::size_t how_many, std::size_t first_index)
    : kind(std::find_if(kFindingKinds.begin(), kFindingKinds.end(),
                        [&](const FindingKind& known) { return known.key == key; })),
      what(one_line(std::move(text))),
      count(how_many),
      first(first_index) {
  if (kind == kFindingKinds.end()) throw std::logic_error(fmt::format("no kind of finding is '{}'", key));
}

std::string finding_line(const Finding& finding) {
  std::string line = fmt::format("{}: {}", name_of(finding.kind->severity), finding.what);
  if (finding.count > 0) line += fmt::format(": {}, first at index {}", finding.count, finding.first);
  return line;
}

nlohmann::ordered_json to_json(const Findings& findings) {
  auto json = nlohmann::ordered_json::array();
  for (const Finding& f : findings) {
    json.push_back({{"key", f.kind->key}, {"severity", name_of(f.kind->severity)}, {"what", f.what}});
    if (f.count > 0) json.back().update({{"count", f.count}, {"first", f.first}});
  }
  return json;
}

}  // namespace pipegs
