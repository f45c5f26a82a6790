// Mesh: array sizes, indices, inverted, flat and badly shaped elements, nodes that nothing holds.
#include <glisson/core/validation/checks.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace glisson::detail {
namespace {

bool finite(const Vec3<double>& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

double length_squared(const Vec3<double>& v) { return dot(v, v); }

std::string element_text(int e, Formulation formulation) {
  return "element " + std::to_string(e) + " (" + name_of(formulation) + ")";
}

[[noreturn]] void refuse_volume(int e, Formulation formulation, double volume) {
  const bool flat = volume >= 0;
  refuse(element_text(e, formulation),
         "its volume is " + number_text(volume) + (flat ? ": it is flat" : ": it is inverted") +
             ", so it has no mass or stiffness of its own; correct the order of its nodes or "
             "the mesh");
}

struct Box {
  Vec3<double> low, high;
};

Box bounds(const std::vector<Vec3<double>>& X) {
  Box box{X.front(), X.front()};
  for (const auto& x : X) {
    box.low = {std::min(box.low.x, x.x), std::min(box.low.y, x.y), std::min(box.low.z, x.z)};
    box.high = {std::max(box.high.x, x.x), std::max(box.high.y, x.y), std::max(box.high.z, x.z)};
  }
  return box;
}

/// Corners of a hexahedron in its own coordinates (xi, eta, zeta = -1 or 1).
constexpr int corner_sign[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                   {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};

/// det dX/dxi of the trilinear map at a point.
double jacobian(const std::array<Vec3<double>, 8>& X, const std::array<double, 3>& xi) {
  Mat3<double> J{};
  for (std::size_t a = 0; a < 8; ++a)
    for (std::size_t k = 0; k < 3; ++k) {
      double dN = 0.125 * corner_sign[a][k];
      for (std::size_t l = 0; l < 3; ++l)
        if (l != k) dN *= 1 + corner_sign[a][l] * xi[l];
      J.m[0][k] += dN * X[a].x;
      J.m[1][k] += dN * X[a].y;
      J.m[2][k] += dN * X[a].z;
    }
  return determinant(J);
}

/// 12 (3 V)^(2/3) / sum of the squared edges: 1 for the regular tetrahedron, 0 for a flat one (Liu & Joe
/// 1994).
double tetrahedron_quality(const std::array<Vec3<double>, 4>& X, double volume) {
  double edges = 0;
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = 0; b < a; ++b) edges += length_squared(X[a] - X[b]);
  return edges > 0 ? 12 * std::cbrt(9 * volume * volume) / edges : 0;
}

// Below these an element is as good as flat: its volume is rounding error of its edges.
constexpr double flat_quality = 1e-6;
constexpr double sliver_quality = 0.1;

double check_tetrahedron(const Mesh& mesh, int e, Formulation formulation) {
  const auto nodes = mesh.element(e);
  std::array<Vec3<double>, 4> X;
  for (std::size_t a = 0; a < 4; ++a) X[a] = mesh.X[static_cast<std::size_t>(nodes[a])];
  const double volume = dot(cross(X[1] - X[0], X[2] - X[0]), X[3] - X[0]) / 6;
  if (!(volume > 0)) refuse_volume(e, formulation, volume);
  const double quality = tetrahedron_quality(X, volume);
  if (quality < flat_quality) refuse_volume(e, formulation, volume);
  return quality;
}

/// Smallest corner Jacobian over the largest. One-point elements need it at the centre, H8Full at its 8
/// points.
double check_hexahedron(const Mesh& mesh, int e, Formulation formulation) {
  const auto nodes = mesh.element(e);
  std::array<Vec3<double>, 8> X;
  for (std::size_t a = 0; a < 8; ++a) X[a] = mesh.X[static_cast<std::size_t>(nodes[a])];
  const double g = 1 / std::sqrt(3.0);
  double volume = 0, smallest = std::numeric_limits<double>::infinity(), largest = 0,
         smallest_point = smallest;
  for (const auto& sign : corner_sign) {
    const double at_point = jacobian(X, {g * sign[0], g * sign[1], g * sign[2]});
    const double at_corner = jacobian(X, {1.0 * sign[0], 1.0 * sign[1], 1.0 * sign[2]});
    volume += at_point;  // 2x2x2 points integrate the trilinear map's volume exactly
    smallest_point = std::min(smallest_point, at_point);
    smallest = std::min(smallest, at_corner);
    largest = std::max(largest, at_corner);
  }
  if (!(volume > flat_quality * largest) || !(jacobian(X, {0, 0, 0}) > 0))
    refuse_volume(e, formulation, std::min(volume, jacobian(X, {0, 0, 0})));
  if (formulation == Formulation::h8_full && !(smallest_point > 0))
    refuse(element_text(e, formulation), "it is folded: the Jacobian at one of its integration points is " +
                                             number_text(smallest_point) +
                                             "; correct its nodes, or use the one-point element H8 for it");
  return smallest / largest;
}

}  // namespace

void check_mesh_arrays(const Mesh& mesh) {
  const auto elements = mesh.shape.size();
  if ((elements == 0 && mesh.triangles.empty()) || mesh.X.empty())
    refuse("mesh", "it has no elements, so there is nothing to simulate");
  if (mesh.begin.size() != elements + 1 || mesh.begin[0] != 0 ||
      static_cast<std::size_t>(mesh.begin.back()) != mesh.nodes.size())
    refuse("mesh", "the table of first nodes does not fit the elements");
  if (!mesh.label.empty() && mesh.label.size() != elements)
    refuse("mesh", "it has " + std::to_string(mesh.label.size()) + " labels for " + std::to_string(elements) +
                       " elements");
  for (std::size_t n = 0; n < mesh.X.size(); ++n)
    if (!finite(mesh.X[n])) refuse("node " + std::to_string(n), "its position is not finite");
  for (std::size_t e = 0; e < elements; ++e) {
    if (mesh.begin[e + 1] - mesh.begin[e] != node_count_of(mesh.shape[e]))
      refuse("element " + std::to_string(e), "its number of nodes does not fit its shape");
    const auto nodes = mesh.element(static_cast<int>(e));
    for (const int n : nodes) {
      if (n < 0 || n >= mesh.node_count())
        refuse("element " + std::to_string(e), "it uses node " + std::to_string(n) +
                                                   ", but the nodes are 0 to " +
                                                   std::to_string(mesh.node_count() - 1));
      if (std::count(nodes.begin(), nodes.end(), n) > 1)
        refuse("element " + std::to_string(e),
               "it uses node " + std::to_string(n) +
                   " twice; collapsed elements are not supported, mesh that place with tetrahedra");
    }
  }
}

void check_elements(const Mesh& mesh, const std::vector<Formulation>& formulation, Warnings& warnings) {
  int slivers = 0, worst = -1;
  double worst_quality = sliver_quality;
  for (int e = 0; e < mesh.element_count(); ++e) {
    const auto f = formulation[static_cast<std::size_t>(e)];
    const double quality =
        shape_of(f) == Shape::tetrahedron ? check_tetrahedron(mesh, e, f) : check_hexahedron(mesh, e, f);
    if (quality >= sliver_quality) continue;
    ++slivers;
    if (quality < worst_quality) {
      worst_quality = quality;
      worst = e;
    }
  }
  if (slivers > 0)
    warnings.push_back(std::to_string(slivers) + " elements are badly shaped (quality below " +
                       number_text(sliver_quality) + "; the worst is element " + std::to_string(worst) +
                       " with " + number_text(worst_quality, 3) +
                       "): they limit the time step and lose accuracy; improve the mesh there");
}

void check_nodes(const Model& model, Warnings& warnings) {
  const Mesh& mesh = model.mesh;
  std::vector<char> used(mesh.X.size(), 0);
  for (const int n : mesh.nodes) used[static_cast<std::size_t>(n)] = 1;
  for (const auto& triangle : mesh.triangles)
    for (const int n : triangle) used[static_cast<std::size_t>(n)] = 1;
  const auto unused = std::count(used.begin(), used.end(), 0);
  if (unused > 0) {
    const auto first = std::find(used.begin(), used.end(), 0) - used.begin();
    warnings.push_back(std::to_string(unused) + " nodes belong to no element (the first is node " +
                       std::to_string(first) + "): they have no mass and are held fixed");
  }
  const Box box = bounds(mesh.X);
  const auto extent = box.high - box.low;
  const double cell =
      1e-9 * std::max({extent.x, extent.y, extent.z, std::numeric_limits<double>::min() * 1e9});
  using Key = std::array<std::int64_t, 4>;
  std::vector<Key> keys;
  for (std::size_t n = 0; n < mesh.X.size(); ++n) {
    if (used[n] == 0) continue;
    const auto x = (1 / cell) * (mesh.X[n] - box.low);
    keys.push_back({std::llround(x.x), std::llround(x.y), std::llround(x.z), static_cast<std::int64_t>(n)});
  }
  std::sort(keys.begin(), keys.end());
  std::int64_t twins = 0, example = -1;
  for (std::size_t i = 1; i < keys.size(); ++i)
    if (std::equal(keys[i].begin(), keys[i].begin() + 3, keys[i - 1].begin())) {
      if (twins++ == 0) example = static_cast<std::int64_t>(i);
    }
  if (twins > 0) {
    const auto i = static_cast<std::size_t>(example);
    warnings.push_back(std::to_string(twins) + " nodes lie where another one lies (nodes " +
                       std::to_string(keys[i - 1][3]) + " and " + std::to_string(keys[i][3]) +
                       " for example): the parts there are not connected; merge them if they should be");
  }
}

}  // namespace glisson::detail
