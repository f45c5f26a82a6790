// The sum of energies per element that kernels have left in a backend's memory.
#pragma once

#include <vector>

#include <glisson/core/backend.hpp>

namespace glisson {

/// Sums in the order of the elements. Energies of a device are copied into memory that is kept: with a
/// strain-energy cap on springs they are wanted in every step.
template <Backend B>
class EnergySum {
 public:
  double operator()(B& backend, const Buffer<double>& energies, std::size_t count) {
    const double* energy = energies.get();
    if constexpr (B::space == Space::device) {
      on_host_.resize(count);
      backend.copy_out(energy, on_host_.data(), count);
      energy = on_host_.data();
    }
    double sum = 0;
    for (std::size_t e = 0; e < count; ++e) sum += energy[e];
    return sum;
  }

 private:
  std::vector<double> on_host_;  ///< [J]  [count]
};

}  // namespace glisson
