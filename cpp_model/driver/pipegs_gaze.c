/* SPDX-License-Identifier: Apache-2.0
 * pipegs_gaze.c: see pipegs_gaze.h. */
#include "pipegs_gaze.h"

#define COARSEST 4  /* pixels of the largest sample in each direction */
#define FRACTION 47 /* bits of a principal point */
#define FAR 15      /* log2 of the pixels that it may lie off */

struct rectangle {
  uint32_t x0, y0, x1, y1;
};

/* An edge of a square: a multiple of the largest sample, the next one outwards, in a picture of `side` pixels. */
static uint32_t edge(int64_t at, bool high, uint32_t side) {
  if (at < 0) at = 0;
  if (high) at += COARSEST - 1;
  at -= at % COARSEST;
  return at < side ? (uint32_t)at : side;
}

static struct rectangle around(const struct pipegs_camera *camera, const struct pipegs_gaze *gaze, uint32_t radius) {
  struct rectangle square;
  square.x0 = edge((int64_t)gaze->x - radius, false, camera->width);
  square.y0 = edge((int64_t)gaze->y - radius, false, camera->height);
  square.x1 = edge((int64_t)gaze->x + radius, true, camera->width);
  square.y1 = edge((int64_t)gaze->y + radius, true, camera->height);
  return square;
}

/* (center - begin - (2^pitch - 1) / 2) / 2^pitch: where the centre lies in samples from the first one's centre. */
static bool in_samples(struct pipegs_number *center, uint32_t begin, uint32_t pitch) {
  const int64_t first = ((int64_t)begin << 1) + (INT64_C(1) << pitch) - 1; /* half pixels */
  const int32_t down = -FRACTION - center->exponent;
  const bool negative = center->mantissa < 0;
  uint64_t size = negative ? 0 - (uint64_t)center->mantissa : (uint64_t)center->mantissa;
  if (down > 64) size = 0;
  else if (down > 0) size = (down < 64 ? size >> down : 0) + (size >> (down - 1) & 1);
  else if (size != 0 && (down < -FAR - FRACTION || size >> (FAR + FRACTION + down) != 0)) return false;
  else size <<= size == 0 ? 0 : -down;
  if (size >> (FAR + FRACTION) != 0) return false;
  center->mantissa = (negative ? -(int64_t)size : (int64_t)size) - first * (INT64_C(1) << (FRACTION - 1));
  center->exponent = -FRACTION - (int32_t)pitch;
  return true;
}

struct parts {
  const struct pipegs_camera *camera;
  struct pipegs_gaze_part *list;
  uint32_t count;
  bool fit;
};

static void add(struct parts *parts, uint32_t x0, uint32_t y0, uint32_t x1, uint32_t y1, uint32_t pitch) {
  struct pipegs_gaze_part *const part = parts->list + parts->count;
  if (x0 >= x1 || y0 >= y1) return;
  ++parts->count;
  part->camera = *parts->camera;
  part->x = x0;
  part->y = y0;
  part->pitch = pitch;
  part->camera.width = (x1 - x0 + (UINT32_C(1) << pitch) - 1) >> pitch;
  part->camera.height = (y1 - y0 + (UINT32_C(1) << pitch) - 1) >> pitch;
  part->camera.of_width = (parts->camera->width + (UINT32_C(1) << pitch) - 1) >> pitch;
  part->camera.of_height = (parts->camera->height + (UINT32_C(1) << pitch) - 1) >> pitch;
  part->camera.focal[0].exponent -= (int32_t)pitch;
  part->camera.focal[1].exponent -= (int32_t)pitch;
  parts->fit &= in_samples(&part->camera.center[0], x0, pitch) && in_samples(&part->camera.center[1], y0, pitch);
}

/* What lies in the outer rectangle and not in the inner one: above, left, right, below. */
static void add_ring(struct parts *parts, struct rectangle outer, struct rectangle inner, uint32_t pitch) {
  if (inner.x0 == inner.x1 || inner.y0 == inner.y1) {
    add(parts, outer.x0, outer.y0, outer.x1, outer.y1, pitch);
    return;
  }
  add(parts, outer.x0, outer.y0, outer.x1, inner.y0, pitch);
  add(parts, outer.x0, inner.y0, inner.x0, inner.y1, pitch);
  add(parts, inner.x1, inner.y0, outer.x1, inner.y1, pitch);
  add(parts, outer.x0, inner.y1, outer.x1, outer.y1, pitch);
}

uint32_t pipegs_gaze_parts(const struct pipegs_camera *camera, const struct pipegs_gaze *gaze,
                           struct pipegs_gaze_part list[PIPEGS_GAZE_PARTS]) {
  const struct rectangle full = around(camera, gaze, gaze->full), half = around(camera, gaze, gaze->half);
  const struct rectangle all = {0, 0, camera->width, camera->height};
  struct parts parts = {camera, list, 0, true};
  if (gaze->half < gaze->full) return 0;
  add(&parts, full.x0, full.y0, full.x1, full.y1, 0);
  add_ring(&parts, half, full, 1);
  add_ring(&parts, all, half, 2);
  return parts.fit ? parts.count : 0;
}
