// SPDX-License-Identifier: Apache-2.0
// A saved simulation goes on, bit by bit, as the one that saved it; other bytes are refused.
#include <algorithm>
#include <cstddef>
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "avo/error.h"
#include "avo/simulation.h"
#include "core/hash.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::dense_avo_scene;
using test::dense_scene;
using test::Random;
using Bytes = std::vector<std::byte>;

Vec2 somewhere(Random& random, double low, double high) {
  const double x = random.uniform(low, high);
  return {x, random.uniform(low, high)};
}

void add_any_robot(Random& random, Simulation& simulation) {
  const Vec2 place = somewhere(random, 300.0, 600.0);  // out of sight of the others
  RobotSetup setup = test::robot_at(place, somewhere(random, 0.0, 20.0));
  setup.max_speed = setup.preferred_speed = random.uniform(0.05, 0.2);
  if (random.below(3) == 0) setup.priority = random.log_uniform(0.01, 100.0);
  if (random.below(3) == 0) setup.max_braking = 0.6 * setup.max_acceleration;
  if (random.below(2) == 0 && simulation.planner().options().motion == Motion::held) {
    setup.model = Car{0.7}, setup.heading = random.uniform(-3.0, 3.0);
  }
  simulation.add_robot(setup);
}

// Anything that a user can do to a simulation.
void edit(Random& random, Simulation& simulation) {
  const int robots = static_cast<int>(simulation.fleet().id.size());
  const int kind = random.below(4);
  if (kind == 0) return simulation.step();
  if (kind == 1 || robots == 0) return add_any_robot(random, simulation);
  const RobotId robot = simulation.fleet().id[static_cast<std::size_t>(random.below(robots))];
  if (kind == 2) return simulation.remove_robot(robot);
  const std::size_t index = simulation.fleet().id.size();
  for (std::size_t k = 0; k < index; ++k) {
    if (simulation.fleet().id[k] == robot && simulation.fleet().setup[k].parked) return;
  }
  simulation.set_goal(robot, somewhere(random, 0.0, 20.0));
}

// Some are parked, and not all avoid each other.
void mix_conduct(Random& random, Scenario& scene) {
  for (RobotSetup& robot : scene.robots) {
    if (random.below(8) == 0) {
      robot.parked = true;
      robot.goal = robot.position;
      robot.velocity = {};
    } else if (random.below(3) == 0) {
      robot.layers.bits = 1U + static_cast<std::uint32_t>(random.below(3));
      robot.avoids.bits = static_cast<std::uint32_t>(random.below(4));
    }
  }
}

// The hashes of what comes later, edits included, and at last the saved bytes.
std::pair<std::vector<std::uint64_t>, Bytes> future(Simulation& simulation, std::uint64_t seed) {
  Random random(seed);
  std::vector<std::uint64_t> hashes{simulation.state_hash()};
  for (int k = 0; k < 30; ++k) {
    k % 3 == 0 ? edit(random, simulation) : simulation.step();
    hashes.push_back(simulation.state_hash());
  }
  return {hashes, simulation.save()};
}

Scenario random_scene(Random& random) {
  constexpr Certificate kCertificates[] = {Certificate::stopping_capsules,
                                           Certificate::braking_trajectories};
  const Motion motion = random.below(2) == 0 ? Motion::held : Motion::exponential;
  const int robots = random.below(12) == 0 ? 270 : random.below(60);
  const std::uint64_t seed = random.bits();
  const bool mixed = random.below(3) == 0;
  if (random.below(4) == 0) {
    Scenario scene = dense_scene(robots, motion, seed);
    if (mixed) mix_conduct(random, scene);
    return scene;
  }
  Scenario scene = dense_avo_scene(robots, motion, kCertificates[random.below(2)], seed);
  scene.sensing_radius = 20.0;
  if (random.below(3) == 0) scene.moving_obstacles.clear();
  for (MovingObstacle& each : scene.moving_obstacles) {
    if (random.below(3) > 0) continue;
    each.acceleration = {};
    each.max_deviation = 0.5, each.max_speed = norm(each.velocity) + 0.1;
    if (random.below(2) == 0) each.path = {somewhere(random, 0.0, 20.0), {3.0, 4.0}, {5.0, 4.0}};
  }
  if (mixed) mix_conduct(random, scene);
  return scene;
}

