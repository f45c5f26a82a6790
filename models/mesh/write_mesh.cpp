#include <glisson/models/mesh/write_mesh.hpp>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <ostream>

#include <glisson/core/base/error.hpp>
#include <glisson/core/mesh/surface.hpp>
#include <glisson/models/mesh/number_type.hpp>
#include <glisson/models/mesh/scanner.hpp>
#include <glisson/models/output/atomic_file.hpp>
#include <glisson/models/output/vtu_writer.hpp>

namespace glisson {
namespace {

/// Shortest text that reads back as the same number, whatever the locale.
template <class T>
std::string text_of(T value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

void write_gmsh_data(std::ostream& out, const char* section, const std::string& name, const NamedArray& array,
                     std::size_t count) {
  const auto components = static_cast<std::size_t>(array.components);
  if (components > 9)
    throw Error(ErrorKind::usage, "array " + detail::quoted(name) + " has " + text_of(components) +
                                      " components, but Gmsh files hold at most 9. Write a VTK file instead");
  const std::size_t padded = components == 1 ? 1 : components <= 3 ? 3 : 9;
  std::string plain = name;
  for (char& c : plain)
    if (c == '"' || c == '\n' || c == '\r') c = '_';
  out << '$' << section << "\n1\n\"" << plain << "\"\n1\n0\n3\n0\n"
      << text_of(padded) << '\n'
      << text_of(count) << '\n';
  for (std::size_t i = 0; i < count; ++i) {
    out << text_of(i + 1);
    for (std::size_t c = 0; c < padded; ++c)
      out << ' ' << (c < components ? text_of(array.values[i * components + c]) : "0");
    out << '\n';
  }
  out << "$End" << section << '\n';
}

/// The parts of a legacy VTK file, as text or as big-endian bytes.
class VtkWriter {
 public:
  VtkWriter(std::ostream& out, Encoding encoding) : out_(out), binary_(encoding == Encoding::binary) {}

  template <class T>
  void put(T value) {
    if (!binary_) {
      out_ << text_of(value) << ' ';
      return;
    }
    const T swapped = std::endian::native == std::endian::big
                          ? value
                          : detail::load<T>(reinterpret_cast<const char*>(&value), true);
    out_.write(reinterpret_cast<const char*>(&swapped), sizeof swapped);
  }
  void end() { out_ << '\n'; }

  /// Blanks and what is not plain ASCII as %xx.
  static std::string coded(const std::string& name) {
    constexpr char digits[] = "0123456789ABCDEF";
    std::string text;
    for (const char c : name) {
      const auto byte = static_cast<unsigned char>(c);
      if (c > ' ' && c < '\x7f' && c != '%' && c != '"')
        text += c;
      else
        text = text + '%' + digits[byte >> 4] + digits[byte & 15];
    }
    return text.empty() ? "unnamed" : text;
  }

  void put_arrays(const std::map<std::string, NamedArray>& arrays) {
    if (arrays.empty()) return;
    out_ << "FIELD FieldData " << text_of(arrays.size()) << '\n';
    for (const auto& [name, array] : arrays) {
      out_ << coded(name) << ' ' << text_of(array.components) << ' '
           << text_of(array.values.size() / static_cast<std::size_t>(array.components)) << " double\n";
      for (const double v : array.values) put(v);
      end();
    }
  }

 private:
  std::ostream& out_;
  bool binary_;
};

void put_cells(VtkWriter& writer, std::ostream& out, const Mesh& mesh) {
  const auto count = text_of(mesh.element_count());
  out << "CELLS " << count << ' ' << text_of(mesh.nodes.size() + mesh.shape.size()) << '\n';
  for (int e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.element(e);
    writer.put(static_cast<std::int32_t>(nodes.size()));
    for (const int n : nodes) writer.put(static_cast<std::int32_t>(n));
  }
  writer.end();
  out << "CELL_TYPES " << count << '\n';
  for (const Shape shape : mesh.shape)
    writer.put(static_cast<std::int32_t>(shape == Shape::tetrahedron ? 10 : 12));
  writer.end();
}

}  // namespace

void write_gmsh(std::ostream& out, const Mesh& mesh) {
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << text_of(mesh.X.size()) << '\n';
  for (std::size_t n = 0; n < mesh.X.size(); ++n)
    out << text_of(n + 1) << ' ' << text_of(mesh.X[n].x) << ' ' << text_of(mesh.X[n].y) << ' '
        << text_of(mesh.X[n].z) << '\n';
  out << "$EndNodes\n$Elements\n" << text_of(mesh.shape.size()) << '\n';
  for (int e = 0; e < mesh.element_count(); ++e) {
    const auto at = static_cast<std::size_t>(e);
    const auto label = text_of(mesh.label.empty() ? 0 : mesh.label[at]);
    out << text_of(e + 1) << (mesh.shape[at] == Shape::tetrahedron ? " 4 2 " : " 5 2 ") << label << ' '
        << label;
    for (const int n : mesh.element(e)) out << ' ' << text_of(n + 1);
    out << '\n';
  }
  out << "$EndElements\n";
  for (const auto& [name, array] : mesh.point_arrays)
    write_gmsh_data(out, "NodeData", name, array, mesh.X.size());
  for (const auto& [name, array] : mesh.cell_arrays)
    write_gmsh_data(out, "ElementData", name, array, mesh.shape.size());
}

void write_vtk(std::ostream& out, const Mesh& mesh, Encoding encoding) {
  VtkWriter writer(out, encoding);
  out << "# vtk DataFile Version 4.2\nmesh written by Glisson\n"
      << (encoding == Encoding::binary ? "BINARY" : "ASCII") << "\nDATASET UNSTRUCTURED_GRID\nPOINTS "
      << text_of(mesh.X.size()) << " double\n";
  for (const auto& x : mesh.X) {
    writer.put(x.x);
    writer.put(x.y);
    writer.put(x.z);
  }
  writer.end();
  put_cells(writer, out, mesh);
  if (!mesh.label.empty() || !mesh.cell_arrays.empty())
    out << "CELL_DATA " << text_of(mesh.element_count()) << '\n';
  if (!mesh.label.empty()) {
    out << "SCALARS label int 1\nLOOKUP_TABLE default\n";
    for (const int label : mesh.label) writer.put(static_cast<std::int32_t>(label));
    writer.end();
  }
  writer.put_arrays(mesh.cell_arrays);
  if (!mesh.point_arrays.empty()) out << "POINT_DATA " << text_of(mesh.X.size()) << '\n';
  writer.put_arrays(mesh.point_arrays);
}

void write_stl(std::ostream& out, const SurfaceMesh& surface) {
  const auto put = [&out](auto value) {
    if constexpr (std::endian::native == std::endian::big)
      value = detail::load<decltype(value)>(reinterpret_cast<const char*>(&value), true);
    out.write(reinterpret_cast<const char*>(&value), sizeof value);
  };
  std::string header = "surface written by Glisson";
  header.resize(80, ' ');
  std::size_t count = 0;
  for (const auto& facet : surface.facets) count += static_cast<std::size_t>(facet.node_count() - 2);
  out << header;
  put(static_cast<std::uint32_t>(count));
  for (const auto& facet : surface.facets)
    for (int t = 0; t + 2 < facet.node_count(); ++t) {
      const auto k = static_cast<std::size_t>(t);
      const Facet triangle{{facet.nodes[0], facet.nodes[k + 1], facet.nodes[k + 2], -1}, -1};
      const auto normal = facet_normal(triangle, surface.X);
      for (const double v : {normal.x, normal.y, normal.z}) put(static_cast<float>(v));
      for (std::size_t a = 0; a < 3; ++a) {
        const auto& x = surface.X[static_cast<std::size_t>(triangle.nodes[a])];
        for (const double v : {x.x, x.y, x.z}) put(static_cast<float>(v));
      }
      put(std::uint16_t{0});
    }
}

void write_surface(const std::string& path, const SurfaceMesh& surface) {
  if (!detail::same_word(std::filesystem::path(path).extension().string(), ".stl"))
    throw Error(ErrorKind::usage, "surfaces are written as .stl only; '" + path + "' has another extension");
  write_atomically(path, [&surface](std::ostream& out) { write_stl(out, surface); });
}

void write_mesh(const std::string& path, const Mesh& mesh, Encoding encoding) {
  const auto extension = std::filesystem::path(path).extension().string();
  const auto is = [&extension](const char* name) { return detail::same_word(extension, name); };
  if (is(".msh")) return write_atomically(path, [&mesh](std::ostream& out) { write_gmsh(out, mesh); });
  if (is(".vtk")) return write_atomically(path, [&](std::ostream& out) { write_vtk(out, mesh, encoding); });
  if (is(".vtu")) return write_vtu(path, mesh, {}, VtuOptions{OutputPrecision::full});
  if (is(".stl")) return write_surface(path, SurfaceMesh{mesh.X, outer_surface(mesh)});
  throw Error(ErrorKind::usage,
              "meshes are written as .msh, .vtk, .vtu or .stl; '" + path + "' has another extension");
}

}  // namespace glisson
