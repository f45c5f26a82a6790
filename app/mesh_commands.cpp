// glisson mesh, convert and info: meshes and images without a simulation.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <map>

#include <glisson/app/commands.hpp>
#include <glisson/app/mesh_quality.hpp>
#include <glisson/app/read_input.hpp>
#include <glisson/core/base/error.hpp>
#include <glisson/models/image/label_image.hpp>
#include <glisson/models/mesh/read_mesh.hpp>
#include <glisson/models/mesh/transform.hpp>
#include <glisson/models/mesh/write_mesh.hpp>
#include <glisson/models/mesher/mesh_labels.hpp>

namespace glisson::app {
namespace {

bool ends_with_any(const std::string& file, std::initializer_list<const char*> endings) {
  return std::any_of(endings.begin(), endings.end(),
                     [&](const char* ending) { return file.ends_with(ending); });
}

/// "6mm", "0.6 cm", "0.006m" in mm.
double length_in_mm(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  std::string unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
  unit.erase(0, std::min(unit.find_first_not_of(' '), unit.size()));
  const std::map<std::string, double> units{{"mm", 1}, {"cm", 10}, {"m", 1000}};
  const auto found = units.find(unit);
  if (error != std::errc{} || !(value > 0) || found == units.end())
    throw Error(ErrorKind::usage,
                "--voxel '" + text + "' is not a length. Write a positive number and its unit, as in 6mm.");
  return value * found->second;
}

/// labels.nii.gz -> labels.vtu, in the working directory.
std::string mesh_beside(const std::string& image) {
  std::filesystem::path name = std::filesystem::path(image).filename();
  if (name.extension() == ".gz") name.replace_extension();
  return name.replace_extension(".vtu").string();
}

void print_mesh(const Mesh& mesh) {
  std::array<int, 2> shapes{};
  for (const Shape shape : mesh.shape) ++shapes[static_cast<std::size_t>(shape)];
  fmt::print("{} nodes, {} tetrahedra, {} hexahedra\n", mesh.node_count(), shapes[0], shapes[1]);
  if (mesh.X.empty() || mesh.shape.empty()) return;
  Vec3<double> low = mesh.X[0], high = mesh.X[0];
  for (const auto& X : mesh.X) {
    low = {std::min(low.x, X.x), std::min(low.y, X.y), std::min(low.z, X.z)};
    high = {std::max(high.x, X.x), std::max(high.y, X.y), std::max(high.z, X.z)};
  }
  fmt::print("x {:.6g} to {:.6g}, y {:.6g} to {:.6g}, z {:.6g} to {:.6g}\n", low.x, high.x, low.y, high.y,
             low.z, high.z);
  double worst = 2;
  int element = 0;
  for (int e = 0; e < mesh.element_count(); ++e)
    if (const double q = element_quality(mesh, e); q < worst) worst = q, element = e;
  fmt::print("worst element quality {:.3f} (element {})\n", worst, element);
  std::map<int, int> labels;
  for (const int label : mesh.label) ++labels[label];
  for (const auto& [label, count] : labels) fmt::print("label {}: {} elements\n", label, count);
  for (const auto& [name, array] : mesh.cell_arrays)
    fmt::print("cell array {} ({})\n", name, array.components);
  for (const auto& [name, array] : mesh.point_arrays)
    fmt::print("point array {} ({})\n", name, array.components);
}

void print_warnings(const std::vector<std::string>& warnings) {
  for (const auto& warning : warnings) fmt::print(stderr, "warning: {}\n", warning);
}

int print_model(const std::string& file) {
  const CheckedModel input = read_and_validate(file, true);
  const Model& m = input.model;
  print_mesh(m.mesh);
  for (const auto& s : m.sections) {
    fmt::print("{}: {} elements {}, {} [", s.name, s.elements.size(), name_of(s.formulation), s.material.law);
    for (std::size_t i = 0; i < s.material.parameters.size(); ++i)
      fmt::print("{}{:g}", i ? " " : "", s.material.parameters[i]);
    fmt::print("], density {:g}, {} Prony terms\n", s.material.density,
               s.material.isochoric.size() + s.material.volumetric.size());
  }
  fmt::print(
      "{} fixed, {} prescribed displacements, {} forces, {} gravity, {} pressures, {} tractions, {} springs, "
      "{} planes, {} rigid bodies\n",
      m.fixed.size(), m.displacements.size(), m.forces.size(), m.gravity.size(), m.pressures.size(),
      m.tractions.size(), m.springs.size(), m.planes.size(), m.bodies.size());
  fmt::print("total time {:g} s{}, units {}\n", m.time.total, m.time.quasi_static ? ", quasi-static" : "",
             m.units.empty() ? "not declared" : m.units);
  print_warnings(input.warnings);
  return exit_done;
}

int print_image(const std::string& file) {
  const LabelImage image = read_label_image(file);
  fmt::print("{} x {} x {} voxels\n", image.size[0], image.size[1], image.size[2]);
  fmt::print("labels: {}\n", label_summary(image));
  return exit_done;
}

}  // namespace

int mesh(const MeshArguments& arguments) {
  const std::string output = arguments.output.empty() ? mesh_beside(arguments.image) : arguments.output;
  if (!ends_with_any(output, {".vtu", ".vtk", ".msh"}))
    throw Error(ErrorKind::usage, "-o '" + output + "': a mesh is written as .vtu, .vtk or .msh.");
  MesherOptions options;
  options.voxel_mm = length_in_mm(arguments.voxel);
  options.element = arguments.element == "H8" ? Shape::hexahedron : Shape::tetrahedron;
  options.labels = arguments.labels;
  options.one_region = arguments.one_region;
  options.largest_only = arguments.largest_only;
  options.scale = arguments.scale;
  const LabelMesh made =
      in_file(arguments.image, [&] { return mesh_labels(read_label_image(arguments.image), options); });
  print_warnings(made.warnings);
  for (const auto& r : made.regions)
    fmt::print("label {}: {} elements, {:.1f} mL ({:.1f} mL in the image)\n", r.label, r.element_count,
               r.mesh_mm3 / 1000, r.image_mm3 / 1000);
  write_mesh(output, made.mesh);
  print_mesh(made.mesh);
  fmt::print("written: {}\n", output);
  return exit_done;
}

int convert(const ConvertArguments& arguments) {
  Warnings warnings;
  const Transform transform{.centre = {}, .angles = {}, .scale = arguments.scale, .translation = {}};
  if (arguments.surface) {
    SurfaceMesh surface = read_surface_mesh(arguments.input, &warnings);
    transform_nodes(transform, surface.X);
    write_surface(arguments.output, surface);
    fmt::print("{} facets written: {}\n", surface.facets.size(), arguments.output);
  } else {
    Mesh solid = read_solid_mesh(arguments.input, &warnings);
    transform_nodes(transform, solid.X);
    write_mesh(arguments.output, solid, arguments.text ? Encoding::text : Encoding::binary);
    fmt::print("{} elements written: {}\n", solid.element_count(), arguments.output);
  }
  print_warnings(warnings);
  return exit_done;
}

int info(const std::string& file) {
  if (ends_with_any(file, {".nii", ".nii.gz", ".inr", ".inr.gz"})) return print_image(file);
  if (ends_with_any(file, {".msh", ".vtk", ".vtu"})) {
    Warnings warnings;
    print_mesh(read_solid_mesh(file, &warnings));
    print_warnings(warnings);
    return exit_done;
  }
  if (ends_with_any(file, {".stl", ".ply", ".off", ".obj"})) {
    const SurfaceMesh surface = read_surface_mesh(file);
    fmt::print("surface of {} vertices and {} facets\n", surface.X.size(), surface.facets.size());
    return exit_done;
  }
  return print_model(file);
}

}  // namespace glisson::app
