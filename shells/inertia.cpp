#include <glisson/shells/inertia.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include <glisson/core/mesh/triangles.hpp>
#include <glisson/core/numbers/dual.hpp>
#include <glisson/shells/laws/laws.hpp>
#include <glisson/shells/shell_blocks.hpp>

namespace glisson::shells {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// dS/dE of the law at rest, E11 E22 2 E12, on the side of tension, where fibres work.
Eigen::Matrix3d rest_stiffness(const ShellSection& section) {
  Eigen::Matrix3d D = Eigen::Matrix3d::Zero();
  using Number = Dual<double>;
  for_each_type(MembraneLaws<Number>{}, [&]<class L>() {
    if (section.law != L::name) return;
    std::vector<Number> parameters;
    for (const double p : section.parameters) parameters.emplace_back(p);
    const L law = L::load(parameters.data());
    for (int k = 0; k < 3; ++k) {
      constexpr double tension = 1e-12;
      const Number dx(tension, k == 0 ? 2.0 : 0.0), dy(tension, k == 1 ? 2.0 : 0.0),
          dxy(0, k == 2 ? 1.0 : 0.0);
      const auto S = law.second_pk({dx, dy, dxy});
      D.col(k) << S.xx.derivative, S.yy.derivative, S.xy.derivative;
    }
  });
  return 0.5 * (D + D.transpose());
}

/// The forces of unit stresses and moments are the columns of -B^T; K = B^T D B has the nonzero spectrum of
/// D B B^T, here with the masses in between.
template <int slots>
double largest_eigenvalue(const Eigen::MatrixXd& D, const Eigen::MatrixXd& forces,
                          const double (&mass)[slots]) {
  Eigen::MatrixXd scaled = forces;
  for (int a = 0; a < slots; ++a) scaled.middleRows(Eigen::Index{3} * a, 3) /= std::sqrt(mass[a]);
  const Eigen::MatrixXd G = scaled.transpose() * scaled;
  const Eigen::MatrixXd L = D.llt().matrixL();
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(L.transpose() * G * L, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

struct Built {
  std::vector<HostShells> blocks;
  std::vector<double> mass;  ///< of each triangle [kg]
};

Built build(const Model& model) {
  Built built{make_shell_blocks(model), std::vector<double>(model.mesh.triangles.size(), 0.0)};
  for (const ShellSection& section : model.shells)
    for (std::size_t k = 0; k < section.elements.size(); ++k) {
      const int e = section.elements[k];
      built.mass[at(e)] = section.density_of(k) * section.thickness_of(k) *
                          triangle_area(model.mesh.triangles[at(e)], model.mesh.X);
    }
  return built;
}

/// Of the gradients of the three shape functions.
double squares(const double (&g)[2][2]) {
  double sum = 0;
  for (int k = 0; k < 2; ++k) {
    const double third = g[0][k] + g[1][k];
    sum += g[0][k] * g[0][k] + g[1][k] * g[1][k] + third * third;
  }
  return sum;
}

TriangleStep membrane_step(const Membrane::Constants<double>& c, const Eigen::Matrix3d& D, double mass) {
  Eigen::MatrixXd forces(9, 3);
  const SurfaceGradient<double> rest{};
  for (int k = 0; k < 3; ++k) {
    Vec3<double> f[3]{};
    const double unit_stress = 1 / c.volume;
    Membrane::forces_of(
        c, rest, {k == 0 ? unit_stress : 0., k == 1 ? unit_stress : 0., k == 2 ? unit_stress : 0.}, f);
    for (int a = 0; a < 3; ++a) forces.block<3, 1>(Eigen::Index{3} * a, k) << f[a].x, f[a].y, f[a].z;
  }
  const double third[3] = {mass / 3, mass / 3, mass / 3};
  return {2 / std::sqrt(largest_eigenvalue(c.volume * D, forces, third)), 1 / std::sqrt(squares(c.point.g))};
}

/// Mass at the slots of a patch: a quarter of each of its triangles, in thirds to their nodes.
void patch_mass(const Model& model, const HostShells& block, std::size_t k, const std::vector<double>& mass,
                double (&slot_mass)[6]) {
  std::fill(std::begin(slot_mass), std::end(slot_mass), 0.0);
  const int* nodes = block.nodes.data() + 6 * k;
  for (std::size_t p = 0; p < 4; ++p) {
    const int t = block.patch[4 * k + p];
    if (t < 0) continue;
    for (const int n : model.mesh.triangles[at(t)]) {
      const auto slot = std::find(nodes, nodes + 6, n) - nodes;
      if (slot < 6) slot_mass[slot] += mass[at(t)] / 12;
    }
  }
}

TriangleStep shell_step(const RotationFree::Constants<double>& c, const Eigen::Matrix3d& D,
                        const double (&slot_mass)[6], const int* nodes) {
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(6, 6);
  stiffness.topLeftCorner<3, 3>() = c.volume * D;
  const double b = std::max(c.bending, 1e-30 * c.volume * D(0, 0));
  stiffness.bottomRightCorner<3, 3>() << b, b * c.nu, 0, b * c.nu, b, 0, 0, 0, 0.5 * b * (1 - c.nu);
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(18, 6);
  const Vec3<double> zero[6] = {};
  const auto rest = RotationFree::state(c, zero);
  double mass[6];
  for (int k = 0; k < 6; ++k) {
    const auto is = [k](int i) { return k == i ? 1.0 : 0.0; };
    Vec3<double> f[6];
    RotationFree::forces_of(c, rest, {is(0) / c.volume, is(1) / c.volume, is(2) / c.volume},
                            {is(3), is(4), is(5)}, f);
    for (int a = 0; a < 6; ++a) {
      const auto slot = std::find(nodes, nodes + a, nodes[a]) - nodes;  // an image pushes the node it follows
      forces.block<3, 1>(3 * slot, k) += Eigen::Vector3d(f[a].x, f[a].y, f[a].z);
    }
  }
  for (int a = 0; a < 6; ++a)
    mass[a] = slot_mass[a] > 0 ? slot_mass[a] : 1;  // slots that repeat a node hold nothing
  return {2 / std::sqrt(largest_eigenvalue(stiffness, forces, mass)), 0.5 / std::sqrt(c.inverse_double_area)};
}

/// visit(section, element of the section, step)
template <class Visit>
void visit_steps(const Model& model, const Built& built, const Visit& visit) {
  for (const HostShells& block : built.blocks) {
    const Eigen::Matrix3d D = rest_stiffness(*block.section);
    for (std::size_t k = 0; k < block.section->elements.size(); ++k) {
      const int e = block.section->elements[k];
      if (!block.bends()) {
        visit(block, k, membrane_step(block.membranes[k], D, built.mass[at(e)]));
        continue;
      }
      double slot_mass[6];
      patch_mass(model, block, k, built.mass, slot_mass);
      visit(block, k, shell_step(block.shells[k], D, slot_mass, block.nodes.data() + 6 * k));
    }
  }
}

/// The step that every triangle is brought to; 0: none.
double wanted_step(const Model& model, const InertialMass& inertia, const std::vector<double>& steps) {
  if (!model.time.quasi_static) return model.time.mass_scaling_step.value_or(0);
  if (std::isfinite(inertia.step.dt)) return inertia.step.dt;  // all solids have it
  return steps.empty() ? 0 : *std::max_element(steps.begin(), steps.end());
}

}  // namespace

std::vector<TriangleStep> triangle_steps(const Model& model) {
  std::vector<TriangleStep> steps;
  visit_steps(model, build(model),
              [&](const HostShells&, std::size_t, const TriangleStep& s) { steps.push_back(s); });
  return steps;
}

void add_inertia(const Model& model, InertialMass& inertia) {
  if (model.shells.empty()) return;
  const Built built = build(model);
  std::vector<double> steps, factor(built.mass.size(), 1.0);
  visit_steps(model, built, [&](const HostShells&, std::size_t, const TriangleStep& s) {
    steps.push_back(s.dt);
    inertia.step.smallest_size = std::min(inertia.step.smallest_size, s.size);
  });
  const double wanted = wanted_step(model, inertia, steps);
  std::size_t i = 0;
  for (const HostShells& block : built.blocks)
    for (std::size_t k = 0; k < block.section->elements.size(); ++k, ++i) {
      const double wish = steps[i] < wanted ? (wanted / steps[i]) * (wanted / steps[i]) : 1;
      for (std::size_t p = 0; p < 4; ++p)
        if (const int t = block.patch[4 * k + p]; t >= 0) factor[at(t)] = std::max(factor[at(t)], wish);
      if (const double dt = std::max(steps[i], wanted); dt < inertia.step.dt)
        inertia.step = {dt, -1, block.section->elements[k], inertia.step.smallest_size};
    }
  double before = 0, total = 0;
  for (const double m : inertia.mass) before += m;
  const double solid = before / (1 + inertia.added_share);
  double shell = 0;
  for (std::size_t t = 0; t < built.mass.size(); ++t) {
    shell += built.mass[t];
    for (const int n : model.mesh.triangles[t]) inertia.mass[at(n)] += factor[t] * built.mass[t] / 3;
    total += factor[t] * built.mass[t];
  }
  inertia.added_share = solid + shell > 0 ? (before + total) / (solid + shell) - 1 : 0;
}

}  // namespace glisson::shells
