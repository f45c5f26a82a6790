#include <glisson/models/selection/selection.hpp>

#include <glisson/core/mesh/surface.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glisson {
namespace {

using Kind = Selection::Kind;

bool in_region(const Selection& s, const Vec3<double>& x) {
  const auto& v = s.numbers;
  switch (s.kind) {
    case Kind::box:
      return v[0] <= x.x && x.x <= v[1] && v[2] <= x.y && x.y <= v[3] && v[4] <= x.z && x.z <= v[5];
    case Kind::sphere: {
      const Vec3<double> d = x - Vec3<double>{v[1], v[2], v[3]};
      return std::sqrt(dot(d, d)) < v[0];
    }
    case Kind::half_space:
      return dot(x - Vec3<double>{v[0], v[1], v[2]}, Vec3<double>{v[3], v[4], v[5]}) >= 0;
    case Kind::distance:
      return s.to_surface->within(x, v[0]);
    default:
      return true;
  }
}

bool faces(const Selection& s, const Vec3<double>& normal) {
  if (dot(normal, normal) == 0) return false;
  const double cosine = dot(normal, {s.numbers[0], s.numbers[1], s.numbers[2]});
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * (180 / std::numbers::pi) < s.numbers[3];
}

bool holds(const std::vector<int>& values, int value) {
  return std::find(values.begin(), values.end(), value) != values.end();
}

int label_of_element(const Mesh& mesh, int e) {
  return mesh.label.empty() || e < 0 ? 0 : mesh.label[static_cast<std::size_t>(e)];
}

/// and, or, not of masks that `mask_of` gives for the parts.
template <class MaskOf>
std::vector<char> combined(const Selection& s, std::size_t size, MaskOf mask_of) {
  std::vector<char> mask(size, s.kind == Kind::both);
  for (const auto& part : s.parts) {
    const std::vector<char> other = mask_of(part);
    for (std::size_t i = 0; i < size; ++i)
      mask[i] = s.kind == Kind::both ? static_cast<char>(mask[i] & other[i])
                                     : static_cast<char>(mask[i] | other[i]);
  }
  if (s.kind == Kind::neither)
    for (auto& m : mask) m = m == 0;
  return mask;
}

bool combines(Kind kind) { return kind == Kind::both || kind == Kind::either || kind == Kind::neither; }

std::vector<char> listed(const std::vector<int>& nodes, std::size_t size) {
  std::vector<char> mask(size, 0);
  for (const int n : nodes)
    if (n >= 0 && static_cast<std::size_t>(n) < size) mask[static_cast<std::size_t>(n)] = 1;
  return mask;
}

}  // namespace

const std::vector<Facet>& SelectionMesh::surface() const {
  if (!surface_) surface_ = outer_surface(mesh_);
  return *surface_;
}

int SelectionMesh::label_of(std::size_t facet) const {
  const int e = surface()[facet].element;
  return e < 0 && facet < facet_labels_.size() ? facet_labels_[facet] : label_of_element(mesh_, e);
}

std::vector<char> SelectionMesh::labelled_nodes(const std::vector<int>& labels) const {
  std::vector<char> mask(mesh_.X.size(), 0);
  for (int e = 0; e < mesh_.element_count(); ++e)
    if (holds(labels, label_of_element(mesh_, e)))
      for (const int n : mesh_.element(e)) mask[static_cast<std::size_t>(n)] = 1;
  for (std::size_t i = 0; i < facet_labels_.size(); ++i)
    if (holds(labels, facet_labels_[i]))
      for (int a = 0; a < surface()[i].node_count(); ++a)
        mask[static_cast<std::size_t>(surface()[i].nodes[static_cast<std::size_t>(a)])] = 1;
  return mask;
}

std::vector<char> SelectionMesh::node_mask(const Selection& s) const {
  const std::size_t size = mesh_.X.size();
  if (combines(s.kind)) return combined(s, size, [&](const Selection& part) { return node_mask(part); });
  if (s.kind == Kind::all) return std::vector<char>(size, 1);
  if (s.kind == Kind::nodes) return listed(s.integers, size);
  if (s.kind == Kind::label) return labelled_nodes(s.integers);
  if (s.kind == Kind::surface || s.kind == Kind::normal) return listed(nodes_of(facets(s)), size);
  std::vector<char> mask(size);
  for (std::size_t n = 0; n < size; ++n) mask[n] = in_region(s, mesh_.X[n]);
  return mask;
}

std::vector<char> SelectionMesh::facet_mask(const Selection& s) const {
  const auto& all = surface();
  if (combines(s.kind))
    return combined(s, all.size(), [&](const Selection& part) { return facet_mask(part); });
  const auto listed_nodes = s.kind == Kind::nodes ? listed(s.integers, mesh_.X.size()) : std::vector<char>();
  std::vector<char> mask(all.size(), 1);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Facet& facet = all[i];
    if (s.kind == Kind::nodes)
      for (int a = 0; a < facet.node_count(); ++a)
        mask[i] &= listed_nodes[static_cast<std::size_t>(facet.nodes[static_cast<std::size_t>(a)])];
    else if (s.kind == Kind::label)
      mask[i] = holds(s.integers, label_of(i));
    else if (s.kind == Kind::normal)
      mask[i] = faces(s, facet_normal(facet, mesh_.X));
    else
      mask[i] = in_region(s, facet_centre(facet, mesh_.X));
  }
  return mask;
}

std::vector<int> SelectionMesh::nodes(const Selection& selection) const {
  const auto mask = node_mask(selection);
  std::vector<int> nodes;
  for (std::size_t n = 0; n < mask.size(); ++n)
    if (mask[n] != 0) nodes.push_back(static_cast<int>(n));
  return nodes;
}

std::vector<Facet> SelectionMesh::facets(const Selection& selection) const {
  const auto mask = facet_mask(selection);
  std::vector<Facet> chosen;
  for (std::size_t i = 0; i < mask.size(); ++i)
    if (mask[i] != 0) chosen.push_back(surface()[i]);
  return chosen;
}

}  // namespace glisson
