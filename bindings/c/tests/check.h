// What the tests share: a failure says where and what, and the program ends with 1.

#pragma once

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "terrella.h"

static int failures = 0;

#define CHECK(condition)                                                       \
  do {                                                                         \
    if (!(condition)) {                                                        \
      printf("%s:%d: %s\n", __FILE__, __LINE__, #condition);                   \
      failures++;                                                              \
    }                                                                          \
  } while (0)

// A status that is 0.
#define OK(call) CHECK((call) == TERRELLA_OK)

// Numbers that are the same in every run.
static inline double draw(double from, double to) {
  static uint64_t state = 1;
  state = state * 6364136223846793005u + 1442695040888963407u;
  return from + (to - from) * (double)(state >> 11) * 0x1p-53;
}

static inline int ended(void) {
  if (failures) printf("%d failures\n", failures);
  return failures != 0;
}
