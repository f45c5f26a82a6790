// Orders of magnitude of soft tissue in declared units: a wrong unit is the commonest mistake in a simulation
// file.
#include <glisson/core/materials/law_table.hpp>
#include <glisson/core/validation/checks.hpp>

#include <algorithm>
#include <cmath>

namespace glisson::detail {
namespace {

/// Factors to SI. mm-kg-s: force kg mm/s^2 = 1 mN, stress mN/mm^2 = 1 kPa, density kg/mm^3.
struct Units {
  double length, stress, density;
  const char *length_name, *stress_name, *density_name;
};
constexpr Units si{1, 1, 1, "m", "Pa", "kg/m^3"};
constexpr Units mm_kg_s{1e-3, 1e3, 1e9, "mm", "kPa", "kg/mm^3"};

void check_extent(const Model& model, const Units& units, Warnings& warnings) {
  double low[3], high[3];
  std::fill(low, low + 3, 1e300);
  std::fill(high, high + 3, -1e300);
  for (const auto& X : model.mesh.X) {
    const double x[3] = {X.x, X.y, X.z};
    for (int i = 0; i < 3; ++i) low[i] = std::min(low[i], x[i]), high[i] = std::max(high[i], x[i]);
  }
  const double extent = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  if (extent * units.length > 10 || extent * units.length < 1e-4)
    warnings.push_back("units=\"" + model.units + "\": the mesh is " + number_text(extent) + " " +
                       units.length_name + " long, which is " +
                       (extent * units.length > 10 ? "large" : "small") +
                       " for an organ; is it in other units? ScaleFactor converts it");
}

void check_section_units(const Section& section, const Model& model, const Units& units, Warnings& warnings) {
  const auto place =
      (section.name.empty() ? std::string("section") : section.name) + ": units=\"" + model.units + "\": ";
  const double density = section.material.density * units.density;
  if (density < 100 || density > 20000)
    warnings.push_back(place + "a density of " + number_text(section.material.density) + " " +
                       units.density_name + " is far from that of tissue (1000 kg/m^3)");
  const LawRule* law = find_law(section.material.law);
  for (std::size_t i = 0; law != nullptr && i < law->parameters.size(); ++i) {
    const auto& rule = law->parameters[i];
    const double value = section.material.parameters[i], pascal = value * units.stress;
    if (rule.modulus && value != 0 && (pascal < 10 || pascal > 1e12))
      warnings.push_back(place + std::string(rule.name) + " = " + number_text(value) + " " +
                         units.stress_name + " is far from any tissue (10 Pa to 1 TPa)");
  }
}

}  // namespace

void check_units(const Model& model, Warnings& warnings) {
  if (model.units.empty()) return;
  if (model.units != "SI" && model.units != "mm-kg-s")
    refuse("model", "the units \"" + model.units +
                        "\" are not known; use \"SI\" or \"mm-kg-s\", or leave them out for any "
                        "consistent set");
  const Units& units = model.units == "SI" ? si : mm_kg_s;
  check_extent(model, units, warnings);
  for (const auto& section : model.sections) check_section_units(section, model, units, warnings);
}

}  // namespace glisson::detail
