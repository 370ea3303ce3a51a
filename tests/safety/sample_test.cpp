// SPDX-License-Identifier: Apache-2.0
// The tests run a sample of every family with every certificate. No robot touches another robot,
// limits are kept, and robots arrive within the targets. scripts/soak safety runs all of every
// family.
#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "families.h"
#include "run.h"
#include "scenes.h"
#include "table.h"

namespace avo::safety {
namespace {

const Family& family_of(const std::vector<Family>& all, const std::string& name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Family& f) { return f.name == name; });
  if (found == all.end()) throw std::runtime_error("no family " + name);
  return *found;
}

struct Sample {
  const char* family;
  int scenes;
  double arrive;  // share of all robots of the sample, within the families' limits; 0: none has to
};

void PrintTo(const Sample& sample, std::ostream* out) {
  *out << sample.family;
}

struct Arrivals {
  std::int64_t robots = 0, in_time = 0;
};

// Robot-steps of a crush over all its scenes.
constexpr double kCrushSteps = 4e5;
constexpr std::uint64_t kFirstSeed = 1001;

Arrivals run(const Sample& sample, Certificate certificate, Motion motion) {
  const std::vector<Family> all = families(kCrushSteps);
  const Family& family = family_of(all, sample.family);
  Arrivals arrivals;
  for (int k = 0; k < sample.scenes; ++k) {
    const std::uint64_t seed = kFirstSeed + static_cast<std::uint64_t>(k);
    Scene scene = family.make(seed);
    scene.scenario.certificate = certificate;
    scene.scenario.motion = motion;
    see_far_enough(scene.scenario);
    const Outcome outcome = run_scene(scene, seed, "");
    EXPECT_TRUE(outcome.verdict.safe())
        << sample.family << ", seed " << seed << ": " << outcome.verdict.violations;
    arrivals.robots += static_cast<std::int64_t>(outcome.arrival.size());
    arrivals.in_time +=
        std::count_if(outcome.arrival.begin(), outcome.arrival.end(),
                      [&](double time) { return time <= outcome.limit * outcome.unit; });
  }
  return arrivals;
}

class Targets : public testing::TestWithParam<Sample> {};

TEST_P(Targets, are_reached_without_contact) {
  const Sample& sample = GetParam();
  const Arrivals arrivals = run(sample, Certificate::braking_trajectories, Motion::held);
  EXPECT_GE(static_cast<double>(arrivals.in_time),
            sample.arrive * static_cast<double>(arrivals.robots))
      << arrivals.in_time << " of " << arrivals.robots;
}

INSTANTIATE_TEST_SUITE_P(
    Families, Targets,
    testing::Values(
        Sample{"circle-10", 1, 1.0}, Sample{"circle-50", 1, 1.0}, Sample{"circle-100", 1, 1.0},
        Sample{"circle-250", 1, 1.0}, Sample{"circle-100-d2t6", 1, 1.0},
        Sample{"circle-100-d4t10", 1, 1.0}, Sample{"circle-100-jitter", 3, 0.99},
        Sample{"random-2", 40, 0.995}, Sample{"random-10", 30, 0.995},
        Sample{"random-30", 20, 0.995}, Sample{"random-60", 12, 0.99}, Sample{"swap", 1, 0.9},
        Sample{"swap-jitter", 3, 0.98}, Sample{"streams", 1, 0.99}, Sample{"ring", 4, 1.0},
        Sample{"deep", 4, 1.0}, Sample{"large", 1, 1.0}, Sample{"block-swap", 4, 0.93},
        Sample{"clump-100", 4, 0.9}, Sample{"permutation", 4, 0.99}, Sample{"mixed", 6, 0.98},
        Sample{"movers", 6, 0.99}, Sample{"crush", 1, 0.0}, Sample{"crush-packed", 1, 0.0},
        Sample{"doorway-1.6", 2, 0.98}, Sample{"corridor-1.6", 2, 0.98},
        Sample{"corridor-2.4", 2, 0.98}, Sample{"office-1.6", 2, 0.98},
        Sample{"office-1.2", 2, 0.97}, Sample{"maze", 2, 0.97}, Sample{"walls-random", 4, 0.0},
        Sample{"walls-cars", 4, 0.0}, Sample{"walls-corners", 4, 0.0}, Sample{"walls-gaps", 4, 0.0},
        Sample{"walls-movers", 2, 0.0}, Sample{"clocks-random", 10, 0.99},
        Sample{"clocks-steps-random", 10, 0.99}, Sample{"clocks-circle", 3, 0.99},
        Sample{"clocks-crush", 2, 0.0}, Sample{"clocks-steps-crush", 2, 0.0},
        Sample{"clocks-walls", 1, 0.0}, Sample{"clocks-movers", 2, 0.98},
        Sample{"clocks-mixed", 1, 0.0}),
    [](const auto& kind) {
      std::string name = kind.param.family;
      std::replace_if(
          name.begin(), name.end(), [](char c) { return c == '-' || c == '.'; }, '_');
      return name;
    });

