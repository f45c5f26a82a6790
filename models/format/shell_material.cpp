// Material of a ShellElementSet: law, bending, thickness, density, Prony terms, fibres, per-triangle values.
#include <glisson/core/materials/shell_law_table.hpp>
#include <glisson/core/validation/checks.hpp>
#include <glisson/models/format/reader.hpp>
#include <glisson/models/format/suggest.hpp>

#include <array>
#include <cmath>

namespace glisson::detail {
namespace {

/// What a Type of the file stands for; E and nu of bending follow the law's own parameters in shells.
struct ShellType {
  const char *name, *law;
  bool bends = false;
};

constexpr std::array shell_types{
    ShellType{"Linear", "Linear"},
    ShellType{"NeoHookean", "NeoHookean"},
    ShellType{"NeoHookeanCompressible", "NeoHookeanCompressible"},
    ShellType{"Fung", "Fung"},
    ShellType{"TwoFibre", "TwoFibre"},
    ShellType{"LinearShell", "Linear", true},
    ShellType{"LinearThickShell", "Linear", true},
    ShellType{"NeoHookeanShell", "NeoHookean", true},
    ShellType{"NeoHookeanCompressibleShell", "NeoHookeanCompressible", true},
};

const ShellType& shell_type(const XmlElement& material) {
  const auto& name = material.required_attribute("Type");
  for (const ShellType& type : shell_types)
    if (name == type.name) return type;
  material.fail("Type=\"" + name +
                "\" is not one of a membrane or shell");  // the grammar lists the same names
}

void read_parameters(const Reader& reader, const XmlElement& material, ShellSection& section) {
  const ShellType& type = shell_type(material);
  if (std::string(type.name) == "LinearThickShell")
    reader.warn(material, "it is the same as LinearShell: there is no transverse shear in it");
  section.formulation = type.bends ? ShellFormulation::rotation_free : ShellFormulation::membrane;
  section.law = type.law;
  std::string names;
  const auto& rules = find_shell_law(type.law)->law.parameters;
  for (const auto& rule : rules) names += (names.empty() ? "" : " ") + std::string(rule.name);
  if (type.bends) names += ", then E nu of bending";
  const auto values = material.numbers();
  const std::size_t needed = rules.size() + (type.bends ? 2 : 0);
  if (values.size() != needed)
    material.fail(std::string(type.name) + " needs " + std::to_string(needed) + " parameters (" + names +
                  ") as its text, not " + std::to_string(values.size()));
  section.parameters.assign(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rules.size()));
  if (type.bends) section.bending_E = values[needed - 2], section.bending_nu = values[needed - 1];
  const auto wrinkling = material.attribute("Wrinkling");
  section.wrinkling = wrinkling != nullptr && wrinkling->value == "1";
}

void read_prony(const XmlElement& material, ShellSection& section) {
  const auto element = material.child("ViscoParams");
  if (element == nullptr) return;
  element->required_attribute("NumTerms");
  const int count = *element->integer_attribute("NumTerms");
  const auto values = element->numbers();
  if (count < 0 || values.size() != 2 * static_cast<std::size_t>(count))
    element->fail("it holds " + std::to_string(values.size()) + " numbers; NumTerms=\"" +
                  std::to_string(count) + "\" needs 2 for each term (alpha tau)");
  for (std::size_t i = 0; i < values.size(); i += 2) section.prony.push_back({values[i], values[i + 1]});
}

/// Thickness and Density: one value or one of each triangle.
void read_sizes(const Reader& reader, const XmlElement& material, const Part& part, ShellSection& section) {
  for (const auto element : material.all("ElementArray")) {
    const auto& name = element->required_attribute("Param");
    if (name != "Thickness" && name != "Density")
      element->fail("Param=\"" + name + "\" cannot differ by triangle" +
                    suggestion(name, {"Thickness", "Density"}));
    auto& values = name == "Density" ? section.element_density : section.element_thickness;
    values = picked(named_array(*element, part.triangle_arrays, 1), section.elements, 0);
    for (std::size_t k = 0; k < values.size(); ++k)
      if (!(values[k] > 0))
        element->fail("the " + name + " of shell triangle " + std::to_string(section.elements[k]) + " is " +
                      number_text(values[k]) + ", but must be greater than 0");
  }
  if (const auto element = material.child("Thickness"))
    section.thickness = positive_number(*element);
  else if (section.element_thickness.empty())
    material.required_child("Thickness");
  if (const auto element = material.child("Density"))
    section.density = positive_number(*element);
  else if (reader.density)
    section.density = *reader.density;
  else if (section.element_density.empty())
    material.fail("it has no density; add <Density> to it or to <SystemParams>");
}

void read_directions(const XmlElement& material, const Part& part, ShellSection& section) {
  if (const auto element = material.child("FibreDirection")) section.direction = direction_of(*element);
  if (const auto element = material.child("FibreArray")) {
    const auto& array = named_array(*element, part.triangle_arrays, 3);
    std::array<std::vector<double>, 3> a;
    for (int i = 0; i < 3; ++i) a[static_cast<std::size_t>(i)] = picked(array, section.elements, i);
    for (std::size_t k = 0; k < section.elements.size(); ++k) {
      section.element_direction.push_back({a[0][k], a[1][k], a[2][k]});
      const auto& d = section.element_direction.back();
      if (!(dot(d, d) > 0))
        element->fail("the fibre direction of shell triangle " + std::to_string(section.elements[k]) +
                      " is the zero vector");
    }
  }
  if (section.law == "TwoFibre" && !material.child("FibreDirection") && !material.child("FibreArray"))
    material.fail(
        "the law TwoFibre needs the direction its angle is measured from; add <FibreDirection> or "
        "<FibreArray>");
}

}  // namespace

void read_shell_material(const Reader& reader, const XmlElement& material, const Part& part,
                         ShellSection& section) {
  read_parameters(reader, material, section);
  read_prony(material, section);
  read_sizes(reader, material, part, section);
  read_directions(material, part, section);
  try {
    check_shell_section(section, "");
  } catch (const Error& error) {
    material.fail(error.what());
  }
}

}  // namespace glisson::detail
