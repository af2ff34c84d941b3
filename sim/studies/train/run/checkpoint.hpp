// SPDX-License-Identifier: Apache-2.0
// checkpoint: a TrainState in a file, from which a run goes on as if it had never stopped.
//
// Layout  "PIPEGSCK", a version, the mark of the run, then the fields of the state, arrays with their
//         lengths before them, all little-endian; at the end the CRC-32 of all before it.
// Rule    Written aside and renamed: a run that is killed, or finds the disk full, leaves the one before. Read whole or
//         not at all: one that is cut, changed, of another run, or holds what is no number is refused.
// Mark    A number that two runs share only if they train the same with the same options.
// Errors  InputError when it is read, OwnFailure when it cannot be written.
#pragma once

#include <cstdint>
#include <filesystem>

#include "sim/studies/train/run/trainer.hpp"

namespace pipegs {

// Of what a run depends on: its options, its views, the parameters with which it begins.
std::uint64_t run_mark(const TrainOptions& options, const TrainingViews& views, const Parameters& start);

void write_checkpoint(const std::filesystem::path& path, std::uint64_t mark, const TrainState& state);
TrainState read_checkpoint(const std::filesystem::path& path, std::uint64_t mark);

}  // namespace pipegs
