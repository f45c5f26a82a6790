#include <glisson/core/numbering.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
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

std::uint64_t morton_key(const Mesh& mesh, int e, const Bounds& bounds) {
  const auto nodes = mesh.element(e);
  Vec3<double> sum{};
  for (const int n : nodes) sum = sum + mesh.X[static_cast<std::size_t>(n)];
  const double scale = 2097151 / bounds.size(), share = 1.0 / double(nodes.size());
  auto cell = [&](double c, double low) {
    return static_cast<std::uint64_t>(std::max(0.0, (c * share - low) * scale));
  };
  return spread(cell(sum.x, bounds.low.x)) | spread(cell(sum.y, bounds.low.y)) << 1 |
         spread(cell(sum.z, bounds.low.z)) << 2;
}

}  // namespace

Numbering make_numbering(const Mesh& mesh) {
  Numbering numbering;
  const auto elements = static_cast<std::size_t>(mesh.element_count()), nodes = mesh.X.size();
  {
    const Bounds bounds = bounds_of(mesh);
    std::vector<std::pair<std::uint64_t, int>> keys(elements);
    for (std::size_t e = 0; e < elements; ++e)
      keys[e] = {morton_key(mesh, static_cast<int>(e), bounds), static_cast<int>(e)};
    std::sort(keys.begin(), keys.end());
    numbering.element_order.resize(elements);
    for (std::size_t e = 0; e < elements; ++e) numbering.element_order[e] = keys[e].second;
  }
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
  for (std::size_t n = 0; n < nodes; ++n) touch(static_cast<int>(n));  // nodes without elements come last
  return numbering;
}

}  // namespace glisson
