// Stress resultants, curvature, thickness and energy of every triangle, evaluated in double on the host from a
// displacement: what outputs show.
#pragma once

#include <span>

#include <glisson/core/model.hpp>
#include <glisson/core/result_fields.hpp>

namespace glisson::shells {

/// u [m] in the user's order [node_count]; history [Pa] of the shells alone, [section][element][term][3]; dt
/// [s] is the step over which Prony terms follow the present stress (it is not stored). A rotation-free
/// triangle shows the mean over its sides.
ShellFields shell_fields(const Model& model, std::span<const Vec3<double>> u, std::span<const double> history,
                         double dt);

}  // namespace glisson::shells
