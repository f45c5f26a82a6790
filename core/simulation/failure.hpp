// Why a run failed, in one sentence that names node, element and step.
#pragma once

#include <span>
#include <string>

#include <glisson/core/any_simulation.hpp>

namespace glisson {

struct FailureContext {
  std::span<const Vec3<double>> u;        ///< now, user's numbering [m]
  std::span<const Vec3<double>> healthy;  ///< at the last check that passed [m]; may be empty
  std::int64_t step = 0, healthy_step = 0;
  double time = 0;
  StepReport report;
  double stable_now = 0;  ///< estimate of the stable step for `healthy` [s]; 0: not known
};

/// "element 17 (T4, NH)": with formulation and law.
std::string element_text(const Model& model, int element);
/// "shell triangle 17 (membrane, NeoHookean)".
std::string triangle_text(const Model& model, int triangle);
std::string not_finite_message(const Model& model, const FailureContext& context);
std::string imbalance_message(const Model& model, const FailureContext& context, const Energies& energies,
                              double share, double tolerance);

}  // namespace glisson
