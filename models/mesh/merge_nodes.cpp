// Joins nodes by a grid of cubes as wide as the distance: a node has to look at the 27 cubes around it only.
#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <unordered_map>

#include <glisson/core/base/error.hpp>
#include <glisson/models/mesh/keep_nodes.hpp>
#include <glisson/models/mesh/transform.hpp>

namespace glisson {
namespace {

/// A cube by its number along each axis, in double so that no coordinate is too far out.
struct Cube {
  double i, j, k;
  bool operator==(const Cube&) const = default;
};

struct CubeHash {
  std::size_t operator()(const Cube& c) const {
    std::uint64_t h = 0;
    for (const double v : {c.i, c.j, c.k}) {
      h = (h ^ std::bit_cast<std::uint64_t>(v + 0.0)) * 0x9e3779b97f4a7c15u;
      h ^= h >> 29;
    }
    return h;
  }
};

/// Kept nodes in cubes. Kept nodes lie at least the distance apart, so a cube holds few of them.
class Grid {
 public:
  Grid(double width, double distance) : width_(width), distance_(distance) {}

  /// The kept node of smallest number that is closer than the distance; -1: none.
  int near(const Vec3<double>& x, const std::vector<Vec3<double>>& X) const {
    const Cube c = cube_of(x);
    int first = -1;
    for (double i = -1; i <= 1; ++i)
      for (double j = -1; j <= 1; ++j)
        for (double k = -1; k <= 1; ++k) {
          const auto found = nodes_.find({c.i + i, c.j + j, c.k + k});
          if (found == nodes_.end()) continue;
          for (const int n : found->second) {
            const auto d = X[static_cast<std::size_t>(n)] - x;
            if ((first < 0 || n < first) && std::hypot(d.x, d.y, d.z) < distance_) first = n;
          }
        }
    return first;
  }

  void add(int node, const Vec3<double>& x) { nodes_[cube_of(x)].push_back(node); }

 private:
  Cube cube_of(const Vec3<double>& x) const {
    return {std::floor(x.x / width_), std::floor(x.y / width_), std::floor(x.z / width_)};
  }

  double width_, distance_;
  std::unordered_map<Cube, std::vector<int>, CubeHash> nodes_;
};

/// Cubes far smaller than the spacing of double numbers would have no neighbours.
double width_for(const std::vector<Vec3<double>>& X, double distance) {
  double extent = 0;
  for (const auto& x : X) extent = std::max({extent, std::fabs(x.x), std::fabs(x.y), std::fabs(x.z)});
  return std::max(distance, 1e-15 * extent);
}

void check_nodes(std::span<const int> nodes, const std::vector<int>& renumber, double distance,
                 const char* what, int e) {
  for (std::size_t a = 0; a < nodes.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      if (nodes[a] == nodes[b]) continue;  // it was so before
      if (renumber[static_cast<std::size_t>(nodes[a])] == renumber[static_cast<std::size_t>(nodes[b])])
        throw Error(ErrorKind::input,
                    "merging nodes that are closer than " + std::to_string(distance) + " joins nodes " +
                        std::to_string(nodes[b]) + " and " + std::to_string(nodes[a]) +
                        " of one element, which would have no volume. Use a smaller distance",
                    {{}, 0, what + std::to_string(e)});
    }
}

void check_elements(const Mesh& mesh, const std::vector<int>& renumber, double distance) {
  for (int e = 0; e < mesh.element_count(); ++e)
    check_nodes(mesh.element(e), renumber, distance, "element ", e);
  for (std::size_t e = 0; e < mesh.triangles.size(); ++e)
    check_nodes(mesh.triangles[e], renumber, distance, "shell triangle ", static_cast<int>(e));
}

}  // namespace

std::vector<int> merge_nodes(Mesh& mesh, double distance) {
  if (!std::isfinite(distance)) throw Error(ErrorKind::input, "the distance for merging nodes is not finite");
  std::vector<int> renumber(mesh.X.size());
  if (!(distance > 0)) {
    for (std::size_t n = 0; n < renumber.size(); ++n) renumber[n] = static_cast<int>(n);
    return renumber;
  }
  Grid grid(width_for(mesh.X, distance), distance);
  int kept = 0;
  for (std::size_t n = 0; n < mesh.X.size(); ++n) {
    const int first = grid.near(mesh.X[n], mesh.X);
    renumber[n] = first >= 0 ? renumber[static_cast<std::size_t>(first)] : kept++;
    if (first < 0) grid.add(static_cast<int>(n), mesh.X[n]);
  }
  check_elements(mesh, renumber, distance);
  detail::keep_nodes(mesh, renumber);
  return renumber;
}

}  // namespace glisson
