// Membranes and shells: every triangle once and in one set, with area, neighbours that a shell can use, a
// law.
#include <glisson/core/materials/shell_law_table.hpp>
#include <glisson/core/mesh/triangles.hpp>
#include <glisson/core/validation/checks.hpp>

#include <algorithm>
#include <cmath>

namespace glisson::detail {
namespace {

std::string triangle_text(int e) { return "shell triangle " + std::to_string(e); }

void check_triangles(const Mesh& mesh) {
  std::vector<std::pair<Triangle, int>> sorted;
  for (int e = 0; e < static_cast<int>(mesh.triangles.size()); ++e) {
    Triangle t = mesh.triangles[static_cast<std::size_t>(e)];
    double longest = 0;
    for (std::size_t a = 0; a < 3; ++a)
      if (t[a] < 0 || t[a] >= mesh.node_count())
        refuse(triangle_text(e), "it uses node " + std::to_string(t[a]) + ", but the nodes are 0 to " +
                                     std::to_string(mesh.node_count() - 1));
    for (std::size_t a = 0; a < 3; ++a) {
      const auto d =
          mesh.X[static_cast<std::size_t>(t[a])] - mesh.X[static_cast<std::size_t>(t[(a + 1) % 3])];
      longest = std::max(longest, dot(d, d));
    }
    const double area = triangle_area(t, mesh.X);
    if (!(area > 1e-6 * longest))
      refuse(triangle_text(e), "its area is " + number_text(area) +
                                   ": its corners lie on a line, so it has no stiffness of its own; correct "
                                   "its nodes or the mesh");
    std::sort(t.begin(), t.end());
    sorted.emplace_back(t, e);
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i].first == sorted[i - 1].first)
      refuse(triangle_text(sorted[i].second), "it has the same nodes as triangle " +
                                                  std::to_string(sorted[i - 1].second) +
                                                  "; remove one of them");
}

std::string number_range(const ParameterRule& rule) {
  if (std::isfinite(rule.below))
    return "between " + number_text(rule.above) + " and " + number_text(rule.below);
  return (rule.may_be_zero ? "at least " : "greater than ") + number_text(rule.above);
}

void check_law(const ShellSection& section, const std::string& where) {
  const ShellLawRule* rule = find_shell_law(section.law);
  if (rule == nullptr) {
    std::string names;
    for (const auto& known : shell_law_table) names += " " + std::string(known.law.name);
    refuse(where, "there is no law '" + section.law + "' for membranes; the laws are" + names);
  }
  const auto& parameters = rule->law.parameters;
  if (section.parameters.size() != parameters.size())
    refuse(where, "the law " + section.law + " needs " + std::to_string(parameters.size()) +
                      " parameters, not " + std::to_string(section.parameters.size()));
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const double p = section.parameters[i];
    const bool above = p > parameters[i].above || (parameters[i].may_be_zero && p == parameters[i].above);
    if (!std::isfinite(p) || !above || !(p < parameters[i].below))
      refuse(where, "the parameter " + std::string(parameters[i].name) + " is " + number_text(p) +
                        ", but must be " + number_range(parameters[i]));
  }
  if (section.wrinkling && (!rule->wrinkles || section.formulation != ShellFormulation::membrane))
    refuse(where, "wrinkling needs a membrane with an isotropic law; remove it or change the law");
  if (section.formulation == ShellFormulation::membrane) return;
  if (!rule->shell)
    refuse(where, "the law " + section.law +
                      " cannot be the membrane part of a shell; use Linear, NeoHookean "
                      "or NeoHookeanCompressible");
  if (!(section.bending_E >= 0) || !std::isfinite(section.bending_E) || !(section.bending_nu > -1) ||
      !(section.bending_nu <= 0.5))
    refuse(where, "the bending stiffness needs E >= 0 and -1 < nu <= 0.5, not E = " +
                      number_text(section.bending_E) + ", nu = " + number_text(section.bending_nu));
}

