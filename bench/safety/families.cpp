// SPDX-License-Identifier: Apache-2.0
// The rows of the table.
#include "families.h"

#include <utility>

#include "alone_scenes.h"
#include "flow.h"
#include "read_scene.h"
#include "wall_scenes.h"

namespace avo::safety {
namespace {

// A row of scenes that YAML says: 20 with random numbers, or one.
Family read_family(const std::string& name, const std::string& what, const SceneText& text,
                   bool seeded, const std::function<Scene(Scenario)>& measured) {
  return {name, what, seeded ? 20 : 1, seeded,
          [=](std::uint64_t seed) { return measured(read_scene(text, seed)); }};
}

void add_squares(std::vector<Family>& all) {
  for (const int n : {2, 10, 30, 60}) {
    const std::string name = "random-" + std::to_string(n);
    all.push_back(read_family(name, "from and to anywhere in a square", {name + ".yaml"}, true,
                              within_duration));
    all.back().scenes = 200;
  }
}

// Measured by a target, s.
void add_circle(std::vector<Family>& all, const std::string& name, const std::string& what,
                const SceneText& text, bool seeded, double target) {
  all.push_back(read_family(name, what, text, seeded, [target](Scenario scenario) {
    Scene scene{std::move(scenario)};
    scene.unit = target;
    scene.scenario.duration = 1.5 * target;
    return scene;
  }));
}

void add_circles(std::vector<Family>& all) {
  const std::pair<int, double> rows[] = {{10, 24.0},   {50, 46.0},   {100, 46.0},
                                         {250, 102.0}, {500, 220.0}, {1000, 420.0}};
  for (const auto& [robots, target] : rows) {
    const std::string name = "circle-" + std::to_string(robots);
    add_circle(all, name, "antipodal goals on a circle", {name}, false, target);
  }
  add_circle(all, "circle-100-d2t6", "control_time 2, time_horizon 6",
             {"circle-100", {"control_time=2", "time_horizon=6"}}, false, 60.0);
  add_circle(all, "circle-100-d4t10", "control_time 4, time_horizon 10",
             {"circle-100", {"control_time=4", "time_horizon=10"}}, false, 90.0);
  for (const auto& [robots, target] : rows) {
    if (robots == 50 || robots == 500) continue;
    const std::string name = "circle-" + std::to_string(robots);
    add_circle(all, name + "-jitter", "starts and goals up to 0.2 m off",
               {name, {"groups.0.jitter=0.2"}}, true, target);
  }
}

// The same setting for the first `groups` groups.
std::vector<std::string> of_groups(int groups, const std::string& setting) {
  std::vector<std::string> settings;
  for (int k = 0; k < groups; ++k)
    settings.push_back("groups." + std::to_string(k) + "." + setting);
  return settings;
}

void add_blocks(std::vector<Family>& all) {
  const auto add = [&](const char* name, const char* what, const SceneText& text, bool seeded) {
    all.push_back(read_family(name, what, text, seeded, measured_by_straight_time));
  };
  add("swap", "two blocks of 10 x 10 exchange places", {"swap-blocks"}, false);
  add("swap-jitter", "the same, up to 0.2 m off", {"swap-blocks", of_groups(2, "jitter=0.2")},
      true);
  add("streams", "four blocks of 4 x 4 cross", {"crossing-streams"}, false);
  add("streams-jitter", "the same, up to 0.2 m off",
      {"crossing-streams", of_groups(4, "jitter=0.2")}, true);
  add("permutation", "10 x 10 robots deal their places anew", {"permutation-100"}, true);
}

void add_alone(std::vector<Family>& all) {
  const auto add = [&](const char* name, const char* what, int scenes, auto make) {
    all.push_back({name, what, scenes, true, make});
  };
  add("alone-crossing", "one robot whose course 1 to 10 movers cross", 450, alone_crossing);
  add("alone-goal", "one robot at its goal that 1 to 10 movers pass over", 360, alone_at_goal);
  add("alone-road", "one robot over a road of 1 to 3 lanes", 216, alone_over_road);
  add("alone-surprised", "one robot that sees a mover 0.7 to 3 s before contact", 270,
      alone_surprised);
  add("alone-paths", "one robot among 1 to 4 movers to and fro", 180, alone_among_paths);
  add("eight-movers", "8 robots on a circle that 6 movers cross", 80, eight_among_movers);
}

void add_arrivals(std::vector<Family>& all) {
  const auto add = [&](const std::string& name, const char* what, double units) {
    all.push_back(read_family(name, what, {name + ".yaml"}, true, [units](Scenario scenario) {
      return until_rest(std::move(scenario), units);
    }));
  };
  const auto add_made = [&](const std::string& name, const char* what, auto make) {
    all.push_back({name, what, 20, true, make});
  };
  add("ring", "a goal inside a closed ring of 8 at their goals", 8.0);
  add("deep", "a goal in the middle of 36 at their goals", 8.0);
  add("large", "one of 3 m across 200 of 0.3 m at their goals", 8.0);
  for (const int n : {36, 64}) {
    for (const bool hexagonal : {false, true}) {
      add_made("touching-" + std::to_string(n) + (hexagonal ? "-hex" : ""),
               hexagonal ? "the same in the densest packing" : "goals that touch, in a square",
               [n, hexagonal](std::uint64_t seed) { return touching_goals(n, hexagonal, seed); });
    }
  }
  add("block-swap", "8 x 8 robots 1.2 m apart, neighbors exchange places", 20.0);
  add("clump-100", "from and to anywhere, a quarter of the area covered", 3.0);
  add("clump-300", "from and to anywhere, a quarter of the area covered", 4.5);
  add_made("torus", "100 robots in four directions, on a torus of 30 m: the flow",
           [](std::uint64_t seed) { return flow_scene(Flow::torus, seed); });
  add_made("to-and-fro", "100 robots between the middles of a square's sides: the flow",
           [](std::uint64_t seed) { return flow_scene(Flow::to_and_fro, seed); });
}

// 98 % must arrive within ten minutes.
Scene within_ten_minutes(Scenario scenario) {
  scenario.duration = 600.0;
  Scene scene = within_duration(std::move(scenario));
  scene.share = 0.98;
  return scene;
}

void add_passages(std::vector<Family>& all) {
  const auto add = [&](const char* name, const char* what, const char* scene,
                       const std::vector<std::string>& settings) {
    all.push_back(read_family(name, what, {scene, settings}, true, within_ten_minutes));
  };
  const std::vector<std::string> half_each = of_groups(2, "number=25");
  add("doorway-1.6", "50 robots both ways through a door of 1.6 m", "doorway", half_each);
  add("corridor-1.6", "50 robots both ways through a corridor with one lane", "corridor-one-lane",
      half_each);
  add("corridor-2.4", "the same with two lanes", "corridor", half_each);
  add("office-1.6", "50 robots to random rooms with doors of 1.6 m", "office", half_each);
  add("office-1.2", "the same with doors of 1.2 m", "office-narrow.yaml", half_each);
  add("maze", "50 robots from and to anywhere in a maze", "maze", of_groups(1, "number=50"));
}

void add_walls(std::vector<Family>& all, double robot_steps) {
  constexpr int kScenes = 20;
  const double of_each = robot_steps / kScenes;
  const auto add = [&](const char* name, const char* what, Scene (*make)(double, std::uint64_t)) {
    all.push_back({name, what, kScenes, true,
                   [make, of_each](std::uint64_t seed) { return make(of_each, seed); }});
  };
  add("walls-random", "30 unequal robots among random segments", random_walls);
  add("walls-cars", "the same, every other one a car", walls_and_cars);
  add("walls-corners", "30 unequal robots sent into one sharp corner after the other",
      wall_corners);
  add("walls-gaps", "the same through gaps of 2r + 1e-6 m", wall_gaps);
  all.push_back({"clocks-walls", "walls-cars with free clocks, half of them twice as fast", kScenes,
                 true, [of_each](std::uint64_t seed) {
                   return with_clocks(walls_and_cars(of_each, seed), true, seed);
                 }});
  all.push_back({"clocks-mixed", "mixed-crush with free clocks, half of them twice as fast", 4,
                 true, [of_each](std::uint64_t seed) {
                   return with_clocks(mixed_crush(0.5 * of_each, seed), true, seed);
                 }});
  all.push_back({"clocks-movers", "movers with free clocks, half of them twice as fast", kScenes,
                 true,
                 [](std::uint64_t seed) { return with_clocks(among_movers(seed), true, seed); }});
  all.push_back({"walls-movers", "20 among random segments and obstacles that keep their velocity",
                 100, true, walls_and_movers});
}

}  // namespace

std::vector<Family> families(double soak_steps) {
  std::vector<Family> all;
  add_circles(all);
  add_squares(all);
  add_blocks(all);
  all.push_back({"mixed", "unequal radii, accelerations, speeds", 20, true, mixed});
  all.push_back(read_family("doorway", "two blocks of 4 x 4 change sides through a gap",
                            {"posts.yaml"}, false, measured_by_straight_time));
  all.push_back(
      {"movers", "robots among obstacles that keep their velocity", 20, true, among_movers});
  all.push_back({"people", "the same among people who walk about and may turn at any time", 100,
                 true, among_people});
  add_alone(all);
  add_arrivals(all);
  add_passages(all);
  constexpr int kCrushes = 4;
  for (const bool packed : {false, true}) {
    all.push_back({packed ? "crush-packed" : "crush",
                   packed ? "the same from four fifths of the densest packing"
                          : "200 unequal robots sent to one point",
                   kCrushes, true, [packed, soak_steps](std::uint64_t seed) {
                     return crush(packed, soak_steps / kCrushes, seed);
                   }});
  }
  all.push_back({"mixed-crush", "60 robots of all kinds and 5 people sent to one point", kCrushes,
                 true, [soak_steps](std::uint64_t seed) {
                   return mixed_crush(0.1 * soak_steps / kCrushes, seed);
                 }});
  for (const bool mixed : {false, true}) {
    all.push_back({mixed ? "airplanes-mixed" : "airplanes",
                   mixed ? "the same with cars and holonomic robots among them"
                         : "100 unequal airplanes sent to one point",
                   kCrushes, true, [mixed, soak_steps](std::uint64_t seed) {
                     return airplanes(mixed, soak_steps / kCrushes, seed);
                   }});
  }
  add_walls(all, soak_steps);
  add_sensing(all);
  return all;
}

}  // namespace avo::safety
