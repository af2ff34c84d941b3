// SPDX-License-Identifier: Apache-2.0
// bus_timing.cpp: see bus_timing.hpp.
#include "sim/memory/axi/bus_timing.hpp"

namespace pipegs {

BusTiming::BusTiming(const ExternalMemoryOptions& options, const Config& config)
    : axi_(options, config.bus_w, options.write_latency),
      write_ports_(config.write_ports()),
      beats_(512 / config.bus_w) {}

int BusTiming::step() {
  clock();
  const int answer = line_tag_;

  axi_.step();
  ar_ready_ = aw_ready_ = w_ready_ = axi_.ready();
  b_taken_ = axi_.answer() && writes_.valid;
  line_ = axi_.beat() && axi_.line_ends() ? static_cast<int>(axi_.beat_line().id) : kNoAnswer;
  read_ends_ = line_ != kNoAnswer && axi_.beat_line().last;
  if (ar_valid_ && ar_ready_) axi_.read(ar_.line, ar_.lines, static_cast<uint32_t>(ar_.tag), ar_.halves);
  if (aw_valid_ && aw_ready_) addresses_.push_back(aw_line_);
  if (w_valid_ && w_ready_ && last_beat()) ++data_;
  for (; data_ > 0 && !addresses_.empty(); --data_, addresses_.pop_front()) axi_.write(addresses_.front(), 0);
  axi_.end(true, writes_.valid);
  return answer;
}

bool BusTiming::due() const {
  if (!waiting_.valid || passing_) return false;
  // Writes accepted since it came, as a stamp counts them.
  const uint64_t since = (stamp_ - fenced_.front().stamp) % (4 * 2 * Config::bus_writes());
  return leaving_ || since >= static_cast<uint64_t>(writes_.count());
}

bool BusTiming::offer(bool write, uint64_t line, int tag, int lines, int halves) {
  offered_ = true;
  offered_write_ = write;
  offer_ = {.line = line, .tag = tag, .lines = lines, .halves = halves, .stamp = stamp_};
  if (write) {
    accepted_ = writes_.count() < Config::bus_writes() && address_free() && data_free();
    return accepted_;
  }
  accepted_ =
      reads_ < Config::bus_reads() && (passes(tag) ? read_free() && !due() : waiting_.count() < Config::bus_fenced());
  return accepted_;
}

void BusTiming::clock() {
  line_tag_ = line_;
  if (!offered_ && !read_ends_ && !ar_valid_ && !aw_valid_ && !w_valid_ && writes_.count() + waiting_.count() == 0)
    return;
  const bool free = read_free(), leaves = due();
  const bool reads = offered_ && !offered_write_ && reads_ < Config::bus_reads();
  const bool passing = reads && passes(offer_.tag) && !leaves;
  const bool write = offered_ && offered_write_ && accepted_;
  const bool waits = reads && !passes(offer_.tag) && accepted_;

  // Reads.
  reads_ += (offered_ && !offered_write_ && accepted_) - read_ends_;
  if (free) {
    ar_valid_ = leaves || passing;
    if (ar_valid_) ar_ = leaves ? fenced_.front() : offer_;
    if (leaves) fenced_.pop_front();
  }
  if (waits) fenced_.push_back(offer_);
  waiting_.clock(waits, free && leaves);
  passing_ = passing && !free;
  leaving_ = leaves && !free;

  // Writes.
  if (address_free()) aw_valid_ = write;
  if (data_free()) {
    w_valid_ = write;
    w_beat_ = 0;
  } else if (w_ready_) {
    ++w_beat_;
  }
  if (write) {
    aw_line_ = offer_.line;
    ++stamp_;
  }
  writes_.clock(write, b_taken_);

  offered_ = accepted_ = false;
}

std::unique_ptr<MemoryTiming> machine_memory_timing(const ExternalMemoryOptions& options, const Config& config) {
  if (config.bus_w == 0) return memory_timing(options);
  return std::make_unique<BusTiming>(options, config);
}

}  // namespace pipegs
