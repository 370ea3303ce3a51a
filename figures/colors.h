// SPDX-License-Identifier: Apache-2.0
// The colors of data in all figures and videos: those of Okabe and Ito, which people with any color
// vision can tell apart. Python (avo/_colors.py) and the lab (map/colors.ts) have the same ones; a
// test compares them.
#pragma once
#include <array>
#include <cstddef>

#include "figures/canvas.h"

namespace avo::figures {

constexpr Color rgb(unsigned hex) {
  return {((hex >> 16U) & 0xFFU) / 255.0, ((hex >> 8U) & 0xFFU) / 255.0, (hex & 0xFFU) / 255.0};
}

inline constexpr Color kBlue = rgb(0x0072b2);
inline constexpr Color kSky = rgb(0x56b4e9);
inline constexpr Color kGreen = rgb(0x009e73);
inline constexpr Color kYellow = rgb(0xf0e442);
inline constexpr Color kOrange = rgb(0xe69f00);
inline constexpr Color kVermilion = rgb(0xd55e00);
inline constexpr Color kPurple = rgb(0xcc79a7);

/// In this order for a few robots, curves or methods; yellow is too pale for lines on white.
inline constexpr std::array<Color, 6> kFew{kBlue, kVermilion, kGreen, kPurple, kOrange, kSky};

/// Returns the color of a direction, on a circle of the colors above; the angle is taken modulo 360
/// degrees. Opposite directions differ most, and no color is too pale for a white page.
Color direction_color(double degrees);

/// Returns colors that differ as much as possible: of kFew if these are enough, else of directions.
Color color_of(std::size_t index, std::size_t count);

}  // namespace avo::figures
