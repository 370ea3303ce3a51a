/* SPDX-License-Identifier: Apache-2.0 */
/* A test in C: what fails is printed, and the program ends with 1. */
#ifndef AVO_TESTS_C_CHECK_H
#define AVO_TESTS_C_CHECK_H

#include <avo_c/avo.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CHECK(condition)                                                             \
  do {                                                                               \
    if (!(condition)) {                                                              \
      fprintf(stderr, "%s:%d: %s; last error: %s\n", __FILE__, __LINE__, #condition, \
              avo_last_error());                                                     \
      exit(1);                                                                       \
    }                                                                                \
  } while (0)

#define REQUIRE(call) CHECK((call) == AVO_OK)

/* The call fails with that result, and says the text. */
#define REFUSES(call, expected, text)                \
  do {                                               \
    CHECK((call) == (expected));                     \
    CHECK(strstr(avo_last_error(), (text)) != NULL); \
  } while (0)

static inline uint64_t hash_of(avo_simulation_id simulation) {
  uint64_t hash = 0;
  REQUIRE(avo_simulation_get_state_hash(simulation, &hash));
  return hash;
}

static inline void steps_of(avo_simulation_id simulation, int count) {
  for (int k = 0; k < count; ++k) REQUIRE(avo_simulation_step(simulation));
}

#endif
