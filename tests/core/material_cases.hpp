// What the tests of the constitutive laws share: example parameters, random deformation, and norms.
#pragma once

#include <algorithm>
#include <cmath>
#include <glisson/core/materials/laws.hpp>
#include <glisson/core/numbers/dual.hpp>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace glisson::test {

/// Parameters of a soft, nearly incompressible tissue for each law, all exact in float so that precisions
/// compare.
inline std::vector<double> example_parameters(const std::string& law) {
  if (law == "NH") return {1024, 49152};
  if (law == "LE") return {3072, 0.4375};
  if (law == "AB") return {1024, 1.25, 49152};
  if (law == "PY") return {192, 320, 160, 112, 96, 49152};
  if (law == "TI") return {1024, 49152, 4096, 1, 2, -1};
  if (law == "OG") return {1024, 2.5, -320, -3, 96, 0.5, 49152};
  return {};
}

template <class L, class R>
L example() {
  const std::vector<double> parameters = example_parameters(L::name);
  std::vector<R> p;
  for (const double value : parameters) p.push_back(R(static_cast<float>(value)));
  return L::load(p.data());
}

/// Matrix algebra of the tests, independent of the engine's.
using Matrix = Mat3<double>;
inline Matrix identity() { return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; }
inline Matrix transpose(const Matrix& A) {
  Matrix B;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) B.m[i][k] = A.m[k][i];
  return B;
}
inline Matrix minus_identity(Matrix A) {
  for (int i = 0; i < 3; ++i) A.m[i][i] -= 1;
  return A;
}
inline Matrix diagonal(double a, double b, double c) { return {{{a, 0, 0}, {0, b, 0}, {0, 0, c}}}; }

/// Rotation by a random unit quaternion.
inline Matrix random_rotation(std::mt19937& random) {
  std::normal_distribution<double> normal;
  double q[4], sum = 0;
  for (double& value : q) value = normal(random), sum += value * value;
  for (double& value : q) value /= std::sqrt(sum);
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

/// H of independent entries in [-size, size], rounded to float so that precisions compare.
inline Matrix random_gradient(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> entry(-size, size);
  Matrix H;
  for (auto& row : H.m)
    for (double& value : row) value = static_cast<float>(entry(random));
  return H;
}

/// H of principal stretches in [0.5, 2] between two random rotations, rounded to float.
inline Matrix random_large_gradient(std::mt19937& random) {
  std::uniform_real_distribution<double> log_stretch(-std::log(2.0), std::log(2.0));
  const Matrix stretch =
      diagonal(std::exp(log_stretch(random)), std::exp(log_stretch(random)), std::exp(log_stretch(random)));
  Matrix H = minus_identity(random_rotation(random) * stretch * random_rotation(random));
  for (auto& row : H.m)
    for (double& value : row) value = static_cast<float>(value);
  return H;
}

template <class R>
Mat3<R> convert(const Matrix& A) {
  Mat3<R> B;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) B.m[i][k] = R(static_cast<R>(A.m[i][k]));
  return B;
}
template <class R>
Matrix to_double(const Mat3<R>& A) {
  Matrix B;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) B.m[i][k] = double(A.m[i][k]);
  return B;
}

/// Largest |entry|; NaN if one is NaN.
inline double largest(const Matrix& A) {
  double size = 0;
  for (const auto& row : A.m)
    for (const double value : row) size = std::isnan(value) ? value : std::max(size, std::fabs(value));
  return size;
}
inline double largest_difference(const Matrix& A, const Matrix& B) {
  Matrix D;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) D.m[i][k] = A.m[i][k] - B.m[i][k];
  return largest(D);
}

}  // namespace glisson::test
