// SPDX-License-Identifier: Apache-2.0
// job.cpp: see job.hpp.
#include "cpp_model/control/job.hpp"

#include <vector>

namespace pipegs {
namespace {

// The words of the slots as the fields of a record.
class SlotReader final : public FieldVisitor {
 public:
  SlotReader(const std::vector<Slot>& slots, const uint64_t* words) : slots_(slots), words_(words) {}
  void visit(const FieldName&, uint64_t& value, int, bool is_signed) override {
    const int shift = slots_[at_].shift;
    value = is_signed ? static_cast<uint64_t>(static_cast<int64_t>(words_[at_]) >> shift) : words_[at_] >> shift;
    ++at_;
  }

 private:
  const std::vector<Slot>& slots_;
  const uint64_t* words_;
  size_t at_ = 0;
};

// And the fields, which have their sign in all bits above them, as words.
class SlotWriter final : public FieldVisitor {
 public:
  SlotWriter(const std::vector<Slot>& slots, uint64_t* words) : slots_(slots), words_(words) {}
  void visit(const FieldName&, uint64_t& value, int, bool) override {
    words_[at_] = value << slots_[at_].shift;
    ++at_;
  }

 private:
  const std::vector<Slot>& slots_;
  uint64_t* words_;
  size_t at_ = 0;
};

}  // namespace

const RegisterMap& registers_of(const Config& config) {
  thread_local Config known;
  thread_local RegisterMap map = register_map(known);
  if (!(known == config)) {
    map = register_map(config);
    known = config;
  }
  return map;
}

pipegs_job frame_job(const Config& config, const Frame& frame, const Areas& areas, const Picture& picture) {
  pipegs_job job{};
  Frame fields = frame;
  SlotWriter writer(registers_of(config).block("frame").slots, reinterpret_cast<uint64_t*>(&job.frame));
  visit_fields(config, fields, writer);
  // Lines to bytes.
  job.areas = {areas.cells << 6,  areas.groups << 6, areas.chunks << 6,   areas.gaussians << 6,
               areas.colors << 6, areas.pixels << 6, areas.overflow << 6, areas.picture << 6};
  job.picture = {picture.format, picture.base << 6, picture.stride << 6};
  return job;
}

Frame job_frame(const Config& config, const pipegs_job& job) {
  Frame frame;
  SlotReader reader(registers_of(config).block("frame").slots, reinterpret_cast<const uint64_t*>(&job.frame));
  visit_fields(config, frame, reader);
  return frame;
}

}  // namespace pipegs
