// SPDX-License-Identifier: Apache-2.0
// train_report.hpp: what `pipegs train` says at its end, for people and as train.json.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "sim/train/run/evaluate.hpp"
#include "sim/train/run/trainer.hpp"

namespace pipegs {

// On the held-out views, in both orders.
struct TrainQuality {
  Likeness exact, layered;
};

struct TrainReport {
  std::string input;
  int downscale = 1;
  std::size_t trained = 0, held_out = 0;  // views
  int layers = 0;                         // cells per axis of the layered order that was measured
  std::optional<TrainQuality> before;     // of the scene that was fine-tuned
  TrainQuality after;
};

nlohmann::ordered_json train_json(const TrainOptions& options, const TrainState& state, const TrainReport& report);
std::string train_text(const TrainState& state, const TrainReport& report);

}  // namespace pipegs
