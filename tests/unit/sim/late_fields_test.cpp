// SPDX-License-Identifier: Apache-2.0
// Saved states follow the table of fields.
#include "sim/state/late_fields.h"

#include <gtest/gtest.h>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "avo/error.h"
#include "fields/scene_fields.h"
#include "sim/state/saved_state.h"

namespace avo {
namespace {

// All fields with members, as if none of them had a place in the format.
std::vector<RobotField> all_late() {
  std::vector<RobotField> late;
  for_each_member(kFields<RobotSetup>,
                  [&](const RobotField& field, auto) { late.push_back(field); });
  return late;
}

// Other values than the defaults in all fields, and different ones.
RobotSetup unusual() {
  RobotSetup setup;
  double number = 3.25;
  for_each_member(kFields<RobotSetup>, [&](const RobotField&, auto member) {
    auto& value = setup.*member;
    using Value = std::decay_t<decltype(value)>;
    number += 1.0;
    if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, std::optional<double>>)
      value = number;
    else if constexpr (std::is_same_v<Value, Vec2>)
      value = {number, -number};
    else if constexpr (std::is_same_v<Value, LayerSet>)
      value = {static_cast<std::uint32_t>(number)};
    else if constexpr (std::is_same_v<Value, bool>)
      value = !value;
    else if constexpr (std::is_same_v<Value, Behavior>)
      value = Behavior::moves_on;
    else
      value = Method::orca;
  });
  return setup;
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
    describe_late(archive, setup, late_bit(2), std::span(kFields<RobotSetup>).first(2));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()),
              "saved state: found the kinds of a robot 17179869184, must be known ones");
  }
}

TEST(LateFields, all_settings_of_a_scene_are_saved) {
  std::set<std::string_view> saved{"allow_broken_assumptions", "external_method",
                                   "execution_error"};  // by themselves
  for_each_setting([&](std::string_view key, auto) { saved.insert(key); });
  for_each_member(kFields<Scenario>, [&](const auto& field, auto) {
    EXPECT_TRUE(saved.contains(field.key))
        << "src/sim/state/saved_state.h: for_each_setting lacks visit(\"" << field.key
        << "\", &Scenario::" << field.key << ");";
  });
  std::set<std::string_view> of_movers;
  for_each_mover_value([&](std::string_view key, auto) { of_movers.insert(key); });
  for_each_member(kFields<MovingObstacle>, [&](const auto& field, auto) {
    EXPECT_TRUE(of_movers.contains(field.key))
        << "src/sim/state/saved_state.h: for_each_mover_value lacks visit(\"" << field.key
        << "\", &MovingObstacle::" << field.key << ");";
  });
}

}  // namespace
}  // namespace avo
