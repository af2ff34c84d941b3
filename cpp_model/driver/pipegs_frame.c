/* SPDX-License-Identifier: Apache-2.0
 * pipegs_frame.c: see pipegs_frame.h.
 *
 * Idea    Reach and spread are products of a logarithm, which no integer is: what lies strictly between two integers is
 *         rounded up by cutting it and adding one. Both keep 60 leading bits or more. */
#include "pipegs_frame.h"

#include "pipegs_wide.h"

/* Integer bits of the fields, the sign included; the rest of a width is fraction. */
enum { ROTATION_BITS = 2, FOCAL_BITS = 14, CENTER_BITS = 16, GUARD_BITS = 4, SPREAD_MANTISSA = 8 };
enum { WINDOW_W = 10, LIST_WINDOW_W = 12, TILE_LIST_WINDOW_W = 14, LIST_GAP = 132, TILE = 16, SQUARE = 64 };
/* Of the overflow area, in lines of 64 bytes: the least that a part of it is made for, and 1 GiB. */
enum { AREA_LEAST = 64, GIBIBYTE = 1 << 24 };
enum { ROTATION_F = 60 }; /* fraction of what the quaternion is computed from */

/* number * 2^fraction, to the nearest, a tie away from 0; false when it has more than 62 bits. */
static bool rounded(struct pipegs_number number, int fraction, int64_t *field) {
  const bool negative = number.mantissa < 0;
  uint64_t size = negative ? 0 - (uint64_t)number.mantissa : (uint64_t)number.mantissa;
  const int64_t up = (int64_t)number.exponent + fraction;
  if (up > 0 && size != 0) {
    if (up > 62 || size >> (62 - up) != 0) return false;
    size <<= up;
  } else if (up < 0) {
    if (up < -64) size = 0;
    else size = (up > -64 ? size >> -up : 0) + (size >> (-up - 1) & 1);
  }
  if (size >> 62 != 0) return false;
  *field = negative ? -(int64_t)size : (int64_t)size;
  return true;
}

static bool signed_field(struct pipegs_number number, int fraction, uint32_t width, int64_t *field) {
  const int64_t high = INT64_C(1) << (width - 1);
  return rounded(number, fraction, field) && *field >= -high && *field < high;
}

static bool unsigned_field(struct pipegs_number number, int fraction, uint32_t width, uint64_t *field) {
  int64_t value = 0;
  if (!rounded(number, fraction, &value) || value < 0 || value >> width != 0) return false;
  *field = (uint64_t)value;
  return true;
}

/* 2 ln(n), u4.60, rounded down; n is 2 to 2980. With n = 2^k y, ln y = 2 atanh((y - 1) / (y + 1)). */
static uint64_t two_logarithms(uint32_t n) {
  const uint64_t ln2 = UINT64_C(0xb17217f7d1cf79ab); /* u0.64 */
  struct pipegs_wide ratio = {0, 0}, sum = {0, 0};
  uint64_t z = 0, square, term, odd;
  uint32_t k = 0;
  while (n >> (k + 1) != 0) ++k;
  ratio.high = n - (UINT32_C(1) << k);
  (void)pipegs_wide_divide(ratio, (uint64_t)n + (UINT32_C(1) << k), &z);
  square = pipegs_wide_multiply(z, z).high;
  sum.low = z;
  for (term = z, odd = 3; term != 0; odd += 2) {
    term = pipegs_wide_multiply(term, square).high;
    sum.low += term / odd;
  }
  sum = pipegs_wide_add(pipegs_wide_left(sum, 2), pipegs_wide_multiply(ln2, 2 * k));
  return pipegs_wide_right(sum, 4).low;
}

/* The quaternion of a rotation by the largest of its components, times a factor that the length takes out again. No
 * entry is beyond 2, so sums of them have 63 bits; whatever they are, the length is 2^60 or more. */
