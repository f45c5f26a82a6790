#include <glisson/contact/shell_thickness.hpp>

namespace glisson::contact {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

std::vector<double> half_thicknesses(const Model& model) {
  std::vector<double> half(model.mesh.triangles.size(), 0.0);
  for (const ShellSection& section : model.shells)
    for (std::size_t k = 0; k < section.elements.size(); ++k)
      half[at(section.elements[k])] = 0.5 * section.thickness_of(k);
  return half;
}

std::vector<double> half_thickness_at_nodes(const Model& model) {
  const auto half = half_thicknesses(model);
  std::vector<double> sum(model.mesh.X.size(), 0.0), count(sum);
  for (std::size_t t = 0; t < half.size(); ++t)
    for (const int n : model.mesh.triangles[t]) {
      sum[at(n)] += half[t];
      ++count[at(n)];
    }
  for (std::size_t n = 0; n < sum.size(); ++n)
    if (count[n] > 0) sum[n] /= count[n];
  return sum;
}

}  // namespace glisson::contact
