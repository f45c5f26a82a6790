#include <glisson/models/output/shell_sheets.hpp>

#include <cmath>
#include <glisson/core/mesh/triangles.hpp>
#include <glisson/core/tensor/symmetric.hpp>
#include <numeric>

namespace glisson {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

template <class T>
std::vector<T> chosen(const std::vector<T>& all, const std::vector<int>& rows) {
  std::vector<T> some;
  if (all.empty()) return some;
  some.reserve(rows.size());
  for (const int row : rows) some.push_back(all[at(row)]);
  return some;
}

/// The arrays of nodes and triangles that the sheet shows.
void take(ShellSheet& sheet, const Snapshot& snapshot, const std::vector<int>& nodes,
          const std::vector<int>& triangles) {
  sheet.displacement = chosen(snapshot.displacement, nodes);
  sheet.velocity = chosen(snapshot.velocity, nodes);
  sheet.internal_force = chosen(snapshot.internal_force, nodes);
  sheet.node.assign(nodes.begin(), nodes.end());
  const ShellFields& all = snapshot.shells;
  ShellFields& own = sheet.values;
  for (const auto member : {&ShellFields::stress, &ShellFields::strain, &ShellFields::membrane_force,
                            &ShellFields::moment, &ShellFields::curvature})
    own.*member = chosen(all.*member, triangles);
  for (const auto member : {&ShellFields::J, &ShellFields::area_ratio, &ShellFields::thickness,
                            &ShellFields::rest_thickness, &ShellFields::energy})
    own.*member = chosen(all.*member, triangles);
  own.set = chosen(all.set, triangles);
  sheet.set.assign(own.set.begin(), own.set.end());
}

/// The corners of triangles that share a point of the faces: those at one node that two-sided edges of one
/// orientation connect.
class Corners {
 public:
  explicit Corners(std::span<const Triangle> triangles) : parent_(3 * triangles.size()) {
    std::iota(parent_.begin(), parent_.end(), 0);
    for (const TriangleEdge& edge : edges_of(triangles)) {
      if (edge.sides.size() != 2 || !same_orientation(triangles, edge)) {
        borders.insert(borders.end(), edge.sides.begin(), edge.sides.end());
        continue;
      }
      for (const int node : {edge.a, edge.b})
        unite(corner_of(triangles, edge.sides[0] / 3, node), corner_of(triangles, edge.sides[1] / 3, node));
    }
    point.resize(parent_.size());
    for (int c = 0; c < static_cast<int>(parent_.size()); ++c)
      point[at(c)] = root(c) == c ? count++ : point[at(root(c))];  // the root is the smallest of its corners
  }

  std::vector<int> point;    ///< of each corner [triangles][3]
  std::vector<int> borders;  ///< sides where the faces end, 3 * triangle + side
  int count = 0;             ///< of points

 private:
  static int corner_of(std::span<const Triangle> triangles, int t, int node) {
    const Triangle& nodes = triangles[at(t)];
    return 3 * t + (nodes[0] == node ? 0 : nodes[1] == node ? 1 : 2);
  }
  int root(int c) {
    while (parent_[at(c)] != c) c = parent_[at(c)] = parent_[at(parent_[at(c)])];
    return c;
  }
  void unite(int a, int b) {
    a = root(a), b = root(b);
    parent_[at(std::max(a, b))] = std::min(a, b);
  }

  std::vector<int> parent_;
};

/// Half the thickness along the normal at each point: means of its triangles, weighted with their areas.
std::vector<Vec3<double>> half_thickness(std::span<const Triangle> triangles,
                                         const std::vector<Vec3<double>>& x, const std::vector<double>& h,
                                         const Corners& corners) {
  std::vector<Vec3<double>> normal(at(corners.count));
  std::vector<double> area(normal.size(), 0.0), volume(normal.size(), 0.0);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    const auto N = cross(x[at(b)] - x[at(a)], x[at(c)] - x[at(a)]);
    const double A = std::sqrt(dot(N, N));
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t p = at(corners.point[3 * t + k]);
      normal[p] = normal[p] + N;
      area[p] += A, volume[p] += A * h[t];
    }
  }
  for (std::size_t p = 0; p < normal.size(); ++p) {
    const double length = std::sqrt(dot(normal[p], normal[p]));
    // where the triangles cancel, as at a surface folded onto itself, there is no normal and no offset
    const bool has_normal = length > 1e-9 * area[p];
    normal[p] = has_normal ? (0.5 * volume[p] / area[p] / length) * normal[p] : Vec3<double>{};
  }
  return normal;
}

