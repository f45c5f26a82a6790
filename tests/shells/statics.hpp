// Static solutions of shell models by Newton's method with tangents from dual numbers: independent of steps,
// masses and backends, so that tests see the elements alone.
#pragma once

#include <array>
#include <vector>

#include <glisson/core/model.hpp>
#include <glisson/core/numbers/dual.hpp>
#include <glisson/shells/laws/laws.hpp>
#include <glisson/shells/laws/tension_field.hpp>
#include <glisson/shells/shell_blocks.hpp>

namespace glisson::test {

using Real = Dual<double>;

/// Forces of one triangle on its slots, for any number type.
template <class R>
void triangle_forces(const shells::HostShells& block, std::size_t k, const std::vector<Vec3<R>>& u,
                     std::vector<Vec3<R>>& f) {
  const auto run = [&]<class E>(const auto& constants, const auto& law) {
    Vec3<R> ue[E::node_count], fe[E::node_count];
    for (int a = 0; a < E::node_count; ++a) ue[a] = u[static_cast<std::size_t>(a)];
    const auto stress = [&](const shells::Plane<R>& c) {
      return block.section->wrinkling ? shells::tension_field_stress(law, c) : law.second_pk(c);
    };
    E::forces(shells::narrowed<R, E::template Constants>(constants), ue, stress, fe);
    f.assign(fe, fe + E::node_count);
  };
  for_each_type(shells::MembraneLaws<R>{}, [&]<class L>() {
    if (block.section->law != L::name) return;
    std::vector<R> parameters;
    for (const double p : block.section->parameters) parameters.push_back(R(p));
    const L law = L::load(parameters.data());
    if (block.bends())
      run.template operator()<shells::RotationFree>(block.shells[k], law);
    else
      run.template operator()<shells::Membrane>(block.membranes[k], law);
  });
}

struct MatrixEntry {
  int row = 0, col = 0;
  double value = 0;
};

class ShellStatics {
 public:
  /// fixed: [node_count][3], true where the displacement is prescribed.
  ShellStatics(const Model& model, std::vector<std::array<bool, 3>> fixed)
      : blocks_(shells::make_shell_blocks(model)), fixed_(std::move(fixed)), u_(model.mesh.X.size()) {}

  std::vector<Vec3<double>>& u() { return u_; }
  std::size_t dofs() const { return 3 * u_.size(); }

  /// Internal forces and the entries of K = -df/du of the present state.
  void evaluate(std::vector<Vec3<double>>& f, std::vector<MatrixEntry>& K) const;

  /// u <- u + K^-1 (f + load); returns |f + load| over the free directions before that.
  double newton_step(const std::vector<Vec3<double>>& load);
  /// Newton to a residual of `tolerance` times the first one; false when 50 steps do not reach it.
  bool solve(const std::vector<Vec3<double>>& load, double tolerance = 1e-8) {
    const double first = newton_step(load);
    for (int i = 0; i < 50; ++i)
      if (newton_step(load) <= tolerance * first) return true;
    return false;
  }

 private:
  std::vector<shells::HostShells> blocks_;
  std::vector<std::array<bool, 3>> fixed_;
  std::vector<Vec3<double>> u_;
};

}  // namespace glisson::test
