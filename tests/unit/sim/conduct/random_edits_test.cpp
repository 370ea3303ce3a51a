// SPDX-License-Identifier: Apache-2.0
// The edits are of all kinds in no order, under every kind of sensing, with robots of every model
// and behavior. What a simulation knows of its robots stays whole, and no robot is touched.
#include <algorithm>
#include <gtest/gtest.h>
#include <optional>
#include <string>
#include <vector>

#include "avo/error.h"
#include "avo/simulation.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::Random;

constexpr double kSide = 14.0;  // m, of the square in which all of them are

Vec2 anywhere(Random& random) {
  return {random.uniform(0.0, kSide), random.uniform(0.0, kSide)};
}

MotionModel any_model(const Scenario& scene, Random& random) {
  Car car{0.5};
  switch (random.below(5)) {
    case 0:
      car.max_curvature = 0.8, car.reverse = true;
      return car;
    case 1:
      car.body = CarBody{0.3, 0.4};
      return car;
    case 2:
      return DifferentialDrive{};
    case 3:
      return scene.moving_obstacles.empty() ? MotionModel(Airplane{}) : MotionModel(Holonomic{});
    default:
      return Holonomic{};
  }
}

RobotSetup any_robot(const Scenario& scene, Random& random) {
  RobotSetup robot = test::robot_at(anywhere(random), anywhere(random));
  robot.radius = random.uniform(0.2, 0.5);
  robot.max_speed = robot.preferred_speed = 1.2;
  robot.model = any_model(scene, random);
  if (scene.clock == Clock::free && random.below(2) == 0) robot.time_step = 0.05;
  robot.heading = random.uniform(-3.0, 3.0);
  if (random.below(3) == 0) robot.velocity = random.uniform(0.1, 1.0) * random.direction();
  robot.priority = random.below(4) == 0 ? 4.0 : 1.0;
  if (random.below(4) == 0) robot.layers = robot.avoids = {2};  // others, which avoid each other
  if (random.below(4) == 0) {
    robot.behavior = Behavior::parked, robot.goal = robot.position, robot.velocity = {};
    robot.layers = RobotSetup{}.layers, robot.avoids = RobotSetup{}.avoids, robot.time_step = {};
  } else if (random.below(4) == 0 && is_holonomic(robot.model)) {
    robot.layers = {4}, robot.avoids = {0};  // it reacts to no robot, and all others to it
  }
  return robot;
}

StaticObstacle any_obstacle(Random& random) {
  const Vec2 a = anywhere(random);
  const auto floor = static_cast<std::uint32_t>(random.below(4));  // 0 and 3: of both
  return {.chains = {{.points = {a, a + random.uniform(0.1, 2.0) * random.direction()}}},
          .radius = random.below(2) == 0 ? 0.1 : 0.0,
          .layers = floor == 0 ? kAllLayers : LayerSet{floor}};
}

// What the host changes of a robot between two steps.
RobotSetup changed(RobotSetup robot, Random& random) {
  switch (random.below(9)) {
    case 0:
      robot.radius *= random.uniform(0.7, 1.3);
      break;
    case 1:
      robot.max_speed = robot.preferred_speed = random.uniform(0.2, 1.5);
      break;
    case 2:
      robot.max_acceleration *= random.uniform(0.5, 2.0);
      break;
    case 3:
      robot.max_braking = random.uniform(0.5, 1.5);
      break;
    case 4:
      robot.priority = random.uniform(0.5, 4.0), robot.arrival_distance = random.uniform(0.1, 1.0);
      break;
    case 5:
      robot.layers = robot.avoids = {random.below(2) == 0 ? 2U : 1U};
      break;
    case 6:
      robot.behavior = static_cast<Behavior>(random.below(3));
      break;
    case 7:
      robot.behavior = is_parked(robot) ? Behavior::decides : Behavior::parked;
      break;
    default:
      robot.time_horizon = random.uniform(1.0, 4.0);
  }
  return robot;
}