/// Triangles of the faces; for each the triangle it belongs to and its side.
void add_triangles(std::size_t triangle_count, const Corners& corners, ShellSheet& sheet,
                   std::vector<int>& source) {
  const int bottom = corners.count;
  const auto add = [&](int a, int b, int c, int triangle, double side) {
    sheet.surface.triangles.push_back({a, b, c});
    sheet.side.push_back(side);
    source.push_back(triangle);
  };
  for (std::size_t t = 0; t < triangle_count; ++t) {
    const int* p = corners.point.data() + 3 * t;
    add(p[0], p[1], p[2], static_cast<int>(t), 1);
    add(bottom + p[0], bottom + p[2], bottom + p[1], static_cast<int>(t), -1);
  }
  for (const int side : corners.borders) {
    const int t = side / 3;
    const int p = corners.point[at(3 * t + (side + 1) % 3)], q = corners.point[at(3 * t + (side + 2) % 3)];
    add(bottom + p, bottom + q, q, t, 0);
    add(bottom + p, q, p, t, 0);
  }
}

/// Values at the faces. The curvature is n . x,ab, so the side of the normal has E - h/2 times it; a moment
/// M per length makes the stress S - 6 M / h^2 there.
void bend_faces(ShellSheet& sheet) {
  ShellFields& v = sheet.values;
  if (v.moment.empty()) return;
  for (std::size_t t = 0; t < sheet.side.size(); ++t) {
    const double h = v.rest_thickness[t];
    v.stress[t] = v.stress[t] - (6 * sheet.side[t] / (h * h)) * v.moment[t];
    v.strain[t] = v.strain[t] - (0.5 * sheet.side[t] * h) * v.curvature[t];
  }
}

}  // namespace

Fields ShellSheet::fields() const {
  Fields all;
  const auto add = [](std::vector<Field>& list, const char* name, const auto& numbers, bool whole = false) {
    if (numbers.empty()) return;
    list.push_back(field(name, std::span(numbers)));
    list.back().whole = whole;
  };
  add(all.point, "displacement", displacement);
  add(all.point, "velocity", velocity);
  add(all.point, "internal_force", internal_force);
  add(all.point, "node", node, true);
  add(all.cell, "stress", values.stress);
  add(all.cell, "strain", values.strain);
  add(all.cell, "J", values.J);
  add(all.cell, "area_ratio", values.area_ratio);
  add(all.cell, "thickness", values.thickness);
  add(all.cell, "membrane_force", values.membrane_force);
  add(all.cell, "moment", values.moment);
  add(all.cell, "curvature", values.curvature);
  add(all.cell, "energy", values.energy);
  add(all.cell, "set", set, true);
  add(all.cell, "side", side, true);
  return all;
}

ShellSheet mid_surface(const Mesh& mesh, const Snapshot& snapshot) {
  ShellSheet sheet;
  std::vector<int> place(mesh.X.size(), -1), nodes;
  for (const auto& t : mesh.triangles) {
    auto& own = sheet.surface.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      int& p = place[at(t[k])];
      if (p < 0) p = static_cast<int>(nodes.size()), nodes.push_back(t[k]);
      own[k] = p;
    }
  }
  std::vector<int> triangles(mesh.triangles.size());
  std::iota(triangles.begin(), triangles.end(), 0);
  sheet.surface.X = chosen(mesh.X, nodes);
  take(sheet, snapshot, nodes, triangles);
  return sheet;
}

ShellSheet shell_faces(const Mesh& mesh, const Snapshot& snapshot) {
  ShellSheet sheet;
  const Corners corners(mesh.triangles);
  std::vector<int> nodes(2 * at(corners.count)), triangles;
  for (std::size_t c = 0; c < corners.point.size(); ++c) {
    const int p = corners.point[c];
    nodes[at(p)] = nodes[at(corners.count + p)] = mesh.triangles[c / 3][c % 3];
  }
  add_triangles(mesh.triangles.size(), corners, sheet, triangles);
  take(sheet, snapshot, nodes, triangles);
  bend_faces(sheet);
  sheet.values.energy.clear();  // belongs to the triangle, not to its faces
  std::vector<Vec3<double>> x = mesh.X;
  const auto rest = half_thickness(mesh.triangles, x, snapshot.shells.rest_thickness, corners);
  for (std::size_t n = 0; n < snapshot.displacement.size(); ++n) x[n] = x[n] + snapshot.displacement[n];
  const auto now = half_thickness(mesh.triangles, x, snapshot.shells.thickness, corners);
  sheet.surface.X = chosen(mesh.X, nodes);
  for (std::size_t p = 0; p < nodes.size(); ++p) {
    const std::size_t k = p % rest.size();
    const double side = p < rest.size() ? 1 : -1;
    sheet.surface.X[p] = sheet.surface.X[p] + side * rest[k];
    if (!sheet.displacement.empty())
      sheet.displacement[p] = sheet.displacement[p] + side * (now[k] - rest[k]);
  }
  return sheet;
}

}  // namespace glisson
