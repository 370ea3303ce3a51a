// SPDX-License-Identifier: Apache-2.0
// What one robot of space senses now, and where it wants to go, by the functions of a step. No
// robot moves.
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "space/fleet.h"

namespace avo::space {
namespace {

// Lists the bodies at these places, by ascending numbers.
void list_neighbors(const Bodies& bodies, std::vector<std::size_t>& places,
                    Simulation::Perception& seen) {
  std::sort(places.begin(), places.end(),
            [&](std::size_t a, std::size_t b) { return bodies.number[a] < bodies.number[b]; });
  for (const std::size_t place : places) {
    seen.neighbors.push_back(bodies.neighbor(place));
    seen.neighbor_ids.push_back({static_cast<std::uint64_t>(bodies.number[place])});
  }
}

}  // namespace

Simulation::Perception SpaceFleet::perceive(std::size_t k) {
  begin_step();
  SpaceWorker& worker = workers.front();
  find_boxes(k, worker);
  const std::size_t runs = cells.around(robots[k].position, worker.runs);
  sense_movers(k, worker);
  Simulation::Perception seen{.robot = robots[k],
                              .boxes = worker.boxes,
                              .box_ids = worker.box_ids,
                              .movers = worker.movers,
                              .mover_ids = worker.mover_ids,
                              .detour = detours[k]};
  std::vector<std::size_t> places;
  if (senses.are_exact()) {
    for (const Run& run : std::span(worker.runs).first(runs)) {
      for (std::size_t place = run.first; place < run.last; ++place)
        if (cells.order()[place] != k && is_in_range(bodies.place_of(place), k))
          places.push_back(place);
    }
    list_neighbors(bodies, places, seen);
  } else {
    sense_robots(k, runs, worker);
    for (std::size_t place = 0; place < worker.scratch.bodies.count; ++place)
      places.push_back(place);
    list_neighbors(worker.scratch.bodies, places, seen);
  }
  SpaceRoute route = routes.memory(k);
  const double yielded = route.yielded;
  std::uint8_t stood = has_stood[k];
  seen.guide = head_for_goal(k, seen.neighbors, {seen.robot, route, seen.detour, stood}, worker);
  if (seen.guide != Guide::passage) return seen;
  route.yielded = yielded;
  Robot there = seen.robot;
  there.position = there.position + worker.lost;
  const PassageView company =
      view_of(k, senses.know_places() ? std::span<const Neighbor>(seen.neighbors) : worker.on_map);
  if (const auto wait = routes.wait(k, there, company, route, worker.routes))
    seen.wait = {wait->passage,
                 wait->is_claim ? RobotId{wait->robot} : seen.neighbor_ids[wait->robot],
                 wait->inside};
  return seen;
}

}  // namespace avo::space
