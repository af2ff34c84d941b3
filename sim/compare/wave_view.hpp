// SPDX-License-Identifier: Apache-2.0
// wave_view.hpp: a save file for GTKWave beside waves of pipegs_sim: the clock and the streams that are compared,
// stream by stream, with the marker where to look.
//
// Idea    The names are those of the waves: only what a machine has is in its view.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace pipegs {

// `waves` with .gtkw in place of its end; `marker` is a time of the waves.
void write_wave_view(const std::filesystem::path& waves, std::optional<int64_t> marker);

}  // namespace pipegs
