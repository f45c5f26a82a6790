#include <glisson/viz/colouring.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <glisson/core/base/error.hpp>
#include <glisson/models/format/suggest.hpp>

namespace glisson::viz {
namespace {

const std::vector<std::string> vector_components{"x", "y", "z"};
const std::vector<std::string> tensor_components{"11", "22", "33", "12", "23", "13"};

/// sqrt(factor dev:dev) of 11 22 33 12 23 13.
double equivalent(const double* s, double factor) {
  const double mean = (s[0] + s[1] + s[2]) / 3, a = s[0] - mean, b = s[1] - mean, c = s[2] - mean;
  return std::sqrt(factor * (a * a + b * b + c * c + 2 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5])));
}

struct Choice {
  std::string name, component;
  int index = -1;  ///< of the component; -1: the length or the equivalent value
};

const NamedArray* array_of(const detail::RawMesh& part, const std::string& name, bool& on_points) {
  const auto point = part.point_arrays.find(name), cell = part.cell_arrays.find(name);
  on_points = point != part.point_arrays.end();
  if (on_points) return &point->second;
  return cell != part.cell_arrays.end() ? &cell->second : nullptr;
}

int components_of(std::span<const detail::RawMesh> parts, const std::string& name) {
  bool on_points = false;
  for (const auto& part : parts)
    if (const NamedArray* array = array_of(part, name, on_points)) return array->components;
  return 0;
}

Choice choose(std::span<const detail::RawMesh> parts, const std::string& field) {
  const auto names = field_names(parts);
  if (names.empty()) throw Error(ErrorKind::usage, "The results hold no field that could colour them.");
  if (field.empty()) return {names.front(), ""};
  const auto colon = field.rfind(':');
  Choice choice{field, ""};
  const auto known = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  if (colon != std::string::npos && !known(field)) choice = {field.substr(0, colon), field.substr(colon + 1)};
  if (!known(choice.name)) {
    std::string list;
    for (const auto& name : names) list += (list.empty() ? "" : ", ") + name;
    const std::string near = detail::nearest(choice.name, names);
    throw Error(ErrorKind::usage, "There is no field '" + choice.name + "'" +
                                      (near.empty() ? "" : "; did you mean " + near + "?") +
                                      " The results hold: " + list + ".");
  }
  if (choice.component.empty()) return choice;
  const int count = components_of(parts, choice.name);
  const auto allowed = count == 3   ? vector_components
                       : count == 6 ? tensor_components
                                    : std::vector<std::string>{};
  const auto found = std::find(allowed.begin(), allowed.end(), choice.component);
  if (found == allowed.end())
    throw Error(ErrorKind::usage, "The field " + choice.name + " has no component '" + choice.component +
                                      "'; it has " +
                                      (count == 1   ? "only one value"
                                       : count == 3 ? "x, y and z"
                                                    : "11, 22, 33, 12, 23 and 13") +
                                      ".");
  choice.index = static_cast<int>(found - allowed.begin());
  return choice;
}

double value_at(const Choice& choice, const NamedArray& array, std::size_t row) {
  const double* v = array.values.data() + row * static_cast<std::size_t>(array.components);
  if (choice.index >= 0 && choice.index < array.components) return v[choice.index];
  if (array.components == 3) return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  if (array.components == 6)
    return equivalent(v, choice.name.find("strain") != std::string::npos ? 2. / 3 : 1.5);
  return v[0];
}

struct Unit {
  const char* name;
  double per;  ///< how many of this unit are one of the results'
};

