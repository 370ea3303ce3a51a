// SPDX-License-Identifier: Apache-2.0
// Checks whether a robot may be put where it is added or moved to: as a start of a scene, beside
// the present robots.
#include <algorithm>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "core/plane.h"
#include "planner/stages/certify.h"
#include "sim/clocks.h"
#include "sim/scene/assumptions.h"
#include "sim/scene/complaints.h"
#include "sim/scene/edit_checks.h"
#include "sim/world.h"
#include "walls/segment.h"

namespace avo::inline sim {
namespace {

// With two steps to spare.
double time_until_rest(double speed, double max_braking, const CertificateLaw& law) {
  const double step = std::max(law.step.time_step, longest_first_step(law));
  return step * (2.0 + braking_steps(speed, braking_decrement(max_braking, law.step)));
}

// The new robot and all robots that it could meet while they brake, as a scene; the new robot comes
// first.
struct StartCompany {
  Scenario scene;
  std::vector<RobotId> id;        // of its robots
  std::vector<std::size_t> slot;  // of the others

  StartCompany(const World& world, const RobotSetup& setup, RobotId robot,
               std::vector<std::size_t> others);
};

// Finds them by the distance that each moves at its highest speed until both are at rest.
class Reach {
 public:
  Reach(const World& world, const RobotSetup& setup)
      : world_(world),
        law_(certificate_law(world.certified_planner())),
        flies_(!can_rest(setup.model) || !world.fleet.flights.empty()),
        center_(disc_center(setup)),
        radius_(disc_radius(setup)),
        top_speed_(std::max(setup.max_speed, norm(setup.velocity))),
        seconds_(until_rest(norm(setup.velocity), braking_limit(setup))) {}

  /// m, from the center of its disc; infinite where a robot may fly in from anywhere.
  [[nodiscard]] double farthest(const MostOfOthers& most) const {
    if (flies_) return kInfinity;
    return radius_ + most.radius + std::max(seconds_, most.seconds) * (top_speed_ + most.speed);
  }
  [[nodiscard]] Vec2 center() const { return center_; }

  [[nodiscard]] bool includes(std::size_t slot) const {
    const Fleet& fleet = world_.fleet;
    if (flies_) return true;  // a robot that flies does not come to rest
    const RobotTraits& other = fleet.traits[slot];
    const double speed = norm(fleet.velocity[slot]);
    const double time = std::max(seconds_, until_rest(speed, other.max_braking));
    const double length = time * (top_speed_ + std::max(other.max_speed, speed));
    return !(norm(fleet.position[slot] - center_) > radius_ + other.radius + length);
  }

 private:
  [[nodiscard]] double until_rest(double speed, double max_braking) const {
    return time_until_rest(speed, max_braking, law_);
  }