MovingObstacle any_mover(Random& random) {
  MovingObstacle mover{.position = anywhere(random), .velocity = 0.5 * random.direction()};
  mover.radius = random.uniform(0.2, 0.5);
  if (random.below(2) == 0) mover.max_deviation = 0.5, mover.max_speed = 0.8;
  if (random.below(3) == 0)
    mover.max_deviation = 1.0, mover.max_speed = 0.8,
    mover.path = {anywhere(random), anywhere(random)};
  return mover;
}

/// A simulation that is changed at random, and looked at after each change.
class Edited {
 public:
  /// hosted: robots also change, are told where to go, and moving obstacles come and go.
  Edited(const Scenario& scene, std::uint64_t seed, bool hosted)
      : random_(seed), scene_(scene), simulation_(scene, 1), hosted_(hosted) {}

  void run(int rounds) {
    for (int k = 0; k < rounds && !testing::Test::HasFailure(); ++k) {
      edit();
      expect_whole();
      if (k % 5 == 0) expect_the_same_future();
      for (int steps = random_.below(4); steps > 0; --steps) step();
    }
  }
  [[nodiscard]] int accepted() const { return accepted_; }
  [[nodiscard]] int refused() const { return refused_; }
  [[nodiscard]] int parked() const { return parked_; }

 private:
  [[nodiscard]] RobotId any_id() {
    const FleetView fleet = simulation_.fleet();
    return fleet.id[static_cast<std::size_t>(random_.below(static_cast<int>(fleet.id.size())))];
  }

  void edit() {
    const std::vector<std::byte> before = simulation_.save();
    const std::uint64_t hash = simulation_.state_hash();
    try {
      change();
      ++accepted_;
    } catch (const Error& error) {
      ++refused_;
      EXPECT_EQ(simulation_.state_hash(), hash) << error.what();
      EXPECT_TRUE(simulation_.save() == before) << error.what();
    }
  }

  void change() {
    const std::size_t robots = simulation_.fleet().id.size();
    const auto obstacles = simulation_.obstacles().id;
    switch (random_.below(hosted_ ? 15 : 7)) {
      case 0:
      case 1: {
        const RobotSetup robot = any_robot(scene_, random_);
        if (robots < 24) simulation_.add_robot(robot);
        parked_ += robots < 24 && is_parked(robot) ? 1 : 0;
        return;
      }
      case 2:
        if (robots > 4) simulation_.remove_robot(any_id());
        return;
      case 3:
        return simulation_.move_robot(any_id(), anywhere(random_));
      case 4:
        return simulation_.set_goal(any_id(), anywhere(random_));
      case 5:
        if (obstacles.size() < 8) simulation_.add_obstacle(any_obstacle(random_));
        return;
      case 7:
      case 8:
      case 9: {
        const RobotId id = any_id();
        const RobotSetup now = simulation_.setup(id);
        return simulation_.change_robot(id, changed(now, random_));
      }
      case 10:
      case 11: {
        const Vec2 velocity = random_.uniform(0.0, 2.0) * random_.direction();
        return simulation_.set_preferred_velocity(
            any_id(), random_.below(3) == 0 ? std::nullopt : std::optional(velocity));
      }
      case 12:
        return change_movers();
      case 13:
      case 14: {
        const RobotId id = any_id();
        const bool is_moved = simulation_.host_velocity(id).has_value();
        const Vec2 velocity = simulation_.robot(id).velocity + 0.08 * random_.direction();
        return simulation_.set_velocity(
            id, is_moved && random_.below(2) == 0 ? std::nullopt : std::optional(velocity));
      }
      default:
        if (obstacles.empty()) return;
        simulation_.remove_obstacle(
            obstacles[static_cast<std::size_t>(random_.below(static_cast<int>(obstacles.size())))]);
    }
  }

  void change_movers() {
    const auto movers = simulation_.moving_obstacles().id;
    const MovingObstacle mover = any_mover(random_);
    const auto any =
        movers.empty()
            ? MovingObstacleId{}
            : movers[static_cast<std::size_t>(random_.below(static_cast<int>(movers.size())))];
    switch (random_.below(movers.empty() ? 1 : 3)) {
      case 0:
        if (movers.size() < 4) simulation_.add_moving_obstacle(mover);
        return;
      case 1:
        return simulation_.remove_moving_obstacle(any);
      default:
        simulation_.change_moving_obstacle(any, mover);
    }
  }

