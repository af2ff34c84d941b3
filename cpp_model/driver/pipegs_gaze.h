/* SPDX-License-Identifier: Apache-2.0
 * pipegs_gaze.h: one picture in several frames, whose resolution falls off around the pixel at which an eye looks.
 *
 * Paper   None: what a headset asks for, docs/headset.md.
 * Idea    Near the gaze each pixel is drawn; around that samples of 2 x 2 pixels, and farther out of 4 x 4. A frame of
 *         larger samples is a frame of fewer pixels: its lens is shorter by a power of two, its low-pass filter is as
 *         wide as its sample, and level of detail and rest count samples. So the machine needs nothing for it: the
 *         square around the gaze is one frame, and each ring around it is four, queued one behind the other.
 * Seams   All edges are multiples of four pixels, or of the picture. Each pixel lies in one sample of one part.
 * Numbers Focal length exact; principal point to 2^-47 of a pixel. */
#ifndef PIPEGS_GAZE_H
#define PIPEGS_GAZE_H

#include "pipegs_frame.h"

#ifdef __cplusplus
extern "C" {
#endif

struct pipegs_gaze {
  int32_t x, y;        /* a pixel; it may lie outside of the picture */
  uint32_t full, half; /* pixels to each side of it, up to which samples have one pixel, and two in each direction */
};

struct pipegs_gaze_part {
  struct pipegs_camera camera; /* that of the part: sizes and lens in samples */
  uint32_t x, y;               /* the pixel of the picture at which it begins */
  uint32_t pitch;              /* a sample is 2^pitch pixels wide and high: 0, 1, 2 */
};
#define PIPEGS_GAZE_PARTS 9

/* The parts of a camera's picture, the gaze first; their number. 0 when `half` is less than `full`, the picture has no
 * pixels, or the principal point lies 2^15 pixels off or more. Each is a job of its own (pipegs_place,
 * pipegs_setup_job, pipegs_setup_eyes with its camera), whose pixels lie where the caller puts them. A part's last
 * column and row may reach up to three pixels beyond the picture. */
uint32_t pipegs_gaze_parts(const struct pipegs_camera *camera, const struct pipegs_gaze *gaze,
                           struct pipegs_gaze_part parts[PIPEGS_GAZE_PARTS]);

#ifdef __cplusplus
}
#endif
#endif
