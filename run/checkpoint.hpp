// The checkpoint file of a run: the complete state of a simulation, with what tells whether it fits and is
// whole.
#pragma once

#include <cstdint>
#include <filesystem>

#include <glisson/core/any_simulation.hpp>

namespace glisson {

/// What a runner adds to the state of the simulation.
struct CheckpointExtras {
  double stepping_seconds = 0, output_seconds = 0;  ///< wall time spent before [s]
};

/// Written atomically: an older checkpoint stays until the new one is complete.
void write_checkpoint(const std::filesystem::path& path, const AnySimulation& simulation, std::uint64_t model,
                      const CheckpointExtras& extras);

/// Throws Error(input) for a damaged file, another version, model, precision or kind of device.
CheckpointExtras read_checkpoint(const std::filesystem::path& path, AnySimulation& simulation,
                                 std::uint64_t model);

}  // namespace glisson
