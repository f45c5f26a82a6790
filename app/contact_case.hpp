// Two blocks of tissue that touch with a twentieth of their surface, for bench.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>

#include <glisson/core/contact_report.hpp>
#include <glisson/core/model.hpp>

namespace glisson::app {

/// About `elements` tetrahedra in two equal cubes whose meshes do not match. The upper one stands on the
/// lower one with a corner, is pressed down at once by a hundredth of its height and then slides at 5 mm/s.
/// `touch`: false for the same without contact, to compare with.
Model contact_model(int elements, double total_time, bool touch);

/// Contact between deformable bodies over some steps, from the reports before and after them.
/// step: mean time of a step [s]
nlohmann::ordered_json contact_per_step(const ContactReport& before, const ContactReport& after,
                                        std::int64_t steps, double step);

}  // namespace glisson::app
