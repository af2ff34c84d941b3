// SPDX-License-Identifier: Apache-2.0
// job.hpp: a frame of the model as the driver queues it: the slots of the registers.
#pragma once

#include "cpp_model/config.hpp"
#include "cpp_model/records.hpp"
#include "cpp_model/ru/ru_raster.hpp"
#include "sim/driver/pipegs.h"

namespace pipegs {

pipegs_job frame_job(const Config& config, const Frame& frame, const Areas& areas, const Picture& picture = {});
Frame job_frame(const Config& config, const pipegs_job& job);  // and back

}  // namespace pipegs
