/* SPDX-License-Identifier: Apache-2.0
 * platform_mapped.c: the platform of example.c where the registers lie in the processor's memory. The two numbers are
 * those of the system: -DPIPEGS_REGISTERS_ADDRESS=0x43c00000 and so on. It polls, and shows no text. */
#include "pipegs_platform.h"

#include "pipegs.h"

#ifndef PIPEGS_REGISTERS_ADDRESS
#define PIPEGS_REGISTERS_ADDRESS 0x40000000
#endif
#ifndef PIPEGS_IMAGE_ADDRESS
#define PIPEGS_IMAGE_ADDRESS 0x10000000
#endif

static struct pipegs_bus registers(void) {
  return pipegs_memory_mapped((volatile uint32_t *)(uintptr_t)PIPEGS_REGISTERS_ADDRESS);
}

uint32_t pipegs_platform_read(void *context, uint32_t offset) {
  const struct pipegs_bus bus = registers();
  (void)context;
  return bus.read(bus.context, offset);
}

void pipegs_platform_write(void *context, uint32_t offset, uint32_t value) {
  const struct pipegs_bus bus = registers();
  (void)context;
  bus.write(bus.context, offset, value);
}

void pipegs_platform_wait(void *context) {
  (void)context;
}

uint64_t pipegs_platform_image(void) {
  return PIPEGS_IMAGE_ADDRESS;
}

void pipegs_platform_print(const char *text) {
  (void)text;
}