static void set_quaternion(const struct pipegs_camera *camera, uint32_t width, int64_t *const q[4]) {
  int64_t m[3][3] = {{0}}, v[4];
  struct pipegs_wide sum = {0, 0};
  uint64_t length;
  const int64_t one = INT64_C(1) << ROTATION_F;
  int i, j, k;
  for (i = 0; i < 9; ++i) (void)rounded(camera->rotation[i / 3][i % 3], ROTATION_F, &m[i / 3][i % 3]);
  if (m[0][0] + m[1][1] + m[2][2] > 0) {
    v[0] = one + m[0][0] + m[1][1] + m[2][2];
    v[1] = m[2][1] - m[1][2];
    v[2] = m[0][2] - m[2][0];
    v[3] = m[1][0] - m[0][1];
  } else {
    i = m[0][0] >= m[1][1] && m[0][0] >= m[2][2] ? 0 : m[1][1] >= m[2][2] ? 1 : 2;
    j = (i + 1) % 3;
    k = (i + 2) % 3;
    v[0] = m[k][j] - m[j][k];
    v[1 + i] = one + m[i][i] - m[j][j] - m[k][k];
    v[1 + j] = m[j][i] + m[i][j];
    v[1 + k] = m[k][i] + m[i][k];
  }
  for (i = 0; i < 4; ++i) {
    const uint64_t size = v[i] < 0 ? 0 - (uint64_t)v[i] : (uint64_t)v[i];
    sum = pipegs_wide_add(sum, pipegs_wide_multiply(size, size));
  }
  length = pipegs_wide_root(sum);
  for (i = 0; i < 4; ++i) {
    struct pipegs_wide size = {0, 0};
    uint64_t twice = 0;
    size.low = v[i] < 0 ? 0 - (uint64_t)v[i] : (uint64_t)v[i];
    (void)pipegs_wide_divide(pipegs_wide_left(size, (int)width - ROTATION_BITS + 1), length, &twice);
    twice = (twice + 1) >> 1;
    *q[i] = v[i] < 0 ? -(int64_t)twice : (int64_t)twice;
  }
}

static enum pipegs_setup set_pose(const struct pipegs_configuration *config, const struct pipegs_scene *scene,
                                  const struct pipegs_camera *camera, struct pipegs_frame *frame) {
  int64_t *const position[3] = {&frame->camera_position_x, &frame->camera_position_y, &frame->camera_position_z};
  int64_t *const rotation[9] = {&frame->camera_rotation_w00, &frame->camera_rotation_w01, &frame->camera_rotation_w02,
                                &frame->camera_rotation_w10, &frame->camera_rotation_w11, &frame->camera_rotation_w12,
                                &frame->camera_rotation_w20, &frame->camera_rotation_w21, &frame->camera_rotation_w22};
  int64_t *const quaternion[4] = {&frame->camera_quaternion_w, &frame->camera_quaternion_x,
                                  &frame->camera_quaternion_y, &frame->camera_quaternion_z};
  int i;
  for (i = 0; i < 3; ++i) {
    /* One bit below world_w, so that centre - camera keeps world_w + 1 bits in every unit. */
    if (!signed_field(camera->position[i], -scene->exponent, config->world_w - 1, position[i])) {
      return i == 0 ? PIPEGS_SETUP_POSITION_X : i == 1 ? PIPEGS_SETUP_POSITION_Y : PIPEGS_SETUP_POSITION_Z;
    }
  }
  for (i = 0; i < 9; ++i) {
    if (!signed_field(camera->rotation[i / 3][i % 3], (int)config->rot_w - ROTATION_BITS, config->rot_w, rotation[i])) {
      return PIPEGS_SETUP_ROTATION;
    }
  }
  set_quaternion(camera, config->cam_quat_w, quaternion);
  return PIPEGS_SETUP_OK;
}

/* 13/10 size / (2 focal), to the nearest. */
static bool set_guard(struct pipegs_number focal, uint32_t size, uint32_t fraction, uint64_t *limit) {
  struct pipegs_wide numerator = {0, 0};
  uint64_t twice = 0;
  /* A focal length that fits its field is below 2^14 and not below 2^-15: 19 bits shifted by 0 to 102 places. */
  numerator.low = 26 * (uint64_t)size;
  if (!pipegs_wide_divide(pipegs_wide_left(numerator, (int)fraction - focal.exponent), (uint64_t)focal.mantissa,
                          &twice)) {
    return false;
  }
  *limit = (twice / 20 + 1) >> 1;
  return *limit >> (GUARD_BITS + fraction) == 0;
}

