/* SPDX-License-Identifier: Apache-2.0
   A potential field as a method of one's own, for the command line:

   cc -shared -fPIC own_method.c -o own_method.so -lm
   avo run circle-40 --method field=./own_method.so,certified --until-arrived

   Each robot wants its preferred velocity, and others and walls push it away. */
#include <avo_c/avo.h>
#include <math.h>

static const double kStrength = 1.0, kRange = 0.5; /* m/s, m */

/* Adds the push away from a body that begins at `contact` m from its center. */
static void push(avo_vec2 away, double contact, avo_vec2* velocity) {
  const double distance = sqrt(away.x * away.x + away.y * away.y);
  const double gap = distance - contact;
  if (!(distance > 0.0) || gap > 6.0 * kRange) return;
  const double part = kStrength * exp(-gap / kRange) / distance;
  velocity->x += part * away.x;
  velocity->y += part * away.y;
}

static avo_vec2 from_wall(avo_vec2 position, const avo_wall* wall) {
  const double x = wall->b.x - wall->a.x, y = wall->b.y - wall->a.y;
  const double px = position.x - wall->a.x, py = position.y - wall->a.y;
  const double squared = x * x + y * y;
  const double along = squared > 0.0 ? fmin(fmax((px * x + py * y) / squared, 0.0), 1.0) : 0.0;
  return (avo_vec2){px - along * x, py - along * y};
}

/* Shortens a velocity to the largest speed. */
static void limit(double max_speed, avo_vec2* velocity) {
  const double speed = sqrt(velocity->x * velocity->x + velocity->y * velocity->y);
  if (speed <= max_speed) return;
  velocity->x *= max_speed / speed;
  velocity->y *= max_speed / speed;
}

int32_t avo_choose(void* context, const avo_method_batch* batch, avo_vec2* velocities) {
  (void)context;
  for (size_t i = 0; i < batch->robot_count; ++i) {
    const avo_vec2 own = batch->position[i];
    for (size_t k = batch->first_neighbor[i]; k < batch->first_neighbor[i + 1]; ++k) {
      const avo_vec2 other = batch->neighbor_position[k];
      push((avo_vec2){own.x - other.x, own.y - other.y},
           batch->radius[i] + batch->neighbor_radius[k], &velocities[i]);
    }
    for (size_t k = batch->first_wall[i]; k < batch->first_wall[i + 1]; ++k)
      push(from_wall(own, &batch->wall[k]), batch->radius[i] + batch->wall[k].radius,
           &velocities[i]);
    limit(batch->max_speed[i], &velocities[i]);
  }
  return 0;
}
