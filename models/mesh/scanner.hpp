// Reads tokens, lines and bytes from a mesh file in memory; every complaint carries the file and the place in
// it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <glisson/core/tensor/tensor.hpp>
#include <glisson/models/mesh/number_type.hpp>

namespace glisson::detail {

/// Text and binary parts may alternate, as they do in VTK, Gmsh and PLY files. Nothing is copied: `text` must
/// outlive it.
class Scanner {
 public:
  Scanner(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

  std::string section;      ///< named in complaints
  bool binary = false;      ///< complaints give the byte instead of the line
  bool big_endian = false;  ///< byte order of the binary numbers

  const std::string& file() const { return file_; }
  std::size_t offset() const { return next_; }
  std::size_t remaining() const { return text_.size() - next_; }
  std::string_view rest() const { return text_.substr(next_); }
  void skip(std::size_t count) { next_ += std::min(count, remaining()); }

  /// True when only white space is left.
  bool at_end();
  /// The next token between white space; `what` says in the complaint what was expected at the end of the
  /// file.
  std::string_view token(const char* what);
  /// The next token of this line, or nothing.
  std::optional<std::string_view> token_in_line();
  /// The rest of this line without its line break; the next line begins behind it.
  std::string_view line();
  /// The next token must be this word (any case).
  void expect(std::string_view word);

  double number(const char* what) { return number_of(token(what), what); }
  /// A number that is finite.
  double coordinate();
  std::int64_t integer(const char* what) { return integer_of(token(what), what); }
  double number_of(std::string_view token, const char* what) const;
  std::int64_t integer_of(std::string_view token, const char* what) const;

  /// How many `what` follow, as text or already read. Each takes `least` bytes, so that a count which the
  /// rest of the file cannot hold is refused before memory is taken for it. Fits into int.
  std::int64_t count(const char* what, std::size_t least) {
    return checked_count(integer(what), what, least);
  }
  std::int64_t checked_count(std::int64_t value, const char* what, std::size_t least) const;
  /// 0-based index that must lie in [0, size).
  int checked_index(std::int64_t value, std::int64_t size, const char* what) const;

  /// The next `count` bytes.
  std::string_view bytes(std::uint64_t count, const char* what);
  bool swap() const { return big_endian != (std::endian::native == std::endian::big); }
  template <class T>
  T load(const char* what) {
    return detail::load<T>(bytes(sizeof(T), what).data(), swap());
  }
  Vec3<double> finite(const Vec3<double>& x) const;

  [[noreturn]] void fail(const std::string& message) const;

 private:
  void skip_space();

  std::string_view text_;
  std::string file_;
  std::size_t next_ = 0, start_ = 0;  ///< behind, and at the beginning of, what was read last
};

/// Equal in any case of the ASCII letters.
bool same_word(std::string_view a, std::string_view b);
/// At most 40 bytes in quotes, what cannot be printed as '?': for messages.
std::string quoted(std::string_view text);

}  // namespace glisson::detail
