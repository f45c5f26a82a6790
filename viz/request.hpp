// What a picture or a window shall show, as the command line says it.
#pragma once

#include <optional>
#include <span>
#include <string>

#include <glisson/core/tensor/tensor.hpp>

namespace glisson::viz {

/// "x=0.12" [m], "y=50%" (of the bounding box) or "nx,ny,nz@px,py,pz" (normal and a point).
struct Cut {
  Vec3<double> normal;          ///< unit
  Vec3<double> point;           ///< on the plane [m]
  std::optional<double> share;  ///< of the bounding box along the normal, instead of the point [-]
};

struct Request {
  bool window = false;          ///< a window instead of a file
  std::string results, output;  ///< .pvd, .vtu, .vtp or .vtk; .png
  std::string field;            ///< NAME or NAME:COMPONENT; empty: displacement, else the first one
  std::string model;            ///< simulation file; empty: the one that summary.json names
  std::optional<Cut> cut;
  int step = -1;                      ///< index of the snapshot; negative: from the end
  double scale = 1;                   ///< of the displacements [-]
  Vec3<double> eye{0.45, -0.8, 0.4};  ///< unit, from the model to the eye
  int width = 1200, height = 900;     ///< [pixels]
  bool undeformed = false, edges = false, loads = false;
  double seconds = 0;  ///< the window closes after this time [s]; 0: when the user closes it
};

/// From "picture" or "view", the results and "--name=value". Throws Error(usage), which says what is allowed.
Request request_of(std::span<const std::string> arguments);

}  // namespace glisson::viz
