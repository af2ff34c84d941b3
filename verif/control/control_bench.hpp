// SPDX-License-Identifier: Apache-2.0
// control_bench.hpp: pipegs_control_registers beside its model, which is compared in every cycle, and a bus manager.
//
// The manager takes writes and reads from two queues; address, data, and the acceptance of answers each come at a pace
// of their own. Everything else at the ports is set by the test, or random.
#pragma once

#include "cpp_model/control/control_registers.hpp"
#include "sim/rtl/pins/axi_lite_pins.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "Vpipegs_control_registers.h"

namespace pipegs {

struct BusWrite {
  int offset;
  uint32_t data, strobe;
};
struct BusAnswer {
  bool error;
  uint32_t data;
};

// Fills a record from values in the order of its fields, with the names that they must have.
class FieldSetter final : public FieldVisitor {
 public:
  FieldSetter(const std::vector<Slot>& slots, const std::vector<uint64_t>& values) : slots_(slots), values_(values) {}
  void visit(const FieldName& field, uint64_t& value, int width, bool is_signed) override {
    ASSERT_LT(at_, slots_.size());
    ASSERT_EQ(slots_[at_].name, field.text());
    ASSERT_EQ(slots_[at_].width, width) << field.text();
    ASSERT_EQ(slots_[at_].is_signed, is_signed) << field.text();
    value = values_[at_++];
    if (is_signed && width > 0 && width < 64 && (value >> (width - 1)) != 0) value |= ~uint64_t{0} << width;
  }
  size_t at() const { return at_; }

 private:
  const std::vector<Slot>& slots_;
  const std::vector<uint64_t>& values_;
  size_t at_ = 0;
};

class ControlBench : public Endpoint {
 public:
  explicit ControlBench(uint64_t seed = test_seed()) : bench(seed), model(config) {
    in.counters.assign(static_cast<size_t>(counters()), 0);
    bench.add(*this);
    write_inputs();
    bench.reset();
  }
  int counters() const { return 3 + kUnitStates * (1 + 3 * config.units); }
  std::string at() const { return "cycle " + std::to_string(bench.cycle) + ", seed " + std::to_string(bench.seed); }

  // --- what tests call -----------------------------------------------------------------------------------------------
  void push_write(int offset, uint32_t data, uint32_t strobe = 0xf) {
    addresses_.push_back(offset);
    writes_.push_back({offset, data, strobe});
    ++expected_writes;
  }
  void push_read(int offset) {
    reads_.push_back(offset);
    ++expected_reads;
  }
  bool done() const { return write_answers.size() == expected_writes && read_answers.size() == expected_reads; }
  void finish() {
    ASSERT_TRUE(bench.run_until([&] { return done() || testing::Test::HasFatalFailure(); }));
  }
  bool write(int offset, uint32_t data, uint32_t strobe = 0xf) {  // false: refused
    push_write(offset, data, strobe);
    finish();
    return !write_answers.empty() && !write_answers.back();
  }
  BusAnswer read(int offset) {
    push_read(offset);
    finish();
    return read_answers.empty() ? BusAnswer{true, 0} : read_answers.back();
  }
  uint32_t value(int offset) {
    const BusAnswer answer = read(offset);
    EXPECT_FALSE(answer.error) << "offset " << std::hex << offset << std::dec << ", " << at();
    return answer.data;
  }
  int offset(const std::string& name) const {
    for (const Register& reg : model.map.registers)
      if (reg.name == name) return reg.offset;
    throw std::logic_error("no register " + name);
  }
  // One cycle with these events, which are gone behind it.
  void event(bool frame_done, uint32_t errors, bool frame_ready = false) {
    in.frame_done = frame_done, in.errors = errors, in.frame_ready = frame_ready;
    bench.step();
    in.frame_done = false, in.errors = 0, in.frame_ready = false;
  }
  void reset() {  // in the middle of whatever goes on
    addresses_.clear(), writes_.clear(), reads_.clear(), write_answers.clear(), read_answers.clear();
    expected_writes = expected_reads = 0;
    in.aw_valid = in.w_valid = in.ar_valid = false;
    write_inputs();
    bench.reset(1 + static_cast<int>(bench.rng() % 3));
    model.reset();
  }

