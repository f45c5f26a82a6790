#include <glisson/models/output/write_state.hpp>

#include <glisson/models/output/shell_sheets.hpp>
#include <glisson/models/output/vtk_xml_encoding.hpp>

namespace glisson {

namespace {

/// All that may be wrong with the numbers is found before the first file is written.
void check(const Mesh& mesh, const Snapshot& snapshot, const ShellSheet& mid, const VtuOptions& options) {
  const double largest = detail::largest_value(options.precision);
  require_finite(snapshot.fields(), mesh.X.size(), mesh.shape.size(), largest);
  require_finite(mid.fields(), mid.surface.X.size(), mesh.triangles.size(), largest, "shell triangle");
}

}  // namespace

std::vector<std::string> write_state(const std::filesystem::path& directory, const std::string& stem,
                                     const Mesh& mesh, const Snapshot& snapshot, VtuOptions options,
                                     const std::string& state) {
  options.time = snapshot.time;
  std::vector<std::string> names{stem + ".vtu"};
  if (snapshot.shells.size() > 0) {
    const ShellSheet mid = mid_surface(mesh, snapshot), faces = shell_faces(mesh, snapshot);
    check(mesh, snapshot, mid, options);
    names.push_back(stem + ".vtp");
    names.push_back(stem + "_faces.vtp");
    write_vtp(directory / names[2], faces.surface, faces.fields(), options, state);
    write_vtp(directory / names[1], mid.surface, mid.fields(), options, state);
  }
  write_vtu(directory / names[0], mesh, snapshot.fields(), options, state);
  return names;
}

}  // namespace glisson
