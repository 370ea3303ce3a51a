// SPDX-License-Identifier: Apache-2.0
// Boxes that do not move, halved repeatedly at the median of their centers.
#include "check/box_tree.h"

namespace avo::judge {
namespace {

constexpr std::size_t kLeaf = 4;  // boxes

BoundingBox hull(const std::vector<BoundingBox>& boxes, std::size_t first, std::size_t last) {
  BoundingBox result = boxes[first];
  for (std::size_t i = first + 1; i < last; ++i) result = hull(result, boxes[i]);
  return result;
}

}  // namespace

BoxTree::BoxTree(std::vector<BoundingBox> boxes) : boxes_(std::move(boxes)) {
  if (!boxes_.empty()) build(0, boxes_.size());
}

void BoxTree::build(std::size_t first, std::size_t last) {
  const std::size_t index = nodes_.size();
  const BoundingBox box = hull(boxes_, first, last);
  nodes_.push_back({box, first, last});
  if (last - first <= kLeaf) return;
  const std::size_t axis = box.high[1] - box.low[1] > box.high[0] - box.low[0] ? 1 : 0;
  const std::size_t half = first + (last - first) / 2;
  const auto at = [this](std::size_t k) { return boxes_.begin() + static_cast<std::ptrdiff_t>(k); };
  std::nth_element(at(first), at(half), at(last),
                   [axis](const BoundingBox& a, const BoundingBox& b) {
                     return std::pair(a.low[axis] + a.high[axis], a.owner) <
                            std::pair(b.low[axis] + b.high[axis], b.owner);
                   });
  build(first, half);
  nodes_[index].second_child = nodes_.size();
  build(half, last);
}

}  // namespace avo::judge
