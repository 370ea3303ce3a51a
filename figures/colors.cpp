// SPDX-License-Identifier: Apache-2.0
// Colors between the colors of the palette: in Oklab, where equal steps look equal (Bjorn Ottosson,
// 2020).
#include "figures/colors.h"

#include <algorithm>
#include <cmath>

namespace avo::figures {
namespace {

struct Oklab {
  double lightness, a, b;
};

double to_linear(double c) {
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}
double from_linear(double c) {
  const double share = std::clamp(c, 0.0, 1.0);
  return share <= 0.0031308 ? 12.92 * share : 1.055 * std::pow(share, 1.0 / 2.4) - 0.055;
}

Oklab to_lab(Color color) {
  const double r = to_linear(color.red), g = to_linear(color.green), b = to_linear(color.blue);
  const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return {0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s};
}

Color to_color(const Oklab& lab) {
  const double l = lab.lightness + 0.3963377774 * lab.a + 0.2158037573 * lab.b;
  const double m = lab.lightness - 0.1055613458 * lab.a - 0.0638541728 * lab.b;
  const double s = lab.lightness - 0.0894841775 * lab.a - 1.291485548 * lab.b;
  const double lll = l * l * l, mmm = m * m * m, sss = s * s * s;
  return {from_linear(4.0767416621 * lll - 3.3077115913 * mmm + 0.2309699292 * sss),
          from_linear(-1.2684380046 * lll + 2.6097574011 * mmm - 0.3413193965 * sss),
          from_linear(-0.0041960863 * lll - 0.7034186147 * mmm + 1.707614701 * sss)};
}

}  // namespace

Color direction_color(double degrees) {
  constexpr std::array<Color, 7> kCircle{kSky,    kBlue,   kPurple, kVermilion,
                                         kOrange, kYellow, kGreen};
  constexpr double kDarkest = 0.48, kPalest = 0.74;  // lightness
  const double turn = degrees / 360.0;
  const double at = (turn - std::floor(turn)) * static_cast<double>(kCircle.size());
  const std::size_t k = std::min(static_cast<std::size_t>(at), kCircle.size() - 1);
  const double part = at - static_cast<double>(k);
  const Oklab from = to_lab(kCircle[k]), to = to_lab(kCircle[(k + 1) % kCircle.size()]);
  const auto between = [part](double a, double b) { return a + part * (b - a); };
  return to_color({std::clamp(between(from.lightness, to.lightness), kDarkest, kPalest),
                   between(from.a, to.a), between(from.b, to.b)});
}

Color color_of(std::size_t index, std::size_t count) {
  if (count <= kFew.size()) return kFew[index];
  return direction_color(360.0 * static_cast<double>(index) / static_cast<double>(count));
}

}  // namespace avo::figures
