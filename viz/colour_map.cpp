#include <glisson/viz/colour_map.hpp>

#include <algorithm>
#include <cmath>

namespace glisson::viz {
namespace {

double gamma(double linear) {
  const double v = std::clamp(linear, 0.0, 1.0);
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

/// OKLCh to sRGB: lightness 0..1, chroma, hue [degrees]. The matrices are Ottosson's.
Rgb from_oklch(double lightness, double chroma, double hue) {
  const double angle = hue * std::acos(-1.0) / 180;
  const double a = chroma * std::cos(angle), b = chroma * std::sin(angle);
  const auto cube = [](double v) { return v * v * v; };
  const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
  return {gamma(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          gamma(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          gamma(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

}  // namespace

Rgb sequential_colour(double t) {
  t = std::clamp(t, 0.0, 1.0);
  // Chroma stays within what sRGB has at this lightness and hue.
  return from_oklch(0.36 + 0.55 * t, 0.115, 290 - 185 * t);
}

Rgb diverging_colour(double t) {
  const double d = 2 * std::clamp(t, 0.0, 1.0) - 1, strength = std::abs(d);
  return from_oklch(0.92 - 0.42 * strength, 0.16 * strength, d < 0 ? 255 : 28);
}

Rgb region_colour(int k) { return from_oklch(0.72, 0.12, std::fmod(28 + 137.50776 * k, 360)); }

}  // namespace glisson::viz
