#include <glisson/cpu/solids/strips.hpp>

#include <algorithm>
#include <cstdint>

namespace glisson::patches {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

template <std::size_t N>
std::uint64_t face_key(const std::array<int, N>& nodes, int opposite) {
  std::array<std::uint64_t, N - 1> face;
  for (std::size_t a = 0, k = 0; a < N; ++a)
    if (a != at(opposite)) face[k++] = static_cast<std::uint64_t>(nodes[a]);
  std::sort(face.begin(), face.end());
  std::uint64_t key = 0;
  for (const std::uint64_t node : face) key = key << 16 | node;
  return key;
}

/// Across the face opposite node a; -1: none.
template <std::size_t N>
std::vector<std::array<int, N>> find_neighbours(std::span<const std::array<int, N>> simplices) {
  constexpr int corners = static_cast<int>(N);
  struct Face {
    std::uint64_t key;
    int side;  ///< corners x simplex + opposite node
  };
  std::vector<Face> faces;
  faces.reserve(N * simplices.size());
  for (int side = 0; side < corners * static_cast<int>(simplices.size()); ++side)
    faces.push_back({face_key(simplices[at(side / corners)], side % corners), side});
  std::sort(faces.begin(), faces.end(),
            [](const Face& a, const Face& b) { return a.key != b.key ? a.key < b.key : a.side < b.side; });
  std::array<int, N> none;
  none.fill(-1);
  std::vector<std::array<int, N>> neighbours(simplices.size(), none);
  for (std::size_t i = 0; i + 1 < faces.size(); ++i) {
    if (faces[i].key != faces[i + 1].key) continue;
    const int a = faces[i].side, b = faces[i + 1].side;
    if (simplices[at(a / corners)][at(a % corners)] == simplices[at(b / corners)][at(b % corners)])
      continue;  // the same simplex twice
    neighbours[at(a / corners)][at(a % corners)] = b / corners;
    neighbours[at(b / corners)][at(b % corners)] = a / corners;
    ++i;
  }
  return neighbours;
}

template <std::size_t N>
class Builder {
 public:
  explicit Builder(std::span<const std::array<int, N>> simplices)
      : simplices_(simplices), neighbours_(find_neighbours(simplices)) {}

  std::vector<Strip<N>> build() {
    const int count = static_cast<int>(simplices_.size());
    degree_.resize(simplices_.size());
    for (int e = 0; e < count; ++e) {
      for (const int other : neighbours_[at(e)]) degree_[at(e)] += other >= 0;
      waiting_[at(degree_[at(e)])].push_back(e);
    }
    std::vector<Strip<N>> strips;
    strips.reserve(simplices_.size() / 2);
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

  /// A free one with the fewest free neighbours, but those without any last; -1 when none is free.
  int next() {
    for (std::size_t i = 1; i <= N + 1; ++i) {
      const std::size_t degree = i % (N + 1);
      while (!waiting_[degree].empty()) {
        const int e = waiting_[degree].back();
        waiting_[degree].pop_back();
        if (degree_[at(e)] == static_cast<int>(degree)) return e;
      }
    }
    return -1;
  }

  void take(int e) {
    degree_[at(e)] = taken;
    for (const int other : neighbours_[at(e)])
      if (free(other)) waiting_[at(--degree_[at(other)])].push_back(other);
  }

  /// The longest path from e or through e; of equally long ones that with the fewest ways on from its
  /// members.
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
    const auto& nodes = simplices_[at(e)];
    return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
  }
  /// The node of a that b does not have.
  int only_in(int a, int b) const {
    for (const int node : simplices_[at(a)])
      if (!has(b, node)) return node;
    return simplices_[at(a)][0];
  }

  /// Any path of three works: the node that the third drops is one of the face between the first two, whose
  /// order is free.
  Strip<N> strip_of(const std::array<int, 3>& path) const {
    const auto& first = simplices_[at(path[0])];
    Strip<N> strip;
    strip.element = path;
    auto& node = strip.node;
    node.fill(first[N - 1]);
    std::copy(first.begin(), first.end(), node.begin());
    if (path[1] < 0) return strip;
    node[0] = only_in(path[0], path[1]);
    for (std::size_t a = 0, k = 1; a < N; ++a)
      if (first[a] != node[0]) node[k++] = first[a];
    node[N + 1] = node[N] = only_in(path[1], path[0]);
    if (path[2] < 0) return strip;
    const int dropped = only_in(path[1], path[2]);
    std::swap(node[1], *std::find(node.begin() + 1, node.begin() + N, dropped));
    node[N + 1] = only_in(path[2], path[1]);
    return strip;
  }

  std::span<const std::array<int, N>> simplices_;
  std::vector<std::array<int, N>> neighbours_;
  std::vector<int> degree_;  ///< number of free neighbours, or taken
  std::array<std::vector<int>, N + 1>
      waiting_;  ///< by degree; an entry whose degree has changed since is void
};

}  // namespace

template <std::size_t N>
std::vector<Strip<N>> build_strips(std::span<const std::array<int, N>> simplices) {
  return Builder<N>(simplices).build();
}
template std::vector<Strip<3>> build_strips(std::span<const std::array<int, 3>>);
template std::vector<Strip<4>> build_strips(std::span<const std::array<int, 4>>);

}  // namespace glisson::patches
