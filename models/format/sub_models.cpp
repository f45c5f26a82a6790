// A level of the tree: its own mesh, or its sub-models joined in the order of the document and merged where
// they touch.
#include <glisson/models/format/join_parts.hpp>

namespace glisson::detail {
namespace {

void read_sub_models(const Reader& reader, const XmlElement& level, Part& part) {
  for (const auto sub : level.all("SubModel")) {
    Part its = read_level(reader, *sub);
    name_body(*sub, its);
    for (const NamedElements& body : its.model.bodies_by_name)
      for (const NamedElements& other : part.model.bodies_by_name)
        if (body.name == other.name)
          sub->fail("the Name \"" + body.name + "\" is used twice; contact pairs need different ones");
    append(part, std::move(its));
  }
  for (const auto name : {"Nodes", "Elements", "MSHMesh", "VTKMesh", "VTUMesh", "Mesh"})
    if (const auto own = level.child(name))
      reader.warn(*own, "it is not used: the geometry of a level with sub-models is theirs");
}

void merge(const Reader& reader, const XmlElement& level, Part& part) {
  const auto distance = level.child("SubModelNodeMergerDistance");
  if (distance == nullptr) return;
  const double value = distance->number();
  if (!(value > 0)) return;  // as the format says: no merging
  const int merged = merge_nodes(part, value, *distance);
  if (merged > 0 && !part.model.mesh.triangles.empty()) check_shell_mesh(reader, *distance, part);
  if (merged == 0)
    reader.warn(*distance, "no two nodes are that near, so the sub-models are not connected by it");
}

}  // namespace

Part read_level(const Reader& reader, const XmlElement& level) {
  Part part;
  if (level.child("SubModel") != nullptr) {
    read_sub_models(reader, level, part);
    merge(reader, level, part);
  } else {
    read_geometry(reader, level, part);
  }
  read_shell_elements(reader, level, part);
  read_element_sets(reader, level, part);
  read_shell_sets(reader, level, part);
  read_constraints(reader, level, part);
  return part;
}

}  // namespace glisson::detail
