// SPDX-License-Identifier: Apache-2.0
#include "space/half_space.h"

namespace avo::space {

void HalfSpaceColumns::reserve(std::size_t half_spaces) {
  const std::size_t size = half_spaces + kSpare;
  if (violation.size() >= size) return;  // this column grows last
  for (Column& column : normal) column.resize(size);
  for (Column* column : {&offset, &number, &violation}) column->resize(size);
}

void HalfSpaceColumns::add(const HalfSpace& half_space, double its_number) {
  const auto& [x, y, z] = half_space.normal;
  normal[0][count] = x, normal[1][count] = y, normal[2][count] = z;
  offset[count] = half_space.offset, number[count] = its_number;
  ++count;
}

}  // namespace avo::space
