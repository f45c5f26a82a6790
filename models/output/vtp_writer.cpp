#include <glisson/models/output/vtp_writer.hpp>

#include <glisson/models/output/atomic_file.hpp>
#include <glisson/models/output/vtk_xml_encoding.hpp>
#include <limits>
#include <ostream>

namespace glisson {
namespace {

using detail::write_array;

void check(const TriangleSurface& surface, const Fields& fields, const VtuOptions& options) {
  const std::size_t points = surface.X.size(), triangles = surface.triangles.size();
  require_finite(fields, points, triangles, detail::largest_value(options.precision), "triangle");
  const Fields rest{{field("position", std::span(surface.X))}, {}};
  require_finite(rest, points, triangles, std::numeric_limits<double>::max());
}

void write_triangles(std::ostream& out, const TriangleSurface& surface, int level) {
  std::vector<std::int32_t> nodes, offsets;
  nodes.reserve(3 * surface.triangles.size());
  offsets.reserve(surface.triangles.size());
  for (const auto& t : surface.triangles) {
    nodes.insert(nodes.end(), t.begin(), t.end());
    offsets.push_back(static_cast<std::int32_t>(nodes.size()));
  }
  out << "<Polys>\n";
  write_array<std::int32_t>(out, "connectivity", 1, nodes, level);
  write_array<std::int32_t>(out, "offsets", 1, offsets, level);
  out << "</Polys>\n";
}

void write_checked(std::ostream& out, const TriangleSurface& surface, const Fields& fields,
                   const VtuOptions& options) {
  detail::begin_vtk_file(out, "PolyData", options);
  out << "<Piece NumberOfPoints=\"" << std::to_string(surface.X.size())
      << "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\""
      << std::to_string(surface.triangles.size()) << "\">\n<PointData>\n";
  for (const Field& f : fields.point) detail::write_field(out, f, options);
  out << "</PointData>\n<CellData>\n";
  for (const Field& f : fields.cell) detail::write_field(out, f, options);
  out << "</CellData>\n<Points>\n";
  write_array(out, "Points", 3, field("", std::span(surface.X)).values, options.compression);
  out << "</Points>\n";
  write_triangles(out, surface, options.compression);
  out << "</Piece>\n</PolyData>\n</VTKFile>\n";
}

}  // namespace

void write_vtp(std::ostream& out, const TriangleSurface& surface, const Fields& fields,
               const VtuOptions& options) {
  check(surface, fields, options);
  write_checked(out, surface, fields, options);
}

void write_vtp(const std::filesystem::path& path, const TriangleSurface& surface, const Fields& fields,
               const VtuOptions& options, const std::string& state) {
  check(surface, fields, options);
  write_atomically(
      path, [&](std::ostream& out) { write_checked(out, surface, fields, options); }, state);
}

}  // namespace glisson
