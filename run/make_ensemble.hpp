// From the models of an ensemble's members and a wish to an ensemble.
#pragma once

#include <memory>
#include <vector>

#include <glisson/core/ensemble/any_ensemble.hpp>
#include <glisson/run/make_simulation.hpp>

namespace glisson {

/// The members share mesh and element sets, and may differ in everything else: parameters, loads, boundary
/// values, rigid bodies, time settings. In single precision on the CPU, up to 8000 nodes, the elements of a
/// group of members are computed at once, one member per SIMD lane, and groups run on different threads. In
/// double precision members run side by side on the threads; larger meshes and serial and emulated devices
/// run them one after another. On cuda groups of members share launches. Throws Error(usage) without members,
/// Error(input) for a member with another mesh, Error(device) as make_simulation.
std::unique_ptr<AnyEnsemble> make_ensemble(std::vector<Model> members, const SimulationOptions& options = {});

}  // namespace glisson