  const World& world_;
  CertificateLaw law_;
  bool flies_;
  Vec2 center_;
  double radius_, top_speed_, seconds_;
};

// The state in which it begins to brake, if it decides nothing more: now, or where its own step
// ends. The disc of a drive then moves differently from a drive that starts along its heading: as
// any disc does.
RobotSetup committed(const Fleet& fleet, std::size_t slot) {
  RobotSetup setup = fleet.setup(slot);
  if (is_parked(setup)) return setup;
  const MotionState begin = fleet.has_clocks ? fleet.clock_of(slot).to : fleet.state(slot);
  if (moves_along_heading(setup.model) && !fleet.has_clocks) return setup;
  if (!moves_along_heading(setup.model)) {
    setup.radius = disc_radius(setup);
    setup.model = Holonomic{};
  }
  setup.heading = begin.heading;
  setup.position = begin.position - disc_center(setup.model, {}, begin.heading);
  setup.velocity = begin.velocity;
  return setup;
}

// Slots of the robots that the new one could meet while both brake.
std::vector<std::size_t> others_near(const World& world, const RobotSetup& setup, RobotId robot) {
  const Reach reach(world, setup);
  std::vector<std::size_t> others;
  for (const std::uint32_t other : near_place(world.bystanders, world.fleet, reach.center(),
                                              reach.farthest(world.bystanders.most)))
    if (world.fleet.id[other] != robot && reach.includes(other)) others.push_back(other);
  return others;
}

StartCompany::StartCompany(const World& world, const RobotSetup& setup, RobotId robot,
                           std::vector<std::size_t> others)
    : scene(world.settings), id{robot}, slot(std::move(others)) {
  scene.robots.push_back(setup);
  for (const std::size_t other : slot) {
    scene.robots.push_back(committed(world.fleet, other));
    id.push_back(world.fleet.id[other]);
  }
  for (std::size_t k = 0; k < world.movers.setup.size(); ++k) {
    MovingObstacle& mover = scene.moving_obstacles.emplace_back(world.movers.setup[k]);
    mover.position = world.movers.position[k];
    mover.velocity = world.movers.velocity[k];
  }
}

// Returns whether it keeps the certificate that some robots keep.
bool keeps_any(const World& world, const RobotSetup& robot) {
  return keeps(world.settings, robot, certificate_law(world.certified_planner()));
}

// Finds a contact with a robot within a step, which continues to the end of the step; its path may
// be curved.
std::optional<BrokenStart> find_in_motion(const World& world, const StartCompany& company) {
  const Fleet& fleet = world.fleet;
  const RobotSetup& own = company.scene.robots.front();
  for (std::size_t k = 0; k < company.slot.size() && fleet.has_clocks; ++k) {
    const std::size_t slot = company.slot[k];
    const RobotSetup& other = company.scene.robots[k + 1];
    const OwnClock& clock = fleet.clock_of(slot);
    if (is_parked(other) || clock.end <= world.now || !keep_apart(own, other)) continue;
    if (!keeps_any(world, own) && !keeps_any(world, other)) continue;
    const double left = seconds(clock.end - world.now);
    const double bow =
        0.125 * std::numbers::sqrt2 * other.max_acceleration * left * left +
        (fleet.traits[slot].has_model ? world.certified_planner().options().sensing_error.position
                                      : 0.0);
    const double contact = disc_radius(own) + disc_radius(other);
    const double gap = distance(disc_center(own), {fleet.position[slot], clock.to.position}) - bow -
                       norm(own.velocity) * left;
    if (gap < (1.0 - kStartTolerance) * contact)
      return BrokenStart{RobotId{0}, RobotId{k + 1}, norm(fleet.position[slot] - disc_center(own)),
                         contact - gap};
  }
  return {};
}

// Finds the obstacle, not a robot, to which the new robot is too near by most; the scene gets that
// obstacle alone.
std::optional<WallStart> find_wall(const World& world, const CertificateLaw& law,
                                   StartCompany& company, ObstacleId& obstacle) {
  const StaticWorld& statics = world.statics;
  const RobotSetup& own = company.scene.robots.front();
  const Floor& floor = statics.floors[statics.floor_of(own.layers).value_or(0)];
  const MotionState state = start_of(own);
  WallNeeds needs;
  include_start(company.scene, own, state, law, needs);
  if (floor.needs && floor.needs->cover(needs) &&
      !worst_wall(company.scene, RobotId{0}, state, floor.grid.near(state.position), law))
    return {};
  const std::span<const Wall> walls =
      std::span(floor.walls).first(floor.walls.size() - statics.parked.size());
  auto worst = worst_wall(company.scene, RobotId{0}, state, walls, law);
  if (!worst) return worst;
  std::uint64_t before = worst->obstacle.value;
  for (std::size_t k = 0; k < statics.obstacles.size(); ++k) {
    if (!heeds(own.layers, statics.obstacles[k])) continue;
    const std::uint64_t walls_of_it = walls_of(std::span(&statics.obstacles[k], 1)).size();
    if (before < walls_of_it) {
      company.scene.obstacles = {statics.obstacles[k]};
      obstacle = statics.id[k];
      break;
    }
    before -= walls_of_it;
  }
  worst->obstacle = {0};
  return worst;
}

// The company's scene has positions for ids.
Wording wording_of(const World& world, const StartCompany& company, const ObstacleId& obstacle) {
  return {{},
          [&](BodyId body) {
            const auto* robot = std::get_if<RobotId>(&body);
            if (robot != nullptr) return name_of(listed_as(*robot, company.id));
            return name_of(listed_as(std::get<MovingObstacleId>(body), world.movers.id));
          },
          [&obstacle](ObstacleId) { return name_of(obstacle); }};
}

}  // namespace

void look_around_starts(World& world) {
  Bystanders& bystanders = world.bystanders;
  if (world.settings.allow_broken_assumptions || !world.all_matter()) return;
  if (bystanders.is_made && !has_many_late(bystanders)) return;
  if (!std::exchange(bystanders.is_wanted, true)) return;
  const Fleet& fleet = world.fleet;
  const CertificateLaw law = certificate_law(world.certified_planner());
  MostOfOthers most;
  for (std::size_t slot = 0; slot < fleet.size(); ++slot) {
    const RobotTraits& traits = fleet.traits[slot];
    const double speed = norm(fleet.velocity[slot]);
    most.radius = std::max(most.radius, traits.radius);
    most.speed = std::max({most.speed, traits.max_speed, speed});
    most.seconds = std::max(most.seconds, time_until_rest(speed, traits.max_braking, law));
  }
  make(bystanders, fleet, most, 2.0 * (most.radius + most.seconds * most.speed));
}

void check_mover_start(const World& world, const MovingObstacle& obstacle, const PathWalk& start,
                       const std::string& name) {
  if (world.settings.allow_broken_assumptions || !world.all_matter()) return;
  const CertificateLaw law = certificate_law(world.certified_planner());
  const Fleet& fleet = world.fleet;
  Scenario scene = world.settings;
  scene.moving_obstacles = {obstacle};
  scene.moving_obstacles.front().position = start.position;
  scene.moving_obstacles.front().velocity = start.velocity;
  for (const std::uint32_t slot : fleet.slot_of) {
    scene.robots = {committed(fleet, slot)};
    BrokenAssumptions broken;
    const double late =
        fleet.has_clocks ? longest_first_step(law) * norm(fleet.velocity[slot]) : 0.0;
    find_starts_of_first(scene, law, late, broken);
    if (broken.starts.empty()) continue;
    const Wording wording{{},
                          [&](BodyId body) {
                            return std::holds_alternative<RobotId>(body) ? name_of(fleet.id[slot])
                                                                         : name;
                          },
                          {}};
    refuse_start(complaint(broken.starts.front(), scene, wording));
  }
}

bool is_in_the_way(World& world, const RobotSetup& setup, RobotId robot) {
  look_around_starts(world);
  if (world.settings.allow_broken_assumptions || !world.all_matter()) return false;
  std::vector<std::size_t> others = others_near(world, setup, robot);
  std::erase_if(others, [&](std::size_t slot) { return world.fleet.velocity[slot] == Vec2{}; });
  StartCompany company(world, setup, robot, std::move(others));
  company.scene.moving_obstacles.clear();
  BrokenAssumptions broken;
  find_starts_of_first(company.scene, certificate_law(world.certified_planner()), 0.0, broken);
  return !broken.starts.empty();
}

void check_start(const World& world, const RobotSetup& setup, RobotId robot) {
  if (world.settings.allow_broken_assumptions || !world.all_matter()) return;
  std::vector<std::size_t> others = others_near(world, setup, robot);
  const bool is_alone = others.empty() && world.movers.setup.empty() &&
                        world.statics.obstacles.empty() && !world.statics.has_walls;
  if (is_alone && !exceeds(norm(setup.velocity), setup.max_speed)) return;
  StartCompany company(world, setup, robot, std::move(others));
  const CertificateLaw law = certificate_law(world.certified_planner());
  ObstacleId obstacle;
  const Wording wording = wording_of(world, company, obstacle);
  BrokenAssumptions broken;
  const double late =  // a robot within a step begins to brake so much later
      world.fleet.has_clocks ? longest_first_step(law) * norm(setup.velocity) : 0.0;
  find_starts_of_first(company.scene, law, late, broken);
  if (const auto start = find_in_motion(world, company); start && broken.starts.empty())
    broken.starts.push_back(*start);
  if (!broken.starts.empty()) {
    BrokenStart& worst = broken.starts.front();
    if (worst.other == BodyId(RobotId{0})) worst.other = std::exchange(worst.robot, RobotId{0});
    refuse_start(complaint(worst, company.scene, wording));
  }
  if (!keeps_any(world, setup)) return;
  if (const auto wall = find_wall(world, law, company, obstacle))
    refuse_start(complaint(*wall, company.scene, wording));
  for (std::size_t k = 0; k < world.statics.obstacles.size(); ++k) {
    if (leaves_room(setup, disc_center(setup), world.statics.obstacles[k])) continue;
    company.scene.obstacles = {world.statics.obstacles[k]};
    obstacle = world.statics.id[k];
    refuse_start(complaint(MisplacedStart{}, company.scene, wording));
  }
  if (exceeds(norm(setup.velocity), setup.max_speed))
    refuse_start(complaint(FastStart{RobotId{0}, norm(setup.velocity)}, company.scene, wording));
}

}  // namespace avo::inline sim
