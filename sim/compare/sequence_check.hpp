// SPDX-License-Identifier: Apache-2.0
// sequence_check.hpp: holds a sequence of frames in one machine against the golden model: every stream, every pixel.
//
// Idea    Frames overlap: the front of the machine shows splats of a frame while its RUs blend the one before. Ends of
//         windows tell for each stream in which frame it is; what the RUs show is of the oldest frame whose last pixel
//         has not left them. When all pixels of a frame are in memory, they are compared.
// Result  Mismatches of each frame, see StreamCheck.
#pragma once

#include <memory>
#include <vector>

#include "cpp_model/golden.hpp"
#include "sim/compare/request_check.hpp"
#include "sim/compare/simulate.hpp"
#include "sim/compare/state_check.hpp"
#include "sim/compare/stream_check.hpp"

namespace pipegs {

class SequenceCheck final : public RtlTaps {
 public:
  // A frame where it lies in memory, the golden model's, and its areas. `input` and `golden` outlive this.
  struct Expected {
    const GoldenInput* input;
    const GoldenFrame* golden;
    Areas areas;
  };
  // `second` sees all that this sees, or is null.
  SequenceCheck(const std::vector<Expected>& frames, const ExternalMemory& memory, RtlTaps* second);

  void on_splat(int unit, const uint32_t* splat) override;
  void on_sorted(const uint32_t* sorted) override;
  void on_alphas(int lane, uint64_t window_x, uint64_t window_y, uint32_t index, int region, int quarter,
                 const uint32_t* line) override;
  void on_pixels(int lane, int region, int quarter, const uint32_t* word) override;
  void on_frame_left() override;
  void on_frame_done() override;
  void on_give_up() override;  // what is not complete begins anew
  bool wants_cycles() const override { return true; }
  void on_cycle(uint64_t number, const uint8_t* states) override;
  void on_border(const uint8_t* border) override;
  void on_chunk(int unit, int kind, const uint32_t* chunk) override;
  void on_line_free(int unit) override;
  void on_layer_done(int unit, bool window_done) override;
  void on_request(int tag, bool write, uint64_t line, int lines) override;
  void finish(const RtlResult& counters);  // after the run

  StreamCheck& frame(size_t number) { return *frames_[number].streams; }
  std::optional<int64_t> first_cycle() const;  // of the first mismatch in any frame
  size_t complete() const { return back_; }    // frames that are
  // Of a frame that is complete: what memory held of the picture of its first eye, and of that of its second one.
  const Written& written(size_t number) const { return frames_[number].first; }
  const Written& second_written(size_t number) const { return frames_[number].second; }
  // Of a frame that is complete: what memory has moved since the start.
  const MemoryBytes& moved(size_t number) const { return frames_[number].moved; }

 private:
  struct One {
    Expected expected;
    std::unique_ptr<StreamCheck> streams;
    RequestCheck requests;
    Written first = {}, second = {};
    MemoryBytes moved = {};
  };
  RtlTaps& states();  // in this cycle
  RtlTaps& second();
  void watch_states();             // from a machine on that is empty
  StreamCheck& at(size_t number);  // the last frame, where a stream shows more than it should
  void compare_pixels(One& one);
  void compare_picture(One& one, const GoldenPicture& golden, uint64_t behind, Written& written);
  void compare_request(int tag, bool write, uint64_t line, int lines);
  // The pixel in memory, of colours or so many lines further.
  uint64_t found(const One& one, uint64_t x, uint64_t y, uint64_t ahead = 0) const;

  const ExternalMemory& memory_;
  RtlTaps* second_;
  const bool cycles_;  // the second one wants them, too
  std::vector<One> frames_;
  std::unique_ptr<StateCheck> states_;
  std::vector<size_t> chunk_frame_, splat_frame_;  // of each unit
  size_t sorted_frame_ = 0, left_ = 0, back_ = 0;  // left_: those of which the RUs show nothing any more
};

}  // namespace pipegs
