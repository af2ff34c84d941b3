// SPDX-License-Identifier: Apache-2.0
// parallel: see parallel.hpp.
//
// Idea    The calling thread works too; one item or one thread starts no thread at all.
#include "cpp_model/float/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace pipegs {
namespace {

unsigned most = 0;  // 0: as many as the machine has

}  // namespace

void most_threads(unsigned threads) { most = threads; }

void parallel_for(std::size_t items, unsigned threads, const std::function<void(std::size_t)>& work) {
  if (threads == 0) threads = most > 0 ? most : std::max(1u, std::thread::hardware_concurrency());
  threads = static_cast<unsigned>(std::min<std::size_t>(threads, items));
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto worker = [&] {
    for (std::size_t i = next++; i < items; i = next++) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
        next = items;
      }
    }
  };
  std::vector<std::jthread> pool;
  for (unsigned t = 1; t < threads; ++t) pool.emplace_back(worker);
  worker();
  pool.clear();  // joins
  if (failure) std::rethrow_exception(failure);
}

}  // namespace pipegs
