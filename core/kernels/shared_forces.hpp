// What patches leave of the force on nodes that several of them have: one part per patch, in slots. Plain
// data of a backend.
#pragma once

#include <glisson/core/tensor/tensor.hpp>

namespace glisson {

template <class R>
struct SharedForces {
  const int* number = nullptr;  ///< among the shared nodes, else -1 [node_count]; nullptr: nothing is left
  const int* begin = nullptr;   ///< first slot [shared_count + 1]
  const Vec4<R>* slot_force = nullptr;  ///< [N]  [slot_count]

  /// f with the parts of shared node s, in the order of the patches.
  GLISSON_HD Vec4<R> add(int s, const Vec4<R>& f) const {
    Vec3<R> sum{R(0), R(0), R(0)};
    for (int k = begin[s]; k < begin[s + 1]; ++k) {
      const Vec4<R> g = slot_force[k];
      sum.x = sum.x + g.x, sum.y = sum.y + g.y, sum.z = sum.z + g.z;
    }
    return {f.x + sum.x, f.y + sum.y, f.z + sum.z, f.w};
  }
  /// The same for a node, which may have none.
  GLISSON_HD Vec4<R> add_to_node(int n, const Vec4<R>& f) const {
    if (!number || number[n] < 0) return f;
    return add(number[n], f);
  }
};

}  // namespace glisson