// Each robot decides by a clock of its own, some of them more often.
Scenario with_clocks(Random& random, Scenario scene) {
  scene.motion = Motion::held;
  if (scene.certificate == Certificate::stopping_capsules)
    scene.certificate = Certificate::braking_trajectories;
  scene.clock = Clock::free;
  scene.longest_step = 0.2;
  for (RobotSetup& robot : scene.robots) {
    if (!robot.parked && random.below(3) == 0) robot.time_step = random.below(2) == 0 ? 0.05 : 0.2;
  }
  return scene;
}

TEST(Saving, any_simulation_goes_on_as_before) {
  for (std::uint64_t seed = 0; seed < 60 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Scenario scene = random_scene(random);
    if (seed % 3 == 0) scene = with_clocks(random, scene);
    Simulation original(scene, 1), fresh(scene, 2), used(scene, 2);
    for (int k = random.below(60); k > 0; --k) edit(random, original);
    for (int k = random.below(30); k > 0; --k) edit(random, used);
    const Bytes saved = original.save();
    Simulation alone(saved, 1);
    fresh.restore(saved);
    used.restore(saved);
    EXPECT_EQ(used.save(), saved);
    const auto expected = future(original, seed);
    for (Simulation* restored : {&fresh, &used, &alone}) {
      EXPECT_EQ(future(*restored, seed), expected);
    }
  }
}

// Robots in the order of their cells, on several threads, with their nearest neighbors remembered.
TEST(Saving, large_fleets_go_on_as_before) {
  Scenario scene = dense_avo_scene(1100, Motion::held, Certificate::braking_trajectories);
  scene.max_neighbors = 6;
  Simulation original(scene, 2);
  for (int k = 0; k < 19; ++k) original.step();
  const Bytes saved = original.save();
  Simulation one(saved, 1), two(scene, 2);
  two.restore(saved);
  for (int k = 0; k < 20; ++k) {
    original.step(), one.step(), two.step();
    ASSERT_EQ(one.state_hash(), original.state_hash()) << k;
    ASSERT_EQ(two.state_hash(), original.state_hash()) << k;
  }
}

TEST(Saving, goes_back_and_forth_in_one_simulation) {
  Simulation simulation(dense_scene(40, Motion::held), 1);
  std::vector<Bytes> saved;
  std::vector<std::uint64_t> hashes;
  for (int k = 0; k < 30; ++k) {
    saved.push_back(simulation.save());
    hashes.push_back(simulation.state_hash());
    simulation.step();
  }
  for (const std::size_t k : {20u, 3u, 29u, 0u, 14u}) {
    simulation.restore(saved[k]);
    EXPECT_EQ(simulation.steps(), static_cast<std::int64_t>(k));
    EXPECT_EQ(simulation.state_hash(), hashes[k]);
    while (simulation.steps() < 29) simulation.step();
    EXPECT_EQ(simulation.state_hash(), hashes[29]);
  }
}

TEST(Saving, shows_the_saved_robots_and_nothing_of_the_last_step) {
  Simulation simulation(dense_scene(20, Motion::held), 1);
  for (int k = 0; k < 5; ++k) simulation.step();
  simulation.set_goal({7}, {3, 4});
  simulation.remove_robot({2});
  const Simulation restored(simulation.save(), 1);
  const FleetView a = simulation.fleet(), b = restored.fleet();
  ASSERT_EQ(b.id.size(), 19u);
  for (std::size_t k = 0; k < b.id.size(); ++k) {
    EXPECT_EQ(a.id[k], b.id[k]);
    EXPECT_EQ(a.position[k], b.position[k]);
    EXPECT_EQ(a.velocity[k], b.velocity[k]);
    EXPECT_EQ(a.heading[k], b.heading[k]);
    EXPECT_EQ(a.goal[k], b.goal[k]);
    EXPECT_EQ(a.setup[k].radius, b.setup[k].radius);
    EXPECT_EQ(a.setup[k].max_speed, b.setup[k].max_speed);
    EXPECT_EQ(a.setup[k].max_acceleration, b.setup[k].max_acceleration);
    EXPECT_EQ(a.setup[k].preferred_speed, b.setup[k].preferred_speed);
    EXPECT_EQ(a.setup[k].model, b.setup[k].model);
    EXPECT_EQ(b.plan[k].new_velocity, Vec2{});
    EXPECT_EQ(b.applied_acceleration[k], 0.0);
  }
  EXPECT_EQ(restored.time(), simulation.time());
  EXPECT_EQ(restored.threads(), 1);
}

