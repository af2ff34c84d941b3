// SPDX-License-Identifier: Apache-2.0
// region_ports.hpp: sets of regions on the ports of a module.
#pragma once

#include "cpp_model/regions.hpp"
#include "verif/support/bench.hpp"

namespace pipegs {

template <class Port>
void write_regions(const Config& config, Port& port, const RegionSet& set) {
  std::vector<uint32_t> words(port_words<Port>() + 2);
  for (int part = 0; part < config.parts(); ++part)
    put_bits(words.data(), part * config.mask_w(), config.mask_w(), set.mask[static_cast<size_t>(part)]);
  write_port(port, words.data());
}

template <class Port>
RegionSet read_regions(const Config& config, const Port& port) {
  std::vector<uint32_t> words(port_words<Port>() + 2);
  read_port(port, words.data());
  RegionSet set;
  for (int part = 0; part < config.parts(); ++part)
    set.mask[static_cast<size_t>(part)] = get_bits(words.data(), part * config.mask_w(), config.mask_w());
  return set;
}

}  // namespace pipegs
