// From a model and a wish to a simulation: the only place that knows all backends.
#pragma once

#include <memory>
#include <string>

#include <glisson/core/any_simulation.hpp>

namespace glisson {

enum class Precision { single_precision, double_precision };

struct SimulationOptions {
  std::string device = "auto";  ///< auto, cpu, serial, emulated[:conflicts], cuda, cuda:N
  Precision precision = Precision::single_precision;
  int threads = 0;                       ///< 0: as many as the machine has
  std::string instruction_set = "auto";  ///< auto, sse4.2, avx2, avx512: for tests
  bool validated = false;                ///< the caller has called validate() on the model already
};

/// Throws Error(input) for a model that validate() refuses, Error(device) when the device asked for is not
/// there; `auto` never throws for that. The model must outlive the result.
std::unique_ptr<AnySimulation> make_simulation(const Model& model, const SimulationOptions& options = {});

/// What `auto` chooses on this machine and why: "auto chose the CPU: no CUDA device here".
std::string automatic_device_text();

}  // namespace glisson
