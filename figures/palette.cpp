// SPDX-License-Identifier: Apache-2.0
// Median cut over the colors of a picture.
#include "figures/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace avo::figures {
namespace {

constexpr std::size_t kMostColors = 256;

struct Shade {
  std::uint32_t color = 0;
  double count = 0.0;
};

double channel(std::uint32_t color, int shift) {
  return static_cast<double>((color >> shift) & 0xFFU);
}

// A range of shades that will become one color, and the best place to split it.
struct Group {
  std::size_t begin, end;
  int shift = 0;        // of the channel that varies most
  double spread = 0.0;  // sum of squared deviations in it
  double mean = 0.0;    // of that channel
};

Group make_group(const std::vector<Shade>& shades, std::size_t begin, std::size_t end) {
  Group group{begin, end};
  for (const int shift : {16, 8, 0}) {
    double count = 0.0, sum = 0.0, squares = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      const double value = channel(shades[i].color, shift);
      count += shades[i].count;
      sum += shades[i].count * value;
      squares += shades[i].count * value * value;
    }
    const double mean = sum / count;
    const double spread = squares - sum * mean;
    if (spread > group.spread || shift == 16) {
      group.shift = shift;
      group.spread = end - begin > 1 ? spread : 0.0;
      group.mean = mean;
    }
  }
  return group;
}

std::uint32_t color_of(const std::vector<Shade>& shades, const Group& group) {
  double count = 0.0;
  std::array<double, 3> sum{};
  const Shade* commonest = &shades[group.begin];
  for (std::size_t i = group.begin; i < group.end; ++i) {
    count += shades[i].count;
    for (std::size_t c = 0; c < 3; ++c) {
      sum[c] += shades[i].count * channel(shades[i].color, static_cast<int>(8 * c));
    }
    if (shades[i].count > commonest->count) commonest = &shades[i];
  }
  if (commonest->count >= 0.5 * count) return commonest->color;
  std::uint32_t color = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    color |= static_cast<std::uint32_t>(std::lround(sum[c] / count)) << (8 * c);
  }
  return color;
}

std::vector<Shade> distinct(std::span<const std::uint32_t> pixels) {
  std::vector<std::uint32_t> sorted(pixels.begin(), pixels.end());
  for (std::uint32_t& color : sorted) color &= 0xFFFFFFU;
  std::sort(sorted.begin(), sorted.end());
  std::vector<Shade> shades;
  for (const std::uint32_t color : sorted) {
    if (shades.empty() || shades.back().color != color) shades.push_back({color, 0.0});
    shades.back().count += 1.0;
  }
  return shades;
}

// Splits the group that varies most at its mean, until there are enough groups.
std::vector<Group> cut(std::vector<Shade>& shades) {
  std::vector<Group> groups;
  if (!shades.empty()) groups.push_back(make_group(shades, 0, shades.size()));
  const std::size_t wanted = std::min(kMostColors, shades.size());
  while (groups.size() < wanted) {
    const auto widest =
        std::max_element(groups.begin(), groups.end(),
                         [](const Group& a, const Group& b) { return a.spread < b.spread; });
    const Group group = *widest;
    const auto at = [&shades](std::size_t i) {
      return shades.begin() + static_cast<std::ptrdiff_t>(i);
    };
    const auto cut_at = std::partition(at(group.begin), at(group.end), [&group](const Shade& s) {
      return channel(s.color, group.shift) <= group.mean;
    });
    const auto middle = static_cast<std::size_t>(cut_at - shades.begin());
    if (middle == group.begin || middle == group.end) break;  // the whole group has one color
    *widest = make_group(shades, group.begin, middle);
    groups.push_back(make_group(shades, middle, group.end));
  }
  return groups;
}

}  // namespace

IndexedImage reduce_colors(std::span<const std::uint32_t> pixels) {
  std::vector<Shade> shades = distinct(pixels);
  std::vector<std::uint32_t> colors;
  colors.reserve(shades.size());
  for (const Shade& shade : shades) colors.push_back(shade.color);  // ascending
  const std::vector<Group> groups = cut(shades);

  IndexedImage image;
  std::vector<std::uint8_t> index_of(colors.size());
  for (const Group& group : groups) {
    for (std::size_t i = group.begin; i < group.end; ++i) {
      const auto entry = std::lower_bound(colors.begin(), colors.end(), shades[i].color);
      index_of[static_cast<std::size_t>(entry - colors.begin())] =
          static_cast<std::uint8_t>(image.palette.size());
    }
    image.palette.push_back(color_of(shades, group));
  }
  image.index.reserve(pixels.size());
  for (const std::uint32_t pixel : pixels) {
    const auto entry = std::lower_bound(colors.begin(), colors.end(), pixel & 0xFFFFFFU);
    image.index.push_back(index_of[static_cast<std::size_t>(entry - colors.begin())]);
  }
  return image;
}

}  // namespace avo::figures
