// Nodes, Elements and mesh files of one level.
#include <glisson/models/format/reader.hpp>
#include <glisson/models/format/suggest.hpp>
#include <glisson/models/mesh/transform.hpp>

#include <cmath>

namespace glisson::detail {
namespace {

constexpr const char* mesh_file_names[] = {"VTKMesh", "MSHMesh", "VTUMesh", "Mesh"};

const std::vector<std::string>& type_names() {
  static const std::vector<std::string> names{"T4", "T4ANP", "H8", "H8FixedHourglass", "H8Full", "AUTO"};
  return names;
}

Shape shape_with(const XmlElement& element, int node_count) {
  if (node_count == 4) return Shape::tetrahedron;
  if (node_count == 8) return Shape::hexahedron;
  element.fail("a mixed list gives the number of nodes (4 or 8) before each element, but holds " +
               std::to_string(node_count) + " there");
}

/// The list of one type holds nodes only; a mixed one has 4 or 8 in front of each element's nodes.
void read_elements(const XmlElement& level, Mesh& mesh) {
  const auto& element = level.required_child("Elements");
  element.required_attribute("NumEls");
  const auto choice = formulation_choice(element, element.required_attribute("Type"));
  const bool mixed = choice.tetrahedron && choice.hexahedron;
  const auto entries = element.integers();
  std::size_t i = 0;
  while (i < entries.size()) {
    const Shape shape = mixed                ? shape_with(element, entries[i++])
                        : choice.tetrahedron ? Shape::tetrahedron
                                             : Shape::hexahedron;
    const auto count = static_cast<std::size_t>(node_count_of(shape));
    if (entries.size() - i < count)
      element.fail("the list ends within element " + std::to_string(mesh.element_count()) + ", which needs " +
                   std::to_string(count) + " nodes");
    mesh.add_element(shape, {entries.data() + i, count});
    i += count;
  }
  const int count = *element.integer_attribute("NumEls");
  if (count != mesh.element_count())
    element.fail("it lists " + std::to_string(mesh.element_count()) + " elements, but NumEls=\"" +
                 std::to_string(count) + "\"");
  for (int e = 0; e < mesh.element_count(); ++e)
    for (const int n : mesh.element(e))
      if (n < 0 || n >= mesh.node_count())
        element.fail("element " + std::to_string(e) + " uses node " + std::to_string(n) +
                     ", but there are only nodes 0 to " + std::to_string(mesh.node_count() - 1) +
                     " (numbers start at 0)");
}

/// Keeps elements of the wanted shapes, with their labels and arrays; nodes keep their numbers.
void keep_shapes(const FormulationChoice& choice, Mesh& mesh) {
  Mesh kept;
  std::vector<std::size_t> chosen;
  for (int e = 0; e < mesh.element_count(); ++e)
    if (choice.of(mesh.shape[static_cast<std::size_t>(e)])) chosen.push_back(static_cast<std::size_t>(e));
  if (chosen.size() == mesh.shape.size()) return;
  for (const auto e : chosen) {
    kept.add_element(mesh.shape[e], mesh.element(static_cast<int>(e)));
    if (!mesh.label.empty()) kept.label.push_back(mesh.label[e]);
  }
  for (auto& [name, array] : mesh.cell_arrays) {
    const auto components = static_cast<std::size_t>(array.components);
    auto& values = kept.cell_arrays[name];
    values.components = array.components;
    for (const auto e : chosen)
      for (std::size_t c = 0; c < components; ++c) values.values.push_back(array.values[e * components + c]);
  }
  kept.X = std::move(mesh.X);
  kept.point_arrays = std::move(mesh.point_arrays);
  mesh = std::move(kept);
}

Transform transform_in(const XmlElement& element) {
  Transform transform;
  if (const auto rotation = element.child("Rotation")) {
    const auto v = rotation->numbers(6);
    transform.centre = {v[0], v[1], v[2]};
    transform.angles = {v[3], v[4], v[5]};
  }
  if (const auto scale = element.child("ScaleFactor")) {
    transform.scale = scale->number();
    if (!(transform.scale > 0))
      scale->fail("a scale factor of " + scale->text() +
                  " would turn the mesh inside out or flat; use a positive one");
  }
  if (const auto translation = element.child("Translation")) transform.translation = vector_of(*translation);
  return transform;
}

void read_mesh_file(const Reader& reader, const XmlElement& element, Part& part, FormulationChoice& choice) {
  const auto type = element.attribute("Type");
  choice = formulation_choice(element, type != nullptr ? type->value : "AUTO");
  Mesh& mesh = part.model.mesh;
  mesh = mesh_from_file(reader, element);
  keep_shapes(choice, mesh);
  if (mesh.element_count() == 0)
    element.fail("the file has no element of Type=\"" + (type != nullptr ? type->value : "AUTO") +
                 "\"; choose a Type that it holds");
  transform_as_told(element, mesh.X);
}

/// A level of shells only whose nodes come with their file.
bool shells_bring_nodes(const XmlElement& level) {
  for (const auto shells : level.all("ShellElements"))
    if (const auto type = shells->attribute("Type"); type != nullptr && type->value == "FILE") return true;
  return false;
}

/// A tetrahedron in the other orientation is the same body; NiftySim takes both.
void turn_tetrahedra(const Reader& reader, const XmlElement& level, Mesh& mesh) {
  int turned = 0;
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (mesh.shape[static_cast<std::size_t>(e)] != Shape::tetrahedron) continue;
    const auto nodes = mesh.element(e);
    const auto at = [&](std::size_t a) { return mesh.X[static_cast<std::size_t>(nodes[a])]; };
    if (dot(cross(at(1) - at(0), at(2) - at(0)), at(3) - at(0)) >= 0) continue;
    const auto first = static_cast<std::size_t>(mesh.begin[static_cast<std::size_t>(e)]);
    std::swap(mesh.nodes[first], mesh.nodes[first + 1]);
    ++turned;
  }
  if (turned > 0)
    reader.warn(
        level, std::to_string(turned) + " tetrahedra were listed in the inverted order and have been turned");
}

}  // namespace

