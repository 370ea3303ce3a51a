// SPDX-License-Identifier: Apache-2.0
// The output of avo check.
#include "avo_io/judgement.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "avo/version.h"
#include "avo_io/printable.h"
#include "io/text/json.h"

namespace avo_io {
namespace {

std::int64_t number_of(const Judgement& judgement, std::int64_t index) {
  return judgement.numbers.empty() ? index : judgement.numbers[static_cast<std::size_t>(index)];
}

enum class Among { robots, one_sided, moving_obstacles, walls };

/// Returns the violation by the numbers of the recording and the scene, the lower of two robots
/// first.
avo::CheckViolation by_number(const Judgement& judgement, avo::CheckViolation violation,
                              Among others) {
  violation.robot = number_of(judgement, violation.robot);
  if (!violation.other || others == Among::moving_obstacles) return violation;
  if (others == Among::walls) {
    violation.other = judgement.obstacle_of_wall[static_cast<std::size_t>(*violation.other)];
    return violation;
  }
  violation.other = number_of(judgement, *violation.other);
  if (others == Among::robots && *violation.other < violation.robot)
    std::swap(violation.robot, *violation.other);
  return violation;
}

Json to_json(const Judgement& judgement, const avo::CheckCount& rule, const char* other,
             Among others = Among::robots) {
  Json first;
  if (rule.first) {
    const avo::CheckViolation violation = by_number(judgement, *rule.first, others);
    first["time"] = violation.time;
    first["robot"] = violation.robot;
    if (other != nullptr) first[other] = or_null(violation.other);
    first["amount"] = violation.amount;
  }
  return {{"count", rule.count}, {"worst", rule.worst}, {"first", first}};
}

/// Returns the entry of an unknown limit.
Json unknown() {
  return {{"count", nullptr}, {"worst", nullptr}, {"first", nullptr}};
}

/// Returns e.g. "3 pairs, the first at 1.5 s: robots 0 and 1, by 0.01 m; at most by 0.2 m".
std::string text_of(const Judgement& judgement, const avo::CheckCount& rule, const char* things,
                    const char* unit, Among others = Among::robots) {
  std::string text = fmt::format("{} {}", rule.count, things);
  if (!rule.first) return text;
  const avo::CheckViolation first = by_number(judgement, *rule.first, others);
  text += fmt::format(", the first at {:.6g} s: ", first.time);
  if (!first.other)
    text += fmt::format("robot {}", first.robot);
  else if (others == Among::moving_obstacles)
    text += fmt::format("robot {} and moving obstacle {}", first.robot, *first.other);
  else if (others == Among::walls)
    text += fmt::format("robot {} and obstacle {}", first.robot, *first.other);
  else
    text += fmt::format("robots {} and {}", first.robot, *first.other);
  text += fmt::format(", by {:.3g} {}", first.amount, unit);
  if (rule.worst > first.amount) text += fmt::format("; at most by {:.3g} {}", rule.worst, unit);
  return text;
}

/// Returns the hits of moving obstacles, or of robots that avoid no other robot.
Json hits_of(const Judgement& judgement, const std::vector<avo::CheckedHit>& hits,
             const char* other, bool of_robots) {
  Json list = Json::array();
  for (const avo::CheckedHit& hit : hits)
    list.push_back({{"time", hit.time},
                    {"robot", number_of(judgement, hit.robot)},
                    {other, of_robots ? number_of(judgement, hit.other) : hit.other},
                    {"depth", hit.depth},
                    {"moved", hit.moved}});
  return list;
}

/// Appends a line for each of the first hits.
template <typename Line>
void add_hits(const Judgement& judgement, const std::vector<avo::CheckedHit>& hits, bool of_robots,
              const Line& line) {
  constexpr std::size_t kMostNamed = 10;
  for (std::size_t k = 0; k < hits.size(); ++k) {
    if (k == kMostNamed)
      return line("  ...", fmt::format("{} more, see --json", hits.size() - kMostNamed));
    const avo::CheckedHit& hit = hits[k];
    line(hit.moved ? "  in motion" : "  at rest",
         fmt::format("robot {} at {:.6g} s, by {} {}, {:.3g} m deep",
                     number_of(judgement, hit.robot), hit.time,
                     of_robots ? "robot" : "moving obstacle",
                     of_robots ? number_of(judgement, hit.other) : hit.other, hit.depth));
  }
}

/// Returns e.g. "robots 0, 3, ...".
std::string named(const std::vector<std::int64_t>& robots) {
  constexpr std::size_t kMostNamed = 10;
  const auto most = static_cast<std::ptrdiff_t>(std::min(robots.size(), kMostNamed));
  return fmt::format("robot{} {}{}", robots.size() == 1 ? "" : "s",
                     fmt::join(robots.begin(), robots.begin() + most, ", "),
                     robots.size() > kMostNamed ? ", ..." : "");
}

std::string arrivals(const avo::CheckReport& report) {
  std::string text = fmt::format("{} of {}", report.arrived, report.with_goal);
  if (report.last_arrival) text += fmt::format(", the last after {:.1f} s", *report.last_arrival);
  text += fmt::format("; {} at the end", report.at_goal_at_end);
  const auto& missing = report.not_arrived;
  return missing.empty() ? text : text + "; not " + named(missing);
}

struct KinematicRule {
  const char* key;
  const char* name;
  avo::CheckCount avo::CheckReport::*count;
  const char* things;
  const char* unit;
};

using avo::CheckReport;
constexpr KinematicRule kKinematics[] = {
    {"headings", "headings", &CheckReport::headings, "rows off their velocities", "m/s"},
    {"turns", "turns", &CheckReport::turns, "robot-steps too sharp", "rad"},
    {"lateral_accelerations", "across", &CheckReport::lateral_accelerations,
     "robot-steps beyond the limit", "m/s^2"},
    {"reversals", "reversals", &CheckReport::reversals, "robot-steps backwards", "m/s"},
    {"slow_flights", "slow flights", &CheckReport::slow_flights, "rows below the limit", "m/s"},
    {"wheel_speeds", "wheel speed", &CheckReport::wheel_speeds, "robot-steps beyond the limit",
     "m/s"},
    {"wheel_accelerations", "wheel acceleration", &CheckReport::wheel_accelerations,
     "robot-steps beyond the limit", "m/s^2"}};

/// Appends lines for the rules that only robots with headings can break, if there are such robots.
template <typename Line>
void add_kinematics(const Judgement& judgement, const Line& line) {
  const CheckReport& report = judgement.report;
  bool kept = true;
  for (const KinematicRule& rule : kKinematics) {
    const avo::CheckCount& count = report.*rule.count;
    kept = kept && count.count == 0;
    if (count.count > 0) line(rule.name, text_of(judgement, count, rule.things, rule.unit));
  }
  if (report.with_heading > 0)
    line("with headings", fmt::format("{} robot-steps{}", report.with_heading,
                                      kept ? ", no limit of wheels or wings broken" : ""));
  if (report.without_heading > 0)
    line("without headings", fmt::format("{} robot-steps", report.without_heading));
}

const char* verdict(const Judgement& judgement) {
  if (judgement.report.broken()) return "unsafe";
  return judgement.incomplete() ? "incomplete" : "safe";
}

std::string unjudged(const Judgement& judgement) {
  const CheckReport& report = judgement.report;
  std::string text = fmt::format("{} of {} steps, whose rows in between are missing",
                                 report.unjudged_steps, report.steps);
  if (judgement.every > 1) text += fmt::format(": every {} steps have rows", judgement.every);
  return text;
}

}  // namespace

std::string readable(const Judgement& judgement) {
  const avo::CheckReport& report = judgement.report;
  std::string text = fmt::format(
      "{}: {} robots, {} steps from {:.6g} s to {:.6g} s: {}{}\n",
      avo_io::printable(judgement.recording), report.robots, report.steps, report.from, report.to,
      verdict(judgement), judgement.safe() && !judgement.passed() ? ", but not all arrived" : "");
  const auto line = [&text](const char* name, const std::string& value) {
    text += fmt::format("  {:<18} {}\n", name, value);
  };
  if (!judgement.lacking.empty())
    line("missing",
         fmt::format("rows of {} at the first time or at the last one", named(judgement.lacking)));
  if (report.unjudged_steps > 0) line("not judged", unjudged(judgement));
  if (!judgement.whole)
    line("a part",
         fmt::format("{:.6g} to {:.6g} s of the scene, which ends at {:.6g} s or when all have "
                     "arrived",
                     report.from, report.to, judgement.scene_end));
  if (judgement.deviation > 0.0)
    line("references", fmt::format("of quadrotors; radii contain deviations of up to {:.3g} m",
                                   judgement.deviation));
  line("overlaps", text_of(judgement, report.overlaps, "pairs of robots", "m"));
  const char* allowed = report.movers_at_rest ? ", which is allowed" : "";
  if (judgement.scene)
    line("moving obstacles",
         text_of(judgement, report.mover_contacts_moving, "hit by a robot in motion", "m",
                 Among::moving_obstacles) +
             fmt::format("; {} hit a robot at rest{}", report.mover_contacts_at_rest,
                         report.mover_contacts_at_rest > 0 ? allowed : ""));
  add_hits(judgement, report.mover_hits, false, line);
  if (!report.one_sided_hits.empty())
    line("one-sided pairs", text_of(judgement, report.one_sided_contacts_moving,
                                    "hit in motion by the one that avoids", "m", Among::one_sided) +
                                fmt::format("; {} hit at rest{}", report.one_sided_contacts_at_rest,
                                            report.one_sided_contacts_at_rest > 0 ? allowed : ""));
  add_hits(judgement, report.one_sided_hits, true, line);
  if (!judgement.obstacle_of_wall.empty())
    line("obstacles",
         text_of(judgement, report.static_contacts, "robots touched one", "m", Among::walls));
  const char* const nobody_knows = "unknown, without a limit";
  line("acceleration",
       (judgement.knows_accelerations
            ? text_of(judgement, report.accelerations, "robot-steps beyond the limit", "m/s^2")
            : nobody_knows) +
           fmt::format("; largest {:.6g} m/s^2", report.largest_acceleration));
  line("speed",
       (judgement.knows_speeds ? text_of(judgement, report.speeds, "rows beyond the limit", "m/s")
                               : nobody_knows) +
           fmt::format("; largest {:.6g} m/s", report.largest_speed));
  if (judgement.estimated) line("velocities", "estimated, of a recording that has positions alone");
  line("jumps", text_of(judgement, report.jumps, "robot-steps off their velocities", "m"));
  add_kinematics(judgement, line);
  if (judgement.free_clocks)
    line("held", text_of(judgement, report.changes, "changes between two decisions", "m/s^2"));
  line("least clearance",
       report.least_clearance ? fmt::format("{:.3g} m", *report.least_clearance) : "-");
  if (report.least_static_clearance)
    line("  from obstacles", fmt::format("{:.3g} m", *report.least_static_clearance));
  if (report.with_goal > 0) line("arrived", arrivals(report));
  if (report.interpolation_error > 0.0)
    line("paths known to", fmt::format("{:.3g} m", report.interpolation_error));
  if (report.gaps > 0)
    line("gaps", fmt::format("{} in the rows of a robot, not judged", report.gaps));
  return text;
}

std::string to_json(const Judgement& judgement) {
  const avo::CheckReport& report = judgement.report;
  Json json;
  json["recording"] = judgement.recording;
  json["scene"] = or_null(judgement.scene);
  json["passed"] = judgement.passed();
  json["safe"] = judgement.safe();
  json["verdict"] = verdict(judgement);
  json["robots"] = report.robots;
  json["rows"] = report.rows;
  json["steps"] = report.steps;
  json["unjudged_steps"] = report.unjudged_steps;
  json["every"] = judgement.every;
  json["robot_steps"] = report.robot_steps;
  json["gaps"] = report.gaps;
  json["whole"] = judgement.time_step ? Json(judgement.whole) : Json();
  json["lacking"] = judgement.lacking;
  json["from"] = report.from;
  json["to"] = report.to;
  json["overlaps"] = to_json(judgement, report.overlaps, "other");
  json["mover_contacts_moving"] =
      to_json(judgement, report.mover_contacts_moving, "moving_obstacle", Among::moving_obstacles);
  json["mover_contacts_at_rest"] = report.mover_contacts_at_rest;
  json["mover_hits"] = hits_of(judgement, report.mover_hits, "moving_obstacle", false);
  json["one_sided_contacts_moving"] =
      to_json(judgement, report.one_sided_contacts_moving, "other", Among::one_sided);
  json["one_sided_contacts_at_rest"] = report.one_sided_contacts_at_rest;
  json["one_sided_hits"] = hits_of(judgement, report.one_sided_hits, "other", true);
  json["movers_at_rest"] = report.movers_at_rest ? "ok" : "collision";
  json["static_contacts"] = to_json(judgement, report.static_contacts, "obstacle", Among::walls);
  json["accelerations"] =
      judgement.knows_accelerations ? to_json(judgement, report.accelerations, nullptr) : unknown();
  json["speeds"] = judgement.knows_speeds ? to_json(judgement, report.speeds, nullptr) : unknown();
  json["jumps"] = to_json(judgement, report.jumps, nullptr);
  for (const KinematicRule& rule : kKinematics)
    json[rule.key] = to_json(judgement, report.*rule.count, nullptr);
  json["with_heading"] = report.with_heading;
  json["without_heading"] = report.without_heading;
  json["changes"] = to_json(judgement, report.changes, nullptr);
  json["least_clearance"] = or_null(report.least_clearance);
  json["least_static_clearance"] = or_null(report.least_static_clearance);
  json["largest_acceleration"] = report.largest_acceleration;
  json["largest_speed"] = report.largest_speed;
  json["with_goal"] = report.with_goal;
  json["arrived"] = report.arrived;
  json["at_goal_at_end"] = report.at_goal_at_end;
  json["last_arrival"] = or_null(report.last_arrival);
  json["not_arrived"] = report.not_arrived;
  json["deviation"] = judgement.deviation;
  json["estimated"] = judgement.estimated;
  json["tolerance"] = judgement.tolerance;
  json["interpolation_error"] = report.interpolation_error;
  json["uneven_steps"] = judgement.time_step ? Json(judgement.uneven_steps) : Json();
  json["version"] = avo::kVersion;
  // names of files may be no UTF-8
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace avo_io
