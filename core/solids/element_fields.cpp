#include <glisson/core/solids/element_fields.hpp>

#include <string>

#include <glisson/core/elements/h8.hpp>
#include <glisson/core/elements/h8_full.hpp>
#include <glisson/core/elements/t4.hpp>
#include <glisson/core/kernels/averaged_pressure.hpp>
#include <glisson/core/materials/laws.hpp>
#include <glisson/core/materials/prony.hpp>
#include <glisson/core/solids/section_laws.hpp>

namespace glisson {
namespace {

using Positions = std::span<const Vec3<double>>;

template <int N>
void corners(const Mesh& mesh, Positions of, int e, Vec3<double> (&out)[N]) {
  const auto nodes = mesh.element(e);
  for (std::size_t a = 0; a < N; ++a) out[a] = of[static_cast<std::size_t>(nodes[a])];
}

/// Mean of kappa (J - 1) around each node, for T4ANP.
std::vector<double> nodal_pressure(const Model& model, Positions u) {
  std::vector<double> sum(model.mesh.X.size(), 0.0), volume(model.mesh.X.size(), 0.0);
  std::vector<double> parameters;
  for (const Section& section : model.sections) {
    if (section.formulation != Formulation::t4anp) continue;
    for (std::size_t k = 0; k < section.elements.size(); ++k) {
      const int e = section.elements[k];
      element_parameters(section, k, parameters);
      Vec3<double> X[4], ue[4];
      corners(model.mesh, model.mesh.X, e, X);
      corners(model.mesh, u, e, ue);
      const auto c = T4::make(X);
      Mat3<double> D;
      double J_minus_1 = 0;
      volume_terms(T4::displacement_gradient(c, ue), D, J_minus_1);
      const double p = rest_moduli(section.material.law, parameters).bulk * J_minus_1;
      for (const int n : model.mesh.element(e))
        sum[static_cast<std::size_t>(n)] += p * c.volume, volume[static_cast<std::size_t>(n)] += c.volume;
    }
  }
  for (std::size_t n = 0; n < sum.size(); ++n)
    if (volume[n] > 0) sum[n] /= volume[n];
  return sum;
}

struct PointValues {
  Sym3<double> stress{}, strain{};
  double J = 0, weight = 0;
};

void accumulate(PointValues& sum, const Mat3<double>& H, const Sym3<double>& S, double w) {
  auto add = [w](Sym3<double>& a, const Sym3<double>& b, double scale) {
    a.xx += w * scale * b.xx, a.yy += w * scale * b.yy, a.zz += w * scale * b.zz;
    a.xy += w * scale * b.xy, a.yz += w * scale * b.yz, a.xz += w * scale * b.xz;
  };
  Mat3<double> D;
  double J_minus_1 = 0;
  volume_terms(H, D, J_minus_1);
  add(sum.stress, S, 1);
  add(sum.strain, twice_green_lagrange(H), 0.5);
  sum.J += w * (1 + J_minus_1);
  sum.weight += w;
}

Sym3<double> scaled(double s, const Sym3<double>& a) {
  return {s * a.xx, s * a.yy, s * a.zz, s * a.xy, s * a.yz, s * a.xz};
}

/// One section with law L: everything about the element but the law is decided by its formulation.
template <class L>
class SectionFields {
 public:
  SectionFields(const Model& model, const Section& section, Positions u, const std::vector<double>& history,
                std::size_t first, double dt, const std::vector<double>& pressure, ElementFields& out)
      : model_(model),
        section_(section),
        u_(u),
        history_(history),
        place_(first),
        pressure_(pressure),
        out_(out) {
    for (const auto* terms : {&section.material.isochoric, &section.material.volumetric})
      for (const PronyTerm& t : *terms) terms_.push_back(prony_coefficients(t.alpha, t.tau, dt));
  }

