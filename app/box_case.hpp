// Small models that bench and selftest run: a cube of tissue, held at the bottom and pushed on top.
#pragma once

#include <string>
#include <vector>

#include <glisson/core/model.hpp>

namespace glisson::app {

struct BoxCase {
  std::string name;  ///< "T4", "T4 viscoelastic", ...
  Formulation formulation = Formulation::t4;
  std::string law = "NH";
  std::vector<double> parameters{2000, 20000};
  bool viscous = false;
  double jitter = 0.1;  ///< of the nodes, in cells; 0: the boxes that meshes of voxels have
};

/// About `elements` elements in a cube of 10 cm; `steps` steps of an automatic dt fit into the run.
Model box_model(const BoxCase& c, int elements, double total_time);

}  // namespace glisson::app