/* sqrt(2 ln AlphaCut focal^2 (1 + slope^2)) of a slope one unit above the guard band, rounded up, and one: a bound on
 * what the machine computes. */
static bool set_reach(const struct pipegs_configuration *config, uint64_t focal, uint64_t limit, uint64_t *reach) {
  const uint64_t hypotenuse = (UINT64_C(1) << (2 * config->tan_f)) + (limit + 1) * (limit + 1);
  int exponent;
  const uint64_t square = pipegs_wide_leading(pipegs_wide_multiply(focal * focal, hypotenuse), &exponent);
  struct pipegs_wide product = pipegs_wide_multiply(square, two_logarithms(config->alpha_cut));
  exponent -= 60;
  if (exponent % 2 != 0) {
    product = pipegs_wide_right(product, 1);
    ++exponent;
  }
  *reach = pipegs_wide_root(product) >> ((int)config->tan_f - exponent / 2);
  *reach += 2;
  return *reach >> config->reach_w == 0;
}

uint64_t pipegs_spread(uint32_t alpha_cut, uint64_t focal) {
  int exponent, e;
  struct pipegs_wide product;
  if (focal == 0) return 0;
  product = pipegs_wide_multiply(
      pipegs_wide_leading(pipegs_wide_multiply(focal * focal, (1 << SPREAD_MANTISSA) + 1), &exponent),
      two_logarithms(alpha_cut));
  /* The product's unit: of the logarithm, of two focal lengths, of 257/256. */
  e = pipegs_wide_bits(product) - 1 + exponent - 60 - 2 * FOCAL_BITS - SPREAD_MANTISSA;
  if (e < 0) return 0;
  /* A mantissa that rounds up to 2 carries into the exponent. */
  return ((uint64_t)e << SPREAD_MANTISSA) + 1 - (UINT64_C(1) << SPREAD_MANTISSA) +
         pipegs_wide_right(product, pipegs_wide_bits(product) - 1 - SPREAD_MANTISSA).low;
}

/* Focal length, principal point, guard band and reach of one image axis; the errors follow one another. */
static enum pipegs_setup set_lens(const struct pipegs_configuration *config, const struct pipegs_camera *camera,
                                  int axis, struct pipegs_frame *frame) {
  const int begin = axis == 0 ? PIPEGS_SETUP_FOCAL_X : PIPEGS_SETUP_FOCAL_Y;
  uint64_t *const focal = axis == 0 ? &frame->lens_focal_x : &frame->lens_focal_y;
  uint64_t *const limit = axis == 0 ? &frame->lens_limit_x : &frame->lens_limit_y;
  const uint32_t size = axis == 0 ? camera->width : camera->height;
  const uint32_t of = axis == 0 ? camera->of_width : camera->of_height;
  const uint32_t whole = of == 0 ? size : of;
  uint64_t *const spread = axis == 0 ? &frame->lens_spread_x : &frame->lens_spread_y;
  if (!unsigned_field(camera->focal[axis], (int)config->focal_w - FOCAL_BITS, config->focal_w, focal) || *focal == 0) {
    return (enum pipegs_setup)begin;
  }
  if (!signed_field(camera->center[axis], (int)config->center_w - CENTER_BITS, config->center_w,
                    axis == 0 ? &frame->lens_center_x : &frame->lens_center_y)) {
    return (enum pipegs_setup)(begin + 1);
  }
  if (!set_guard(camera->focal[axis], whole, config->tan_f, limit)) {
    return (enum pipegs_setup)(begin + 2);
  }
  if (!set_reach(config, *focal, *limit, axis == 0 ? &frame->lens_reach_x : &frame->lens_reach_y)) {
    return (enum pipegs_setup)(begin + 3);
  }
  *spread = config->tight_cull ? pipegs_spread(config->alpha_cut, *focal) : 0;
  return PIPEGS_SETUP_OK;
}

/* Most lists of a frame: those of 16 pixels are small, and many. */
static uint32_t most_lists(const struct pipegs_configuration *config) {
  return UINT32_C(1) << (config->window == TILE ? TILE_LIST_WINDOW_W : LIST_WINDOW_W);
}