TEST(Saving, ids_are_not_reused_after_it) {
  Simulation simulation(dense_scene(5, Motion::held), 1);
  simulation.remove_robot({4});
  Simulation restored(simulation.save(), 1);
  EXPECT_EQ(restored.add_robot(test::robot_at({500, 500}, {500, 500})).value, 5u);
}

Scenario holonomic_scene(int robots) {
  Scenario scene = dense_scene(robots, Motion::held);
  for (RobotSetup& robot : scene.robots) robot.model = Holonomic{};
  return scene;
}

TEST(Saving, takes_64_bytes_a_robot_beside_its_setup) {
  constexpr std::size_t kSetup = 11 * sizeof(double);  // goal, radius, limits, model, conduct
  Simulation few(holonomic_scene(10), 1), many(holonomic_scene(110), 1);
  few.step(), many.step();
  EXPECT_LE(many.save().size() - few.save().size(), 100 * (kSetup + 64));
}

std::string refusal(Simulation& simulation, const Bytes& bytes) {
  const std::uint64_t hash = simulation.state_hash();
  std::string message = "accepted";
  try {
    simulation.restore(bytes);
  } catch (const Error& error) {
    message = error.what();
  }
  EXPECT_EQ(simulation.state_hash(), hash) << message;
  EXPECT_THROW(Simulation(bytes, 1), Error);
  EXPECT_EQ(message.find("saved state: "), 0u) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  return message;
}

TEST(Saving, every_changed_bit_is_noticed) {
  Simulation simulation(dense_scene(3, Motion::held), 1);
  const Bytes saved = simulation.save();
  simulation.step();
  for (std::size_t k = 0; k < saved.size(); ++k) {
    for (int bit = 0; bit < 8; ++bit) {
      Bytes changed = saved;
      changed[k] ^= std::byte(1 << bit);
      ASSERT_NE(refusal(simulation, changed), "accepted") << k;
    }
  }
}

TEST(Saving, bytes_that_are_cut_off_or_go_on_are_refused) {
  Simulation simulation(dense_scene(3, Motion::held), 1);
  const Bytes saved = simulation.save();
  simulation.step();
  for (std::size_t size = 0; size < saved.size(); ++size) {
    ASSERT_NE(refusal(simulation, Bytes(saved.begin(), saved.begin() + std::ptrdiff_t(size))), "");
  }
  Bytes longer = saved;
  longer.insert(longer.end(), 8, std::byte{0});
  EXPECT_NE(refusal(simulation, longer).find("bytes, must be the"), std::string::npos);
}

std::uint64_t word(const Bytes& bytes, std::size_t index) {
  std::uint64_t value = 0;
  for (std::size_t k = 8; k-- > 0;)
    value = value << 8 | std::to_integer<std::uint64_t>(bytes[8 * index + k]);
  return value;
}
void set_word(Bytes& bytes, std::size_t index, std::uint64_t value) {
  for (std::size_t k = 0; k < 8; ++k) bytes[8 * index + k] = std::byte(value >> (8 * k) & 0xff);
}
// A forger knows the length and the checksum.
void seal(Bytes& bytes) {
  const std::size_t words = bytes.size() / 8;
  set_word(bytes, 1, bytes.size());
  std::uint64_t hash = 0;
  for (std::size_t k = 0; k + 1 < words; ++k) hash = mixed(hash, word(bytes, k));
  set_word(bytes, words - 1, hash);
}