  void run() {
    std::vector<double> parameters;
    for (std::size_t k = 0; k < section_.elements.size(); ++k) {
      element_parameters(section_, k, parameters);
      const L law = L::load(parameters.data());
      const int e = section_.elements[k];
      switch (section_.formulation) {
        case Formulation::t4:
          element<T4>(e, law, T4::make);
          break;
        case Formulation::t4anp:
          averaged(e, law);
          break;
        case Formulation::h8:
          element<H8>(e, law, H8::make);
          break;
        case Formulation::h8_fixed:
          element<H8>(e, law, H8::make_fixed);
          break;
        case Formulation::h8_full:
          element<H8Full>(e, law, H8Full::make);
          break;
      }
    }
  }

 private:
  Sym3<double> stress(const L& law, const Mat3<double>& H, int p) const {
    if (terms_.empty()) {
      const SplitStress<double> S = law.second_pk(H);
      return S.isochoric + S.volumetric;
    }
    const int isochoric = static_cast<int>(section_.material.isochoric.size());
    const PronyTerms<double> prony{terms_.data(), isochoric, static_cast<int>(terms_.size()) - isochoric};
    auto* values =
        const_cast<double*>(history_.data()) + place_ + static_cast<std::size_t>(p) * 6 * terms_.size();
    return second_pk_relaxed(law, H, prony, StridedHistory<double>{values, 1},
                             false);  // only read: store is false
  }
  void finish(int e, const PointValues& sum) {
    const auto i = static_cast<std::size_t>(e);
    out_.stress[i] = scaled(1 / sum.weight, sum.stress);
    out_.strain[i] = scaled(1 / sum.weight, sum.strain);
    out_.J[i] = sum.J / sum.weight;
  }
  template <class E, class Make>
  void element(int e, const L& law, const Make& make) {
    Vec3<double> X[E::node_count], ue[E::node_count];
    corners(model_.mesh, model_.mesh.X, e, X);
    corners(model_.mesh, u_, e, ue);
    PointValues sum;
    E::points(make(X, 0), ue,
              [&](const Mat3<double>& H, double w, int p) { accumulate(sum, H, stress(law, H, p), w); });
    place_ += static_cast<std::size_t>(E::point_count) * 6 * terms_.size();
    finish(e, sum);
  }
  void averaged(int e, const L& law) {
    Vec3<double> X[4], ue[4];
    corners(model_.mesh, model_.mesh.X, e, X);
    corners(model_.mesh, u_, e, ue);
    double p = 0;
    for (const int n : model_.mesh.element(e)) p += pressure_[static_cast<std::size_t>(n)] / 4;
    const Mat3<double> H =
        averaged_gradient(T4::displacement_gradient(T4::make(X), ue), p / law.bulk_modulus());
    PointValues sum;
    accumulate(sum, H, stress(law, H, 0), 1);
    place_ += 6 * terms_.size();
    finish(e, sum);
  }

  const Model& model_;
  const Section& section_;
  Positions u_;
  const std::vector<double>& history_;
  std::size_t place_;
  const std::vector<double>& pressure_;
  ElementFields& out_;
  std::vector<PronyCoefficients<double>> terms_;
};

std::size_t history_size(const Section& section) {
  const std::size_t terms = section.material.isochoric.size() + section.material.volumetric.size();
  const std::size_t points = section.formulation == Formulation::h8_full ? H8Full::point_count : 1;
  return section.elements.size() * terms * 6 * points;
}

}  // namespace

ElementFields element_fields(const Model& model, Positions u, const std::vector<double>& history, double dt) {
  const auto count = static_cast<std::size_t>(model.mesh.element_count());
  ElementFields fields{std::vector<Sym3<double>>(count), std::vector<Sym3<double>>(count),
                       std::vector<double>(count, 1.0)};
  const std::vector<double> pressure = nodal_pressure(model, u);
  std::size_t first = 0;
  for (const Section& section : model.sections) {
    for_each_type(AllLaws<double>{}, [&]<class L>() {
      if (section.material.law == L::name)
        SectionFields<L>(model, section, u, history, first, dt, pressure, fields).run();
    });
    first += history_size(section);
  }
  return fields;
}

}  // namespace glisson