void check_prony_terms(const ShellSection& section, const std::string& where) {
  double sum = 0;
  for (const PronyTerm& term : section.prony) {
    if (!(term.tau > 0) || !std::isfinite(term.tau) || !(term.alpha >= 0))
      refuse(where, "a Prony term has alpha = " + number_text(term.alpha) +
                        ", tau = " + number_text(term.tau) + "; alpha must be 0 to 1, tau greater than 0");
    sum += term.alpha;
  }
  if (!(sum < 1)) refuse(where, "the alphas sum to " + number_text(sum) + "; keep the sum below 1");
}

void check_positive(const std::vector<double>& values, double value, std::size_t count, const char* name,
                    const std::string& where) {
  if (!values.empty() && values.size() != count)
    refuse(where, std::to_string(values.size()) + " values of the " + name + " are given for " +
                      std::to_string(count) + " triangles");
  for (std::size_t k = 0; k < std::max<std::size_t>(values.size(), 1); ++k) {
    const double v = values.empty() ? value : values[k];
    if (!(v > 0) || !std::isfinite(v))
      refuse(where, std::string("the ") + name + " is " + number_text(v) + ", but must be greater than 0");
  }
}

/// Fills which section each triangle has.
std::vector<int> check_shell_sections(const Model& model) {
  std::vector<int> owner(model.mesh.triangles.size(), -1);
  for (std::size_t s = 0; s < model.shells.size(); ++s) {
    const ShellSection& section = model.shells[s];
    const std::string where = section.name.empty() ? "shell section " + std::to_string(s) : section.name;
    if (section.elements.empty()) refuse(where, "it has no triangles");
    for (const int e : section.elements) {
      if (e < 0 || static_cast<std::size_t>(e) >= owner.size())
        refuse(where, "it lists triangle " + std::to_string(e) + ", but the triangles are 0 to " +
                          std::to_string(static_cast<int>(owner.size()) - 1));
      int& its_owner = owner[static_cast<std::size_t>(e)];
      if (its_owner >= 0) refuse(where, triangle_text(e) + " is in two sets; take it out of one of them");
      its_owner = static_cast<int>(s);
    }
    check_law(section, where);
    check_prony_terms(section, where);
    check_positive(section.element_thickness, section.thickness, section.elements.size(), "thickness", where);
    check_positive(section.element_density, section.density, section.elements.size(), "density", where);
    const auto& d = section.direction;
    if (!std::isfinite(dot(d, d))) refuse(where, "the direction is not finite");
  }
  for (std::size_t e = 0; e < owner.size(); ++e)
    if (owner[e] < 0)
      refuse(triangle_text(static_cast<int>(e)),
             "it is in no ShellElementSet, so it has no material; add it to one");
  return owner;
}

void check_edges(const Model& model, const std::vector<int>& owner) {
  const auto& triangles = model.mesh.triangles;
  const auto bends = [&](int side) {
    const auto section = static_cast<std::size_t>(owner[static_cast<std::size_t>(side / 3)]);
    return model.shells[section].formulation == ShellFormulation::rotation_free;
  };
  for (const TriangleEdge& edge : edges_of(triangles)) {
    const std::string where = "shell edge " + std::to_string(edge.a) + " - " + std::to_string(edge.b);
    if (std::count_if(edge.sides.begin(), edge.sides.end(), bends) > 2)
      refuse(where,
             "more than two triangles of a rotation-free shell meet there, and curvature across such an "
             "edge is not defined; use membranes there, or give the parts nodes of their own");
    if (edge.sides.size() == 2 && !same_orientation(triangles, edge))
      refuse(where, "the triangles " + std::to_string(edge.sides[0] / 3) + " and " +
                        std::to_string(edge.sides[1] / 3) +
                        " have opposite orientations, so a pressure would push them to different sides; turn "
                        "one of them (orient() does it)");
  }
}

}  // namespace

void check_shells(const Model& model, Warnings&) {
  check_triangles(model.mesh);
  const auto owner = check_shell_sections(model);
  check_edges(model, owner);
  for (const int n : model.clamped_nodes)
    if (n < 0 || n >= model.mesh.node_count())
      refuse("ClampedNodes", "it names node " + std::to_string(n) + ", but the nodes are 0 to " +
                                 std::to_string(model.mesh.node_count() - 1));
}

}  // namespace glisson::detail
