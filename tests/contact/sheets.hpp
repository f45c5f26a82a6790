// Membranes that touch: added to models of bodies, and whether surfaces cross.
#pragma once

#include <span>

#include <tests/contact/bodies.hpp>
#include <tests/contact/overlap_check.hpp>
#include <tests/shells/sheets.hpp>

namespace glisson::test {

/// Appends a sheet of n x m cells as a body of its own; X maps [0, 1]^2.
inline Body add_sheet(Model& model, int n, int m, const std::function<Vec3<double>(double, double)>& X,
                      const ShellSection& section) {
  const Model its = sheet(n, m, X, section);
  const Body body{model.mesh.node_count(), its.mesh.node_count()};
  const int first = static_cast<int>(model.mesh.triangles.size());
  const int count = static_cast<int>(its.mesh.triangles.size());
  model.mesh.X.insert(model.mesh.X.end(), its.mesh.X.begin(), its.mesh.X.end());
  for (auto t : its.mesh.triangles) {
    for (int& k : t) k += body.first_node;
    model.mesh.triangles.push_back(t);
  }
  ShellSection own = its.shells[0];
  own.name = "sheet " + std::to_string(model.shells.size());
  for (int& e : own.elements) e += first;
  model.bodies_by_name.push_back({own.name, 0, 0, first, count});
  model.shells.push_back(own);
  return body;
}

/// A flat square sheet about the origin at the height z.
inline Body add_flat_sheet(Model& model, int n, double size, double z, const ShellSection& section) {
  return add_sheet(
      model, n, n,
      [=](double s, double t) {
        return Vec3<double>{size * (s - 0.5), size * (t - 0.5), z};
      },
      section);
}

using Triangles = std::vector<std::array<int, 3>>;

/// Outer facets of solids, cut along a diagonal, and shell triangles whose nodes all belong to a body.
inline Triangles triangles_of(const Mesh& mesh, const Body& body) {
  Triangles all(mesh.triangles), its;
  for (const auto& t : contact::split_facets(outer_surface(mesh), mesh.X)) all.push_back(t);
  for (const auto& t : all)
    if (std::all_of(t.begin(), t.end(),
                    [&](int n) { return n >= body.first_node && n < body.first_node + body.node_count; }))
      its.push_back(t);
  return its;
}

inline bool goes_through(const Vec3<double>& p, const Vec3<double>& q, const Vec3<double>& a,
                         const Vec3<double>& b, const Vec3<double>& c) {
  const auto volume = [](const Vec3<double>& x, const Vec3<double>& y, const Vec3<double>& z) {
    return dot(x, cross(y, z));
  };
  if (!(volume(p - a, b - a, c - a) * volume(q - a, b - a, c - a) < 0)) return false;
  const double s = volume(q - p, a - p, b - p), t = volume(q - p, b - p, c - p),
               w = volume(q - p, c - p, a - p);
  return (s > 0 && t > 0 && w > 0) || (s < 0 && t < 0 && w < 0);
}

/// Edges of one set of triangles that go through triangles of the other, those that share a node left out.
inline int crossings(const std::vector<Vec3<double>>& x, const Triangles& a, const Triangles& b) {
  const auto at = [&](int n) { return x[std::size_t(n)]; };
  int count = 0;
  const auto count_edges = [&](const Triangles& edges, const Triangles& facets) {
    for (const auto& [p, q] : contact::edges_of(edges)) {
      const contact::Box box = united(united(contact::Box{}, at(p)), at(q));
      for (const auto& t : facets) {
        if (std::any_of(t.begin(), t.end(), [&, p = p, q = q](int n) { return n == p || n == q; })) continue;
        const contact::Box other = united(united(united(contact::Box{}, at(t[0])), at(t[1])), at(t[2]));
        count += overlap(box, other) && goes_through(at(p), at(q), at(t[0]), at(t[1]), at(t[2]));
      }
    }
  };
  count_edges(a, b);
  if (&a != &b) count_edges(b, a);
  return count;
}

/// Smallest distance from nodes of one set of triangles to triangles of the other, both ways [m].
inline double least_distance(const std::vector<Vec3<double>>& x, const Triangles& a, const Triangles& b) {
  const auto at = [&](int n) { return x[std::size_t(n)]; };
  double squared = 1e300;
  const auto measure = [&](const Triangles& nodes, const Triangles& facets) {
    for (const auto& its : nodes)
      for (const int n : its)
        for (const auto& t : facets)
          squared = std::min(
              squared, contact::closest_on_triangle(at(n), at(t[0]), at(t[1]), at(t[2])).distance_squared);
  };
  measure(a, b);
  measure(b, a);
  return std::sqrt(squared);
}

}  // namespace glisson::test
