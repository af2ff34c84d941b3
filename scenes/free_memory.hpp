// SPDX-License-Identifier: Apache-2.0
// free_memory: what the computer has free, and whether a scene fits into it before a byte of it is taken.
#pragma once

#include <cstdint>

namespace pipegs {

// Bytes that may still be taken: of the computer, the container and the limit of this process (ulimit -v).
std::uint64_t free_memory();

// Of so many Gaussians and their coefficients.
std::uint64_t scene_bytes(std::uint64_t gaussians, int sh_degree);
// InputError unless they fit.
void check_scene_memory(std::uint64_t gaussians, int sh_degree);

}  // namespace pipegs
