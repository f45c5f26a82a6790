// validate(): everything that must hold before the first step, in the order in which one check relies on
// another.
#include <glisson/core/validation/checks.hpp>

namespace glisson {

std::vector<std::string> validate(const Model& model) {
  detail::Warnings warnings;
  detail::check_mesh_arrays(model.mesh);
  const auto formulation = detail::check_sections(model, warnings);
  detail::check_elements(model.mesh, formulation, warnings);
  detail::check_shells(model, warnings);
  detail::check_nodes(model, warnings);
  detail::check_loads(model, warnings);
  detail::check_rigid_surfaces(model);
  detail::check_deformable_contact(model, warnings);
  detail::check_time(model, warnings);
  detail::check_units(model, warnings);
  return warnings;
}

}  // namespace glisson