  // --- each cycle ----------------------------------------------------------------------------------------------------
  void drive() override {
    const auto offer = [&](bool& valid, bool waits) { valid = valid || (waits && goes(pace, bench.rng)); };
    offer(in.aw_valid, !addresses_.empty());
    offer(in.w_valid, !writes_.empty());
    offer(in.ar_valid, !reads_.empty());
    in.aw_address = in.aw_valid ? static_cast<uint32_t>(addresses_.front()) : noise();
    in.w_data = in.w_valid ? writes_.front().data : noise();
    in.w_strobe = in.w_valid ? writes_.front().strobe : noise() & 15;
    in.ar_address = in.ar_valid ? static_cast<uint32_t>(reads_.front()) : noise();
    in.b_ready = goes(answer_pace, bench.rng);
    in.r_ready = goes(answer_pace, bench.rng);
    if (before_edge) before_edge();
    write_inputs();
  }
  void observe() override {
    const ControlOutputs out = model.outputs();
    auto& dut = bench.dut;
    const AxiLiteSubordinateSide shown = axi_lite_subordinate_side(dut.s_axi_o);
    ASSERT_EQ(shown.aw_ready, out.aw_ready) << at();
    ASSERT_EQ(shown.w_ready, out.w_ready) << at();
    ASSERT_EQ(shown.ar_ready, out.ar_ready) << at();
    ASSERT_EQ(shown.b_valid, out.b_valid) << at();
    ASSERT_EQ(shown.r_valid, out.r_valid) << at();
    if (out.b_valid) { ASSERT_EQ(shown.b_response, out.b_error ? 2 : 0) << at(); }
    if (out.r_valid) {
      ASSERT_EQ(shown.r_response, out.r_error ? 2 : 0) << at();
      ASSERT_EQ(shown.r_data, out.r_data) << at();
    }
    ASSERT_EQ(dut.irq_o, out.irq) << at();
    ASSERT_EQ(dut.abort_o, out.abort) << at();
    ASSERT_EQ(dut.frame_valid_o, out.frame_valid) << at();
    ASSERT_EQ(dut.timeout_o, out.timeout) << at();
    if (out.frame_valid) check_frame();
    if (in.aw_valid && out.aw_ready) addresses_.pop_front(), in.aw_valid = false;
    if (in.w_valid && out.w_ready) writes_.pop_front(), in.w_valid = false;
    if (in.ar_valid && out.ar_ready) reads_.pop_front(), in.ar_valid = false;
    if (out.b_valid && in.b_ready) write_answers.push_back(out.b_error);
    if (out.r_valid && in.r_ready) read_answers.push_back({out.r_error, out.r_data});
    model.step(sampled_);
  }

  Config config = test_config();
  Bench<Vpipegs_control_registers> bench;
  ControlRegisters model;
  ControlInputs in;
  Pace pace = Pace::kAlways, answer_pace = Pace::kAlways;
  std::function<void()> before_edge;
  std::vector<bool> write_answers;  // true: an error
  std::vector<BusAnswer> read_answers;
  size_t expected_writes = 0, expected_reads = 0;

 private:
  uint32_t noise() { return static_cast<uint32_t>(bench.rng()) & ((1u << model.map.address_bits) - 1); }
  void write_inputs() {
    auto& dut = bench.dut;
    write_manager_side(dut.s_axi_i, {in.aw_valid, in.w_valid, in.b_ready, in.ar_valid, in.r_ready, in.aw_address,
                                     in.ar_address, in.w_data, in.w_strobe});
    dut.frame_ready_i = in.frame_ready, dut.apart_i = in.apart, dut.busy_i = in.busy, dut.frame_done_i = in.frame_done;
    dut.silent_i = in.silent;
    dut.error_i = static_cast<CData>(in.errors);
    dut.located_i = static_cast<CData>(in.located);
    Words lines(port_words<decltype(dut.error_address_i)>() + 2), counts(port_words<decltype(dut.counters_i)>() + 2);
    for (int i = 0; i < kErrorCauses; ++i) {
      put_bits(lines.data(), i * config.address_w(), config.address_w(), in.error_lines[static_cast<size_t>(i)]);
    }
    for (int i = 0; i < counters(); ++i) {
      put_bits(counts.data(), i * config.perf_w(), config.perf_w(), in.counters[static_cast<size_t>(i)]);
    }
    write_port(dut.error_address_i, lines.data());
    write_port(dut.counters_i, counts.data());
    sampled_ = in;
  }
  // frame_o by the records' own table, what lies beside it by the widths of the slots.
  void check_frame() {
    const std::vector<Slot> slots = model.map.shadow();
    Frame frame;
    FieldSetter setter(slots, model.shadow());
    visit_fields(config, frame, setter);
    ASSERT_EQ(first_difference(config, frame, read_record<Frame>(config, bench.dut.frame_o)), "") << at();
    Words words[2] = {Words(port_words<decltype(bench.dut.areas_o)>() + 2),
                      Words(port_words<decltype(bench.dut.picture_o)>() + 2)};
    read_port(bench.dut.areas_o, words[0].data());
    read_port(bench.dut.picture_o, words[1].data());
    const size_t areas = setter.at(), picture = areas + model.map.block("areas").slots.size();
    int bit = 0;
    for (size_t i = areas; i < slots.size(); ++i) {
      if (i == picture) bit = 0;
      ASSERT_EQ(get_bits(words[i >= picture].data(), bit, slots[i].width), model.shadow()[i])
          << slots[i].name << ", " << at();
      bit += slots[i].width;
    }
  }

  std::deque<int> addresses_, reads_;
  std::deque<BusWrite> writes_;
  ControlInputs sampled_;
};

}  // namespace pipegs
