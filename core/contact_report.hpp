// What contact providers tell about themselves besides their forces.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glisson/core/tensor/tensor.hpp>

namespace glisson {

/// What contact did since the start of the process. Of something rigid only `volumes`, `candidates` and
/// `seconds`: its tree is never refitted, and every node walks it in every step. Seconds are wall time; on a
/// device those outside of searches are the time of the launches.
struct ContactSearchReport {
  std::int64_t volumes = 0;           ///< boxes of the hierarchy; 0 for analytic bodies
  std::int64_t searches = 0;          ///< lists of candidates made
  std::int64_t looks = 0;             ///< steps in which the host looked whether that was due
  std::int64_t volumes_refitted = 0;  ///< over all searches, like the next two
  std::int64_t subtrees_tested = 0;   ///< whose children were tested against each other
  std::int64_t triangle_pairs = 0;    ///< with overlapping boxes
  std::int64_t candidates = 0;        ///< node-facet and edge-edge pairs of the present list; rigid: nodes
  double refit_seconds = 0;           ///< of the searches: boxes and cones
  double pair_seconds = 0;            ///< of the searches: pairs of triangles
  double list_seconds = 0;            ///< of the searches: lists of nodes with facets and of edges
  double search_seconds = 0;          ///< the searches with what brings data to and from the device
  double touch_seconds = 0;           ///< finding touches among the candidates
  double force_seconds = 0;           ///< their forces
  double seconds = 0;                 ///< all of contact
};

/// State of a contact pair at the last step of a run with energies.
struct ContactReport {
  bool between_bodies = false;  ///< of deformable bodies; else of something rigid
  double depth = 0;          ///< largest penetration of the nodes [m]
  double largest_depth = 0;  ///< the same over the run [m]
  double start_depth = 0;    ///< in the file already [m]
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
