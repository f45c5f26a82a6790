// Views on node and element arrays, and the check that nothing unusable reaches a file.
#include <algorithm>
#include <cmath>
#include <cstring>
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
  return {simulation.time(),
          simulation.displacement(),
          simulation.velocity(),
          simulation.internal_force(),
          {},
          simulation.element_field_source(),
          simulation.shell_fields(),
          simulation.contact_force(),
          {}};
}

void Field::for_each_piece(const std::function<void(std::span<const double>)>& use) const {
  if (!rows) return use(values);
  constexpr std::size_t piece = 1 << 14;  // rows
  const auto width = static_cast<std::size_t>(components);
  std::vector<double> some(std::min(piece, row_count) * width);
  for (std::size_t first = 0; first < row_count; first += piece) {
    const std::size_t count = std::min(piece, row_count - first);
    rows(first, count, some.data());
    use({some.data(), count * width});
  }
}

std::vector<Field> Snapshot::element_fields() const {
  std::vector<Field> list;
  if (!element_source.range) {
    if (!elements.stress.empty()) list.push_back(field("stress", std::span(elements.stress)));
    if (!elements.strain.empty()) list.push_back(field("strain", std::span(elements.strain)));
    if (!elements.J.empty()) list.push_back(field("J", std::span(elements.J)));
    return list;
  }
  const auto add = [&](const char* name, const auto member, int components) {
    Field& f = list.emplace_back();
    f.name = name;
    f.components = components;
    f.row_count = static_cast<std::size_t>(element_source.element_count);
    f.rows = [range = element_source.range, member](std::size_t first, std::size_t count, double* out) {
      const ElementFields some = range(static_cast<int>(first), static_cast<int>(count));
      const auto& values = some.*member;
      std::memcpy(out, values.data(), values.size() * sizeof(values[0]));
    };
  };
  add("stress", &ElementFields::stress, 6);
  add("strain", &ElementFields::strain, 6);
  add("J", &ElementFields::J, 1);
  return list;
}

Fields Snapshot::fields() const {
  Fields all;
  const auto add = [](std::vector<Field>& list, const char* name, const auto& values) {
    if (!values.empty()) list.push_back(field(name, std::span(values)));
  };
  add(all.point, "displacement", displacement);
  add(all.point, "velocity", velocity);
  add(all.point, "internal_force", internal_force);
  add(all.point, "contact_force", contact_force);
  add(all.point, "contact_pressure", contact_pressure);
  for (Field& f : element_fields()) all.cell.push_back(std::move(f));
  return all;
}

namespace {

void require_finite(const Field& field, std::size_t i, double value, const char* what, double largest) {
  if (std::abs(value) <= largest) return;
  const auto components = static_cast<std::size_t>(field.components);
  const char* problem = std::isnan(value) ? "not a number" : std::isinf(value) ? "infinite" : "too large";
  throw Error(
      ErrorKind::run,
      "array '" + field.name + "' is " + problem + " at " + what + " " + std::to_string(i / components) +
          " (component " + std::to_string(i % components) +
          "); no such value is written to a file. The simulation has diverged: use a smaller time step "
          "or check the loads.");
}

void require_finite(const Field& field, std::size_t count, const char* what, double largest) {
  const auto components = static_cast<std::size_t>(field.components > 0 ? field.components : 0);
  const std::size_t values = field.value_count();
  if (components == 0 || values / components != count || values % components != 0)
    throw Error(ErrorKind::usage, "array '" + field.name + "' has " + std::to_string(values) +
                                      " values, which is not " + std::to_string(field.components) +
                                      " for each " + what + " (" + std::to_string(count) +
                                      "). Give one row per " + what + ".");
  std::size_t i = 0;
  field.for_each_piece([&](std::span<const double> piece) {
    for (const double value : piece) require_finite(field, i++, value, what, largest);
  });
}
}  // namespace

void require_finite(const Fields& fields, std::size_t node_count, std::size_t cell_count, double largest,
                    const char* cell) {
  for (const Field& f : fields.point) require_finite(f, node_count, "node", largest);
  for (const Field& f : fields.cell) require_finite(f, cell_count, cell, largest);
}

}  // namespace glisson
