// The kinds of ensemble, each in a file of its own.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <glisson/core/ensemble/any_ensemble.hpp>
#include <glisson/cuda/device_group.hpp>

namespace glisson::detail {

/// Lanes are members: single precision on the CPU.
std::unique_ptr<AnyEnsemble> lane_ensemble(std::vector<Model> members, int threads,
                                           const std::string& instruction_set);

using MakeAlone = std::function<std::unique_ptr<AnySimulation>(const Model&)>;
/// Every member is a simulation of its own; they share nothing, so that `threads` of them run side by side.
std::unique_ptr<AnyEnsemble> plain_ensemble(std::vector<Model> members, int threads, MakeAlone make);

/// A GPU, or what tests put in its place.
struct GroupDevice {
  std::function<std::unique_ptr<cuda::DeviceGroup>()> open;
  std::function<std::unique_ptr<AnySimulation>(const Model&, std::unique_ptr<cuda::Device>)> make;
};
/// Members in up to `threads` groups; those of a group share launches (cuda/device_group.hpp).
std::unique_ptr<AnyEnsemble> device_ensemble(std::vector<Model> members, int threads, GroupDevice device);

}  // namespace glisson::detail
