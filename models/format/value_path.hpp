// Paths to single values of a simulation file: "ElementSet[2]/ElasticParams#1", "Constraint[3]/Magnitudes",
// "liver/ElasticParams#2", "TotalTime", "Constraint[1]@EndTime".
#pragma once

#include <string>
#include <string_view>

#include <glisson/models/format/xml_tree.hpp>

namespace glisson::detail {

/// A number in an element's text, or an attribute.
class ValueTarget {
 public:
  /// Throws Error(input), placed at `place`, when the path names nothing or several things; the message says
  /// what is there.
  ValueTarget(XmlElement& root, std::string_view path, const Place& place);
  /// Throws Error(input) when the text is not a finite number (attributes may be any text).
  void set(const std::string& value, const Place& place);
  bool operator==(const ValueTarget& other) const = default;

 private:
  XmlElement* element_ = nullptr;
  XmlAttribute* attribute_ = nullptr;  ///< nullptr: the text
  std::size_t number_ = 0;             ///< which token of the text, from 0
};

}  // namespace glisson::detail
