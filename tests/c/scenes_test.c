/* SPDX-License-Identifier: Apache-2.0 */
/* Built-in scenes, loaded and simulated from C, have the state hashes of C++; so has Circle-100
 * that is made of nothing but where its robots are. */
#include "check.h"
#include "cpp_runs.h"

static void check_scene(const char* name, const char* override, int steps) {
  avo_scene_id scene;
  avo_simulation_id simulation;
  avo_simulation_def def = avo_default_simulation_def();
  REQUIRE(avo_load_scene(name, &override, override == NULL ? 0 : 1, &scene));
  REQUIRE(avo_scene_get_def(scene, &def));
  def.threads = 1;
  REQUIRE(avo_create_simulation(&def, &simulation));
  REQUIRE(avo_destroy_scene(scene)); /* a simulation keeps nothing of its definition */
  steps_of(simulation, steps);
  const uint64_t expected = cpp_scene_hash(name, override, steps);
  printf("%-20s %-32s 0x%016llx\n", name, override == NULL ? "" : override,
         (unsigned long long)expected);
  CHECK(hash_of(simulation) == expected);
  REQUIRE(avo_destroy_simulation(simulation));
}

/* Of the scene it takes the positions alone. */
static void check_built_circle(void) {
  enum { COUNT = 100 };
  avo_robot_def robots[COUNT];
  avo_scene_id scene;
  avo_simulation_id simulation;
  avo_simulation_def loaded = avo_default_simulation_def(), def = avo_default_simulation_def();
  REQUIRE(avo_load_scene("circle-100", NULL, 0, &scene));
  REQUIRE(avo_scene_get_def(scene, &loaded));
  CHECK(loaded.robot_count == COUNT);
  for (int k = 0; k < COUNT; ++k) {
    robots[k] = avo_default_robot_def();
    robots[k].position = loaded.robots[k].position;
    robots[k].goal = loaded.robots[k].goal;
  }
  def.robots = robots;
  def.robot_count = COUNT;
  def.max_neighbors = loaded.max_neighbors;
  def.duration = loaded.duration;
  def.metrics = true;
  REQUIRE(avo_create_simulation(&def, &simulation));
  bool goes_on = true;
  int steps = 0;
  for (; goes_on; ++steps) {
    REQUIRE(avo_simulation_step(simulation));
    REQUIRE(avo_simulation_can_step_by(simulation, def.duration, &goes_on));
  }
  CHECK(hash_of(simulation) == cpp_scene_hash("circle-100", NULL, 0));

  avo_summary summary = avo_default_summary();
  REQUIRE(avo_simulation_summary(simulation, &summary));
  CHECK(summary.robots == COUNT && summary.arrived == COUNT && summary.steps == steps);
  CHECK(summary.collision_pairs == 0 && summary.min_clearance > 0.0);
  CHECK(summary.decisions[AVO_PLAN_OPTIMAL] > 0 && summary.last_arrival < def.duration);
  CHECK(summary.first_collision_time != summary.first_collision_time); /* NAN: none */
  const avo_run_metrics m = summary.metrics;
  CHECK(m.trips == COUNT && m.collision_robot_steps == 0 && m.overlap_depth == 0.0);
  CHECK(m.success == 1.0 && m.collision == 0.0 && m.timeout == 0.0);
  CHECK(m.extra_time_mean > 0.0 && m.extra_time_mean < m.extra_time_p75);
  CHECK(m.extra_time_p75 < m.extra_time_p90 && m.extra_time_p90 < summary.last_arrival);
  CHECK(m.flowtime > 99.9 * summary.mean_arrival && m.flowtime < 100.1 * summary.mean_arrival);
  CHECK(m.path_ratio > 1.0 && m.path_ratio < 1.2 && m.efficacy > 0.5 && m.efficacy < 1.0);
  CHECK(m.effort > 1.0 && m.effort < m.reversals && m.jerk > 0.3 && m.jerk < m.effort);
  /* all of 1 m/s^2 */
  const double squares = m.acceleration_rms * m.acceleration_rms * m.flowtime / COUNT;
  CHECK(squares > 0.999999 * m.effort && squares < 1.000001 * m.effort);
  CHECK(m.turned_back >= 0.0 && m.turned_back < m.acceleration_rms);
  CHECK(m.deadlock_time >= 0.0 && m.deadlock_time < m.efficacy);
  REQUIRE(avo_destroy_simulation(simulation));
  REQUIRE(avo_destroy_scene(scene));
}

int main(void) {
  check_built_circle();
  check_scene("circle-100", NULL, 300);
  check_scene("circle-100", "method=avo_paper", 200);
  check_scene("circle-10", "method=orca", 200);
  check_scene("circle-10", "method=velocity_obstacle", 200);
  check_scene("circle-10", "method=orca_clamped", 200);
  check_scene("circle-10", "method=reciprocal_velocity_obstacle", 200);
  check_scene("circle-10", "method=buffered_voronoi", 200);
  check_scene("circle-10", "clock=free", 200);
  check_scene("circle-10", "sensing.dropped=0.2", 200);
  check_scene("circle-10", "execution={time_constant: 0.2, dead_time: 0.13, quantum: 0.02}", 200);
  check_scene("uniform-1000", NULL, 30);
  check_scene("swap-blocks", NULL, 100);
  check_scene("cars-100", NULL, 60);
  check_scene("drives-100", NULL, 60);
  check_scene("planes-12", NULL, 400);
  check_scene("person", NULL, 200);
  check_scene("reversing-cars", NULL, 200);
  check_scene("mixed-yard", NULL, 100);
  check_scene("moving-obstacle", "motion=exponential", 200);
  check_scene("office", NULL, 60);
  check_scene("doorway", "right_of_way=none", 100);
  check_scene("doorway", "navigation=false", 60);
  return 0;
}
