/* SPDX-License-Identifier: Apache-2.0
 * pipegs_wide.h: unsigned numbers of 128 bits in C99, as far as a frame's parameters need them; no compiler's own type.
 * Bit by bit where that is enough: a frame takes a few thousand steps. */
#ifndef PIPEGS_WIDE_H
#define PIPEGS_WIDE_H

#include <stdbool.h>
#include <stdint.h>

struct pipegs_wide {
  uint64_t high, low;
};

static inline struct pipegs_wide pipegs_wide_add(struct pipegs_wide a, struct pipegs_wide b) {
  struct pipegs_wide sum;
  sum.low = a.low + b.low;
  sum.high = a.high + b.high + (sum.low < a.low);
  return sum;
}

static inline struct pipegs_wide pipegs_wide_multiply(uint64_t a, uint64_t b) {
  const uint64_t mask = 0xffffffffu;
  const uint64_t low = (a & mask) * (b & mask), left = (a >> 32) * (b & mask), right = (a & mask) * (b >> 32);
  const uint64_t middle = (low >> 32) + (left & mask) + (right & mask);
  struct pipegs_wide product;
  product.low = (middle << 32) | (low & mask);
  product.high = (a >> 32) * (b >> 32) + (left >> 32) + (right >> 32) + (middle >> 32);
  return product;
}

/* By 0 to 127 places. */
static inline struct pipegs_wide pipegs_wide_left(struct pipegs_wide a, int places) {
  struct pipegs_wide shifted = a;
  if (places >= 64) {
    shifted.high = a.low << (places - 64);
    shifted.low = 0;
  } else if (places > 0) {
    shifted.high = (a.high << places) | (a.low >> (64 - places));
    shifted.low = a.low << places;
  }
  return shifted;
}

static inline struct pipegs_wide pipegs_wide_right(struct pipegs_wide a, int places) {
  struct pipegs_wide shifted = a;
  if (places >= 64) {
    shifted.low = a.high >> (places - 64);
    shifted.high = 0;
  } else if (places > 0) {
    shifted.low = (a.low >> places) | (a.high << (64 - places));
    shifted.high = a.high >> places;
  }
  return shifted;
}

/* Places up to the highest one; 0 for 0. */
static inline int pipegs_wide_bits(struct pipegs_wide a) {
  int bits = 0;
  while (a.high | a.low) {
    a = pipegs_wide_right(a, 1);
    ++bits;
  }
  return bits;
}

/* The 64 leading bits of a number that is not 0, the highest one set: a = result * 2^exponent, rounded down. */
static inline uint64_t pipegs_wide_leading(struct pipegs_wide a, int *exponent) {
  *exponent = pipegs_wide_bits(a) - 64;
  return (*exponent < 0 ? pipegs_wide_left(a, -*exponent) : pipegs_wide_right(a, *exponent)).low;
}

/* Rounded down; false when the quotient has more than 64 bits, or the divisor is 0. */
static inline bool pipegs_wide_divide(struct pipegs_wide a, uint64_t divisor, uint64_t *quotient) {
  uint64_t rest = a.high;
  int i;
  if (a.high >= divisor) return false;
  *quotient = 0;
  for (i = 63; i >= 0; --i) {
    const bool carry = rest >> 63 != 0;
    rest = (rest << 1) | (a.low >> i & 1);
    if (carry || rest >= divisor) {
      rest -= divisor;
      *quotient |= UINT64_C(1) << i;
    }
  }
  return true;
}

/* The square root, rounded down. */
static inline uint64_t pipegs_wide_root(struct pipegs_wide a) {
  uint64_t root = 0;
  int i;
  for (i = 63; i >= 0; --i) {
    const uint64_t next = root | UINT64_C(1) << i;
    const struct pipegs_wide square = pipegs_wide_multiply(next, next);
    if (square.high < a.high || (square.high == a.high && square.low <= a.low)) root = next;
  }
  return root;
}

#endif
