// SPDX-License-Identifier: Apache-2.0
// Ten robots on board change rooms through a door of 1.6 m. Each has a navigator of its own, and
// knows the others by what it senses: places, velocities, radii. No robot sends anything.
#include <algorithm>
#include <cstdio>
#include <vector>

#include <avo/avo.h>

namespace {

// Stands for a robot: its state, and a base that does as it is told.
struct OnBoard {
  avo::Robot self;
  avo::Navigator navigator;

  void move(const avo::Plan& plan, double time_step) {
    self.position = self.position + 0.5 * time_step * (self.velocity + plan.next_velocity);
    self.velocity = plan.next_velocity;
  }
};

std::vector<avo::Neighbor> sensed(const std::vector<OnBoard>& robots, std::size_t own) {
  std::vector<avo::Neighbor> others;
  for (std::size_t k = 0; k < robots.size(); ++k)
    if (k != own)
      others.push_back({.position = robots[k].self.position, .velocity = robots[k].self.velocity});
  return others;
}

std::vector<avo::StaticObstacle> rooms() {
  const avo::Chain around{{{-16, -8}, {16, -8}, {16, 8}, {-16, 8}}, true};
  return {{{around, {{{0, -8}, {0, -0.8}}}, {{{0, 0.8}, {0, 8}}}}}};
}

}  // namespace

int main() {
  std::vector<OnBoard> robots;
  for (std::uint64_t k = 0; k < 10; ++k) {
    const double side = k % 2 == 0 ? -1.0 : 1.0, y = 2.0 * static_cast<double>(k / 2) - 4.0;
    avo::NavigatorOptions options;
    options.id = {k};
    robots.push_back({{.position = {side * 8.0, y}}, avo::Navigator(options, rooms())});
    robots.back().navigator.set_goal({-side * 8.0, -y});
  }
  double time = 0.0, nearest = 100.0;
  std::size_t reached = 0;
  for (; reached < robots.size() && time < 120.0; time += 0.1) {
    std::vector<avo::NavigatorDecision> decisions;
    for (std::size_t k = 0; k < robots.size(); ++k)
      decisions.push_back(robots[k].navigator.step(robots[k].self, sensed(robots, k), time));
    reached = 0;
    for (std::size_t k = 0; k < robots.size(); ++k) {
      robots[k].move(decisions[k].plan, 0.1);
      if (decisions[k].status == avo::NavigatorStatus::reached) ++reached;
      for (std::size_t other = 0; other < k; ++other)
        nearest = std::min(nearest,
                           avo::norm(robots[k].self.position - robots[other].self.position) - 1.0);
    }
  }
  std::printf("%zu of 10 on the other side after %.1f s, never nearer than %.0f mm\n", reached,
              time, 1000.0 * nearest);
  return reached == robots.size() && time < 40.0 && nearest > -1e-9 ? 0 : 1;
}
