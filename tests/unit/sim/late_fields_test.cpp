// SPDX-License-Identifier: Apache-2.0
// Saved states follow the table of fields.
#include "sim/state/late_fields.h"

#include <gtest/gtest.h>
#include <set>
#include <string>
#include <vector>

#include "avo/error.h"
#include "fields/scene_fields.h"
#include "sim/state/saved_state.h"

namespace avo {
namespace {

// All fields with members, as if none of them had a place in the format.
std::vector<RobotField> all_late() {
  std::vector<RobotField> late;
  for_each_member(kRobotFields, [&](const RobotField& field, auto) { late.push_back(field); });
  return late;
}

RobotSetup unusual() {
  return {.position = {1, 2},
          .velocity = {3, 4},
          .goal = {5, 6},
          .radius = 0.7,
          .max_speed = 8.0,
          .max_acceleration = 9.0,
          .preferred_speed = 10.0,
          .priority = 11.0,
          .parked = true,
          .layers = {12},
          .avoids = {13},
          .time_step = 0.14,
          .max_braking = 15.0,
          .behavior = Behavior::moves_on,
          .method = Method::orca,
          .time_horizon = 17.0,
          .arrival_distance = 0.18};
}

std::vector<std::byte> written(RobotSetup setup, std::span<const RobotField> late) {
  Archive<false> archive;
  describe_late(archive, setup, late_kinds(setup, late), late);
  return archive.written;
}

TEST(LateFields, values_come_back) {
  const std::vector<RobotField> late = all_late();
  const RobotSetup setup = unusual();
  const std::uint64_t kinds = late_kinds(setup, late);
  EXPECT_EQ(kinds, kLateKinds & ~(~std::uint64_t{0} << (kFirstLateBit + late.size())));
  const std::vector<std::byte> bytes = written(setup, late);
  Archive<true> archive{{}, bytes};
  RobotSetup read;
  describe_late(archive, read, kinds, late);
  EXPECT_TRUE(read == setup);
  EXPECT_TRUE(archive.unread.empty());
}

TEST(LateFields, defaults_take_no_bytes) {
  const std::vector<RobotField> late = all_late();
  EXPECT_EQ(late_kinds({}, late), 0u);
  EXPECT_TRUE(written({}, late).empty());
  EXPECT_EQ(written({.priority = 2.0}, late).size(), kWord);
}

TEST(LateFields, an_unknown_field_is_refused) {
  Archive<true> archive;
  RobotSetup setup;
  try {
    describe_late(archive, setup, late_bit(2), std::span(kRobotFields).first(2));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()),
              "saved state: found the kinds of a robot 17179869184, must be known ones");
  }
}

TEST(LateFields, all_settings_of_a_scene_are_saved) {
  std::set<std::string_view> saved{"allow_broken_assumptions", "external_method"};  // by themselves
  for_each_setting([&](std::string_view key, auto) { saved.insert(key); });
  for_each_member(kScenarioFields, [&](const auto& field, auto) {
    EXPECT_TRUE(saved.contains(field.key))
        << "src/sim/state/saved_state.h: for_each_setting lacks visit(\"" << field.key
        << "\", &Scenario::" << field.key << ");";
  });
  std::set<std::string_view> of_movers;
  for_each_obstacle_value([&](std::string_view key, auto) { of_movers.insert(key); });
  for_each_member(kMoverFields, [&](const auto& field, auto) {
    EXPECT_TRUE(of_movers.contains(field.key))
        << "src/sim/state/saved_state.h: for_each_obstacle_value lacks visit(\"" << field.key
        << "\", &MovingObstacle::" << field.key << ");";
  });
}

}  // namespace
}  // namespace avo
