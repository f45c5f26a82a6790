#include <glisson/models/format/xml_tree.hpp>

#include <tinyxml2.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace glisson::detail {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

XmlElement copy(const tinyxml2::XMLElement& from, const std::string* file) {
  XmlElement to;
  to.name = from.Name();
  to.line = from.GetLineNum();
  to.file = file;
  for (auto a = from.FirstAttribute(); a != nullptr; a = a->Next()) {
    if (to.attribute(a->Name()) != nullptr)
      to.fail(a->GetLineNum(),
              std::string("attribute ") + a->Name() + " is given twice (names compare without case)");
    to.attributes.push_back({a->Name(), a->Value(), a->GetLineNum()});
  }
  for (auto node = from.FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (const auto element = node->ToElement()) to.children.push_back(copy(*element, file));
    if (const auto text = node->ToText()) to.texts.push_back({text->Value(), text->GetLineNum()});
  }
  return to;
}

const char* reason_of(tinyxml2::XMLError error) {
  switch (error) {
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      return "the document is empty";
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return "an element is closed by another name than it was opened with";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return "an attribute is not of the form name=\"value\" or is given twice";
    case tinyxml2::XML_ERROR_PARSING_ELEMENT:
      return "an element is not well formed";
    case tinyxml2::XML_ERROR_PARSING_TEXT:
      return "a text is not ended by an element: an end tag is missing";
    case tinyxml2::XML_ERROR_PARSING_COMMENT:
      return "a comment is not ended by -->";
    case tinyxml2::XML_ERROR_PARSING_CDATA:
      return "a CDATA section is not ended by ]]>";
    case tinyxml2::XML_ERROR_PARSING_DECLARATION:
      return "a declaration is misplaced or not ended by ?>";
    case tinyxml2::XML_ERROR_PARSING_UNKNOWN:
      return "a <! section is not ended by >";
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return "elements are nested too deeply (more than 100)";
    default:
      return "a tag is open or misplaced (is an end tag missing?)";
  }
}

std::string_view trimmed(std::string_view text) {
  const auto first = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  text.remove_prefix(first);
  return text.substr(0, text.find_last_not_of(" \t\r\n") + 1);
}

std::string_view shown(std::string_view token) { return token.substr(0, 40); }

}  // namespace

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](char c) { return lower(c); });
  return result;
}

