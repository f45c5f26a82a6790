// The one place where the format reader calls the mesh readers.
#include <glisson/models/format/reader.hpp>
#include <glisson/models/mesh/read_mesh.hpp>

namespace glisson::detail {

Mesh mesh_from_file(const Reader& reader, const XmlElement& element) {
  std::vector<std::string> warnings;
  Mesh mesh = read_solid_mesh(reader.find_file(element, element.required_text()), &warnings);
  for (const auto& warning : warnings) reader.warn(element, warning);
  return mesh;
}

SurfaceMesh surface_from_file(const Reader& reader, const XmlElement& element, std::string* found) {
  std::vector<std::string> warnings;
  const std::string path = reader.find_file(element, element.required_text());
  if (found != nullptr) *found = path;
  SurfaceMesh surface = read_surface_mesh(path, &warnings);
  for (const auto& warning : warnings) reader.warn(element, warning);
  return surface;
}

LabelledSurface labelled_surface_from_file(const Reader& reader, const XmlElement& element) {
  std::vector<std::string> warnings;
  auto surface = read_labelled_surface(reader.find_file(element, element.required_text()), &warnings);
  for (const auto& warning : warnings) reader.warn(element, warning);
  return surface;
}

std::shared_ptr<const SurfaceDistance> distance_from_file(const Reader& reader, const XmlElement& element,
                                                          double reach) {
  const auto surface = surface_from_file(reader, element);
  if (surface.facets.empty()) element.fail("the surface has no facets, so nothing has a distance to it");
  return std::make_shared<SurfaceDistance>(surface, reach);
}

}  // namespace glisson::detail
