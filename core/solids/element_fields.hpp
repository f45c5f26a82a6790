// Stress, strain and volume ratio of every element, evaluated in double on the host from a displacement: what
// outputs show.
#pragma once

#include <vector>

#include <glisson/core/model.hpp>
#include <glisson/core/result_fields.hpp>

namespace glisson {

/// u [m] in the user's order [node_count]; history as SolidForces::history gives it; dt [s] is the step over
/// which Prony terms follow the present stress (it is not stored). T4ANP and H8Full show their averaged F;
/// H8Full the mean over its points.
ElementFieldSource element_field_source(const Model& model, std::vector<Vec3<double>> u,
                                        std::vector<double> history, double dt);

}  // namespace glisson
