// SPDX-License-Identifier: Apache-2.0
// axi_memory.cpp: see axi_memory.hpp.
#include "sim/memory/axi/axi_memory.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace pipegs {
namespace {

constexpr uint64_t kLineBytes = 64;

}  // namespace

AxiMemory::AxiMemory(const AxiMemoryOptions& options)
    : options_(options),
      rules_(options.data_w, options.most_reads, options.most_writes),
      timing_(options.timing, options.data_w, options.timing.write_latency),
      rng_(options.seed) {
  if (options.data_w != 128 && options.data_w != 256 && options.data_w != 512) {
    throw std::invalid_argument("AXI memory: the bus has 128, 256 or 512 bits");
  }
  if (options.base % kLineBytes != 0 || options.size % kLineBytes != 0 || options.ready_percent < 1) {
    throw std::invalid_argument("AXI memory: base and size are multiples of 64, ready_percent is above 0");
  }
}

AxiResponse AxiMemory::response(uint64_t line, int& fail) const {
  const uint64_t first = options_.base / kLineBytes;
  if (line < first || line - first >= options_.size / kLineBytes) return AxiResponse::kDecodeError;
  if (fail > 0) {
    --fail;
    return AxiResponse::kSlaveError;
  }
  return failing.contains(line) ? AxiResponse::kSlaveError : AxiResponse::kOkay;
}

// --- what the manager asks for ---------------------------------------------------------------------------------------
void AxiMemory::observe(const AxiManagerSide& manager) {
  rules_.check(manager, shown_);
  if (manager.ar.valid && shown_.ar_ready) take_read(manager.ar);
  if (manager.aw.valid && shown_.aw_ready) address_.push_back(manager.aw);
  if (manager.w.valid && shown_.w_ready) data_.push_back(manager.w);
  take_write();
  if (!options_.harsh) {
    const std::optional<AxiLine> taken =
        timing_.end(manager.r_ready && shown_.r.valid, manager.b_ready && shown_.b.valid);
    if (taken) take(*taken);
  }
  if (manager.r_ready) shown_.r.valid = false;
  if (manager.b_ready) shown_.b.valid = false;
}

void AxiMemory::take_read(const AxiAddress& address) {
  const uint64_t bytes = (static_cast<uint64_t>(address.length) + 1) << address.size;
  const bool half = bytes == kLineBytes / 2 && address.address % bytes == 0;
  if (!half && (address.address % kLineBytes != 0 || bytes % kLineBytes != 0)) {
    throw std::runtime_error("AXI memory: a burst that is neither lines of 64 bytes nor half of one");
  }
  const uint64_t lines = half ? 1 : bytes / kLineBytes;
  const int halves = !half ? 3 : address.address % kLineBytes == 0 ? 1 : 2;
  const bool sampled = options_.harsh && rng_() % 2 == 0;
  Reads& reads = reads_[address.id];
  ++bursts_;
  for (uint64_t i = 0; i < lines; ++i) {
    const uint64_t line = address.address / kLineBytes + i;
    const bool last = i + 1 == lines;
    reads.lines.push_back({line, {}, last, false, response(line, fail_reads), halves});
    if (sampled) sample(reads.lines.back());
  }
  if (!options_.harsh) timing_.read(address.address / kLineBytes, static_cast<int>(lines), address.id, halves);
  if (options_.harsh) {
    reads.due.push_back(now_ + 1 + static_cast<int64_t>(rng_() % static_cast<uint64_t>(options_.read_delay)));
  }
  lines_read_ += lines;
}

void AxiMemory::sample(Line& line) {
  line.sampled = true;
  if (line.response != AxiResponse::kDecodeError) line.data = pages_.line(line.address);
}

// A write is complete when its address and all its beats are here.
void AxiMemory::take_write() {
  const size_t words = static_cast<size_t>(options_.data_w) / 32;
  while (!address_.empty() && data_.size() > static_cast<size_t>(address_.front().length)) {
    const AxiAddress address = address_.front();
    const size_t beats = static_cast<size_t>(address.length) + 1;
    if (address.address % kLineBytes != 0 || beats * words != 16) {
      throw std::runtime_error("AXI memory: a write that is not one line of 64 bytes");
    }
    const uint64_t half = static_cast<uint64_t>(options_.write_delay) / 2;
    const uint64_t line = address.address / kLineBytes;
    Write write{address.id, line, {}, {}, 0, false, response(line, fail_writes)};
    write.due = now_ + 1 + static_cast<int64_t>(half + rng_() % (half + 1));
    for (size_t i = 0; i < 16; ++i) {
      const AxiWriteBeat& beat = data_[i / words];
      write.data[i] = beat.data[i % words];
      for (size_t byte = 0; byte < 4; ++byte) {
        if ((beat.strobes >> (4 * (i % words) + byte)) & 1) write.mask[i] |= 0xffu << (8 * byte);
      }
    }
    data_.erase(data_.begin(), data_.begin() + static_cast<std::ptrdiff_t>(beats));
    address_.pop_front();
    if (!options_.harsh) timing_.write(write.address, write.id);
    writes_.push_back(write);
    ++lines_written_;
  }
}

