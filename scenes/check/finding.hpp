// SPDX-License-Identifier: Apache-2.0
// finding: what is odd in a scene, in its cameras or in a frame, and how grave that is.
//
// Idea    Readers say what they mended or left out, check_scene() what the whole looks like, check_views() what a view
//         can show, check_packed() and check_frame() what a frame does: all in one list, so that a command line,
//         report.json and a page say the same.
// Terms   note: what was read is what was meant. warning: the picture may be wrong. error: nothing can be drawn.
// Rule    Each kind has a key, which stands in kFindingKinds and in the table of docs/your_scene.md (test `findings`).
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pipegs {

enum class Severity { kNote, kWarning, kError };

struct FindingKind {
  std::string_view key;
  Severity severity;
  bool told = true;            // by every command; otherwise only by `pipegs info`, because trained scenes are so
  bool shows_nothing = false;  // the reason of an empty frame
};

std::span<const FindingKind> finding_kinds();
std::string_view name_of(Severity severity);

struct Finding {
  // std::logic_error for a key that is none.
  Finding(std::string_view key, std::string what, std::size_t count = 0, std::size_t first = 0);

  const FindingKind* kind;
  std::string what;
  std::size_t count;  // of Gaussians; 0: it is not about single ones
  std::size_t first;  // index of the first such Gaussian
};
using Findings = std::vector<Finding>;

// "warning: non-finite values, culled: 3, first at index 17".
std::string finding_line(const Finding& finding);
nlohmann::ordered_json to_json(const Findings& findings);

}  // namespace pipegs
