// A spring between the centre of mass of a body and its rest position, as a force provider of a user's own.
#pragma once

#include <vector>

#include <glisson/core/force_provider.hpp>

/// The force -k u_centre, shared out by mass, so that it moves the body without deforming it. Moving freely
/// on it, a body of mass m oscillates with the period 2 pi sqrt(m / k).
class CentreSpring : public glisson::ForceProvider<double> {
 public:
  explicit CentreSpring(double stiffness) : stiffness_(stiffness) {}

  std::string_view name() const override { return "spring at the centre of mass"; }
  void attach(const glisson::Attachment& attachment) override;
  double stable_step() const override;
  void add_forces(const glisson::StepView<double>& step) override;
  double work() const override { return work_; }

 private:
  double stiffness_;           ///< k [N/m]
  std::vector<double> share_;  ///< of each node in the mass [-]  [node_count]
  double mass_ = 0;            ///< [kg]
  double work_ = 0;            ///< [J]
};
