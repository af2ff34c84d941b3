// SPDX-License-Identifier: Apache-2.0
// pipelines.hpp: the pipelines of the paper's Fig. 1 that have no RTL here: a GPU's order of work, GSCore and GSAcc,
// from their models on the counts of a view.
//
// Idea    A bar is a unit in a phase; its height is the share of the phase's time in which the unit works.
//         A GPU is another machine altogether. What Fig. 1a compares is its order of work: all Gaussians, then all
//         lists, then all pixels, with the lists of the square of 3 sigma. Here GSCore's units do it in that order.
#pragma once

#include <string>
#include <vector>

#include "sim/report/pipelines.hpp"
#include "sim/studies/rivals/counts.hpp"
#include "sim/studies/rivals/models/phases.hpp"

namespace pipegs {

MachinePipeline machine_pipeline(const std::string& machine, const std::string& note, const MachineFrame& frame);
// The order of work of INRIA's kernels on GSCore's units.
MachineFrame gpu_order(const FrameCounts& counts, PlayedMemory& memory);
std::vector<MachinePipeline> rival_pipelines(const FrameCounts& counts, PlayedMemory& memory);

}  // namespace pipegs
