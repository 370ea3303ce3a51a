// SPDX-License-Identifier: Apache-2.0
// The programs of many robots at once against nearest_point(), bit for bit, for every instruction
// set.
#include "lp/programs.h"

#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "core/simd_target.h"
#include "unit/lp/programs.h"

namespace avo::test {
namespace {

constexpr int kPrograms = 60000;  // of each family

// As a planner hands them over: no hard half-planes, the speed disc around 0.
Program centered(Program p) {
  const Vec2 origin = p.speed.center;
  for (const HalfPlane& plane : p.hard) p.soft.push_back(plane);
  p.hard.clear();
  for (HalfPlane& plane : p.soft) plane.offset -= dot(plane.normal, origin);
  p.acceleration.center = p.acceleration.center - origin;
  p.speed.center = {};
  p.preferred = p.preferred - origin;
  return p;
}

std::vector<Program> programs(Generator make, int count) {
  Random random(2011);
  std::vector<Program> all;
  for (int k = 0; k < count; ++k) all.push_back(centered(make(random)));
  return all;
}

template <typename Number>
void solve(const std::vector<Program>& all, ProgramBatch<Number>& batch) {
  batch.clear();
  for (const Program& p : all) {
    batch.add(p.acceleration, p.speed.radius, p.preferred);
    for (const HalfPlane& plane : p.soft) batch.add(plane);
  }
  batch.solve();
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

// Which cases the settled programs were, each of which has to occur.
struct Cases {
  int untouched = 0, one_plane = 0, two_planes = 0, arc = 0, corner = 0, plane_and_arc = 0;
  int least_unsafe = 0, unsettled = 0;

  void count(const Program& p, const ProgramResult& r) {
    if (r.state == ProgramState::least_unsafe) return void(++least_unsafe);
    if (r.point == p.preferred) return void(++untouched);
    const Real size = 1e-12L * (norm(p.acceleration.center) + p.acceleration.radius);
    const Point u{r.point.x, r.point.y};
    int planes = 0, arcs = 0;
    for (const HalfPlane& plane : p.soft) planes += std::abs(excess(plane, u)) < size;
    for (const Disc& disc : {p.acceleration, p.speed}) arcs += std::abs(excess(disc, u)) < size;
    if (planes == 0) ++(arcs == 1 ? arc : corner);
    if (planes == 1) ++(arcs == 0 ? one_plane : plane_and_arc);
    if (planes == 2) ++two_planes;
  }
};

class Batch : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override { ASSERT_TRUE(use_simd_target(GetParam())); }
  void TearDown() override { use_simd_target(simd_targets().front()); }
};
INSTANTIATE_TEST_SUITE_P(Targets, Batch, testing::ValuesIn(simd_targets()),
                         [](const auto& target) { return std::string(target.param); });

TEST_P(Batch, double_precision_equals_the_program_of_one_robot_bit_for_bit) {
  Cases cases;
  ProgramBatch<double> batch;
  int optimal = 0;
  for (const Family& family : kFamilies) {
    const std::vector<Program> all = programs(family.make, kPrograms);
    solve(all, batch);
    for (std::size_t k = 0; k < all.size(); ++k) {
      const ProgramResult r = run(all[k]);
      optimal += r.state == ProgramState::optimal;
      if (!batch.settled(k)) {
        ++cases.unsettled;
        continue;
      }
      cases.count(all[k], r);
      const Vec2 point = batch.point(k);
      ASSERT_TRUE(same_bits(point.x, r.point.x) && same_bits(point.y, r.point.y) &&
                  same_bits(batch.violation(k), r.violation))
          << family << " " << k << " " << point.x << " " << point.y << " v " << batch.violation(k) << "\n" << r.point.x << " " << r.point.y << " " << r.violation << " state " << (int)r.state;
    }
  }
  EXPECT_GT(cases.untouched, 5000);
  EXPECT_GT(cases.one_plane, 5000);
  EXPECT_GT(cases.two_planes, 5000);
  EXPECT_GT(cases.arc, 5000);
  EXPECT_GT(cases.corner, 5000);
  EXPECT_GT(cases.plane_and_arc, 5000);
  std::printf("%d %d %d %d %d %d lu %d un %d opt %d\n", cases.untouched, cases.one_plane,
              cases.two_planes, cases.arc, cases.corner, cases.plane_and_arc, cases.least_unsafe,
              cases.unsettled, optimal);
}

}  // namespace
}  // namespace avo::test
