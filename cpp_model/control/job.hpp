// SPDX-License-Identifier: Apache-2.0
// job.hpp: a frame of the model as the driver queues it, the slots of the registers, and back.
//
// RTL     rtl/control/pipegs_control_shadow.sv
// Idea    A slot has 64 bits. A field of the frame stands in it from bit `shift` on, its sign above it. The members of
//         a job are the slots in their order, which is that of the fields.
#pragma once

#include "cpp_model/config.hpp"
#include "cpp_model/control/registers.hpp"
#include "cpp_model/records.hpp"
#include "cpp_model/ru/ru_raster.hpp"
#include "cpp_model/driver/pipegs.h"

namespace pipegs {

// Of the machine that was asked about last it is made once.
const RegisterMap& registers_of(const Config& config);

pipegs_job frame_job(const Config& config, const Frame& frame, const Areas& areas, const Picture& picture = {});
Frame job_frame(const Config& config, const pipegs_job& job);

}  // namespace pipegs
