#include <glisson/models/mesh/read_mesh.hpp>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>

#include <glisson/core/base/error.hpp>
#include <glisson/models/mesh/formats.hpp>
#include <glisson/models/mesh/keep_nodes.hpp>
#include <glisson/models/mesh/scanner.hpp>

namespace glisson {
namespace {

constexpr const char* known_names =
    "Readable are .msh (Gmsh 2.2 and 4.1), .vtk, .vtu, .vtp, .stl, .ply, .off and .obj";

std::string contents_of(const std::string& path) {
  std::error_code problem;
  const auto status = std::filesystem::status(path, problem);
  const Place place{path, 0, {}};
  if (!std::filesystem::exists(status))
    throw Error(ErrorKind::input,
                "there is no such file (looked for from the folder '" +
                    std::filesystem::current_path(problem).string() + "'). Check the path",
                place);
  if (std::filesystem::is_directory(status))
    throw Error(ErrorKind::input, "this is a folder, but a mesh file is needed", place);
  if (!std::filesystem::is_regular_file(status))
    throw Error(ErrorKind::input, "this is a device or a pipe, but a mesh file is needed", place);
  std::ifstream in(path, std::ios::binary);
  if (!in) throw Error(ErrorKind::input, std::string("cannot be opened: ") + std::strerror(errno), place);
  std::string text;
  const auto size_hint = std::filesystem::file_size(path, problem);
  if (!problem) text.reserve(size_hint + (1 << 20));
  constexpr std::size_t chunk = 1 << 20;
  for (std::size_t size = 0; in; text.resize(size += static_cast<std::size_t>(in.gcount()))) {
    text.resize(size + chunk);
    in.read(text.data() + size, chunk);
  }
  if (in.bad()) throw Error(ErrorKind::input, std::string("cannot be read: ") + std::strerror(errno), place);
  return text;
}

struct FormatName {
  const char* extension;
  MeshFormat format;
};
constexpr FormatName format_names[] = {{".msh", MeshFormat::gmsh},    {".vtk", MeshFormat::vtk},
                                       {".vtu", MeshFormat::vtk_xml}, {".vtp", MeshFormat::vtk_xml},
                                       {".stl", MeshFormat::stl},     {".ply", MeshFormat::ply},
                                       {".off", MeshFormat::off},     {".obj", MeshFormat::obj}};

std::optional<MeshFormat> format_by_beginning(std::string_view text) {
  if (text.starts_with("$MeshFormat")) return MeshFormat::gmsh;
  if (text.starts_with("# vtk DataFile")) return MeshFormat::vtk;
  if (text.starts_with("<?xml") || text.starts_with("<VTKFile")) return MeshFormat::vtk_xml;
  if (text.starts_with("ply\n") || text.starts_with("ply\r\n")) return MeshFormat::ply;
  if (text.starts_with("OFF")) return MeshFormat::off;
  if (text.starts_with("solid")) return MeshFormat::stl;
  return {};
}

void refuse_other_contents(std::string_view text, const std::string& file, MeshFormat format) {
  const Place place{file, 0, {}};
  if (text.empty()) throw Error(ErrorKind::input, "the file is empty", place);
  if (text.starts_with("\x1f\x8b"))
    throw Error(ErrorKind::input, "the file is compressed with gzip. Unpack it first (gunzip)", place);
  const auto found = format_by_beginning(text);
  if (!found || *found == format || *found == MeshFormat::stl) return;
  for (const auto& [extension, its_format] : format_names)
    if (its_format == *found)
      throw Error(ErrorKind::input,
                  "the contents begin like a " + std::string(extension) +
                      " file, which does not fit the name. Rename the file",
                  place);
}

detail::RawMesh parse(std::string_view text, const std::string& file, MeshFormat format) {
  refuse_other_contents(text, file, format);
  switch (format) {
    case MeshFormat::gmsh:
      return detail::parse_gmsh(text, file);
    case MeshFormat::vtk:
      return detail::parse_vtk(text, file);
    case MeshFormat::vtk_xml:
      return detail::parse_vtk_xml(text, file);
    case MeshFormat::stl:
      return detail::parse_stl(text, file);
    case MeshFormat::ply:
      return detail::parse_ply(text, file);
    case MeshFormat::off:
      return detail::parse_off(text, file);
    case MeshFormat::obj:
      return detail::parse_obj(text, file);
  }
  throw Error(ErrorKind::usage, "no such mesh format");
}

void hand_over(std::vector<std::string>& from, const std::string& file, Warnings* to) {
  if (to == nullptr) return;
  for (const auto& warning : from) to->push_back(located({file, 0, {}}, warning));
}

}  // namespace

MeshFormat mesh_format(std::string_view text, const std::string& file) {
  const auto extension = std::filesystem::path(file).extension().string();
  for (const auto& [name, format] : format_names)
    if (detail::same_word(extension, name)) return format;
  if (const auto format = format_by_beginning(text)) return *format;
  throw Error(ErrorKind::input,
              "the format is not known from the name (extension '" + extension +
                  "') nor from the contents. " + known_names,
              {file, 0, {}});
}

Mesh parse_solid_mesh(std::string_view text, const std::string& file, MeshFormat format, Warnings* warnings) {
  auto raw = parse(text, file, format);
  Mesh mesh = detail::solid_mesh(raw, file);
  hand_over(raw.warnings, file, warnings);
  return mesh;
}

SurfaceMesh parse_surface_mesh(std::string_view text, const std::string& file, MeshFormat format,
                               Warnings* warnings) {
  auto raw = parse(text, file, format);
  SurfaceMesh surface = detail::surface_mesh(raw, file);
  hand_over(raw.warnings, file, warnings);
  return surface;
}

Mesh read_solid_mesh(const std::string& path, Warnings* warnings) {
  const auto text = contents_of(path);
  return parse_solid_mesh(text, path, mesh_format(text, path), warnings);
}

SurfaceMesh read_surface_mesh(const std::string& path, Warnings* warnings) {
  const auto text = contents_of(path);
  return parse_surface_mesh(text, path, mesh_format(text, path), warnings);
}

LabelledSurface read_labelled_surface(const std::string& path, Warnings* warnings) {
  const auto text = contents_of(path);
  auto raw = parse(text, path, mesh_format(text, path));
  LabelledSurface surface = detail::labelled_surface(raw, path);
  hand_over(raw.warnings, path, warnings);
  return surface;
}

std::vector<int> drop_unused_nodes(Mesh& mesh) {
  std::vector<int> renumber(mesh.X.size(), -1);
  for (const int n : mesh.nodes) renumber[static_cast<std::size_t>(n)] = 0;
  for (const auto& triangle : mesh.triangles)
    for (const int n : triangle) renumber[static_cast<std::size_t>(n)] = 0;
  int next = 0;
  for (int& n : renumber)
    if (n == 0) n = next++;
  detail::keep_nodes(mesh, renumber);
  return renumber;
}

}  // namespace glisson
