// SPDX-License-Identifier: Apache-2.0
// rtl_fault.hpp: what is thrown when the machine does what it must not: an assertion of the RTL fails, it hangs, or it
// differs from the golden model where nothing can go on. Exit code 1, as any difference.
#pragma once

#include <cstdint>
#include <stdexcept>

namespace pipegs {

struct RtlFault : std::runtime_error {
  using std::runtime_error::runtime_error;
  int64_t cycle = 0;  // in which it happened, as RtlTaps counts
};

}  // namespace pipegs
