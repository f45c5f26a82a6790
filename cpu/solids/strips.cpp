#include <glisson/cpu/solids/strips.hpp>

#include <algorithm>
#include <cstdint>

namespace glisson::patches {
namespace {

using Tetrahedra = std::span<const std::array<int, 4>>;
using Neighbours = std::vector<std::array<int, 4>>;  ///< across the face opposite node a; -1: none

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::uint64_t face_key(const std::array<int, 4>& nodes, int opposite) {
  std::array<std::uint64_t, 3> face;
  for (int a = 0, k = 0; a < 4; ++a)
    if (a != opposite) face[at(k++)] = static_cast<std::uint64_t>(nodes[at(a)]);
  std::sort(face.begin(), face.end());
  return face[0] << 32 | face[1] << 16 | face[2];
}

Neighbours find_neighbours(Tetrahedra tetrahedra) {
  struct Face {
    std::uint64_t key;
    int side;  ///< 4 x tetrahedron + opposite node
  };
  std::vector<Face> faces;
  faces.reserve(4 * tetrahedra.size());
  for (int side = 0; side < static_cast<int>(4 * tetrahedra.size()); ++side)
    faces.push_back({face_key(tetrahedra[at(side / 4)], side % 4), side});
  std::sort(faces.begin(), faces.end(),
            [](const Face& a, const Face& b) { return a.key != b.key ? a.key < b.key : a.side < b.side; });
  Neighbours neighbours(tetrahedra.size(), {-1, -1, -1, -1});
  for (std::size_t i = 0; i + 1 < faces.size(); ++i) {
    if (faces[i].key != faces[i + 1].key) continue;
    const int a = faces[i].side, b = faces[i + 1].side;
    if (tetrahedra[at(a / 4)][at(a % 4)] == tetrahedra[at(b / 4)][at(b % 4)])
      continue;  // the same tetrahedron twice
    neighbours[at(a / 4)][at(a % 4)] = b / 4;
    neighbours[at(b / 4)][at(b % 4)] = a / 4;
    ++i;
  }
  return neighbours;
}

class Builder {
 public:
  explicit Builder(Tetrahedra tetrahedra)
      : tetrahedra_(tetrahedra), neighbours_(find_neighbours(tetrahedra)) {}

  std::vector<Strip> build() {
    const int count = static_cast<int>(tetrahedra_.size());
    degree_.resize(tetrahedra_.size());
    for (int e = 0; e < count; ++e) {
      for (const int other : neighbours_[at(e)]) degree_[at(e)] += other >= 0;
      waiting_[at(degree_[at(e)])].push_back(e);
    }
    std::vector<Strip> strips;
    strips.reserve(tetrahedra_.size() / 2);
    for (int e = next(); e >= 0; e = next()) {
      const std::array<int, 3> path = best_path(e);
      for (const int used : path)
        if (used >= 0) take(used);
      strips.push_back(strip_of(path));
    }
    return strips;
  }

 private:
  static constexpr int taken = -1;

  bool free(int e) const { return e >= 0 && degree_[at(e)] != taken; }

  /// A free tetrahedron with the fewest free neighbours, but those without any last; -1 when none is free.
  int next() {
    for (const std::size_t degree : {1u, 2u, 3u, 4u, 0u})
      while (!waiting_[degree].empty()) {
        const int e = waiting_[degree].back();
        waiting_[degree].pop_back();
        if (degree_[at(e)] == static_cast<int>(degree)) return e;
      }
    return -1;
  }

  void take(int e) {
    degree_[at(e)] = taken;
    for (const int other : neighbours_[at(e)])
      if (free(other)) waiting_[at(--degree_[at(other)])].push_back(other);
  }

  /// The longest path from e or through e; of equally long ones that with the fewest ways on from its
  /// tetrahedra.
  std::array<int, 3> best_path(int e) const {
    std::array<int, 3> best{e, -1, -1};
    int best_cost = 100;
    auto offer = [&](int a, int b, int c) {
      const int cost = (c < 0 ? 50 : 0) + degree_[at(a)] + degree_[at(b)] + (c < 0 ? 0 : degree_[at(c)]);
      if (cost >= best_cost) return;
      best_cost = cost;
      best = {a, b, c};
    };
    for (const int b : neighbours_[at(e)]) {
      if (!free(b)) continue;
      offer(e, b, -1);
      for (const int c : neighbours_[at(b)])
        if (c != e && free(c)) offer(e, b, c);
      for (const int c : neighbours_[at(e)])
        if (c != b && free(c)) offer(b, e, c);
    }
    return best;
  }

  bool has(int e, int node) const {
    const auto& nodes = tetrahedra_[at(e)];
    return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
  }
  /// The node of a that b does not have.
  int only_in(int a, int b) const {
    for (const int node : tetrahedra_[at(a)])
      if (!has(b, node)) return node;
    return tetrahedra_[at(a)][0];
  }

  /// Any path of three works: the node that the third drops is one of the face between the first two, whose
  /// order is free.
  Strip strip_of(const std::array<int, 3>& path) const {
    const auto& first = tetrahedra_[at(path[0])];
    Strip strip{{first[0], first[1], first[2], first[3], first[3], first[3]}, path};
    if (path[1] < 0) return strip;
    auto& node = strip.node;
    node[0] = only_in(path[0], path[1]);
    for (int a = 0, k = 1; a < 4; ++a)
      if (first[at(a)] != node[0]) node[at(k++)] = first[at(a)];
    node[5] = node[4] = only_in(path[1], path[0]);
    if (path[2] < 0) return strip;
    const int dropped = only_in(path[1], path[2]);
    std::swap(node[1], *std::find(node.begin() + 1, node.begin() + 4, dropped));
    node[5] = only_in(path[2], path[1]);
    return strip;
  }

  Tetrahedra tetrahedra_;
  Neighbours neighbours_;
  std::vector<int> degree_;                  ///< number of free neighbours, or taken
  std::array<std::vector<int>, 5> waiting_;  ///< by degree; an entry whose degree has changed since is void
};

}  // namespace

std::vector<Strip> build_strips(std::span<const std::array<int, 4>> tetrahedra) {
  return Builder(tetrahedra).build();
}

}  // namespace glisson::patches
