#include <glisson/shells/shell_blocks.hpp>

#include <algorithm>
#include <cmath>
#include <map>

#include <glisson/core/base/error.hpp>
#include <glisson/core/mesh/triangles.hpp>

namespace glisson::shells {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// What the sides of the shells' triangles meet.
struct SideTable {
  std::vector<int> opposite;  ///< node of the neighbour across, or -1  [triangle][3]
  std::vector<int> triangle;  ///< the neighbour, or -1                 [triangle][3]
};

SideTable neighbours_of(const Model& model) {
  const auto& triangles = model.mesh.triangles;
  std::vector<char> bends(triangles.size(), 0);
  for (const ShellSection& section : model.shells)
    if (section.formulation == ShellFormulation::rotation_free)
      for (const int e : section.elements) bends[at(e)] = 1;
  SideTable table{std::vector<int>(3 * triangles.size(), -1), std::vector<int>(3 * triangles.size(), -1)};
  for (TriangleEdge& edge : edges_of(triangles)) {
    auto& sides = edge.sides;
    sides.erase(std::remove_if(sides.begin(), sides.end(), [&](int s) { return bends[at(s / 3)] == 0; }),
                sides.end());
    if (sides.size() != 2) continue;
    for (int k = 0; k < 2; ++k) {
      const int other = sides[at(1 - k)];
      table.triangle[at(sides[at(k)])] = other / 3;
      table.opposite[at(sides[at(k)])] = triangles[at(other / 3)][at(other % 3)];
    }
  }
  return table;
}

/// Which edges of the border do not rotate: both nodes clamped, or in one symmetry plane.
class MirrorPlanes {
 public:
  explicit MirrorPlanes(const Model& model) : model_(model), clamped_(model.mesh.X.size(), 0) {
    for (const int n : model.clamped_nodes) clamped_[at(n)] = 1;
    for (std::size_t p = 0; p < model.planes.size(); ++p)
      for (const int n : model.planes[p].nodes) planes_.emplace(n, p);
  }
  /// False for a side that is free to rotate. A clamped side mirrors the plane of the triangle itself.
  bool find(int a, int b, const Vec3<double>& triangle_normal, Vec3<double>& normal) const {
    const auto [first, last] = planes_.equal_range(a);
    for (auto i = first; i != last; ++i) {
      const auto [other, end] = planes_.equal_range(b);
      for (auto j = other; j != end; ++j)
        if (i->second == j->second) {
          normal = model_.planes[i->second].normal;
          return true;
        }
    }
    if (clamped_[at(a)] == 0 || clamped_[at(b)] == 0) return false;
    normal = unit(cross(model_.mesh.X[at(b)] - model_.mesh.X[at(a)], triangle_normal));
    return true;
  }

 private:
  const Model& model_;
  std::vector<char> clamped_;
  std::multimap<int, std::size_t> planes_;
};

/// The section's direction; zero where it is normal to the triangle.
Vec3<double> usable_direction(const Vec3<double>& d, const Vec3<double>& normal) {
  const auto in_plane = d - dot(d, normal) * normal;
  return dot(in_plane, in_plane) > 1e-6 * dot(d, d) ? d : Vec3<double>{};
}

class ShellBuilder {
 public:
  ShellBuilder(const Model& model, const SideTable& sides, const MirrorPlanes& planes)
      : model_(model), sides_(sides), planes_(planes) {}

  void add(HostShells& block, std::size_t k) const {
    const ShellSection& section = *block.section;
    const int e = section.elements[k];
    const Triangle& t = model_.mesh.triangles[at(e)];
    Vec3<double> X[6];
    for (int a = 0; a < 3; ++a) X[a] = model_.mesh.X[at(t[at(a)])];
    const auto normal = unit(cross(X[1] - X[0], X[2] - X[0]));
    block.along.push_back(usable_direction(section.direction_of(k), normal));
    const auto& direction = block.along.back();
    const auto along = dot(direction, direction) > 0 ? direction : X[1] - X[0];
    const double h = section.thickness_of(k);
    const auto axis = unit(along - dot(along, normal) * normal);
    block.frames.push_back({{axis, cross(normal, axis)}, normal});
    block.nodes.insert(block.nodes.end(), t.begin(), t.end());
    block.patch.push_back(e);
    if (!block.bends()) {
      block.patch.insert(block.patch.end(), 3, -1);
      block.membranes.push_back(Membrane::make({X[0], X[1], X[2]}, along, h));
      return;
    }
    Across across[3];
    Vec3<double> mirror[3];
    for (int s = 0; s < 3; ++s) across[s] = look_across(block, e, s, normal, X, mirror[s]);
    const double nu = section.bending_nu;
    block.shells.push_back(RotationFree::make(X, across, mirror, along, h,
                                              section.bending_E * h * h * h / (12 * (1 - nu * nu)), nu));
  }

 private:
  Across look_across(HostShells& block, int e, int s, const Vec3<double>& normal, Vec3<double> (&X)[6],
                     Vec3<double>& mirror) const {
    const Triangle& t = model_.mesh.triangles[at(e)];
    const int j = (s + 1) % 3, k = (s + 2) % 3, other = sides_.opposite[at(3 * e + s)];
    block.nodes.push_back(other >= 0 ? other : t[at(s)]);
    block.patch.push_back(sides_.triangle[at(3 * e + s)]);
    Across across = Across::neighbour;
    if (other >= 0) {
      X[3 + s] = model_.mesh.X[at(other)];
    } else if (planes_.find(t[at(j)], t[at(k)], normal, mirror)) {
      const auto away = X[s] - 0.5 * (X[j] + X[k]);
      X[3 + s] = X[s] - (2 * dot(mirror, away)) * mirror;
      across = Across::mirror;
    } else {
      across = Across::nothing;
    }
    const auto N = cross(X[j] - X[k], X[3 + s] - X[s]);  // parallel to the normal at the side
    const auto edge = X[j] - X[k];
    if (across != Across::nothing && !(dot(N, N) > 1e-8 * dot(edge, edge) * dot(edge, edge)))
      throw Error(
          ErrorKind::input,
          "shell triangle " + std::to_string(e) +
              ": it is folded flat onto its neighbour, or lies in its own symmetry plane, so its curvature "
              "is not defined; correct the mesh");
    return across;
  }

  const Model& model_;
  const SideTable& sides_;
  const MirrorPlanes& planes_;
};

}  // namespace

std::vector<HostShells> make_shell_blocks(const Model& model) {
  const SideTable sides = neighbours_of(model);
  const MirrorPlanes planes(model);
  const ShellBuilder builder(model, sides, planes);
  std::vector<HostShells> blocks;
  for (const ShellSection& section : model.shells) {
    HostShells block;
    block.section = &section;
    for (std::size_t k = 0; k < section.elements.size(); ++k) builder.add(block, k);
    blocks.push_back(std::move(block));
  }
  return blocks;
}

}  // namespace glisson::shells
