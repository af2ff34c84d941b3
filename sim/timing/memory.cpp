// SPDX-License-Identifier: Apache-2.0
// memory.cpp: see memory.hpp.
#include "sim/timing/memory.hpp"

#include <bit>

#include "sim/timing/machine.hpp"

namespace pipegs::timing {

Memory::Memory(MemoryTiming& timing, const Config& config)
    : timing_(timing),
      units_(config.units),
      write_ports_(config.write_ports()),
      first_(((uint64_t{1} << write_ports_) - 1) | uint64_t{1} << node_port()),
      geometry_(((uint64_t{1} << units_) - 1) << write_ports_) {
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
  const uint64_t able = pause_ > 0 ? wanted_ & ~geometry_ : wanted_;
  if (pause_ > 0) --pause_;
  if (wanted_ == 0 && !out_valid_) return;

  bool free = !out_valid_;
  if (out_valid_ && timing_.offer(out_.write, out_.line, out_port_, out_.lines, out_.write ? 3 : out_.halves)) {
    const auto port = static_cast<size_t>(out_port_);
    if (out_.write) {
      written_[port] += static_cast<uint64_t>(std::popcount(static_cast<unsigned>(out_.halves)));
    } else {
      ++bursts_[port], read_[port] += out_.halves == 3 ? 2 * static_cast<uint64_t>(out_.lines) : 1;
    }
    machine.show(now, Border::kRequest, out_port_, shown_request(out_.line, out_.write, out_.lines));
    last_accepted_ = now;
    free = true;
    out_valid_ = false;
  }
  const uint64_t chosen = chosen_ == kNone ? 0 : uint64_t{1} << chosen_;
  const uint64_t others = able & ~chosen, first = others & first_, second = others & ~geometry_;
  const uint64_t requests = first != 0 ? first : second != 0 ? second : others;
  const bool served = (able & chosen) != 0, moves = !served || free;
  if (served && free) {
    out_valid_ = true;
    out_port_ = chosen_;
    out_ = request_[static_cast<size_t>(chosen_)];
    wanted_ &= ~chosen;
    if ((chosen & geometry_) != 0) pause_ = out_.lines - 1;
    granted_ = chosen_;
    grant_at_ = now;
    machine.wheel.wake_now(grant_unit_[static_cast<size_t>(chosen_)]);
  }
  if (requests != 0 && moves) chosen_ = arbiter_.port(requests);
  arbiter_.clock(requests, moves);
}

}  // namespace pipegs::timing
