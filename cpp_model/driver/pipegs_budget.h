/* SPDX-License-Identifier: Apache-2.0
 * pipegs_budget.h: how much worse a frame may be such that frames take the cycles that there are.
 *
 * Paper   None: raster.rest and level of detail, docs/numerics/time.md, docs/units/dopu.md.
 * Idea    One level, 0 for the whole picture. First raster.rest rises, which costs least, then groups take proxies
 *         that differ by more and more pixels while the rest goes on rising slowly; a machine that has one of the two
 *         uses that. Of each frame that is done its cycles are known (counter, alone or queued): the next level lies
 *         off that frame's by as many octaves as the cycles lie off what is wanted, divided by how many an octave of it
 *         has changed them lately; towards a better picture it goes half of that way. Within a sixteenth below it
 *         stays. So a picture that does not move keeps its level, and no proxy pops.
 * Numbers Integers alone; octaves in 1/256, of which a number's logarithm is good to 0.09. */
#ifndef PIPEGS_BUDGET_H
#define PIPEGS_BUDGET_H

#include "pipegs_frame.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PIPEGS_BUDGET_FRAMES 2 /* that may be on their way: one runs, one is queued */

struct pipegs_budget {
  uint64_t cycles; /* wanted of a frame */
  int32_t rest_w;  /* bits of raster.rest; 0: the machine has none */
  int32_t octave;  /* steps of the field lod in an octave; 0: the machine has none */
  int32_t finest;  /* the field lod at which the first groups take proxies */
  int32_t level;   /* of the next frame, 1/256 octave; 0: the whole picture */
  int32_t most;    /* the highest one */
  int32_t slope;   /* octaves of cycles for one of the level, 1/256 */
  int32_t flying[PIPEGS_BUDGET_FRAMES]; /* levels of the frames that are set and not done, the oldest first */
  int32_t frames;  /* so many */
  int32_t last;    /* log2 of what the frame done last took, 1/256; 0: none is */
  int32_t before;  /* its level */
};

/* For frames of cameras with about this focal length; false for a budget of 0 and on a machine with neither field
 * (CONFIG_LESS). The first frame is drawn at a high level, proxies that differ by PIPEGS_BUDGET_FIRST pixels: nothing
 * is known of the scene. */
#define PIPEGS_BUDGET_FIRST 4
bool pipegs_budget_begin(const struct pipegs_configuration *config, const struct pipegs_camera *camera, uint64_t cycles,
                         struct pipegs_budget *budget);

/* The fields raster.rest and lod of the next frame, before it is queued. */
void pipegs_budget_set(struct pipegs_budget *budget, struct pipegs_frame *frame);

/* The oldest of the frames set has taken so many cycles. */
void pipegs_budget_took(struct pipegs_budget *budget, uint64_t cycles);

#ifdef __cplusplus
}
#endif
#endif
