#include <glisson/models/format/value_path.hpp>

#include <algorithm>
#include <optional>
#include <vector>

#include <glisson/models/format/suggest.hpp>

namespace glisson::detail {
namespace {

struct Segment {
  std::string name;
  std::optional<std::int64_t> index;  ///< from 1
};

[[noreturn]] void fail(const Place& place, std::string_view path, const std::string& message) {
  throw Error(ErrorKind::input, "the column '" + std::string(path) + "' " + message, place);
}

/// The part after `mark` is taken off the path.
std::optional<std::string> split_off(std::string_view& path, char mark) {
  const auto at = path.rfind(mark);
  if (at == std::string_view::npos) return {};
  std::string part(path.substr(at + 1));
  path = path.substr(0, at);
  return part;
}

Segment segment_of(std::string_view text, const Place& place, std::string_view path) {
  const auto open = text.find('[');
  if (open == std::string_view::npos) return {std::string(text), {}};
  const bool closed = text.back() == ']';
  const auto index = closed ? to_integer(text.substr(open + 1, text.size() - open - 2)) : std::nullopt;
  if (!index || *index < 1) fail(place, path, "needs a number from 1 between [ and ]");
  return {std::string(text.substr(0, open)), index};
}

void collect_below(XmlElement& from, const std::string& name, std::vector<XmlElement*>& found) {
  for (auto& child : from.children) {
    if (child.is(name)) found.push_back(&child);
    collect_below(child, name, found);
  }
}

void collect_named(XmlElement& from, const std::string& name, std::vector<XmlElement*>& found) {
  for (auto& child : from.children) {
    const auto own = child.attribute("Name");
    if (own != nullptr && own->value == name) found.push_back(&child);
    collect_named(child, name, found);
  }
}

/// Children of that name; else an element that the file calls by it; else descendants.
std::vector<XmlElement*> candidates(XmlElement& from, const std::string& name) {
  std::vector<XmlElement*> found;
  for (auto& child : from.children)
    if (child.is(name)) found.push_back(&child);
  if (found.empty()) collect_named(from, name, found);
  if (found.empty()) collect_below(from, name, found);
  return found;
}

std::vector<std::string> names_in(const XmlElement& element) {
  std::vector<std::string> names;
  for (const auto& child : element.children) {
    names.push_back(child.name);
    if (const auto own = child.attribute("Name")) names.push_back(own->value);
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

XmlElement* follow(XmlElement* element, const Segment& segment, const Place& place, std::string_view path) {
  const auto found = candidates(*element, segment.name);
  if (found.empty())
    fail(place, path,
         "names nothing: <" + element->name + "> has no '" + segment.name + "'" +
             suggestion(segment.name, names_in(*element)));
  const auto count = static_cast<std::int64_t>(found.size());
  if (!segment.index && count > 1)
    fail(place, path,
         "is one of " + std::to_string(count) + ": choose with " + segment.name + "[1] to " + segment.name +
             "[" + std::to_string(count) + "]");
  if (segment.index.value_or(1) > count)
    fail(place, path,
         "names nothing: there " + std::string(count == 1 ? "is one " : "are only ") +
             (count == 1 ? "" : std::to_string(count) + " ") + segment.name);
  return found[static_cast<std::size_t>(segment.index.value_or(1) - 1)];
}

std::size_t token_count(const XmlElement& element) {
  std::size_t count = 0;
  for (const auto& chunk : element.texts) for_each_token(chunk, [&](std::string_view, int) { ++count; });
  return count;
}

}  // namespace

ValueTarget::ValueTarget(XmlElement& root, std::string_view path, const Place& place) {
  std::string_view rest = path;
  const auto attribute = split_off(rest, '@');
  const auto number = attribute ? std::nullopt : split_off(rest, '#');
  element_ = &root;
  while (!rest.empty()) {
    const auto slash = std::min(rest.find('/'), rest.size());
    element_ = follow(element_, segment_of(rest.substr(0, slash), place, path), place, path);
    rest.remove_prefix(std::min(slash + 1, rest.size()));
  }
  if (attribute) {
    for (auto& own : element_->attributes)
      if (same_name(own.name, *attribute)) attribute_ = &own;
    if (attribute_ == nullptr)
      fail(place, path,
           "names nothing: <" + element_->name + "> at line " + std::to_string(element_->line) +
               " has no attribute " + *attribute + "; write it into the file first");
    return;
  }
  const auto count = static_cast<std::int64_t>(token_count(*element_));
  if (count == 0) fail(place, path, "names no value: <" + element_->name + "> holds no text");
  if (!number && count > 1)
    fail(place, path,
         "holds " + std::to_string(count) + " values: choose with #1 to #" + std::to_string(count));
  const auto index = number ? to_integer(*number) : std::optional<std::int64_t>(1);
  if (!index || *index < 1 || *index > count)
    fail(place, path,
         "names nothing: <" + element_->name + "> has the values #1 to #" + std::to_string(count));
  number_ = static_cast<std::size_t>(*index - 1);
}

void ValueTarget::set(const std::string& value, const Place& place) {
  if (attribute_ != nullptr) {
    attribute_->value = value;
    return;
  }
  if (!to_number(value))
    throw Error(ErrorKind::input, "'" + value.substr(0, 40) + "' is not a finite number", place);
  std::size_t k = 0;
  for (auto& chunk : element_->texts) {
    std::string text;
    int line = chunk.line;
    for_each_token(chunk, [&](std::string_view token, int token_line) {
      text.append(static_cast<std::size_t>(token_line - line), '\n');
      line = token_line;
      text += ' ';
      text += k++ == number_ ? std::string_view(value) : token;
    });
    chunk.text = text;
  }
}

}  // namespace glisson::detail
