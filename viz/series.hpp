// The snapshots of a run, read back: .pvd with one or more parts per time, or a single file.
#pragma once

#include <string>
#include <vector>

#include <glisson/models/mesh/raw_mesh.hpp>

namespace glisson::viz {

struct Step {
  double time = 0;                 ///< [s]
  std::vector<std::string> files;  ///< parts, as paths that can be opened
};

/// Of a .pvd in the order of time; a .vtu, .vtp or .vtk is one step. Throws Error(input), never returns an
/// empty list.
std::vector<Step> read_series(const std::string& path);

/// All parts of a step, their node numbers checked. Throws Error(input).
std::vector<detail::RawMesh> read_step(const Step& step);

/// Of membranes and shells the results hold the mid-surface (STEM.vtp) and the faces (STEM_faces.vtp),
/// between which it lies hidden. For each part that is a mid-surface the place of its faces, else -1.
std::vector<int> faces_of_parts(const Step& step);

/// Index of the step that the user means, negative from the end; Error(usage) when there is none.
int step_index(int wanted, std::size_t count);

/// What summary.json beside the results says; empty where it says nothing or is not there.
struct RunFacts {
  std::string units, model_file;
};
RunFacts facts_beside(const std::string& results);

}  // namespace glisson::viz
