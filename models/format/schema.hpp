// The grammar of a simulation file as one table: which elements may stand where, with which attributes and
// values. Unknown names are found with it, suggestions come from it, and glisson.xsd is written from it.
#pragma once

#include <glisson/models/format/xml_tree.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glisson::detail {

/// One kind of element. Kinds differ from names because `Nodes` in the mesh is not `Nodes` in a constraint.
struct ElementRule {
  std::string_view kind;
  std::string_view attributes;  ///< "Name Name:value,value ..."
  std::string_view children;    ///< "Name=Kind Name=Kind* ..."; * may occur several times
  bool text = false;            ///< it may hold text
};

struct AttributeRule {
  std::string name;
  std::vector<std::string> values;  ///< empty: any
};
struct ChildRule {
  std::string name, kind;
  bool repeatable = false;
};

/// The kind of an element whose feature is not built yet; nothing inside it is looked at.
constexpr std::string_view not_built = "NotBuilt";
constexpr std::string_view root_kind = "Model";

std::span<const ElementRule> element_rules();
const ElementRule& rule_of(std::string_view kind);
std::vector<AttributeRule> attributes_of(const ElementRule& rule);
std::vector<ChildRule> children_of(const ElementRule& rule);

class Reader;
/// Throws Error(input), or warns in lenient mode, for the first unknown element, attribute, stray text or
/// repeated element.
void check_names(const Reader& reader, const XmlElement& root);

}  // namespace glisson::detail
