// What outputs show of the elements and of the shells, in double on the host.
#pragma once

#include <functional>
#include <vector>

#include <glisson/core/tensor/tensor.hpp>

namespace glisson {

/// One value per element in the user's numbering; hexahedra with 8 points give the mean over the points.
struct ElementFields {
  std::vector<Sym3<double>> stress;  ///< second Piola-Kirchhoff [Pa]
  std::vector<Sym3<double>> strain;  ///< Green-Lagrange [-]
  std::vector<double> J;             ///< det F [-]
};

/// The fields of any range of elements, evaluated when asked: those of all elements at once take more memory
/// than the simulation itself. Belongs to the state that it was asked of; the model must outlive it.
struct ElementFieldSource {
  int element_count = 0;
  std::function<ElementFields(int first, int count)> range;
};

/// One value per triangle of Mesh::triangles; all empty without shells. Tensors have the axes of space and
/// lie in the plane of the triangle at rest. Forces and moments are per length at rest.
struct ShellFields {
  std::vector<int> set;                      ///< place in Model::shells [-]
  std::vector<Sym3<double>> stress;          ///< second Piola-Kirchhoff in the mid-surface [Pa]
  std::vector<Sym3<double>> strain;          ///< Green-Lagrange of the mid-surface, thickness included [-]
  std::vector<Sym3<double>> membrane_force;  ///< stress times thickness at rest [N/m]
  std::vector<Sym3<double>> moment;          ///< work-conjugate to the curvature; 0 for membranes [N]
  std::vector<Sym3<double>> curvature;  ///< change since rest, positive towards the normal; 0 for membranes
                                        ///< [1/m]
  std::vector<double> J;                ///< volume now over volume at rest [-]
  std::vector<double> area_ratio;       ///< area now over area at rest [-]
  std::vector<double> thickness;        ///< now [m]
  std::vector<double> rest_thickness;   ///< [m]
  std::vector<double> energy;           ///< of the law and of bending, integrated over the triangle [J]

  std::size_t size() const { return set.size(); }
  void resize(std::size_t count) {
    set.resize(count);
    for (auto* tensors : {&stress, &strain, &membrane_force, &moment, &curvature}) tensors->resize(count);
    for (auto* values : {&J, &area_ratio, &thickness, &rest_thickness, &energy}) values->resize(count);
  }
};

}  // namespace glisson