std::vector<Vec3<double>> read_positions(const XmlElement& element) {
  element.required_attribute("NumNodes");
  const int count = *element.integer_attribute("NumNodes");
  const auto values = element.numbers();
  if (count <= 0 || values.size() != 3 * static_cast<std::size_t>(count))
    element.fail("it holds " + std::to_string(values.size()) + " coordinates, but NumNodes=\"" +
                 std::to_string(count) + "\" needs " + std::to_string(3 * static_cast<std::int64_t>(count)));
  std::vector<Vec3<double>> X;
  for (std::size_t i = 0; i < values.size(); i += 3) X.push_back({values[i], values[i + 1], values[i + 2]});
  return X;
}

void transform_as_told(const XmlElement& element, std::span<Vec3<double>> X) {
  transform_nodes(transform_in(element), X);
}

double not_negative(const XmlElement& element) {
  const double value = element.number();
  if (value < 0) element.fail("it is " + element.text() + ", but must not be negative");
  return value;
}

Vec3<double> vector_of(const XmlElement& element) {
  const auto v = element.numbers(3);
  return {v[0], v[1], v[2]};
}

Vec3<double> direction_of(const XmlElement& element) {
  const auto v = vector_of(element);
  const double length = std::sqrt(dot(v, v));
  if (!(length > 1e-12) || !std::isfinite(length))
    element.fail("the vector has no direction; give three numbers that are not all 0");
  return (1 / length) * v;
}

std::optional<Formulation> formulation_named(std::string_view name) {
  for (const auto f :
       {Formulation::t4, Formulation::t4anp, Formulation::h8, Formulation::h8_fixed, Formulation::h8_full})
    if (name == name_of(f)) return f;
  return {};
}

FormulationChoice formulation_choice(const XmlElement& element, const std::string& type) {
  FormulationChoice choice;
  std::string_view rest = type;
  while (true) {
    const auto plus = std::min(rest.find('+'), rest.size());
    const auto name = rest.substr(0, plus);
    if (name == "AUTO" && type == "AUTO") return {Formulation::t4, Formulation::h8};
    const auto formulation = formulation_named(name);
    if (!formulation)
      element.fail("Type=\"" + type + "\" is not an element type or types joined by +" +
                   suggestion(name, type_names()));
    auto& slot = shape_of(*formulation) == Shape::tetrahedron ? choice.tetrahedron : choice.hexahedron;
    if (slot)
      element.fail("Type=\"" + type +
                   "\" names two formulations of the same shape; ElementSet/Formulation can differ by set");
    slot = formulation;
    if (plus == rest.size()) return choice;
    rest.remove_prefix(plus + 1);
  }
}

const XmlElement* mesh_file_of(const XmlElement& level) {
  for (const auto name : mesh_file_names)
    if (const auto found = level.child(name)) return found;
  return nullptr;
}

void read_geometry(const Reader& reader, const XmlElement& level, Part& part) {
  FormulationChoice choice;
  const XmlElement* from_file = mesh_file_of(level);
  for (const auto name : mesh_file_names)
    if (const auto other = level.child(name); other != nullptr && other != from_file)
      reader.complain(*other, other->line,
                      "a second geometry: <" + from_file->name + "> is there too; keep one of them");
  if (from_file != nullptr) {
    for (const auto name : {"Nodes", "Elements"})
      if (const auto other = level.child(name))
        reader.complain(*other, other->line,
                        "a second geometry: <" + from_file->name + "> is there too; keep one of them");
    read_mesh_file(reader, *from_file, part, choice);
  } else if (level.child("Nodes") != nullptr || level.child("Elements") != nullptr ||
             !shells_bring_nodes(level)) {
    part.model.mesh.X = read_positions(level.required_child("Nodes"));
    if (level.child("Elements") == nullptr && level.child("ShellElements") != nullptr) return;
    read_elements(level, part.model.mesh);
    const auto& elements = level.required_child("Elements");
    choice = formulation_choice(elements, elements.required_attribute("Type"));
  }
  turn_tetrahedra(reader, level, part.model.mesh);
  for (const auto shape : part.model.mesh.shape) part.formulation.push_back(*choice.of(shape));
}

}  // namespace glisson::detail
