// Shell models on mapped rectangles.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <vector>

#include <glisson/core/model.hpp>

namespace glisson::test {

inline ShellSection shell_section(double E, double nu, double h, double density = 1000) {
  ShellSection s;
  s.formulation = ShellFormulation::rotation_free;
  s.law = "Linear";
  s.parameters = {E, nu};
  s.bending_E = E, s.bending_nu = nu;
  s.density = density, s.thickness = h;
  return s;
}
inline ShellSection membrane_section(const std::string& law, std::vector<double> parameters, double h,
                                     double density = 1000) {
  ShellSection s;
  s.law = law;
  s.parameters = std::move(parameters);
  s.density = density, s.thickness = h;
  return s;
}

/// (n + 1) x (m + 1) nodes X(s, t), s, t in [0, 1], node number i + (n + 1) j. crossed: the diagonals
/// alternate.
inline Model sheet(int n, int m, const std::function<Vec3<double>(double, double)>& X, ShellSection section,
                   bool crossed = false) {
  Model model;
  model.name = "sheet";
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i <= n; ++i) model.mesh.X.push_back(X(double(i) / n, double(j) / m));
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = i + (n + 1) * j, b = a + 1, c = b + n + 1, d = a + n + 1;
      if (crossed && (i + j) % 2 == 1) {
        model.mesh.triangles.push_back({a, b, d});
        model.mesh.triangles.push_back({b, c, d});
      } else {
        model.mesh.triangles.push_back({a, b, c});
        model.mesh.triangles.push_back({a, c, d});
      }
    }
  section.elements.resize(model.mesh.triangles.size());
  std::iota(section.elements.begin(), section.elements.end(), 0);
  model.shells = {std::move(section)};
  model.time.total = 1;
  return model;
}

inline std::vector<int> sheet_nodes(const Model& model,
                                    const std::function<bool(const Vec3<double>&)>& keep) {
  std::vector<int> nodes;
  for (int n = 0; n < model.mesh.node_count(); ++n)
    if (keep(model.mesh.X[static_cast<std::size_t>(n)])) nodes.push_back(n);
  return nodes;
}

using FixedDirections = std::vector<std::array<bool, 3>>;
inline void fix(FixedDirections& fixed, const std::vector<int>& nodes, const char* axes) {
  for (const int n : nodes)
    for (const char* a = axes; *a != 0; ++a)
      fixed[static_cast<std::size_t>(n)][static_cast<std::size_t>(*a - 'x')] = true;
}

constexpr double pi = std::numbers::pi;

}  // namespace glisson::test
