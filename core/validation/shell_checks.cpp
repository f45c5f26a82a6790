// Membranes and shells: every triangle once and in one set, with area, neighbours that a shell can use, a
// law.
#include <glisson/core/materials/shell_law_table.hpp>
#include <glisson/core/mesh/triangles.hpp>
#include <glisson/core/validation/checks.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace glisson::detail {
namespace {

std::string triangle_text(int e) { return "shell triangle " + std::to_string(e); }

std::string nodes_text(const Triangle& t) {
  return std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]);
}

}  // namespace

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
      if (t[a] == t[(a + 1) % 3])
        refuse(triangle_text(e), "it uses node " + std::to_string(t[a]) + " twice (" + nodes_text(t) +
                                     "); give three different nodes or remove it");
      const auto d =
          mesh.X[static_cast<std::size_t>(t[a])] - mesh.X[static_cast<std::size_t>(t[(a + 1) % 3])];
      longest = std::max(longest, dot(d, d));
    }
    const double area = triangle_area(t, mesh.X);
    if (!(area > 1e-6 * longest))
      refuse(triangle_text(e), "its area is " + number_text(area) + ": its corners (nodes " + nodes_text(t) +
                                   ") lie on a line, so it has no stiffness of its own; correct its nodes or "
                                   "the mesh");
    std::sort(t.begin(), t.end());
    sorted.emplace_back(t, e);
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i].first == sorted[i - 1].first)
      refuse(triangle_text(sorted[i].second),
             "it has the same nodes as triangle " + std::to_string(sorted[i - 1].second) + " (" +
                 nodes_text(sorted[i].first) + "); remove one of them, or make one that is as thick as both");
}

namespace {

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
  const std::vector<double> one{value};
  for (const double v : values.empty() ? one : values)
    if (!(v > 0) || !std::isfinite(v))
      refuse(where, std::string("the ") + name + (values.empty() ? "" : " of a triangle") + " is " +
                        number_text(v) + ", but must be greater than 0");
}

void check_directions(const ShellSection& section, const std::string& where) {
  if (!section.element_direction.empty() && section.element_direction.size() != section.elements.size())
    refuse(where, std::to_string(section.element_direction.size()) + " directions are given for " +
                      std::to_string(section.elements.size()) + " triangles");
  for (std::size_t k = 0; k < section.elements.size(); ++k)
    if (const auto& d = section.direction_of(k); !std::isfinite(dot(d, d)))
      refuse(where, "the direction of triangle " + std::to_string(section.elements[k]) + " is not finite");
}

}  // namespace

void check_shell_section(const ShellSection& section, const std::string& where) {
  check_law(section, where);
  check_prony_terms(section, where);
  check_positive(section.element_thickness, section.thickness, section.elements.size(), "thickness", where);
  check_positive(section.element_density, section.density, section.elements.size(), "density", where);
  check_directions(section, where);
}

namespace {

/// Which section each triangle has; fails for one with two or none.
void check_shell_sections(const Model& model) {
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
    check_shell_section(section, where);
  }
  for (std::size_t e = 0; e < owner.size(); ++e)
    if (owner[e] < 0)
      refuse(triangle_text(static_cast<int>(e)),
             "it is in no ShellElementSet, so it has no material; add it to one");
}

/// 1 where a triangle is one of a rotation-free shell.  [triangle_count]
std::vector<char> bending_triangles(const Model& model) {
  std::vector<char> bends(model.mesh.triangles.size(), 0);
  for (const ShellSection& section : model.shells)
    if (section.formulation == ShellFormulation::rotation_free)
      for (const int e : section.elements) bends[static_cast<std::size_t>(e)] = 1;
  return bends;
}

}  // namespace

