// external_memory.hpp: the memory outside the chip, as lines of 64 bytes behind one port.
//
// Idea    Requests take effect in the order in which they are accepted; only the answers come later. Each line costs
//         64 / bytes_per_cycle cycles of the pins; a read answers after `latency` cycles plus a random jitter of up to
//         `jitter` cycles, never before an earlier read of the same tag. At most `queue` requests wait; then the port
//         is not ready. Bytes and requests are counted by tag.
// Units   Cycles of the machine's clock. Paper: Sec. 5.1 (off-chip memory).
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <queue>
#include <random>
#include <unordered_map>
#include <vector>

namespace pipegs {

using MemoryLine = std::array<uint32_t, 16>;

struct ExternalMemoryOptions {
  int latency = 100;             // cycles from acceptance to answer when nothing waits
  double bytes_per_cycle = 51.2;  // of the pins
  int jitter = 0;                // largest random delay added to an answer
  int queue = 64;                // requests that may wait for the pins
  uint64_t seed = 1;
};

class ExternalMemory {
 public:
  explicit ExternalMemory(const ExternalMemoryOptions& options = {});

  struct Answer {
    int tag;
    MemoryLine data;
  };
  struct Traffic {
    uint64_t lines_read = 0, lines_written = 0;
  };

  bool ready() const { return waiting_ < options_.queue; }           // may a request be accepted in this cycle
  void request(bool write, uint64_t address, int tag, const uint32_t* data);  // accepted in this cycle
  const Answer* answer() const;                                      // the answer shown in this cycle, if any
  void step();                                                       // the next cycle begins

  const MemoryLine& line(uint64_t address) const;  // contents, for host access; untouched lines hold zero
  MemoryLine& line(uint64_t address);
  const std::array<Traffic, 256>& traffic() const { return traffic_; }
  uint64_t busy_line_cycles() const { return lines_; }  // lines that crossed the pins

 private:
  struct Pending {
    double due;
    uint64_t order;
    Answer answer;
    bool operator>(const Pending& other) const { return due != other.due ? due > other.due : order > other.order; }
  };
  static constexpr uint64_t kPageLines = 4096;

  ExternalMemoryOptions options_;
  std::unordered_map<uint64_t, std::unique_ptr<std::array<MemoryLine, kPageLines>>> pages_;
  std::priority_queue<Pending, std::vector<Pending>, std::greater<>> pending_;
  std::array<double, 256> last_due_{};  // per tag: answers of one tag stay in order
  std::array<Traffic, 256> traffic_{};
  std::mt19937_64 rng_;
  double now_ = 0, pins_free_ = 0;
  int waiting_ = 0;
  uint64_t order_ = 0, lines_ = 0;
  std::deque<double> starts_;  // when each waiting request gets the pins
  mutable uint64_t cached_page_ = ~uint64_t{0};
  mutable std::array<MemoryLine, kPageLines>* cached_ = nullptr;
  std::optional<Answer> shown_;
};

}  // namespace pipegs
