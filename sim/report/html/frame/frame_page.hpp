// SPDX-License-Identifier: Apache-2.0
// frame_page.hpp: a simulated frame as one HTML page: pictures against each other, maps over them, where each cycle
// went, the timeline of all units.
//
// Units   Pictures are 8 bits a channel, as frame.png. Errors are of channels of 0 to 1, the largest of a pixel's.
#pragma once

#include <optional>
#include <string>

#include "scenes/camera.hpp"
#include "sim/compare/simulate.hpp"
#include "sim/report/html/document.hpp"
#include "sim/report/html/frame/frame_record.hpp"

namespace pipegs {

struct FramePage {
  std::string title = {}, command = {};
  std::string explain = {};  // command line of `pipegs explain` up to the pixel
  Rgb8 picture;              // of the machine
  nlohmann::ordered_json report;
  std::optional<Rgb8> against = {};  // a photograph or any image of the same size
  std::string against_name = {};
  const FrameRecord* record = nullptr;  // without RTL none
};

HtmlDocument frame_document(const FramePage& page, const Simulation& simulation, const SimulateOptions& options);

// What bounds the frame, and what each kind of unit does with its cycles: a sentence each, from report.json.
nlohmann::ordered_json frame_sentences(const nlohmann::ordered_json& report);

}  // namespace pipegs
