// SPDX-License-Identifier: Apache-2.0
// train_report.hpp: what `pipegs train` says at its end, for people and as train.json.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "sim/layers/cldr.hpp"
#include "sim/studies/train/run/evaluate.hpp"
#include "sim/studies/train/run/trainer.hpp"

namespace pipegs {

// On the views held out, and on some others behind them: by the truth in both orders, and as the machines draw them.
struct TrainQuality {
  std::vector<Likeness> exact, layered;
  std::vector<MachineViews> machines;
  Margin margin;  // of the grid of the layered order
};

struct TrainReport {
  std::string input;
  int downscale = 1;
  std::size_t trained = 0, held_out = 0;  // views
  std::vector<std::string> measured;      // names of cameras: those held out, and behind them others
  int layers = 0;                         // cells per axis of the layered order that was measured
  std::optional<TrainQuality> before;     // of the scene that was fine-tuned
  TrainQuality after;
};

nlohmann::ordered_json train_json(const TrainOptions& options, const TrainState& state, const TrainReport& report);
std::string train_text(const TrainState& state, const TrainReport& report);

}  // namespace pipegs
