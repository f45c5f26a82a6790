// SubModel: levels are read on their own, joined in the order of the document, and near nodes merged.
#include <algorithm>

#include <glisson/models/format/reader.hpp>

namespace glisson::detail {
namespace {

/// Calls body(list) for every list of nodes and body_facets(list) for every list of facets that is not a mesh's own.
template <class Nodes, class Facets>
void for_each_list(Model& model, Nodes nodes, Facets facets) {
  for (auto& c : model.fixed) nodes(c.nodes);
  for (auto& c : model.displacements) nodes(c.nodes);
  for (auto& c : model.forces) nodes(c.nodes);
  for (auto& c : model.gravity) nodes(c.nodes);
  for (auto& c : model.springs) nodes(c.nodes);
  for (auto& c : model.planes) nodes(c.nodes);
  for (auto& c : model.initial_velocities) nodes(c.nodes);
  for (auto& c : model.pressures) facets(c.facets);
  for (auto& c : model.tractions) facets(c.facets);
}

}  // namespace

Part read_level(const Reader& reader, const XmlElement& level) {
  Part part;
  if (const auto sub = level.child("SubModel")) sub->fail("sub-models are not supported yet");
  read_geometry(reader, level, part);
  read_element_sets(reader, level, part);
  read_constraints(reader, level, part);
  return part;
}

}  // namespace glisson::detail
