/* SPDX-License-Identifier: Apache-2.0
 * pipegs.c: see pipegs.h.
 *
 * Idea    A ticket is the value that FRAMES_DONE has when its frame is complete; both count modulo 2^32. An abort takes
 *         frames out of the count, so it sets the next ticket anew from the register.
 * Order   STATUS is read before FRAMES_DONE: a machine that was idle has counted all that it will count. Events are
 *         cleared before the state that they tell of is read, so that none is lost. */
#include "pipegs.h"

static uint32_t get(const struct pipegs_device *device, uint32_t offset) {
  return device->bus.read(device->bus.context, offset);
}

static void put(const struct pipegs_device *device, uint32_t offset, uint32_t value) {
  device->bus.write(device->bus.context, offset, value);
}

static uint32_t mapped_read(void *context, uint32_t offset) {
  return ((volatile uint32_t *)context)[offset / 4];
}

static void mapped_write(void *context, uint32_t offset, uint32_t value) {
  ((volatile uint32_t *)context)[offset / 4] = value;
}

struct pipegs_bus pipegs_memory_mapped(volatile uint32_t *registers) {
  struct pipegs_bus bus = {mapped_read, mapped_write, 0, 0};
  bus.context = (void *)registers;
  return bus;
}

enum pipegs_result pipegs_identify(struct pipegs_device *device, const struct pipegs_bus *bus) {
  device->bus = *bus;
  device->known = false;
  if (get(device, PIPEGS_ID) != PIPEGS_ID_VALUE) return PIPEGS_NO_MACHINE;
  if ((get(device, PIPEGS_VERSION) ^ PIPEGS_VERSION_VALUE) & PIPEGS_VERSION_MAJOR) return PIPEGS_OTHER_LAYOUT;
  if (get(device, PIPEGS_LAYOUT) != PIPEGS_LAYOUT_VALUE) return PIPEGS_OTHER_LAYOUT;
#define READ_FIELD(name, offset, low, width) \
  device->config.name = (get(device, offset) >> (low)) & (0xffffffffu >> (32 - (width)));
  PIPEGS_CONFIGURATION(READ_FIELD)
#undef READ_FIELD
  device->ticket = get(device, PIPEGS_FRAMES_DONE);
  return PIPEGS_OK;
}

bool pipegs_queue_free(const struct pipegs_device *device) {
  return !(get(device, PIPEGS_STATUS) & PIPEGS_STATUS_QUEUED);
}

/* Between two polls; false: that was the last one. An event that comes behind the clearing ends the idling. */
static bool poll_again(struct pipegs_device *device, uint32_t *polls) {
  if (*polls != PIPEGS_NO_LIMIT && --*polls == 0) return false;
  if (device->bus.idle) device->bus.idle(device->bus.context);
  return true;
}

static void clear_events(const struct pipegs_device *device) {
  if (device->bus.idle) (void)pipegs_interrupt(device);
}

enum pipegs_result pipegs_wait_queue(struct pipegs_device *device, uint32_t polls) {
  do {
    uint32_t status;
    clear_events(device);
    status = get(device, PIPEGS_STATUS);
    if (status & PIPEGS_STATUS_FAILED) return PIPEGS_FAILED;
    if (!(status & PIPEGS_STATUS_QUEUED)) return PIPEGS_OK;
  } while (poll_again(device, &polls));
  return PIPEGS_FULL;
}

/* A block of slots; `known` has what was written to them before. */
static void write_slots(struct pipegs_device *device, uint32_t offset, const uint64_t *slots, uint32_t count,
                        uint64_t *known, bool all) {
  uint32_t i;
  for (i = 0; i < count; ++i) {
    const uint64_t changed = all ? ~UINT64_C(0) : slots[i] ^ known[i];
    if (changed & 0xffffffffu) put(device, offset + 8 * i, (uint32_t)slots[i]);
    if (changed >> 32) put(device, offset + 8 * i + 4, (uint32_t)(slots[i] >> 32));
    known[i] = slots[i];
  }
}

void pipegs_write(struct pipegs_device *device, const struct pipegs_job *job, bool all) {
  /* Each of the structs is its slots one after the other, all of 64 bits. */
  uint64_t *known = device->written;
  all = all || !device->known;
  write_slots(device, PIPEGS_FRAME, (const uint64_t *)&job->frame, PIPEGS_FRAME_SLOTS, known, all);
  known += PIPEGS_FRAME_SLOTS;
  write_slots(device, PIPEGS_AREAS, (const uint64_t *)&job->areas, PIPEGS_AREAS_SLOTS, known, all);
  known += PIPEGS_AREAS_SLOTS;
  write_slots(device, PIPEGS_PICTURE, (const uint64_t *)&job->picture, PIPEGS_PICTURE_SLOTS, known, all);
  device->known = true;
}

