// SPDX-License-Identifier: Apache-2.0
// Fields of robots that are younger than the format of saved states. If a robot's value is not the
// default, the word of the robot's kinds has the field's bit, and the value follows the older ones.
// So a state without such values keeps the bytes that earlier builds wrote.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "fields/robot_fields.h"
#include "sim/state/archive.h"

namespace avo::inline sim {

/// The fields up to this one have their places in the format. Every later one takes the next bit.
inline constexpr std::size_t kEarlyFields = 23;
static_assert(kFields<RobotSetup>[kEarlyFields - 1].key == "arrival_distance",
              "new fields of robots come last: saved states number them");
inline constexpr std::span<const RobotField> kLateFields =
    std::span(kFields<RobotSetup>).subspan(kEarlyFields);
inline constexpr int kFirstLateBit = 32;
static_assert(kFirstLateBit + kLateFields.size() <= 64);
inline constexpr std::uint64_t kLateKinds = ~std::uint64_t{0} << kFirstLateBit;

constexpr std::uint64_t late_bit(std::size_t field) {
  return std::uint64_t{1} << (kFirstLateBit + static_cast<int>(field));
}

/// The bits of the fields with values other than the default ones.
inline std::uint64_t late_kinds(const RobotSetup& setup, std::span<const RobotField> late) {
  std::uint64_t bits = 0;
  const RobotSetup usual;
  for (std::size_t k = 0; k < late.size(); ++k)
    for_each_member(late.subspan(k, 1), [&](const RobotField&, auto member) {
      if (!(setup.*member == usual.*member)) bits |= late_bit(k);
    });
  return bits;
}

/// The values of the fields that have their bits in `kinds`.
template <bool kReads>
void describe_late(Archive<kReads>& archive, RobotSetup& setup, std::uint64_t kinds,
                   std::span<const RobotField> late) {
  for (std::size_t k = 0; k < late.size(); ++k) {
    if ((kinds & late_bit(k)) == 0) continue;
    for_each_member(late.subspan(k, 1),
                    [&](const RobotField&, auto member) { describe(archive, setup.*member); });
    kinds &= ~late_bit(k);
  }
  if (kinds != 0) refuse_saved("the kinds of a robot " + std::to_string(kinds), "known ones");
}

}  // namespace avo::inline sim
