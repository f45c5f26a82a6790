// Which nodes of two glued surfaces hang together, and how. Host data, constant.
#pragma once

#include <vector>

#include <glisson/core/model.hpp>

namespace glisson::contact {

/// Constraints sum weight u(node) = 0, a row each: the mean of the gap between the surfaces around a node
/// keeps its value, weighted by a dual function of that node (Wohlmuth 2000). The weights of a row sum to 0,
/// so that its forces do. Rows are scaled by the masses: sum weight^2 / m = 1.
struct TieRows {
  std::vector<int> nodes;      ///< of the mesh that occur, rising
  std::vector<int> row_begin;  ///< [row_count + 1]
  std::vector<int> node;       ///< places in nodes
  std::vector<double> weight;  ///< [sqrt(kg)]
  /// Bounds of the eigenvalues of W M^-1 W^T, and how many Chebyshev steps shrink an error by a thousand.
  double low = 1, high = 1;
  int steps = 1;

  int row_count() const { return static_cast<int>(row_begin.size()) - 1; }
};

/// mass: of each node of the mesh [kg]. Throws Error(input) for a tie whose surfaces are nowhere near each
/// other, of a body without a surface, or of one body with itself.
TieRows tie_rows(const Model& model, const std::vector<double>& mass);

}  // namespace glisson::contact
