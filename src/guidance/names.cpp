// SPDX-License-Identifier: Apache-2.0
#include "guidance/names.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "avo/model.h"

namespace avo::inline guidance {
namespace {

constexpr std::size_t kNamed = 4;  // causes that are named

}  // namespace

Words number(double value, int digits) {
  double scale = 1.0;
  for (int k = 0; k < digits; ++k) scale *= 10.0;
  const double rounded = std::round(std::abs(value) * scale);
  if (!(rounded < 1e18)) return "far more";
  Words words = std::to_string(static_cast<std::int64_t>(rounded));
  const auto after = static_cast<std::size_t>(digits);
  if (words.size() <= after) words.insert(0, after + 1 - words.size(), '0');
  if (digits > 0) {
    words.insert(words.size() - after, 1, '.');
    words.erase(words.find_last_not_of('0') + 1);
    if (words.back() == '.') words.pop_back();
  }
  return rounded > 0.0 && value < 0.0 ? Words("-") + words : words;
}

Words place(Vec2 p) {
  return Words("(") + number(p.x, 2) + ", " + number(p.y, 2) + ")";
}

Words name_of(std::int64_t source) {
  return source >= 0 ? Words("robot ") + std::to_string(source)
                     : Words("moving obstacle ") + std::to_string(-1 - source);
}

Words name_of(const Wall& wall) {
  if (wall.a == wall.b) return Words("the disc at ") + place(wall.a);
  return Words("the wall from ") + place(wall.a) + " to " + place(wall.b);
}

Words name_of(const Explanation& e, Cause cause) {
  if (cause.neighbor >= 0) return name_of(e.seen.source[static_cast<std::size_t>(cause.neighbor)]);
  const auto wall = static_cast<std::size_t>(cause.wall);
  if (cause.wall >= 0) {
    const bool is_robot = wall < e.seen.wall_source.size() && e.seen.wall_source[wall] < 0;
    return is_robot ? name_of(-1 - e.seen.wall_source[wall]) : name_of(e.seen.walls[wall]);
  }
  return can_rest(e.seen.robot.model) ? "its own wheels" : "its own wings";
}

Words list_of(const std::vector<Words>& all) {
  std::vector<Words> names;
  for (const Words& name : all)
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  const Words robot = "robot ";
  const bool are_robots =
      names.size() > 1 && std::all_of(names.begin(), names.end(),
                                      [&](const Words& name) { return name.starts_with(robot); });
  for (std::size_t k = 0; k < names.size() && are_robots; ++k)
    names[k] = k == 0 ? "robots " + names[k].substr(robot.size()) : names[k].substr(robot.size());
  if (names.size() > kNamed + 1) {
    const std::size_t rest = names.size() - kNamed;
    names.resize(kNamed);
    names.push_back(std::to_string(rest) + " others");
  }
  Words list;
  for (std::size_t k = 0; k < names.size(); ++k)
    list += (k == 0 ? "" : k + 1 == names.size() ? " and " : ", ") + names[k];
  return list;
}

Words list_of(const Explanation& e, const std::vector<Cause>& causes) {
  std::vector<Words> names;
  for (const Cause cause : causes) names.push_back(name_of(e, cause));
  return list_of(names);
}

}  // namespace avo::inline guidance