bool same_name(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

std::optional<double> to_number(std::string_view token) {
  if (token.size() > 1 && token[0] == '+' && token[1] != '-') token.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (error != std::errc() || end != token.data() + token.size() || !std::isfinite(value)) return {};
  return value;
}

std::optional<std::int64_t> to_integer(std::string_view token) {
  if (token.size() > 1 && token[0] == '+' && token[1] != '-') token.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (error != std::errc() || end != token.data() + token.size()) return {};
  return value;
}

bool XmlElement::is(std::string_view wanted) const { return same_name(name, wanted); }

const XmlAttribute* XmlElement::attribute(std::string_view wanted) const {
  for (const auto& a : attributes)
    if (same_name(a.name, wanted)) return &a;
  return nullptr;
}

const XmlElement* XmlElement::child(std::string_view wanted) const {
  for (const auto& c : children)
    if (c.is(wanted)) return &c;
  return nullptr;
}

std::vector<const XmlElement*> XmlElement::all(std::string_view wanted) const {
  std::vector<const XmlElement*> found;
  for (const auto& c : children)
    if (c.is(wanted)) found.push_back(&c);
  return found;
}

const std::string& XmlElement::required_attribute(std::string_view wanted) const {
  const auto found = attribute(wanted);
  if (found == nullptr)
    fail("the attribute " + std::string(wanted) + " is missing; add " + std::string(wanted) + "=\"...\"");
  return found->value;
}

const XmlElement& XmlElement::required_child(std::string_view wanted) const {
  const auto found = child(wanted);
  if (found == nullptr) fail("the element <" + std::string(wanted) + "> is missing inside it; add it");
  return *found;
}

bool XmlElement::has_text() const {
  for (const auto& chunk : texts)
    if (chunk.text.find_first_not_of(" \t\r\n\f\v") != std::string::npos) return true;
  return false;
}

std::string XmlElement::text() const {
  std::string joined;
  for (const auto& chunk : texts) {
    const auto first = chunk.text.find_first_not_of(" \t\r\n\f\v");
    if (first == std::string::npos) continue;
    const auto last = chunk.text.find_last_not_of(" \t\r\n\f\v");
    if (!joined.empty()) joined += ' ';
    joined.append(chunk.text, first, last - first + 1);
  }
  return joined;
}

std::string XmlElement::required_text() const {
  auto joined = text();
  if (joined.empty()) fail("it is empty where a value is needed; write the value between its tags");
  return joined;
}

std::vector<double> XmlElement::numbers() const {
  std::vector<double> values;
  for (const auto& chunk : texts)
    for_each_token(chunk, [&](std::string_view token, int at_line) {
      const auto value = to_number(token);
      if (!value)
        fail(at_line,
             "'" + std::string(shown(token)) + "' is not a finite number; write numbers separated by blanks");
      values.push_back(*value);
    });
  return values;
}

std::vector<double> XmlElement::numbers(std::size_t count) const {
  auto values = numbers();
  if (values.size() != count)
    fail("it holds " + std::to_string(values.size()) + " numbers where " + std::to_string(count) +
         " are needed");
  return values;
}

std::vector<int> XmlElement::integers() const {
  std::vector<int> values;
  for (const auto& chunk : texts)
    for_each_token(chunk, [&](std::string_view token, int at_line) {
      const auto value = to_integer(token);
      if (!value || *value > std::numeric_limits<int>::max() || *value < std::numeric_limits<int>::min())
        fail(at_line,
             "'" + std::string(shown(token)) + "' is not a whole number; write numbers separated by blanks");
      values.push_back(static_cast<int>(*value));
    });
  return values;
}

std::int64_t XmlElement::integer() const {
  const auto value = to_integer(required_text());
  if (!value) fail("'" + std::string(shown(text())) + "' is not a whole number");
  return *value;
}

std::optional<double> XmlElement::number_attribute(std::string_view wanted) const {
  const auto found = attribute(wanted);
  if (found == nullptr) return {};
  const auto value = to_number(trimmed(found->value));
  if (!value)
    fail(found->line, found->name + "=\"" + std::string(shown(found->value)) + "\" is not a finite number");
  return value;
}

std::optional<int> XmlElement::integer_attribute(std::string_view wanted) const {
  const auto found = attribute(wanted);
  if (found == nullptr) return {};
  const auto value = to_integer(trimmed(found->value));
  if (!value || *value > std::numeric_limits<int>::max() || *value < std::numeric_limits<int>::min())
    fail(found->line, found->name + "=\"" + std::string(shown(found->value)) + "\" is not a whole number");
  return static_cast<int>(*value);
}

void parse_xml(std::string_view xml, const std::string& file, XmlDocument& document) {
  document.file = file;
  if (xml.find('\0') != std::string_view::npos)
    throw Error(ErrorKind::input, "the file holds a zero byte, so it is not a text file in XML",
                {file, 0, ""});
  tinyxml2::XMLDocument tree;
  if (tree.Parse(xml.data(), xml.size()) != tinyxml2::XML_SUCCESS)
    throw Error(ErrorKind::input, std::string("this is not well-formed XML: ") + reason_of(tree.ErrorID()),
                {file, tree.ErrorLineNum(), ""});
  const auto root = tree.RootElement();
  if (root == nullptr)
    throw Error(ErrorKind::input, "the document has no element; a <Model> is needed", {file, 0, ""});
  if (const auto next = root->NextSiblingElement())
    throw Error(ErrorKind::input, "there is a second root element; put everything inside one <Model>",
                {file, next->GetLineNum(), std::string("<") + next->Name() + ">"});
  document.root = copy(*root, &document.file);
}

}  // namespace glisson::detail
