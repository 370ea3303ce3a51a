// SPDX-License-Identifier: Apache-2.0
// Each function makes one figure of the paper in a folder and says what it shows.
#pragma once
#include <string>
#include <vector>

namespace avo::paper {

/// One figure and what there is to say about it, in Markdown.
struct Caption {
  std::string number;  ///< as in the paper: "3"
  std::string file;    ///< within the folder
  std::string title;
  std::string shows;    ///< what is drawn, with its numbers
  std::string agrees;   ///< with the paper
  std::string differs;  ///< from the paper
  /// What is drawn, each with the hash of the state that it ends in, as tools/check_figures.py
  /// reads it: "circle-100 method=avo_paper 0x0123456789abcdef".
  std::vector<std::string> runs = {};
};

Caption draw_velocity_obstacle(const std::string& folder);      // Fig. 2
Caption draw_acceleration_obstacle(const std::string& folder);  // Fig. 3
Caption draw_reciprocal_sets(const std::string& folder);        // Fig. 5
Caption draw_among_obstacles(const std::string& folder);        // Fig. 4
Caption draw_half_planes(const std::string& folder);            // Fig. 6(a)
Caption draw_car_accelerations(const std::string& folder);      // Fig. 6(b)
Caption draw_exchange(const std::string& folder);               // Fig. 1
Caption draw_moving_obstacle(const std::string& folder);        // Fig. 7
Caption draw_circle(const std::string& folder);                 // Fig. 8
Caption draw_cars(const std::string& folder);                   // Fig. 9
Caption draw_speed(const std::string& folder);                  // Fig. 10

/// A figure of docs/states.md; returns its path.
std::string draw_states(const std::string& folder);

/// Writes what a figure's file is to hold.
void save(const std::string& path, const std::string& bytes);

/// printf with the value of a double: format("%.2f m", x).
std::string format(const char* pattern, double value);

}  // namespace avo::paper
