// SPDX-License-Identifier: Apache-2.0
// alpha_lines.hpp: lines of alphas for the tests of the RU: contents, the alpha stores that answer, and memory.
#pragma once

#include <algorithm>
#include <array>
#include <map>

#include "cpp_model/ru/ru_lanes.hpp"
#include "cpp_model/ru/ru_walk.hpp"
#include "verif/support/bench.hpp"

namespace pipegs {

using Codes = std::array<uint16_t, kRegionPixels>;

// A line with holes; `strength` 0 is faint, large values close pixels quickly.
inline Codes random_codes(const Config& config, std::mt19937_64& rng, int strength) {
  Codes codes;
  const uint32_t top = 1u << config.alpha_w;
  for (uint16_t& code : codes) {
    const uint32_t value = rng() % top;
    code = rng() % 4 == 0  ? 0
           : strength >= 2 ? std::min(value | (top / 2), top * 99 / 100)
           : strength == 1 ? value / 2
                           : value / 16;
  }
  return codes;
}

inline Words pack_codes(const Config& config, const Codes& codes) {
  Words words(2 * config.memory_w() / 32);
  for (int i = 0; i < kRegionPixels; ++i) put_bits(words.data(), i * config.alpha_w, config.alpha_w, codes[i]);
  return words;
}

inline void store_line(const Config& config, ExternalMemory& memory, uint64_t address, const Codes& codes) {
  const Words words = pack_codes(config, codes);
  for (int part = 0; part < config.alpha_memory_lines(); ++part) {
    std::copy_n(words.begin() + 16 * part, 16, memory.line(address + part).begin());
  }
}

// The alpha stores of all units: each answers two cycles after it took a request, and a line is read or skipped once.
template <class Dut>
class AlphaStores : public Endpoint {
 public:
  AlphaStores(Bench<Dut>& bench, const Config& config, Pace pace) : pace(pace), bench_(bench), config_(config) {
    bench.dut.read_ready_i = 0;
    bench.dut.answer_valid_i = 0;
    bench.add(*this);
  }
  void drive() override {
    auto& dut = bench_.dut;
    dut.read_ready_i = 0;
    for (int i = 0; i < config_.units; ++i) dut.read_ready_i |= goes(pace, bench_.rng) << i;
    dut.answer_valid_i = now_.asked ? 1 << now_.unit : 0;
    Words words(port_words<decltype(dut.answer_i)>() + 32);
    for (uint32_t& word : words) word = static_cast<uint32_t>(bench_.rng());
    for (int i = 0; now_.asked && i < kRegionPixels; ++i)
      put_bits(words.data(), now_.unit * config_.line_w() + i * config_.alpha_w, config_.alpha_w, now_.codes[i]);
    write_port(dut.answer_i, words.data());
  }
  void observe() override {
    auto& dut = bench_.dut;
    EXPECT_EQ(dut.read_valid_o & (dut.read_valid_o - 1), 0) << "two stores asked at once";
    now_ = next_;
    next_ = {};
    if ((dut.read_valid_o & dut.read_ready_i) == 0) return;
    next_.unit = std::countr_zero(static_cast<unsigned>(dut.read_valid_o));
    const auto codes = lines.find({next_.unit, dut.read_address_o});
    if (codes == lines.end()) {
      ADD_FAILURE() << "unit " << next_.unit << " has no line " << dut.read_address_o << ", cycle " << bench_.cycle;
      return;
    }
    next_.asked = !dut.read_skip_o;
    skipped += dut.read_skip_o;
    next_.codes = codes->second;
    lines.erase(codes);
  }

  std::map<std::pair<int, uint64_t>, Codes> lines;
  Pace pace;
  uint64_t skipped = 0;

 private:
  struct Read {
    bool asked = false;
    int unit = 0;
    Codes codes{};
  };
  Bench<Dut>& bench_;
  Config config_;
  Read now_, next_;  // what is answered in this cycle, and in the next one
};

}  // namespace pipegs
