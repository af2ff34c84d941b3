/* SPDX-License-Identifier: Apache-2.0
 * pipegs_budget.c: see pipegs_budget.h. */
#include "pipegs_budget.h"

#define OCTAVE 256    /* of logarithms here */
#define FINEST 3      /* octaves below a pixel: what differs by less shows nowhere */
#define CALM 20       /* the level stays where the cycles lie less than 1/CALM below what is wanted */
#define MOST 2        /* octaves by which it moves at most */

/* log2 of a number above 0, the mantissa as it is. */
static int32_t octaves(uint64_t number) {
  int32_t length = 0;
  while (number >> length > 1) ++length;
  return length * OCTAVE + (int32_t)((length > 8 ? number >> (length - 8) : number << (8 - length)) & 255);
}

bool pipegs_budget_begin(const struct pipegs_configuration *config, const struct pipegs_camera *camera, uint64_t cycles,
                         struct pipegs_budget *budget) {
  const struct pipegs_number focal = camera->focal[0];
  int32_t level;
  if (config->lod_bits == 0 || focal.mantissa <= 0 || cycles == 0) return false;
  budget->cycles = cycles;
  budget->octave = (int32_t)1 << config->lod_bits;
  level = (octaves((uint64_t)focal.mantissa) + focal.exponent * OCTAVE) * budget->octave / OCTAVE;
  budget->finest = level + FINEST * budget->octave;
  budget->coarser = budget->finest - level + octaves(PIPEGS_BUDGET_FIRST) * budget->octave / OCTAVE;
  return budget->finest > 1;
}

void pipegs_budget_took(struct pipegs_budget *budget, uint64_t cycles) {
  int32_t over = octaves(cycles == 0 ? 1 : cycles) - octaves(budget->cycles);
  if (over <= 0 && cycles >= budget->cycles - budget->cycles / CALM) return;
  if (over > 0) over *= 2;
  if (over > MOST * OCTAVE) over = MOST * OCTAVE;
  if (over < -MOST * OCTAVE) over = -MOST * OCTAVE;
  budget->coarser += over * budget->octave / OCTAVE;
  if (over > 0 && budget->coarser < 1) budget->coarser = 1;
  if (budget->coarser < 0) budget->coarser = 0;
  if (budget->coarser > budget->finest - 1) budget->coarser = budget->finest - 1;
}

uint64_t pipegs_budget_lod(const struct pipegs_budget *budget) {
  return budget->coarser == 0 ? 0 : (uint64_t)(budget->finest - budget->coarser);
}
