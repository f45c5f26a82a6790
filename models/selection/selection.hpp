// Which nodes or surface facets a load or a boundary condition acts on, by place, direction, label or
// distance, combined by and, or, not. All in the rest configuration.
#pragma once

#include <glisson/core/mesh/mesh.hpp>
#include <glisson/models/selection/distance.hpp>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace glisson {

/// A tree: leaves are sets, inner nodes combine them. As a set of facets, a region in space holds the facets
/// whose centre it holds, a list of nodes the facets that have all their nodes in it, and a label those of
/// the labelled elements.
struct Selection {
  enum class Kind {
    all,      ///< every node; every facet of the outer surface
    surface,  ///< nodes of the outer surface; every facet of it
    nodes,    ///< `integers`: node indices
    label,    ///< `integers`: element labels
    normal,   ///< numbers: direction x y z (unit), angle [degrees]: outward normal within less than the angle
    box,      ///< numbers: xmin xmax ymin ymax zmin zmax, ends included
    sphere,   ///< numbers: radius, centre x y z; |x - c| < r
    half_space,  ///< numbers: point x y z, normal x y z; (x - p) . n >= 0
    distance,    ///< numbers: largest distance [m] to `surface`, included
    both,        ///< in every one of `parts`
    either,      ///< in at least one of `parts`
    neither,     ///< in none of `parts`
  };
  Kind kind = Kind::all;
  std::array<double, 6> numbers{};
  std::vector<int> integers;
  std::shared_ptr<const SurfaceDistance> to_surface;
  std::vector<Selection> parts;
};

/// A mesh with its outer surface, which is found at the first need, or with other facets.
class SelectionMesh {
 public:
  explicit SelectionMesh(const Mesh& mesh) : mesh_(mesh) {}
  /// Instead of the outer surface these facets, with a label each.  [facets]
  SelectionMesh(const Mesh& mesh, std::vector<Facet> facets, std::vector<int> labels)
      : mesh_(mesh), surface_(std::move(facets)), facet_labels_(std::move(labels)) {}

  const Mesh& mesh() const { return mesh_; }
  const std::vector<Facet>& surface() const;
  std::vector<int> nodes(const Selection& selection) const;        ///< sorted, each once
  std::vector<Facet> facets(const Selection& selection) const;     ///< of the outer surface, in its order
  std::vector<char> facet_mask(const Selection& selection) const;  ///< 1 where selected  [facet_count]
  /// 1 where the node is selected.  [node_count]
  std::vector<char> node_mask(const Selection& selection) const;

 private:
  int label_of(std::size_t facet) const;
  std::vector<char> labelled_nodes(const std::vector<int>& labels) const;

  const Mesh& mesh_;
  mutable std::optional<std::vector<Facet>> surface_;
  std::vector<int> facet_labels_;  ///< of given facets
};

}  // namespace glisson
