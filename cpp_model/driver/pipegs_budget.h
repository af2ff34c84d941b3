/* SPDX-License-Identifier: Apache-2.0
 * pipegs_budget.h: the level of detail of each frame such that frames take the cycles that there are.
 *
 * Paper   None: level of detail, docs/units/dopu.md.
 * Idea    What the last frame took is known when the next one is queued (counter of its cycles, alone or queued). The
 *         level moves by as many octaves as the cycles lie off what is wanted, divided by how many an octave of it has
 *         changed them lately; towards more detail it goes half of that way. Within a sixteenth below it stays. So a
 *         picture that does not move keeps its level, and no proxy pops.
 * Numbers Integers alone; octaves in 1/256, of which a number's logarithm is good to 0.09. */
#ifndef PIPEGS_BUDGET_H
#define PIPEGS_BUDGET_H

#include "pipegs_frame.h"

#ifdef __cplusplus
extern "C" {
#endif

struct pipegs_budget {
  uint64_t cycles; /* wanted of a frame */
  int32_t octave;  /* steps of the frame field lod in an octave */
  int32_t finest;  /* the level at which the first groups take proxies */
  int32_t coarser; /* steps below that; 0: no proxies */
  int32_t slope;   /* octaves of cycles for one of the level, 1/256 */
  int32_t moved;   /* by what the level moved last, 1/256 octave */
  int32_t last;    /* log2 of what the frame before took, 1/256 */
};

/* For frames of cameras with about this focal length; false on a machine without proxies (lod = 0). The first frame is
 * drawn with those that differ by PIPEGS_BUDGET_FIRST pixels: coarse, since nothing is known of the scene. */
#define PIPEGS_BUDGET_FIRST 4
bool pipegs_budget_begin(const struct pipegs_configuration *config, const struct pipegs_camera *camera, uint64_t cycles,
                         struct pipegs_budget *budget);

/* A frame at the level of now has taken so many cycles. */
void pipegs_budget_took(struct pipegs_budget *budget, uint64_t cycles);

/* The field lod of the next frame. */
uint64_t pipegs_budget_lod(const struct pipegs_budget *budget);

#ifdef __cplusplus
}
#endif
#endif
