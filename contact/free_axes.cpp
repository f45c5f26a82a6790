#include <glisson/contact/free_axes.hpp>

#include <cmath>

#include <glisson/core/constraints/constraint_list.hpp>
#include <glisson/core/loads/node_list.hpp>

namespace glisson::contact {

std::vector<int> free_axes_of(const std::vector<int>& nodes, const Model& model, const Numbering& numbering) {
  const ConstraintList list = make_constraint_list(model, numbering);
  std::vector<unsigned> held(model.mesh.X.size(), 0u);  // by internal node
  for (int i = 0; i < list.count(); ++i) {
    const auto entry = static_cast<std::size_t>(i);
    unsigned& its = held[static_cast<std::size_t>(list.nodes[entry])];
    its = list.axes[entry];
    for (int k = list.plane_begin[entry]; k < list.plane_begin[entry + 1]; ++k) {
      const Vec3<double>& n = list.planes[static_cast<std::size_t>(k)].normal;
      const double along[] = {std::abs(n.x), std::abs(n.y), std::abs(n.z)};
      for (unsigned axis = 0; axis < 3; ++axis)
        if (along[axis] > 1 - 1e-9) its |= 1u << axis;
    }
  }
  std::vector<int> free;
  for (const int n : nodes)
    free.push_back(
        static_cast<int>(all_axes & ~held[static_cast<std::size_t>(detail::internal_node(numbering, n))]));
  return free;
}

}  // namespace glisson::contact
