#include <glisson/core/numbering.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

namespace glisson {
namespace {

/// Bits of x with two zeros after each, for 21 bits (Morton 1966).
std::uint64_t spread(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

struct Bounds {
  Vec3<double> low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  double size() const { return std::max({high.x - low.x, high.y - low.y, high.z - low.z, 1e-300}); }
};

Bounds bounds_of(const Mesh& mesh) {
  Bounds b;
  for (const auto& X : mesh.X) {
    b.low = {std::min(b.low.x, X.x), std::min(b.low.y, X.y), std::min(b.low.z, X.z)};
    b.high = {std::max(b.high.x, X.x), std::max(b.high.y, X.y), std::max(b.high.z, X.z)};
  }
  return b;
}

std::uint64_t morton_key(const Mesh& mesh, std::span<const int> nodes, const Bounds& bounds) {
  Vec3<double> sum{};
  for (const int n : nodes) sum = sum + mesh.X[static_cast<std::size_t>(n)];
  const double scale = 2097151 / bounds.size(), share = 1.0 / double(nodes.size());
  auto cell = [&](double c, double low) {
    return static_cast<std::uint64_t>(std::max(0.0, (c * share - low) * scale));
  };
  return spread(cell(sum.x, bounds.low.x)) | spread(cell(sum.y, bounds.low.y)) << 1 |
         spread(cell(sum.z, bounds.low.z)) << 2;
}

/// 0 .. count - 1 along the curve; nodes_of(i) gives the nodes of number i.
template <class NodesOf>
std::vector<int> curve_order(const Mesh& mesh, const Bounds& bounds, std::size_t count, NodesOf&& nodes_of) {
  std::vector<std::pair<std::uint64_t, int>> keys(count);
  for (std::size_t i = 0; i < count; ++i)
    keys[i] = {morton_key(mesh, nodes_of(static_cast<int>(i)), bounds), static_cast<int>(i)};
  std::sort(keys.begin(), keys.end());
  std::vector<int> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = keys[i].second;
  return order;
}

}  // namespace

Numbering make_numbering(const Mesh& mesh) {
  Numbering numbering;
  const std::size_t nodes = mesh.X.size();
  const Bounds bounds = bounds_of(mesh);
  auto triangle = [&](int t) -> std::span<const int> { return mesh.triangles[static_cast<std::size_t>(t)]; };
  numbering.element_order = curve_order(mesh, bounds, static_cast<std::size_t>(mesh.element_count()),
                                        [&](int e) { return mesh.element(e); });
  numbering.triangle_order = curve_order(mesh, bounds, mesh.triangles.size(), triangle);
  numbering.internal_of_user.assign(nodes, -1);
  numbering.user_of_internal.reserve(nodes);
  auto touch = [&](int user) {
    int& internal = numbering.internal_of_user[static_cast<std::size_t>(user)];
    if (internal >= 0) return;
    internal = static_cast<int>(numbering.user_of_internal.size());
    numbering.user_of_internal.push_back(user);
  };
  for (const int e : numbering.element_order)
    for (const int user : mesh.element(e)) touch(user);
  for (const int t : numbering.triangle_order)
    for (const int user : triangle(t)) touch(user);
  for (std::size_t n = 0; n < nodes; ++n) touch(static_cast<int>(n));  // nodes without elements come last
  return numbering;
}

}  // namespace glisson
