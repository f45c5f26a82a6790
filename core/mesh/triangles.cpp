#include <glisson/core/mesh/triangles.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace glisson {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Nodes of side s in the triangle's own direction.
std::pair<int, int> ends(std::span<const Triangle> triangles, int side) {
  const Triangle& t = triangles[at(side / 3)];
  return {t[at((side + 1) % 3)], t[at((side + 2) % 3)]};
}

struct Side {
  int a, b, side;
};

}  // namespace

std::vector<TriangleEdge> edges_of(std::span<const Triangle> triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (int e = 0; e < static_cast<int>(triangles.size()); ++e)
    for (int s = 0; s < 3; ++s) {
      const Triangle& t = triangles[at(e)];
      const auto [a, b] = std::minmax(t[at((s + 1) % 3)], t[at((s + 2) % 3)]);
      sides.push_back({a, b, 3 * e + s});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
    return std::pair(std::pair(x.a, x.b), x.side) < std::pair(std::pair(y.a, y.b), y.side);
  });
  std::vector<TriangleEdge> edges;
  for (const Side& s : sides) {
    if (edges.empty() || edges.back().a != s.a || edges.back().b != s.b) edges.push_back({s.a, s.b, {}});
    edges.back().sides.push_back(s.side);
  }
  return edges;
}

bool same_orientation(std::span<const Triangle> triangles, const TriangleEdge& edge) {
  return ends(triangles, edge.sides[0]) != ends(triangles, edge.sides[1]);
}

int orient(std::vector<Triangle>& triangles) {
  struct Neighbour {
    int triangle;
    bool agrees;
  };
  std::vector<std::vector<Neighbour>> neighbours(triangles.size());
  for (const TriangleEdge& edge : edges_of(triangles)) {
    if (edge.sides.size() != 2) continue;
    const int e = edge.sides[0] / 3, f = edge.sides[1] / 3;
    const bool agrees = same_orientation(triangles, edge);
    neighbours[at(e)].push_back({f, agrees});
    neighbours[at(f)].push_back({e, agrees});
  }
  std::vector<int> turn(triangles.size(), -1);
  std::vector<int> front;
  for (std::size_t first = 0; first < triangles.size(); ++first) {
    if (turn[first] >= 0) continue;
    turn[first] = 0;
    front.assign(1, static_cast<int>(first));
    while (!front.empty()) {
      const int e = front.back();
      front.pop_back();
      for (const Neighbour& n : neighbours[at(e)]) {
        const int wanted = n.agrees ? turn[at(e)] : 1 - turn[at(e)];
        if (turn[at(n.triangle)] < 0) {
          turn[at(n.triangle)] = wanted;
          front.push_back(n.triangle);
        } else if (turn[at(n.triangle)] != wanted) {
          return -1;
        }
      }
    }
  }
  for (std::size_t e = 0; e < triangles.size(); ++e)
    if (turn[e] == 1) std::swap(triangles[e][1], triangles[e][2]);
  return static_cast<int>(std::count(turn.begin(), turn.end(), 1));
}

void append_triangles(const Facet& facet, std::span<const Vec3<double>> X, std::vector<Triangle>& triangles) {
  const auto& n = facet.nodes;
  if (facet.node_count() == 3) return triangles.push_back({n[0], n[1], n[2]});
  const auto square = [&](std::size_t a, std::size_t b) {
    const auto d = X[at(n[a])] - X[at(n[b])];
    return dot(d, d);
  };
  const double first = square(0, 2), second = square(1, 3);
  constexpr double equal = 2e-3;  // of squares
  const bool from_first = std::abs(first - second) > equal * std::max(first, second)
                              ? first < second
                              : std::min(n[0], n[2]) < std::min(n[1], n[3]);
  if (from_first)
    triangles.insert(triangles.end(), {{n[0], n[1], n[2]}, {n[0], n[2], n[3]}});
  else
    triangles.insert(triangles.end(), {{n[0], n[1], n[3]}, {n[1], n[2], n[3]}});
}

std::vector<Facet> facets_of(std::span<const Triangle> triangles) {
  std::vector<Facet> facets;
  facets.reserve(triangles.size());
  for (const Triangle& t : triangles) facets.push_back({{t[0], t[1], t[2], -1}, -1});
  return facets;
}

double triangle_area(const Triangle& t, std::span<const Vec3<double>> X) {
  const auto N = cross(X[at(t[1])] - X[at(t[0])], X[at(t[2])] - X[at(t[0])]);
  return 0.5 * std::sqrt(dot(N, N));
}

std::vector<SurfacePart> connected_parts(std::span<const Triangle> triangles) {
  std::vector<std::vector<int>> neighbours(triangles.size());
  for (const TriangleEdge& edge : edges_of(triangles))
    for (const int side : edge.sides)
      neighbours[at(side / 3)].push_back(edge.sides.size() == 2 ? edge.sides[side == edge.sides[0]] / 3 : -1);
  std::vector<bool> seen(triangles.size());
  std::vector<SurfacePart> parts;
  for (std::size_t first = 0; first < triangles.size(); ++first) {
    if (seen[first]) continue;
    seen[first] = true;
    SurfacePart part;
    part.triangles = {first};
    for (std::size_t i = 0; i < part.triangles.size(); ++i)
      for (const int other : neighbours[part.triangles[i]]) {
        part.closed = part.closed && other >= 0;
        if (other < 0 || seen[at(other)]) continue;
        seen[at(other)] = true;
        part.triangles.push_back(at(other));
      }
    parts.push_back(std::move(part));
  }
  return parts;
}

TriangleSizes triangle_sizes(std::span<const Triangle> triangles, std::span<const Vec3<double>> X) {
  TriangleSizes sizes;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[i];
    const auto ab = X[at(t[1])] - X[at(t[0])], ac = X[at(t[2])] - X[at(t[0])], bc = ac - ab;
    const double longest = std::sqrt(std::max({dot(ab, ab), dot(ac, ac), dot(bc, bc)}));
    const double height = longest > 0 ? 2 * triangle_area(t, X) / longest : 0;
    sizes.smallest = i == 0 ? height : std::min(sizes.smallest, height);
    sizes.largest = std::max(sizes.largest, height);
  }
  return sizes;
}

}  // namespace glisson
