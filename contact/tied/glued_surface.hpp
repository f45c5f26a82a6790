// The surface of a named body at rest, for gluing: points on it with their shape functions, nearest points.
#pragma once

#include <array>
#include <map>
#include <vector>

#include <glisson/contact/bvh/pairs.hpp>
#include <glisson/contact/deformable/contact_facets.hpp>

namespace glisson::contact {

/// A point of a facet that stands for a piece of it.
struct FacetSample {
  Vec3<double> x, normal;         ///< [m], unit
  bool of_sheet = false;          ///< the normal may point to either side
  double area = 0;                ///< [m^2]
  int count = 0;                  ///< corners
  std::array<int, 4> node{};      ///< of the mesh
  std::array<double, 4> shape{};  ///< shape functions there
  /// Combinations of the shape functions of the facet with integral dual_i shape_j = 0 for i != j and
  /// integral shape_i for i = j.
  std::array<double, 4> dual{};
};

struct NearPoint {
  double distance = 1e300;  ///< [m]
  int count = 0;
  std::array<int, 4> node{};       ///< corners of its facet
  std::array<double, 4> weight{};  ///< shape functions there
};

class GluedSurface {
 public:
  /// The outer facets of a body, as ContactFacet::body; of sheets, their middles.
  GluedSurface(const Model& model, const ContactFacets& facets, int body);

  int facet_count() const { return static_cast<int>(facets_.size()); }
  std::vector<FacetSample> samples(int facet) const;
  /// The nearest point of facets that face the sample, within the distance; beyond it, possibly none.
  NearPoint nearest(const FacetSample& from, double distance) const;
  /// Integral of the shape function of a node over the surface [m^2]
  double area_at(int node) const { return area_.at(node); }
  double edge_length() const { return edge_length_; }  ///< shortest [m]

 private:
  struct Facet {
    std::array<int, 4> node{-1, -1, -1, -1};
    bool of_sheet = false;
    int count() const { return node[3] < 0 ? 3 : 4; }
  };
  /// A triangle or a quarter of a quadrilateral about its centre, as contact has them.
  struct Piece {
    int facet = 0;
    std::array<std::array<double, 4>, 3> shape{};  ///< of the facet, at the corners of the piece
    std::array<Vec3<double>, 3> x;
    Vec3<double> normal;  ///< unit
  };
  void cut(int facet);
  void add_piece(int facet, const std::array<std::array<double, 4>, 3>& shape,
                 const std::array<Vec3<double>, 3>& x);
  static bool faces(const FacetSample& sample, const Piece& piece, const Facet& facet);

  const Model& model_;
  std::vector<Facet> facets_;
  std::vector<Piece> pieces_;
  std::vector<int> first_piece_;  ///< [facet_count + 1]
  std::map<int, double> area_;
  double edge_length_ = 0;
  Hierarchy hierarchy_;  ///< of the pieces
};

}  // namespace glisson::contact
