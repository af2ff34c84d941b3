// SPDX-License-Identifier: Apache-2.0
// job.cpp: see job.hpp.
#include "sim/rtl/job.hpp"

#include <vector>

#include "cpp_model/control/registers.hpp"

namespace pipegs {

pipegs_job frame_job(const Config& config, const Frame& frame, const Areas& areas, const Picture& picture) {
  std::vector<uint32_t> bits(record_words<Frame>(config) + 1);
  pack(config, frame, bits.data());
  pipegs_job job{};
  uint64_t* slot = reinterpret_cast<uint64_t*>(&job.frame);  // its members are the slots in their order
  int at = 0;
  for (const Slot& field : register_map(config).block("frame").slots) {
    uint64_t value = field.width == 0 ? 0 : get_bits(bits.data(), at, field.width);
    if (field.is_signed && value >> (field.width - 1) & 1) value |= ~uint64_t{0} << (field.width - 1);
    *slot++ = value << field.shift;
    at += field.width;
  }
  // Lines to bytes.
  job.areas = {areas.cells << 6,  areas.groups << 6, areas.chunks << 6,  areas.gaussians << 6,
               areas.colors << 6, areas.pixels << 6, areas.overflow << 6};
  job.picture = {picture.format, picture.base << 6, picture.stride << 6};
  return job;
}

Frame job_frame(const Config& config, const pipegs_job& job) {
  std::vector<uint32_t> bits(record_words<Frame>(config) + 1);
  const uint64_t* slot = reinterpret_cast<const uint64_t*>(&job.frame);
  int at = 0;
  for (const Slot& field : register_map(config).block("frame").slots) {
    if (field.width > 0)
      put_bits(bits.data(), at, field.width, (*slot >> field.shift) & (~uint64_t{0} >> (64 - field.width)));
    ++slot;
    at += field.width;
  }
  return unpack<Frame>(config, bits.data());
}

}  // namespace pipegs
