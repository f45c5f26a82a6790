// Binary data begin with their size, or when compressed with: number of blocks, size of a block, size of the
// last block if it is not full, compressed size of each block ("VTK file formats", XML file formats).
#include <glisson/models/mesh/vtk_xml_data.hpp>

#include <tinyxml2.h>
#include <zlib.h>

#include <limits>
#include <type_traits>

#include <glisson/core/base/error.hpp>
#include <glisson/models/mesh/scanner.hpp>

namespace glisson::detail {
namespace {

constexpr std::size_t any_count = std::string::npos;

int sextet(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

NumberType number_type(const XmlData& data, const tinyxml2::XMLElement& array) {
  constexpr std::pair<std::string_view, NumberType> names[] = {
      {"Int8", NumberType::int8},       {"UInt8", NumberType::uint8},     {"Int16", NumberType::int16},
      {"UInt16", NumberType::uint16},   {"Int32", NumberType::int32},     {"UInt32", NumberType::uint32},
      {"Int64", NumberType::int64},     {"UInt64", NumberType::uint64},   {"Float32", NumberType::float32},
      {"Float64", NumberType::float64}, {"float32", NumberType::float32}, {"float64", NumberType::float64}};
  const char* type = array.Attribute("type");
  if (type == nullptr) data.fail(array, "the array has no type");
  for (const auto& [name, its_type] : names)
    if (name == type) return its_type;
  data.fail(array, quoted(type) + " is no number type of VTK");
}

}  // namespace

bool ByteSource::decode_group() {
  unsigned group = 0;
  int letters = 0;
  for (int place = 0; place < 4; ++place) {
    while (next_ < text_.size() && (text_[next_] == ' ' || (text_[next_] >= '\t' && text_[next_] <= '\r')))
      ++next_;
    if (next_ == text_.size()) return false;
    const int value = sextet(text_[next_]);
    if (value < 0 && text_[next_] != '=') return false;
    ++next_;
    group = group << 6 | static_cast<unsigned>(std::max(value, 0));
    letters += value >= 0;
  }
  for (int b = 0; b + 1 < letters; ++b) held_ += static_cast<char>(group >> (16 - 8 * b) & 255);
  return letters > 1;
}

std::size_t ByteSource::read(std::size_t count, std::string& bytes) {
  if (!base64_) {
    count = std::min(count, text_.size() - next_);
    bytes.append(text_.substr(next_, count));
    next_ += count;
    return count;
  }
  std::size_t done = 0;
  while (done < count) {
    if (held_at_ == held_.size()) {
      held_.clear();
      held_at_ = 0;
      while (held_.size() < 4096 && decode_group()) {
      }
      if (held_.empty()) break;
    }
    const auto part = std::min(count - done, held_.size() - held_at_);
    bytes.append(held_, held_at_, part);
    held_at_ += part;
    done += part;
  }
  return done;
}

void XmlData::fail(const tinyxml2::XMLElement& element, const std::string& message) const {
  std::string name = element.Name() == nullptr ? "" : std::string(element.Name()).substr(0, 40);
  if (const char* its_name = element.Attribute("Name")) name += " " + quoted(its_name);
  throw Error(ErrorKind::input, message, {file_, element.GetLineNum(), name});
}

std::uint64_t XmlData::header_number(const tinyxml2::XMLElement& array, ByteSource& source) const {
  std::string data;
  if (source.read(header_bytes, data) != header_bytes)
    fail(array, "the binary data end within the sizes before them; the file is truncated or no base64");
  return header_bytes == 4 ? load<std::uint32_t>(data.data(), swap) : load<std::uint64_t>(data.data(), swap);
}

std::string XmlData::inflated(const tinyxml2::XMLElement& array, ByteSource& source, std::size_t wanted) {
  const auto blocks = header_number(array, source), block_size = header_number(array, source),
             last_size = header_number(array, source);
  if (blocks > source.most() / header_bytes)
    fail(array, std::to_string(blocks) + " compressed blocks cannot be right: only " +
                    std::to_string(source.most()) + " bytes follow");
  std::vector<std::uint64_t> packed(blocks);
  for (auto& size : packed) size = header_number(array, source);
  std::string result, block;
  for (std::size_t b = 0; b < packed.size(); ++b) {
    const auto size = b + 1 == packed.size() && last_size != 0 ? last_size : block_size;
    block.clear();
    if (packed[b] > source.most() || source.read(packed[b], block) != packed[b])
      fail(array, "compressed block " + std::to_string(b) + " is truncated");
    if (size > 1100 * packed[b] + 64 || size > budget_ ||
        (wanted != any_count && size > wanted - result.size()))
      fail(array, "compressed block " + std::to_string(b) + " unpacks to " + std::to_string(size) +
                      " bytes, which is more than the array can have");
    budget_ -= size;
    const auto before = result.size();
    result.resize(before + size);
    uLongf unpacked = static_cast<uLongf>(size);
    if (uncompress(reinterpret_cast<Bytef*>(result.data() + before), &unpacked,
                   reinterpret_cast<const Bytef*>(block.data()), static_cast<uLong>(block.size())) != Z_OK ||
        unpacked != size)
      fail(array, "compressed block " + std::to_string(b) + " is damaged (zlib)");
  }
  return result;
}

/// Binary data of an array; `wanted`: how many bytes it must have.
std::string XmlData::bytes(const tinyxml2::XMLElement& array, std::size_t wanted) {
  std::string_view text;
  const bool is_appended = std::string_view(array.Attribute("format")) == "appended";
  if (is_appended) {
    const char* offset_text = array.Attribute("offset");
    if (offset_text == nullptr) fail(array, "appended data need an offset");
    Scanner number(offset_text, file_);
    const auto offset = number.integer_of(offset_text, "an offset");
    if (offset < 0 || static_cast<std::uint64_t>(offset) > appended.size())
      fail(array, "the offset " + std::to_string(offset) + " is beyond the " +
                      std::to_string(appended.size()) + " bytes of appended data; the file is truncated");
    text = appended.substr(static_cast<std::size_t>(offset));
  } else if (array.GetText() != nullptr) {
    text = array.GetText();
  }
  ByteSource source(text, !is_appended || appended_base64);
  if (compressed) return wanted == 0 ? std::string() : inflated(array, source, wanted);
  if (wanted == 0) return {};
  const auto size = header_number(array, source);
  if (wanted != any_count && size != wanted)
    fail(array, "the array has " + std::to_string(size) + " bytes, but needs " + std::to_string(wanted));
  std::string result;
  if (size > source.most() || size > budget_ || source.read(size, result) != size)
    fail(array, "the array should have " + std::to_string(size) +
                    " bytes, but the data end before; the file is truncated");
  budget_ -= size;
  return result;
}

template <class T>
std::vector<T> XmlData::text_values(const tinyxml2::XMLElement& array, const char* text, std::size_t count) {
  std::vector<T> values;
  Scanner scanner(text, file_);
  while (!scanner.at_end()) {
    const auto token = scanner.token("a value");
    try {
      if constexpr (std::is_integral_v<T>)
        values.push_back(scanner.integer_of(token, "a whole number"));
      else
        values.push_back(scanner.number_of(token, "a number"));
    } catch (const Error&) {
      fail(array,
           quoted(token) + " is no " + (std::is_integral_v<T> ? "whole number" : "number") + " in range");
    }
    if (values.size() > count) fail(array, "the array has more than " + std::to_string(count) + " values");
  }
  return values;
}

template <class T>
std::vector<T> XmlData::values(const tinyxml2::XMLElement& array, std::size_t count) {
  const auto type = number_type(*this, array);
  if (std::is_integral_v<T> && !is_integer(type)) fail(array, "the array must hold whole numbers");
  const char* format = array.Attribute("format");
  const std::string_view its_format = format == nullptr ? "ascii" : format;
  std::vector<T> values;
  if (its_format == "ascii") {
    values = text_values<T>(array, array.GetText() == nullptr ? "" : array.GetText(), count);
  } else if (its_format == "binary" || its_format == "appended") {
    const auto size = size_of(type);
    if (count != any_count && count > any_count / 16)
      fail(array, std::to_string(count) + " values are not possible");
    const auto data = bytes(array, count == any_count ? any_count : count * size);
    if (data.size() % size != 0) fail(array, "the data end within a value");
    values.reserve(data.size() / size);
    for (std::size_t i = 0; i < data.size(); i += size)
      if constexpr (std::is_integral_v<T>)
        values.push_back(load_integer(data.data() + i, type, swap));
      else
        values.push_back(load_number(data.data() + i, type, swap));
  } else {
    fail(array, "the format " + quoted(its_format) + " is not ascii, binary or appended");
  }
  if (count != any_count && values.size() != count)
    fail(array,
         "the array has " + std::to_string(values.size()) + " values, but needs " + std::to_string(count));
  return values;
}

std::vector<double> XmlData::numbers(const tinyxml2::XMLElement& array, std::size_t count) {
  return values<double>(array, count);
}

std::vector<std::int64_t> XmlData::integers(const tinyxml2::XMLElement& array, std::size_t count) {
  return values<std::int64_t>(array, count);
}

}  // namespace glisson::detail
