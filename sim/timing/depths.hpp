// depths.hpp: how much waits where in the RTL: depths of queues and lines in flight that are no entry of the configuration.
//
// Rule    Each number is a parameter of an RTL module, named beside it, and changes with it. verif/timing tells when one
//         was forgotten: it holds the model against the RTL.
#pragma once

#include "cpp_model/config.hpp"

namespace pipegs::timing {

// rtl/pu/pu_fetch.sv: Jobs and Lines of its line_reader.
inline constexpr int kFetchJobs = 8, kFetchLines = 64;
// rtl/dopu/dopu_descend.sv: Results; Jobs and Lines of its readers (Lines of dopu.sv for orders 0 and 1).
inline constexpr int kDescendResults = 8, kDescendJobs = 8, kDescendLines = 32;
// rtl/dopu/dopu_nearest.sv: Results, Most, Ahead; Lines of dopu.sv for order 2.
inline constexpr int kNearestResults = 16, kNearestMost = 16, kNearestAhead = 128, kNearestLines = 64;
// rtl/dopu/dopu_send.sv: MarksW is 5.
inline constexpr int kNearestMarks = 31;
// rtl/pu/pu.sv: VisibleDepth, WalkDepth; Marks.
inline constexpr int kVisibleDepth = 4, kWalkDepth = 16, kPuMarks = 16;
// rtl/pu/pu_color.sv: Depth; rtl/pu/pu_expand.sv: Depth; rtl/pu/pu_cache.sv and pu_list.sv: JobDepth.
inline constexpr int kColorDepth = 32, kExpandDepth = 40, kRowJobs = 4;
// rtl/list/list_read.sv: Jobs and Lines of its line_reader.
inline constexpr int kListJobs = 8, kListLines = 64;
// rtl/su/su.sv: Chains, Marks; depths of the queues in su_emit and su_port.
inline constexpr int kSuChains = 64, kSuMarks = 64, kSuMarksLayers = 4, kSuWaiting = 32, kSuAnswers = 32;
// rtl/ru/ru.sv: QueueDepth.
inline constexpr int kRuQueueMost = 64;
inline int ru_queue_depth(const Config& config) { return config.late == 0 ? 16 : 64; }
// rtl/ru/ru_rows.sv: LinesDepth; rtl/ru/ru_fetch.sv: LocalLines.
inline constexpr int kRuLines = 2, kRuLocalLines = 4;

}  // namespace pipegs::timing
