// SPDX-License-Identifier: Apache-2.0
// The scalar instance of the certificate's kernels: the reference that all others equal bit for
// bit.
#pragma once
#include "certificate/admission_kernel.h"
#include "certificate/near_kernel.h"
#include "certificate/plan_kernel.h"

namespace avo::inline certificate {

struct CertificateKernels {
  void (*find_near)(const RobotColumns&, const StepLaw&, NearPairs&);
  void (*admit_next)(const RobotColumns&, const std::vector<double>&, const std::vector<double>&,
                     const StepLaw&, NearPairs&);
  void (*fill_own)(const Braking&, const Deviation&, const StepLaw&, OwnColumns&);
  double (*append_constraints)(const PairConstraints&, const StepLaw&, const OwnColumns&,
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

/// See constraints_kernel.h.
void hold(const PairConstraints& wanted, std::size_t first, ConstraintColumns& constraints);

/// See admission_kernel.h.
bool keeps(const Braking& own, const CandidatePath& path, const StepLaw& law, bool has_cones,
           Asked asked_for, ConstraintColumns& constraints);

}  // namespace avo::inline certificate