  void expect_whole() {
    const FleetView fleet = simulation_.fleet();
    for (std::size_t k = 0; k < fleet.id.size(); ++k) {
      EXPECT_EQ(simulation_.index_of(fleet.id[k]), k);
      if (k > 0) {
        EXPECT_LT(fleet.id[k - 1].value, fleet.id[k].value);
      }
      for (const std::int64_t source : simulation_.perceive(fleet.id[k]).source)
        EXPECT_TRUE(source < 0 || simulation_.index_of({static_cast<std::uint64_t>(source)}));
    }
  }

  // A simulation of the bytes of now goes on as this one does.
  void expect_the_same_future() {
    Simulation other(simulation_.save(), 1);
    EXPECT_EQ(other.state_hash(), simulation_.state_hash());
    for (int k = 0; k < 3; ++k) step(), other.step();
    EXPECT_EQ(other.state_hash(), simulation_.state_hash());
  }

  void step() {
    const FleetView before = simulation_.fleet();
    const std::vector<Vec2> places(before.position.begin(), before.position.end());
    simulation_.step();
    const FleetView fleet = simulation_.fleet();
    const auto center = [&](std::size_t k) {
      return disc_center(fleet.setup[k].model, fleet.position[k], fleet.heading[k]);
    };
    for (std::size_t k = 0; k < fleet.id.size(); ++k) {
      const RobotSetup& own = fleet.setup[k];
      ASSERT_TRUE(is_finite(fleet.position[k]) && is_finite(fleet.velocity[k])) << k;
      if (is_parked(own)) {
        EXPECT_EQ(fleet.position[k], places[k]);
      }
      for (std::size_t j = 0; j < k && keeps_promise(); ++j) {
        const RobotSetup& other = fleet.setup[j];
        if (!avoids(own, other) || !avoids(other, own)) continue;
        if (is_moved(fleet.id[k]) || is_moved(fleet.id[j])) continue;  // onto a parked one, too
        EXPECT_GT(norm(center(k) - center(j)) - disc_radius(own) - disc_radius(other), -1e-9)
            << "robots " << fleet.id[j].value << " and " << fleet.id[k].value << " after "
            << simulation_.steps();
      }
    }
  }

  // The host moves it, or it brakes since the host gave it back.
  [[nodiscard]] bool is_moved(RobotId robot) const {
    return scene_.clock == Clock::common && !is_parked(simulation_.setup(robot)) &&
           !simulation_.decided(robot);
  }

  // Every robot may be counted on: no robot is put into another one, and all is sensed as declared.
  [[nodiscard]] bool keeps_promise() const {
    return !scene_.allow_broken_assumptions && !scene_.sensing.misses() &&
           scene_.certificate != Certificate::none && scene_.method == Method::avo;
  }

  Random random_;
  Scenario scene_;
  Simulation simulation_;
  bool hosted_ = false;
  int accepted_ = 0, refused_ = 0, parked_ = 0;
};

// Eight robots on a ring with two movers through it, and walls outside.
Scenario ring() {
  Scenario scene;
  for (int k = 0; k < 8; ++k) {
    const Vec2 place{1.0 + 4.0 * (k % 4), k < 4 ? 1.0 : 13.0};
    RobotSetup robot = test::robot_at(place, {14.0 - place.x, 14.0 - place.y});
    robot.radius = 0.4;
    robot.max_speed = robot.preferred_speed = 1.2;
    scene.robots.push_back(robot);
  }
  scene.obstacles = {{.chains = {{.points = {{5, 7}, {9, 7}}}}}};
  scene.moving_obstacles = {{.position = {-3, 5}, .velocity = {0.4, 0}, .radius = 0.4}};
  return scene;
}

std::vector<std::pair<std::string, SensingModel>> all_sensing() {
  const MeasurementNoise noise{.position = 0.01, .velocity = 0.02};
  return {{"exact", {}},
          {"noise", {.noise = noise}},
          {"delay", {.delay = 1}},
          {"dropped", {.dropped = 0.2}},
          {"occlusion", {.occlusion = true}},
          {"all of it", {.noise = noise, .delay = 2, .dropped = 0.2, .occlusion = true}}};
}

