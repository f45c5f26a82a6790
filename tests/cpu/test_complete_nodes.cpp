// The sweep that ends a step on devices against the separate loops: shared forces, reactions, update,
// constraints.
#include <gtest/gtest.h>

#include <vector>

#include <glisson/core/constraints/constraints.hpp>
#include <glisson/core/kernels/patch_view.hpp>
#include <glisson/core/mesh/box_mesh.hpp>
#include <glisson/core/steppers/steppers.hpp>
#include <glisson/cpu/emulated_device.hpp>

namespace glisson {
namespace {

using Step = CentralDifference<double>;
using Rows = std::vector<Vec4<double>>;

/// A box held below, pressed from above, and free to slide along a tilted plane on one side.
Model held_box() {
  Model model;
  model.mesh = box_mesh({3, 3, 3}, {1, 1, 1}, Shape::tetrahedron, 0);
  FixedNodes bottom;
  PrescribedDisplacement top;
  SlidingPlane side;
  for (int n = 0; n < model.mesh.node_count(); ++n) {
    const Vec3<double> X = model.mesh.X[static_cast<std::size_t>(n)];
    if (X.z < 1e-9) bottom.nodes.push_back(n);
    if (X.z > 1 - 1e-9) top.nodes.push_back(n);
    if (X.x > 1 - 1e-9 && X.z > 1e-9 && X.z < 1 - 1e-9) side.nodes.push_back(n);
  }
  top.axes = 5;
  top.values = {-0.1};
  side.normal = {0.8, 0.6, 0};
  model.fixed.push_back(bottom);
  model.displacements.push_back(top);
  model.planes.push_back(side);
  return model;
}

/// Every third node has one to three parts in slots.
struct Slots {
  explicit Slots(int node_count) : number(static_cast<std::size_t>(node_count), -1) {
    for (int n = 0; n < node_count; n += 3) {
      number[static_cast<std::size_t>(n)] = static_cast<int>(nodes.size());
      nodes.push_back(n);
      for (int k = 0; k <= n % 3 + n % 2; ++k) force.push_back({0.1 * k, 1.0 * n, -0.01 * n, 0});
      begin.push_back(static_cast<int>(force.size()));
    }
  }
  std::vector<int> nodes, number, begin{0};
  Rows force;
};

class CompleteNodesSweep : public testing::Test {
 protected:
  static constexpr double damping = 5, dt = 1e-3;

  template <class T>
  Buffer<T> upload(const std::vector<T>& from) {
    auto buffer = device_.allocate<T>(from.size());
    device_.copy_in(from.data(), buffer.get(), from.size());
    return buffer;
  }
  Rows rows(double a, double b, double w) const {
    Rows result;
    for (int n = 0; n < count_; ++n)
      result.push_back({a * n, b - a * n, a * b * n, n == 5 ? 0.0 : w + n * w});
    return result;
  }

  /// Three steps with the forces put in anew; returns u, v and the energies.
  void run(bool sweep, Rows& u_out, Rows& v_out, std::vector<NodeEnergies>& e_out, double& work) {
    Constraints<EmulatedDevice, double> constraints(device_, model_, numbering_);
    auto u = upload(rows(1e-3, 0.1, 0)), v = upload(rows(0.01, 0.3, 2)), f = upload(rows(0, 0, 0));
    e_out.resize(static_cast<std::size_t>(chunks_of(count_, node_energy_chunk)));
    auto energies = upload(e_out);
    for (int k = 0; k < 3; ++k) {
      const Rows force = rows(0.5, 2, 0);
      device_.copy_in(force.data(), f.get(), force.size());
      StepView<double> view;
      view.u = u.get(), view.v = v.get(), view.f = f.get();
      view.node_count = count_, view.step = k, view.dt = dt, view.monitor = true;
      const Step stepper = Step::make(damping, k == 0 ? dt / 2 : dt, dt);
      step(sweep, view, constraints, stepper, {u.get(), v.get(), f.get(), stepper.rows(), count_},
           energies.get());
    }
    u_out.resize(static_cast<std::size_t>(count_)), v_out.resize(static_cast<std::size_t>(count_));
    device_.copy_out(u.get(), u_out.data(), u_out.size());
    device_.copy_out(v.get(), v_out.data(), v_out.size());
    device_.copy_out(energies.get(), e_out.data(), e_out.size());
    work = constraints.work();
  }
  void step(bool sweep, const StepView<double>& view, Constraints<EmulatedDevice, double>& constraints,
            const Step& stepper, const AdvanceNodes<double, Step>& update, NodeEnergies* energies) {
    const SharedForces<double> shared{number_.get(), begin_.get(), force_.get()};
    const int chunks = chunks_of(count_, node_energy_chunk);
    const double t_next = dt * static_cast<double>(view.step + 1);
    if (sweep) {
      const CompleteNodes<double, Step> nodes{update, shared, constraints.for_sweep(view, t_next, stepper)};
      device_.for_each(chunks, AdvanceNodesMonitored<double, Step, CompleteNodes<double, Step>>{
                                   nodes, energies, count_, damping, dt, view.step == 0});
      constraints.finish(view);
      return;
    }
    device_.for_each(static_cast<int>(slots_.nodes.size()),
                     AddSharedForces<double>{nodes_.get(), shared, view.f});
    constraints.add_reactions(view, t_next, stepper);
    device_.for_each(
        chunks, AdvanceNodesMonitored<double, Step>{update, energies, count_, damping, dt, view.step == 0});
    constraints.apply(update.u, update.v, t_next, dt);
  }

  EmulatedDevice device_;
  Model model_ = held_box();
  Numbering numbering_ = make_numbering(model_.mesh);
  int count_ = model_.mesh.node_count();
  Slots slots_{count_};
  Buffer<int> nodes_ = upload(slots_.nodes), number_ = upload(slots_.number), begin_ = upload(slots_.begin);
  Buffer<Vec4<double>> force_ = upload(slots_.force);
};

TEST_F(CompleteNodesSweep, DoesWhatTheSeparateLoopsDo) {
  Rows u[2], v[2];
  std::vector<NodeEnergies> e[2];
  double work[2];
  for (int k = 0; k < 2; ++k) run(k == 1, u[k], v[k], e[k], work[k]);
  for (std::size_t n = 0; n < u[0].size(); ++n) {
    EXPECT_EQ(u[0][n].x, u[1][n].x);
    EXPECT_EQ(u[0][n].z, u[1][n].z);
    EXPECT_EQ(v[0][n].y, v[1][n].y);
    EXPECT_EQ(v[0][n].w, v[1][n].w);
  }
  for (std::size_t c = 0; c < e[0].size(); ++c) {
    EXPECT_EQ(e[0][c].damping, e[1][c].damping);
    EXPECT_EQ(e[0][c].kinetic, e[1][c].kinetic);
  }
  EXPECT_NE(work[0], 0);
  EXPECT_NEAR(work[0], work[1], 1e-14 * std::abs(work[0]));
}

}  // namespace
}  // namespace glisson
