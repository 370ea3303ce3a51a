// SPDX-License-Identifier: Apache-2.0
// Boxes that do not move, halved repeatedly: it finds the boxes near another box.
#pragma once
#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "check/sweep.h"

namespace avo::judge {

/// The wider of the gaps along x and y, m; negative where the boxes overlap.
inline double gap(const BoundingBox& a, const BoundingBox& b) {
  double widest = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 2; ++k)
    widest = std::max({widest, a.low[k] - b.high[k], b.low[k] - a.high[k]});
  return widest;
}

/// The nodes' boxes contain those of all their descendants.
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(std::vector<BoundingBox> boxes);

  /// Calls meet(owner) for every box with a gap to `box` less than reach(), boxes in nearer halves
  /// first; reach may shrink between the calls.
  template <typename Reach, typename Meet>
  void visit(const BoundingBox& box, const Reach& reach, const Meet& meet) const {
    if (!nodes_.empty()) visit(0, box, reach, meet);
  }

 private:
  struct Node {
    BoundingBox box;
    std::size_t first = 0, last = 0;  // of boxes_
    std::size_t second_child = 0;     // the first child is the next node; 0: a leaf
  };

  void build(std::size_t first, std::size_t last);

  template <typename Reach, typename Meet>
  void visit(std::size_t index, const BoundingBox& box, const Reach& reach,
             const Meet& meet) const {
    const Node& node = nodes_[index];
    if (!(gap(node.box, box) < reach())) return;
    if (node.second_child == 0) {
      for (std::size_t k = node.first; k < node.last; ++k)
        if (gap(boxes_[k], box) < reach()) meet(boxes_[k].owner);
      return;
    }
    std::size_t nearer = index + 1, farther = node.second_child;
    if (gap(nodes_[farther].box, box) < gap(nodes_[nearer].box, box)) std::swap(nearer, farther);
    visit(nearer, box, reach, meet);
    visit(farther, box, reach, meet);
  }

  std::vector<BoundingBox> boxes_;
  std::vector<Node> nodes_;
};

}  // namespace avo::judge
