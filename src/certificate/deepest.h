// SPDX-License-Identifier: Apache-2.0
// How deep a contact is, and whether that is no more than rounding.
#pragma once
#include <algorithm>

namespace avo {

/// m: how deep a contact rounding may feign, of the radii and of the other lengths (coordinates,
/// ways) that it is told from. It is sixteen roundings to single precision, in which robots are
/// often told their place (docs/on_board.md, "Contact"). Far from the origin, where nobody keeps
/// coordinates in it, radii alone count.
inline double feigned_depth(double lengths, double radii) {
  return std::min(0x1p-20 * (lengths + radii), 0x1p-10 * radii);
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

}  // namespace avo
