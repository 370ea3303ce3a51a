// SPDX-License-Identifier: Apache-2.0
// The messages about bad scene files, word by word: line, column, what, found, allowed.
#include "bad_scenes.h"

namespace avo_test {

const std::vector<BadScene>& bad_scenes() {
  static const std::vector<BadScene> scenes{
      {"empty_file", s(""),
       "1:1: found nothing, must be a map with at least version and robots, robots_from or groups"},
      {"only_comment", s("# nothing\n"),
       "1:1: found nothing, must be a map with at least version and robots, robots_from or groups"},
      {"a_word", s("circle\n"), s("1:1: found \"circle\", must be a map with keys ") + kSceneKeys},
      {"a_list", s("- 1\n- 2\n"), s("1:1: found a list, must be a map with keys ") + kSceneKeys},
      {"version_missing", s("robots:\n  - {position: [0, 0], goal: [1, 0]}\n"),
       "1:1: found no \"version\", must be given: version: 1"},
      {"version_2", s("version: 2\nrobots:\n  - {position: [0, 0], goal: [1, 0]}\n"),
       "1:10: version: found 2, must be 1"},
      {"version_text", s("version: \"1\"\nrobots:\n  - {position: [0, 0], goal: [1, 0]}\n"),
       "1:10: version: found \"1\", must be 1"},
      {"no_robots", s("version: 1\nname: empty\n"),
       "1:1: found no robots, must have at least one in robots, robots_from or groups"},
      {"robots_empty", s("version: 1\nrobots: []\n"),
       "1:1: found no robots, must have at least one in robots, robots_from or groups"},
      {"robots_a_map", s("version: 1\nrobots: {position: [0, 0], goal: [1, 0]}\n"),
       "2:9: robots: found a map, must be a list"},
      {"robot_a_number", s("version: 1\nrobots:\n  - 5\n"),
       s("3:5: robots.0: found 5, must be a map with keys ") + kRobotKeys},
      {"unknown_key", kGood + s("time_stp: 0.1\n"),
       s("4:1: found the unknown key \"time_stp\", did you mean \"time_step\"? Allowed are ") +
           kSceneKeys},
      {"unknown_key_far", kGood + s("colour: red\n"),
       s("4:1: found the unknown key \"colour\", allowed are ") + kSceneKeys},
      {"unknown_key_in_robot",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], max_acel: 2}\n"),
       s("3:38: robots.0: found the unknown key \"max_acel\", did you mean \"max_acceleration\"? "
         "Allowed are ") +
           kRobotKeys},
      {"swapped_letters", s("version: 1\nrobots:\n  - position: [0, 0]\n    gaol: [1, 0]\n"),
       s("4:5: robots.0: found the unknown key \"gaol\", did you mean \"goal\"? Allowed are ") +
           kRobotKeys},
      {"duplicate_key",
       s("version: 1\ntime_step: 0.1\nrobots:\n  - {position: [0, 0], goal: [1, 0]}\ntime_step: "
         "0.2\n"),
       "5:1: found the key \"time_step\" twice, allowed is once, the first is in line 2"},
      {"duplicate_key_in_robot",
       s("version: 1\nrobots:\n  - position: [0, 0]\n    goal: [1, 0]\n    radius: 1\n    radius: "
         "2\n"),
       "6:5: robots.0: found the key \"radius\" twice, allowed is once, the first is in line 5"},
      {"layer_32",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], layers: [0, 32]}\n"),
       "3:50: robots.0.layers.1: found 32, must be <= 31"},
      {"layer_twice",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], avoids: [2, 2]}\n"),
       "3:50: robots.0.avoids.1: found 2 twice, must be there once"},
      {"layers_a_number",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], layers: 1}\n"),
       "3:46: robots.0.layers: found 1, must be a list"},
      {"behavior_unknown",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], behavior: brakes}\n"),
       "3:48: robots.0.behavior: found \"brakes\", must be one of decides, cooperates, moves_on, "
       "parked"},
      {"obstacle_layer_too_high",
       s("version: 1\nobstacles:\n  - {polyline: [[0, 0], [1, 0]], layers: [0, 32]}\n"),
       "3:46: obstacles.0.layers.1: found 32, must be <= 31"},
      {"behavior_parked",
       s("version: 1\nrobots:\n"
         "  - {position: [0, 0], goal: [0, 0], parked: true, behavior: cooperates}\n"),
       "3:46: robots.0.parked: found true, must be left out beside behavior: cooperates"},
      {"parked_and_not",
       s("version: 1\nrobots:\n"
         "  - {position: [0, 0], goal: [0, 0], parked: false, behavior: parked}\n"),
       "3:46: robots.0.parked: found false, must be left out beside behavior: parked"},
      {"parked_a_word",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [0, 0], parked: maybe}\n"),
       "3:46: robots.0.parked: found \"maybe\", must be true or false"},
      {"never_swerves_of_orca",
       s("version: 1\nmethod: orca\nrobots:\n  - {position: [0, 0], goal: [1, 0]}\n"
         "never_swerves: true\n"),
       "5:16: never_swerves: found true, must be false with method orca"},
      {"parked_elsewhere",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], parked: true}\n"),
       "3:30: robots.0.goal: found [1, 0], must be [0, 0], its position: it is parked"},
      {"priority_zero",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], priority: 0}\n"),
       "3:48: robots.0.priority: found 0, must be > 0"},
      {"brakes_harder_than_its_wheels_can",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], model: differential_drive, "
         "max_acceleration: 0.5, max_braking: 2.5}\n"),
       "3:101: robots.0.max_braking: found 2.5, must be < 2.1213203435596424 m/s^2, "
       "wheel_acceleration/sqrt(1 + (track/(2 offset))^2)"},
      {"max_speed_of_one_that_keeps_its_acceleration",
       kGood + s("moving_obstacles:\n  - {position: [9, 9], max_speed: 2}\n"),
       "5:35: moving_obstacles.0.max_speed: found 2, must be left out without max_deviation: it "
       "keeps "
       "its acceleration"},
      {"path_without_limits",
       kGood + s("moving_obstacles:\n  - {position: [9, 9], max_deviation: 2, path: [[1, 2]]}\n"),
       "5:48: moving_obstacles.0.path: found one, must be left out without max_speed and "
       "max_deviation, within which it is followed"},
      {"path_of_numbers", kGood + s("moving_obstacles:\n  - {position: [9, 9], path: [1, 2]}\n"),
       "5:31: moving_obstacles.0.path.0: found 1, must be [x, y] in m"},
      {"missing_goal", s("version: 1\nrobots:\n  - {position: [0, 0]}\n"),
       "3:5: robots.0: found no \"goal\", must be given: where it wants to come to rest"},
      {"missing_position", kGood + s("  - {goal: [1, 0]}\n"),
       "4:5: robots.1: found no \"position\", must be given: where it starts"},
      {"obstacle_without_position", kGood + s("moving_obstacles:\n  - {velocity: [1, 0]}\n"),
       "5:5: moving_obstacles.0: found no \"position\", must be given: where it starts, or "
       "a trajectory"},
      {"number_is_text", kGood + s("time_step: fast\n"),
       "4:12: time_step: found \"fast\", must be a number (s)"},
      {"number_in_quotes", kGood + s("time_step: \"0.1\"\n"),
       "4:12: time_step: found \"0.1\", must be a number (s)"},
      {"number_with_unit", kGood + s("time_step: 0.1 s\n"),
       "4:12: time_step: found \"0.1 s\", must be a number (s)"},
      {"number_with_comma", kGood + s("time_step: 0,1\n"),
       "4:12: time_step: found \"0,1\", must be a number (s)"},
      {"number_hexadecimal", kGood + s("time_step: 0x1p-3\n"),
       "4:12: time_step: found \"0x1p-3\", must be a number (s)"},
      {"number_is_list", kGood + s("time_step: [0.1]\n"),
       "4:12: time_step: found a list, must be a number (s)"},
      {"number_is_nothing", kGood + s("time_step:\n"),
       "4:1: time_step: found nothing, must be a number (s)"},
      {"number_is_true", kGood + s("time_step: true\n"),
       "4:12: time_step: found \"true\", must be a number (s)"},
      {"number_nan", kGood + s("time_step: .nan\n"),
       "4:12: time_step: found .nan, must be a finite number"},
      {"number_nan_bare", kGood + s("time_step: nan\n"),
       "4:12: time_step: found nan, must be a finite number"},
      {"number_inf", kGood + s("duration: .inf\n"),
       "4:11: duration: found .inf, must be a finite number"},
      {"number_minus_inf", s("version: 1\nrobots:\n  - {position: [-.inf, 0], goal: [1, 0]}\n"),
       "3:17: robots.0.position.0: found -.inf, must be a finite number"},
      {"number_too_large", kGood + s("duration: 1e400\n"),
       "4:11: duration: found 1e400, must be within the range of a double"},
      {"priority_tiny",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], priority: 1e-100}\n"),
       "3:48: robots.0.priority: found 1e-100, must be >= 1e-60"},
      {"heading_of_many_turns",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], heading: 1e7, car: {}}\n"),
       "3:47: robots.0.heading: found 1e7, must be <= 1e+06 rad"},
      {"body_without_radius",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], car: {body: {offset: 1}}}\n"),
       "3:50: robots.0.car.body: found no \"radius\", must be given: of the disc, instead of "
       "radius"},
      {"number_too_small", kGood + s("time_step: 1e-400\n"),
       "4:12: time_step: found 1e-400, must be within the range of a double"},
      {"number_zero", kGood + s("time_step: 0\n"), "4:12: time_step: found 0, must be > 0 s"},
      {"number_minus_zero", kGood + s("control_time: -0.0\n"),
       "4:15: control_time: found -0.0, must be > 0 s"},
      {"sensing_a_word", kGood + s("sensing: noisy\n"),
       "4:10: sensing: found \"noisy\", must be a map with keys noise, delay, dropped, occlusion, "
       "localization"},
      {"noise_of_another_kind",
       kGood + s("sensing: {noise: {position: 0.1, distribution: normal}}\n"),
       "4:48: sensing.noise.distribution: found \"normal\", must be one of gaussian, uniform"},
      {"noise_uniform_truncated",
       kGood + s("sensing: {noise: {position: 0.1, distribution: uniform, truncated: 2}}\n"),
       "4:68: sensing.noise.truncated: found 2, must be left out with distribution uniform, which "
       "stays within what is given"},
      {"delay_of_half_a_step", kGood + s("sensing: {delay: 0.5}\n"),
       "4:18: sensing.delay: found 0.5, must be a whole number"},
      {"dropped_all", kGood + s("sensing: {dropped: 1}\n"),
       "4:20: sensing.dropped: found 1, must be <= 0.999"},
      {"declared_without_a_certificate",
       kGood + s("method: orca\nsensing_error: {position: 0.1}\n"),
       "5:16: sensing_error: found one, must be none with certificate none"},
      {"number_negative", kGood + s("sensing_radius: -15\n"),
       "4:17: sensing_radius: found -15, must be > 0 m"},
      {"number_beyond_all", kGood + s("sensing_radius: 1e13\n"),
       "4:17: sensing_radius: found 1e13, must be <= 1e+12 m"},
      {"radius_zero", s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], radius: 0}\n"),
       "3:46: robots.0.radius: found 0, must be > 0 m"},
      {"preferred_speed_negative",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], preferred_speed: -1}\n"),
       "3:55: robots.0.preferred_speed: found -1, must be >= 0 m/s"},
      {"point_of_three", s("version: 1\nrobots:\n  - {position: [0, 0, 0], goal: [1, 0]}\n"),
       "3:16: robots.0.position: found a list of 3, must be [x, y] in m"},
      {"point_is_number", s("version: 1\nrobots:\n  - {position: 3, goal: [1, 0]}\n"),
       "3:16: robots.0.position: found 3, must be [x, y] in m"},
      {"point_empty", s("version: 1\nrobots:\n  - {position: [], goal: [1, 0]}\n"),
       "3:16: robots.0.position: found an empty list, must be [x, y] in m"},
      {"point_of_words", s("version: 1\nrobots:\n  - {position: [left, 0], goal: [1, 0]}\n"),
       "3:17: robots.0.position.0: found \"left\", must be a number (m)"},
      {"whole_number_is_fraction", kGood + s("max_neighbors: 2.5\n"),
       "4:16: max_neighbors: found 2.5, must be a whole number"},
      {"whole_number_exponent", kGood + s("max_neighbors: 1e1\n"),
       "4:16: max_neighbors: found 1e1, must be a whole number"},
      {"max_neighbors_zero", kGood + s("max_neighbors: 0\n"),
       "4:16: max_neighbors: found 0, must be >= 1"},
      {"samples", kGood + s("samples: 0\n"),
       "4:1: found the removed key \"samples\", must be left out: all half-planes are exact"},
      {"told", kGood + s("right_of_way: told\n"),
       "4:15: right_of_way: found \"told\", must be seen: told was removed"},
      {"seed_negative", kGood + s("seed: -1\n"), "4:7: seed: found -1, must be >= 0"},
      {"seed_too_large", kGood + s("seed: 18446744073709551616\n"),
       "4:7: seed: found 18446744073709551616, must be < 2^64 = 18446744073709551616"},
      {"method_unknown", kGood + s("method: orka\n"),
       "4:9: method: found \"orka\", did you mean \"orca\"? Must be one of avo, avo_paper, "
       "velocity_obstacle, orca, orca_clamped, reciprocal_velocity_obstacle, buffered_voronoi, "
       "external, external_clamped"},
      {"method_number", kGood + s("method: 3\n"),
       "4:9: method: found 3, must be one of avo, avo_paper, velocity_obstacle, orca, "
       "orca_clamped, "
       "reciprocal_velocity_obstacle, buffered_voronoi, external, "
       "external_clamped"},
      {"certificate_unknown", kGood + s("certificate: capsules\n"),
       "4:14: certificate: found \"capsules\", must be one of none, braking_trajectories"},
      {"stopping_capsules", kGood + s("certificate: stopping_capsules\n"),
       "4:14: certificate: found \"stopping_capsules\", must be braking_trajectories: "
       "stopping_capsules was removed"},
      {"certificate_of_another_method",
       kGood + s("method: avo_paper\ncertificate: "
                 "braking_trajectories\n"),
       "5:14: certificate: found braking_trajectories, must be none with method avo_paper"},
      {"certificate_that_there_is_not", kGood + s("certificate: linear_soft_stop\n"),
       "4:14: certificate: found \"linear_soft_stop\", must be one of none, braking_trajectories"},
      {"key_that_there_is_not", kGood + s("soft_stop_time: 2\n"),
       s("4:1: found the unknown key \"soft_stop_time\", allowed are ") + kSceneKeys},
      {"braking_for_ever",
       s("version: 1\nduration: 9\nrobots:\n  - {position: [0, 0], goal: [1, 0], max_speed: 2, "
         "max_acceleration: 0.0001}\n"),
       "4:49: robots.0.max_speed: found 2, must be <= 0.65 m/s, 65000 steps of braking, with a "
       "certificate"},
      {"motion_unknown", kGood + s("motion: exact\n"),
       "4:9: motion: found \"exact\", must be one of held, exponential"},
      {"precision_single", kGood + s("precision: single\n"),
       "4:1: found the removed key \"precision\", must be left out: everything is computed in "
       "double "
       "precision"},
      {"precision_double", kGood + s("precision: double\n"),
       "4:1: found the removed key \"precision\", must be left out: everything is computed in "
       "double "
       "precision"},
      {"name_is_list", kGood + s("name: [a]\n"), "4:7: name: found a list, must be a text"},
      {"name_empty", kGood + s("name: \"\"\n"), "4:7: name: found \"\", must be a text"},
      {"name_escape", kGood + s("name: \"\\e[2J\"\n"),
       "4:7: name: found \"\\x1b[2J\", must have no control characters"},
      {"time_step_beyond_delta", kGood + s("time_step: 2.5\n"),
       "4:12: time_step: found 2.5, must be <= control_time = 2 s where motion is held"},
      {"time_step_beyond_delta_of_the_paper", kGood + s("method: avo_paper\ntime_step: 5\n"),
       "5:12: time_step: found 5, must be <= control_time = 4 s where motion is held"},
      {"time_step_beyond_tau", kGood + s("time_horizon: 0.05\n"),
       "1:1: time_step: found 0.1, must be <= time_horizon = 0.05 s"},
      {"duration_below_step", kGood + s("duration: 0.05\n"),
       "4:11: duration: found 0.05, must be >= time_step = 0.1 s"},
      {"too_many_steps", kGood + s("duration: 1e9\ntime_step: 0.1\n"),
       "4:11: duration: found 1e+09, must be at most 100000000 steps of 0.1 s"},
      {"too_many_usual_steps", s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1e9, 0]}\n"),
       "1:1: found no \"duration\", the usual one of 1e+09 s has more than 100000000 steps, must "
       "be "
       "given"},
      {"coincident",
       s("version: 1\nrobots:\n  - {position: [1, 2], goal: [5, 0]}\n  - {position: [3, 2], goal: "
         "[5, 0]}\n  - {position: [1, 2], goal: [0, 0]}\n"),
       "5:16: robots.2.position: found [1, 2], the position of robots.0, must differ from it"},
      {"car_unknown_key",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], car: {wheel_base: 1}}\n"),
       "3:44: robots.0.car: found the unknown key \"wheel_base\", did you mean \"wheelbase\"? "
       "Allowed are wheelbase, max_curvature, body, reverse, acceleration_set, heading"},
      {"airplane_with_a_clock_of_its_own",
       s("version: 1\nclock: free\nrobots:\n  - {position: [0, 0], goal: [1, 0], airplane: {}}\n"),
       "2:8: clock: found free, must be common in a scene with airplanes"},
      {"two_headings",
       s("version: 1\nrobots:\n"
         "  - {position: [0, 0], goal: [1, 0], heading: 1, car: {heading: 1}}\n"),
       "3:65: robots.0.car.heading: found a second heading, must be given once"},
      {"heading_of_holonomic",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], heading: 1}\n"),
       "3:47: robots.0.heading: found a heading, must be left out: its model is holonomic"},
      {"keys_of_another_model",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], model: holonomic, car: {}}\n"),
       "3:61: robots.0.car: found keys of a car, must be left out: its model is holonomic"},
      {"unknown_model",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], model: cart}\n"),
       "3:45: robots.0.model: found \"cart\", did you mean \"car\"? Must be one of holonomic, car, "
       "differential_drive, airplane"},
      {"footprint_of_a_holonomic_robot",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], footprint: {length: 3, width: "
         "1}}\n"),
       "3:49: robots.0.footprint: found a footprint, must be left out: its model is holonomic, not "
       "car or differential_drive"},
      {"footprint_of_an_airplane",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], airplane: {}, footprint: "
         "{length: 3, width: 1}}\n"),
       "3:63: robots.0.footprint: found a footprint, must be left out: its model is airplane, not "
       "car or differential_drive"},
      {"footprint_too_long",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], car: {}, footprint: {length: "
         "12, width: 1}}\n"),
       "3:58: robots.0.footprint.excess: found 0.25 m, must be >= 0.8 m: so far do 5 discs exceed "
       "the sides"},
      {"footprint_without_width",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], car: {}, footprint: {length: "
         "12}}\n"),
       "3:58: robots.0.footprint: found a map, must have length and width, or a polygon alone"},
      {"footprint_beside_a_body",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], car: {body: {radius: 1}}, "
         "footprint: {length: 3, width: 1}}\n"),
       "3:50: robots.0.car.body: found one, must be left out: it has a footprint"},
      {"footprint_with_free_clocks",
       s("version: 1\nclock: free\nrobots:\n  - {position: [0, 0], goal: [1, 0], car: {}, "
         "footprint: {length: 3, width: 1}}\n"),
       "2:8: clock: found free, must be common with footprints: robots.0.footprint is one"},
      {"body_unknown_key",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], car: {body: {ofset: 1}}}\n"),
       "3:51: robots.0.car.body: found the unknown key \"ofset\", did you mean \"offset\"? Allowed "
       "are offset, radius"},
      {"airplane_unknown_key",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], airplane: {min_spee: 1}}\n"),
       "3:49: robots.0.airplane: found the unknown key \"min_spee\", did you mean \"min_speed\"? "
       "Allowed are min_speed, lateral_acceleration, after_goal"},
      {"airplane_after_goal",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], airplane: {after_goal: "
         "land}}\n"),
       "3:61: robots.0.airplane.after_goal: found \"land\", must be one of loiter, leave"},
      {"airplane_keys_of_a_car",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], model: car, airplane: {}}\n"),
       "3:60: robots.0.airplane: found keys of an airplane, must be left out: its model is car"},
      {"airplane_beside_one_that_cooperates",
       s("version: 1\nsensing_radius: 40\nrobots:\n  - {position: [0, 0], goal: [9, 0], airplane: "
         "{}}\n"
         "  - {position: [50, 0], goal: [50, 0], behavior: cooperates}\n"),
       "5:50: robots.1.behavior: found cooperates, must be decides in a scene with airplanes, "
       "which "
       "cannot stop for it"},
      {"car_heading_word",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], car: {heading: random}}\n"),
       "3:53: robots.0.car.heading: found \"random\", must be a number (rad)"},
      {"drive_of_a_car",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], model: car, drive: {}}\n"),
       "3:57: robots.0.drive: found keys of a differential drive, must be left out: its model is "
       "car"},
      {"drive_unknown_key",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], drive: {trak: 1}}\n"),
       "3:46: robots.0.drive: found the unknown key \"trak\", did you mean \"track\"? Allowed are "
       "track, offset, wheel_speed, wheel_acceleration"},
      {"drive_brakes_too_hard",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], max_acceleration: 2, drive: "
         "{track: 1.5, offset: 1, wheel_acceleration: 2.5}}\n"),
       "3:56: robots.0.max_acceleration: found 2, must be < 2 m/s^2, "
       "wheel_acceleration/sqrt(1 + (track/(2 offset))^2)"},
      {"drive_faster_than_its_wheels",
       s("version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0], max_speed: 1.5, drive: "
         "{wheel_speed: 1.25}}\n"),
       "3:49: robots.0.max_speed: found 1.5, must be <= 1.25 m/s, its drive.wheel_speed"},
      {"drive_starts_faster_than_its_wheels",
       s("version: 1\nrobots:\n  - {position: [0, 0], velocity: [3, 4], goal: [1, 0], drive: "
         "{}}\n"),
       "3:34: robots.0.velocity: found 5 m/s, must be <= 2 m/s, its drive.wheel_speed"},
      {"group_without_number",
       s("version: 1\ngroups:\n  - {placement: circle, goals: antipodal}\n"),
       "3:5: groups.0: found no \"number\", must be given: how many robots"},
      {"group_too_many",
       s("version: 1\ngroups:\n  - {number: 1000000000000000000, placement: circle, goals: "
         "antipodal}\n"),
       "3:14: groups.0.number: found 1000000000000000000, must be <= 1000000"},
      {"groups_too_many",
       s("version: 1\ngroups:\n  - {number: 600000, placement: circle, goals: antipodal}\n  - "
         "{number: 600000, placement: circle, goals: antipodal}\n"),
       "4:14: groups.1.number: found 1200000 robots in all, must be at most 1000000"},
      {"group_with_position",
       s("version: 1\ngroups:\n  - {number: 3, placement: circle, goals: antipodal, position: [0, "
         "0]}\n"),
       "3:54: groups.0: found the unknown key \"position\", allowed are number, placement, goals, "
       "task, jitter, " +
           kGroupRobotKeys},
      {"placement_unknown",
       s("version: 1\ngroups:\n  - {number: 3, placement: cirle, goals: antipodal}\n"),
       "3:28: groups.0.placement: found \"cirle\", did you mean \"circle\"? Must be one of circle, "
       "grid, line, random, ring"},
      {"placement_needs_more",
       s("version: 1\ngroups:\n  - {number: 3, placement: grid, goals: antipodal}\n"),
       "3:28: groups.0.placement.grid: found no \"spacing\", must be given: from robot to robot, "
       "along x and y"},
      {"placement_two",
       s("version: 1\ngroups:\n  - {number: 3, placement: {circle: {}, line: {}}, goals: "
         "antipodal}\n"),
       "3:28: groups.0.placement: found 2 kinds, must be one of circle, grid, line, random, ring"},
      {"placement_unknown_key",
       s("version: 1\ngroups:\n  - {number: 3, placement: {circle: {radius: 3}}, goals: "
         "antipodal}\n"),
       "3:38: groups.0.placement.circle: found the unknown key \"radius\", allowed are center, "
       "min_radius, spacing"},
      {"placement_upside_down",
       s("version: 1\ngroups:\n  - {number: 3, placement: {random: {min: [1, 0], max: [0, 1]}}, "
         "goals: antipodal}\n"),
       "3:37: groups.0.placement.random: found min [1, 0] and max [0, 1], min must not exceed max"},
      {"placement_no_room",
       s("version: 1\ngroups:\n  - {number: 30, placement: {random: {min: [0, 0], max: [2, 2]}}, "
         "goals: antipodal}\n"),
       "3:5: groups.0.placement: found room for 5 of 30, must have room for all: enlarge the "
       "rectangle"},
      {"goals_no_room",
       s("version: 1\ngroups:\n  - {number: 30, placement: circle, goals: {random: {min: [0, 0], "
         "max: [1, 1]}}}\n"),
       "3:5: groups.0.goals: found room for 2 of 30, must have room for all: enlarge the "
       "rectangle"},
      {"goals_with_keys",
       s("version: 1\ngroups:\n  - {number: 3, placement: circle, goals: {antipodal: {center: [0, "
         "0]}}}\n"),
       "3:56: groups.0.goals.antipodal: found the unknown key \"center\", no key is allowed"},
      {"task_unknown",
       s("version: 1\ngroups:\n  - {number: 3, placement: circle, goals: antipodal, task: quee}\n"),
       "3:60: groups.0.task: found \"quee\", did you mean \"queue\"? Must be one of queue, follow, "
       "patrol, flow"},
      {"task_needs_more",
       s("version: 1\ngroups:\n  - {number: 3, placement: circle, goals: antipodal, task: {queue: "
         "{spacing: 1}}}\n"),
       "3:68: groups.0.task.queue: found no \"line\", must be given: from the head of the row "
       "backward"},
      {"task_of_a_short_line",
       s("version: 1\ngroups:\n  - {number: 3, placement: circle, goals: antipodal, task: {queue: "
         "{line: [[1, 1]]}}}\n"),
       "3:60: groups.0.task.line: found 1 points, must be at least 2"},
      {"task_of_half_an_exit",
       s("version: 1\ngroups:\n  - {number: 3, placement: circle, goals: antipodal, task: {flow: "
         "{exits: [[1, 1], [2, 1], [3, 1]]}}}\n"),
       "3:60: groups.0.task.exits: found 3 points, must be two for each exit"},
      {"formation_unknown",
       s("version: 1\ngroups:\n  - {number: 3, placement: circle, goals: {formation: {shape: "
         "wegde, center: [0, 9]}}}\n"),
       "3:63: groups.0.goals.formation.shape: found \"wegde\", did you mean \"wedge\"? Must be one "
       "of line, column, wedge, block, ring"},
      {"line_of_one_point",
       s("version: 1\ngroups:\n  - {number: 3, placement: {line: {from: [1, 1], to: [1, 1]}}, "
         "goals: "
         "antipodal}\n"),
       "3:5: robots.1.position: found [1, 1], the position of robots.0, must differ from it"},
  };
  return scenes;
}

