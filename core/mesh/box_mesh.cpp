#include <glisson/core/mesh/box_mesh.hpp>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

#include <glisson/core/base/error.hpp>

namespace glisson {
namespace {

/// The six orders in which a path along the edges of a brick can take the axes; odd ones turn the tetrahedron
/// inside out.
constexpr int axis_orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
constexpr bool odd_order[6] = {false, true, true, false, false, true};

void check(const std::array<int, 3>& cells, const Vec3<double>& size) {
  double nodes = 1, elements = 6;
  for (const int count : cells) {
    if (count < 1)
      throw Error(ErrorKind::usage,
                  "A box of " + std::to_string(count) + " cells has no element. Give at least 1.");
    nodes *= count + 1.0;
    elements *= count;
  }
  if (std::max(nodes, 8 * elements) > std::numeric_limits<int>::max())
    throw Error(ErrorKind::usage, "The box has too many cells to number them with 32 bits. Use fewer cells.");
  if (!(size.x > 0 && size.y > 0 && size.z > 0))
    throw Error(ErrorKind::usage, "The size of a box must be positive along every axis.");
}

/// Uniform in [-1, 1), the same on every platform (the distributions of the standard library are not).
double symmetric(std::mt19937& random) { return random() * (2.0 / 4294967296.0) - 1; }

std::vector<int> random_order(int count, std::mt19937& random) {
  std::vector<int> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  for (int i = count - 1; i > 0; --i)
    std::swap(order[static_cast<std::size_t>(i)], order[random() % static_cast<unsigned>(i + 1)]);
  return order;
}

Mesh shuffle(const Mesh& mesh, std::mt19937& random) {
  const std::vector<int> new_node = random_order(mesh.node_count(), random);
  const std::vector<int> old_element = random_order(mesh.element_count(), random);
  Mesh result;
  result.X.resize(mesh.X.size());
  for (std::size_t n = 0; n < mesh.X.size(); ++n) result.X[static_cast<std::size_t>(new_node[n])] = mesh.X[n];
  for (const int e : old_element) {
    std::array<int, 8> nodes;
    const auto old_nodes = mesh.element(e);
    std::transform(old_nodes.begin(), old_nodes.end(), nodes.begin(),
                   [&](int n) { return new_node[static_cast<std::size_t>(n)]; });
    result.add_element(mesh.shape[static_cast<std::size_t>(e)], {nodes.data(), old_nodes.size()});
  }
  return result;
}

void add_nodes(Mesh& mesh, const std::array<int, 3>& cells, const Vec3<double>& size, double jitter,
               std::mt19937& random) {
  auto coordinate = [&](int i, int count, double length, bool moves) {
    return length / count * (i + (moves ? jitter * symmetric(random) : 0));
  };
  auto inside = [&](int i, int count) { return i > 0 && i < count; };
  for (int k = 0; k <= cells[2]; ++k)
    for (int j = 0; j <= cells[1]; ++j)
      for (int i = 0; i <= cells[0]; ++i) {
        const bool moves = jitter != 0 && inside(i, cells[0]) && inside(j, cells[1]) && inside(k, cells[2]);
        const double x = coordinate(i, cells[0], size.x, moves), y = coordinate(j, cells[1], size.y, moves);
        mesh.X.push_back({x, y, coordinate(k, cells[2], size.z, moves)});
      }
}

}  // namespace

Mesh box_mesh(std::array<int, 3> cells, Vec3<double> size, Shape shape, double jitter, bool shuffled) {
  check(cells, size);
  std::mt19937 random(1);
  Mesh mesh;
  add_nodes(mesh, cells, size, jitter, random);
  const int stride[3] = {1, cells[0] + 1, (cells[0] + 1) * (cells[1] + 1)};
  auto add_brick = [&](int corner) {
    if (shape == Shape::hexahedron) {
      const int x = stride[0], y = stride[1], z = stride[2];
      mesh.add_element(shape, std::array{corner, corner + x, corner + x + y, corner + y, corner + z,
                                         corner + x + z, corner + x + y + z, corner + y + z});
      return;
    }
    for (int order = 0; order < 6; ++order) {
      std::array<int, 4> nodes{corner};
      for (std::size_t a = 0; a < 3; ++a) nodes[a + 1] = nodes[a] + stride[axis_orders[order][a]];
      if (odd_order[order]) std::swap(nodes[1], nodes[2]);
      mesh.add_element(shape, nodes);
    }
  };
  for (int k = 0; k < cells[2]; ++k)
    for (int j = 0; j < cells[1]; ++j)
      for (int i = 0; i < cells[0]; ++i) add_brick(i + j * stride[1] + k * stride[2]);
  return shuffled ? shuffle(mesh, random) : mesh;
}

}  // namespace glisson
