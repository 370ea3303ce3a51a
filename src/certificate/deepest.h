// SPDX-License-Identifier: Apache-2.0
// How deep a contact is, and whether that is no more than rounding.
#pragma once

namespace avo::inline certificate {

/// m: how deep a contact rounding may feign, of both radii together and of the ways that both need
/// to stop. It is sixteen roundings to single precision, in which robots are often told their
/// state: of places 256 times as far from the origin as the radii are long, and of these ways
/// (docs/on_board.md, "Contact"). Where the two are does not count, only how far they are apart.
constexpr double feigned_depth(double radii, double ways) {
  return 0x1p-12 * radii + 0x1p-20 * ways;
}

/// The deepest of several contacts, of equally deep ones that of the least index.
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
