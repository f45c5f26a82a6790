// The node update in packs against that of one node.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <glisson/cpu/solids/kernel_table.hpp>

namespace glisson {
namespace {

struct Nodes {
  std::vector<Vec4<float>> u, v, f;
  std::vector<NodeEnergies> energies;

  explicit Nodes(int count) : energies(static_cast<std::size_t>(count / node_energy_chunk + 1)) {
    for (int n = 0; n < count; ++n) {
      const float x = 0.01f * static_cast<float>(n);
      u.push_back({x, 2 * x, 1, 0});
      v.push_back({x, 1 - x, 0.5f * x, n % 7 == 0 ? 0.0f : 3 + x});  // some nodes have no mass
      f.push_back({2 * x, -x, 1, 0});
    }
  }
};

template <class Stepper>
void compare(const NodeKernels& kernels, const Stepper& stepper, int count, bool damped) {
  Nodes one(count), packed(count);
  auto body = [&](Nodes& nodes) {
    return AdvanceNodes<float, Stepper>{nodes.u.data(), nodes.v.data(), nodes.f.data(), stepper.rows(),
                                        count};
  };
  const int chunks = chunks_of(count, node_energy_chunk);
  const AdvanceNodesDamped<float, Stepper> damped_one{body(one), one.energies.data(), count, 5, 1e-3},
      damped_packed{body(packed), packed.energies.data(), count, 5, 1e-3};
  if (damped) {
    for (int c = 0; c < chunks; ++c) damped_one(c);
    kernels.run(damped_packed, 0, chunks / 2);
    kernels.run(damped_packed, chunks / 2, chunks);
  } else {
    for (int n = 0; n < count; ++n) body(one)(n);
    kernels.run(body(packed), 0, count / 3);
    kernels.run(body(packed), count / 3, count);
  }
  for (std::size_t n = 0; n < one.u.size(); ++n) {
    EXPECT_NEAR(packed.u[n].y, one.u[n].y, 1e-6f * (1 + std::abs(one.u[n].y)));
    EXPECT_NEAR(packed.v[n].x, one.v[n].x, 1e-6f * (1 + std::abs(one.v[n].x)));
    EXPECT_EQ(packed.v[n].w, one.v[n].w);
    EXPECT_EQ(packed.u[n].w, 0);
    EXPECT_EQ(packed.f[n].z, 0);
  }
  for (std::size_t c = 0; c < one.energies.size(); ++c)
    EXPECT_NEAR(packed.energies[c].damping, one.energies[c].damping, 1e-6 * one.energies[c].damping);
}

TEST(NodeKernels, MoveNodesAsOneAtATime) {
  const auto all = patches::instruction_sets();
  for (std::size_t i = 0; i < all.count; ++i) {
    if (!all.sets[i].available()) continue;
    const NodeKernels& kernels = node_kernels(all.sets[i].name);
    for (const int count : {1, 3, 4, 5, 16, 63, 64, 65, 200})
      for (const bool damped : {false, true}) {
        compare(kernels, CentralDifference<float>::make(5, 1e-3, 1e-3), count, damped);
        compare(kernels, Newmark<float>::make(5, 1e-3, 1e-3), count, damped);
      }
  }
}

}  // namespace
}  // namespace glisson