/* The least scale whose reach is at least half the way between the eyes: |half| focal / reach, up. */
static uint64_t eye_reach(int64_t half, uint64_t focal, uint64_t reach) {
  uint64_t scale = 0;
  if (half == 0) return 0;
  (void)pipegs_wide_divide(pipegs_wide_multiply((uint64_t)(half < 0 ? -half : half), focal), reach, &scale);
  return scale + 1; /* the reach is more than twice the focal length: less than half, and the quotient fits */
}

enum pipegs_setup pipegs_setup_eyes(const struct pipegs_configuration *config, const struct pipegs_scene *scene,
                                    const struct pipegs_number half[2], struct pipegs_job *job) {
  struct pipegs_frame *const frame = &job->frame;
  int64_t x, y;
  uint64_t larger;
  if (config->eyes < 2 || !signed_field(half[0], -scene->exponent, config->half_eye_w, &x) ||
      !signed_field(half[1], -scene->exponent, config->half_eye_w, &y)) {
    return PIPEGS_SETUP_EYES;
  }
  frame->eyes_half_x = x;
  frame->eyes_half_y = y;
  frame->eyes_length = 0;
  for (larger = (uint64_t)(x < 0 ? -x : x) | (uint64_t)(y < 0 ? -y : y); larger != 0; larger >>= 1) {
    ++frame->eyes_length;
  }
  frame->eyes_reach_x = eye_reach(x, frame->lens_focal_x, frame->lens_reach_x);
  frame->eyes_reach_y = eye_reach(y, frame->lens_focal_y, frame->lens_reach_y);
  frame->raster_eyes = 3;
  return PIPEGS_SETUP_OK;
}

static uint32_t windows_along(const struct pipegs_configuration *config, uint32_t pixels) {
  return (pixels + config->window - 1) / config->window;
}

static enum pipegs_setup set_windows(const struct pipegs_configuration *config, const struct pipegs_camera *camera,
                                     const struct pipegs_windows *windows, struct pipegs_frame *frame) {
  const uint32_t side = UINT32_C(1) << (config->size_w - 1);
  const uint32_t columns = windows_along(config, camera->width), rows = windows_along(config, camera->height);
  struct pipegs_windows range;
  if (camera->width < 1 || camera->width > side || columns > UINT32_C(1) << WINDOW_W) return PIPEGS_SETUP_WIDTH;
  if (camera->height < 1 || camera->height > side || rows > UINT32_C(1) << WINDOW_W) return PIPEGS_SETUP_HEIGHT;
  range.first_x = range.first_y = 0;
  range.last_x = columns - 1;
  range.last_y = rows - 1;
  if (windows != 0) range = *windows;
  if (range.first_x > range.last_x || range.last_x >= columns || range.first_y > range.last_y || range.last_y >= rows) {
    return PIPEGS_SETUP_WINDOWS;
  }
  if (config->order == 1 &&
      (range.last_x - range.first_x + 1) * (range.last_y - range.first_y + 1) > most_lists(config)) {
    return PIPEGS_SETUP_LISTS;
  }
  frame->raster_width = camera->width;
  frame->raster_height = camera->height;
  frame->raster_windows_first_x = range.first_x;
  frame->raster_windows_first_y = range.first_y;
  frame->raster_windows_last_x = range.last_x;
  frame->raster_windows_last_y = range.last_y;
  return PIPEGS_SETUP_OK;
}

uint64_t pipegs_pixels_size(const struct pipegs_configuration *config, const struct pipegs_camera *camera) {
  return (uint64_t)windows_along(config, camera->width) * windows_along(config, camera->height) * config->window *
         config->window * (config->pixel_w / 8);
}

/* a * b lines, not below AREA_LEAST, cut at `most`. */
static uint64_t area(uint64_t a, uint64_t b, uint64_t most) {
  const struct pipegs_wide lines = pipegs_wide_multiply(a, b);
  if (lines.high != 0 || lines.low > most) return most;
  return lines.low < AREA_LEAST ? AREA_LEAST : lines.low;
}

