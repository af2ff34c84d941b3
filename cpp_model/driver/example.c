/* SPDX-License-Identifier: Apache-2.0
 * example.c: a program that renders one frame, of two eyes and with its depths on a machine that makes them. `pipegs
 * pack` (for two eyes with --stereo) wrote image.bin, which lies in the machine's memory, and scene.h, which is
 * compiled with it; pipegs_platform.h says what the system supplies. Returns 0 when the pixels are in memory at the
 * address that pipegs_place gave them. */
#include "pipegs_frame.h"
#include "pipegs_platform.h"
#include "scene.h"

static int fail(const char *text) {
  pipegs_platform_print(text);
  return 1;
}

/* What went wrong while a frame was rendered; the machine is idle and without errors behind it. */
static int fail_frame(struct pipegs_device *device) {
  const struct pipegs_error error = pipegs_get_error(device);
  char text[400];
  pipegs_error_text(&error, text, sizeof text);
  pipegs_abort(device, PIPEGS_NO_LIMIT);
  pipegs_clear_error(device, error.causes);
  return fail(text);
}

int main(void) {
  static const struct pipegs_bus bus = {pipegs_platform_read, pipegs_platform_write, pipegs_platform_wait, 0};
  static const struct pipegs_number half[2] = PIPEGS_PACKED_HALF;
  static struct pipegs_device device;
  static struct pipegs_job job; /* the picture: by windows, no raster order */
  struct pipegs_memory memory;
  uint32_t ticket;

  if (pipegs_identify(&device, &bus) != PIPEGS_OK) return fail("no PipeGS with the registers of this driver");
  memory = pipegs_place(&device.config, &pipegs_packed_scene, &pipegs_packed_camera, pipegs_platform_image());
  if (pipegs_setup_job(&device.config, &pipegs_packed_scene, &pipegs_packed_camera, 0, &memory, &job) !=
      PIPEGS_SETUP_OK) {
    return fail("this machine cannot render this scene from this camera");
  }
  if (device.config.eyes > 1 &&
      pipegs_setup_eyes(&device.config, &pipegs_packed_scene, half, &job) != PIPEGS_SETUP_OK) {
    return fail("this machine cannot see this scene with these eyes");
  }
  job.frame.raster_aovs_wanted = device.config.aovs & PIPEGS_AOV_DEPTH;
  pipegs_enable(&device, PIPEGS_IRQ_ENABLE_FRAME_DONE | PIPEGS_IRQ_ENABLE_QUEUE_FREE | PIPEGS_IRQ_ENABLE_ERROR);
  if (pipegs_queue(&device, &job, PIPEGS_NO_LIMIT, &ticket) != PIPEGS_OK) return fail_frame(&device);
  if (pipegs_wait(&device, ticket, PIPEGS_NO_LIMIT) != PIPEGS_OK) return fail_frame(&device);
  pipegs_platform_print("the frame is in memory");
  return 0;
}
