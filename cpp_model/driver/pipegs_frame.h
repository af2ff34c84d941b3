/* SPDX-License-Identifier: Apache-2.0
 * pipegs_frame.h: what a start queues, computed from a packed scene and a camera, in integers alone.
 *
 * Paper   Sec. 2.1 (projection constants).
 * Idea    Everything that is the same for all Gaussians of a frame is computed here once. A number of the camera is
 *         mantissa * 2^exponent: fixed point in the caller's own unit, or the two parts of a float. Products have up to
 *         128 bits, so any processor gives the same words. What does not fit its field is an error, never a clamp.
 * Numbers Half a unit of the field at most, a tie away from 0: position, near plane, rotation, focal length, principal
 *         point (exact but for that), guard band (1.3 is 13/10). Quaternion: half a unit and 2^-40 of one, from the
 *         numbers of the rotation to 2^-60. Bounds, rounded up: reach, at most 2 units of u18.14 above
 *         sqrt(2 ln AlphaCut) fx sqrt(1 + limit^2) of the rounded focal length and the guard band one unit up; spread,
 *         less than 2^-8 above 2 ln AlphaCut fx^2 (1 + 2^-8), and 1 where that is smaller. 2 ln is good to 2^-57.
 * Sign    A quaternion and its negative are one rotation. Of the two it is the one whose w is positive when the trace
 *         is, else that whose largest component is positive. */
#ifndef PIPEGS_FRAME_H
#define PIPEGS_FRAME_H

#include "pipegs.h"

