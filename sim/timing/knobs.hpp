#pragma once
#include <cstdlib>
namespace pipegs {
inline int knob(const char* name, int none) { const char* v = std::getenv(name); return v ? std::atoi(v) : none; }
inline int x_occ() { static const int v = knob("X_OCC", 0); return v; }        // 1: chunks and groups, 2: + Gaussians before the PUs
inline int x_pace() { static const int v = knob("X_PACE", 8); return v; }
inline int x_cpace() { static const int v = knob("X_CPACE", 8); return v; }
inline int x_split() { static const int v = knob("X_SPLIT", 1 << 30); return v; }    // Gaussians of a window from which it is four walks
inline int x_split2() { static const int v = knob("X_SPLIT2", 1 << 30); return v; }  // of a part, from which it is four walks of 32
inline int x_nobehind() { static const int v = knob("X_NOBEHIND", 0); return v; }
inline int x_grow() { static const int v = knob("X_GROW", 0); return v; }  // regions that a chunk's rectangle is too large on each side
inline int x_stat() { static const int v = knob("X_STAT", 0); return v; }
inline int x_tests() { static const int v = knob("X_TESTS", 1); return v; }  // of boxes walked in a cycle, beyond config.tests
inline int x_minbox() { static const int v = knob("X_MINBOX", 1); return v; }
inline int x_insert() { static const int v = knob("X_INSERT", 2); return v; }
inline int x_part() { static const int v = knob("X_PART", 0); return v; }  // 1: the part of a window before the depth
inline int x_gap() { static const int v = knob("X_GAP", 0); return v; }
inline int x_halves() { static const int v = knob("X_HALVES", 4); return v; }
inline int x_queue() { static const int v = knob("X_QUEUE", 64); return v; }
inline int x_nohazard() { static const int v = knob("X_NOHAZARD", 0); return v; }
inline int x_regions() { static const int v = knob("X_REGIONS", 1); return v; }
inline int x_link() { static const int v = knob("X_LINK", 0); return v; }
inline int x_splitter() { static const int v = knob("X_SPLITTER", 1); return v; }
inline int x_bbox() { static const int v = knob("X_BBOX", 0); return v; }
inline const char* knob_text(const char* name) { const char* v = std::getenv(name); return v != nullptr && *v != 0 ? v : nullptr; }
inline int x_variants() { static const int v = knob("X_VARIANTS", 0); return v; }  // survivors of a window from which all its walks are traced
inline int x_marks() { static const int v = knob("X_MARKS", 0); return v; }  // chunks between watermarks, always; 0: as in the machine
inline int x_fire() { static const int v = knob("X_FIRE", 0); return v; }  // both halves of a region in a cycle
inline int x_origin() { static const int v = knob("X_ORIGIN", 9); return v; }  // cycles of a chunk in dopu_origin
inline int x_log() { static const int v = knob("X_LOG", 0); return v; }
inline int x_episode() { static const int v = knob("X_EPISODE", 0); return v; }  // a spill ends with the next watermark
inline int x_sets() { static const int v = knob("X_SETS", 2); return v; }  // in an SU
inline int x_none() { static const int v = knob("X_NONE", 0); return v; }  // the end of an empty set turns none
inline int x_mshift() { static const int v = knob("X_MSHIFT", 3); return v; }  // marks at one distance, log2; 8 times as many in a window
inline int x_deal() { static const int v = knob("X_DEAL", 1); return v; }  // Gaussians in a cycle from the fronts to the PUs
inline int x_oracle() { static const int v = knob("X_ORACLE", 0); return v; }
}
