// SPDX-License-Identifier: Apache-2.0
// The depth of a contact, and whether it is within rounding.
#pragma once

namespace avo::inline certificate {

/// m: the contact depth that rounding may cause, from the sum of the radii and the displacements
/// that both robots need to stop. It is sixteen roundings to single precision, in which robots
/// often receive their state. These are roundings of places 256 times as far from the origin as the
/// radii are long, and of these displacements (docs/on_board.md, "Contact"). The places of the two
/// do not count, only their distance.
constexpr double feigned_depth(double radii, double ways) {
  return 0x1p-12 * radii + 0x1p-20 * ways;
}

/// The deepest of several contacts; of equally deep contacts the one with the least index.
struct Deepest {
  int index = -1;      ///< of a neighbor or a wall; -1: there is no contact
  double depth = 0.0;  ///< m, > 0 if there is one

  bool any() const { return index >= 0; }
  void take(int other, double depth_of_other) {
    if (!(depth_of_other > depth) && !(depth_of_other == depth && other < index)) return;
    index = other, depth = depth_of_other;
  }
};

}  // namespace avo::inline certificate
