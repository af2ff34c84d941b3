/* SPDX-License-Identifier: Apache-2.0
 * pipegs_text.c: what went wrong as text, without a C library; see pipegs.h. The sentences are those of the table. */
#include "pipegs.h"

/* Writes to `text` while there is room, and counts all. */
struct writer {
  char *text;
  size_t size, length;
};

static void put_character(struct writer *out, char character) {
  if (out->length + 1 < out->size) out->text[out->length] = character;
  ++out->length;
}

static void put_text(struct writer *out, const char *text) {
  while (*text) put_character(out, *text++);
}

static void put_address(struct writer *out, uint64_t address) {
  int digits = 1;
  put_text(out, "0x");
  while (digits < 16 && address >> (4 * digits)) ++digits;
  while (digits-- > 0) put_character(out, "0123456789abcdef"[address >> (4 * digits) & 15]);
}

const char *pipegs_cause_text(uint32_t bit) {
  switch (bit) {
#define CAUSE(name, number, what) \
  case number: return what;
    PIPEGS_ERROR_CAUSES(CAUSE)
#undef CAUSE
    default: return "an error that this driver does not know";
  }
}

size_t pipegs_error_text(const struct pipegs_error *error, char *text, size_t size) {
  struct writer out;
  uint32_t bit;
  out.text = text;
  out.size = size;
  out.length = 0;
  for (bit = 0; bit < 32; ++bit) {
    if (!(error->causes >> bit & 1)) continue;
    if (out.length > 0) put_text(&out, "; ");
    put_text(&out, pipegs_cause_text(bit));
  }
  if (error->has_address || (error->has_first && error->causes != (UINT32_C(1) << error->first))) {
    put_text(&out, "; first: ");
    put_text(&out, pipegs_cause_text(error->first));
  }
  if (error->has_address) {
    put_text(&out, ", at ");
    put_address(&out, error->address);
  }
  if (out.length == 0) put_text(&out, "no error");
  if (size > 0) text[out.length < size ? out.length : size - 1] = 0;
  return out.length;
}
