#include <glisson/models/output/vtu_writer.hpp>

#include <algorithm>
#include <glisson/core/base/error.hpp>
#include <glisson/models/output/atomic_file.hpp>
#include <glisson/models/output/vtk_xml_encoding.hpp>
#include <limits>
#include <ostream>
#include <set>

namespace glisson {
namespace {

using detail::write_array;
using detail::write_field;

/// The fields, then those arrays of the mesh that no field hides.
std::vector<Field> merged(const std::vector<Field>& fields, const std::map<std::string, NamedArray>& of_mesh,
                          std::set<std::string> taken) {
  std::vector<Field> all;
  for (const Field& f : fields) {
    if (!taken.insert(f.name).second)
      throw Error(ErrorKind::usage,
                  "array '" + f.name + "' is given twice; a file holds one array per name.");
    all.push_back(f);
  }
  for (const auto& [name, array] : of_mesh)
    if (!taken.contains(name)) all.push_back({name, array.components, array.values});
  return all;
}

/// Everything that goes into the file, checked.
Fields checked(const Mesh& mesh, const Fields& fields, const VtuOptions& options) {
  const std::map<std::string, NamedArray> none;
  Fields all;
  all.point = merged(fields.point, options.mesh_arrays ? mesh.point_arrays : none, {});
  const std::set<std::string> taken =
      mesh.label.empty() ? std::set<std::string>{} : std::set<std::string>{"label"};
  all.cell = merged(fields.cell, options.mesh_arrays ? mesh.cell_arrays : none, taken);
  require_finite(all, mesh.X.size(), mesh.shape.size(), detail::largest_value(options.precision));
  const Fields rest{{field("position", std::span(mesh.X))}, {}};
  require_finite(rest, mesh.X.size(), mesh.shape.size(), std::numeric_limits<double>::max());
  if (!mesh.label.empty() && mesh.label.size() != mesh.shape.size())
    throw Error(ErrorKind::usage, "the mesh has " + std::to_string(mesh.shape.size()) + " elements and " +
                                      std::to_string(mesh.label.size()) +
                                      " labels. Give one label per element.");
  return all;
}

void write_cells(std::ostream& out, const Mesh& mesh, int level) {
  constexpr std::uint8_t vtk_tetra = 10, vtk_hexahedron = 12;
  std::vector<std::uint8_t> types(mesh.shape.size());
  std::transform(mesh.shape.begin(), mesh.shape.end(), types.begin(),
                 [](Shape shape) { return shape == Shape::tetrahedron ? vtk_tetra : vtk_hexahedron; });
  out << "<Cells>\n";
  write_array<std::int32_t>(out, "connectivity", 1, mesh.nodes, level);
  write_array<std::int32_t>(out, "offsets", 1, std::span(mesh.begin).subspan(1), level);
  write_array<std::uint8_t>(out, "types", 1, types, level);
  out << "</Cells>\n";
}

void write_checked(std::ostream& out, const Mesh& mesh, const Fields& fields, const VtuOptions& options) {
  const int level = options.compression;
  detail::begin_vtk_file(out, "UnstructuredGrid", options);
  out << "<Piece NumberOfPoints=\"" << std::to_string(mesh.X.size()) << "\" NumberOfCells=\""
      << std::to_string(mesh.shape.size()) << "\">\n<Points>\n";
  write_array(out, "Points", 3, field("", std::span(mesh.X)).values, level);
  out << "</Points>\n";
  write_cells(out, mesh, level);
  out << "<PointData>\n";
  for (const Field& f : fields.point) write_field(out, f, options);
  out << "</PointData>\n<CellData>\n";
  if (!mesh.label.empty()) write_array<std::int32_t>(out, "label", 1, mesh.label, level);
  for (const Field& f : fields.cell) write_field(out, f, options);
  out << "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace

void write_vtu(std::ostream& out, const Mesh& mesh, const Fields& fields, const VtuOptions& options) {
  write_checked(out, mesh, checked(mesh, fields, options), options);
}

void write_vtu(const std::filesystem::path& path, const Mesh& mesh, const Fields& fields,
               const VtuOptions& options, const std::string& state) {
  const Fields all = checked(mesh, fields, options);
  write_atomically(
      path, [&](std::ostream& out) { write_checked(out, mesh, all, options); }, state);
}

}  // namespace glisson