#ifdef __cplusplus
extern "C" {
#endif

/* mantissa * 2^exponent */
struct pipegs_number {
  int64_t mantissa;
  int32_t exponent;
};

/* camera space = rotation * (p - position), axes right, down, forward; pixel = focal * xy / z + center. */
struct pipegs_camera {
  struct pipegs_number position[3];    /* scene units */
  struct pipegs_number rotation[3][3]; /* rows: right, down, forward; orthonormal */
  struct pipegs_number focal[2];       /* pixels, x and y */
  struct pipegs_number center[2];      /* pixels; pixel i has its centre at i, so (width - 1) / 2 is the middle */
  struct pipegs_number near_plane;     /* scene units */
  uint32_t width, height;              /* pixels */
  uint32_t of_width, of_height;        /* of the picture of which this is a part; 0: it is the whole one */
};

/* INRIA's near plane, 0.2, as a double has it. */
#define PIPEGS_NEAR_PLANE \
  { INT64_C(0x1999999999999a), -55 }

/* What the packer knows of a scene (`pipegs pack` prints it). Places are bytes from the beginning of the image, each
 * table up to the next one, multiples of a line. */
struct pipegs_scene {
  struct pipegs_configuration packed_for; /* what its records need of it is compared */
  int32_t exponent;                       /* a world unit is 2^exponent scene units */
  uint32_t sh_degree, antialias;
  int64_t grid_low[3];    /* world units */
  uint64_t grid_scale[3]; /* cells per world unit * 2^world_w */
  uint64_t cells, groups, chunks, gaussians, colors, size;
  uint64_t slots; /* of Gaussians, empty ones among them */
};

/* Where things lie in the machine's memory: byte addresses, multiples of a line. */
struct pipegs_memory {
  uint64_t scene;    /* the image */
  uint64_t pixels;   /* the frame by windows, pipegs_pixels_size bytes */
  uint64_t aovs;     /* one AOV behind the other, each as large; of a machine that has some */
  uint64_t overflow;      /* the overflow areas, a multiple of PIPEGS_OVERFLOW_ALIGNMENT */
  uint64_t overflow_size; /* a multiple of a line; area_full says that it was too small */
};
#define PIPEGS_OVERFLOW_ALIGNMENT UINT64_C(0x40000)

/* Frame field walk_most as pipegs_setup_job leaves it: a window with more Gaussians at about one depth is walked part
 * by part. No pixel depends on it; a caller may write any number, 0 for windows that are always walked whole. */
#define PIPEGS_WALK_MOST 32000

/* Columns and rows of windows, both ends included. */
struct pipegs_windows {
  uint32_t first_x, first_y, last_x, last_y;
};

/* Which value does not fit; PIPEGS_SETUP_OK is 0. */
enum pipegs_setup {
  PIPEGS_SETUP_OK = 0,
  PIPEGS_SETUP_SCENE, /* packed for other records than this machine's */
  PIPEGS_SETUP_POSITION_X,
  PIPEGS_SETUP_POSITION_Y,
  PIPEGS_SETUP_POSITION_Z,
  PIPEGS_SETUP_ROTATION, /* an entry of 2 or more */
  PIPEGS_SETUP_FOCAL_X,
  PIPEGS_SETUP_CENTER_X,
  PIPEGS_SETUP_GUARD_X, /* 1.3 tan(fov / 2) is 16 or more */
  PIPEGS_SETUP_REACH_X,
  PIPEGS_SETUP_FOCAL_Y,
  PIPEGS_SETUP_CENTER_Y,
  PIPEGS_SETUP_GUARD_Y,
  PIPEGS_SETUP_REACH_Y,
  PIPEGS_SETUP_NEAR_PLANE,
  PIPEGS_SETUP_ANTIALIAS, /* the scene needs what this machine has not */
  PIPEGS_SETUP_WIDTH,
  PIPEGS_SETUP_HEIGHT,
  PIPEGS_SETUP_WINDOWS, /* not within the picture */
  PIPEGS_SETUP_LISTS,   /* more windows than lists (order = 1) */
  PIPEGS_SETUP_EYES,    /* no machine for two, or too far apart */
  PIPEGS_SETUP_MEMORY   /* an address that is not aligned or that the machine does not have */
};

/* Bytes of a frame's pixels by windows, whole windows. */
uint64_t pipegs_pixels_size(const struct pipegs_configuration *config, const struct pipegs_camera *camera);

/* Bytes of the overflow areas of a frame of so many windows of a scene of so many slots, as many as it can need at
 * most: a splat of every Gaussian in each part of a window, all in one SU; a line of alphas for each region; a list as
 * long as the scene. Where that is too much it is cut: at 1 GiB of records and keys and 1 GiB of alphas for all units
 * together, and at 2 GiB of lists, beside the gaps between them. A frame that needs more ends with the error
 * area_full. */
uint64_t pipegs_overflow_size(const struct pipegs_configuration *config, uint64_t slots, uint64_t windows);

/* The pixels behind the image, room for all AOVs of the machine behind them, then the overflow areas, as large as a
 * frame of all windows can need: what one frame at a time takes. A caller with less memory makes overflow_size
 * smaller. */
struct pipegs_memory pipegs_place(const struct pipegs_configuration *config, const struct pipegs_scene *scene,
                                  const struct pipegs_camera *camera, uint64_t image);

/* What a frame writes beside colours: bits of frame.raster_aovs_wanted, and of config.aovs where the machine has it.
 * They lie in this order, each with frame.raster_aovs_lines bytes. */
#define PIPEGS_AOV_COVERAGE 1u
#define PIPEGS_AOV_DEPTH 2u
#define PIPEGS_AOV_MEDIAN 4u
#define PIPEGS_AOV_INDEX 8u

/* Fills frame and areas of `job`; the picture in raster order is the caller's. `windows` 0: all. No AOV is wanted: a
 * caller sets bits of frame.raster_aovs_wanted. Where they lie and the range of their depths, which reaches behind the
 * farthest corner of the scene's grid, are there; in raster order with a stride larger than it must be, frame.
 * raster_aovs_lines (bytes) is to be raised to stride * height. */
enum pipegs_setup pipegs_setup_job(const struct pipegs_configuration *config, const struct pipegs_scene *scene,
                                   const struct pipegs_camera *camera, const struct pipegs_windows *windows,
                                   const struct pipegs_memory *memory, struct pipegs_job *job);

/* Two eyes (a machine with eyes = 2): the camera stands between them, and the second one twice `half` further to its
 * right and down (scene units) than the first one. Both have its rotation and lens. Makes `job` write both pictures:
 * that of the second eye lies behind that of the first one by windows, as does each AOV of it; in raster order frame.
 * raster_eye_lines (bytes) is to be set so that both have room. Without it only the first eye's picture is made, that
 * of the camera. */
enum pipegs_setup pipegs_setup_eyes(const struct pipegs_configuration *config, const struct pipegs_scene *scene,
                                    const struct pipegs_number half[2], struct pipegs_job *job);

/* The field lens.spread_x or _y of a rounded focal length, for a machine that has it (tight_cull). */
uint64_t pipegs_spread(uint32_t alpha_cut, uint64_t focal);

#ifdef __cplusplus
}
#endif

#endif
