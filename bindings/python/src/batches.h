// SPDX-License-Identifier: Apache-2.0
// The inputs of decisions of many robots at once.
#pragma once
#include <cstddef>
#include <vector>

#include "avo/planner.h"
#include "bind.h"
#include "shared.h"

namespace avo_python {

struct Robots {
  std::vector<avo::Robot> all;
};

/// The neighbors of robot k are all[first[k]] to all[first[k + 1] - 1].
struct Neighbors {
  std::vector<avo::Neighbor> all;
  std::vector<std::size_t> first{0};
};

/// The number of detours always equals the number of robots. Threads may share them.
struct Detours : Shared<std::vector<avo::Detour>> {
  explicit Detours(std::size_t n) : Shared(std::vector<avo::Detour>(n)), size(n) {}
  const std::size_t size;
};

/// Reads offsets of CSR form. Throws Error unless they ascend from 0 to m.
std::vector<std::size_t> checked_offsets(const py::object& object, std::size_t m);

/// Throws Error unless it is a whole number in the range of ages.
int checked_age(double age);

void bind_batch_inputs(py::module_& module);

}  // namespace avo_python
