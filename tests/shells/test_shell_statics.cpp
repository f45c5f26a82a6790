// The solver of statics.hpp; no test of its own.
#include <tests/shells/statics.hpp>

#include <Eigen/Sparse>

namespace glisson::test {

void ShellStatics::evaluate(std::vector<Vec3<double>>& f, std::vector<MatrixEntry>& K) const {
  f.assign(u_.size(), {});
  K.clear();
  for (const auto& block : blocks_) {
    const auto slots = static_cast<std::size_t>(block.slots());
    for (std::size_t k = 0; k < block.section->elements.size(); ++k) {
      const int* nodes = block.nodes.data() + slots * k;
      std::vector<Vec3<Real>> ue(slots), fe;
      for (std::size_t a = 0; a < slots; ++a) {
        const auto& x = u_[static_cast<std::size_t>(nodes[a])];
        ue[a] = {Real(x.x), Real(x.y), Real(x.z)};
      }
      for (std::size_t a = 0; a < slots; ++a)
        for (int i = 0; i < 3; ++i) {
          Real& seed = i == 0 ? ue[a].x : i == 1 ? ue[a].y : ue[a].z;
          seed.derivative = 1;
          triangle_forces<Real>(block, k, ue, fe);
          seed.derivative = 0;
          for (std::size_t b = 0; b < slots; ++b) {
            const double row[3] = {fe[b].x.derivative, fe[b].y.derivative, fe[b].z.derivative};
            for (int j = 0; j < 3; ++j)
              if (row[j] != 0) K.push_back({3 * nodes[b] + j, 3 * nodes[a] + i, -row[j]});
          }
        }
      for (std::size_t b = 0; b < slots; ++b) {
        auto& sum = f[static_cast<std::size_t>(nodes[b])];
        sum = sum + Vec3<double>{fe[b].x.value, fe[b].y.value, fe[b].z.value};
      }
    }
  }
}

double ShellStatics::newton_step(const std::vector<Vec3<double>>& load) {
  std::vector<Vec3<double>> f;
  std::vector<MatrixEntry> all;
  std::vector<Eigen::Triplet<double>> free;
  evaluate(f, all);
  Eigen::VectorXd r = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(dofs()));
  for (std::size_t n = 0; n < u_.size(); ++n) {
    const auto sum = f[n] + load[n];
    const double row[3] = {sum.x, sum.y, sum.z};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto d = static_cast<Eigen::Index>(3 * n + i);
      if (fixed_[n][i])
        free.emplace_back(d, d, 1.0);
      else
        r(d) = row[i];
    }
  }
  const auto is_free = [&](int d) {
    return !fixed_[static_cast<std::size_t>(d / 3)][static_cast<std::size_t>(d % 3)];
  };
  for (const auto& t : all)
    if (is_free(t.row) && is_free(t.col)) free.emplace_back(t.row, t.col, t.value);
  const auto size = static_cast<Eigen::Index>(dofs());
  Eigen::SparseMatrix<double> K(size, size);
  K.setFromTriplets(free.begin(), free.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(K);
  const Eigen::VectorXd du = solver.solve(r);
  for (std::size_t n = 0; n < u_.size(); ++n) {
    const auto d = static_cast<Eigen::Index>(3 * n);
    u_[n] = u_[n] + Vec3<double>{du(d), du(d + 1), du(d + 2)};
  }
  return r.norm();
}

}  // namespace glisson::test
