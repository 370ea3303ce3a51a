// SPDX-License-Identifier: Apache-2.0
// The certificate's kernels in space, for the best instruction set: the text of the plane with D
// = 3.
#pragma once
#include "certificate/admission_kernel.h"

namespace avo::space {

using Braking = BrakingOf<3>;
using BrakingPair = BrakingPairOf<3>;
using CandidatePath = CandidatePathOf<3>;
using ConstraintColumns = ConstraintColumnsOf<3>;
using OwnColumns = OwnColumnsOf<3>;
using PairConstraints = PairConstraintsOf<3>;

struct SpaceKernels {
  void (*fill_own)(const Braking&, const Deviation&, const StepLaw&, OwnColumns&);
  double (*append_in_space)(const PairConstraints&, const StepLaw&, const OwnColumns&,
                            ConstraintColumns&);
  void (*hold)(const PairConstraints&, std::size_t, ConstraintColumns&);
  bool (*keeps)(const Braking&, const CandidatePath&, const StepLaw&, bool, Asked,
                ConstraintColumns&);
};

/// own.count must be set, and the columns must have room for it.
void fill_own(const Braking& a, const Deviation& deviation, const StepLaw& law, OwnColumns& own);
/// See constraints_kernel.h; the columns must have room for all intervals.
double append_constraints(const PairConstraints& wanted, const StepLaw& law, const OwnColumns& own,
                          ConstraintColumns& constraints);
void hold(const PairConstraints& wanted, std::size_t first, ConstraintColumns& constraints);
/// See admission_kernel.h.
bool keeps(const Braking& own, const CandidatePath& path, const StepLaw& law, bool has_cones,
           Asked asked_for, ConstraintColumns& constraints);

}  // namespace avo::space
