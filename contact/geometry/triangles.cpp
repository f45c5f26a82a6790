#include <glisson/contact/geometry/triangles.hpp>

#include <algorithm>
#include <cmath>

namespace glisson::contact {
namespace {

using Nodes = std::span<const Vec3<double>>;

double squared(const Vec3<double>& a) { return dot(a, a); }
const Vec3<double>& at(Nodes x, int n) { return x[static_cast<std::size_t>(n)]; }

/// An edge and its place: triangle and corner that it starts at.
struct EdgeUse {
  std::array<int, 2> nodes;
  int triangle, corner;
};

std::vector<EdgeUse> sorted_uses(std::span<const Triangle> triangles) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * triangles.size());
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto& nodes = triangles[static_cast<std::size_t>(t)];
      const int a = nodes[static_cast<std::size_t>(k)], b = nodes[static_cast<std::size_t>((k + 1) % 3)];
      uses.push_back({{std::min(a, b), std::max(a, b)}, t, k});
    }
  std::stable_sort(uses.begin(), uses.end(),
                   [](const EdgeUse& a, const EdgeUse& b) { return a.nodes < b.nodes; });
  return uses;
}

/// One past the uses of the same edge as uses[i].
std::size_t end_of_edge(const std::vector<EdgeUse>& uses, std::size_t i) {
  std::size_t end = i + 1;
  while (end < uses.size() && uses[end].nodes == uses[i].nodes) ++end;
  return end;
}

}  // namespace

std::vector<Triangle> split_facets(std::span<const Facet> facets, Nodes X) {
  std::vector<Triangle> triangles;
  triangles.reserve(facets.size());
  for (const Facet& facet : facets) {
    const auto [a, b, c, d] = facet.nodes;
    if (d < 0) {
      triangles.push_back({a, b, c});
    } else if (squared(at(X, c) - at(X, a)) <= squared(at(X, d) - at(X, b))) {
      triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
    } else {
      triangles.insert(triangles.end(), {{a, b, d}, {b, c, d}});
    }
  }
  return triangles;
}

std::vector<std::array<int, 3>> neighbours_of(std::span<const Triangle> triangles) {
  std::vector<std::array<int, 3>> result(triangles.size(), {-1, -1, -1});
  const auto uses = sorted_uses(triangles);
  for (std::size_t i = 0; i < uses.size();) {
    const std::size_t end = end_of_edge(uses, i);
    if (end == i + 2) {
      const EdgeUse &a = uses[i], &b = uses[i + 1];
      result[static_cast<std::size_t>(a.triangle)][static_cast<std::size_t>(a.corner)] = b.triangle;
      result[static_cast<std::size_t>(b.triangle)][static_cast<std::size_t>(b.corner)] = a.triangle;
    }
    i = end;
  }
  return result;
}

void part_vertices(std::vector<Triangle>& triangles, std::vector<Vec3<double>>& x) {
  const auto neighbours = neighbours_of(triangles);
  const auto start = triangles;
  std::vector<bool> met(x.size());
  std::vector<std::array<bool, 3>> done(triangles.size(), {false, false, false});
  for (std::size_t t = 0; t < start.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      if (done[t][k]) continue;
      const int node = start[t][k];
      const bool first = !met[static_cast<std::size_t>(node)];
      met[static_cast<std::size_t>(node)] = true;
      if (!first) x.push_back(x[static_cast<std::size_t>(node)]);
      std::vector<std::size_t> open{t};  // triangles around the node that hang together
      while (!open.empty()) {
        const std::size_t its = open.back();
        open.pop_back();
        const auto corner = static_cast<std::size_t>(std::find(start[its].begin(), start[its].end(), node) -
                                                     start[its].begin());
        if (done[its][corner]) continue;
        done[its][corner] = true;
        if (!first) triangles[its][corner] = static_cast<int>(x.size()) - 1;
        for (const std::size_t edge : {corner, (corner + 2) % 3})
          if (const int other = neighbours[its][edge]; other >= 0)
            open.push_back(static_cast<std::size_t>(other));
      }
    }
}

std::vector<std::array<int, 2>> edges_of(std::span<const Triangle> triangles) {
  std::vector<std::array<int, 2>> edges;
  const auto uses = sorted_uses(triangles);
  for (std::size_t i = 0; i < uses.size(); i = end_of_edge(uses, i)) edges.push_back(uses[i].nodes);
  return edges;
}

std::vector<Vec3<double>> vertex_normals(std::span<const Triangle> triangles, Nodes x) {
  std::vector<Vec3<double>> normals(x.size());
  for (const Triangle& t : triangles) {
    const auto n = cross(at(x, t[1]) - at(x, t[0]), at(x, t[2]) - at(x, t[0]));
    const double length = std::sqrt(squared(n));
    if (!(length > 0)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = at(x, t[(k + 1) % 3]) - at(x, t[k]), b = at(x, t[(k + 2) % 3]) - at(x, t[k]);
      const double angle = std::atan2(length, dot(a, b));  // |a x b| is the same at every corner
      auto& sum = normals[static_cast<std::size_t>(t[k])];
      sum = sum + (angle / length) * n;
    }
  }
  for (auto& n : normals) {
    const double length = std::sqrt(squared(n));
    n = length > 0 ? (1 / length) * n : Vec3<double>{};
  }
  return normals;
}

}  // namespace glisson::contact
