// SPDX-License-Identifier: Apache-2.0
// sin, cos, atan2 and expm1 against 80 decimal digits, in units in the last place of the result;
// and what holds exactly: symmetries, zeros, axes.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include "core/elementary.h"
#include "rows.h"

namespace avo {
namespace {

struct Case {
  std::vector<double> arguments;
  double high = 0.0, low = 0.0;  // of the exact result
};

double number(const json& text) {
  return std::strtod(text.get<std::string>().c_str(), nullptr);
}

std::vector<Case> cases_of(const std::string& function) {
  std::vector<Case> result;
  const json rows = cases("elementary.json");
  for (const json& row : rows) {
    if (row.at(0) != function) continue;
    Case& added = result.emplace_back();
    for (const json& argument : row.at(1)) added.arguments.push_back(number(argument));
    added.high = number(row.at(2).at(0)), added.low = number(row.at(2).at(1));
  }
  return result;
}

double units_off(double value, const Case& expected) {
  const double size = std::abs(expected.high);
  const double unit =
      std::max(size - std::nextafter(size, 0.0), std::numeric_limits<double>::denorm_min());
  return std::abs((value - expected.high) - expected.low) / unit;
}

template <typename Function>
void expect_within(double most_units, const std::string& name, std::size_t fewest,
                   const Function& function) {
  const std::vector<Case> all = cases_of(name);
  EXPECT_GE(all.size(), fewest);
  for (const Case& c : all) {
    EXPECT_LT(units_off(function(c), c), most_units)
        << std::hexfloat << name << " of " << c.arguments.front() << ", " << c.arguments.back();
  }
}

TEST(Elementary, sine_and_cosine_are_nearly_correctly_rounded) {
  const auto x = [](const Case& c) { return c.arguments[0]; };
  expect_within(0.501, "sin", 300, [&](const Case& c) { return elementary::sin(x(c)); });
  expect_within(0.501, "sin", 300, [&](const Case& c) { return elementary::direction(x(c)).y; });
  expect_within(0.501, "cos", 300, [&](const Case& c) { return elementary::direction(x(c)).x; });
}

TEST(Elementary, sine_is_odd_and_cosine_even_bit_for_bit) {
  for (const Case& c : cases_of("sin")) {
    const double x = c.arguments[0];
    EXPECT_EQ(elementary::sin(-x), -elementary::sin(x));
    EXPECT_EQ(elementary::direction(-x).x, elementary::direction(x).x);
  }
  EXPECT_FALSE(std::signbit(elementary::sin(0.0)));
  EXPECT_TRUE(std::signbit(elementary::sin(-0.0)));
  EXPECT_EQ(elementary::direction(0.0), (Vec2{1.0, 0.0}));
}

TEST(Elementary, angles_are_nearly_correctly_rounded) {
  expect_within(0.501, "atan2", 250,
                [](const Case& c) { return elementary::atan2(c.arguments[0], c.arguments[1]); });
}

TEST(Elementary, angles_mirror_bit_for_bit_and_do_not_depend_on_size) {
  for (const Case& c : cases_of("atan2")) {
    const double y = c.arguments[0], x = c.arguments[1];
    EXPECT_EQ(elementary::atan2(-y, x), -elementary::atan2(y, x));
    const double size = std::max(std::abs(x), std::abs(y));
    const double least = std::min(std::abs(x), std::abs(y));
    if (size > 1e290 || least < 1e-290) continue;
    EXPECT_EQ(elementary::atan2(0x1p40 * y, 0x1p40 * x), elementary::atan2(y, x));
  }
}

TEST(Elementary, angles_of_axes_and_zeros_are_those_of_the_C_library) {
  for (const double y : {0.0, -0.0, 1.0, -1.0, 5e-324, -1e300}) {
    for (const double x : {0.0, -0.0, 1.0, -1.0, 5e-324, -1e300}) {
      const double ours = elementary::atan2(y, x), its = std::atan2(y, x);
      EXPECT_EQ(ours, its) << y << ", " << x;
      EXPECT_EQ(std::signbit(ours), std::signbit(its)) << y << ", " << x;
    }
  }
}

TEST(Elementary, expm1_is_within_its_bound) {
  expect_within(0.9, "expm1", 300, [](const Case& c) { return elementary::expm1(c.arguments[0]); });
  EXPECT_EQ(elementary::expm1(0.0), 0.0);
  EXPECT_TRUE(std::signbit(elementary::expm1(-0.0)));
}

}  // namespace
}  // namespace avo
