// SPDX-License-Identifier: Apache-2.0
// The rows with wrong sensing and with faults on board: a random square, a jittered circle and a
// crush each.
#include <algorithm>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "families.h"
#include "placement.h"
#include "read_scene.h"

namespace avo::safety {
namespace {

constexpr double kClearance = 0.3;  // m between robots at the start

Scene square_of_30(std::uint64_t seed) {
  return within_duration(read_scene({"random-30.yaml"}, seed));
}

// Returns a circle so small that all robots meet within seconds.
Scene circle_of_20(std::uint64_t seed) {
  return within_duration(
      read_scene({"circle-20",
                  {"groups.0.placement.circle.min_radius=8", "groups.0.preferred_speed=1.5",
                   "groups.0.jitter=0.2", "duration=60"}},
                 seed));
}

// Returns unequal robots, all sent to one point, then to another.
Scene crush_of_40(std::uint64_t seed) {
  Scene scene{usual_scenario()};
  Random random(seed, 10);
  std::vector<double> radii(40);
  for (double& radius : radii) radius = random.between(0.3, 0.6);
  std::sort(radii.rbegin(), radii.rend());
  for (int k = 0; k < 5; ++k) scene.rallies.push_back(random.in_square(6.0));
  for (const Vec2 start : random_places(radii, 11.0, kClearance, random)) {
    RobotSetup robot = usual_robot(start, scene.rallies[0], kSpeed);
    robot.radius = radii[scene.scenario.robots.size()];
    robot.max_acceleration = random.between(0.7, 1.4);
    scene.scenario.robots.push_back(robot);
  }
  scene.scenario.duration = 60.0;
  return scene;
}

struct Case {
  std::string name, what;
  Sensing sensing;
  Acting acting = {};
  int scenes = 20;  // of each kind, and of each shape of errors
};

// The library's own model of what robots sense.
struct ModelCase {
  std::string name, what;
  SensingModel model;
  std::optional<double> declared = {};  // standard deviations; unset: the full error
};

SensingModel gaussian(std::optional<double> truncated) {
  SensingModel model;
  model.noise = {0.02, 0.05, NoiseDistribution::gaussian, truncated};
  return model;
}

std::vector<ModelCase> model_cases() {
  SensingModel late, tracked, all = gaussian({});
  late.delay = all.delay = 1;
  tracked.dropped = all.dropped = 0.05;
  const std::string noise = "normal errors of 2 cm and 5 cm/s";
  return {
      {"delay-1", "one step old, declared", late},
      {"tracked-5%", "each neighbor missed in one step of twenty, and carried on", tracked},
      {"gaussian-3", noise + ", within 3 deviations, declared", gaussian({})},
      {"gaussian-all", "the same, one step old, one of twenty missed", all},
      {"gaussian-beyond-2", noise + ", 2 deviations declared", gaussian(6.0), 2.0},
      {"gaussian-beyond-1", noise + ", 1 deviation declared", gaussian(6.0), 1.0},
      {"gaussian-undeclared", noise, gaussian(6.0), 0.0},
  };
}

Scene with_model(Scene scene, const ModelCase& chosen, std::uint64_t seed) {
  Scenario& scenario = scene.scenario;
  scenario.seed = seed;
  scenario.sensing = chosen.model;
  see_far_enough(scenario);
  if (!chosen.declared) return scene;
  const MeasurementNoise& noise = chosen.model.noise;
  const double each = std::numbers::sqrt2 * *chosen.declared;
  scenario.sensing_error = SensingError{each * noise.position, each * noise.velocity};
  return scene;
}

Sensing wrong(SensingError error, SensingError declared) {
  Sensing sensing;
  sensing.error = error;
  sensing.declared = declared;
  sensing.promised = error == declared;
  return sensing;
}

std::vector<Case> cases() {
  Sensing blind;
  blind.missed = 0.05;
  return {
      {"sensing-p1", "1 cm off, declared", wrong({0.01, 0.0}, {0.01, 0.0})},
      {"sensing-p5v5", "5 cm and 5 cm/s off, declared", wrong({0.05, 0.05}, {0.05, 0.05})},
      {"sensing-undeclared-1", "1 cm off", wrong({0.01, 0.0}, {})},
      {"sensing-undeclared-3", "3 cm off", wrong({0.03, 0.0}, {})},
      {"sensing-undeclared-10", "10 cm off", wrong({0.1, 0.0}, {})},
      {"sensing-beyond-p1", "3 cm off, 1 cm declared", wrong({0.03, 0.0}, {0.01, 0.0})},
      {"sensing-beyond-p5v5", "15 cm and 15 cm/s off, a third declared",
       wrong({0.15, 0.15}, {0.05, 0.05})},
      {"dropped-5%", "each neighbor missed in one step of twenty", blind},
  };
}

// Returns the faults that a user has to rule out on board, each by itself. None of them is
// declared, except where clocks out of phase are treated as errors (docs/on_board.md).
std::vector<Case> faults_on_board() {
  constexpr std::int64_t kTicks = 10;
  Acting phases, jitter, late, weak, one_sided, half_steps;
  phases.ticks = jitter.ticks = late.ticks = kTicks;
  phases.phases = true;
  jitter.jitter = 1;
  late.latency = kTicks / 2;
  weak.strength = 0.8;
  one_sided.oddity = Oddity::one_sided;
  half_steps.oddity = Oddity::half_steps;
  half_steps.ticks = 2;
  Acting free_clock = phases, free_steps = phases;
  free_clock.free_clock = free_steps.free_clock = true;
  free_steps.oddity = Oddity::half_steps;
  Sensing exact, stale, carried, blind, small, allowed, promised;
  stale.stale = true;
  carried.delayed = true;
  blind.missed = 0.01;
  small.radius = 0.9;
  promised.promised = true;
  allowed.declared = {0.028, 0.28};  // 2 a_max Δt, and that for Δt, with a_max at most 1.4 m/s²
  return {
      {"board-phases", "each decides at times of its own", exact, phases},
      {"board-phases-declared", "the same, taken for errors", allowed, phases},
      {"board-phases-free", "the same, with free clocks", promised, free_clock},
      {"board-steps-free", "and half of them decide twice as often", promised, free_steps},
      {"board-jitter", "steps a tenth shorter or longer, all by themselves", exact, jitter},
      {"board-stale", "states one step old", stale},
      {"board-stale-carried", "states one step old, carried on", carried},
      {"board-latency", "decisions take effect half a step late", exact, late},
      {"board-weak", "drives have four fifths of a_max", exact, weak},
      {"board-missed", "each neighbor missed in one step of a hundred", blind},
      {"board-radius", "neighbors look a tenth smaller", small},
      {"board-one-sided", "half the robots plan as among obstacles", exact, one_sided, 5},
      {"board-steps", "half the robots decide twice as often", exact, half_steps},
  };
}

// Returns robots among obstacles whose motion no robot can foresee.
Family whims_of_movers(const std::string& name, double whims) {
  return {name, "obstacles that change their acceleration every second", 20, true,
          [whims](std::uint64_t seed) {
            Scene scene = among_movers(seed);
            scene.scenario.duration = 30.0;
            scene.sensing.emplace();
            scene.acting.whims = whims;
            return scene;
          }};
}

}  // namespace

void add_sensing(std::vector<Family>& all) {
  struct Kind {
    std::string name, what;
    Scene (*make)(std::uint64_t seed);
  };
  const Kind kinds[] = {{"random", "30 robots in a square", square_of_30},
                        {"circle", "20 robots on a circle", circle_of_20},
                        {"crush", "40 robots sent to one point", crush_of_40}};
  std::vector<Case> all_cases = cases();
  for (Case& fault : faults_on_board()) all_cases.push_back(std::move(fault));
  for (const Case& chosen : all_cases) {
    const bool shaped = !(chosen.sensing.error == SensingError{});
    for (const Kind& kind : kinds) {
      all.push_back({chosen.name + "-" + kind.name, chosen.what + ": " + kind.what,
                     shaped ? chosen.scenes * kErrorShapes : chosen.scenes, true,
                     [chosen, make = kind.make](std::uint64_t seed) {
                       const Sensing& sensing = chosen.sensing;
                       Scene scene = make(seed);
                       scene.acting = chosen.acting;
                       scene.sensing = sensing;
                       scene.sensing->shape = static_cast<ErrorShape>(seed % kErrorShapes);
                       return scene;
                     }});
    }
  }
  for (const ModelCase& chosen : model_cases()) {
    for (const Kind& kind : kinds) {
      all.push_back({chosen.name + "-" + kind.name, chosen.what + ": " + kind.what, 20, true,
                     [chosen, make = kind.make](std::uint64_t seed) {
                       return with_model(make(seed), chosen, seed);
                     }});
    }
  }
  for (const bool unequal : {false, true}) {
    for (const Kind& kind : kinds) {
      all.push_back(
          {std::string(unequal ? "clocks-steps-" : "clocks-") + kind.name,
           std::string(unequal ? "free clocks, half of them twice as fast: " : "free clocks: ") +
               kind.what,
           20, true, [unequal, make = kind.make](std::uint64_t seed) {
             return with_clocks(make(seed), unequal, seed);
           }});
    }
  }
  all.push_back(whims_of_movers("board-movers", 1.0));
  all.push_back(whims_of_movers("board-movers-gentle", 0.2));
}

}  // namespace avo::safety