// Where goals touch, all come to rest, bit for bit.
TEST(Rest, comes_within_a_minute_of_the_last_arrival) {
  const std::vector<Family> all = families(kCrushSteps);
  for (const char* name : {"touching-36", "touching-36-hex", "touching-64", "touching-64-hex"}) {
    const Family& family = family_of(all, name);
    for (std::uint64_t seed = kFirstSeed; seed < kFirstSeed + 3; ++seed) {
      const Outcome outcome = run_scene(family.make(seed), seed, "");
      EXPECT_TRUE(outcome.verdict.safe()) << name << ", seed " << seed;
      EXPECT_LE(last_arrival(outcome), 300.0) << name << ", seed " << seed;
      EXPECT_LE(*outcome.rest, last_arrival(outcome) + 60.0) << name << ", seed " << seed;
    }
  }
}

TEST(Flow, never_ends_and_gets_on) {
  const std::vector<Family> all = families(kCrushSteps);
  for (const auto& [name, least] : {std::pair{"torus", 0.9}, {"to-and-fro", 0.25}}) {
    const Outcome outcome = run_scene(family_of(all, name).make(kFirstSeed), kFirstSeed, "");
    EXPECT_TRUE(outcome.verdict.safe()) << name;
    EXPECT_GE(*outcome.flow, least) << name;
  }
}

// The same scenes, by clocks of their own and by a common one.
TEST(FreeClocks, cost_hardly_any_time) {
  const std::vector<Family> all = families(kCrushSteps);
  const auto mean_of = [&](const char* name) {
    const Family& family = family_of(all, name);
    std::vector<Outcome> outcomes;
    for (std::uint64_t seed = kFirstSeed; seed < kFirstSeed + 10; ++seed)
      outcomes.push_back(run_scene(family.make(seed), seed, ""));
    const RowResult row = summarize(name, outcomes);
    EXPECT_GE(static_cast<double>(row.arrived), 0.99 * static_cast<double>(row.robots)) << name;
    return row.mean;
  };
  EXPECT_LT(mean_of("clocks-random"), 1.15 * mean_of("random-30"));
}

struct Kind {
  Certificate certificate;
  Motion motion;
};

class EveryCertificate : public testing::TestWithParam<Kind> {};

TEST_P(EveryCertificate, is_safe_and_lets_arrive) {
  const auto [certificate, motion] = GetParam();
  for (const Sample& sample :
       {Sample{"circle-50", 1, 0.9}, Sample{"random-30", 5, 0.99}, Sample{"mixed", 2, 0.9},
        Sample{"crush", 1, 0.0}, Sample{"walls-random", 2, 0.0}, Sample{"walls-corners", 2, 0.0},
        Sample{"walls-gaps", 2, 0.0}}) {
    const Arrivals arrivals = run(sample, certificate, motion);
    EXPECT_GE(static_cast<double>(arrivals.in_time),
              sample.arrive * static_cast<double>(arrivals.robots))
        << sample.family << ": " << arrivals.in_time << " of " << arrivals.robots;
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryCertificate,
                         testing::Values(Kind{Certificate::braking_trajectories,
                                              Motion::exponential}),
                         [](const auto& kind) {
                           const bool held = kind.param.motion == Motion::held;
                           return std::string(avo::to_string(kind.param.certificate)) +
                                  (held ? "_held" : "_exponential");
                         });

}  // namespace
}  // namespace avo::safety
