// Compares a document with the grammar: unknown and repeated names, unknown values of listed attributes,
// stray text.
#include <glisson/models/format/reader.hpp>
#include <glisson/models/format/schema.hpp>
#include <glisson/models/format/suggest.hpp>

namespace glisson::detail {
namespace {

template <class Rules>
std::vector<std::string> names_of(const Rules& rules) {
  std::vector<std::string> names;
  names.reserve(rules.size());
  for (const auto& rule : rules) names.push_back(rule.name);
  return names;
}

void check_attribute(const Reader& reader, const XmlElement& element, const XmlAttribute& attribute,
                     const std::vector<AttributeRule>& allowed) {
  for (const auto& rule : allowed) {
    if (!same_name(rule.name, attribute.name)) continue;
    if (rule.values.empty()) return;
    for (const auto& value : rule.values)
      if (value == attribute.value) return;
    element.fail(attribute.line, attribute.name + "=\"" + attribute.value + "\" is not a value it can have" +
                                     suggestion(attribute.value, rule.values));
  }
  reader.complain(element, attribute.line,
                  "unknown attribute " + attribute.name + suggestion(attribute.name, names_of(allowed)));
}

const ChildRule* find_child(const std::vector<ChildRule>& rules, const XmlElement& child) {
  for (const auto& rule : rules)
    if (child.is(rule.name)) return &rule;
  return nullptr;
}

void check_element(const Reader& reader, const XmlElement& element, const ElementRule& rule) {
  if (rule.kind == not_built)
    element.fail("this feature is not supported yet; remove the element to run the rest");
  const auto attributes = attributes_of(rule);
  for (const auto& attribute : element.attributes) check_attribute(reader, element, attribute, attributes);
  if (!rule.text && element.has_text()) {
    const auto shown = element.text().substr(0, 40);
    reader.complain(element, element.line,
                    "text '" + shown + "' stands where only elements are expected; remove it");
  }
  const auto children = children_of(rule);
  for (const auto& child : element.children) {
    const auto known = find_child(children, child);
    if (known == nullptr) {
      reader.complain(
          child, child.line,
          "unknown element in <" + element.name + ">" + suggestion(child.name, names_of(children)));
      continue;
    }
    if (!known->repeatable && element.child(child.name) != &child)
      reader.complain(child, child.line,
                      "a second one in the same <" + element.name + ">; the first is at line " +
                          std::to_string(element.child(child.name)->line) + ", keep one of them");
    check_element(reader, child, rule_of(known->kind));
  }
}

}  // namespace

void check_names(const Reader& reader, const XmlElement& root) {
  if (!root.is(root_kind)) root.fail("the root element must be <Model>");
  check_element(reader, root, rule_of(root_kind));
}

}  // namespace glisson::detail