void check_shell_edges(const Model& model) {
  const auto& triangles = model.mesh.triangles;
  const auto bending = bending_triangles(model);
  const auto bends = [&](int side) { return bending[static_cast<std::size_t>(side / 3)] != 0; };
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

namespace {

void check_clamped(const Model& model, Warnings& warnings) {
  std::vector<char> fixed(model.mesh.X.size(), 0);
  for (const FixedNodes& fix : model.fixed)
    for (const int n : fix.nodes)
      if (n >= 0 && n < model.mesh.node_count()) fixed[static_cast<std::size_t>(n)] = 1;
  int loose = 0;
  for (const int n : model.clamped_nodes) {
    if (n < 0 || n >= model.mesh.node_count())
      refuse("ClampedNodes", "it names node " + std::to_string(n) + ", but the nodes are 0 to " +
                                 std::to_string(model.mesh.node_count() - 1));
    loose += fixed[static_cast<std::size_t>(n)] == 0;
  }
  if (loose > 0)
    warnings.push_back(std::to_string(loose) +
                       " clamped nodes are not fixed: ClampedNodes stops the rotation of the edges between "
                       "them only; add a Constraint of Type=\"Fix\" for their positions");
}

/// Borders that lie on each other with nodes of their own: neighbours are found by shared nodes only.
void check_seams(const Model& model, Warnings& warnings) {
  using Ends = std::array<std::array<double, 3>, 2>;
  const auto position = [&](int n) {
    const auto& X = model.mesh.X[static_cast<std::size_t>(n)];
    return std::array<double, 3>{X.x, X.y, X.z};
  };
  std::vector<std::pair<Ends, const TriangleEdge*>> borders;
  const auto edges = edges_of(model.mesh.triangles);
  for (const TriangleEdge& edge : edges) {
    if (edge.sides.size() != 1) continue;
    Ends ends{position(edge.a), position(edge.b)};
    if (ends[1] < ends[0]) std::swap(ends[0], ends[1]);
    borders.emplace_back(ends, &edge);
  }
  std::stable_sort(borders.begin(), borders.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  int pairs = 0;
  std::string first;
  for (std::size_t i = 1; i < borders.size(); ++i) {
    if (borders[i].first != borders[i - 1].first) continue;
    const auto text = [](const TriangleEdge& e) { return std::to_string(e.a) + " - " + std::to_string(e.b); };
    if (pairs++ == 0) first = text(*borders[i - 1].second) + " and " + text(*borders[i].second);
  }
  if (pairs > 0)
    warnings.push_back(std::to_string(pairs) + (pairs == 1 ? " pair" : " pairs") +
                       " of edges of membranes or shells lie on each other without sharing their nodes (" +
                       first + "): neither force nor moment passes there; merge the nodes if it should");
}

/// EBST1 is much too stiff in bending where the diagonals of a grid alternate, so that nodes of four and of
/// eight triangles take turns (doc/shells.md).
void check_diagonals(const Model& model, Warnings& warnings) {
  const auto bending = bending_triangles(model);
  std::vector<int> valence(model.mesh.X.size(), 0);
  std::vector<char> border(model.mesh.X.size(), 0);
  std::vector<Triangle> bent;
  for (std::size_t e = 0; e < bending.size(); ++e)
    if (bending[e] != 0) bent.push_back(model.mesh.triangles[e]);
  for (const Triangle& t : bent)
    for (const int n : t) ++valence[static_cast<std::size_t>(n)];
  for (const TriangleEdge& edge : edges_of(bent))
    if (edge.sides.size() == 1)
      border[static_cast<std::size_t>(edge.a)] = border[static_cast<std::size_t>(edge.b)] = 1;
  int inner = 0, four = 0, eight = 0;
  for (std::size_t n = 0; n < valence.size(); ++n) {
    if (valence[n] == 0 || border[n] != 0) continue;
    ++inner, four += valence[n] == 4, eight += valence[n] == 8;
  }
  if (four > 1 && eight > 0 && 2 * (four + eight) > inner)
    warnings.push_back("the diagonals of the shell's mesh alternate (" + std::to_string(four) +
                       " inner nodes have four triangles, " + std::to_string(eight) +
                       " have eight): rotation-free shells are much too stiff in bending there and do not "
                       "converge; mesh with parallel diagonals or with about six triangles at each node");
}

}  // namespace

void check_shells(const Model& model, Warnings& warnings) {
  check_triangles(model.mesh);
  check_shell_sections(model);
  check_shell_edges(model);
  check_clamped(model, warnings);
  check_diagonals(model, warnings);
  check_seams(model, warnings);
}

}  // namespace glisson::detail
