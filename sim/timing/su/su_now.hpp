// SPDX-License-Identifier: Apache-2.0
// su_now.hpp: what the parts of a Sorting Unit say in a cycle of the timing model, from the registers as it began.
#pragma once

#include "sim/timing/machine.hpp"

namespace pipegs::timing {

struct Su::Now {
  bool item, item_end, split_idle, bitonic_idle, emit_empty, drained, spilled, sends, outside, kept, diverts, spill_job;
  bool mark_waits, mark_first, mark_all, spill_done, emit_item, emit_ready, item_goes;
  bool chain, chain_end, batch_ready, batch_valid;
  bool hungry, link_ready, released_room, sent_all;
  uint8_t mark_set;
  uint32_t mark_bucket;
  Beat mark_end;
  // buckets
  bool job, job_all, job_done, quiet, word_wanted, ends, push_group, join_group, filled, insert, chain_valid;
  uint8_t job_set;
  Bits candidates;
  Operation next;
  // collect
  const Splat* in;
  Source record;
  bool data, open, taken, write, spill_start, mark_push;
};

}  // namespace pipegs::timing
