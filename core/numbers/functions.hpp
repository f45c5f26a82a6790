// The only transcendental functions that laws may use. Built-in numbers have their overloads here; packs and
// duals bring theirs, found by argument-dependent lookup. No std::pow, no branch on R: use select.
#pragma once

#include <cmath>

#include <glisson/core/base/host_device.hpp>

namespace glisson {

/// x^(-1/3) for x > 0; NaN for x <= 0 (an inverted element must not look healthy).
GLISSON_HD inline double rcbrt(double x) { return x > 0 ? 1 / ::cbrt(x) : NAN; }
GLISSON_HD inline float rcbrt(float x) { return x > 0 ? 1 / ::cbrtf(x) : NAN; }

GLISSON_HD inline double square_root(double x) { return ::sqrt(x); }
GLISSON_HD inline float square_root(float x) { return ::sqrtf(x); }
GLISSON_HD inline double log_1p(double x) { return ::log1p(x); }
GLISSON_HD inline float log_1p(float x) { return ::log1pf(x); }
GLISSON_HD inline double exp_m1(double x) { return ::expm1(x); }
GLISSON_HD inline float exp_m1(float x) { return ::expm1f(x); }

/// condition ? a : b, lane by lane for packs. Comparisons of packs give the mask type.
GLISSON_HD inline double select(bool condition, double a, double b) { return condition ? a : b; }
GLISSON_HD inline float select(bool condition, float a, float b) { return condition ? a : b; }

}  // namespace glisson
