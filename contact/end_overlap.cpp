#include <glisson/contact/end_overlap.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <glisson/contact/bvh/solid_search.hpp>
#include <glisson/contact/deformable/contact_distances.hpp>
#include <glisson/contact/surface/surface_data.hpp>
#include <glisson/core/base/number_text.hpp>
#include <glisson/core/mesh/surface.hpp>

namespace glisson::contact {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Points that lie deep in a solid.
struct Lost {
  int count = 0;
  int point = -1, solid = -1;  ///< of the deepest one
  double depth = 0;            ///< its [m]

  void add(int its_point, int its_solid, double its_depth) {
    ++count;
    if (its_depth > depth) point = its_point, solid = its_solid, depth = its_depth;
  }
};

std::string count_text(int count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? " lies" : " lie");
}

/// Nodes of solids in other solids that they may touch.
void warn_of_bodies(const Model& model, const std::vector<Vec3<double>>& u, std::vector<std::string>& to) {
  const ContactMesh mesh = contact_mesh(model);
  const ContactRules rules(model, mesh);
  const double deep = contact_distances(model.contact, mesh).reach;
  std::vector<Vec3<double>> x;
  for (const int n : mesh.nodes) x.push_back(model.mesh.X[at(n)] + u[at(n)] - mesh.centre);
  mesh.append_points(x);
  std::vector<int> solid;
  for (const Triangle& c : mesh.triangles) solid.push_back(mesh.solid[at(c[0])]);
  std::map<int, std::set<int>> regions;  // of each solid
  for (int t = 0; t < mesh.triangle_count(); ++t) regions[solid[at(t)]].insert(mesh.region[at(t)]);
  SolidSearch search(mesh.triangles, solid, x);
  Lost lost;
  for (int k = 0; k < mesh.node_count(); ++k) {
    const int region = mesh.point_region[at(k)];
    if (region < 0) continue;
    const auto other_solid = [&](int t) {
      return mesh.sheet[at(t)] < 0 && solid[at(t)] != mesh.solid[at(k)];
    };
    const auto may_touch = [&](int its) { return rules.may_touch(region, its); };
    for (const int other : search.around(x[at(k)], other_solid)) {
      if (std::none_of(regions[other].begin(), regions[other].end(), may_touch)) continue;
      if (const double depth = search.nearest(x[at(k)], other).distance; depth > deep)
        lost.add(k, other, depth);
    }
  }
  if (lost.count == 0) return;
  to.push_back(
      std::string(contact_place) + ": at the end " +
      count_text(lost.count, lost.count == 1 ? "node" : "nodes") + " deeper than " + number_text(deep) +
      " in another body, where contact does not find them and largest_depth does not count them (node " +
      std::to_string(mesh.nodes[at(lost.point)]) + " of " +
      rules.body_name(mesh.point_region[at(lost.point)]) + " by " + number_text(lost.depth) + " in " +
      rules.body_name(*regions[lost.solid].begin()) +
      "). The result is wrong there. Let them meet more slowly, or refine sharp edges");
}

/// Nodes of rigid surfaces in solids.
void warn_of_surfaces(const Model& model, const std::vector<Vec3<double>>& u, double t,
                      std::vector<std::string>& to) {
  const auto triangles = split_facets(outer_surface(model.mesh), model.mesh.X);
  if (triangles.empty()) return;
  std::vector<Vec3<double>> x = model.mesh.X;
  for (std::size_t n = 0; n < x.size(); ++n) x[n] = x[n] + u[n];
  SolidSearch search(triangles, std::vector<int>(triangles.size(), 0), x);
  for (const RigidSurface& surface : model.surfaces) {
    if (!surface.nodes.empty()) continue;
    const SurfacePose pose = pose_at(surface, t);
    Lost lost;
    for (std::size_t n = 0; n < surface.surface.X.size(); ++n) {
      const Vec3<double> p =
          times(pose.turn, surface.surface.X[n] - surface.centre) + pose.shift + surface.centre;
      if (search.around(p, [](int) { return true; }).empty()) continue;
      const auto [depth, edge] = search.nearest(p, 0);
      if (depth > 0.2 * edge) lost.add(static_cast<int>(n), 0, depth);
    }
    if (lost.count == 0) continue;
    to.push_back(
        surface.name + ": at the end " + count_text(lost.count, lost.count == 1 ? "node" : "of its nodes") +
        " deeper in the body than a fifth of the body's facets there (its node " +
        std::to_string(lost.point) + " by " + number_text(lost.depth) +
        "): it acts on nodes of the body only and went in between them. Refine the body's mesh there, "
        "or mesh the tool as a body whose nodes are all prescribed");
  }
}

}  // namespace

std::vector<std::string> overlap_warnings(const Model& model, const std::vector<Vec3<double>>& u, double t) {
  std::vector<std::string> warnings;
  if (model.contact.wanted() && model.contact.nodes.empty()) warn_of_bodies(model, u, warnings);
  if (!model.surfaces.empty()) warn_of_surfaces(model, u, t, warnings);
  return warnings;
}

}  // namespace glisson::contact
