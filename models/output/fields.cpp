// Views on node and element arrays, and the check that nothing unusable reaches a file.
#include <cmath>
#include <glisson/core/base/error.hpp>
#include <glisson/models/output/fields.hpp>

namespace glisson {

static_assert(sizeof(Vec3<double>) == 3 * sizeof(double) && sizeof(Sym3<double>) == 6 * sizeof(double),
              "vectors and tensors are written as plain rows of numbers");

Field field(std::string name, std::span<const double> values) { return {std::move(name), 1, values}; }

Field field(std::string name, std::span<const Vec3<double>> values) {
  return {std::move(name), 3, {reinterpret_cast<const double*>(values.data()), 3 * values.size()}};
}

Field field(std::string name, std::span<const Sym3<double>> values) {
  return {std::move(name), 6, {reinterpret_cast<const double*>(values.data()), 6 * values.size()}};
}

Snapshot Snapshot::of(const AnySimulation& simulation) {
  return {simulation.time(), simulation.displacement(), simulation.velocity(), simulation.internal_force(),
          simulation.element_fields(), simulation.shell_fields()};
}

Fields Snapshot::fields() const {
  Fields all;
  const auto add = [](std::vector<Field>& list, const char* name, const auto& values) {
    if (!values.empty()) list.push_back(field(name, std::span(values)));
  };
  add(all.point, "displacement", displacement);
  add(all.point, "velocity", velocity);
  add(all.point, "internal_force", internal_force);
  add(all.cell, "stress", elements.stress);
  add(all.cell, "strain", elements.strain);
  add(all.cell, "J", elements.J);
  return all;
}

namespace {

void require_finite(const Field& field, std::size_t count, const char* what, double largest) {
  const auto components = static_cast<std::size_t>(field.components > 0 ? field.components : 0);
  if (components == 0 || field.values.size() / components != count || field.values.size() % components != 0)
    throw Error(ErrorKind::usage, "array '" + field.name + "' has " + std::to_string(field.values.size()) +
                                      " values, which is not " + std::to_string(field.components) +
                                      " for each " + what + " (" + std::to_string(count) +
                                      "). Give one row per " + what + ".");
  for (std::size_t i = 0; i < field.values.size(); ++i) {
    const double value = field.values[i];
    if (std::abs(value) <= largest) continue;
    const char* problem = std::isnan(value) ? "not a number" : std::isinf(value) ? "infinite" : "too large";
    throw Error(
        ErrorKind::run,
        "array '" + field.name + "' is " + problem + " at " + what + " " + std::to_string(i / components) +
            " (component " + std::to_string(i % components) +
            "); no such value is written to a file. The simulation has diverged: use a smaller time step "
            "or check the loads.");
  }
}

}  // namespace

void require_finite(const Fields& fields, std::size_t node_count, std::size_t cell_count, double largest,
                    const char* cell) {
  for (const Field& f : fields.point) require_finite(f, node_count, "node", largest);
  for (const Field& f : fields.cell) require_finite(f, cell_count, cell, largest);
}

}  // namespace glisson
