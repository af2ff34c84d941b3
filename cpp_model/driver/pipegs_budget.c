/* SPDX-License-Identifier: Apache-2.0
 * pipegs_budget.c: see pipegs_budget.h. */
#include "pipegs_budget.h"

#define OCTAVE 256           /* of the level, and of logarithms here */
#define REST_LEAST 10        /* the rest begins at so many octaves below one, */
#define REST_FAST 4          /* rises by so many for one of the level */
#define REST_ALONE 384       /* up to this level, where proxies begin if there are any, */
#define REST_SLOW 2          /* then by one for so many, */
#define REST_MOST 2          /* up to so many octaves below one */
#define WIDEST 16            /* octaves of the longest focal length, pixels, times 2^FINEST */
#define FINEST 3             /* octaves below a pixel: what differs by less shows nowhere */
#define CALM 16              /* the level stays where the cycles lie less than 1/CALM below what is wanted */
#define MOST 2               /* octaves by which it moves at most */
#define SLOPE 128            /* octaves of cycles for OCTAVE of the level, to begin with, */
#define FLATTEST 40          /* and within what is believed */
#define STEEPEST 600

/* log2 of a number above 0, the mantissa as it is. */
static int32_t octaves(uint64_t number) {
  int32_t length = 0;
  while (number >> length > 1) ++length;
  return length * OCTAVE + (int32_t)((length > 8 ? number >> (length - 8) : number << (8 - length)) & 255);
}

static int32_t within(int32_t low, int32_t value, int32_t high) {
  return value < low ? low : value > high ? high : value;
}

/* The level at which proxies begin. */
static int32_t alone(const struct pipegs_budget *budget) { return budget->rest_w == 0 ? 0 : REST_ALONE; }

bool pipegs_budget_begin(const struct pipegs_configuration *config, const struct pipegs_camera *camera, uint64_t cycles,
                         struct pipegs_budget *budget) {
  const struct pipegs_number focal = camera->focal[0];
  int32_t proxies = 0; /* levels with proxies */
  budget->cycles = cycles;
  budget->rest_w = (int32_t)config->rest_w;
  budget->octave = config->lod_bits == 0 ? 0 : (int32_t)1 << config->lod_bits;
  /* A focal length of 2^-16 to 2^32 pixels; in any other no proxy would be seen, or all that is. */
  if (focal.mantissa > 0 && focal.exponent > -64 && focal.exponent < 32)
    proxies = octaves((uint64_t)focal.mantissa) + (focal.exponent + FINEST) * OCTAVE;
  proxies = within(0, proxies, WIDEST * OCTAVE);
  if (proxies < OCTAVE) budget->octave = 0;
  budget->finest = proxies * budget->octave / OCTAVE;
  budget->most = budget->octave != 0 ? alone(budget) + (budget->finest - 1) * OCTAVE / budget->octave
                                     : (REST_LEAST - REST_MOST) * OCTAVE / REST_FAST;
  budget->level = within(0, alone(budget) + FINEST * OCTAVE + octaves(PIPEGS_BUDGET_FIRST), budget->most);
  budget->slope = SLOPE;
  budget->frames = budget->last = budget->before = 0;
  return cycles != 0 && (budget->rest_w != 0 || budget->octave != 0);
}

void pipegs_budget_set(struct pipegs_budget *budget, struct pipegs_frame *frame) {
  const int32_t proxies = budget->level - alone(budget);
  if (budget->frames == PIPEGS_BUDGET_FRAMES) budget->flying[0] = budget->flying[--budget->frames];
  budget->flying[budget->frames++] = budget->level;
  frame->raster_rest = frame->lod = 0;
  if (budget->level == 0) return;
  if (budget->rest_w != 0) {
    int32_t rest = -REST_LEAST * OCTAVE + REST_FAST * budget->level; /* log2 of it, 1/OCTAVE */
    if (budget->octave != 0 && proxies > 0) rest = -REST_LEAST * OCTAVE + REST_FAST * REST_ALONE + proxies / REST_SLOW;
    rest = within(0, rest + budget->rest_w * OCTAVE, (budget->rest_w - REST_MOST) * OCTAVE);
    frame->raster_rest = ((uint64_t)(OCTAVE + rest % OCTAVE) << (rest / OCTAVE)) / OCTAVE;
  }
  if (budget->octave != 0 && proxies > 0)
    frame->lod = (uint64_t)within(1, budget->finest - proxies * budget->octave / OCTAVE, budget->finest);
}

void pipegs_budget_took(struct pipegs_budget *budget, uint64_t cycles) {
  const int32_t level = budget->frames == 0 ? budget->level : budget->flying[0],
                took = octaves(cycles == 0 ? 1 : cycles), moved = level - budget->before;
  int32_t over = took - octaves(budget->cycles - budget->cycles / (2 * CALM));
  if (budget->frames > 0) {
    --budget->frames;
    budget->flying[0] = budget->flying[PIPEGS_BUDGET_FRAMES - 1];
  }
  if (budget->last != 0 && (moved > OCTAVE / 8 || moved < -OCTAVE / 8)) {
    const int32_t slope = within(FLATTEST, (budget->last - took) * OCTAVE / moved, STEEPEST);
    budget->slope = (budget->slope + slope) / 2;
  }
  if (cycles <= budget->cycles && cycles >= budget->cycles - budget->cycles / CALM) over = 0;
  if (over < 0) over /= 2; /* too fine is worse than too coarse */
  over = within(-MOST * OCTAVE, over * OCTAVE / budget->slope, MOST * OCTAVE);
  budget->level = within(0, level + over, budget->most);
  if (cycles > budget->cycles && budget->level == 0) budget->level = 1;
  budget->last = took;
  budget->before = level;
}
