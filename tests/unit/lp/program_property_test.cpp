// SPDX-License-Identifier: Apache-2.0
// P10, P11 of the linear program against brute force, and its exact symmetries.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include "unit/lp/judge.h"
#include "unit/lp/programs.h"

namespace avo::test {
namespace {

constexpr int kPrograms = 40000;  // of each family

class Programs : public testing::TestWithParam<Family> {};
INSTANTIATE_TEST_SUITE_P(Families, Programs, testing::ValuesIn(kFamilies), [](const auto& family) {
  std::string name = family.param.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
});

TEST_P(Programs, P10_P11_agree_with_all_vertices) {
  Random random(2011);
  int states[4] = {};
  for (int k = 0; k < kPrograms; ++k) {
    const Program p = GetParam().make(random);
    const ProgramResult r = run(p);
    ++states[static_cast<int>(r.state)];
    judge(p, r);
    if (HasFailure()) FAIL() << "program " << k << '\n' << text(p, r);
  }
  EXPECT_GT(states[0], kPrograms / 10);
  EXPECT_GT(states[1], kPrograms / 50);
  EXPECT_GT(states[2], kPrograms / 2000);
}

// The test checks P10 word for word, with dense samples around the result, ever closer to the
// result.
TEST_P(Programs, P10_no_sampled_point_is_nearer) {
  Random random(7);
  for (int k = 0; k < kPrograms / 10; ++k) {
    const Program p = GetParam().make(random);
    const ProgramResult r = run(p);
    if (r.state != ProgramState::optimal) continue;
    std::vector<HalfPlane> all = p.hard;
    all.insert(all.end(), p.soft.begin(), p.soft.end());
    const ConvexSet set = set_of(p, 0, all, {}, 0);
    const Real size = extent(p);
    const Real bound = distance(wide(r.point), p.preferred) - 1e-9L * size;
    for (int sample = 0; sample < 500 && bound > 0; ++sample) {
      const double step = static_cast<double>(size) * std::pow(2.0, -0.05 * sample);
      const Point u = wide(r.point + step * random.unit());
      ASSERT_FALSE(distance(u, p.preferred) < bound && set.contains(u, 0)) << text(p, r);
    }
  }
}

// The test checks P11 word for word, with the same kind of samples.
TEST_P(Programs, P11_no_sampled_point_is_less_unsafe) {
  Random random(8);
  for (int k = 0; k < kPrograms / 4; ++k) {
    const Program p = GetParam().make(random);
    const ProgramResult r = run(p);
    if (r.state != ProgramState::least_unsafe) continue;
    const ConvexSet set = set_of(p, 0, p.hard, {}, 0);
    const Real size = extent(p);
    for (int sample = 0; sample < 500; ++sample) {
      const double step = static_cast<double>(size) * std::pow(2.0, -0.05 * sample);
      const Point u = wide(r.point + step * random.unit());
      ASSERT_FALSE(worst(p.soft, u) < r.violation - 1e-9L * size && set.contains(u, 0))
          << text(p, r);
    }
  }
}

Program mapped(const Program& p, Vec2 (*turn)(Vec2), double factor) {
  Program q = p;
  for (Disc* disc : {&q.acceleration, &q.speed}) {
    *disc = {factor * turn(disc->center), factor * disc->radius};
  }
  for (std::vector<HalfPlane>* planes : {&q.hard, &q.soft}) {
    for (HalfPlane& plane : *planes) plane = {turn(plane.normal), factor * plane.offset};
  }
  q.preferred = factor * turn(p.preferred);
  return q;
}

Vec2 same(Vec2 u) {
  return u;
}
Vec2 turned(Vec2 u) {
  return perpendicular(u);
}

TEST_P(Programs, P6_a_quarter_turn_turns_the_result_bit_for_bit) {
  Random random(3);
  for (int k = 0; k < kPrograms / 4; ++k) {
    const Program p = GetParam().make(random);
    const ProgramResult r = run(p);
    const ProgramResult q = run(mapped(p, turned, 1.0));
    ASSERT_EQ(q.point, turned(r.point)) << text(p, r);
    ASSERT_EQ(q.violation, r.violation);
    ASSERT_EQ(q.state, r.state);
  }
}

TEST_P(Programs, P6_scaling_by_a_power_of_two_scales_the_result_bit_for_bit) {
  Random random(4);
  for (int k = 0; k < kPrograms / 4; ++k) {
    const Program p = GetParam().make(random);
    const double factor = std::ldexp(1.0, random.below(81) - 40);
    const ProgramResult r = run(p);
    const ProgramResult q = run(mapped(p, same, factor));
    ASSERT_EQ(q.point, factor * r.point) << text(p, r);
    ASSERT_EQ(q.violation, factor * r.violation);
    ASSERT_EQ(q.state, r.state);
  }
}

void shuffle(std::vector<HalfPlane>& planes, Random& random) {
  for (int n = static_cast<int>(planes.size()); n > 1; --n) {
    std::swap(planes[static_cast<std::size_t>(n - 1)],
              planes[static_cast<std::size_t>(random.below(n))]);
  }
}

// The test takes all families but the nearly degenerate family, where rounding may move the result
// far.
TEST(Programs, P10_order_changes_rounding_only) {
  for (const Family& family : kFamilies) {
    if (family.make == nearly_degenerate_program) continue;
    // a hard half-plane that touches a disc amplifies rounding to its square root
    const double rounding = family.make == degenerate_program ? 1e-7 : 1e-12;
    Random random(5);
    for (int k = 0; k < kPrograms / 4; ++k) {
      Program p = family.make(random);
      const ProgramResult r = run(p);
      shuffle(p.soft, random);
      shuffle(p.hard, random);
      const ProgramResult q = run(p);
      const double size = static_cast<double>(extent(p));
      ASSERT_NEAR(q.violation / size, r.violation / size, rounding) << text(p, r);
      ASSERT_EQ(q.state, r.state) << text(p, r);
      ASSERT_NEAR(norm(q.point - p.preferred) / size, norm(r.point - p.preferred) / size, 1e-9)
          << text(p, r);
    }
  }
}

// Two opposite half-planes leave no point, but a whole segment of equally unsafe ones.
TEST(Programs, P11_equally_unsafe_points_are_settled_by_the_preferred_one) {
  Random random(6);
  int settled = 0;
  for (int k = 0; k < kPrograms / 4; ++k) {
    Program p = planner_program(random);
    const Vec2 n = random.unit();
    const double middle = dot(n, p.speed.center) + random.uniform(-1.0, 1.0);
    const double half_gap = random.uniform(0.01, 1.0);
    p.soft.insert(p.soft.begin() + random.below(static_cast<int>(p.soft.size()) + 1),
                  {n, middle + half_gap});
    p.soft.insert(p.soft.begin() + random.below(static_cast<int>(p.soft.size()) + 1),
                  {-n, half_gap - middle});
    const ProgramResult r = run(p);
    // the strip is what decides where nothing forces a violation beyond half of its gap
    if (std::abs(r.violation - half_gap) > 1e-14) continue;
    const ConvexSet equals = set_of(p, 0, p.hard, p.soft, r.violation + 1e-12L);
    const auto best = equals.nearest(wide(p.preferred), 1e-15L);
    ASSERT_TRUE(best.has_value());
    ASSERT_LE(distance(wide(r.point), p.preferred), distance(*best, p.preferred) + 1e-6L)
        << text(p, r);
    ++settled;
  }
  EXPECT_GT(settled, kPrograms / 20);
}

// Any finite number is an input, and the answer is a point.
TEST(Programs, never_yields_nan) {
  Random random(9);
  const auto usual = [&] { return any_number(random); };
  for (int k = 0; k < kPrograms; ++k) {
    Program p;
    p.acceleration = {{usual(), usual()}, std::abs(usual())};
    p.speed = {{usual(), usual()}, std::abs(usual())};
    p.preferred = {usual(), usual()};
    for (int n = random.below(8); n > 0; --n) {
      (random.chance(0.3) ? p.hard : p.soft).push_back({random.unit(), usual()});
    }
    const ProgramResult r = run(p);
    ASSERT_TRUE(is_finite(r.point) && !std::isnan(r.violation)) << text(p, r);
    ASSERT_EQ(r.violation > 0.0, r.state != ProgramState::optimal) << text(p, r);
  }
}

}  // namespace
}  // namespace avo::test