const std::vector<BadScene>& bad_texts() {
  static const std::vector<BadScene> texts{
      {"anchor", s("version: 1\nrobots:\n  - &a {position: [0, 0], goal: [1, 0]}\n"),
       "3:5: found an anchor, anchors, aliases and merge keys are not allowed"},
      {"alias", s("version: 1\nrobots: [*a]\n"),
       "2:10: found text that is not YAML: the referenced anchor is not defined"},
      {"merge_key",
       s("version: 1\nrobots:\n  - {<<: {radius: 1}, position: [0, 0], goal: [1, 0]}\n"),
       "3:6: found a merge key, anchors, aliases and merge keys are not allowed"},
      {"tag", s("version: !!int 1\nrobots:\n  - {position: [0, 0], goal: [1, 0]}\n"),
       "1:10: found the tag tag:yaml.org,2002:int, tags are not allowed"},
      {"key_is_list", s("? [1, 2]\n: 3\n"),
       "1:3: found a list as a key or one that is not closed, keys must be words such as "
       "time_step"},
      {"key_is_empty", s("version: 1\n: 3\n"),
       "2:1: found an empty key, keys must be words such as time_step"},
      {"two_documents", kGood + s("---\nversion: 1\n"),
       "5:1: found a second document, a scene is one document"},
      {"tab", s("version: 1\nrobots:\n\011- {position: [0, 0], goal: [1, 0]}\n"),
       "3:2: found text that is not YAML: illegal block entry"},
      {"unclosed_list", s("version: 1\nrobots: [1, 2\n"),
       "2:1: found text that is not YAML: end of sequence flow not found"},
      {"unclosed_quote", s("version: 1\nname: \"abc\n"),
       "2:11: found text that is not YAML: illegal EOF in scalar"},
      {"bad_indentation", s("version: 1\n  name: a\n"),
       "2:7: found text that is not YAML: illegal map value"},
      {"nul_byte", s("version: 1\nname: a\000b\n"),
       "2:8: found the control character 0x00, must be text"},
      {"bad_utf8", s("version: 1\nname: \"\303(\"\n"),
       "2:8: found the byte 0xc3, must be UTF-8 text"},
      {"utf16", s("\377\376v\000e\000r\000s\000i\000o\000n\000:\000 \0001\000\n\000"),
       "1:1: found the byte 0xff, must be UTF-8 text"},
      {"escape_byte", s("version: 1\nname: \033[2J\n"),
       "2:7: found the control character 0x1b, must be text"},
      {"bom_and_crlf",
       s("\357\273\277version: 1\015\nrobots:\015\n  - {position: [0, 0], goal: [1, 0], radius: "
         "-1}\015\n"),
       "3:46: robots.0.radius: found -1, must be > 0 m"},
      {"bom_is_no_column", s("\357\273\277a\001"),
       "1:2: found the control character 0x01, must be text"},
      {"umlauts_count_as_one",
       s("version: 1\nname: \"\303\244\303\266\303\274\"\nrobots:\n  - "
         "{\"\303\244\303\266\303\274\": 1}\n"),
       s("4:6: robots.0: found the unknown key \"\303\244\303\266\303\274\", allowed are ") +
           kRobotKeys},
      {"nested_too_deep",
       s("version: 1\nrobots: "
         "[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[]]]]]]]]]]]]]]]]]]]"
         "]]"
         "]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]\n"),
       "2:72: found more than 64 levels of nesting"},
  };
  return texts;
}

}  // namespace avo_test
