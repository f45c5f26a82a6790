#include <glisson/shells/shell_fields.hpp>

#include <algorithm>
#include <cmath>

#include <glisson/core/tensor/symmetric.hpp>
#include <glisson/shells/laws/laws.hpp>
#include <glisson/shells/relaxation.hpp>
#include <glisson/shells/shell_kernels.hpp>

namespace glisson::shells {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// sum P_kl t_k t_l
Sym3<double> in_space(const SurfaceFrame& frame, const Plane<double>& P) {
  const auto &a = frame.t[0], &b = frame.t[1];
  const auto entry = [&](double ai, double aj, double bi, double bj) {
    return P.xx * ai * aj + P.yy * bi * bj + P.xy * (ai * bj + bi * aj);
  };
  return {entry(a.x, a.x, b.x, b.x), entry(a.y, a.y, b.y, b.y), entry(a.z, a.z, b.z, b.z),
          entry(a.x, a.y, b.x, b.y), entry(a.y, a.z, b.y, b.z), entry(a.x, a.z, b.x, b.z)};
}

/// One section with element E and law L.
template <class E, class L>
class SectionFields {
 public:
  SectionFields(const HostShells& block, std::span<const Vec3<double>> u, std::span<const double> history,
                double dt)
      : block_(block),
        section_(*block.section),
        u_(u),
        history_(history.begin(), history.end()),
        law_(L::load(block.section->parameters.data())) {
    for (const PronyTerm& t : section_.prony) terms_.push_back(prony_coefficients(t.alpha, t.tau, dt));
  }

  void element(std::size_t k, const typename E::template Constants<double>& constants, ShellFields& out) {
    Vec3<double> u_e[E::node_count];
    for (std::size_t a = 0; a < E::node_count; ++a) u_e[a] = u_[at(block_.nodes[k * E::node_count + a])];
    const auto e = at(section_.elements[k]);
    const double h = section_.thickness_of(k);
    const Plane<double> c = E::plane_strain(constants, u_e);
    const Plane<double> counts = section_.wrinkling ? tension_field(law_, c).c : c;
    const double q = law_.thickness_change(counts);
    const Plane<double> S = stress(k, c);
    const SurfaceFrame& frame = block_.frames[k];
    out.stress[e] = in_space(frame, S);
    out.membrane_force[e] = in_space(frame, {h * S.xx, h * S.yy, h * S.xy});
    out.strain[e] = in_space(frame, {c.xx / 2, c.yy / 2, c.xy / 2});
    out.strain[e] = out.strain[e] + in_space({{frame.normal, {}}, {}}, {q / 2, 0, 0});
    out.area_ratio[e] = std::sqrt(std::max(0.0, 1 + area_change(c)));
    out.J[e] = std::sqrt(std::max(0.0, (1 + area_change(counts)) * (1 + q)));
    out.rest_thickness[e] = h;
    out.thickness[e] = h * std::sqrt(1 + q);
    out.energy[e] = constants.volume * law_.energy(counts) + E::bending_energy(constants, u_e);
    if constexpr (std::is_same_v<E, RotationFree>) bend(e, frame, constants, u_e, out);
  }

 private:
  Plane<double> stress(std::size_t k, const Plane<double>& c) {
    const Plane<double> S = section_.wrinkling ? tension_field_stress(law_, c) : law_.second_pk(c);
    const PlaneHistory<double, double> history{history_.data() + 3 * terms_.size() * k, terms_.data(),
                                               static_cast<int>(terms_.size())};
    return relaxed(history, 0, S, false);  // only read: store is false
  }
  void bend(std::size_t e, const SurfaceFrame& frame, const RotationFree::Constants<double>& constants,
            const Vec3<double> (&u_e)[RotationFree::node_count], ShellFields& out) const {
    const Bending<double> chi = RotationFree::state(constants, u_e).chi;
    const double stiffness = 2 * constants.bending * constants.inverse_double_area;
    const Bending<double> M = RotationFree::moments(stiffness, constants.nu, chi);
    out.moment[e] = in_space(frame, {M.xx, M.yy, M.xy});
    out.curvature[e] = in_space(frame, {chi.xx, chi.yy, chi.xy / 2});
  }

  const HostShells& block_;
  const ShellSection& section_;
  std::span<const Vec3<double>> u_;
  std::vector<double> history_;
  L law_;
  std::vector<PronyCoefficients<double>> terms_;
};

}  // namespace

ShellFields shell_fields(const Model& model, std::span<const Vec3<double>> u, std::span<const double> history,
                         double dt) {
  ShellFields fields;
  fields.resize(model.mesh.triangles.size());
  std::size_t first = 0;
  int set = 0;
  for (const HostShells& block : make_shell_blocks(model)) {
    const ShellSection& section = *block.section;
    const std::size_t size = 3 * section.prony.size() * section.elements.size();
    const auto run = [&]<class E, class L>(const auto& constants) {
      if (section.law != L::name) return;
      SectionFields<E, L> of(block, u, history.subspan(first, size), dt);
      for (std::size_t k = 0; k < constants.size(); ++k) of.element(k, constants[k], fields);
    };
    if (block.bends())
      for_each_type(ShellLaws<double>{},
                    [&]<class L>() { run.template operator()<RotationFree, L>(block.shells); });
    else
      for_each_type(MembraneLaws<double>{},
                    [&]<class L>() { run.template operator()<Membrane, L>(block.membranes); });
    for (const int e : section.elements) fields.set[at(e)] = set;
    first += size, ++set;
  }
  return fields;
}

}  // namespace glisson::shells
