#include <glisson/core/solids/element_fields.hpp>

#include <algorithm>
#include <memory>
#include <span>

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
  const auto averages = [](const Section& s) { return s.formulation == Formulation::t4anp; };
  if (std::none_of(model.sections.begin(), model.sections.end(), averages)) return {};
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

/// The state that fields are asked of.
struct State {
  const Model& model;
  std::vector<Vec3<double>> u;
  std::vector<double> history;
  double dt;
  std::vector<double> pressure;     ///< of the nodes, for T4ANP [Pa]
  std::vector<std::size_t> places;  ///< where the history of each section begins
  std::vector<bool> sorted;         ///< sections whose elements come in increasing order
};

/// A part of a section with law L: everything about the element but the law is decided by its formulation.
template <class L>
class SectionFields {
 public:
  /// `out` begins with element `first`.
  SectionFields(const State& state, std::size_t section, int first, ElementFields& out)
      : state_(state),
        model_(state.model),
        section_(state.model.sections[section]),
        place_(state.places[section]),
        first_(first),
        out_(out) {
    for (const auto* terms : {&section_.material.isochoric, &section_.material.volumetric})
      for (const PronyTerm& t : *terms) terms_.push_back(prony_coefficients(t.alpha, t.tau, state.dt));
  }

  /// The element at place k of the section.
  void run(std::size_t k) {
    element_parameters(section_, k, parameters_);
    const L law = L::load(parameters_.data());
    const int e = section_.elements[k];
    switch (section_.formulation) {
      case Formulation::t4:
        return element<T4>(e, k, law, T4::make);
      case Formulation::t4anp:
        return averaged(e, k, law);
      case Formulation::h8:
        return element<H8>(e, k, law, H8::make);
      case Formulation::h8_fixed:
        return element<H8>(e, k, law, H8::make_fixed);
      case Formulation::h8_full:
        return element<H8Full>(e, k, law, H8Full::make);
    }
  }

 private:
  Sym3<double> stress(const L& law, const Mat3<double>& H, std::size_t point) const {
    if (terms_.empty()) {
      const SplitStress<double> S = law.second_pk(H);
      return S.isochoric + S.volumetric;
    }
    const int isochoric = static_cast<int>(section_.material.isochoric.size());
    const PronyTerms<double> prony{terms_.data(), isochoric, static_cast<int>(terms_.size()) - isochoric};
    auto* values = const_cast<double*>(state_.history.data()) + place_ + point * 6 * terms_.size();
    return second_pk_relaxed(law, H, prony, StridedHistory<double>{values, 1},
                             false);  // only read: store is false
  }
  void finish(int e, const PointValues& sum) {
    const auto i = static_cast<std::size_t>(e - first_);
    out_.stress[i] = scaled(1 / sum.weight, sum.stress);
    out_.strain[i] = scaled(1 / sum.weight, sum.strain);
    out_.J[i] = sum.J / sum.weight;
  }
  template <class E, class Make>
  void element(int e, std::size_t k, const L& law, const Make& make) {
    Vec3<double> X[E::node_count], ue[E::node_count];
    corners(model_.mesh, model_.mesh.X, e, X);
    corners(model_.mesh, state_.u, e, ue);
    PointValues sum;
    const std::size_t first = k * static_cast<std::size_t>(E::point_count);
    E::points(make(X, 0), ue, [&](const Mat3<double>& H, double w, int p) {
      accumulate(sum, H, stress(law, H, first + static_cast<std::size_t>(p)), w);
    });
    finish(e, sum);
  }
  void averaged(int e, std::size_t k, const L& law) {
    Vec3<double> X[4], ue[4];
    corners(model_.mesh, model_.mesh.X, e, X);
    corners(model_.mesh, state_.u, e, ue);
    double p = 0;
    for (const int n : model_.mesh.element(e)) p += state_.pressure[static_cast<std::size_t>(n)] / 4;
    const Mat3<double> H =
        averaged_gradient(T4::displacement_gradient(T4::make(X), ue), p / law.bulk_modulus());
    PointValues sum;
    accumulate(sum, H, stress(law, H, k), 1);
    finish(e, sum);
  }

  const State& state_;
  const Model& model_;
  const Section& section_;
  std::size_t place_;
  int first_;
  ElementFields& out_;
  std::vector<PronyCoefficients<double>> terms_;
  std::vector<double> parameters_;
};

std::size_t history_size(const Section& section) {
  const std::size_t terms = section.material.isochoric.size() + section.material.volumetric.size();
  const std::size_t points = section.formulation == Formulation::h8_full ? H8Full::point_count : 1;
  return section.elements.size() * terms * 6 * points;
}

/// Calls use(k) for the places k of a section whose elements are first ... first + count - 1.
template <class Use>
void for_each_inside(const Section& section, bool sorted, int first, int count, const Use& use) {
  const auto& elements = section.elements;
  const auto begin = sorted ? std::lower_bound(elements.begin(), elements.end(), first) : elements.begin();
  const auto end = sorted ? std::lower_bound(begin, elements.end(), first + count) : elements.end();
  for (auto place = begin; place != end; ++place)
    if (*place >= first && *place < first + count) use(static_cast<std::size_t>(place - elements.begin()));
}

ElementFields fields_of(const State& state, int first, int count) {
  const auto size = static_cast<std::size_t>(count);
  ElementFields fields{std::vector<Sym3<double>>(size), std::vector<Sym3<double>>(size),
                       std::vector<double>(size, 1.0)};
  for (std::size_t i = 0; i < state.model.sections.size(); ++i) {
    const Section& section = state.model.sections[i];
    for_each_type(AllLaws<double>{}, [&]<class L>() {
      if (section.material.law != L::name) return;
      SectionFields<L> of(state, i, first, fields);
      for_each_inside(section, state.sorted[i], first, count, [&](std::size_t k) { of.run(k); });
    });
  }
  return fields;
}

}  // namespace

ElementFieldSource element_field_source(const Model& model, std::vector<Vec3<double>> u,
                                        std::vector<double> history, double dt) {
  auto pressure = nodal_pressure(model, u);
  auto state = std::make_shared<State>(
      State{model, std::move(u), std::move(history), dt, std::move(pressure), {}, {}});
  std::size_t place = 0;
  for (const Section& section : model.sections) {
    state->places.push_back(place);
    state->sorted.push_back(std::is_sorted(section.elements.begin(), section.elements.end()));
    place += history_size(section);
  }
  return {model.mesh.element_count(),
          [state](int first, int count) { return fields_of(*state, first, count); }};
}

}  // namespace glisson
