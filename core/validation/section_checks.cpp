// Sections: every element in exactly one, its formulation fits its shape, the material is physical.
#include <glisson/core/materials/law_table.hpp>
#include <glisson/core/validation/checks.hpp>

#include <cmath>

namespace glisson::detail {
namespace {

std::string section_name(const Model& model, std::size_t s) {
  return model.sections[s].name.empty() ? "section " + std::to_string(s) : model.sections[s].name;
}

std::string bounds_text(const ParameterRule& rule) {
  const bool lower = std::isfinite(rule.above), upper = std::isfinite(rule.below);
  if (lower && upper) return "between " + number_text(rule.above) + " and " + number_text(rule.below);
  if (!lower) return "finite";
  return rule.may_be_zero ? "at least " + number_text(rule.above) : "greater than " + number_text(rule.above);
}

bool allowed(const ParameterRule& rule, double value) {
  if (!std::isfinite(value)) return false;
  return (value > rule.above || (rule.may_be_zero && value == rule.above)) && value < rule.below;
}

/// What the single ranges cannot say: the shear modulus at rest of laws with several terms, the fibre
/// direction.
void check_together(const LawRule& law, const std::vector<double>& p, const std::string& where) {
  if (law.name == "PY" && !(p[0] + p[1] > 0))
    refuse(where, "c10 + c01 is " + number_text(p[0] + p[1]) +
                      ", so the shear modulus at rest is not positive and the body "
                      "would collapse; correct the parameters");
  if (law.name == "OG") {
    const double twice_mu = p[0] * p[1] + p[2] * p[3] + p[4] * p[5];
    for (std::size_t i = 0; i < 6; i += 2)
      if (p[i] != 0 && p[i + 1] == 0)
        refuse(where, "an exponent alpha is 0 where its mu is not; give the exponent or set mu to 0");
    if (!(twice_mu > 0))
      refuse(where, "the sum of mu alpha is " + number_text(twice_mu) +
                        ", so the shear modulus at rest is not positive and the "
                        "body would collapse; correct the parameters");
  }
  if (law.direction < 0) return;
  const double* a = p.data() + law.direction;
  if (!(a[0] * a[0] + a[1] * a[1] + a[2] * a[2] > 0))
    refuse(where, "the fibre direction is the zero vector; give its three components");
}

void check_parameters(const LawRule& law, const std::vector<double>& p, const std::string& where) {
  for (std::size_t i = 0; i < p.size(); ++i)
    if (!allowed(law.parameters[i], p[i]))
      refuse(where, "the parameter " + std::string(law.parameters[i].name) + " of " + std::string(law.name) +
                        " is " + number_text(p[i]) + ", but must be " + bounds_text(law.parameters[i]));
  check_together(law, p, where);
}

void check_prony(const std::vector<PronyTerm>& terms, const char* kind, const std::string& where) {
  double sum = 0;
  for (const auto& term : terms) {
    if (!(term.tau > 0) || !std::isfinite(term.tau))
      refuse(where, std::string("a ") + kind + " Prony term has tau = " + number_text(term.tau) +
                        ", but a time constant must be greater than 0");
    if (!(term.alpha >= 0) || !std::isfinite(term.alpha))
      refuse(where, std::string("a ") + kind + " Prony term has alpha = " + number_text(term.alpha) +
                        ", but must be 0 to 1");
    sum += term.alpha;
  }
  if (!(sum < 1))
    refuse(where, std::string("the ") + kind + " alphas sum to " + number_text(sum) +
                      ", so no stiffness is left in the long term; keep the sum below 1");
}

void check_material(const Section& section, const std::string& where, Warnings& warnings) {
  const auto& material = section.material;
  const LawRule* law = find_law(material.law);
  if (law == nullptr) {
    std::string names;
    for (const auto& known : law_table) names += " " + std::string(known.name);
    refuse(where, "there is no law '" + material.law + "'; the laws are" + names);
  }
  if (material.parameters.size() != law->parameters.size())
    refuse(where, "the law " + material.law + " needs " + std::to_string(law->parameters.size()) +
                      " parameters, not " + std::to_string(material.parameters.size()));
  if (!(material.density > 0) || !std::isfinite(material.density))
    refuse(where, "the density is " + number_text(material.density) + ", but must be greater than 0");
  check_prony(material.isochoric, "isochoric", where);
  check_prony(material.volumetric, "volumetric", where);
  for (const auto& [index, values] : material.element_parameters) {
    if (index < 0 || static_cast<std::size_t>(index) >= law->parameters.size())
      refuse(where, "per-element values are given for parameter " + std::to_string(index) +
                        ", which the law does not have");
    if (values.size() != section.elements.size())
      refuse(where, std::to_string(values.size()) + " per-element values are given for " +
                        std::to_string(section.elements.size()) + " elements");
  }
  auto parameters = material.parameters;
  if (material.element_parameters.empty()) check_parameters(*law, parameters, where);
  for (std::size_t i = 0; i < section.elements.size() && !material.element_parameters.empty(); ++i) {
    for (const auto& [index, values] : material.element_parameters)
      parameters[static_cast<std::size_t>(index)] = values[i];
    check_parameters(*law, parameters, where + ", element " + std::to_string(section.elements[i]));
  }
  if (material.law == "AB" && material.parameters[1] <= 1)
    warnings.push_back(where + ": lambda_m is " + number_text(material.parameters[1]) +
                       ", but a limiting stretch is normally above 1");
}

void check_locking(const Section& section, const std::string& where, Warnings& warnings) {
  const auto& p = section.material.parameters;
  const auto& law = section.material.law;
  if (section.formulation != Formulation::t4) return;
  double mu = 0, kappa = p.back();
  if (law == "NH" || law == "TI") mu = p[0], kappa = p[1];
  if (law == "AB") mu = p[0], kappa = p[2];
  if (law == "PY") mu = 2 * (p[0] + p[1]);
  if (law == "OG") mu = 0.5 * (p[0] * p[1] + p[2] * p[3] + p[4] * p[5]);
  const bool locks = law == "LE" ? p[1] > 0.495 : kappa > 100 * mu;
  if (locks)
    warnings.push_back(where + ": T4 elements lock in a nearly incompressible material; T4ANP does not");
}

}  // namespace

std::vector<Formulation> check_sections(const Model& model, Warnings& warnings) {
  const Mesh& mesh = model.mesh;
  if (model.sections.empty() && mesh.element_count() > 0)
    refuse("model", "no element has a material; add an ElementSet");
  std::vector<int> owner(mesh.shape.size(), -1);
  std::vector<Formulation> formulation(mesh.shape.size());
  for (std::size_t s = 0; s < model.sections.size(); ++s) {
    const Section& section = model.sections[s];
    const auto where = section_name(model, s);
    if (section.elements.empty()) refuse(where, "it has no elements");
    for (const int e : section.elements) {
      if (e < 0 || e >= mesh.element_count())
        refuse(where, "it lists element " + std::to_string(e) + ", but the elements are 0 to " +
                          std::to_string(mesh.element_count() - 1));
      int& its_owner = owner[static_cast<std::size_t>(e)];
      if (its_owner >= 0)
        refuse(where, "element " + std::to_string(e) + " is also in " +
                          section_name(model, static_cast<std::size_t>(its_owner)) +
                          "; every element must be in exactly one set, take it out of one of them");
      if (shape_of(section.formulation) != mesh.shape[static_cast<std::size_t>(e)])
        refuse(where, "the formulation " + std::string(name_of(section.formulation)) +
                          " does not fit the shape of element " + std::to_string(e));
      its_owner = static_cast<int>(s);
      formulation[static_cast<std::size_t>(e)] = section.formulation;
    }
    if (!(section.hourglass >= 0) || !std::isfinite(section.hourglass))
      refuse(where,
             "the hourglass coefficient is " + number_text(section.hourglass) + ", but must not be negative");
    check_material(section, where, warnings);
    check_locking(section, where, warnings);
  }
  for (std::size_t e = 0; e < owner.size(); ++e)
    if (owner[e] < 0)
      refuse(
          "element " + std::to_string(e),
          "it is in no ElementSet, so it has no material; add it to one" +
              (mesh.label.empty() ? std::string() : " (its label is " + std::to_string(mesh.label[e]) + ")"));
  return formulation;
}

}  // namespace glisson::detail
