// The one place where the format reader calls the mesh readers.
#include <glisson/models/format/reader.hpp>

#if __has_include(<glisson/models/mesh/read_mesh.hpp>)
#include <glisson/models/mesh/read_mesh.hpp>
#define GLISSON_HAS_MESH_FILES
#endif

namespace glisson::detail {

#ifdef GLISSON_HAS_MESH_FILES
Mesh mesh_from_file(const Reader& reader, const XmlElement& element) {
  std::vector<std::string> warnings;
  Mesh mesh = read_solid_mesh(reader.find_file(element, element.required_text()), &warnings);
  for (const auto& warning : warnings) reader.warn(element, warning);
  return mesh;
}

std::shared_ptr<const SurfaceDistance> distance_from_file(const Reader& reader, const XmlElement& element,
                                                          double reach) {
  std::vector<std::string> warnings;
  const auto surface = read_surface_mesh(reader.find_file(element, element.required_text()), &warnings);
  for (const auto& warning : warnings) reader.warn(element, warning);
  if (surface.facets.empty()) element.fail("the surface has no facets, so nothing has a distance to it");
  return std::make_shared<SurfaceDistance>(surface, reach);
}
#else
Mesh mesh_from_file(const Reader& reader, const XmlElement& element) {
  reader.find_file(element, element.required_text());
  element.fail("mesh files cannot be read by this build");
}

std::shared_ptr<const SurfaceDistance> distance_from_file(const Reader& reader, const XmlElement& element,
                                                          double) {
  reader.find_file(element, element.required_text());
  element.fail("mesh files cannot be read by this build");
}
#endif

}  // namespace glisson::detail