void AxiMemory::apply(Write& write) {
  write.applied = true;
  if (write.response != AxiResponse::kOkay) return;
  MemoryLine& line = pages_.line(write.address);
  for (size_t i = 0; i < line.size(); ++i) line[i] = (line[i] & ~write.mask[i]) | (write.data[i] & write.mask[i]);
}

// The timing takes a line: what is in memory now is what counts.
void AxiMemory::take(const AxiLine& line) {
  if (line.write) {
    apply(*std::find_if(writes_.begin(), writes_.end(), [](const Write& w) { return !w.applied; }));
    return;
  }
  std::deque<Line>& lines = reads_[line.id].lines;
  sample(*std::find_if(lines.begin(), lines.end(), [](const Line& l) { return !l.sampled; }));
}

// --- what it answers -------------------------------------------------------------------------------------------------
const AxiSubordinateSide& AxiMemory::step() {
  ++now_;
  if (options_.harsh) {
    step_harsh();
  } else {
    step_timed();
  }
  shown_.ar_ready = shown_.ar_ready && !silence.ar;
  shown_.aw_ready = shown_.aw_ready && !silence.aw;
  shown_.w_ready = shown_.w_ready && !silence.w;
  return shown_;
}

void AxiMemory::show_beat(uint32_t id) {
  const auto found = reads_.find(id);
  Reads& reads = found->second;
  Line& line = reads.lines.front();
  const size_t words = static_cast<size_t>(options_.data_w) / 32;
  if (!line.sampled && reads.beat == 0) sample(line);
  // Half a line is as many beats less, or, on a bus as wide as a line, one of which the other half is noise.
  const size_t all = line.data.size(), from = line.halves == 2 && words < all ? all / 2 : 0,
               until = line.halves == 1 && words < all ? all / 2 : all,
               at = from + static_cast<size_t>(reads.beat) * words;
  const auto first = line.data.begin() + static_cast<std::ptrdiff_t>(at);
  const bool ends = at + words == until;
  shown_.r.valid = true;
  shown_.r.id = id;
  shown_.r.response = line.response;
  shown_.r.last = ends && line.last;
  std::copy(first, first + static_cast<std::ptrdiff_t>(words), shown_.r.data.begin());
  if (line.halves != 3 && words == all)
    std::fill_n(shown_.r.data.begin() + (line.halves == 1 ? 8 : 0), 8, static_cast<uint32_t>(rng_()));
  reads.beat = ends ? 0 : reads.beat + 1;
  if (!ends) return;
  const bool last = line.last;
  reads.lines.pop_front();
  if (!last) return;
  --bursts_;
  if (options_.harsh) reads.due.pop_front();
  if (reads.lines.empty()) reads_.erase(found);
}

void AxiMemory::show_answer(uint32_t id, AxiResponse response) {
  shown_.b.valid = true;
  shown_.b.id = id;
  shown_.b.response = response;
}

void AxiMemory::step_harsh() {
  shown_.ar_ready = chance();
  shown_.aw_ready = chance() && address_.size() < 4;
  shown_.w_ready = chance() && data_.size() < 16;
  if (!shown_.r.valid && !silence.r && chance()) {
    std::vector<uint32_t> due;
    for (const auto& [id, reads] : reads_) {
      if (reads.due.front() <= now_) due.push_back(id);
    }
    if (!due.empty()) show_beat(due[rng_() % due.size()]);
  }
  // Writes of one ID are applied and answered in their order; of several IDs each for itself.
  std::set<uint32_t> waiting;
  for (Write& write : writes_) {
    if (!write.applied && (write.due > now_ || waiting.contains(write.id))) waiting.insert(write.id);
    if (!write.applied && !waiting.contains(write.id)) apply(write);
  }
  if (shown_.b.valid || silence.b || !chance()) return;
  std::set<uint32_t> seen;
  for (auto write = writes_.begin(); write != writes_.end(); ++write) {
    if (!seen.insert(write->id).second || !write->applied || !chance()) continue;
    show_answer(write->id, write->response);
    writes_.erase(write);
    return;
  }
}

void AxiMemory::step_timed() {
  timing_.step();
  shown_.ar_ready = shown_.aw_ready = shown_.w_ready = timing_.ready();
  if (!shown_.r.valid && !silence.r && timing_.beat()) show_beat(timing_.beat_line().id);
  if (!shown_.b.valid && !silence.b && timing_.answer()) {
    show_answer(writes_.front().id, writes_.front().response);
    writes_.pop_front();
  }
}

}  // namespace pipegs
