// SPDX-License-Identifier: Apache-2.0
// Chooses under the certificate in space: programs propose, the certificate's own test decides, as
// in the plane (docs/certificate.md, "Choosing").
#pragma once
#include <vector>

#include "planner/stages/certified.h"
#include "planner/trace.h"
#include "space/certificate.h"
#include "space/program.h"

namespace avo::space {

/// Scratch memory; allocates only while it grows.
struct ChoiceWorkspace {
  Constraints constraints;      ///< by begin_constraints()
  std::vector<HalfSpace> cuts;  ///< in v_1, in the robot's own space
  SpaceProgramWorkspace program;
};

struct Choice {
  Vec3 next_velocity;  ///< m/s
  Chosen chosen = Chosen::backup;
  bool is_rounded = false;  ///< the candidate differs from the wanted velocity by rounding alone

  /// Whether the robot gets what it wants.
  [[nodiscard]] bool is_as_wanted() const { return chosen == Chosen::wanted || is_rounded; }
};

/// The half-spaces of climb and sink, in the robot's own space.
void append_climb(const Robot& robot, std::vector<HalfSpace>& half_spaces);

/// Returns the admitted velocity near the wanted one, m/s. trace.is_refused() tells why the wanted
/// velocity was not admitted. What rounding alone has put beyond the robot's own limits does not
/// count.
template <typename Trace = NoTrace>
Choice choose(const Robot& robot, Vec3 wanted, const StepLaw& law, ChoiceWorkspace& workspace,
              Trace trace = {});

}  // namespace avo::space