uint32_t pipegs_start(struct pipegs_device *device) {
  put(device, PIPEGS_CONTROL, PIPEGS_CONTROL_START);
  return ++device->ticket;
}

enum pipegs_result pipegs_queue(struct pipegs_device *device, const struct pipegs_job *job, uint32_t polls,
                                uint32_t *ticket) {
  const enum pipegs_result result = pipegs_wait_queue(device, polls);
  if (result != PIPEGS_OK) return result;
  pipegs_write(device, job, false);
  *ticket = pipegs_start(device);
  return PIPEGS_OK;
}

enum pipegs_result pipegs_done(const struct pipegs_device *device, uint32_t ticket) {
  const uint32_t status = get(device, PIPEGS_STATUS);
  if (status & PIPEGS_STATUS_FAILED) return PIPEGS_FAILED;
  if (get(device, PIPEGS_FRAMES_DONE) - ticket < 0x80000000u) return PIPEGS_OK;
  return status & (PIPEGS_STATUS_BUSY | PIPEGS_STATUS_QUEUED) ? PIPEGS_PENDING : PIPEGS_GIVEN_UP;
}

enum pipegs_result pipegs_wait(struct pipegs_device *device, uint32_t ticket, uint32_t polls) {
  do {
    enum pipegs_result result;
    clear_events(device);
    result = pipegs_done(device, ticket);
    if (result != PIPEGS_PENDING) return result;
  } while (poll_again(device, &polls));
  return PIPEGS_TIMEOUT;
}

void pipegs_enable(const struct pipegs_device *device, uint32_t events) {
  put(device, PIPEGS_IRQ_ENABLE, events);
}

uint32_t pipegs_interrupt(const struct pipegs_device *device) {
  const uint32_t events = get(device, PIPEGS_IRQ_STATUS);
  if (events) put(device, PIPEGS_IRQ_STATUS, events);
  return events;
}

enum pipegs_result pipegs_abort(struct pipegs_device *device, uint32_t polls) {
  put(device, PIPEGS_CONTROL, PIPEGS_CONTROL_ABORT_ALL);
  while (get(device, PIPEGS_STATUS) & (PIPEGS_STATUS_BUSY | PIPEGS_STATUS_QUEUED)) {
    /* No event tells of the end of an abort: nothing to be idle for. */
    if (polls != PIPEGS_NO_LIMIT && --polls == 0) return PIPEGS_TIMEOUT;
  }
  device->ticket = get(device, PIPEGS_FRAMES_DONE);
  return PIPEGS_OK;
}

void pipegs_set_timeout(const struct pipegs_device *device, uint32_t cycles) {
  put(device, PIPEGS_BUS_TIMEOUT, cycles);
}

bool pipegs_silent(const struct pipegs_device *device) {
  return (get(device, PIPEGS_STATUS) & PIPEGS_STATUS_SILENT) != 0;
}

struct pipegs_error pipegs_get_error(const struct pipegs_device *device) {
  struct pipegs_error error = {0, false, 0, false, 0};
  uint32_t first;
  error.causes = get(device, PIPEGS_ERROR);
  first = get(device, PIPEGS_ERROR_FIRST);
  error.has_first = (first & PIPEGS_ERROR_FIRST_VALID) != 0;
  error.has_address = (first & PIPEGS_ERROR_FIRST_LOCATED) != 0;
  if (error.has_first) error.first = (first & PIPEGS_ERROR_FIRST_CAUSE) >> PIPEGS_ERROR_FIRST_CAUSE_SHIFT;
  if (!error.has_address) return error;
  error.address = get(device, PIPEGS_ERROR_ADDRESS_LOW);
  error.address |= (uint64_t)get(device, PIPEGS_ERROR_ADDRESS_HIGH) << 32;
  return error;
}

void pipegs_clear_error(const struct pipegs_device *device, uint32_t causes) {
  put(device, PIPEGS_ERROR, causes);
  put(device, PIPEGS_IRQ_STATUS, PIPEGS_IRQ_STATUS_ERROR);
}

uint64_t pipegs_counter(const struct pipegs_device *device, uint32_t offset) {
  const uint32_t low = get(device, offset); /* keeps the high word of the same moment */
  return (uint64_t)get(device, offset + 4) << 32 | low;
}

void pipegs_get_counters(const struct pipegs_device *device, struct pipegs_counters *counters) {
  uint64_t *const slots = (uint64_t *)counters;
  uint32_t i;
  for (i = 0; i < PIPEGS_COUNTERS_SLOTS; ++i) slots[i] = pipegs_counter(device, PIPEGS_COUNTERS + 8 * i);
}
