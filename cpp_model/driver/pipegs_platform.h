/* SPDX-License-Identifier: Apache-2.0
 * pipegs_platform.h: what example.c needs of the system in which it runs. platform_mapped.c is that of a processor that
 * sees the registers in its memory; another system, or a simulation, supplies the same functions. */
#ifndef PIPEGS_PLATFORM_H
#define PIPEGS_PLATFORM_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A register of the machine, by its offset in bytes; `context` is 0. */
uint32_t pipegs_platform_read(void *context, uint32_t offset);
void pipegs_platform_write(void *context, uint32_t offset, uint32_t value);

/* Returns at the latest when the machine's interrupt is high; at once is right, too: then the program polls. */
void pipegs_platform_wait(void *context);

/* Where image.bin of `pipegs pack` lies, as the machine addresses its memory. The frame and its overflow areas come
 * behind it: `pipegs pack` says how much memory all of it takes. */
uint64_t pipegs_platform_image(void);

/* A line for a person, without its end. */
void pipegs_platform_print(const char *text);

#ifdef __cplusplus
}
#endif

#endif
