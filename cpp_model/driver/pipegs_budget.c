/* SPDX-License-Identifier: Apache-2.0
 * pipegs_budget.c: see pipegs_budget.h. */
#include "pipegs_budget.h"

#define OCTAVE 256    /* of logarithms here */
#define FINEST 3      /* octaves below a pixel: what differs by less shows nowhere */
#define CALM 16       /* the level stays where the cycles lie less than 1/CALM below what is wanted, and in its middle else */
#define MOST 2        /* octaves by which it moves at most */
#define SLOPE 128     /* octaves of cycles for OCTAVE of the level, to begin with, */
#define FLATTEST 40   /* and within what is believed */
#define STEEPEST 600

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
  budget->slope = SLOPE;
  budget->moved = budget->last = 0;
  return budget->finest > 1;
}

static int32_t within(int32_t low, int32_t value, int32_t high) {
  return value < low ? low : value > high ? high : value;
}

void pipegs_budget_took(struct pipegs_budget *budget, uint64_t cycles) {
  const int32_t before = budget->coarser, took = octaves(cycles == 0 ? 1 : cycles);
  int32_t over = took - octaves(budget->cycles - budget->cycles / (2 * CALM));
  if (budget->moved > OCTAVE / 8 || budget->moved < -OCTAVE / 8) {
    const int32_t slope = within(FLATTEST, (budget->last - took) * OCTAVE / budget->moved, STEEPEST);
    budget->slope = (budget->slope + slope) / 2;
  }
  if (cycles <= budget->cycles && cycles >= budget->cycles - budget->cycles / CALM) over = 0;
  if (over < 0) over /= 2; /* too fine is worse than too coarse */
  over = within(-MOST * OCTAVE, over * OCTAVE / budget->slope, MOST * OCTAVE);
  budget->coarser = within(0, before + over * budget->octave / OCTAVE, budget->finest - 1);
  if (cycles > budget->cycles && budget->coarser == 0) budget->coarser = 1;
  budget->moved = (budget->coarser - before) * OCTAVE / budget->octave;
  budget->last = took;
}

uint64_t pipegs_budget_lod(const struct pipegs_budget *budget) {
  return budget->coarser == 0 ? 0 : (uint64_t)(budget->finest - budget->coarser);
}
