#include <glisson/models/mesh/scanner.hpp>

#include <charconv>
#include <cmath>
#include <limits>

#include <glisson/core/base/error.hpp>

namespace glisson::detail {
namespace {

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// from_chars takes no plus sign, but files may have one.
std::string_view without_plus(std::string_view token) {
  if (token.size() > 1 && token[0] == '+' && token[1] != '-' && token[1] != '+') token.remove_prefix(1);
  return token;
}

}  // namespace

bool same_word(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

std::string quoted(std::string_view text) {
  constexpr std::size_t most = 40;
  std::string result = "'";
  for (const char c : text.substr(0, most)) result += c >= ' ' && c <= '~' ? c : '?';
  return result + (text.size() > most ? "...'" : "'");
}

void Scanner::skip_space() {
  while (next_ < text_.size() && is_space(text_[next_])) ++next_;
}

bool Scanner::at_end() {
  skip_space();
  start_ = next_;
  return next_ == text_.size();
}

std::string_view Scanner::token(const char* what) {
  skip_space();
  start_ = next_;
  while (next_ < text_.size() && !is_space(text_[next_])) ++next_;
  if (next_ == start_) fail(std::string("the file ends where ") + what + " should follow; it is truncated");
  return text_.substr(start_, next_ - start_);
}

std::optional<std::string_view> Scanner::token_in_line() {
  while (next_ < text_.size() && is_space(text_[next_]) && text_[next_] != '\n') ++next_;
  if (next_ == text_.size() || text_[next_] == '\n') return {};
  return token("a value");
}

std::string_view Scanner::line() {
  start_ = next_;
  const auto end = std::min(text_.find('\n', next_), text_.size());
  auto result = text_.substr(next_, end - next_);
  next_ = std::min(end + 1, text_.size());
  if (!result.empty() && result.back() == '\r') result.remove_suffix(1);
  return result;
}

void Scanner::expect(std::string_view word) {
  const auto found = token(std::string(word).c_str());
  if (!same_word(found, word)) fail(quoted(found) + " stands where " + std::string(word) + " should");
}

double Scanner::number_of(std::string_view token, const char* what) const {
  const auto digits = without_plus(token);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (end != digits.data() + digits.size() || error == std::errc::invalid_argument)
    fail(quoted(token) + " is not a number, but " + what + " should stand here");
  if (error == std::errc{}) return value;
  if (digits.find("e-") != digits.npos || digits.find("E-") != digits.npos) return 0;
  fail(quoted(token) + " is beyond the range of double numbers");
}

std::int64_t Scanner::integer_of(std::string_view token, const char* what) const {
  const auto digits = without_plus(token);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (end != digits.data() + digits.size() || error != std::errc{})
    fail(quoted(token) + " is not a whole number, but " + what + " should stand here");
  return value;
}

Vec3<double> Scanner::finite(const Vec3<double>& x) const {
  if (!std::isfinite(x.x) || !std::isfinite(x.y) || !std::isfinite(x.z))
    fail("a coordinate is not finite; every node needs a position");
  return x;
}

double Scanner::coordinate() {
  const double value = number("a coordinate");
  if (!std::isfinite(value)) fail("a coordinate is not finite; every node needs a position");
  return value;
}

std::int64_t Scanner::checked_count(std::int64_t value, const char* what, std::size_t least) const {
  if (value < 0) fail(std::to_string(value) + " is no possible " + what);
  if (value > std::numeric_limits<int>::max())
    fail(std::to_string(value) + " as the " + what + " is more than 2147483647, which is the limit");
  // The last number of a file may lack the white space behind it, so one byte more counts as being there.
  const std::uint64_t room = (remaining() + 1) / std::max<std::size_t>(least, 1);
  if (static_cast<std::uint64_t>(value) > room)
    fail(std::to_string(value) + " as the " + what + " cannot be right: only " + std::to_string(remaining()) +
         " bytes follow. The file is truncated or the number is wrong");
  return value;
}

int Scanner::checked_index(std::int64_t value, std::int64_t size, const char* what) const {
  if (value < 0 || value >= size)
    fail(std::string(what) + " " + std::to_string(value) + " does not exist; there are " +
         std::to_string(size) + ", numbered from 0");
  return static_cast<int>(value);
}

std::string_view Scanner::bytes(std::uint64_t count, const char* what) {
  start_ = next_;
  if (count > remaining())
    fail("the file ends within " + std::string(what) + ": " + std::to_string(count) + " bytes are needed, " +
         std::to_string(remaining()) + " are there; it is truncated");
  next_ += count;
  return text_.substr(start_, count);
}

void Scanner::fail(const std::string& message) const {
  Place place{file_, 0, section};
  if (binary)
    place.element += (section.empty() ? "byte " : ", byte ") + std::to_string(start_);
  else
    place.line = 1 + static_cast<int>(std::count(text_.begin(),
                                                 text_.begin() + static_cast<std::ptrdiff_t>(start_), '\n'));
  throw Error(ErrorKind::input, message, place);
}

}  // namespace glisson::detail
