// The encoding of VTK's XML files: each array is cut into blocks, each block compressed; the header with the
// sizes and the blocks are coded in base64 separately (VTK file formats, "XML file formats", appendix on
// compressed inline data).
#include <glisson/models/output/vtk_xml_encoding.hpp>

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <glisson/core/base/error.hpp>
#include <limits>
#include <ostream>

namespace glisson::detail {
namespace {

constexpr std::size_t block_bytes = 1 << 18;

/// Bytes to base64 in pieces: what does not fill a group of 3 waits for the next call.
class Base64 {
 public:
  explicit Base64(std::ostream& out) : out_(out) {}

  void put(const unsigned char* data, std::size_t count) {
    std::string text;
    text.reserve(4 * (count + 2) / 3 + 4);
    for (std::size_t i = 0; i < count; ++i) {
      group_ = group_ << 8 | data[i];
      if (++held_ == 3) append(text, 4);
    }
    out_ << text;
  }

  void finish() {
    if (held_ == 0) return;
    const int letters = held_ + 1;
    group_ <<= 8 * (3 - held_);
    std::string text;
    append(text, letters);
    out_ << text << std::string(static_cast<std::size_t>(4 - letters), '=');
  }

 private:
  void append(std::string& text, int letters) {
    static constexpr char alphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (int i = 0; i < letters; ++i) text += alphabet[group_ >> (18 - 6 * i) & 63];
    group_ = 0;
    held_ = 0;
  }

  std::ostream& out_;
  unsigned group_ = 0;
  int held_ = 0;
};

std::vector<unsigned char> compress_block(const unsigned char* data, std::size_t count, int level) {
  std::vector<unsigned char> packed(compressBound(static_cast<uLong>(count)));
  uLongf size = static_cast<uLongf>(packed.size());
  if (compress2(packed.data(), &size, data, static_cast<uLong>(count), level) != Z_OK)
    throw Error(ErrorKind::usage,
                "zlib cannot compress with level " + std::to_string(level) + ". Use 1 to 9.");
  packed.resize(size);
  return packed;
}

/// One compressed array: [blocks][block size][size of the last block if it is not full][compressed sizes...],
/// blocks.
void write_compressed(std::ostream& out, const void* data, std::size_t bytes, int level) {
  const auto* begin = static_cast<const unsigned char*>(data);
  const std::size_t blocks = (bytes + block_bytes - 1) / block_bytes;
  std::vector<std::uint64_t> header{blocks, block_bytes, bytes % block_bytes};
  std::vector<std::vector<unsigned char>> packed;
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::size_t first = b * block_bytes;
    packed.push_back(compress_block(begin + first, std::min(block_bytes, bytes - first), level));
    header.push_back(packed.back().size());
  }
  Base64 head(out), body(out);
  head.put(reinterpret_cast<const unsigned char*>(header.data()), header.size() * sizeof(std::uint64_t));
  head.finish();
  for (const auto& block : packed) body.put(block.data(), block.size());
  body.finish();
}

bool valid_utf8(const std::string& text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto c = static_cast<unsigned char>(text[i]);
    const std::size_t length = c < 0x80 ? 1 : c >> 5 == 6 ? 2 : c >> 4 == 14 ? 3 : c >> 3 == 30 ? 4 : 0;
    if (length == 0 || i + length > text.size()) return false;
    for (std::size_t k = 1; k < length; ++k)
      if ((static_cast<unsigned char>(text[i + k]) & 0xC0) != 0x80) return false;
    i += length;
  }
  return true;
}

/// Names come from mesh files: what XML cannot hold becomes an underscore.
std::string attribute(const std::string& name) {
  const bool utf8 = valid_utf8(name);
  std::string text;
  for (const char letter : name) {
    const auto c = static_cast<unsigned char>(letter);
    switch (letter) {
      case '&':
        text += "&amp;";
        break;
      case '<':
        text += "&lt;";
        break;
      case '>':
        text += "&gt;";
        break;
      case '"':
        text += "&quot;";
        break;
      default:
        text += c < 0x20 || c == 0x7F || (c >= 0x80 && !utf8) ? '_' : letter;
    }
  }
  return text;
}

template <class T>
constexpr const char* type_name() {
  if constexpr (std::is_same_v<T, float>) return "Float32";
  if constexpr (std::is_same_v<T, double>) return "Float64";
  if constexpr (std::is_same_v<T, std::int32_t>) return "Int32";
  return "UInt8";
}

std::string number(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

}  // namespace

template <class T>
void write_array(std::ostream& out, const std::string& name, int components, std::span<const T> values,
                 int level) {
  out << "<DataArray type=\"" << type_name<T>() << "\" Name=\"" << attribute(name) << '"';
  if (components != 1) out << " NumberOfComponents=\"" << components << '"';
  out << " format=\"binary\">\n";
  write_compressed(out, values.data(), values.size_bytes(), level);
  out << "\n</DataArray>\n";
}

template void write_array(std::ostream&, const std::string&, int, std::span<const float>, int);
template void write_array(std::ostream&, const std::string&, int, std::span<const double>, int);
template void write_array(std::ostream&, const std::string&, int, std::span<const std::int32_t>, int);
template void write_array(std::ostream&, const std::string&, int, std::span<const std::uint8_t>, int);

namespace {

template <class T>
void write_as(std::ostream& out, const Field& field, int level) {
  std::vector<T> values(field.values.size());
  std::transform(field.values.begin(), field.values.end(), values.begin(),
                 [](double value) { return static_cast<T>(value); });
  write_array<T>(out, field.name, field.components, values, level);
}

}  // namespace

void write_field(std::ostream& out, const Field& field, const VtuOptions& options) {
  if (field.whole) return write_as<std::int32_t>(out, field, options.compression);
  if (options.precision == OutputPrecision::full)
    return write_array(out, field.name, field.components, field.values, options.compression);
  write_as<float>(out, field, options.compression);
}

void begin_vtk_file(std::ostream& out, const char* type, const VtuOptions& options) {
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"" << type << "\" version=\"1.0\" byte_order=\""
      << (std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian")
      << "\" header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<" << type << ">\n";
  if (options.time)
    out << "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
           "format=\"ascii\">\n"
        << number(*options.time) << "\n</DataArray>\n</FieldData>\n";
}

double largest_value(OutputPrecision precision) {
  return precision == OutputPrecision::full ? std::numeric_limits<double>::max()
                                            : std::numeric_limits<float>::max();
}

}  // namespace glisson::detail
