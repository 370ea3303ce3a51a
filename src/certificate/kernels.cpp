// SPDX-License-Identifier: Apache-2.0
// The certificate's kernels for every instruction set; the best one is chosen at run time.
#include "certificate/kernels.h"

#define AVO_KERNEL_HEADER "certificate/admission_kernel.h"
#define AVO_KERNEL_HEADER_2 "certificate/near_kernel.h"
#define AVO_KERNEL_STRUCT CertificateKernels
#define AVO_KERNEL_FUNCTIONS                                                 \
  find_near<Pack<double>>, admit_next<Pack<double>>, fill_own<Pack<double>>, \
      append_constraints<Pack<double>>, hold<Pack<double>>, keeps<Pack<double>>
#include "core/kernel_passes.h"

namespace avo::inline certificate {
void find_near(const RobotColumns& robots, const StepLaw& law, NearPairs& near) {
  kKernels->find_near(robots, law, near);
}

void admit_next(const RobotColumns& robots, const std::vector<double>& next_x,
                const std::vector<double>& next_y, const StepLaw& law, NearPairs& near) {
  kKernels->admit_next(robots, next_x, next_y, law, near);
}

void fill_own(const Braking& a, const Deviation& deviation, const StepLaw& law, OwnColumns& own) {
  kKernels->fill_own(a, deviation, law, own);
}

double append_constraints(const PairConstraints& wanted, const StepLaw& law, const OwnColumns& own,
                          ConstraintColumns& constraints) {
  return kKernels->append_constraints(wanted, law, own, constraints);
}

void hold(const PairConstraints& wanted, std::size_t first, ConstraintColumns& constraints) {
  kKernels->hold(wanted, first, constraints);
}

bool keeps(const Braking& own, const CandidatePath& path, const StepLaw& law, bool has_cones,
           Asked asked_for, ConstraintColumns& constraints) {
  return kKernels->keeps(own, path, law, has_cones, asked_for, constraints);
}

}  // namespace avo::inline certificate
