// Facets of a surface load in the engine's order and the sum over the facets of a node.
#pragma once

#include <vector>

#include <glisson/core/loads/list_forces.hpp>
#include <glisson/core/loads/node_list.hpp>

namespace glisson {

/// Area vector N = a x b of a facet (|N| = twice its area), a and b differences of two corners: 1-0 and 2-0
/// of a triangle, the diagonals 2-0 and 3-1 of a quadrilateral. Differences keep the digits of float where
/// positions would lose them.
template <class R>
struct LoadFacet {
  int a_from, a_to, b_from, b_to;  ///< internal nodes [-]
  Vec3<R> a, b;                    ///< at rest [m]
  R corner_share;                  ///< 1 / (2 corner count): share of |N| that a corner gets [-]

  GLISSON_HD Vec3<R> area_vector(const Vec4<R>* u) const {
    return cross(a + (xyz(u[a_to]) - xyz(u[a_from])), b + (xyz(u[b_to]) - xyz(u[b_from])));
  }
};

/// Every corner of a facet gets the same force: sum of the facets around a node, in their order in the list.
template <class R>
struct GatherFacets : LastForces<R> {
  const int* begin;       ///< [entry_count + 1]
  const int* facets;      ///< [begin[entry_count]]
  const Vec4<R>* forces;  ///< on each corner of a facet [N]  [facet_count]

  GLISSON_HD Vec3<R> force(int i, int) const {
    Vec3<R> sum;
    for (int k = begin[i]; k < begin[i + 1]; ++k) sum = sum + xyz(forces[facets[k]]);
    return sum;
  }
};

/// Facets and their incidence on the backend.
template <Backend B, class R>
class FacetSet {
 public:
  FacetSet(B& backend, const std::vector<Facet>& facets, const std::vector<Vec3<double>>& X,
           const Numbering& numbering)
      : facet_count_(static_cast<int>(facets.size())) {
    std::vector<LoadFacet<R>> local;
    std::map<int, std::vector<int>> facets_of_node;
    for (const Facet& facet : facets) {
      local.push_back(make(facet, X, numbering));
      for (int c = 0; c < facet.node_count(); ++c)
        facets_of_node[detail::internal_node(numbering, facet.nodes[std::size_t(c)])].push_back(
            int(local.size()) - 1);
    }
    std::vector<int> begin{0}, list;
    for (const auto& [node, its_facets] : facets_of_node) {
      list.insert(list.end(), its_facets.begin(), its_facets.end());
      begin.push_back(static_cast<int>(list.size()));
    }
    node_count_ = static_cast<int>(facets_of_node.size());
    facets_ = detail::upload(backend, local);
    nodes_ = detail::upload(backend, detail::keys(facets_of_node));
    begin_ = detail::upload(backend, begin);
    list_ = detail::upload(backend, list);
    forces_ = detail::zeros<Vec4<R>>(backend, facets.size());
    last_ = detail::zeros<Vec4<R>>(backend, std::size_t(node_count_));
  }

  int facet_count() const { return facet_count_; }
  int node_count() const { return node_count_; }
  const LoadFacet<R>* facets() const { return facets_.get(); }
  const int* nodes() const { return nodes_.get(); }
  Vec4<R>* forces() const { return forces_.get(); }
  const Buffer<Vec4<R>>& last() const { return last_; }
  GatherFacets<R> gather() const { return {{last_.get()}, begin_.get(), list_.get(), forces_.get()}; }

 private:
  static LoadFacet<R> make(const Facet& facet, const std::vector<Vec3<double>>& X,
                           const Numbering& numbering) {
    const bool quad = facet.node_count() == 4;
    const int ends[4] = {facet.nodes[0], facet.nodes[quad ? 2 : 1], facet.nodes[quad ? 1 : 0],
                         facet.nodes[quad ? 3 : 2]};
    int n[4];
    for (int k = 0; k < 4; ++k) n[k] = detail::internal_node(numbering, ends[k]);
    const auto at = [&](int k) { return X[std::size_t(ends[k])]; };
    const auto a = at(1) - at(0), b = at(3) - at(2);
    return {n[0],
            n[1],
            n[2],
            n[3],
            {R(a.x), R(a.y), R(a.z)},
            {R(b.x), R(b.y), R(b.z)},
            R(quad ? 1.0 / 8 : 1.0 / 6)};
  }

  int facet_count_, node_count_ = 0;
  Buffer<LoadFacet<R>> facets_;
  Buffer<int> nodes_, begin_, list_;
  Buffer<Vec4<R>> forces_, last_;
};

}  // namespace glisson
