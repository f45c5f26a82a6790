// The XML document as a plain tree with line numbers, and the conversion of its text to numbers.
// Names compare without case; an element's text is all of its text chunks, so a comment never glues two
// numbers.
#pragma once

#include <glisson/core/base/error.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glisson::detail {

struct XmlAttribute {
  std::string name, value;
  int line = 0;
};

struct XmlText {
  std::string text;
  int line = 0;  ///< of its first character that is not blank
};

class XmlElement {
 public:
  std::string name;
  int line = 0;
  const std::string* file = nullptr;  ///< for messages; lives in the XmlDocument
  std::vector<XmlAttribute> attributes;
  std::vector<XmlText> texts;
  std::vector<XmlElement> children;

  const XmlAttribute* attribute(std::string_view wanted) const;  ///< nullptr when absent
  const XmlElement* child(std::string_view wanted) const;        ///< the first; nullptr when absent
  std::vector<const XmlElement*> all(std::string_view wanted) const;
  /// Throw Error(input) when absent.
  const std::string& required_attribute(std::string_view wanted) const;
  const XmlElement& required_child(std::string_view wanted) const;

  bool is(std::string_view wanted) const;
  bool has_text() const;
  /// All chunks joined with blanks, trimmed.
  std::string text() const;
  /// The same, and an error when there is none.
  std::string required_text() const;

  /// Every token of the text as a finite number.
  std::vector<double> numbers() const;
  std::vector<double> numbers(std::size_t count) const;  ///< an error unless there are exactly `count`
  double number() const { return numbers(1)[0]; }
  std::vector<int> integers() const;
  std::int64_t integer() const;

  std::optional<double> number_attribute(std::string_view wanted) const;
  std::optional<int> integer_attribute(std::string_view wanted) const;

  Place place() const { return {*file, line, "<" + name + ">"}; }
  Place place(int at_line) const { return {*file, at_line, "<" + name + ">"}; }
  [[noreturn]] void fail(const std::string& message) const {
    throw Error(ErrorKind::input, message, place());
  }
  [[noreturn]] void fail(int at_line, const std::string& message) const {
    throw Error(ErrorKind::input, message, place(at_line));
  }
};

struct XmlDocument {
  std::string file;
  XmlElement root;  ///< its elements point to `file`, so a document stays where it was made
  XmlDocument() = default;
  XmlDocument(const XmlDocument&) = delete;
  XmlDocument& operator=(const XmlDocument&) = delete;
};

/// Throws Error(input) for text that is not well-formed XML, saying what and where.
void parse_xml(std::string_view xml, const std::string& file, XmlDocument& document);

bool same_name(std::string_view a, std::string_view b);  ///< ASCII, without case
std::string lower(std::string_view text);

/// Whole-token numbers; empty when the token is something else, not finite or out of range.
std::optional<double> to_number(std::string_view token);
std::optional<std::int64_t> to_integer(std::string_view token);

/// Splits at blanks and calls body(token, line); a token never contains a blank.
template <class Body>
void for_each_token(const XmlText& chunk, Body body) {
  constexpr std::string_view blanks = " \t\r\n\f\v";
  const std::string_view text = chunk.text;
  std::size_t i = text.find_first_not_of(blanks);
  int line = chunk.line;
  while (i != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(blanks, i), text.size());
    body(text.substr(i, end - i), line);
    const std::size_t next = text.find_first_not_of(blanks, end);
    for (std::size_t k = end; k < std::min(next, text.size()); ++k) line += text[k] == '\n';
    i = next;
  }
}

}  // namespace glisson::detail
