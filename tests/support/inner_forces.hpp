// Forces, energies and histories of the elements of a model on a backend, for tests that compare one form of
// them with another.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <glisson/core/backend.hpp>
#include <glisson/core/numbering.hpp>
#include <glisson/core/solids/solid_forces.hpp>

namespace glisson::test {

/// Which displacement a test looks at, and what f starts from, because providers add [N].
struct ForceCase {
  std::function<Vec3<double>(const Vec3<double>& X, double scale)> displacement;
  Vec3<double> start;
};

template <class B, class R>
class InnerForces {
 public:
  /// make(backend, model, numbering) -> std::unique_ptr<SolidForces<R>>
  template <class Make>
  InnerForces(B backend, const Model& model, Make make, ForceCase its)
      : backend_(std::move(backend)),
        model_(model),
        case_(std::move(its)),
        numbering_(make_numbering(model.mesh)),
        forces_(make(backend_, model, numbering_)),
        u_(backend_.template allocate<Vec4<R>>(count())),
        f_(backend_.template allocate<Vec4<R>>(count())) {}

  std::vector<Vec4<R>> forces(double scale, bool advance = true) {
    StepView<R> step = view(scale);
    step.advance = advance;
    forces_->add_forces(step);
    return found();
  }
  /// The same where the parts of shared nodes are left to a sweep over the nodes.
  std::vector<Vec4<R>> forces_with_left(double scale) {
    const StepView<R> step = view(scale);
    const SharedForces<R> left = forces_->add_all_but_shared(step);
    EXPECT_NE(left.number, nullptr) << "nothing was left";
    backend_.for_each(step.node_count, AddLeft{left, step.f});
    return found();
  }
  double strain_energy(double scale) { return forces_->strain_energy(view(scale)).read(); }
  double hourglass_energy(double scale) { return forces_->hourglass_energy(view(scale)).read(); }
  SolidForces<R>& get() { return *forces_; }

 private:
  struct AddLeft {
    SharedForces<R> left;
    Vec4<R>* f;
    void operator()(int n) const { f[n] = left.add_to_node(n, f[n]); }
  };
  std::size_t count() const { return model_.mesh.X.size(); }
  std::vector<Vec4<R>> found() {
    std::vector<Vec4<R>> f(count());
    backend_.copy_out(f_.get(), f.data(), f.size());
    return f;
  }
  /// The displacement is that of float in every precision.
  StepView<R> view(double scale) {
    const Vec4<R> start{R(case_.start.x), R(case_.start.y), R(case_.start.z), R(0)};
    std::vector<Vec4<R>> u(count()), f(count(), start);
    for (std::size_t n = 0; n < u.size(); ++n) {
      const auto user = static_cast<std::size_t>(numbering_.user_of_internal[n]);
      const Vec3<double> a = case_.displacement(model_.mesh.X[user], scale);
      u[n] = {R(float(a.x)), R(float(a.y)), R(float(a.z)), R(0)};
    }
    backend_.copy_in(u.data(), u_.get(), u.size());
    backend_.copy_in(f.data(), f_.get(), f.size());
    StepView<R> step;
    step.u = u_.get(), step.f = f_.get();
    step.node_count = static_cast<int>(count());
    step.dt = 1e-3;
    return step;
  }

  B backend_;
  const Model& model_;
  ForceCase case_;
  Numbering numbering_;
  std::unique_ptr<SolidForces<R>> forces_;
  Buffer<Vec4<R>> u_, f_;
};

/// Of a from b, over the size of b, both without what f started from.
template <class R>
double difference(const std::vector<Vec4<R>>& a, const std::vector<Vec4<double>>& b,
                  const Vec3<double>& start) {
  double squares = 0, norm = 0;
  const auto add = [&](R x, double y, double from) {
    squares += (double(x) - y) * (double(x) - y), norm += (y - from) * (y - from);
  };
  for (std::size_t n = 0; n < a.size(); ++n)
    add(a[n].x, b[n].x, start.x), add(a[n].y, b[n].y, start.y), add(a[n].z, b[n].z, start.z);
  return std::sqrt(squares / norm);
}

}  // namespace glisson::test
