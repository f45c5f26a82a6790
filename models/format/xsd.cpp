// The grammar as an XML schema (W3C XML Schema 1.0) for editors. The reader takes any case; the schema has
// the usual one.
#include <glisson/models/format/read_model.hpp>
#include <glisson/models/format/schema.hpp>

#include <sstream>

namespace glisson {
namespace {

using detail::ElementRule;

void write_attribute(std::ostream& out, const detail::AttributeRule& attribute) {
  out << "    <xs:attribute name=\"" << attribute.name << "\"";
  if (attribute.values.empty()) {
    out << " type=\"xs:string\"/>\n";
    return;
  }
  out << ">\n      <xs:simpleType>\n        <xs:restriction base=\"xs:string\">\n";
  for (const auto& value : attribute.values) out << "          <xs:enumeration value=\"" << value << "\"/>\n";
  out << "        </xs:restriction>\n      </xs:simpleType>\n    </xs:attribute>\n";
}

void write_type(std::ostream& out, const ElementRule& rule) {
  out << "  <xs:complexType name=\"" << rule.kind << "\"" << (rule.text ? " mixed=\"true\"" : "") << ">\n";
  const auto children = detail::children_of(rule);
  if (!children.empty()) {
    out << "    <xs:choice minOccurs=\"0\" maxOccurs=\"unbounded\">\n";
    for (const auto& child : children)
      if (child.kind != detail::not_built)
        out << "      <xs:element name=\"" << child.name << "\" type=\"" << child.kind << "\"/>\n";
    out << "    </xs:choice>\n";
  }
  for (const auto& attribute : detail::attributes_of(rule)) write_attribute(out, attribute);
  out << "  </xs:complexType>\n";
}

}  // namespace

std::string make_xsd() {
  std::ostringstream out;
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<!-- Simulation files of Glisson; written from the table in models/format/schema.cpp, do not edit. "
         "-->\n"
         "<xs:schema xmlns:xs=\"http://www.w3.org/2001/XMLSchema\">\n"
         "  <xs:element name=\""
      << detail::root_kind << "\" type=\"" << detail::root_kind << "\"/>\n";
  for (const auto& rule : detail::element_rules())
    if (rule.kind != detail::not_built) write_type(out, rule);
  out << "</xs:schema>\n";
  return std::move(out).str();
}

}  // namespace glisson
