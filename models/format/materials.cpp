// Material of an ElementSet: law, parameters, Prony terms, density, per-element values from cell arrays.
#include <glisson/core/materials/law_table.hpp>
#include <glisson/models/format/reader.hpp>
#include <glisson/models/format/suggest.hpp>

#include <algorithm>
#include <cmath>

namespace glisson::detail {
namespace {

std::vector<std::string> parameter_names(const LawRule& law) {
  std::vector<std::string> names;
  for (const auto& parameter : law.parameters) names.emplace_back(parameter.name);
  return names;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : " ") + name;
  return text;
}

/// Ogden may have one, two or three terms before kappa; absent ones get mu = 0 and a harmless exponent.
void complete_ogden(std::vector<double>& values) {
  if (values.size() != 3 && values.size() != 5) return;
  const double kappa = values.back();
  values.pop_back();
  while (values.size() < 6) values.insert(values.end(), {0.0, 2.0});
  values.push_back(kappa);
}

void read_elastic(const XmlElement& material, const LawRule& law, MaterialSpec& spec) {
  const auto& element = material.required_child("ElasticParams");
  element.required_attribute("NumParams");
  const int announced = *element.integer_attribute("NumParams");
  spec.parameters = element.numbers();
  if (announced < 0 || spec.parameters.size() != static_cast<std::size_t>(announced))
    element.fail("it holds " + std::to_string(spec.parameters.size()) + " parameters, but NumParams=\"" +
                 std::to_string(announced) + "\"");
  if (law.name == "OG") complete_ogden(spec.parameters);
  if (spec.parameters.size() != law.parameters.size())
    element.fail("the law " + std::string(law.name) + " needs " + std::to_string(law.parameters.size()) +
                 " parameters (" + joined(parameter_names(law)) + "), not " + std::to_string(announced));
  if (law.direction < 0) return;
  const auto d = static_cast<std::size_t>(law.direction);
  double* a = spec.parameters.data() + d;
  const double length = std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
  if (!(length > 0)) element.fail("the fibre direction is the zero vector; give its three components");
  for (int i = 0; i < 3; ++i) a[i] /= length;
}

void read_viscous(const XmlElement& material, const std::string& type, MaterialSpec& spec) {
  const auto element = material.child("ViscoParams");
  if (element == nullptr) {
    if (type == "NHV" || type == "TIV")
      material.fail("the law " + type + " needs <ViscoParams>; add it or use " + type.substr(0, 2));
    return;
  }
  element->required_attribute("NumIsoTerms");
  element->required_attribute("NumVolTerms");
  const int isochoric = *element->integer_attribute("NumIsoTerms"),
            volumetric = *element->integer_attribute("NumVolTerms");
  const auto values = element->numbers();
  if (isochoric < 0 || volumetric < 0 ||
      values.size() != 2 * (static_cast<std::size_t>(isochoric) + static_cast<std::size_t>(volumetric)))
    element->fail("it holds " + std::to_string(values.size()) + " numbers; " + std::to_string(isochoric) +
                  " isochoric and " + std::to_string(volumetric) +
                  " volumetric terms need 2 each (alpha tau)");
  for (std::size_t i = 0; i < values.size(); i += 2)
    (i < 2 * static_cast<std::size_t>(isochoric) ? spec.isochoric : spec.volumetric)
        .push_back({values[i], values[i + 1]});
}

}  // namespace

const NamedArray& named_array(const XmlElement& element, const std::map<std::string, NamedArray>& arrays,
                              int components) {
  const auto name = element.required_text();
  const auto found = arrays.find(name);
  if (found == arrays.end()) {
    std::vector<std::string> names;
    for (const auto& [known, array] : arrays) names.push_back(known);
    element.fail("the mesh has no cell array '" + name + "'" + suggestion(name, names));
  }
  if (found->second.components != components)
    element.fail("the cell array '" + name + "' has " + std::to_string(found->second.components) +
                 " components where " + std::to_string(components) + " are needed");
  return found->second;
}

std::vector<double> picked(const NamedArray& array, const std::vector<int>& rows, int component) {
  std::vector<double> values;
  values.reserve(rows.size());
  for (const int e : rows)
    values.push_back(
        array.values.at(static_cast<std::size_t>(e) * static_cast<std::size_t>(array.components) +
                        static_cast<std::size_t>(component)));
  return values;
}

namespace {

void read_arrays(const XmlElement& material, const LawRule& law, const Mesh& mesh,
                 const std::vector<int>& elements, MaterialSpec& spec) {
  const auto names = parameter_names(law);
  for (const auto element : material.all("ElementArray")) {
    const auto& wanted = element->required_attribute("Param");
    const auto found = std::find(names.begin(), names.end(), wanted);
    if (found == names.end())
      element->fail("the law " + std::string(law.name) + " has no parameter '" + wanted + "'" +
                    suggestion(wanted, names));
    spec.element_parameters.emplace_back(static_cast<int>(found - names.begin()),
                                         picked(named_array(*element, mesh.cell_arrays, 1), elements, 0));
  }
  if (const auto element = material.child("FibreArray")) {
    if (law.direction < 0)
      element->fail("the law " + std::string(law.name) + " has no fibre direction; TI has one");
    const auto& array = named_array(*element, mesh.cell_arrays, 3);
    std::array<std::vector<double>, 3> a;
    for (int i = 0; i < 3; ++i) a[static_cast<std::size_t>(i)] = picked(array, elements, i);
    for (std::size_t k = 0; k < elements.size(); ++k) {
      const double length = std::sqrt(a[0][k] * a[0][k] + a[1][k] * a[1][k] + a[2][k] * a[2][k]);
      if (!(length > 0))
        element->fail("the fibre direction of element " + std::to_string(elements[k]) +
                      " is the zero vector");
      for (auto& component : a) component[k] /= length;
    }
    for (int i = 0; i < 3; ++i)
      spec.element_parameters.emplace_back(law.direction + i, std::move(a[static_cast<std::size_t>(i)]));
  }
}

}  // namespace

MaterialSpec read_material(const Reader& reader, const XmlElement& material, const Mesh& mesh,
                           const std::vector<int>& elements) {
  const auto& type = material.required_attribute("Type");
  MaterialSpec spec;
  spec.law = type == "NHV" || type == "TIV" ? type.substr(0, 2) : type;
  const LawRule* law = find_law(spec.law);
  if (law == nullptr) material.fail("there is no law '" + type + "'");  // the grammar lists the same names
  read_elastic(material, *law, spec);
  read_viscous(material, type, spec);
  read_arrays(material, *law, mesh, elements, spec);
  if (const auto density = material.child("Density"))
    spec.density = density->number();
  else if (reader.density)
    spec.density = *reader.density;
  else
    material.fail("it has no density; add <Density> to it or to <SystemParams>");
  return spec;
}

}  // namespace glisson::detail
