#include <glisson/run/shell_packs/triangle_strips.hpp>

#include <algorithm>

#include <glisson/cpu/solids/strips.hpp>

namespace glisson::shells {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Triangles whose strips are looked for together: many, so that few strips end short at the border, but
/// their nodes must have numbers of 16 bits.
constexpr std::size_t window = 12288;

/// The triangles first, first + 1, ... in numbers of nodes that fit into 16 bits.
std::vector<std::array<int, 3>> renumbered(std::span<const std::array<int, 3>> triangles) {
  std::vector<int> nodes;
  for (const auto& triangle : triangles) nodes.insert(nodes.end(), triangle.begin(), triangle.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  std::vector<std::array<int, 3>> result(triangles.begin(), triangles.end());
  for (auto& triangle : result)
    for (int& n : triangle)
      n = static_cast<int>(std::lower_bound(nodes.begin(), nodes.end(), n) - nodes.begin());
  return result;
}

void add_strips(std::span<const std::array<int, 3>> part, int first, std::vector<TriangleStrip>& strips) {
  const std::vector<std::array<int, 3>> triangles = renumbered(part);
  const auto old = static_cast<std::ptrdiff_t>(strips.size());
  for (const auto& strip : patches::build_strips<3>(triangles)) {
    TriangleStrip turned;
    for (std::size_t j = 0; j < 3 && strip.element[j] >= 0; ++j) {
      const auto& corners = triangles[at(strip.element[j])];
      turned[j].number = first + strip.element[j];
      for (std::size_t a = 0; a < 3; ++a)
        turned[j].corner[a] =
            static_cast<int>(std::find(corners.begin(), corners.end(), strip.node[j + a]) - corners.begin());
    }
    strips.push_back(turned);
  }
  std::sort(strips.begin() + old, strips.end(),
            [](const TriangleStrip& a, const TriangleStrip& b) { return a[0].number < b[0].number; });
}

/// Gradients of the area coordinates of all corners, from those of corners 1 and 2, in another order.
void turn_gradients(double (&g)[2][2], const std::array<int, 3>& corner) {
  const double all[3][2] = {{-g[0][0] - g[1][0], -g[0][1] - g[1][1]}, {g[0][0], g[0][1]}, {g[1][0], g[1][1]}};
  for (std::size_t a = 0; a < 2; ++a) std::copy_n(all[corner[a + 1]], 2, g[a]);
}

}  // namespace

std::vector<TriangleStrip> triangle_strips(std::span<const std::array<int, 3>> triangles) {
  std::vector<TriangleStrip> strips;
  for (std::size_t first = 0; first < triangles.size(); first += window)
    add_strips(triangles.subspan(first, std::min(window, triangles.size() - first)), static_cast<int>(first),
               strips);
  return strips;
}

Membrane::Constants<double> turned(const Membrane::Constants<double>& c, const std::array<int, 3>& corner) {
  Membrane::Constants<double> result = c;
  turn_gradients(result.point.g, corner);
  return result;
}

ShellPatch<double> turned(const ShellPatch<double>& c, const std::array<int, 3>& corner) {
  ShellPatch<double> result = c;
  const Vec3<double> from_first[3] = {{}, c.a, c.b};
  result.a = from_first[corner[1]] - from_first[corner[0]];
  result.b = from_first[corner[2]] - from_first[corner[0]];
  turn_gradients(result.dL, corner);
  const bool over = (corner[0] + 1) % 3 != corner[1];  // sides run the other way
  for (std::size_t s = 0; s < 3; ++s) {
    const int old = corner[s];
    result.across[s] = c.across[old];
    for (int k = 0; k < 2; ++k) {
      result.g[s][0][k] = c.g[old][0][k];
      result.g[s][1][k] = over ? -c.g[old][1][k] : c.g[old][1][k];
    }
  }
  return result;
}

}  // namespace glisson::shells
