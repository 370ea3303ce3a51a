// SPDX-License-Identifier: Apache-2.0
// Bytes that no simulation has saved are refused, or make a sound one.
#include <algorithm>
#include <cstddef>
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "avo/error.h"
#include "avo/simulation.h"
#include "core/hash.h"
#include "unit/sim/saving.h"

namespace avo {
namespace {

using test::Bytes;
using test::dense_avo_scene;
using test::dense_scene;
using test::holonomic_scene;
using test::Random;
using test::with_clocks;

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

TEST(SavedBytes, every_changed_bit_is_noticed) {
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

TEST(SavedBytes, bytes_that_are_cut_off_or_go_on_are_refused) {
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

TEST(SavedBytes, arbitrary_bytes_do_no_harm) {
  Random random(5);
  Scenario scene = dense_avo_scene(3, Motion::held, Certificate::braking_trajectories);
  scene.name = "a name of some letters";
  const Bytes without_walls = Simulation(scene, 1).save();
  scene.obstacles = {{{{{{-9, -9}, {9, -9}, {9, -8}}, true}}, 0.1}, {{{{{20, 3}}, false}}, 0.5}};
  const Bytes among_walls = Simulation(scene, 1).save();
  const Bytes by_clocks = Simulation(with_clocks(random, scene), 1).save();
  scene.sensing = {.delay = 1, .dropped = 0.2, .localization = {.position = 0.01}};
  Simulation late(with_clocks(random, scene), 1);
  for (int k = 0; k < 30; ++k) late.step();
  const Bytes by_tracks = late.save();
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
    if (k % 24 >= 20) bytes = by_tracks;
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

TEST(SavedBytes, forged_values_are_refused) {
  Simulation simulation(holonomic_scene(3), 1);
  const Bytes saved = simulation.save();
  const std::size_t last = saved.size() / 8 - 1;  // behind the last robot
  const std::size_t end = last - 1;               // before its last acceleration
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
  EXPECT_EQ(word(saved, 22), static_cast<std::uint64_t>(Method::avo_paper));
  EXPECT_EQ(forged(22, 9), "saved state: found an unknown choice, must be a known one");
  EXPECT_EQ(forged(24, 1),
            "saved state: certificate: found stopping_capsules, must be braking_trajectories: "
            "stopping_capsules was removed");
  EXPECT_EQ(forged(26, 25),
            "saved state: samples: found 25, must be left out: all half-planes are exact");
  EXPECT_EQ(forged(31, 2), "saved state: right_of_way: found told, must be seen: told was removed");
  EXPECT_EQ(forged(22, 1000), "saved state: found the number 1000, must be one that its type has");
  const std::size_t robots = last - 3 * 20 - 1, obstacles = robots - 3 * 17 - 1;
  ASSERT_EQ(word(saved, robots), 3u);
  EXPECT_EQ(forged(obstacles - 2, 1ull << 63),
            "saved state: found -9223372036854775808 steps, must be 0 to 9007199254740992");
  EXPECT_EQ(forged(robots, 1ull << 60),
            "saved state: found 1152921504606846976 entries, must be at most 3");
  // a parked robot is at its goal, and at rest
  EXPECT_EQ(forged(end - 11, 1),
            "saved state: found a parked robot that has moved, must be one at its goal");
  for (const char* kinds : {"3", "9", "33", "40", "64", "256"})
    EXPECT_EQ(
        forged(end - 11, std::stoul(kinds)),
        std::string("saved state: found the kinds of a robot ") + kinds + ", must be known ones");
  EXPECT_EQ(forged(robots, 2), "saved state: found 160 more bytes, must be no more");
}

TEST(SavedBytes, forged_ways_and_static_obstacles_are_refused) {
  Scenario scene;
  scene.obstacles = {{{{{{5, -1}, {5, 1}}}}}};
  for (const double y : {0.0, 2.0, 4.0}) scene.robots.push_back(test::robot_at({0, y}, {10, y}));
  Simulation simulation(scene, 1);
  const Bytes saved = simulation.save();
  const std::size_t robots = saved.size() / 8 - 1 - 3 * 20 - 1, movers = robots - 1;
  const std::size_t routes = movers - 2 - 3 - 1, next_obstacle = routes - 1;
  ASSERT_EQ(word(saved, routes), 3u);
  ASSERT_EQ(word(saved, next_obstacle), 1u);
  Bytes fewer = saved;
  set_word(fewer, routes, 2);
  fewer.erase(fewer.begin() + std::ptrdiff_t(8 * routes + 8),
              fewer.begin() + std::ptrdiff_t(8 * routes + 16));
  seal(fewer);
  EXPECT_EQ(refusal(simulation, fewer), "saved state: found 2 routes, must be 3");
  Bytes taken = saved;
  set_word(taken, next_obstacle, 0);
  seal(taken);
  EXPECT_EQ(refusal(simulation, taken),
            "saved state: found id 0, must be ascending and below the next, 0");
  const std::size_t radius = next_obstacle - 2;  // no robot has stood near a shared goal
  for (const std::uint64_t value : {0ull, 0x7ff8000000000000ull, 0xbff0000000000000ull}) {
    Bytes blind = saved;
    set_word(blind, radius, value);
    seal(blind);
    EXPECT_TRUE(refusal(simulation, blind).starts_with("saved state: found a sensing radius of "));
  }
  for (const std::uint64_t target : {0ull, 7ull, 0xfffffffcull, 0xfffffffdull, 0xfffffffeull}) {
    Bytes odd = saved;
    set_word(odd, routes + 1, target);
    seal(odd);
    expect_refused_or_sound(odd);
  }
}

TEST(SavedBytes, other_scenes_are_refused_by_what_differs) {
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
  EXPECT_EQ(refused_by([](Scenario& s) { s.right_of_way = RightOfWay::none; }),
            "saved state: right_of_way: found seen, must be none as in this simulation");
  EXPECT_EQ(
      refused_by([](Scenario& s) { s.sensing.delay = 2; }),
      "saved state: sensing: found {noise: {position: 0, velocity: 0, distribution: gaussian}, "
      "delay: 0, dropped: 0, occlusion: false}, must be {noise: {position: 0, velocity: 0, "
      "distribution: gaussian}, delay: 2, dropped: 0, occlusion: false} as in this simulation");
  // they come and go
  EXPECT_EQ(refused_by([](Scenario& s) { s.moving_obstacles.pop_back(); }), "accepted");
  EXPECT_EQ(refused_by([](Scenario& s) { s.moving_obstacles[1].radius = 0.41; }), "accepted");
  EXPECT_EQ(refused_by([](Scenario& s) { s.robots.clear(); }), "accepted");
}

TEST(SavedBytes, states_of_other_versions_are_refused) {
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

TEST(SavedBytes, bytes_are_the_same_on_every_machine) {
  const Bytes saved = Simulation(Scenario{}, 1).save();
  const std::string mark = "avo save";
  for (std::size_t k = 0; k < mark.size(); ++k) EXPECT_EQ(saved[k], std::byte(mark[k]));
  EXPECT_EQ(word(saved, 1), saved.size());
}

}  // namespace
}  // namespace avo
