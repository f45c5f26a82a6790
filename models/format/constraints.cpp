// Constraint: boundary conditions and loads of one level.
#include <glisson/core/mesh/triangles.hpp>
#include <glisson/models/format/constraint_reader.hpp>
#include <glisson/models/format/suggest.hpp>

#include <array>

namespace glisson::detail {
namespace {

void add_fix(const Reader&, const XmlElement&, ConstraintReader& in, Model& model) {
  auto nodes = in.nodes();
  if (!in.acts_on_nothing()) model.fixed.push_back({std::move(nodes), in.axes()});
}

void add_displacement(const Reader&, const XmlElement& element, ConstraintReader& in, Model& model) {
  auto nodes = in.nodes();
  const auto curve = in.curve();
  auto values = in.values(element.required_child("Magnitudes"), 1);
  if (!in.acts_on_nothing())
    model.displacements.push_back({std::move(nodes), in.axes(), std::move(values), curve});
}

void add_force(const Reader&, const XmlElement& element, ConstraintReader& in, Model& model) {
  auto nodes = in.nodes();
  const auto curve = in.curve();
  auto values = in.values(element.required_child("Magnitudes"), 1);
  if (!in.acts_on_nothing()) model.forces.push_back({std::move(nodes), in.axes(), std::move(values), curve});
}

void add_gravity(const Reader&, const XmlElement& element, ConstraintReader& in, Model& model) {
  auto nodes = in.nodes();
  const auto curve = in.curve();
  const double g = element.required_child("AccelerationMagnitude").number();
  const auto direction = direction_of(element.required_child("AccelerationDirection"));
  if (in.acts_on_nothing()) return;
  if (nodes.size() == model.mesh.X.size()) nodes.clear();  // the model's way to say all
  model.gravity.push_back({std::move(nodes), g * direction, curve});
}

void add_pressure(const Reader& reader, const XmlElement& element, ConstraintReader& in, Model& model) {
  auto facets = in.facets();
  const auto curve = in.curve();
  const double magnitude = element.required_child("Magnitude").number();
  if (in.acts_on_nothing()) return;
  if (magnitude == 0) reader.warn(element, "the pressure is 0");
  model.pressures.push_back({std::move(facets), magnitude, curve});
}

void add_traction(const Reader&, const XmlElement& element, ConstraintReader& in, Model& model) {
  auto facets = in.facets();
  const auto curve = in.curve();
  auto values = in.vectors(element.required_child("Magnitudes"));
  if (!in.acts_on_nothing()) model.tractions.push_back({std::move(facets), std::move(values), curve});
}

void add_spring(const Reader& reader, const XmlElement& element, ConstraintReader& in, Model& model) {
  Springs springs;
  springs.nodes = in.nodes();
  springs.curve = in.curve();
  springs.target_curve = read_curve(reader, element, "TargetLoadShape", "TargetTable", LoadShape::step);
  springs.targets = in.vectors(element.required_child("Targets"));
  const auto& stiffness = element.required_child("Stiffness");
  springs.stiffness = in.values(stiffness, 1);
  for (const double k : springs.stiffness)
    if (k < 0) stiffness.fail("a stiffness is negative; the spring would push away from its target");
  if (const auto cap = element.child("StrainEnergyCap")) {
    springs.strain_energy_cap = cap->number();
    if (!(*springs.strain_energy_cap > 0)) cap->fail("it is " + cap->text() + ", but must be greater than 0");
  }
  if (!in.acts_on_nothing()) model.springs.push_back(std::move(springs));
}

void add_plane(const Reader&, const XmlElement& element, ConstraintReader& in, Model& model) {
  auto nodes = in.nodes();
  const auto normal = direction_of(element.required_child("PlaneNormal"));
  if (!in.acts_on_nothing()) model.planes.push_back({std::move(nodes), normal});
}

void add_velocity(const Reader&, const XmlElement& element, ConstraintReader& in, Model& model) {
  auto nodes = in.nodes();
  const auto velocity = vector_of(element.required_child("Velocity"));
  if (!in.acts_on_nothing()) model.initial_velocities.push_back({std::move(nodes), velocity});
}

using Adder = void (*)(const Reader&, const XmlElement&, ConstraintReader&, Model&);
struct ConstraintType {
  const char* name;
  Adder add;
  const char* uses;  ///< the attributes and elements that mean something for it, besides the selection
};

constexpr std::array types{
    ConstraintType{"Fix", add_fix, " DOF "},
    ConstraintType{"Disp", add_displacement, " DOF Magnitudes Table "},
    ConstraintType{"Force", add_force, " DOF Magnitudes Table "},
    ConstraintType{"Gravity", add_gravity, " AccelerationMagnitude AccelerationDirection Table "},
    ConstraintType{"Pressure", add_pressure, " Magnitude Faces Table "},
    ConstraintType{"Traction", add_traction, " Magnitudes Faces Table "},
    ConstraintType{"Spring", add_spring,
                   " Stiffness Targets StrainEnergyCap Table TargetTable TargetLoadShape "},
    ConstraintType{"SlidingPlane", add_plane, " PlaneNormal "},
    ConstraintType{"Symmetry", add_plane, " PlaneNormal "},
    ConstraintType{"InitialVelocity", add_velocity, " Velocity "},
};

/// What another type would use is accepted by the grammar; here it has no effect and is probably a mistake.
void warn_unused(const Reader& reader, const XmlElement& element, const ConstraintType& type) {
  for (const char* name :
       {"Magnitudes", "Magnitude", "AccelerationMagnitude", "AccelerationDirection", "Table", "Faces",
        "TargetTable", "Stiffness", "Targets", "StrainEnergyCap", "PlaneNormal", "Velocity"}) {
    const auto child = element.child(name);
    if (child != nullptr && std::string(type.uses).find(" " + std::string(name) + " ") == std::string::npos)
      reader.warn(*child, "it has no effect in a Constraint of Type=\"" + std::string(type.name) + "\"");
  }
}

/// In a model of shells only they are the surface.
bool acts_on_shells(const XmlElement& element, const Mesh& mesh) {
  const auto type = element.attribute("FaceType");
  const bool asked = type != nullptr && type->value == "Shell";
  if (asked && mesh.triangles.empty())
    element.fail(type->line,
                 "FaceType=\"Shell\" needs shell triangles, but there are none; add <ShellElements>");
  return asked || mesh.element_count() == 0;
}

}  // namespace

void read_constraints(const Reader& reader, const XmlElement& level, Part& part) {
  const Mesh& mesh = part.model.mesh;
  const SelectionMesh solids(mesh), shells(mesh, facets_of(mesh.triangles), part.triangle_label);
  for (const auto element : level.all("Constraint")) {
    const auto& name = element->required_attribute("Type");
    for (const auto& type : types) {
      if (name != type.name) continue;
      ConstraintReader in(reader, *element, acts_on_shells(*element, mesh) ? shells : solids);
      type.add(reader, *element, in, part.model);
      warn_unused(reader, *element, type);
    }
  }
}

}  // namespace glisson::detail
