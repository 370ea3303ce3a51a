/* SPDX-License-Identifier: Apache-2.0 */
/* A loop of a game against the C library for games: frames of any length draw a crowd that steps 20
 * times a second. The player goes where the keys say, and every second the nearest ten of the crowd
 * turn to the player. */
#include <avo_c/avo.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { CROWD = 200, COLUMNS = 20, FRAMES = 1800, NEAR = 10 };

static void require(avo_result result) {
  if (result == AVO_OK) return;
  fprintf(stderr, "%s: %s\n", avo_result_text(result), avo_last_error());
  exit(1);
}

/* Two moments of the crowd, between which frames draw. Robots neither come nor go here, so rows
 * stay in order. */
typedef struct moments {
  avo_vec2 before[CROWD], now[CROWD];
} moments;

static void look(avo_simulation_id game, moments* crowd) {
  avo_columns columns;
  require(avo_simulation_columns(game, &columns));
  for (size_t i = 0; i < columns.count; ++i) {
    crowd->before[i] = crowd->now[i];
    crowd->now[i] = columns.position[i];
  }
}

static avo_vec2 between(avo_vec2 a, avo_vec2 b, double part) {
  const avo_vec2 point = {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
  return point;
}

static avo_simulation_id new_game(double time_step) {
  static avo_robot_def robots[CROWD];
  for (int k = 0; k < CROWD; ++k) { /* they cross a square to and fro */
    robots[k] = avo_default_robot_def();
    robots[k].radius = 0.3;
    robots[k].position.x = 2.0 * (k % COLUMNS) - 19.0;
    robots[k].position.y = 2.0 * (k / COLUMNS) - 9.0; /* integers */
    robots[k].goal.x = -robots[k].position.x;
    robots[k].goal.y = robots[k].position.y;
  }
  avo_simulation_def def = avo_default_simulation_def();
  def.robots = robots, def.robot_count = CROWD;
  def.time_step = time_step;
  def.metrics = true;
  avo_simulation_id game;
  require(avo_create_simulation(&def, &game));
  return game;
}

/* The player is where the simulation has moved it. Its velocity changes to what the keys ask for,
 * no faster than it declares: the crowd counts on that. */
static void steer(avo_simulation_id game, avo_moving_obstacle_id id,
                  avo_moving_obstacle_def* player, avo_vec2 keys, double time_step) {
  avo_moving_obstacle_columns obstacles;
  require(avo_simulation_moving_obstacles(game, &obstacles));
  player->position = obstacles.position[0];
  const avo_vec2 change = {keys.x - player->velocity.x, keys.y - player->velocity.y};
  const double wanted = sqrt(change.x * change.x + change.y * change.y);
  const double part = fmin(1.0, player->max_deviation * time_step / fmax(wanted, 1e-9));
  player->velocity = between(player->velocity, keys, part);
  require(avo_simulation_change_moving_obstacle(game, id, player));
}

static void call_the_nearest(avo_simulation_id game, avo_vec2 place) {
  avo_robot_id near[NEAR];
  size_t count = 0;
  require(avo_simulation_nearest_robots(game, place, near, NEAR, &count));
  for (size_t k = 0; k < count; ++k) require(avo_simulation_set_goal(game, near[k], place));
}

int main(void) {
  const double time_step = 0.05; /* s */
  const avo_vec2 keys[3] = {
      {0.0, 1.4}, {0.84, 1.12}, {-0.84, 1.12}}; /* m/s, each held for 300 frames */
  avo_simulation_id game = new_game(time_step);
  avo_moving_obstacle_def player = avo_default_moving_obstacle_def();
  player.position.x = 0.0, player.position.y = -14.0;
  player.radius = 0.4;
  player.max_deviation = 2.5; /* m/s^2, that it may speed up, brake and turn */
  player.max_speed = 1.5;
  avo_moving_obstacle_id id;
  require(avo_simulation_add_moving_obstacle(game, &player, &id));

  static moments crowd;
  look(game, &crowd), look(game, &crowd);
  avo_vec2 drawn = crowd.now[0];
  double left_over = 0.0, fastest = 0.0; /* s, m/s */
  long steps = 0;
  for (int frame = 0; frame < FRAMES; ++frame) {
    const double spent = frame % 7 == 0 ? 0.034 : 0.0139; /* s: some frames take longer */
    for (left_over += spent; left_over >= time_step; left_over -= time_step, ++steps) {
      steer(game, id, &player, keys[frame / 300 % 3], time_step);
      if (steps % 20 == 0) call_the_nearest(game, player.position);
      require(avo_simulation_step(game));
      look(game, &crowd);
    }
    const avo_vec2 place = between(crowd.before[0], crowd.now[0], left_over / time_step);
    fastest = fmax(fastest, hypot(place.x - drawn.x, place.y - drawn.y) / spent);
    drawn = place; /* drawn is where the first robot would be painted */
  }
  avo_summary summary = avo_default_summary();
  require(avo_simulation_summary(game, &summary));
  uint64_t hash = 0;
  require(avo_simulation_get_state_hash(game, &hash));
  printf(
      "%d frames, %ld steps, drawn at up to %.2f m/s; touched in motion: %d robots by the player, "
      "%d pairs; state "
      "hash 0x%016" PRIx64 "\n",
      FRAMES, steps, fastest, (int)summary.mover_collisions_in_motion, (int)summary.collision_pairs,
      hash);
  require(avo_destroy_simulation(game));
  return 0;
}