uint64_t pipegs_overflow_size(const struct pipegs_configuration *config, uint64_t slots, uint64_t windows) {
  const bool lists = config->list_entry_w != 0;
  const uint64_t units = config->units, layers = lists ? 1 : 2;
  uint64_t share = 0, list = AREA_LEAST; /* lines of a unit, and of a list */
  uint32_t list_w = 6;
  if (windows > most_lists(config)) windows = most_lists(config); /* a frame with more lists is refused */
  if (config->overflow) share = 2 * area(slots, config->parts, GIBIBYTE / (2 * units)); /* as much for keys */
  if (config->alpha_memory_lines != 0) {
    const uint64_t of_slot = (uint64_t)config->regions * config->alpha_memory_lines * (lists ? windows : 1);
    const uint64_t alphas = layers * area(slots, of_slot, GIBIBYTE / (layers * units));
    share = 2 * (alphas > share ? alphas : share); /* the SU has the other half */
  }
  share = (share + 15) / 16 * 16; /* every part of it is exact */
  if (!lists) return units * share * config->line;
  for (; list <= slots && list_w < config->list_entry_w && windows * list <= GIBIBYTE; ++list_w) list *= 2;
  list += LIST_GAP;
  return 2 * (units * share > windows * list ? units * share : windows * list) * config->line;
}

/* How many AOVs the machine has. */
static uint64_t aovs_of(const struct pipegs_configuration *config) {
  uint64_t count = 0;
  uint32_t left = config->aovs;
  for (; left != 0; left &= left - 1) ++count;
  return count;
}

struct pipegs_memory pipegs_place(const struct pipegs_configuration *config, const struct pipegs_scene *scene,
                                  const struct pipegs_camera *camera, uint64_t image) {
  const uint64_t windows = (uint64_t)windows_along(config, camera->width) * windows_along(config, camera->height);
  const uint64_t pixels = pipegs_pixels_size(config, camera);
  struct pipegs_memory memory;
  memory.scene = image;
  memory.pixels = image + scene->size;
  memory.aovs = memory.pixels + config->eyes * pixels;
  memory.overflow = (memory.aovs + aovs_of(config) * config->eyes * pixels + PIPEGS_OVERFLOW_ALIGNMENT - 1) /
                    PIPEGS_OVERFLOW_ALIGNMENT * PIPEGS_OVERFLOW_ALIGNMENT;
  memory.overflow_size = pipegs_overflow_size(config, scene->slots, windows);
  return memory;
}

/* Do the records in the image have the fields that this machine reads? */
static bool same_records(const struct pipegs_configuration *a, const struct pipegs_configuration *b) {
  return a->grid == b->grid && a->table_cells == b->table_cells && a->chunk == b->chunk && a->group == b->group &&
         a->tight_boxes == b->tight_boxes && a->sh_degree == b->sh_degree && a->coded == b->coded &&
         a->pos_w == b->pos_w && a->quat_w == b->quat_w && a->scale_m_w == b->scale_m_w &&
         a->scale_e_w == b->scale_e_w && a->base_w == b->base_w && a->sh_m_w == b->sh_m_w && a->sh_e_w == b->sh_e_w &&
         a->opacity_f == b->opacity_f && a->world_w == b->world_w && a->index_w == b->index_w &&
         a->half_w == b->half_w && a->hull_w == b->hull_w && a->slot_w == b->slot_w && a->count_w == b->count_w &&
         a->focal_w == b->focal_w && a->line == b->line && a->alpha_cut == b->alpha_cut;
}

/* A place of the machine's memory: aligned, and all of it there. */
static bool lies(const struct pipegs_configuration *config, uint64_t address, uint64_t size, uint64_t alignment) {
  const uint64_t end = (UINT64_C(1) << config->address_w) * config->line;
  return address % alignment == 0 && size % config->line == 0 && address < end && size <= end - address;
}

/* Octave of a distance, in world units, that no mean of the scene exceeds: the sum of those along the axes to the
 * farther side of its grid, each a unit up. */
static uint64_t farthest(const struct pipegs_configuration *config, const struct pipegs_scene *scene,
                         const struct pipegs_frame *frame) {
  const int64_t position[3] = {frame->camera_position_x, frame->camera_position_y, frame->camera_position_z};
  uint64_t distance = 1, octave = 0;
  int axis;
  for (axis = 0; axis < 3; ++axis) {
    const uint64_t scale = scene->grid_scale[axis] == 0 ? 1 : scene->grid_scale[axis];
    const int64_t extent = (int64_t)(((uint64_t)config->grid << config->world_w) / scale) + 1;
    const int64_t low = position[axis] - scene->grid_low[axis], high = scene->grid_low[axis] + extent - position[axis];
    distance += (uint64_t)(low > high ? low : high);
  }
  while (distance >> octave > 1) ++octave;
  return octave;
}

