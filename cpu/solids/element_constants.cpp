#include <glisson/cpu/solids/element_constants.hpp>

#include <cmath>

#include <glisson/core/elements/t4.hpp>

namespace glisson::detail {
namespace {

/// B row by row, then the volume. An order of nodes that turns the tetrahedron inside out only changes the sign of det.
void tetrahedron(std::span<const Vec3<double>> X, double* constants) {
  Mat3<double> edges;  // edges[a][K] = (X_(a+1) - X_0)_K; B is its inverse transposed
  for (std::size_t a = 0; a < 3; ++a) {
    const Vec3<double> edge = X[a + 1] - X[0];
    edges.m[a][0] = edge.x;
    edges.m[a][1] = edge.y;
    edges.m[a][2] = edge.z;
  }
  const Mat3<double> c = cofactor(edges);
  const double det = determinant(edges);
  for (int a = 0; a < 3; ++a)
    for (int k = 0; k < 3; ++k) constants[3 * a + k] = c.m[a][k] / det;
  constants[9] = std::abs(det) / 6;
}

}  // namespace

int constant_count_of(Formulation formulation) {
  switch (formulation) {
    case Formulation::t4: return T4::constant_count;
    case Formulation::t4anp: return T4::constant_count + 1;
    default: return 0;
  }
}

void element_constants(Formulation formulation, std::span<const Vec3<double>> X, const Moduli& moduli, double,
                       double* constants) {
  tetrahedron(X, constants);
  if (formulation == Formulation::t4anp) constants[10] = moduli.bulk;
}

}  // namespace glisson::detail
