#include "centre_spring.hpp"

#include <cmath>
#include <numeric>

void CentreSpring::attach(const glisson::Attachment& attachment) {
  mass_ = std::accumulate(attachment.mass.begin(), attachment.mass.end(), 0.0);
  share_.clear();
  for (const double mass : attachment.mass) share_.push_back(mass / mass_);
}

// Central difference is stable up to 2 / omega.
double CentreSpring::stable_step() const { return 2 * std::sqrt(mass_ / stiffness_); }

void CentreSpring::add_forces(const glisson::StepView<double>& step) {
  double x = 0, y = 0, z = 0;
  for (int n = 0; n < step.node_count; ++n) {
    const double share = share_[static_cast<std::size_t>(n)];
    x += share * step.u[n].x;
    y += share * step.u[n].y;
    z += share * step.u[n].z;
  }
  for (int n = 0; n < step.node_count; ++n) {
    const double k = stiffness_ * share_[static_cast<std::size_t>(n)];
    step.f[n].x -= k * x;
    step.f[n].y -= k * y;
    step.f[n].z -= k * z;
  }
  work_ = -stiffness_ / 2 * (x * x + y * y + z * z);
}
