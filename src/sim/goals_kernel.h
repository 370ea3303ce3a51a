// SPDX-License-Identifier: Apache-2.0
// Robots that are so far from their goals that nothing but the way there counts. Included into a
// namespace that has Pack, once per instruction set.

/// What preferred_velocity() depends on.
template <typename Real>
struct Traveller {
  Vec<Real> position, velocity, goal;
  Real preferred_speed, max_acceleration, max_speed;
};

template <typename Real>
struct Way {
  Real distance;                    // m, to the goal
  Vec<Real> direction;              // unit, or 0 at the goal
  Real along;                       // m/s, velocity in that direction
  Real left;                        // m, of the distance, where the next decision takes effect
  Vec<Real> preferred;              // m/s, see preferred_velocity()
  decltype(Real() < Real()) known;  // whether that is it, which it is but near the goal
};

/// Whether braking by `decrement` m/s a step from `speed` on surely ends within the distance, told
/// without root or floor, see admissible_speed(): with x = k + f, (k + 1)(k/2 + f) <= (x + 1) x.
template <typename Real>
AVO_KERNEL auto surely_admits(Real distance, Real speed, Real decrement, Real time_step) {
  const Real margin(1.001);  // for rounding
  return distance * decrement > margin * time_step * speed * (speed + decrement);
}

template <typename Real>
AVO_KERNEL Way<Real> way_of(const Traveller<Real>& robot, const GoalLaw& law) {
  const Real zero(0.0), time_step(law.time_step), control_time(law.control_time), rate(law.rate);
  const Real speed = robot.preferred_speed;
  const Vec<Real> way = robot.goal - robot.position;
  Way<Real> of;
  of.distance = norm(way);
  of.direction = select(of.distance > zero, way / of.distance, constant<Real>({}));
  if (adopts_at_once(law.method)) {
    of.preferred = min(of.distance / time_step, speed) * of.direction;
    of.known = zero <= zero;
    return of;
  }
  of.along = dot(robot.velocity, of.direction);
  of.left = of.distance - Real(law.lag) * of.along;
  of.preferred = speed * of.direction;
  if (law.method == Method::avo) {
    const Vec<Real> p = robot.position, goal = robot.goal;
    // more than the norms that preferred_velocity() compares it with
    const Real farthest = (abs(p.x) + abs(p.y)) + (abs(goal.x) + abs(goal.y));
    of.known =
        surely_admits(of.left, speed, rate * control_time * robot.max_acceleration, time_step) &
        (of.distance > Real(0x1p-45) * farthest);
  } else {
    const Real change = min(robot.max_speed, control_time * robot.max_acceleration);
    of.known = surely_admits(of.left, speed, rate * change, time_step) &
               (Real(2.0) * of.distance >= Real(1.001) * control_time * speed);
  }
  return of;
}
