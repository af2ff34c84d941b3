/* SPDX-License-Identifier: Apache-2.0
 * pipegs.h: a driver of PipeGS in C99: what a program without an operating system needs to render frames.
 *
 * Idea    The machine is reached through two functions that read and write a register, so the same driver serves a
 *         memory-mapped machine, a simulated one and a test. It allocates nothing, prints nothing, and keeps no state
 *         but struct pipegs_device. What is queued is a struct pipegs_job: frame, areas and picture, all in bytes;
 *         pipegs_frame.h computes it from a packed scene and a camera.
 * Order   pipegs_identify once; then for each frame pipegs_queue, and pipegs_wait for its ticket, before or after the
 *         next frame is queued: the machine renders one frame while one waits.
 * Waiting Either pipegs_wait, which polls (between two polls it calls `idle`), or a handler of the interrupt that calls
 *         pipegs_interrupt and pipegs_done. Not both: each clears the events that the other waits for.
 * Threads None: calls for one device must not overlap. */
#ifndef PIPEGS_H
#define PIPEGS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "pipegs_registers.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Access to the registers; `offset` is a multiple of 4 below 4096. */
struct pipegs_bus {
  uint32_t (*read)(void *context, uint32_t offset);
  void (*write)(void *context, uint32_t offset, uint32_t value);
  /* Returns at the latest when the interrupt is high; every event that is waited for must be enabled then
   * (pipegs_enable). 0: waiting polls without a pause. */
  void (*idle)(void *context);
  void *context;
};

/* The registers at an address of this processor's memory. */
struct pipegs_bus pipegs_memory_mapped(volatile uint32_t *registers);

enum pipegs_result {
  PIPEGS_OK = 0,
  PIPEGS_NO_MACHINE,   /* ID is another one */
  PIPEGS_OTHER_LAYOUT, /* the machine's registers are not those of pipegs_registers.h */
  PIPEGS_FULL,         /* a frame is queued: the next one must wait */
  PIPEGS_PENDING,      /* the frame is not complete yet */
  PIPEGS_FAILED,       /* a bit of ERROR is set: pipegs_get_error */
  PIPEGS_GIVEN_UP,     /* the machine is idle, and the frame is not complete */
  PIPEGS_TIMEOUT       /* polled as often as the caller allowed */
};

/* What a start queues: the slots of the registers. */
struct pipegs_job {
  struct pipegs_frame frame;
  struct pipegs_areas areas;
  struct pipegs_picture picture;
};
#define PIPEGS_JOB_SLOTS (PIPEGS_FRAME_SLOTS + PIPEGS_AREAS_SLOTS + PIPEGS_PICTURE_SLOTS)

/* Its fields belong to the driver; `config` may be read. */
struct pipegs_device {
  struct pipegs_bus bus;
  struct pipegs_configuration config;
  uint64_t written[PIPEGS_JOB_SLOTS]; /* what was written to the slots last, when `known` */
  bool known;
  uint32_t ticket; /* what FRAMES_DONE is when all that was queued is complete */
};

#define PIPEGS_NO_LIMIT 0u /* of polls */

/* Compares ID, major version and LAYOUT, and reads the configuration. Call it again after a reset of the machine. */
enum pipegs_result pipegs_identify(struct pipegs_device *device, const struct pipegs_bus *bus);

/* Can the next frame be written? */
bool pipegs_queue_free(const struct pipegs_device *device);

/* Waits until the queue is free, at most `polls` times. PIPEGS_FAILED at once when an error is there. */
enum pipegs_result pipegs_wait_queue(struct pipegs_device *device, uint32_t polls);

/* Writes the words of the slots that differ from those written before, or all; the queue must be free. */
void pipegs_write(struct pipegs_device *device, const struct pipegs_job *job, bool all);

/* Queues what was written and returns its ticket. The queue must be free. */
uint32_t pipegs_start(struct pipegs_device *device);

/* The three in one: PIPEGS_OK and a ticket, or PIPEGS_FULL after `polls`, or PIPEGS_FAILED. */
enum pipegs_result pipegs_queue(struct pipegs_device *device, const struct pipegs_job *job, uint32_t polls,
                                uint32_t *ticket);

/* Is the frame of this ticket complete in memory? PIPEGS_OK, PIPEGS_PENDING, PIPEGS_FAILED or PIPEGS_GIVEN_UP. */
enum pipegs_result pipegs_done(const struct pipegs_device *device, uint32_t ticket);

/* Waits for it, at most `polls` times; PIPEGS_TIMEOUT after that. */
enum pipegs_result pipegs_wait(struct pipegs_device *device, uint32_t ticket, uint32_t polls);

/* Which events raise the interrupt: bits of IRQ_ENABLE. */
void pipegs_enable(const struct pipegs_device *device, uint32_t events);

/* For the handler: what happened, as bits of IRQ_STATUS, which are clear then. */
uint32_t pipegs_interrupt(const struct pipegs_device *device);

/* Gives up what runs and what is queued, and waits until the machine is idle. Every ticket is void then. A machine
 * whose memory is silent is idle, too, once the time-out has passed. */
enum pipegs_result pipegs_abort(struct pipegs_device *device, uint32_t polls);

/* For how many cycles memory may owe answers without any before its frames fail, with READ_TIMEOUT or WRITE_TIMEOUT; 0:
 * for ever, and then a wait without a limit is one, too. After a reset of the machine it is 2^24. */
void pipegs_set_timeout(const struct pipegs_device *device, uint32_t cycles);

/* Has memory owed answers for longer than that? A frame that is queued fails, too, until it gives them: then the
 * machine goes on by itself. Memory that has forgotten what it owes must be reset, and the machine with it. */
bool pipegs_silent(const struct pipegs_device *device);

struct pipegs_error {
  uint32_t causes;  /* bits of ERROR; 0: no error */
  bool has_first;   /* frames were given up */
  uint32_t first;   /* then: the bit of the cause that came first */
  bool has_address; /* then: it is known where; of a read that failed it is not */
  uint64_t address; /* then: the byte address of the line of memory that it concerns */
};

struct pipegs_error pipegs_get_error(const struct pipegs_device *device);

/* Clears these causes, and the event. What made them may still run: pipegs_abort first. */
void pipegs_clear_error(const struct pipegs_device *device, uint32_t causes);

/* What a bit of ERROR says (its number, 0 to 31), as text that is never freed. */
const char *pipegs_cause_text(uint32_t bit);

/* All causes, and which came first at which address, if it is known: "CAUSE; CAUSE; first: CAUSE, at 0x...". Cut to
 * `size` bytes, a 0 included; returns the length that the whole text has. */
size_t pipegs_error_text(const struct pipegs_error *error, char *text, size_t size);

/* The counter at this offset, a PIPEGS_COUNTERS_...; both words are of one moment. */
uint64_t pipegs_counter(const struct pipegs_device *device, uint32_t offset);

/* All counters, one after the other. */
void pipegs_get_counters(const struct pipegs_device *device, struct pipegs_counters *counters);

#ifdef __cplusplus
}
#endif

#endif
