// SPDX-License-Identifier: Apache-2.0
// Each function draws one figure of the paper in a folder, and describes what it shows.
#pragma once
#include <string>
#include <vector>

namespace avo::paper {

/// One figure and its description, in Markdown.
struct Caption {
  std::string number;  ///< the number in the paper: "3"
  std::string file;    ///< path within the folder
  std::string title;
  std::string shows;    ///< what is drawn, with its numbers
  std::string agrees;   ///< how it agrees with the paper
  std::string differs;  ///< how it differs from the paper
  /// The runs that are drawn, each with the hash of its final state, as tools/check_figures.py
  /// reads it: "circle-100 method=avo_paper 0x0123456789abcdef".
  std::vector<std::string> runs = {};
};

Caption draw_velocity_obstacle(const std::string& folder);      // Fig. 2
Caption draw_acceleration_obstacle(const std::string& folder);  // Fig. 3
Caption draw_reciprocal_sets(const std::string& folder);        // Fig. 5
Caption draw_among_movers(const std::string& folder);           // Fig. 4
Caption draw_half_planes(const std::string& folder);            // Fig. 6(a)
Caption draw_car_accelerations(const std::string& folder);      // Fig. 6(b)
Caption draw_exchange(const std::string& folder);               // Fig. 1
Caption draw_moving_obstacle(const std::string& folder);        // Fig. 7
Caption draw_circle(const std::string& folder);                 // Fig. 8
Caption draw_cars(const std::string& folder);                   // Fig. 9
Caption draw_speed(const std::string& folder);                  // Fig. 10

/// Draws a figure of docs/states.md and returns its path.
std::string draw_states(const std::string& folder);

/// Writes the contents of a figure's file.
void save(const std::string& path, const std::string& bytes);

/// Formats a double like printf: format("%.2f m", x).
std::string format(const char* pattern, double value);

}  // namespace avo::paper
