// SPDX-License-Identifier: Apache-2.0
#include "space/kernels.h"

#define AVO_KERNEL_HEADER "certificate/admission_kernel.h"
#define AVO_KERNEL_STRUCT space::SpaceKernels
#define AVO_KERNEL_FUNCTIONS \
  fill_own<Pack<double>>, append_in_space<Pack<double>>, hold<Pack<double>>, keeps<Pack<double>>
#include "core/kernel_passes.h"

namespace avo::space {

void fill_own(const Braking& a, const Deviation& deviation, const StepLaw& law, OwnColumns& own) {
  kKernels->fill_own(a, deviation, law, own);
}

double append_constraints(const PairConstraints& wanted, const StepLaw& law, const OwnColumns& own,
                          ConstraintColumns& constraints) {
  return kKernels->append_in_space(wanted, law, own, constraints);
}

void hold(const PairConstraints& wanted, std::size_t first, ConstraintColumns& constraints) {
  kKernels->hold(wanted, first, constraints);
}

bool keeps(const Braking& own, const CandidatePath& path, const StepLaw& law, bool has_cones,
           Asked asked_for, ConstraintColumns& constraints) {
  return kKernels->keeps(own, path, law, has_cones, asked_for, constraints);
}

}  // namespace avo::space
