// SPDX-License-Identifier: Apache-2.0
// memory.cpp: see memory.hpp.
#include "sim/timing/memory.hpp"

#include "sim/timing/machine.hpp"

namespace pipegs::timing {

Memory::Memory(MemoryTiming& timing, const Config& config)
    : timing_(timing),
      units_(config.units),
      write_ports_(config.write_ports()),
      first_(((uint32_t{1} << write_ports_) - 1) | uint32_t{1} << node_port()) {
  const auto set = [this](int port, int grant, int answer) {
    grant_unit_[static_cast<size_t>(port)] = static_cast<uint8_t>(grant);
    answer_unit_[static_cast<size_t>(port)] = static_cast<uint8_t>(answer);
  };
  for (int k = 0; k < units_; ++k) {
    set(alpha_port(k), unit(kRows, k), unit(kRows, k));
    set(sort_port(k), unit(kSu, k), unit(kSu, k));
    set(raster_port(k), unit(kSource, k), unit(kSource, k));  // the source wakes kRuMemory
    set(geometry_port(k), unit(kReader, k), unit(kReader, k));
    const int color = unit(config.has_lists() ? kListColor : kColor, k);
    set(color_port(k), color, color);
  }
  if (config.has_lists()) set(list_port(), unit(kLists), unit(kLists));
  set(node_port(), unit(kDopu), unit(kDopu));
}

void Memory::step(Machine& machine, Cycle now) {
  answered_ = coming_;
  coming_ = timing_.step();
  if (answered_ >= 0) machine.wheel.wake_now(answer_unit_[static_cast<size_t>(answered_)]);
  if (wanted_ == 0 && !out_valid_) return;

  bool free = !out_valid_;
  if (out_valid_ && timing_.offer(out_write_, out_line_, out_port_)) {
    if (out_write_) {
      written_[static_cast<size_t>(out_port_)] += static_cast<uint64_t>(out_halves_);
    } else {
      ++read_[static_cast<size_t>(out_port_)];
    }
    machine.show(now, Border::kRequest, out_port_, shown_request(out_line_, out_write_));
    last_accepted_ = now;
    free = true;
    out_valid_ = false;
  }
  const uint32_t chosen = chosen_ == kNone ? 0 : uint32_t{1} << chosen_;
  const uint32_t others = wanted_ & ~chosen, first = others & first_, requests = first != 0 ? first : others;
  const bool served = (wanted_ & chosen) != 0, moves = !served || free;
  if (served && free) {
    out_valid_ = true;
    out_port_ = chosen_;
    out_write_ = write_[static_cast<size_t>(chosen_)];
    out_halves_ = halves_[static_cast<size_t>(chosen_)];
    out_line_ = line_[static_cast<size_t>(chosen_)];
    wanted_ &= ~chosen;
    granted_ = chosen_;
    grant_at_ = now;
    machine.wheel.wake_now(grant_unit_[static_cast<size_t>(chosen_)]);
  }
  if (requests == 0) {
    locked_ = false;
    return;
  }
  const int port = locked_ && (requests >> shown_ & 1) != 0 ? shown_ : round_robin(requests, last_);
  if (moves) chosen_ = last_ = port;
  locked_ = !moves;
  shown_ = port;
}

}  // namespace pipegs::timing
