// SPDX-License-Identifier: Apache-2.0
#include "sim/claims.h"

#include <algorithm>
#include <optional>

#include "sim/world.h"

namespace avo::inline sim {
namespace {

constexpr double kLeavesLane = 1.0;  // rad: a robot that has turned off by more is in a jam
// of a robot; memory for more is allocated when it is needed
constexpr std::size_t kMostClaims = 4;

// Appends the claims within kClaimRange that the robot seems to have.
void append_claims(const World& world, std::size_t slot, std::vector<Claimant>& claimants) {
  const Ways& ways = world.ways;
  const Vec2 p = world.fleet.position[slot];
  const auto append = [&](const Claim& claim) {
    claimants.push_back(claimant_of(world, slot, claim));
  };
  ways.passages.for_each_watched(p, [&](std::uint32_t number) {
    const Passage& passage = ways.passages[number];
    const auto claim = seen_claim(passage, number, p, world.fleet.velocity[slot]);
    if (!claim) return;
    const Vec2 mouth = axis_point(passage, claim->forward, 0.0).point;
    if (claim->inside || ways.is_in_sight(p, mouth)) append(*claim);
  });
}

// A point as far off as the rest of the route, so that no robot brakes for the place, unless it
// must stop.
Vec2 beyond(Vec2 p, Vec2 target, double rest) {
  const Vec2 way = target - p;
  const double distance = norm(way);
  return distance > 0.0 && rest > distance ? p + (rest / distance) * way : target;
}

}  // namespace

Prospect prospect_of(const World& world, std::size_t slot, const Travel& travel) {
  return look_ahead(world.ways.passages, *travel.graph, *travel.map, world.fleet.position[slot],
                    travel.target);
}

Claimant claimant_of(const World& world, std::size_t slot, const Claim& claim) {
  const Conduct& conduct = world.fleet.conduct[slot];
  const bool shares = shares_room(world, slot);
  return {claim,
          world.fleet.position[slot],
          conduct.layers.bits,
          conduct.avoids.bits,
          shares ? world.end_of(slot) : Vec2{},
          shares ? world.fleet.traits[slot].radius : 0.0,
          static_cast<std::uint32_t>(world.fleet.rank[slot])};
}

void collect_claims(const World& world, Executor& executor, Claims& claims) {
  const std::size_t robots = world.fleet.size(), parts = executor.workers();
  claims.parts.resize(std::max(claims.parts.size(), parts));
  parallel_for(executor, parts, [&](std::size_t part, std::size_t) {
    std::vector<Claimant>& own = claims.parts[part];
    own.clear();
    own.reserve(kMostClaims * (robots / parts + 1));
    for (std::size_t k = part * robots / parts; k < (part + 1) * robots / parts; ++k) {
      const std::uint32_t slot = world.fleet.slot_of[k];
      if (world.fleet.conduct[slot].parked || world.fleet.told_velocity(slot)) continue;
      append_claims(world, slot, own);
    }
  });
  std::vector<std::uint32_t>& first = claims.first;
  first.assign(world.ways.passages.size() + 1, 0);
  const auto for_each = [&](const auto& visit) {
    for (std::size_t part = 0; part < parts; ++part) {
      for (const Claimant& claimant : claims.parts[part]) visit(claimant);
    }
  };
  for_each([&](const Claimant& claimant) { ++first[claimant.claim.passage + 1]; });
  for (std::size_t k = 1; k < first.size(); ++k) first[k] += first[k - 1];
  claims.claimants.reserve(kMostClaims * robots);
  claims.claimants.resize(first.back());
  // each `first` becomes that of the next passage, and then its own again
  for_each([&](const Claimant& claimant) {
    claims.claimants[first[claimant.claim.passage]++] = claimant;
  });
  std::copy_backward(first.begin(), first.end() - 1, first.end());
  first[0] = 0;
}

Heading heed_passages(const World& world, const Claims& claims, std::size_t slot,
                      const Travel& travel, const Heading& heading, double nearest) {
  if (!travel.is_known()) return heading;
  const Vec2 p = world.fleet.position[slot];
  const auto [claim, lane] = prospect_of(world, slot, travel);
  const double rest = norm(heading.goal - p);
  Heading heeding = heading;
  const RobotTraits& traits = world.fleet.traits[slot];
  const bool in_company = is_in_company(traits.radius, nearest);
  if (lane && in_company && world.fleet.detour[slot].angle <= kLeavesLane)
    heeding.goal = beyond(p, *lane, rest), heeding.guide = Guide::lane;
  if (!claim) return heeding;
  const Passage& passage = world.ways.passages[claim->passage];
  const Course course =
      right_of_way(passage, claimant_of(world, slot, *claim), planned_braking(traits),
                   claims.of(claim->passage), world.sensing_radius);
  heeding.yields = course.target || course.max_speed < heeding.preferred_speed;
  if (heeding.yields) heeding.guide = Guide::passage;
  heeding.preferred_speed = std::min(heeding.preferred_speed, course.max_speed);
  if (course.target) heeding.goal = course.stops ? *course.target : beyond(p, *course.target, rest);
  return heeding;
}

}  // namespace avo::inline sim
