// Arrays on nodes and elements as they go into a file: views on somebody else's numbers, with a name.
#pragma once

#include <functional>
#include <glisson/core/any_simulation.hpp>
#include <span>
#include <string>
#include <vector>

namespace glisson {

/// A view; what it looks at must live until the file is written.
struct Field {
  std::string name;
  int components = 1;
  std::span<const double> values;  ///< [-]  [count][components]
  bool whole = false;              ///< numbers of things: written as Int32
  /// Instead of values, for arrays that are better not held: fills out with rows first ... first + count - 1.
  std::function<void(std::size_t first, std::size_t count, double* out)> rows = {};
  std::size_t row_count = 0;  ///< of rows

  std::size_t value_count() const {
    return rows ? row_count * static_cast<std::size_t>(components) : values.size();
  }
  /// use(values) for all values in order, in pieces.
  void for_each_piece(const std::function<void(std::span<const double>)>& use) const;
};

Field field(std::string name, std::span<const double> values);        ///< 1 component
Field field(std::string name, std::span<const Vec3<double>> values);  ///< 3 components: x y z
Field field(std::string name, std::span<const Sym3<double>> values);  ///< 6 components: 11 22 33 12 23 13

struct Fields {
  std::vector<Field> point;  ///< per node
  std::vector<Field> cell;   ///< per element
};

/// One state of a simulation, copied to the host. The model must outlive it.
struct Snapshot {
  double time = 0;                           ///< [s]
  std::vector<Vec3<double>> displacement;    ///< [m]    [node_count]
  std::vector<Vec3<double>> velocity;        ///< [m/s]  [node_count]
  std::vector<Vec3<double>> internal_force;  ///< [N]    [node_count]
  ElementFields elements;                    ///< [element_count] each, or empty and instead:
  ElementFieldSource element_source;         ///< asked piece by piece while a file is written
  ShellFields shells;                        ///< [triangle_count] each, or empty
  std::vector<Vec3<double>> contact_force;   ///< of all contact [N]  [node_count], empty without contact
  std::vector<double> contact_pressure;      ///< see nodal_pressure [Pa]  [node_count], or empty

  static Snapshot of(const AnySimulation& simulation);
  /// stress, strain, J.
  std::vector<Field> element_fields() const;
  /// displacement, velocity, internal_force and those of contact on nodes; stress, strain, J on elements.
  /// Empty arrays are left out.
  Fields fields() const;
};

/// Throws Error(run) for the first value that is not finite, naming array and node or element, and
/// Error(usage) for a size that does not fit. `largest` is the largest value that the file's number type
/// holds; `cell` is what the message calls an element.
void require_finite(const Fields& fields, std::size_t node_count, std::size_t cell_count, double largest,
                    const char* cell = "element");

}  // namespace glisson
