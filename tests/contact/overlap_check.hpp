// How deep bodies of tetrahedra or hexahedra lie in each other or in themselves, from geometry alone: points
// of the surface in elements that they do not belong to.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <glisson/contact/bvh/box.hpp>
#include <glisson/contact/geometry/closest_points.hpp>
#include <glisson/contact/geometry/triangles.hpp>
#include <glisson/core/any_simulation.hpp>
#include <glisson/core/mesh/surface.hpp>

namespace glisson::test {

inline std::vector<Vec3<double>> positions(const AnySimulation& simulation, const Mesh& mesh) {
  auto x = simulation.displacement();
  for (std::size_t n = 0; n < x.size(); ++n) x[n] = x[n] + mesh.X[n];
  return x;
}

/// Looks at nodes and at points of edges: surfaces can cross there without a node inside. Quadrilaterals are
/// cut about their centres, as contact cuts them, and hexahedra into the tetrahedra from there to their own.
class OverlapCheck {
 public:
  explicit OverlapCheck(const Mesh& mesh) : mesh_(mesh) {
    for (const Facet& facet : outer_surface(mesh)) {
      const auto& n = facet.nodes;
      if (facet.node_count() == 3) {
        triangles_.push_back({n[0], n[1], n[2]});
        continue;
      }
      const int centre = mean_of({n.begin(), n.end()});
      for (std::size_t k = 0; k < 4; ++k) triangles_.push_back({n[k], n[(k + 1) % 4], centre});
    }
    edges_ = contact::edges_of(triangles_);
    for (int e = 0; e < mesh.element_count(); ++e) cut(e);
  }

  /// Largest distance to the surface of a surface point in a foreign element [m]; x: positions [node_count]
  double deepest(const std::vector<Vec3<double>>& x) {
    x_ = x;
    for (const auto& nodes : means_) {
      Vec3<double> sum;
      for (const int n : nodes) sum = sum + (1.0 / double(nodes.size())) * x[std::size_t(n)];
      x_.push_back(sum);
    }
    boxes_.assign(tetrahedra_.size(), {});
    for (std::size_t i = 0; i < boxes_.size(); ++i)
      for (const int n : tetrahedra_[i].corner) boxes_[i] = united(boxes_[i], at(n));
    double depth = 0;
    for (const auto& [a, b] : edges_)
      for (const double s : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const auto p = (1 - s) * at(a) + s * at(b);
        if (in_a_foreign_element(p, a, b)) depth = std::max(depth, to_the_surface(p, a, b));
      }
    return depth;
  }

 private:
  struct Tetrahedron {
    std::array<int, 4> corner;
    int element;
  };
  const Vec3<double>& at(int n) const { return x_[std::size_t(n)]; }
  int mean_of(std::vector<int> nodes) {
    means_.push_back(std::move(nodes));
    return mesh_.node_count() + static_cast<int>(means_.size()) - 1;
  }
  void cut(int e) {
    const auto n = mesh_.element(e);
    if (n.size() == 4) {
      tetrahedra_.push_back({{n[0], n[1], n[2], n[3]}, e});
      return;
    }
    constexpr std::size_t faces[6][4] = {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                         {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    const int centre = mean_of({n.begin(), n.end()});
    for (const auto& f : faces) {
      const int of_face = mean_of({n[f[0]], n[f[1]], n[f[2]], n[f[3]]});
      for (std::size_t k = 0; k < 4; ++k)
        tetrahedra_.push_back({{n[f[k]], n[f[(k + 1) % 4]], of_face, centre}, e});
    }
  }
  bool in_tetrahedron(const Vec3<double>& p, const std::array<int, 4>& c) const {
    for (std::size_t k = 0; k < 4; ++k) {
      const auto &a = at(c[(k + 1) % 4]), &b = at(c[(k + 2) % 4]), &d = at(c[(k + 3) % 4]);
      const auto n = cross(b - a, d - a);
      if (dot(n, p - a) * dot(n, at(c[k]) - a) <= 0) return false;
    }
    return true;
  }
  /// An element is foreign to an edge with which it shares no node; a facet's centre stands for its corners.
  bool shares(int element, int point) const {
    const auto its = mesh_.element(element);
    const auto has = [&](int n) { return std::find(its.begin(), its.end(), n) != its.end(); };
    if (point < mesh_.node_count()) return has(point);
    const auto& corners = means_[std::size_t(point - mesh_.node_count())];
    return std::any_of(corners.begin(), corners.end(), has);
  }
  bool in_a_foreign_element(const Vec3<double>& p, int a, int b) const {
    for (std::size_t i = 0; i < tetrahedra_.size(); ++i) {
      const auto& [corner, element] = tetrahedra_[i];
      if (contains(boxes_[i], p) && in_tetrahedron(p, corner) && !shares(element, a) && !shares(element, b))
        return true;
    }
    return false;
  }
  double to_the_surface(const Vec3<double>& p, int a, int b) const {
    double squared = 1e300;
    for (const auto& t : triangles_) {
      if (std::any_of(t.begin(), t.end(), [&](int k) { return k == a || k == b; })) continue;
      squared =
          std::min(squared, contact::closest_on_triangle(p, at(t[0]), at(t[1]), at(t[2])).distance_squared);
    }
    return std::sqrt(squared);
  }

  const Mesh& mesh_;
  std::vector<std::vector<int>> means_;  ///< nodes of points beyond those of the mesh
  std::vector<contact::Triangle> triangles_;
  std::vector<std::array<int, 2>> edges_;
  std::vector<Tetrahedron> tetrahedra_;
  std::vector<Vec3<double>> x_;  ///< [points]
  std::vector<contact::Box> boxes_;
};

}  // namespace glisson::test
