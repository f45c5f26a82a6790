// The DataArray elements of VTK XML files: text, base64, raw bytes, with or without zlib.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <glisson/models/mesh/number_type.hpp>

namespace tinyxml2 {
class XMLElement;
}

namespace glisson::detail {

/// Bytes that are read forwards from raw data or from base64, where padding may stand at the end of each
/// part.
class ByteSource {
 public:
  ByteSource(std::string_view text, bool base64) : text_(text), base64_(base64) {}
  /// Appends up to `count` bytes and returns how many; letters outside the alphabet end the data.
  std::size_t read(std::size_t count, std::string& bytes);
  /// More bytes than are left at most.
  std::size_t most() const {
    return base64_ ? held_.size() + (text_.size() - next_) / 4 * 3 + 3 : text_.size() - next_;
  }

 private:
  bool decode_group();

  std::string_view text_;
  bool base64_;
  std::size_t next_ = 0;
  std::string held_;  ///< decoded, not read yet
  std::size_t held_at_ = 0;
};

/// How the file codes its arrays.
class XmlData {
 public:
  XmlData(std::string file, std::size_t file_bytes)
      : file_(std::move(file)), budget_(1100 * file_bytes + 65536) {}

  bool swap = false;
  bool compressed = false;
  std::size_t header_bytes = 4;  ///< of the numbers before binary data
  std::string_view appended;     ///< behind the underscore
  bool appended_base64 = false;

  /// All numbers of an array, which must be `count` times `components`; npos: any number.
  std::vector<double> numbers(const tinyxml2::XMLElement& array, std::size_t count);
  std::vector<std::int64_t> integers(const tinyxml2::XMLElement& array, std::size_t count);

  [[noreturn]] void fail(const tinyxml2::XMLElement& element, const std::string& message) const;

 private:
  template <class T>
  std::vector<T> values(const tinyxml2::XMLElement& array, std::size_t count);
  template <class T>
  std::vector<T> text_values(const tinyxml2::XMLElement& array, const char* text, std::size_t count);
  std::string bytes(const tinyxml2::XMLElement& array, std::size_t wanted);
  std::string inflated(const tinyxml2::XMLElement& array, ByteSource& source, std::size_t wanted);
  std::uint64_t header_number(const tinyxml2::XMLElement& array, ByteSource& source) const;

  std::string file_;
  std::uint64_t budget_;  ///< bytes that may still be unpacked: zlib makes at most 1032 from one
};

}  // namespace glisson::detail
