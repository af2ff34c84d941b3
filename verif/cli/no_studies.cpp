// SPDX-License-Identifier: Apache-2.0
// no_studies.cpp: what sim/command/studies.cpp.in becomes when there is no study.
#include <functional>

namespace CLI {
class App;
}

namespace pipegs {

using Run = std::function<int()>;

void add_studies(CLI::App&, CLI::App&, Run&) {}

}  // namespace pipegs
