// SPDX-License-Identifier: Apache-2.0
#include "space/bodies.h"

#include <algorithm>

#include "space/kernels.h"
#include "space/own_space.h"
#include "space/seen_kernel.h"

namespace avo::space {
namespace {

Vec3 vector_at(const std::array<Bodies::Column, 3>& columns, std::size_t k) {
  return {columns[0][k], columns[1][k], columns[2][k]};
}

void set(std::array<Bodies::Column, 3>& columns, std::size_t k, Vec3 a) {
  columns[0][k] = a.x, columns[1][k] = a.y, columns[2][k] = a.z;
}

}  // namespace

void Bodies::clear() {
  count = 0;
  has_downwash = has_vertical = has_ages = false;
  is_uniform = true;
}

void Bodies::reserve(std::size_t bodies) {
  if (error.size() >= bodies + kSpare) return;  // this column grows last
  for (auto* vectors : {&position, &velocity, &direction}) {
    for (Column& column : *vectors) column.resize(bodies + kSpare, 1.0);
  }
  for (Column* column :
       {&number, &radius, &max_acceleration, &max_braking, &vertical, &downwash, &priority, &speed,
        &decrement, &full_steps, &increment, &length, &reach, &intervals, &error}) {
    column->resize(bodies + kSpare, 1.0);
  }
  age.resize(bodies + kSpare);
}

void Bodies::add(const Neighbor& body, std::size_t body_number) {
  const std::size_t k = count++;
  set(position, k, body.position);
  set(velocity, k, body.velocity);
  number[k] = static_cast<double>(body_number);
  radius[k] = body.radius;
  max_acceleration[k] = body.max_acceleration;
  max_braking[k] = braking_limit(body);
  vertical[k] = body.vertical;
  downwash[k] = body.downwash;
  priority[k] = body.priority;
  age[k] = body.age;
  for (const Column* column :
       {&radius, &max_acceleration, &max_braking, &vertical, &downwash, &priority})
    is_uniform = is_uniform && (*column)[k] == (*column)[0];
  has_downwash = has_downwash || body.downwash > 0.0;
  has_vertical = has_vertical || body.vertical != 1.0;
  has_ages = has_ages || body.age > 0;
}

Neighbor Bodies::neighbor(std::size_t k) const {
  return {vector_at(position, k),
          vector_at(velocity, k),
          radius[k],
          max_acceleration[k],
          vertical[k],
          downwash[k],
          priority[k],
          max_braking[k],
          age[k]};
}

BrakingOf<3> Bodies::braking(std::size_t k) const {
  return {.profile = {speed[k], decrement[k], full_steps[k]},
          .increment = increment[k],
          .direction = vector_at(direction, k),
          .length = length[k],
          .reach = reach[k],
          .intervals = intervals[k]};
}

void fill_braking(const StepLaw& law, Bodies& bodies) {
  if (!bodies.has_ages && (law.is_exact() || !bodies.has_vertical)) {
    kernels().fill_braking(law, 0, bodies.count, bodies);
  } else {
    for (std::size_t k = 0; k < bodies.count; ++k)
      scalar::fill_braking<scalar::Pack<double>>(law_against(bodies.neighbor(k), law), k, k + 1,
                                                 bodies);
  }
  const auto most = [&](const Bodies::Column& column) {
    const auto end = column.begin() + static_cast<std::ptrdiff_t>(bodies.count);
    return bodies.count > 0 ? *std::max_element(column.begin(), end) : 0.0;
  };
  bodies.most_reach = most(bodies.reach), bodies.most_full_steps = most(bodies.full_steps);
  bodies.most_intervals = most(bodies.intervals), bodies.most_error = most(bodies.error);
  bodies.most_downwash = most(bodies.downwash);
}

StepLaw law_against(const Neighbor& neighbor, const StepLaw& law) {
  StepLaw result = law;
  if (law.is_exact() && neighbor.age == 0) return result;
  auto& [position, velocity] = result.sensing_error;
  const double time = neighbor.age * law.time_step, change = top_acceleration(neighbor);
  position += time * velocity + 0.5 * change * time * time;
  velocity = (velocity + change * time) * std::max(neighbor.vertical, 1.0 / neighbor.vertical);
  return result;
}

Vec3 away_from(Vec3 a, double downwash_a, Vec3 b, double downwash_b) {
  Vec3 away = a - b;
  away.z -= std::clamp(away.z, -downwash_b, downwash_a);
  return away;
}

}  // namespace avo::space
