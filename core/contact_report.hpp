// What contact providers tell about themselves besides their forces.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glisson/core/tensor/tensor.hpp>

namespace glisson {

/// What the search for candidates did since the start of the process.
struct ContactSearchReport {
  std::int64_t searches = 0;          ///< lists of candidates made
  std::int64_t volumes_refitted = 0;  ///< of the bounding volume hierarchy
  std::int64_t subtrees_tested = 0;   ///< whose children were tested against each other
  std::int64_t triangle_pairs = 0;    ///< with overlapping boxes, over all searches
  std::int64_t candidates = 0;        ///< node-facet and edge-edge pairs of the present list
  double search_seconds = 0;          ///< wall time of the searches
  double seconds = 0;                 ///< wall time of contact with them; on a device: of its launches
};

/// State of a contact pair at the last step of a run with energies.
struct ContactReport {
  double depth = 0;          ///< largest penetration of the nodes [m]
  double largest_depth = 0;  ///< the same over the run [m]
  double start_depth = 0;    ///< in the file already, between deformable bodies [m]
  int node_count = 0;        ///< nodes that were pushed; of deformable bodies: contacts that press
  Vec3<double> force;        ///< of a rigid body on the nodes [N]
  ContactSearchReport search;
};

struct NamedContact {
  std::string name;  ///< of the provider
  ContactReport report;
};

/// What reports contact; every provider of rigid bodies, rigid surfaces and deformable bodies does
/// (dynamic_cast).
class ContactSource {
 public:
  virtual ~ContactSource() = default;
  virtual ContactReport report() const = 0;
  /// Adds the contact forces of the last step (rigid bodies: of the last account of energies) [N], internal
  /// node order.  [node_count]
  virtual void add_node_forces(std::vector<Vec3<double>>& f) const = 0;
};

}  // namespace glisson
