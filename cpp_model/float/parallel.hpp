// SPDX-License-Identifier: Apache-2.0
// parallel: a loop over independent items on a few threads.
//
// Idea    Threads take the next item from one atomic counter, so uneven tiles balance themselves.
//         Items must not share what they write: then the result does not depend on the threads.
// Rule    The first exception of an item stops the loop and is thrown again in the caller.
#pragma once

#include <cstddef>
#include <functional>

namespace pipegs {

// threads = 0: as many as the machine has, or as most_threads says.
void parallel_for(std::size_t items, unsigned threads, const std::function<void(std::size_t)>& work);

// For a process that shares its machine with others of its kind, one a core; call it before any loop.
void most_threads(unsigned threads);

}  // namespace pipegs