/// Candidates from large to small, empty: no unit known.
std::vector<Unit> units_of(const std::string& name, const std::string& units) {
  const bool si = units == "SI", mm = units == "mm-kg-s";
  if (!si && !mm) return {};
  const double length = si ? 1 : 1e-3, force = si ? 1 : 1e-3, pressure = si ? 1 : 1e3;
  const auto is = [&](const char* word) { return name.find(word) != std::string::npos; };
  if (name == "displacement" || is("thickness"))
    return {{"m", length}, {"mm", 1e3 * length}, {"\u00b5m", 1e6 * length}};
  if (name == "velocity") return {{"m/s", length}, {"mm/s", 1e3 * length}, {"\u00b5m/s", 1e6 * length}};
  if (name == "membrane_force") return {{"kN/m", 1e-3}, {"N/m", 1}, {"mN/m", 1e3}};
  if (name == "moment" || is("force")) return {{"N", force}, {"mN", 1e3 * force}, {"\u00b5N", 1e6 * force}};
  if (name == "curvature") return {{"1/mm", 1e-3 / length}, {"1/m", 1 / length}};
  if (name == "energy")
    return {{"J", force * length}, {"mJ", 1e3 * force * length}, {"\u00b5J", 1e6 * force * length}};
  if (is("stress"))
    return {{"MPa", 1e-6 * pressure}, {"kPa", 1e-3 * pressure}, {"Pa", pressure}, {"mPa", 1e3 * pressure}};
  return {};
}

std::string title_of(const Choice& choice, int components) {
  std::string title = choice.name == "J" ? "J = volume now / at rest" : choice.name;
  std::replace(title.begin(), title.end(), '_', ' ');
  if (choice.index >= 0) return title + " " + choice.component;
  if (components == 6 && choice.name.find("strain") == std::string::npos) return title + ", von Mises";
  if (components == 6) return title + ", equivalent";
  return title;
}

void set_range(Colouring& c) {
  c.low = std::numeric_limits<double>::max(), c.high = std::numeric_limits<double>::lowest();
  for (const auto& part : c.parts)
    for (const double v : part.values)
      if (std::isfinite(v)) c.low = std::min(c.low, v), c.high = std::max(c.high, v);
  if (c.low > c.high) c.low = 0, c.high = 1;
}

/// The largest unit in which the largest number is at least 1.
void scale_to_unit(Colouring& c, const std::vector<Unit>& units) {
  const double largest = std::max(std::abs(c.low), std::abs(c.high));
  if (units.empty()) return;
  const auto readable = [&](const Unit& u) { return largest * u.per >= 1; };
  auto unit = std::find_if(units.begin(), units.end(), readable);
  if (unit == units.end()) unit = largest > 0 ? units.end() - 1 : units.begin();
  for (auto& part : c.parts)
    for (double& v : part.values) v *= unit->per;
  c.low *= unit->per, c.high *= unit->per;
  c.title += std::string(" [") + unit->name + "]";
}

}  // namespace

std::vector<std::string> field_names(std::span<const detail::RawMesh> parts) {
  std::set<std::string> names;
  const auto add = [&](const auto& arrays) {
    for (const auto& [name, array] : arrays)
      if (array.components == 1 || array.components == 3 || array.components == 6) names.insert(name);
  };
  for (const auto& part : parts) add(part.point_arrays), add(part.cell_arrays);
  std::vector<std::string> sorted(names.begin(), names.end());
  std::stable_partition(sorted.begin(), sorted.end(), [](const auto& n) { return n == "displacement"; });
  return sorted;
}

Colouring colour_by(std::span<const detail::RawMesh> parts, const std::string& field,
                    const std::string& units) {
  const Choice choice = choose(parts, field);
  Colouring c;
  c.title = title_of(choice, components_of(parts, choice.name));
  c.labels = choice.name == "label";
  for (const auto& part : parts) {
    Colours colours;
    const NamedArray* array = array_of(part, choice.name, colours.on_points);
    const std::size_t rows = array == nullptr || colours.on_points ? part.X.size() : part.cell_count();
    if (array == nullptr) colours.on_points = true;
    colours.values.assign(rows, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t row = 0; array != nullptr && row < rows; ++row)
      colours.values[row] = value_at(choice, *array, row);
    c.parts.push_back(std::move(colours));
  }
  set_range(c);
  scale_to_unit(c, units_of(choice.name, units));
  return c;
}

}  // namespace glisson::viz
