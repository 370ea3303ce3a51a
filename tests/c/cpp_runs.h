/* SPDX-License-Identifier: Apache-2.0 */
/* The same runs by the C++ interface, for their state hashes. */
#ifndef AVO_TESTS_C_CPP_RUNS_H
#define AVO_TESTS_C_CPP_RUNS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Of a built-in scene after so many steps, 0: all; override: one, or null. */
uint64_t cpp_scene_hash(const char* scene, const char* override, int steps);

/* Of two airplanes that meet, of which the first leaves at its goal. */
uint64_t cpp_sky_hash(int steps);

/* Of a yard with robots that have wheels or none, walls and obstacles on their ways: after 40
 * steps; after it was edited and stepped 40 times more; and after 40 steps more. */
void cpp_yard_hashes(uint64_t hashes[3]);

/* Of six robots of space above a floor, one of them with a quadrotor behind it. */
uint64_t cpp_space_hash(int steps, bool senses_late);

/* What a robot of them decides after so many steps, in words. */
void cpp_space_words(int steps, int robot, char* words, size_t capacity);

/* The next velocity of a robot of space between a neighbor and a moving obstacle that were sensed
 * so many steps ago. It flies 1 m above a floor. */
void cpp_space_decision(int neighbor_age, int mover_age, double next_velocity[3]);

#ifdef __cplusplus
}
#endif
#endif
