// SPDX-License-Identifier: Apache-2.0
// The kernels of space, for the best instruction set. Those of the certificate are the text of the
// plane with D = 3.
#pragma once
#include <cstddef>
#include <span>

#include "certificate/admission_kernel.h"
#include "certificate/clearance_kernel.h"
#include "certificate/deviation_kernel.h"

namespace avo::space {

using Braking = BrakingOf<3>;
using BrakingPair = BrakingPairOf<3>;
using CandidatePath = CandidatePathOf<3>;
using ConstraintColumns = ConstraintColumnsOf<3>;
using OwnColumns = OwnColumnsOf<3>;
using PairConstraints = PairConstraintsOf<3>;

struct Bodies;
struct HalfSpaceColumns;
struct HalfSpaces;
struct Viewer;
struct Looked;
struct OwnLimits;
struct Run;
struct SeenColumns;
struct SpacePairs;

struct SpaceKernels {
  // deviation_kernel.h: own.count must be set, and the columns must have room for all intervals
  void (*fill_own)(const Braking&, const Deviation&, const StepLaw&, OwnColumns&);
  double (*append_constraints)(const PairConstraints&, const StepLaw&, const OwnColumns&,
                               ConstraintColumns&);
  void (*hold)(const PairConstraints&, std::size_t, ConstraintColumns&);
  // admission_kernel.h
  bool (*keeps)(const Braking&, const CandidatePath&, const StepLaw&, bool, Asked,
                ConstraintColumns&);
  // seen_kernel.h
  void (*fill_braking)(const StepLaw&, std::size_t first, std::size_t last, Bodies&);
  void (*find_seen)(const Viewer&, const Bodies&, std::span<const Run>, SeenColumns&);
  // look_kernel.h
  void (*examine_seen)(const Viewer&, const Bodies&, Looked&);
  void (*find_pairs)(const Viewer&, const Vec3* velocity, const Bodies&, Looked&);
  // half_space_kernel.h
  void (*find_frames)(const SpacePairs&, HalfSpaces&);
  void (*turn_back)(const SpacePairs&, const OwnLimits&, HalfSpaces&);
  double (*find_violations)(Vec3, HalfSpaceColumns&);
};
const SpaceKernels& kernels();

}  // namespace avo::space