static enum pipegs_setup set_tables(const struct pipegs_configuration *config, const struct pipegs_scene *scene,
                                    const struct pipegs_memory *memory, uint64_t pixels, struct pipegs_job *job) {
  if (!lies(config, memory->scene, scene->size, config->line) || !lies(config, memory->pixels, pixels, config->line) ||
      !lies(config, memory->overflow, memory->overflow_size, PIPEGS_OVERFLOW_ALIGNMENT) ||
      (config->aovs != 0 && !lies(config, memory->aovs, aovs_of(config) * pixels, config->line))) {
    return PIPEGS_SETUP_MEMORY;
  }
  job->frame.tables_cells = memory->scene + scene->cells;
  job->frame.tables_groups = memory->scene + scene->groups;
  job->frame.tables_chunks = memory->scene + scene->chunks;
  job->frame.tables_gaussians = memory->scene + scene->gaussians;
  job->frame.tables_colors = memory->scene + scene->colors;
  job->frame.tables_sh_degree = scene->sh_degree;
  job->frame.tables_antialias = scene->antialias;
  job->frame.tables_pixels = memory->pixels;
  job->frame.tables_overflow = memory->overflow;
  job->areas.cells = scene->groups - scene->cells;
  job->areas.groups = scene->chunks - scene->groups;
  job->areas.chunks = scene->gaussians - scene->chunks;
  job->areas.gaussians = scene->colors - scene->gaussians;
  job->areas.colors = scene->size - scene->colors;
  job->areas.pixels = pixels;
  job->areas.overflow = memory->overflow_size;
  return PIPEGS_SETUP_OK;
}

enum pipegs_setup pipegs_setup_job(const struct pipegs_configuration *config, const struct pipegs_scene *scene,
                                   const struct pipegs_camera *camera, const struct pipegs_windows *windows,
                                   const struct pipegs_memory *memory, struct pipegs_job *job) {
  struct pipegs_frame *const frame = &job->frame;
  enum pipegs_setup result;
  int axis;
  *frame = (struct pipegs_frame){0}; /* the whole picture: no rest, no level of detail */
  if (!same_records(config, &scene->packed_for)) return PIPEGS_SETUP_SCENE;
  if ((result = set_windows(config, camera, windows, frame)) != PIPEGS_SETUP_OK) return result;
  if ((result = set_pose(config, scene, camera, frame)) != PIPEGS_SETUP_OK) return result;
  for (axis = 0; axis < 2; ++axis) {
    if ((result = set_lens(config, camera, axis, frame)) != PIPEGS_SETUP_OK) return result;
  }
  if (!unsigned_field(camera->near_plane, -scene->exponent, config->world_w - 1, &frame->lens_near_plane)) {
    return PIPEGS_SETUP_NEAR_PLANE;
  }
  if (scene->antialias && !config->antialias) return PIPEGS_SETUP_ANTIALIAS;
  frame->grid_low_x = scene->grid_low[0];
  frame->grid_low_y = scene->grid_low[1];
  frame->grid_low_z = scene->grid_low[2];
  frame->grid_scale_x = scene->grid_scale[0];
  frame->grid_scale_y = scene->grid_scale[1];
  frame->grid_scale_z = scene->grid_scale[2];
  if (config->aovs != 0) {
    frame->raster_aovs_range = farthest(config, scene, frame);
    frame->raster_aovs_base = memory->aovs;
    frame->raster_aovs_lines = config->eyes * pipegs_pixels_size(config, camera);
  }
  if (config->eyes > 1) {
    frame->raster_eyes = 1;
    frame->raster_eye_lines = pipegs_pixels_size(config, camera);
  }
  frame->walk_most = config->order == 2 && config->window > SQUARE ? PIPEGS_WALK_MOST : 0;
  return set_tables(config, scene, memory, config->eyes * pipegs_pixels_size(config, camera), job);
}