// A simulation that accepts forged bytes has to be one that can go on.
void expect_refused_or_sound(const Bytes& bytes) {
  try {
    Simulation simulation(bytes, 1);
    for (int k = 0; k < 2; ++k) simulation.step();
    EXPECT_EQ(Simulation(simulation.save(), 1).state_hash(), simulation.state_hash());
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

TEST(Saving, arbitrary_bytes_do_no_harm) {
  Random random(5);
  Scenario scene = dense_avo_scene(3, Motion::held, Certificate::braking_trajectories);
  scene.name = "a name of some letters";
  const Bytes without_walls = Simulation(scene, 1).save();
  scene.obstacles = {{{{{{-9, -9}, {9, -9}, {9, -8}}, true}}, 0.1}, {{{{{20, 3}}, false}}, 0.5}};
  const Bytes among_walls = Simulation(scene, 1).save();
  const Bytes by_clocks = Simulation(with_clocks(random, scene), 1).save();
  constexpr std::uint64_t kOdd[] = {0,
                                    1,
                                    2,
                                    255,
                                    1u << 31,
                                    ~0ull,
                                    1ull << 63,
                                    0x7ff0000000000000,
                                    0x7ff8000000000000,
                                    0x3ff0000000000000,
                                    0x7fefffffffffffff};
  for (int k = 0; k < 4000; ++k) {
    Bytes bytes = k % 12 < 4 ? without_walls : k % 12 < 8 ? among_walls : by_clocks;
    if (k % 4 == 0) {
      bytes.assign(static_cast<std::size_t>(random.below(400)), std::byte{0});
      for (std::byte& value : bytes) value = std::byte(random.below(256));
    }
    const auto words = static_cast<int>(bytes.size() / 8);
    if (k % 4 == 1) bytes.resize(8 * (3 + static_cast<std::size_t>(random.below(words))));
    for (int n = random.below(4); n > 0 && words > 3; --n) {
      const auto at =
          static_cast<std::size_t>(2 + random.below(static_cast<int>(bytes.size() / 8) - 2));
      set_word(bytes, at, random.below(2) == 0 ? random.bits() : kOdd[random.below(11)]);
    }
    if (k % 4 != 0) seal(bytes);
    expect_refused_or_sound(bytes);
  }
}

TEST(Saving, forged_values_are_refused) {
  Simulation simulation(holonomic_scene(3), 1);
  const Bytes saved = simulation.save();
  const std::size_t last = saved.size() / 8 - 1;  // behind the last robot
  const std::size_t end = last;                   // behind its detour
  const auto forged = [&](std::size_t index, std::uint64_t value) {
    Bytes bytes = saved;
    set_word(bytes, index, value);
    seal(bytes);
    return refusal(simulation, bytes);
  };
  constexpr std::uint64_t kNan = 0x7ff8000000000000, kInfinity = 0x7ff0000000000000;
  const std::string infinite = "saved state: found a position or velocity that is not finite";
  ASSERT_EQ(word(saved, end - 8), 2u);
  EXPECT_EQ(forged(end - 8, 1), "saved state: found id 1, must be ascending and below the next, 3");
  EXPECT_EQ(forged(end - 8, 3), "saved state: found id 3, must be ascending and below the next, 3");
  EXPECT_EQ(forged(end - 7, kNan), infinite + ", must be finite");
  EXPECT_EQ(forged(end - 4, kInfinity), infinite + ", must be finite");
  EXPECT_EQ(forged(end - 3, kInfinity), "saved state: found heading inf, must be an angle in rad");
  for (const std::size_t part : {end - 2, end - 1}) {  // of the detour
    for (const std::uint64_t value : {kNan, kInfinity, 0xbff0000000000000}) {
      EXPECT_EQ(forged(part, value),
                "saved state: found a detour that no robot can remember, must be a sound one");
    }
  }
  EXPECT_EQ(word(saved, 14), static_cast<std::uint64_t>(Method::avo_paper));
  EXPECT_EQ(forged(14, 4), "saved state: found an unknown choice, must be a known one");
  EXPECT_EQ(forged(14, 1000), "saved state: found the number 1000, must be one that its type has");
  const std::size_t robots = last - 3 * 19 - 1, obstacles = robots - 3 * 16 - 1;
  ASSERT_EQ(word(saved, robots), 3u);
  EXPECT_EQ(forged(obstacles - 2, 1ull << 63),
            "saved state: found -9223372036854775808 steps, must be 0 to 9007199254740992");
  EXPECT_EQ(forged(robots, 1ull << 60),
            "saved state: found 1152921504606846976 entries, must be at most 3");
  // a parked robot is at its goal, and at rest
  EXPECT_EQ(forged(end - 11, 1),
            "saved state: found a parked robot that has moved, must be one at its goal");
  EXPECT_EQ(forged(robots, 2), "saved state: found 152 more bytes, must be no more");
}

TEST(Saving, forged_ways_and_static_obstacles_are_refused) {
  Scenario scene;
  scene.obstacles = {{{{{{5, -1}, {5, 1}}}}}};
  for (const double y : {0.0, 2.0, 4.0}) scene.robots.push_back(test::robot_at({0, y}, {10, y}));
  Simulation simulation(scene, 1);
  const Bytes saved = simulation.save();
  const std::size_t robots = saved.size() / 8 - 1 - 3 * 19 - 1, movers = robots - 1;
  const std::size_t ways = movers - 2 - 3 - 1, next_obstacle = ways - 1;
  ASSERT_EQ(word(saved, ways), 3u);
  ASSERT_EQ(word(saved, next_obstacle), 1u);
  Bytes fewer = saved;
  set_word(fewer, ways, 2);
  fewer.erase(fewer.begin() + std::ptrdiff_t(8 * ways + 8),
              fewer.begin() + std::ptrdiff_t(8 * ways + 16));
  seal(fewer);
  EXPECT_EQ(refusal(simulation, fewer), "saved state: found 2 ways, must be 3");
  Bytes taken = saved;
  set_word(taken, next_obstacle, 0);
  seal(taken);
  EXPECT_EQ(refusal(simulation, taken),
            "saved state: found id 0, must be ascending and below the next, 0");
  for (const std::uint64_t target : {0ull, 7ull, 0xfffffffcull, 0xfffffffdull, 0xfffffffeull}) {
    Bytes odd = saved;
    set_word(odd, ways + 1, target);
    seal(odd);
    expect_refused_or_sound(odd);
  }
}

TEST(Saving, other_scenes_are_refused_by_what_differs) {
  Scenario scene = dense_scene(5, Motion::held);
  scene.name = "one";
  const Bytes saved = Simulation(scene, 1).save();
  const auto refused_by = [&](auto&& change) {
    Scenario other = scene;
    change(other);
    Simulation simulation(other, 1);
    const std::uint64_t hash = simulation.state_hash();
    try {
      simulation.restore(saved);
    } catch (const Error& error) {
      EXPECT_EQ(simulation.state_hash(), hash);
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(refused_by([](Scenario& s) { s.name = "two"; }),
            "saved state: name: found \"one\", must be \"two\" as in this simulation");
  EXPECT_EQ(refused_by([](Scenario& s) { s.name = "two\nlines"; }),
            "saved state: name: found \"one\", must be \"two lines\" as in this simulation");
  EXPECT_EQ(refused_by([](Scenario& s) { s.time_step = 0.05; }),
            "saved state: time_step: found 0.1, must be 0.05 as in this simulation");
  EXPECT_EQ(refused_by([](Scenario& s) { s.method = Method::orca; }),
            "saved state: method: found avo_paper, must be orca as in this simulation");
  EXPECT_EQ(refused_by([](Scenario& s) { s.max_neighbors.reset(); }),
            "saved state: max_neighbors: found 10, must be none as in this simulation");
  EXPECT_EQ(refused_by([](Scenario& s) { s.right_of_way = RightOfWay::told; }),
            "saved state: right_of_way: found seen, must be told as in this simulation");
  EXPECT_EQ(
      refused_by([](Scenario& s) { s.sensing.delay = 2; }),
      "saved state: sensing: found {noise: {position: 0, velocity: 0, distribution: gaussian}, "
      "delay: 0, dropped: 0, occlusion: false}, must be {noise: {position: 0, velocity: 0, "
      "distribution: gaussian}, delay: 2, dropped: 0, occlusion: false} as in this simulation");
  const std::string obstacles =
      "saved state: moving_obstacles: found others, must be those of this simulation";
  EXPECT_EQ(refused_by([](Scenario& s) { s.moving_obstacles.pop_back(); }), obstacles);
  EXPECT_EQ(refused_by([](Scenario& s) { s.moving_obstacles[1].radius = 0.41; }), obstacles);
  EXPECT_EQ(refused_by([](Scenario& s) { s.moving_obstacles[1].max_deviation = 1.0; }), obstacles);
  EXPECT_EQ(refused_by([](Scenario& s) { s.robots.clear(); }), "accepted");  // they come and go
}

TEST(Saving, states_of_other_versions_are_refused) {
  Simulation simulation(dense_scene(3, Motion::held), 1);
  Bytes saved = simulation.save();
  ASSERT_EQ(word(saved, 2), 5u);  // letters of 0.1.0
  saved[24] = std::byte{'7'};
  seal(saved);
  EXPECT_EQ(refusal(simulation, saved),
            "saved state: found one of avo 7.1.0, must be one of avo 0.1.0");
  saved[25] = std::byte{'\n'};
  seal(saved);
  EXPECT_EQ(refusal(simulation, saved),
            "saved state: found one of another program, must be one of avo 0.1.0");
}

TEST(Saving, bytes_are_the_same_on_every_machine) {
  const Bytes saved = Simulation(Scenario{}, 1).save();
  const std::string mark = "avo save";
  for (std::size_t k = 0; k < mark.size(); ++k) EXPECT_EQ(saved[k], std::byte(mark[k]));
  EXPECT_EQ(word(saved, 1), saved.size());
}

}  // namespace
}  // namespace avo
