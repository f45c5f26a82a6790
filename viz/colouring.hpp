// Which number colours a point or a cell, and how its scale is labelled.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <glisson/models/mesh/raw_mesh.hpp>

namespace glisson::viz {

/// Arrays with 1, 3 or 6 components, sorted, displacement first.
std::vector<std::string> field_names(std::span<const detail::RawMesh> parts);

/// One value per point or cell of a part; NaN where the part does not have the field.
struct Colours {
  bool on_points = true;
  std::vector<double> values;
};

struct Colouring {
  std::string title;           ///< "displacement [mm]"
  bool labels = false;         ///< whole numbers that name regions
  double low = 0, high = 1;    ///< range over all parts, in the unit of the title
  std::vector<Colours> parts;  ///< in the unit of the title
};

/// `field`: NAME or NAME:COMPONENT. Vectors give their length; symmetric tensors of stress the von Mises
/// value sqrt(3/2 dev:dev), of strain sqrt(2/3 dev:dev). Components: x y z; 11 22 33 12 23 13. Units "SI" or
/// "mm-kg-s" are written with the prefix that gives readable numbers; other units are left out. Throws
/// Error(usage) for an unknown field or component and names what exists.
Colouring colour_by(std::span<const detail::RawMesh> parts, const std::string& field,
                    const std::string& units);

}  // namespace glisson::viz
