// SPDX-License-Identifier: Apache-2.0
// The certificate's kernels for every instruction set: this file is compiled once for each by
// hwy/foreach_target.h, and the fittest is chosen at run time.
#include "certificate/kernels.h"

#include "core/kernel_table.h"

#ifdef AVO_HIGHWAY
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "certificate/kernels.cpp"
#include <hwy/foreach_target.h>
#if HWY_TARGET & AVO_TARGETS
// clang-format off
#include "core/lanes.h"  // begins the pass
// clang-format on
#include "certificate/admission_kernel.h"
#include "certificate/near_kernel.h"

AVO_BEGIN_KERNELS
constexpr CertificateKernels kKernels{find_near<Pack<double>>, admit_next<Pack<double>>,
                                      fill_own<Pack<double>>, append_constraints<Pack<double>>,
                                      keeps<Pack<double>>};
AVO_END_KERNELS
#endif
#endif

#if !defined(AVO_HIGHWAY) || HWY_ONCE
namespace avo {
namespace scalar {
constexpr CertificateKernels kKernels{find_near<Pack<double>>, admit_next<Pack<double>>,
                                      fill_own<Pack<double>>, append_constraints<Pack<double>>,
                                      keeps<Pack<double>>};
}  // namespace scalar

static constexpr KernelTable<CertificateKernels> kKernels = AVO_KERNEL_TABLE(kKernels);

void find_near(const RobotColumns& robots, Whom whom, const StepLaw& law, NearPairs& near) {
  kKernels->find_near(robots, whom, law, near);
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

bool keeps(const Braking& own, const CandidatePath& path, const StepLaw& law, bool has_cones,
           ConstraintColumns& constraints) {
  return kKernels->keeps(own, path, law, has_cones, constraints);
}

}  // namespace avo
#endif
