#include <glisson/core/simulation/energy_monitor.hpp>

#include <algorithm>
#include <cmath>

namespace glisson {

double largest_term(const Energies& e) {
  double largest = 0;
  for (const double term :
       {e.kinetic, e.strain, e.hourglass, e.damping, e.external, e.prescribed, e.contact, e.initial})
    largest = std::max(largest, std::abs(term));
  return largest;
}

double relative_imbalance(const Energies& energies, double largest) {
  const double imbalance = std::abs(energies.imbalance());
  if (!std::isfinite(imbalance)) return imbalance;
  return largest > 0 ? imbalance / largest : 0;
}

}  // namespace glisson
