// Perceptually uniform colours: paths in the OKLab space (Ottosson 2020), where equal distances look equal.
#pragma once

#include <array>

namespace glisson::viz {

using Rgb = std::array<double, 3>;  ///< sRGB, 0..1

/// From dark blue over green to light yellow: lightness grows linearly, so it also reads in grey. t in 0..1.
Rgb sequential_colour(double t);
/// Blue, light grey in the middle, red; for values that matter by their distance from a middle.
Rgb diverging_colour(double t);
/// Region k, all equally light, hues a golden angle apart.
Rgb region_colour(int k);

}  // namespace glisson::viz