void expect_whole(Scenario scene, const std::string& name, bool hosted = false) {
  int parked = 0;
  for (const bool allowed : {false, true}) {
    SCOPED_TRACE(name + (allowed ? ", where all is allowed" : ""));
    scene.allow_broken_assumptions = allowed;
    Edited edited(scene, 7, hosted);
    edited.run(160);
    if (testing::Test::HasFailure()) return;
    EXPECT_GT(edited.accepted(), 40);
    EXPECT_GT(edited.refused(), 0);
    parked += edited.parked();
  }
  if (scene.clock == Clock::common && !hosted) {
    EXPECT_GT(parked, 4);
  }
}

TEST(RandomEdits, keep_all_whole_whatever_is_sensed) {
  for (const auto& [name, sensing] : all_sensing()) {
    Scenario scene = ring();
    scene.sensing = sensing;
    // what any model needs that may come
    if (!sensing.is_exact()) scene.sensing_error = SensingError{0.3, 0.5};
    expect_whole(scene, name);
  }
  Scenario flights = ring();
  flights.moving_obstacles.clear();
  expect_whole(flights, "airplanes among others");
}

TEST(RandomEdits, keep_all_whole_with_every_method) {
  for (const Method method :
       {Method::avo_paper, Method::velocity_obstacle, Method::orca, Method::orca_clamped,
        Method::reciprocal_velocity_obstacle, Method::buffered_voronoi}) {
    Scenario scene = ring();
    scene.method = method;
    scene.sensing = all_sensing().back().second;
    expect_whole(scene, to_string(method));
  }
  Scenario scene = ring();
  scene.certificate = Certificate::none;
  expect_whole(scene, "avo without a certificate");
}

TEST(RandomEdits, keep_all_whole_with_clocks_of_their_own) {
  Scenario scene = ring();
  scene.clock = Clock::free;
  scene.longest_step = 0.1;
  scene.sensing_error = SensingError{0.3, 0.5};
  expect_whole(scene, "free clocks");
  scene.sensing = all_sensing()[1].second;
  expect_whole(scene, "free clocks and noise");
}

TEST(RandomEdits, keep_all_whole_in_the_hands_of_a_host) {
  for (const auto& [name, sensing] : all_sensing()) {
    Scenario scene = ring();
    scene.sensing = sensing;
    if (!sensing.is_exact()) scene.sensing_error = SensingError{0.3, 0.5};
    expect_whole(scene, name, true);
  }
  Scenario open = ring();
  open.moving_obstacles.clear(), open.obstacles.clear();
  expect_whole(open, "in the open", true);
  Scenario free = ring();
  free.clock = Clock::free, free.longest_step = 0.1;
  free.sensing_error = SensingError{0.3, 0.5};
  expect_whole(free, "free clocks", true);
  Scenario orca = ring();
  orca.method = Method::orca_clamped;
  expect_whole(orca, "another method", true);
}

// One that is parked from the start, and one that is parked there before the first step.
TEST(RandomEdits, parked_robots_are_the_same_whether_they_came_or_were_there) {
  for (const auto& [name, sensing] : all_sensing()) {
    Scenario scene = ring();
    scene.sensing = sensing;
    Simulation later(scene, 1);
    for (const double x : {3.0, 11.0}) {
      RobotSetup parked = test::robot_at({x, 9.0}, {x, 9.0});
      parked.behavior = Behavior::parked;
      scene.robots.push_back(parked);
      later.add_robot(parked);
    }
    Simulation there(scene, 1);
    for (int k = 0; k < 60; ++k) {
      ASSERT_EQ(later.state_hash(), there.state_hash()) << name << " " << k;
      later.step(), there.step();
    }
    later.remove_robot({8}), there.remove_robot({8});
    for (int k = 0; k < 20; ++k) later.step(), there.step();
    EXPECT_EQ(later.state_hash(), there.state_hash()) << name;
  }
}

}  // namespace
}  // namespace avo
